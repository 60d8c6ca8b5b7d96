//! Where a beam is carried, and which of these places hold it.

use super::super::lines::widest;
use super::*;
use crate::certificate::in_intervals;
use crate::certificate::kernel::contact_node::tests::{Kind, node};
use crate::certificate::kernel::distance::on_part;
use crate::certificate::kernel::polynomial::Polynomial;
use crate::certificate::kernel::tension::Taut;
use crate::scene::{Balance, Beam, Foundation, LinearLoad, Load, PointLoad, Scene};

const LENGTH: f64 = 20.0;
const STIFFNESS: f64 = 70.0;
const LOAD: f64 = 3.0;
const DEPTH: f64 = 0.4;

/// A zone presses with `q − EI u''''`, under a load that is even, rises or falls.
#[test]
fn outer_thirds_press_with_what_lies_on_them() {
    let beam = Beam::new(LENGTH, STIFFNESS).expect("positive");
    let curved = Foundation::Polynomial { coefficients: vec![DEPTH, 0.0, 0.0, 0.0, 1e-3] };
    for growth in [0.0, 1.0, -0.25] {
        let growing = LinearLoad { from: 0.0, to: LENGTH, start: LOAD, end: LOAD * (1.0 + growth) };
        let load = Load::new(&beam, 0.0, vec![growing], Vec::new()).expect("finite");
        let scene = Scene::new(beam.clone(), load, Some(curved.clone())).expect("well posed");
        let thirds = in_intervals(&scene, Balance::Held, |enclosed| every_other(enclosed, [4.0, 16.0], 3));
        assert_eq!(thirds.len(), 2);
        for (place, [from, to]) in thirds.into_iter().zip([[4.0, 8.0], [12.0, 16.0]]) {
            let middle = 0.5 * (from + to) / LENGTH;
            let (force, expected) = (place.presses, 4.0 * (LOAD * (1.0 + growth * middle) - 24e-3 * STIFFNESS));
            assert!(
                place.from.total_cmp(&from).is_eq() && place.to.total_cmp(&to).is_eq() && place.uncertainty <= 0.0,
                "{place:?}"
            );
            assert!(force <= expected && expected - force <= 1e-10 * expected, "{force} for {expected}");
        }
    }
}

/// Of places that press those two hold a beam that are strong and far apart; parts that overlap do not.
#[test]
fn the_widest_of_the_strongest_places_hold() {
    let part = |from: f64, to: f64, presses: f64| Datum { to, presses, ..Datum::at(from) };
    // Distance by the weaker force: (9 − 1) · 1 for the first two, (4 − 3) · 9 for the others.
    let mut presses = vec![part(0.0, 1.0, 1.0), part(9.0, 9.0, 1.0), part(4.0, 4.0, 9.0), part(0.5, 3.0, 9.0)];
    let held = |presses: &mut [Datum], left: f64, right: f64| {
        let Some(Line(first, last)) = widest(presses) else { return false };
        first.from.total_cmp(&left).is_eq() && last.from.total_cmp(&right).is_eq()
    };
    assert!(held(&mut presses, 0.5, 4.0));
    presses.iter_mut().filter(|p| p.presses < 2.0).for_each(|p| p.presses = 1.25);
    assert!(held(&mut presses, 0.0, 9.0));
    assert!(widest(&mut [part(0.0, 2.0, 1.0), part(1.0, 3.0, 1.0)]).is_none(), "no two places are apart");
}

/// A place carries what is certain of its force, and none that may pull; a load inside a part of a zone leaves that part out.
#[test]
fn what_may_pull_carries_nothing() {
    let beam = Beam::new(LENGTH, STIFFNESS).expect("positive").with_supports(Vec::new()).expect("none");
    let load = Load::new(&beam, LOAD, Vec::new(), vec![PointLoad { at: 5.0, force: 2.0 }]).expect("finite");
    let scene = Scene::new(beam, load, Some(Foundation::Flat { depth: DEPTH })).expect("well posed");
    in_intervals(&scene, Balance::Held, |enclosed| {
        let nodes = [4.0, 9.0].map(|x| node(Kind::Touch, x, 0.0));
        let forces = [[1.0, 2.0], [-1.0, 2.0]].map(|[lo, hi]| Interval::between(lo, hi));
        let places = carriers(enclosed, &nodes, &forces);
        assert_eq!(places.iter().map(|place| [place.from, place.presses]).collect::<Vec<_>>(), [[4.0, 1.0]]);
        let parts = every_other(enclosed, [4.0, 16.0], 3);
        assert_eq!(parts.iter().map(|part| [part.from, part.to]).collect::<Vec<_>>(), [[12.0, 16.0]]);
    });
}

/// Stops at the distances 4 and 6, with the clearances 0.5 and 0.25, of a place that may be off by 0.1: the formula, and the line
/// between them bent by the lever.
#[test]
fn stops_are_off_by_what_the_other_one_leaves() {
    let [left, at, right] =
        [(1.0, 0.5), (5.0, 0.1), (11.0, 0.25)].map(|(x, off)| Datum { uncertainty: off, ..Datum::at(x) });
    for factor in [0.0, 0.125] {
        let Line(one, other) = between_stops(Line(left, right), at, factor, 0.0);
        let risen = 10.0 * (0.1 + factor * Line(left, right).lever([5.0; 2], 0.0));
        for (place, expected) in [(one, (risen + 4.0 * 0.25) / 6.0), (other, (risen + 6.0 * 0.5) / 4.0)] {
            let expected = expected.max(if place.from < 5.0 { 0.5 } else { 0.25 });
            assert!(
                expected <= place.uncertainty && place.uncertainty <= (1.0 + 1e-12) * expected,
                "{place:?}, not {expected}"
            );
        }
    }
    // What is open at a stop itself is not less there.
    let Line(one, _) = between_stops(Line(Datum { uncertainty: 5.0, ..left }, right), at, 0.0, 0.0);
    assert!(5.0 <= one.uncertainty, "{one:?}");
}

/// Parts of a zone that ends at a support, with what the gap leaves open at each: two that hold are apart, and so is the support.
#[test]
fn parts_of_zones_hold_with_what_is_apart() {
    const GAP: f64 = 1e-6;
    let beam = Beam::new(LENGTH, STIFFNESS).expect("positive");
    let load = Load::uniform_on(&beam, LOAD).expect("finite");
    let scene = Scene::new(beam, load, Some(Foundation::Flat { depth: 0.0 })).expect("well posed");
    let nodes = [node(Kind::Support, 0.0, 0.0), node(Kind::Start, 4.0, 0.0), node(Kind::End, LENGTH, 0.0)];
    let mut pair = Pair {
        pieces: Vec::new(),
        gap: GAP,
        carried: Vec::new(),
        lines: vec![Line(Datum::at(0.0), Datum::at(LENGTH))],
        zones: Vec::new(),
        turns_about: None,
        lifted: 0.0,
        ground: None,
        turned: Interval::ZERO,
        soft: 0.0,
        taut: Taut::default(),
    };
    // Far from the first line there are too many of zones, none of which is known as well.
    let (end, most) = ([LENGTH; 2], factor(GAP, STIFFNESS));
    let alone = on_part(&pair, most, end);
    in_intervals(&scene, Balance::Held, |enclosed| hold_by_zones(enclosed, &nodes, &mut pair));
    assert!(on_part(&pair, most, end) <= alone, "zones besides make no bound wider");
    assert!(100 < pair.zones.len(), "{}", pair.zones.len());
    for Line(left, right) in pair.zones {
        assert!(left.to < right.from, "{left:?} and {right:?}");
        for place in [left, right].into_iter().filter(|place| place.presses.is_finite()) {
            assert!(GAP <= place.uncertainty * place.presses * (1.0 + 1e-15) && 0.0 < place.presses, "{place:?}");
        }
    }
}

/// A beam that lies level on a crest: beside it the clearance is `c s²`, far below the digits of both depths.
#[test]
fn beside_a_crest_stops_are_as_far_off_as_the_ground() {
    /// Depths and coefficients are sums of powers of two.
    const BEND: f64 = 1.0 / 128.0;
    const LEVEL: f64 = 0.5;
    const APART: f64 = 1e-3;
    /// Of a product, beside `10⁻⁸` of a difference of two depths.
    const ROUNDING: f64 = 1e-12;
    let beam = Beam::new(LENGTH, STIFFNESS).expect("positive").with_supports(Vec::new()).expect("none");
    let crest = 0.5 * LENGTH;
    let coefficients = vec![LEVEL + BEND * crest * crest, -2.0 * BEND * crest, BEND];
    let load = Load::uniform_on(&beam, LOAD).expect("finite");
    let scene = Scene::new(beam, load, Some(Foundation::Polynomial { coefficients })).expect("well posed");
    let v = Polynomial::new(&[Interval::exact(LEVEL)]);
    let pieces = [[0.0, crest], [crest, LENGTH]].map(|[from, to]| Piece { from, to, v, pressed: false });
    let found = in_intervals(&scene, Balance::Held, |enclosed| stops(enclosed, &pieces, crest, APART));
    let Some(Line(left, right)) = found else { panic!("ground on both sides") };
    for (place, side) in [(left, -1.0), (right, 1.0)] {
        let distance = side * (place.from - crest);
        let expected = BEND * distance * distance;
        assert!((distance - APART).abs() < 1e-12, "{place:?}");
        assert!((place.uncertainty - expected).abs() <= ROUNDING * expected, "{place:?}, not {expected:e}");
    }
}
