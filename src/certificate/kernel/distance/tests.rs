//! What a gap is worth, against beams for which the bound is reached; and every term of the distance between two deflections.

use super::*;
use crate::certificate::in_intervals;
use crate::certificate::kernel::hold::{Hold, Place};
use crate::scene::{Balance, Beam, Load, Scene};

const LENGTH: f64 = 20.0;
const STIFFNESS: f64 = 70.0;
/// Width of a part, and the arrow `w²/8` of a parabola of curvature one.
const WIDTH: f64 = 0.5;
const ARROW: f64 = 0.125 * WIDTH * WIDTH;
/// What rounding of the plain numbers adds to the bounds, and its own bound, which is generous.
const ROUNDING: f64 = 1e-9;

#[track_caller]
fn at_least(bound: f64, value: f64) {
    assert!((value..=value + ROUNDING * value.max(1.0)).contains(&bound), "{bound}, not {value}");
}

fn piece([from, to]: [f64; 2], coefficients: &[f64]) -> Piece {
    let coefficients: Vec<Interval> = coefficients.iter().map(|c| Interval::exact(*c)).collect();
    Piece { from, to, v: Polynomial::new(&coefficients), follows: false }
}

fn pair(pieces: Vec<Piece>) -> Pair {
    let holds = vec![Hold(Place::at(0.0), Place::at(LENGTH))];
    Pair { pieces, gap: Interval::ZERO, reactions: Vec::new(), holds, lifted: 0.0 }
}

/// A pair with the gap that makes a factor.
fn pair_of_factor(pieces: Vec<Piece>, factor: f64) -> Pair {
    Pair { gap: Interval::exact(1.5 * factor * factor * STIFFNESS * LENGTH), ..pair(pieces) }
}

/// The error of nodes on a beam with supports at both ends.
fn of_given(pieces: Vec<Piece>, nodes: &Nodes) -> Error {
    let scene = Scene::new(Beam::new(LENGTH, STIFFNESS).expect("positive"), Load::default(), None).expect("well posed");
    in_intervals(&scene, Balance::Held, |enclosed| of_nodes(&pair(pieces), nodes, &SCALE, enclosed))
}

/// A force `F` at mid-span bends the beam by `F l³/48 EI` there and stores `F² l³/96 EI`: no deflection with that energy
/// is larger, so that the bound is reached.
#[test]
fn a_force_at_mid_span_reaches_the_bound() {
    let cube = LENGTH * LENGTH * LENGTH;
    let force = 3.0;
    let (deflection, gap) = (force * cube / (48.0 * STIFFNESS), force * force * cube / (96.0 * STIFFNESS));
    let pair = Pair { gap: Interval::exact(gap), ..pair(Vec::new()) };
    at_least(anywhere(&pair, STIFFNESS, LENGTH), deflection);
    at_least(on_part(&pair, factor(gap, STIFFNESS), [0.5 * LENGTH; 2]), deflection);
}

const NOTHING: [f64; 2] = [0.0; 2];

/// The bound for samples at 0, w, … on the deflection `c s⁴`, off by something in `v` and in `v''`.
fn bound(c: f64, fourth: f64, factor: f64, off: impl Fn(u32) -> [f64; 2]) -> Error {
    let samples = (0..=40_u32).map(|k| {
        let x = WIDTH * f64::from(k);
        let [v, bent] = off(k);
        Sample { x, values: [c * x * x * x * x + v, 12.0 * c * x * x + bent], off: [0.0; 2] }
    });
    let pieces = vec![piece([0.0, LENGTH], &[0.0, 0.0, 0.0, 0.0, c])];
    compare(&pair_of_factor(pieces, factor), samples, fourth, STIFFNESS)
}

#[test]
fn every_term_of_the_bound_is_there() {
    for node in [1, 7, 39] {
        let at = |off: [f64; 2]| move |k: u32| if k == node { off } else { NOTHING };
        // A deflection that is off at one sample, and a curvature that is: a parabola between samples.
        for sign in [1.0, -1.0] {
            let error = bound(0.0, 0.0, 0.0, at([sign, 0.0]));
            at_least(error.most, 1.0);
            at_least(error.size, 1.0);
            // Of equal bounds the first place is named.
            at_least(error.at, WIDTH * (f64::from(node) - 0.5));
            let error = bound(0.0, 0.0, 0.0, at([0.0, 2.0 * sign]));
            at_least(error.most, 2.0 * ARROW);
            at_least(error.size, 2.0 * ARROW);
        }
    }
    // Fourth derivatives, of the admissible deflection and of the judged one.
    at_least(bound(1e-6, 0.0, 0.0, |_| NOTHING).most, ARROW * ARROW * 24e-6);
    at_least(bound(1e-6, 3e-6, 0.0, |_| NOTHING).most, ARROW * ARROW * 27e-6);
    // The factor, with the largest x (l − x) of a part and the height of its arc.
    at_least(bound(0.0, 0.0, 2.0, |_| NOTHING).most, 2.0 * (0.25 * LENGTH * LENGTH + 2.0 * ARROW));
    // All of them.
    let all = bound(1e-6, 3e-6, 2.0, |_| [1.0, 2.0]).most;
    at_least(all, 2.0 * (100.0 + 2.0 * ARROW) + 1.0 + ARROW * (2.0 + ARROW * 27e-6));
    // What samples are not known by counts as if they were off.
    let unknown = (0..=40_u32).map(|k| Sample { x: WIDTH * f64::from(k), values: NOTHING, off: [1.0, 2.0] });
    at_least(compare(&pair(vec![piece([0.0, LENGTH], &[])]), unknown, 0.0, STIFFNESS).most, 1.0 + 2.0 * ARROW);
}

/// What the places of a witness make is off by what it was lifted by, and by what the gap allows; nothing is known of it where
/// another list is better.
#[test]
fn what_a_witness_was_lifted_by_counts() {
    let own = |gap: f64, lifted: f64| {
        let pair = Pair { gap: Interval::exact(gap), lifted, ..pair(vec![piece([0.0, LENGTH], &[2.0])]) };
        of_witness(&pair, STIFFNESS, LENGTH)
    };
    at_least(own(0.0, 0.25).most, 0.25);
    let gap = Pair { gap: Interval::exact(3.0), ..pair(Vec::new()) };
    at_least(own(3.0, 0.25).most, 0.25 + anywhere(&gap, STIFFNESS, LENGTH));
    at_least(own(0.0, 0.0).size, 2.0);
    assert!(own(0.0, f64::INFINITY).most.is_infinite());
    assert!(own(f64::INFINITY, 0.0).most.is_infinite());
}

#[test]
fn no_number_is_no_bound() {
    for node in [0, 7, 40] {
        for part in 0..2 {
            let mut off = NOTHING;
            off[part] = f64::NAN;
            let error = bound(0.0, 0.0, 0.0, |k| if k == node { off } else { NOTHING });
            assert!(error.most.is_infinite() && error.size.is_infinite(), "part {part} of sample {node}");
        }
    }
}

/// What is not known of the coefficients, and twenty units of rounding of each, times powers of the width.
#[test]
fn values_are_as_good_as_their_coefficients() {
    /// Factors that only round outwards.
    const OUT: f64 = 1e-12;
    let (radius, width) = (0.25, 3.0);
    let unknown = |k: usize| {
        let mut coefficients = [Interval::ZERO; 4];
        coefficients[k] = Interval::around_zero(radius);
        Plain::of(&Polynomial::new(&coefficients), width).off
    };
    for (k, power) in [1.0, 3.0, 9.0, 27.0].into_iter().enumerate() {
        let least = radius * power;
        assert!((least..=least * (1.0 + OUT)).contains(&unknown(k)), "{k}: {}", unknown(k));
    }
    let known = Plain::of(&Polynomial::new(&[1.0, -2.0, 3.0].map(Interval::exact)), width).off;
    let least = ROUNDINGS * (1.0 + 6.0 + 27.0);
    assert!((least..=least * (1.0 + OUT)).contains(&known), "{known}");
    assert!(0.0 < Plain::of(&Polynomial::ZERO, width).off, "underflow is rounding as well");
}

/// Pieces and cells that do not go all the way, or whose ends are no samples, bound nothing.
#[test]
fn what_ends_on_the_way_is_not_judged() {
    let pieces = vec![piece([0.0, 4.0], &[]), piece([4.0, LENGTH], &[])];
    let judged = |to: f64| [([0.0, 3.0], Polynomial::ZERO), ([3.0, to], Polynomial::ZERO)];
    assert!(of_pieces(&pair(pieces.clone()), &judged(LENGTH), STIFFNESS, LENGTH).most < ROUNDING);
    assert!(of_pieces(&pair(pieces.clone()), &judged(10.0), STIFFNESS, LENGTH).most.is_infinite());
    assert!(of_pieces(&pair(pieces[..1].to_vec()), &judged(LENGTH), STIFFNESS, LENGTH).most.is_infinite());
    assert!(of_pieces(&pair(pieces.clone()), &[], STIFFNESS, LENGTH).most.is_infinite());
    let samples = [0.0, 3.0, 5.0, LENGTH].map(|x| Sample { x, values: NOTHING, off: NOTHING });
    assert!(compare(&pair(pieces), samples.into_iter(), 0.0, STIFFNESS).most.is_infinite());
}

const SCALE: Scale = Scale { length: 1.0, depth: 1.0, force: 1.0 };

/// Nodes at unit distances with a deflection of one at one of them, against pieces whose ends lie beside it, between nodes.
#[test]
fn every_cell_is_compared() {
    let ends = [0.0, 4.9, 5.1, 5.2, LENGTH];
    let pieces: Vec<Piece> = ends.windows(2).map(|w| piece([w[0], w[1]], &[])).collect();
    for off in 1..20 {
        let x: Vec<f64> = (1..20_u32).map(f64::from).collect();
        let deflection = x.iter().map(|x| f64::from(u8::from((x - f64::from(off)).abs() < 0.5))).collect();
        let nodes = Nodes { x, deflection, moment: vec![0.0; 19], ..Nodes::default() };
        at_least(of_given(pieces.clone(), &nodes).most, 1.0);
    }
}

/// A piece that lies within a cell is seen by no node, and counts.
#[test]
fn pieces_between_nodes_are_compared() {
    for cell in [0.0, 4.0, 19.0] {
        let [a, b] = [cell + 0.4, cell + 0.6];
        let pieces = vec![piece([0.0, a], &[]), piece([a, b], &[1.0]), piece([b, LENGTH], &[])];
        let x: Vec<f64> = (1..20_u32).map(f64::from).collect();
        let nodes = Nodes { x, deflection: vec![0.0; 19], moment: vec![0.0; 19], ..Nodes::default() };
        at_least(of_given(pieces, &nodes).most, 1.0);
    }
}

/// A node with a moment between two without: `M s (1 − s²) Δ²/6 EI` beside it, largest at `s = 1/√3`, and its curvature.
#[test]
fn between_nodes_the_beam_is_a_cubic() {
    /// Between samples, which are a few thousandths of a cell apart.
    const BETWEEN: f64 = 1e-4;
    let nodes = Nodes { x: vec![8.0], deflection: vec![0.0], moment: vec![3.0], ..Nodes::default() };
    let error = of_given(vec![piece([0.0, LENGTH], &[])], &nodes);
    let most = 3.0 * 144.0 / (9.0 * f64::sqrt(3.0) * STIFFNESS);
    assert!((most..most * (1.0 + BETWEEN)).contains(&error.most), "{error:?}, not {most}");
    let place = LENGTH - 12.0 / f64::sqrt(3.0);
    assert!((error.at - place).abs() < 0.01 * LENGTH, "{error:?}, not {place}");
}

/// The same beam as a polynomial, given in two cells.
#[test]
fn pieces_are_judged_like_nodes() {
    let v = Polynomial::new(&[0.0, 1.0, 0.0, -2.0 / 400.0, 1.0 / 8000.0].map(Interval::exact));
    let judged = [([0.0, 7.0], v), ([7.0, LENGTH], v.shifted(Interval::exact(7.0)))];
    let error = of_pieces(&pair(vec![piece([0.0, LENGTH], &[])]), &judged, STIFFNESS, LENGTH);
    // x − 2 x³/l² + x⁴/l³ is 5 l/16 in the middle.
    assert!((6.25..6.25 * (1.0 + 1e-6)).contains(&error.most), "{error:?}");
    assert!((6.25..6.25 * (1.0 + 1e-12)).contains(&error.size), "{error:?}");
}

#[test]
fn nodes_that_are_not_in_order_or_not_complete_are_none() {
    let known = |x: &[f64], deflections: usize, moments: usize| {
        let nodes =
            Nodes { x: x.to_vec(), deflection: vec![1.0; deflections], moment: vec![1.0; moments], ..Nodes::default() };
        of_given(vec![piece([0.0, LENGTH], &[])], &nodes).most.is_finite()
    };
    assert!(known(&[5.0, 6.0], 2, 2));
    for (x, deflections, moments) in [
        (&[5.0, 6.0], 1, 2),
        (&[5.0, 6.0], 2, 1),
        (&[6.0, 5.0], 2, 2),
        (&[5.0, 5.0], 2, 2),
        (&[-1.0, 5.0], 2, 2),
        (&[5.0, f64::INFINITY], 2, 2),
        (&[f64::NAN, 5.0], 2, 2),
    ] {
        assert!(!known(x, deflections, moments), "{x:?}, {deflections}, {moments}");
    }
}
