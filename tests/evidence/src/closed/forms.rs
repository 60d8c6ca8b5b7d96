//! The scenes and their closed forms. Supports are at tenths of the length, so that grids have nodes there.

use palkki::scene::{Beam, Foundation, SceneError, Support};
use palkki::state::Contact;

use super::Closed;

/// Bending stiffness of all beams here \[force · length²\].
pub const EI: f64 = 7.0;
/// Uniform load of all that have one \[force/length\].
pub const Q: f64 = 3.0;

pub(super) fn at(x: f64) -> Contact {
    Contact::at(x, 1.0)
}

pub(super) fn zone(from: f64, to: f64) -> Contact {
    Contact { from, to, force: 1.0, end_forces: None }
}

fn held(length: f64, supports: &[Support]) -> Result<Beam, SceneError> {
    Beam::new(length, EI)?.with_supports(supports.to_vec())
}

fn flat(depth: f64) -> Option<Foundation> {
    Some(Foundation::Flat { depth })
}

/// The tip of a cantilever of length `c` at the distance `s` from where it is built in: `q s² (6 c² − 4 c s + s²)/24 EI`.
#[must_use]
pub fn overhang(c: f64, s: f64) -> f64 {
    Q * s * s * (6.0 * c * c - 4.0 * c * s + s * s) / (24.0 * EI)
}

/// A simple span: `q x (l³ − 2 l x² + x³)/24 EI`.
fn simple(l: f64, x: f64) -> f64 {
    Q * x * (l * l * l - 2.0 * l * x * x + x * x * x) / (24.0 * EI)
}

/// Two supports at `a` and `b` of a beam from 0 to `l`: a simple span with the moments `−q c²/2` of the overhangs `c`.
#[must_use]
pub fn between(a: f64, b: f64, l: f64, x: f64) -> f64 {
    let (w, left, right) = (b - a, -0.5 * Q * a * a, -0.5 * Q * (l - b) * (l - b));
    // M s (w² − s²)/6 EI w of a moment at the far end of s.
    let bent = |m: f64, s: f64| m * s * (w * w - s * s) / (6.0 * EI * w);
    let turned = |m: f64, other: f64| Q * w * w * w / (24.0 * EI) + (2.0 * m + other) * w / (6.0 * EI);
    if x < a {
        -turned(left, right) * (a - x) + overhang(a, a - x)
    } else if b < x {
        -turned(right, left) * (x - b) + overhang(l - b, x - b)
    } else {
        simple(w, x - a) + bent(right, x - a) + bent(left, b - x)
    }
}

/// Cantilevers and beams that are built in at both ends, in the air, with a tip that touches and with zones.
///
/// # Errors
///
/// None for these numbers, as with all of these lists.
pub fn built_in() -> Result<Vec<Closed>, SceneError> {
    let l = 4.0;
    let cantilever = held(l, &[Support::built_in(0.0)])?;
    // The tip touches with R = q l/4: h = q l⁴/8 EI − R l³/3 EI.
    let touched = Q * l * l * l * l / (24.0 * EI);
    let propped = move |x: f64| overhang(l, x) - 0.25 * Q * l * x * x * (3.0 * l - x) / (6.0 * EI);
    // Lift-off at a⁴ = 72 EI h/q from where it is built in, v = h − q s³ (4 a − 3 s)/72 EI.
    let h = 0.1_f64;
    let a = (72.0 * EI * h / Q).sqrt().sqrt();
    let lying = move |x: f64| {
        let s = (a - x).max(0.0);
        h - Q * s * s * s * (4.0 * a - 3.0 * s) / (72.0 * EI)
    };
    let turned = held(l, &[Support::built_in(l)])?;
    let level = held(l, &[Support::built_in(0.0).at_level(0.5), Support::simple(0.4 * l).at_level(0.5)])?;
    let parted = [zone(0.0, 0.4 * l), zone(0.4 * l, l)];
    let mut found = vec![
        Closed::new("cantilever", &cantilever, Q, None, &[], |x| overhang(l, x))?,
        Closed::new("cantilever above deep ground", &cantilever, Q, flat(100.0), &[], |x| overhang(l, x))?,
        Closed::new("cantilever whose tip touches", &cantilever, Q, flat(touched), &[at(l)], propped)?,
        Closed::new("cantilever that lies on the ground", &cantilever, Q, flat(h), &[zone(a, l)], lying)?,
        Closed::new("cantilever from the right", &turned, Q, flat(h), &[zone(0.0, l - a)], |x| lying(l - x))?,
        // A support parts what lies on both sides of it.
        Closed::new("on ground that is level with all supports", &level, Q, flat(0.5), &parted, |_| 0.5)?,
    ];
    let l = 10.0;
    let both = held(l, &[Support::built_in(0.0), Support::built_in(l)])?;
    let fixed = move |x: f64| Q * x * x * (l - x) * (l - x) / (24.0 * EI);
    let ends = &[zone(a, l - a)];
    // The ground at half the depth of mid-span takes half of what holds it there, R = q l/4.
    let half = move |x: f64| fixed(x) - 0.25 * Q * l * x * x * (3.0 * l - 4.0 * x) / (48.0 * EI);
    let deep = 0.5 * fixed(0.5 * l);
    let half = move |x: f64| half(x.min(l - x));
    found.push(Closed::new("built in at both ends on a point", &both, Q, flat(deep), &[at(0.5 * l)], half)?);
    // A slope of the left support alone: v = φ x (l − x)²/l².
    let sloping = held(l, &[Support { slope: Some(0.3), ..Support::simple(0.0) }, Support::built_in(l)])?;
    found.push(Closed::new("built in at both ends", &both, Q, flat(100.0), &[], fixed)?);
    found.push(Closed::new("built in at both ends above ground", &both, Q, flat(h), ends, |x| lying(x.min(l - x)))?);
    found.push(Closed::new("turned at one end", &sloping, 0.0, None, &[], |x| 0.3 * x * (l - x) * (l - x) / (l * l))?);
    Ok(found)
}

/// Several spans, settlement, overhangs, and a zone in each of two spans.
pub(super) fn spans() -> Result<Vec<Closed>, SceneError> {
    let (l, half) = (6.0, 3.0);
    // A span that is simple at x = 0 and built in at L: q x (L³ − 3 L x² + 2 x³)/48 EI.
    let propped = move |x: f64| Q * x * (half * half * half - 3.0 * half * x * x + 2.0 * x * x * x) / (48.0 * EI);
    let two = held(l, &[Support::simple(0.0), Support::simple(half), Support::simple(l)])?;
    // The middle one settles: v = δ x (3 l² − 4 x²)/l³ up to it.
    let settled = held(l, &[Support::simple(0.0), Support::simple(half).at_level(0.4), Support::simple(l)])?;
    let settlement = move |x: f64| 0.4 * x * (3.0 * l * l - 4.0 * x * x) / (l * l * l);
    let mut found = vec![
        Closed::new("two spans", &two, Q, None, &[], |x| propped(x.min(l - x)))?,
        Closed::new("two spans above deep ground", &two, Q, flat(10.0), &[], |x| propped(x.min(l - x)))?,
        Closed::new("settlement", &settled, 0.0, flat(10.0), &[], |x| settlement(x.min(l - x)))?,
    ];
    for [a, b] in [[0.0, 4.2], [1.2, 5.4], [2.4, 6.0], [0.6, 3.0]] {
        let beam = held(l, &[Support::simple(b), Support::simple(a)])?;
        let name = format!("overhangs beyond {a} and {b}");
        found.push(Closed::new(&name, &beam, Q, flat(50.0), &[], |x| between(a, b, l, x))?);
    }
    // Lift-off at a⁴ = 24 EI h/q from supports at both ends, v = h − q s³ (2 a − s)/24 EI with s = a − x, and on both sides of the
    // one in the middle, where the beam is horizontal, as from where it is built in.
    let (h, l) = (0.05_f64, 16.0);
    let (a, b) = ((24.0 * EI * h / Q).sqrt().sqrt(), (72.0 * EI * h / Q).sqrt().sqrt());
    let beam = held(l, &[Support::simple(0.0), Support::simple(0.5 * l), Support::simple(l)])?;
    let from_end = move |x: f64| {
        let s = (a - x).max(0.0);
        h - Q * s * s * s * (2.0 * a - s) / (24.0 * EI)
    };
    let from_middle = move |x: f64| {
        let s = (b - (0.5 * l - x)).max(0.0);
        h - Q * s * s * s * (4.0 * b - 3.0 * s) / (72.0 * EI)
    };
    let lying = move |x: f64| from_end(x.min(l - x)).min(from_middle(x.min(l - x)));
    let zones = [zone(a, 0.5 * l - b), zone(0.5 * l + b, l - a)];
    found.push(Closed::new("a zone in each of two spans", &beam, Q, flat(h), &zones, lying)?);
    // A floor beam that is lifted at one end: from a hinge to a zone that reaches the other end.
    let beam = held(l, &[Support::simple(0.0).at_level(-h)])?;
    found.push(Closed::new("lifted off the floor", &beam, Q, flat(0.0), &[zone(a, l)], |x| from_end(x) - h)?);
    Ok(found)
}

/// An arch that stands on its ends, and one whose middle touches as well; a ski that lies on flat ground by its own weight, and the same as a hump under a straight beam: overhangs with
/// `q c²/2 = EI κ` at both ends.
pub(super) fn own_shapes() -> Result<Vec<Closed>, SceneError> {
    let (l, kappa) = (12.0, 0.03);
    let gap = move |x: f64| 0.5 * kappa * (x - 0.5 * l) * (x - 0.5 * l);
    let c = (2.0 * EI * kappa / Q).sqrt();
    let closed = move |x: f64| {
        let s = (c - x.min(l - x)).max(0.0);
        gap(x) - Q * s * s * s * (4.0 * c - s) / (24.0 * EI)
    };
    let beam = held(l, &[])?;
    let ski = Foundation::Polynomial { coefficients: vec![-0.125 * kappa * l * l, 0.5 * kappa * l, -0.5 * kappa] };
    let ski = beam.clone().with_shape(ski)?;
    let hump =
        Foundation::Polynomial { coefficients: vec![1.0 + 0.125 * kappa * l * l, -0.5 * kappa * l, 0.5 * kappa] };
    let zones = &[zone(c, l - c)];
    // An arch of height f, of which its load takes off simple(l/2) if that is less, and else down to the ground, by R at mid-span.
    let arch = |f: f64| {
        let coefficients = vec![0.0, -4.0 * f / l, 4.0 * f / (l * l)];
        beam.clone().with_shape(Foundation::Polynomial { coefficients })
    };
    let full = simple(l, 0.5 * l);
    let pushed = move |x: f64| x * (3.0 * l * l - 4.0 * x * x) / (l * l * l);
    let ends = [at(0.0), at(l)];
    let three = [at(0.0), at(0.5 * l), at(l)];
    let standing = move |x: f64| simple(l, x);
    let closed_up = move |x: f64| simple(l, x) - 0.05 * full * pushed(x.min(l - x));
    Ok(vec![
        Closed::new("an arch on its ends", &arch(1.5 * full)?, Q, flat(0.0), &ends, standing)?,
        Closed::new("an arch that its weight closes", &arch(0.95 * full)?, Q, flat(0.0), &three, closed_up)?,
        Closed::new("a ski that its weight closes", &ski, Q, flat(0.0), zones, closed)?,
        Closed::new("a hump under a free beam", &beam, Q, Some(hump), zones, |x| 1.0 + closed(x))?,
    ])
}

/// Bodies that merely lie on the ground, or on one support and the ground.
pub(super) fn free() -> Result<Vec<Closed>, SceneError> {
    let l = 6.0;
    let free = held(l, &[])?;
    let polynomial = |coefficients: &[f64]| Some(Foundation::Polynomial { coefficients: coefficients.to_vec() });
    let mut found = vec![
        Closed::new("flat on flat ground", &free, Q, flat(0.5), &[zone(0.0, l)], |_| 0.5)?,
        // On ground that slopes everything is turned with it.
        Closed::new("flat on a slope", &free, Q, polynomial(&[1.0, 0.25]), &[zone(0.0, l)], |x| 1.0 + 0.25 * x)?,
    ];
    let hollow = polynomial(&[1.0, 20.0 * l, -20.0]);
    found.push(Closed::new("on its tips", &free, Q, hollow, &[at(0.0), at(l)], |x| 1.0 + simple(l, x))?);
    for [a, b] in [[1.2, 5.4], [2.4, 3.6], [0.6, 4.2]] {
        let points = vec![[0.0, 30.0], [a, 1.0], [0.5 * (a + b), 30.0], [b, 1.0], [l, 30.0]];
        let ground = Some(Foundation::Polyline { points });
        let hinged = held(l, &[Support::simple(a).at_level(1.0)])?;
        let v = |x: f64| 1.0 + between(a, b, l, x);
        let name = format!("on peaks at {a} and {b}");
        found.push(Closed::new(&name, &free, Q, ground.clone(), &[at(a), at(b)], v)?);
        let name = format!("on a support at {a} and a peak at {b}");
        found.push(Closed::new(&name, &hinged, Q, ground, &[at(b)], v)?);
    }
    // A hump that is too sharp to lie on: the beam touches it below the resultant, wherever the crest is.
    for crest in [3.0, 2.5] {
        let kappa = 4.0;
        let slope = kappa * (0.5 * l - crest);
        let height = 0.5 * kappa * (0.5 * l - crest) * (0.5 * l - crest);
        let hump = polynomial(&[1.0 + 0.5 * kappa * crest * crest, -kappa * crest, 0.5 * kappa]);
        let v = |x: f64| 1.0 + height + slope * (x - 0.5 * l) + overhang(0.5 * l, (x - 0.5 * l).abs());
        found.push(Closed::new(
            &format!("on a sharp hump with its crest at {crest}"),
            &free,
            Q,
            hump,
            &[at(0.5 * l)],
            v,
        )?);
    }
    Ok(found)
}
