//! Spans against closed forms of the textbook.

use super::*;
use crate::certificate::in_intervals;
use crate::scene::{Balance, Beam, LinearLoad, Load, PointLoad, Scene, Support};

/// An overhang of length `a` under `q + r s` with a force `P` at its tip, from the textbook: with `s` from the support,
/// `EI v''(0) = q a²/2 + r a³/3 + P a`, `EI v'(a) = EI v'(0) + q a³/6 + r a⁴/8 + P a²/2` and
/// `EI v(a) = EI (v(0) + v'(0) a) + q a⁴/8 + 11 r a⁵/120 + P a³/3`. To the left all of it is the mirror image.
#[test]
fn overhangs_bend_by_their_closed_form() {
    const ROUNDING: f64 = 1e-13;
    let (stiffness, a, q, r, force, v, slope) = (70.0, 3.0, 2.0, 0.5, 4.0, 0.3, -0.2);
    let beam = Beam::new(20.0, stiffness).expect("positive");
    for (tip, support, sign) in [(20.0, 17.0, 1.0), (0.0, 3.0, -1.0)] {
        let to_the_left = sign < 0.0;
        let [start, end] = if to_the_left { [r * a, 0.0] } else { [0.0, r * a] };
        let (from, to) = (f64::min(tip, support), f64::max(tip, support));
        let beam = beam.clone().with_supports([support, 10.0].map(Support::simple).to_vec()).expect("on the beam");
        let growing = LinearLoad { from, to, start, end };
        let load = Load::new(&beam, q, vec![growing], vec![PointLoad { at: tip, force }]).expect("finite");
        let scene = Scene::new(beam.clone(), load, None).expect("well posed");
        let held = Some([v, sign * slope].map(Interval::exact));
        let ends = if to_the_left { [None, held] } else { [held, None] };
        let span = in_intervals(&scene, Balance::Held, |enclosed| Span::new(enclosed, [from, to], ends, None));
        let (at_support, at_tip) = if to_the_left { (span.end, span.start) } else { (span.start, span.end) };
        let bent = a * a * a * (q * a / 8.0 + 11.0 * r * a * a / 120.0 + force / 3.0) / stiffness;
        let expected = [
            (at_support[0], v),
            (at_support[1], sign * slope),
            (at_support[2], a * (q * a / 2.0 + r * a * a / 3.0 + force) / stiffness),
            (at_support[3], -sign * (q * a + r * a * a / 2.0 + force) / stiffness),
            (at_tip[0], v + slope * a + bent),
            (at_tip[1], sign * (slope + a * a * (q * a / 6.0 + r * a * a / 8.0 + force / 2.0) / stiffness)),
            (at_tip[2], 0.0),
            (at_tip[3], -sign * force / stiffness),
        ];
        for (i, (found, expected)) in expected.into_iter().enumerate() {
            let off = found.lo() - ROUNDING <= expected && expected <= found.hi() + ROUNDING;
            assert!(off && found.hi() - found.lo() <= ROUNDING, "{i} at {tip}: {found:?} for {expected}");
        }
    }
}

/// A force `P` beside either end of a beam that is built in at both, `a` from the one and `b` from the other: with `r` from the far end
///
/// ```text
/// EI v'' = P a b²/L², P a² b/L² at the near and at the far end,     6 EI L³ v = P a² r² (3 b L − (3 b + a) r)
/// ```
///
/// the moments and the forces to all their digits however near the force is, and the deflection, from both ends, to the digits of what
/// the moment at the near end would bend the beam by.
#[test]
fn a_force_beside_an_end_has_its_digits() {
    /// Some hundred roundings.
    const ROUNDING: f64 = 1e-13;
    let (stiffness, length, force) = (70.0, 16.0, 3.0);
    let beam = Beam::new(length, stiffness).expect("positive");
    for power in [1, 10, 25, 40] {
        let a = libm::ldexp(1.0, -power);
        let b = length - a;
        for to_the_left in [true, false] {
            let at = if to_the_left { a } else { b };
            let load = Load::new(&beam, 0.0, Vec::new(), vec![PointLoad { at, force }]).expect("finite");
            let scene = Scene::new(beam.clone(), load, None).expect("well posed");
            let (span, curves) = in_intervals(&scene, Balance::Held, |enclosed| {
                let span = Span::new(enclosed, [0.0, length], [Some([Interval::ZERO; 2]); 2], None);
                let curves = span.curves(enclosed, Vec::new());
                (span, curves)
            });
            let r = 0.5 * length;
            let inside = force * a * a * r * r * (3.0 * b * length - (3.0 * b + a) * r);
            let inside = inside / (6.0 * stiffness * length * length * length);
            let bent = [a * b * b, a * a * b].map(|moment| force * moment / (length * length * stiffness));
            let pressed = [b, a].map(|arm| force * arm / length);
            let order = |[near, far]: [f64; 2]| if to_the_left { [near, far] } else { [far, near] };
            let ([from, to], [start, end]) = curves[usize::from(to_the_left)];
            let numbers = [
                (span.start[2], order(bent)[0], order(bent)[0]),
                (span.end[2], order(bent)[1], order(bent)[1]),
                (span.loaded[0], order(pressed)[0], order(pressed)[0]),
                (span.loaded[1], order(pressed)[1], order(pressed)[1]),
                (start.at(Interval::length(from, r)), inside, bent[0] * length * length),
                (end.at(Interval::length(to, r)), inside, bent[0] * length * length),
            ];
            for (i, (found, expected, size)) in numbers.into_iter().enumerate() {
                let close = (found.lo() - expected).abs().max((found.hi() - expected).abs()) <= ROUNDING * size;
                assert!(close, "{i}, {power}, {to_the_left}: {found:?} for {expected}");
            }
        }
    }
}

/// A span under two loads: each part has one deflection, whichever of its ends it is told from.
#[test]
fn parts_of_a_span_are_the_same_from_both_ends() {
    let beam = Beam::new(20.0, 70.0).expect("positive");
    let loads = [(5.0, 30.0), (14.0, -8.0)].map(|(at, force)| PointLoad { at, force });
    let load = Load::new(&beam, 2.0, Vec::new(), loads.to_vec()).expect("finite");
    let scene = Scene::new(beam, load, None).expect("well posed");
    let ends = [[0.3, -0.2], [0.1, 0.4]].map(|end| Some(end.map(Interval::exact)));
    let parts = in_intervals(&scene, Balance::Held, |enclosed| {
        Span::new(enclosed, [2.0, 18.0], ends, None).curves(enclosed, Vec::new())
    });
    assert_eq!(parts.iter().map(|part| part.0).collect::<Vec<_>>(), [[2.0, 5.0], [5.0, 14.0], [14.0, 18.0]]);
    for ([from, to], [start, end]) in parts {
        for x in [from, 0.5 * (from + to), to] {
            let [one, other] = [start.at(Interval::length(from, x)), end.at(Interval::length(to, x))];
            let (width, least) = (one.hi() - one.lo() + other.hi() - other.lo(), one.hi().min(other.hi()));
            assert!(one.lo().max(other.lo()) <= least && width <= 1e-9, "{one:?} and {other:?} at {x}");
        }
    }
}
