//! The gap of a pair against its own two energies, which are computed apart.

use super::*;
use crate::certificate::in_intervals;
use crate::certificate::kernel::contact_node::tests::{Kind, node};
use crate::certificate::quantities::energy;
use crate::scene::{Balance, Beam, Foundation, Load, PointLoad, Scene, Support};

const LENGTH: f64 = 20.0;
const STIFFNESS: f64 = 70.0;
const LOAD: f64 = 3.0;
const DEPTH: f64 = 0.4;
/// Both energies are sums of some dozens of roundings, and the gap is what is left of them.
const ROUNDING: f64 = 1e-12;

/// The pair of nodes above a foundation, and what it is a pair of: its energy.
fn pair_of(scene: &Scene, nodes: &[ContactNode]) -> Option<(Pair, Interval)> {
    in_intervals(scene, Balance::Held, |enclosed| {
        let pair = pair(enclosed, nodes)?;
        let energy = energy(&pair.pieces, enclosed);
        Some((pair, energy))
    })
}

/// What the supports at the two ends of the beam exert.
#[track_caller]
fn at_ends(pair: &Pair) -> [Interval; 2] {
    let [first, .., last] = &pair.carried[..] else { panic!("two places at least") };
    assert!(first.0.abs() <= 0.0 && (last.0 - LENGTH).abs() <= 0.0, "{} and {}", first.0, last.0);
    [first.1, last.1]
}

/// Lift-off points at the distances `a` and `b` from the supports, where the moments vanish: the contact load is `q` between
/// them and a force `q a/2`, `q b/2` at each, and
///
/// ```text
/// D(p) = −q² (a⁵ + b⁵)/240 EI − u q (l − (a + b)/2)
/// ```
#[test]
fn the_gap_is_the_difference_of_the_two_energies() {
    let beam = Beam::new(LENGTH, STIFFNESS).expect("positive");
    let load = Load::uniform_on(&beam, LOAD).expect("finite");
    let flat = Foundation::Flat { depth: DEPTH };
    let scene = Scene::new(beam.clone(), load, Some(flat)).expect("well posed");
    // Nearer to the supports than the true ones, so that the beam arrives from above; and slopes that are off.
    for (a, b, share) in [(3.5, 3.5, 0.0), (3.0, 3.6, 0.0), (3.5, 3.2, 0.05), (3.1, 3.4, -0.05)] {
        let slope = |a: f64| (1.5 * DEPTH / a + LOAD * a * a * a / (48.0 * STIFFNESS)) * (1.0 + share);
        let nodes = [
            node(Kind::Support, 0.0, slope(a)),
            node(Kind::Start, a, 0.0),
            node(Kind::End, LENGTH - b, 0.0),
            node(Kind::Support, LENGTH, -slope(b)),
        ];
        let (pair, upper) = pair_of(&scene, &nodes).expect("nodes from support to support");
        let fifth = |a: f64| a * a * a * a * a;
        let lower =
            -LOAD * LOAD * (fifth(a) + fifth(b)) / (240.0 * STIFFNESS) - DEPTH * LOAD * (LENGTH - 0.5 * (a + b));
        let off = pair.gap - (upper.middle() - lower);
        assert!(off.abs() <= ROUNDING * lower.abs(), "{a}, {b}, {share}: off by {off} in {:?}", pair.gap);
        for (reaction, a) in at_ends(&pair).into_iter().zip([a, b]) {
            assert!((reaction.middle() - 0.5 * LOAD * a).abs() <= ROUNDING * LOAD * a, "{a}, {b}: {reaction:?}");
        }
    }
}

/// What a pair is corrected by: `J(v̂)` and `D(p)` are known apart from it, and their difference is the gap.
#[track_caller]
fn corrected(foundation: Foundation, point: f64, slope: f64, corner: bool, lower: f64) -> Pair {
    let beam = Beam::new(LENGTH, STIFFNESS).expect("positive");
    let middle = 0.5 * LENGTH;
    let points = vec![PointLoad { at: middle, force: point }];
    let load = Load::new(&beam, LOAD, Vec::new(), points).expect("finite");
    let scene = Scene::new(beam.clone(), load, Some(foundation)).expect("well posed");
    let mut nodes = vec![node(Kind::Support, 0.0, slope), node(Kind::Support, LENGTH, -slope)];
    if corner {
        nodes.insert(1, node(Kind::Corner, middle, 0.0));
    }
    above_ground(&scene, &nodes, lower)
}

/// The pair of nodes, nowhere in the ground, with the gap between its two energies.
#[track_caller]
fn above_ground(scene: &Scene, nodes: &[ContactNode], lower: f64) -> Pair {
    /// The lift and the cut are rounded outwards, over parts of a span.
    const CORRECTIONS: f64 = 1e-6;
    let (pair, upper) = pair_of(scene, nodes).expect("nodes from support to support");
    for k in 0..=200 {
        let x = LENGTH * f64::from(k) / 200.0;
        let piece = pair.pieces.iter().find(|p| x <= p.to).expect("all the way");
        let v = piece.v.at(Interval::exact(x) - Interval::exact(piece.from));
        assert!(v.lo() <= scene.gap(x), "the beam is in the ground at {x}: {v:?}");
    }
    let gap = upper.middle() - lower;
    assert!((pair.gap - gap).abs() <= CORRECTIONS * gap, "{:?}, not {gap}", pair.gap);
    pair
}

const CUBE: f64 = LENGTH * LENGTH * LENGTH;
/// `−q² l⁵/240 EI` and `5 q l⁴/384 EI`, of the free beam.
const FREE: f64 = -LOAD * LOAD * CUBE * LENGTH * LENGTH / (240.0 * STIFFNESS);
const SAG: f64 = 5.0 * LOAD * CUBE * LENGTH / (384.0 * STIFFNESS);

/// A span that is in the ground is lifted, by `α (s/L)(1 − s/L)`; the contact load of these nodes is none.
#[test]
fn what_lifts_a_span_counts_in_the_gap() {
    for share in [0.5, 0.9] {
        let slope = LOAD * CUBE / (24.0 * STIFFNESS);
        let pair = corrected(Foundation::Flat { depth: share * SAG }, 0.0, slope, false, FREE);
        // At least from the free beam to the ground at mid-span; coefficients of Bernstein are twice a parabola.
        let lifted = (1.0 - share) * SAG;
        assert!((lifted..2.5 * lifted).contains(&pair.lifted), "{} for {lifted}", pair.lifted);
    }
}

/// Two equal spans `a` under a uniform load, of which each is lifted from its own beginning: horizontal in the middle, they begin
/// with the slope `q a³/48 EI`, sag by `q a⁴/185 EI`, and have `J = −q² a⁵/320 EI` together.
#[test]
fn every_span_is_lifted() {
    let a = 0.5 * LENGTH;
    let supports = [0.0, a, LENGTH].map(Support::simple).to_vec();
    let beam = Beam::new(LENGTH, STIFFNESS).and_then(|beam| beam.with_supports(supports)).expect("well held");
    let load = Load::uniform_on(&beam, LOAD).expect("finite");
    let (cube, sag) = (a * a * a, LOAD * a * a * a * a / (185.0 * STIFFNESS));
    let scene = Scene::new(beam, load, Some(Foundation::Flat { depth: 0.8 * sag })).expect("well posed");
    let slope = LOAD * cube / (48.0 * STIFFNESS);
    let nodes = [(0.0, slope), (a, 0.0), (LENGTH, -slope)].map(|(x, slope)| node(Kind::Support, x, slope));
    let pair = above_ground(&scene, &nodes, -LOAD * LOAD * cube * a * a / (320.0 * STIFFNESS));
    assert!(0.1 * sag < pair.lifted, "{} of {sag}", pair.lifted);
}

/// A corner that the beam does not reach pulls it down by `w`, with the force `R = 48 EI w/l³`. Cut off, it leaves the free
/// beam under `q` and a point load `P`, with `J = −q² l⁵/240 EI − P 5 q l⁴/384 EI − P² l³/96 EI`.
#[test]
fn what_pulls_counts_in_the_gap() {
    for point in [0.0, 5.0] {
        let sag = SAG + point * CUBE / (48.0 * STIFFNESS);
        let lower = FREE - point * SAG - point * point * CUBE / (96.0 * STIFFNESS);
        let down = 0.3 * sag;
        let points = [[0.0, 3.0 * sag], [0.5 * LENGTH, sag + down], [LENGTH, 3.0 * sag]].to_vec();
        let slope = LOAD * CUBE / (24.0 * STIFFNESS) + 3.0 * (sag - SAG + down) / LENGTH;
        let pair = corrected(Foundation::Polyline { points }, point, slope, true, lower);
        // The reactions of the moments that are left, and of those that pull, wherever they are.
        let [reaction, pull] = [0.5 * (LOAD * LENGTH + point), 48.0 * STIFFNESS * down / CUBE];
        for bracket in at_ends(&pair) {
            assert!((bracket.lo()..=bracket.hi()).contains(&reaction), "{reaction} in {bracket:?}");
            let width = bracket.hi() - bracket.lo();
            assert!((2.0 * pull..2.1 * pull).contains(&width), "{width} for a pull of {pull}");
        }
    }
}

/// A beam that lies on `u = c x² (l − x)²` all the way, from one level support to the other: `M' = −EI u'''` is its shear.
#[test]
fn a_beam_that_lies_on_the_ground_has_its_shear() {
    let c = 1e-5;
    let coefficients = vec![0.0, 0.0, c * LENGTH * LENGTH, -2.0 * c * LENGTH, c];
    let foundation = Foundation::Polynomial { coefficients };
    let beam = Beam::new(LENGTH, STIFFNESS).expect("positive");
    let load = Load::uniform_on(&beam, LOAD).expect("finite");
    let scene = Scene::new(beam, load, Some(foundation)).expect("well posed");
    let nodes = [node(Kind::Start, 0.0, 0.0), node(Kind::End, LENGTH, 0.0)];
    let (pair, _) = pair_of(&scene, &nodes).expect("from support to support");
    for reaction in at_ends(&pair) {
        let expected = 12.0 * c * LENGTH * STIFFNESS;
        assert!((reaction.middle() - expected).abs() <= ROUNDING * expected, "{reaction:?}, not {expected}");
    }
}

#[test]
fn of_nodes_that_are_no_list_nothing_follows() {
    let beam = Beam::new(LENGTH, STIFFNESS).expect("positive");
    let load = Load::uniform_on(&beam, LOAD).expect("finite");
    let flat = Foundation::Flat { depth: DEPTH };
    let scene = Scene::new(beam, load, Some(flat)).expect("well posed");
    let [support, start, end, touch] = [Kind::Support, Kind::Start, Kind::End, Kind::Touch];
    let complete = |nodes: &[(Kind, f64)]| {
        let nodes: Vec<ContactNode> = nodes.iter().map(|&(kind, x)| node(kind, x, 0.0)).collect();
        let complete = in_intervals(&scene, Balance::Held, |enclosed| is_complete(enclosed, &nodes));
        assert_eq!(pair_of(&scene, &nodes).is_some(), complete, "{nodes:?}");
        complete
    };
    assert!(complete(&[(support, 0.0), (support, LENGTH)]));
    assert!(complete(&[(support, 0.0), (start, 3.0), (end, 7.0), (touch, 9.0), (support, LENGTH)]));
    for nodes in [
        &[][..],
        &[(support, 0.0)],
        &[(support, 1.0), (support, LENGTH)],
        &[(touch, 0.0), (support, LENGTH)],
        &[(support, 0.0), (support, LENGTH - 1.0)],
        &[(support, 0.0), (support, LENGTH + 1.0)],
        &[(support, 0.0), (touch, LENGTH)],
        &[(start, 0.0), (end, 7.0), (support, LENGTH)],
        &[(support, 0.0), (support, LENGTH), (touch, LENGTH + 1.0)],
        &[(support, 0.0), (touch, 9.0), (touch, 8.0), (support, LENGTH)],
        &[(support, 0.0), (touch, 9.0), (touch, 9.0), (support, LENGTH)],
        &[(support, 0.0), (start, 9.0), (support, LENGTH)],
        &[(support, 0.0), (start, 9.0), (Kind::Corner, 12.0), (support, LENGTH)],
    ] {
        assert!(!complete(nodes), "{nodes:?}");
    }
}

/// Ground that is level with a support only at the edge of a step does not hold the beam that lies at the foot of it.
#[test]
fn at_the_foot_of_a_step_no_support_is_met() {
    let beam = Beam::new(LENGTH, STIFFNESS).expect("positive");
    let load = Load::uniform_on(&beam, LOAD).expect("finite");
    for (points, meets) in
        [([[0.0, 0.0], [0.0, 1.0], [LENGTH, 1.0]], false), ([[0.0, 1.0], [0.0, 0.0], [LENGTH, 0.0]], true)]
    {
        let ground = Foundation::Polyline { points: points.to_vec() };
        let scene = Scene::new(beam.clone(), load.clone(), Some(ground)).expect("well posed");
        let nodes = [node(Kind::Start, 0.0, 0.0), node(Kind::End, 7.0, 0.0), node(Kind::Support, LENGTH, 0.0)];
        let complete = in_intervals(&scene, Balance::Held, |enclosed| is_complete(enclosed, &nodes));
        assert_eq!(complete, meets, "{points:?}");
    }
}

/// A foundation steeper than the free beam would have to pull the beam down at the support that it is level with. The couple that
/// this takes is cut off and paid for, at either support alike: `‖m‖² = M² l/3 EI` with `M = 3 EI (s − s₀)/l` for slopes `s` of the
/// foundation and `s₀` of the free beam.
#[test]
fn a_couple_that_pulls_counts_at_both_supports() {
    let free = LOAD * CUBE / (24.0 * STIFFNESS);
    let beam = Beam::new(LENGTH, STIFFNESS).expect("positive");
    let load = Load::uniform_on(&beam, LOAD).expect("finite");
    for steeper in [1.01, 1.5, 3.0] {
        let steep = steeper * free;
        let moment = 3.0 * STIFFNESS * (steep - free) / LENGTH;
        let expected = 0.5 * moment * moment * LENGTH / (3.0 * STIFFNESS);
        // The slope of a beam whose other end is free to turn.
        let other = -free + 0.5 * (free - steep);
        let tangent =
            |x: f64| ContactNode { lies: false, ..node(if x <= 0.0 { Kind::Touch } else { Kind::End }, x, 0.0) };
        for (coefficients, nodes) in [
            (vec![0.0, steep], [tangent(0.0), node(Kind::Support, LENGTH, other)]),
            (vec![steep * LENGTH, -steep], [node(Kind::Support, 0.0, -other), tangent(LENGTH)]),
        ] {
            let foundation = Foundation::Polynomial { coefficients };
            let scene = Scene::new(beam.clone(), load.clone(), Some(foundation)).expect("well posed");
            let gap = pair_of(&scene, &nodes).expect("from support to support").0.gap;
            assert!((gap - expected).abs() <= 1e-9 * expected, "{gap}, not {expected}, at {nodes:?}");
        }
    }
}

/// A beam on supports at 8, on a corner of the ground, and at 20, along the ground on the left of the corner. Over `h = 12` it takes the
/// moment `M = −3 EI (Δ − φ h)/h²` to that, and the force at the left tip makes `8`. The ground on the left makes what is left of both
/// if that is positive; otherwise it is cut off, at `C √(h/3 EI)`.
#[test]
fn ground_on_one_side_makes_couples_of_one_sign() {
    let (x, h, slope) = (8.0, 12.0, -0.25);
    let ground = vec![[0.0, 2.0 - slope * x], [x, 2.0], [LENGTH, 8.0]];
    for rise in [3.0, -12.0] {
        let supports = vec![Support::simple(x).at_level(2.0), Support::simple(LENGTH).at_level(2.0 + rise)];
        let beam = Beam::new(LENGTH, STIFFNESS).expect("positive").with_supports(supports).expect("on the beam");
        let load = Load::new(&beam, 0.0, Vec::new(), vec![PointLoad { at: 0.0, force: -1.0 }]).expect("finite");
        let ground = Foundation::Polyline { points: ground.clone() };
        let scene = Scene::new(beam, load, Some(ground)).expect("well posed");
        let along = ContactNode { x, slope: Slope::OfGround { from_the_left: true }, lies: false };
        let nodes = [along, node(Kind::Corner, LENGTH, 1.5 * rise / h - 0.5 * slope)];
        let (pair, _) = pair_of(&scene, &nodes).expect("held by two supports");
        let jump = -3.0 * STIFFNESS * (rise - slope * h) / (h * h) - 8.0;
        let cut = jump.min(0.0);
        let gap = 0.5 * cut * cut * h / (3.0 * STIFFNESS);
        assert!((pair.gap - gap).abs() <= 1e-9 * gap + ROUNDING, "{rise}: {}, not {gap}", pair.gap);
    }
}

/// A point load above a support bends nothing, and is no force of the pair: it is added where the force of the support is told.
#[test]
fn a_load_above_a_support_is_carried_by_it() {
    let beam = Beam::new(LENGTH, STIFFNESS).expect("positive");
    let slope = LOAD * CUBE / (24.0 * STIFFNESS);
    let nodes = [node(Kind::Support, 0.0, slope), node(Kind::Support, LENGTH, -slope)];
    for at in [0.0, LENGTH] {
        let load = Load::new(&beam, LOAD, Vec::new(), vec![PointLoad { at, force: 5.0 }]).expect("finite");
        let scene = Scene::new(beam.clone(), load, None).expect("well posed");
        let (pair, _) = pair_of(&scene, &nodes).expect("from support to support");
        for reaction in at_ends(&pair) {
            let expected = 0.5 * LOAD * LENGTH;
            assert!((reaction.middle() - expected).abs() <= ROUNDING * expected, "{reaction:?}, not {expected}");
        }
        assert!(pair.gap <= ROUNDING, "{}", pair.gap);
    }
}

mod free;
mod taut;
