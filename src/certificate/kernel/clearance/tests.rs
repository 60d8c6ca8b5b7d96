//! Lifts of spans that are in the ground, against the lift that is needed at some hundred places.

use super::*;
use crate::certificate::in_intervals;
use crate::certificate::kernel::contact_node::tests::{Kind, node};
use crate::scene::{Balance, Beam, Foundation, Load, Scene};

const LENGTH: f64 = 20.0;
const STIFFNESS: f64 = 70.0;
const LOAD: f64 = 3.0;
/// Places along a span.
const PLACES: u32 = 400;

/// `φ`, from its formula.
fn phi(s: f64, length: f64, left: ContactNode, right: ContactNode) -> f64 {
    let power = |node: ContactNode, z: f64| {
        let ends = node.x <= 0.0 || LENGTH <= node.x;
        if ends && matches!(node.slope, Slope::Free(_)) { z } else { z * z }
    };
    power(left, s / length) * power(right, 1.0 - s / length)
}

/// The lift of a span, and the most that one of many places needs.
fn lifts(foundation: &Foundation, load: f64, [left, right]: [ContactNode; 2]) -> (Option<f64>, f64) {
    let beam = Beam::new(LENGTH, STIFFNESS).expect("positive");
    let load = Load::uniform_on(&beam, load).expect("finite");
    let scene = Scene::new(beam, load, Some(foundation.clone())).expect("well posed");
    in_intervals(&scene, Balance::Held, |enclosed| {
        let span = enclosed.span(Some(&left), Some(&right)).expect("a span");
        let parts = span.curves(enclosed, Vec::new());
        let mut needed = 0.0_f64;
        for k in 1..PLACES {
            let s = (span.to - span.from) * f64::from(k) / f64::from(PLACES);
            let v = parts[0].1[0].at(Interval::exact(s)).middle();
            needed = needed.max((v - foundation.depth(left.x + s)) / phi(s, span.to - span.from, left, right));
        }
        let middle = 0.5 * (span.to - span.from);
        let there = phi(middle, span.to - span.from, left, right);
        let lift = lift(enclosed, &span, &parts, [Some(&left), Some(&right)]);
        (lift.map(|lift| lift.at(Interval::exact(middle)).hi() / there), needed)
    })
}

/// What is enough is not less than what is needed, and not much more.
#[track_caller]
fn enough(what: &str, foundation: &Foundation, load: f64, nodes: [ContactNode; 2]) {
    /// Penetration is set against the least `φ` of an eighth of a cell, on which `φ` changes by less than that except in the
    /// first.
    const LOOSE: f64 = 2.0;
    /// Of the places, which are not known better.
    const ROUNDING: f64 = 1e-9;
    let (lift, needed) = lifts(foundation, load, nodes);
    let lift = lift.unwrap_or_else(|| panic!("{what}: there is a lift"));
    assert!(0.0 < needed, "{what}: nothing is in the ground");
    assert!((1.0 - ROUNDING) * needed <= lift, "{what}: {lift} is not {needed}");
    assert!(lift <= LOOSE * needed, "{what}: {lift} for {needed}, {} times", lift / needed);
}

const CUBE: f64 = LENGTH * LENGTH * LENGTH;
const SAG: f64 = 5.0 * LOAD * CUBE * LENGTH / (384.0 * STIFFNESS);
/// At the supports of the free beam.
const STEEP: f64 = LOAD * CUBE / (24.0 * STIFFNESS);

#[test]
fn spans_are_lifted_as_far_as_they_have_to_be() {
    let free = [node(Kind::Support, 0.0, STEEP), node(Kind::Support, LENGTH, -STEEP)];
    for share in [0.1, 0.5, 0.9] {
        enough("free beam", &Foundation::Flat { depth: share * SAG }, LOAD, free);
    }
    // A ridge that is no node, on one side and on the other.
    for ridge in [3.0, 8.0, 13.0, 18.0] {
        let points = [[0.0, SAG], [ridge, 0.2 * SAG], [LENGTH, SAG]].to_vec();
        enough("ridge", &Foundation::Polyline { points }, LOAD, free);
    }
    // Of many points that are far below the beam one that is not: cells are looked at together, but for those about it, and what is
    // known at the end of those beside a corner says nothing beyond.
    let corner = node(Kind::Corner, 2.0, 0.0);
    for (ridge, left) in
        [(6, free[0]), (25, free[0]), (50, free[0]), (74, free[0]), (26, corner), (27, corner), (28, corner)]
    {
        let depth = |k: u32| match k {
            8 => 0.6 * SAG,
            k if k == ridge => 0.2 * SAG,
            k => (1.5 + 0.1 * f64::from(k % 3)) * SAG,
        };
        let points = (0..=80).map(|k| [LENGTH * f64::from(k) / 80.0, depth(k)]).collect();
        enough("one of many", &Foundation::Polyline { points }, LOAD, [left, free[1]]);
    }
    let wave = Foundation::Cosine { mean: 1.0, amplitude: 0.4, wavelength: 8.0, phase: 1.0 };
    // From crest to crest, and between two slopes, where the beam is in the ground beside the node.
    for (from, to) in [(4.0, 9.0), (2.0, 5.0), (3.0, 6.5), (0.0, LENGTH)] {
        enough("wave", &wave, 10.0 * LOAD, [node(Kind::Touch, from, 0.0), node(Kind::Touch, to, 0.0)]);
    }
    let flat = Foundation::Flat { depth: 1.0 };
    enough("from zone to zone", &flat, LOAD, [node(Kind::End, 4.0, 0.0), node(Kind::Start, 9.0, 0.0)]);
    let level = Foundation::Flat { depth: 0.0 };
    enough("steep at a support", &level, LOAD, [node(Kind::Support, 0.0, 0.1), node(Kind::Start, 4.0, 0.0)]);
    enough("steep at the other", &level, LOAD, [node(Kind::End, 16.0, 0.0), node(Kind::Support, LENGTH, -0.1)]);
    // Down from the upper edge of a step, past the lower one, and down from a kink.
    for mirrored in [false, true] {
        let points = vec![[0.0, 3.0], [8.0, 3.0], [8.0, 1.0], [LENGTH, 1.0]];
        let kink = vec![[0.0, 2.0], [8.0, 1.0], [LENGTH, 1.2]];
        for (mut points, [mut left, mut right]) in [
            (points, [node(Kind::Support, 0.0, 0.9), node(Kind::Corner, 8.0, -1.5)]),
            (kink, [node(Kind::Corner, 8.0, -0.05), node(Kind::Support, LENGTH, -STEEP)]),
        ] {
            if mirrored {
                points = points.iter().rev().map(|[x, depth]| [LENGTH - x, *depth]).collect();
                let turned = |j: ContactNode| {
                    let Slope::Free(slope) = j.slope else { return j };
                    ContactNode { x: LENGTH - j.x, slope: Slope::Free(-slope), ..j }
                };
                (left, right) = (turned(right), turned(left));
            }
            enough("corner", &Foundation::Polyline { points }, LOAD, [left, right]);
        }
    }
    enough("to a zone", &flat, LOAD, [node(Kind::Support, 0.0, 0.4), node(Kind::Start, 8.0, 0.0)]);
    enough("from a zone", &flat, LOAD, [node(Kind::End, 12.0, 0.0), node(Kind::Support, LENGTH, -0.4)]);
}

/// However little the free beam is in the ground at mid-span, on however short a part of it and in whatever units: `φ` is 1/4
/// there.
#[test]
fn the_least_penetration_is_lifted() {
    /// Of the deflection, which is known to a few units in the last place.
    const ROUNDING: f64 = 16.0 * f64::EPSILON;
    for unit in [1.0, 1e-6, 1e-12] {
        let free = [node(Kind::Support, 0.0, unit * STEEP), node(Kind::Support, LENGTH, -unit * STEEP)];
        let sag = unit * SAG;
        for share in [1e-3, 1e-5, 1e-7, 1e-9, 1e-11, 1e-13, 1e-14] {
            let lift = lifts(&Foundation::Flat { depth: sag - share * sag }, unit * LOAD, free).0;
            let (lift, needed) = (lift.expect("there is a lift"), 4.0 * share * sag);
            assert!(needed - 4.0 * ROUNDING * sag <= lift && 0.0 < lift, "{lift}, not {needed}");
        }
    }
}

/// A beam that is clear is not lifted at all, and one that is the ground itself, but for rounding, by no more than that.
#[test]
fn what_is_clear_stays_where_it_is() {
    let free = [node(Kind::Support, 0.0, STEEP), node(Kind::Support, LENGTH, -STEEP)];
    let deep = Foundation::Flat { depth: 1.0001 * SAG };
    assert_eq!(lifts(&deep, LOAD, free).0, Some(0.0));
    let touches = [node(Kind::Touch, 4.0, 0.0), node(Kind::Touch, 9.0, 0.0)];
    let cubic = Foundation::Polynomial { coefficients: vec![1.0, 0.3, -0.07, 0.004] };
    let (tie, _) = lifts(&cubic, 0.0, touches);
    // `φ` is at most 1/16 here, and the smallest of its parts begin beside the nodes.
    assert!(tie.is_some_and(|lift| lift <= 1e-10), "{tie:?}");
}

/// The lift is zero at a node: where the beam would be below the edge of a step, or where it leaves a corner below the ground,
/// it is no help.
#[test]
fn some_spans_cannot_be_lifted() {
    let step = Foundation::Polyline { points: [[0.0, 1.0], [8.0, 1.0], [8.0, 1.5], [LENGTH, 1.5]].to_vec() };
    for kind in [Kind::Touch, Kind::Start] {
        let spans = [node(Kind::Touch, 4.0, 0.0), node(kind, 8.0, 0.0)];
        assert_eq!(lifts(&step, LOAD, spans).0, None, "half a unit below the edge");
    }
    let points = [[0.0, 2.0], [8.0, 1.0], [14.0, 1.2], [LENGTH, 2.0]].to_vec();
    let polyline = Foundation::Polyline { points };
    let corners = |slope: f64| [node(Kind::Corner, 8.0, slope), node(Kind::Corner, 14.0, 0.1)];
    assert_eq!(lifts(&polyline, 0.0, corners(0.1)).0, None, "steeper than the ground");
    assert_eq!(lifts(&polyline, 0.0, corners(0.0)).0, Some(0.0));
}

/// `φ = (s/L)^a (1 − s/L)^b`.
#[test]
fn the_shape_of_a_lift() {
    /// Of a dozen roundings.
    const ROUNDING: f64 = 1e-14;
    let span = Span {
        from: 3.0,
        to: 10.0,
        start: [Interval::ZERO; 4],
        end: [Interval::ZERO; 4],
        loaded: [Interval::ZERO; 2],
        flexible: None,
        kinks: Vec::new(),
        hung: None,
    };
    for powers in (0..3).flat_map(|a| (0..3).map(move |b| [a, b])) {
        let shape = shape(&span, powers);
        for s in [0.0, 1.0, 3.5, 6.0, 7.0_f64] {
            let power = |z: f64, times: usize| (0..times).fold(1.0, |product, _| product * z);
            let expected = power(s / 7.0, powers[0]) * power(1.0 - s / 7.0, powers[1]);
            let value = shape.at(Interval::exact(s)).middle();
            assert!((value - expected).abs() <= ROUNDING, "{powers:?}: {value} at {s}, not {expected}");
        }
    }
}
