//! Slopes at corners and at supports against what the foundation allows there.

use super::*;
use crate::certificate::{enclosed, in_intervals};
use crate::scene::{Balance, Beam, Foundation, Load, Scene};

const LENGTH: f64 = 20.0;
const STIFFNESS: f64 = 70.0;

/// Contact nodes above a foundation on a beam without a load.
fn changed<R>(
    foundation: &Foundation,
    nodes: &mut [ContactNode],
    change: impl FnOnce(&EnclosedScene<'_>, &mut [ContactNode]) -> R,
) -> R {
    let beam = Beam::new(LENGTH, STIFFNESS).expect("positive");
    let scene = Scene::new(beam, Load::default(), Some(foundation.clone())).expect("well posed");
    in_intervals(&scene, Balance::Held, |enclosed| change(enclosed, nodes))
}

/// A node where the slope is that of the beam.
fn free(x: f64, slope: f64) -> ContactNode {
    ContactNode { slope: Slope::Free(slope), ..ContactNode::free(x) }
}

fn slope(node: &ContactNode) -> f64 {
    match node.slope {
        Slope::Free(slope) => slope,
        Slope::OfGround { .. } => f64::NAN,
    }
}

fn line(points: &[[f64; 2]]) -> Foundation {
    Foundation::Polyline { points: points.to_vec() }
}

/// What is outside the slopes of the two sides comes to the nearer one, just inside, and what is between them stays. A valley
/// allows none, and gets the one in the middle. At a step only the upper side counts.
#[test]
fn slopes_at_corners_are_between_those_of_the_sides() {
    let ridge = line(&[[0.0, 21.0], [8.0, 1.0], [12.0, 21.0], [LENGTH, 21.0]]);
    let down = line(&[[0.0, 1.0], [8.0, 21.0], [8.0, 24.0], [LENGTH, 24.0]]);
    let up = line(&[[0.0, 24.0], [8.0, 24.0], [8.0, 21.0], [12.0, 1.0], [LENGTH, 1.0]]);
    let open = f64::INFINITY;
    for (foundation, [least, most], given) in [
        (&ridge, [-2.5, 5.0], -7.0),
        (&ridge, [-2.5, 5.0], -2.5),
        (&ridge, [-2.5, 5.0], 0.1),
        (&ridge, [-2.5, 5.0], 5.0),
        (&ridge, [-2.5, 5.0], 7.0),
        (&down, [2.5, open], 0.1),
        (&down, [2.5, open], 9.0),
        (&up, [-open, -5.0], -0.1),
        (&up, [-open, -5.0], -9.0),
    ] {
        let mut nodes = [free(0.0, 7.0), free(8.0, given), ContactNode::on_ground(15.0, false)];
        changed(foundation, &mut nodes, at_corners);
        let turned = slope(&nodes[1]);
        if least < given && given < most {
            assert_eq!(turned.to_bits(), given.to_bits(), "between {least} and {most}");
        } else {
            let (bound, inside) = if given <= least { (least, turned - least) } else { (most, most - turned) };
            let margin = INSIDE * (bound.abs() + given.abs());
            assert!((0.8 * margin..1.2 * margin).contains(&inside), "{given} becomes {turned} at {bound}: {inside:e}");
        }
        assert!((slope(&nodes[0]) - 7.0).abs() <= 0.0 && slope(&nodes[2]).is_nan(), "others are not asked");
    }
    let valley = line(&[[0.0, 1.0], [8.0, 21.0], [12.0, 16.0], [LENGTH, 0.0]]);
    let mut nodes = [free(8.0, 9.0)];
    changed(&valley, &mut nodes, at_corners);
    assert!((slope(&nodes[0]) - 0.625).abs() <= 4.0 * INSIDE, "between 2.5 and −1.25: {:?}", nodes[0]);
}

/// Of a support that is said to be held by the ground that is so on a side where they are level, and on no other.
#[test]
fn the_ground_holds_the_slope_where_it_is_level_with_a_support() {
    let level = line(&[[0.0, 0.0], [10.0, 2.0], [LENGTH, 0.0]]);
    let deep = line(&[[0.0, 1e-3], [10.0, 2.0], [LENGTH, 1e-3]]);
    let inner = line(&[[0.0, 1.0], [0.0, 0.0], [10.0, 2.0], [LENGTH, 0.0], [LENGTH, 1.0]]);
    let outer = line(&[[0.0, 0.0], [0.0, 1.0], [10.0, 3.0], [LENGTH, 1.0], [LENGTH, 0.0]]);
    let unit = Scale { length: 1.0, depth: 1.0, force: 1.0 };
    for (foundation, level) in [(&level, true), (&deep, false), (&inner, true), (&outer, false)] {
        for inwards in [true, false] {
            let said = [(0.0, !inwards), (LENGTH, inwards)];
            let found = changed(foundation, &mut [], |enclosed, _| nodes(enclosed, &[], &said, &unit));
            let held: Vec<(f64, bool)> = found
                .iter()
                .filter_map(|node| match node.slope {
                    Slope::OfGround { from_the_left } => Some((node.x, from_the_left)),
                    Slope::Free(_) => None,
                })
                .collect();
            assert_eq!(held, if level && inwards { said.to_vec() } else { Vec::new() }, "{foundation:?}");
        }
    }
}

/// Right or wrong, in order or not, contacts stay where they are, and become no others.
#[test]
fn a_list_stays_as_it_is_given() {
    const LENGTH: f64 = 8.0;
    let beam = Beam::new(LENGTH, 70.0).expect("positive");
    let load = Load::uniform_on(&beam, 3.0).expect("finite");
    let ground = Foundation::Polyline { points: vec![[0.0, 1.0], [3.0, 2.0], [5.0, 1.0], [8.0, 2.0]] };
    let scene = Scene::new(beam.clone(), load, Some(ground)).expect("well posed");
    // Free, of the ground, and at the start of a zone.
    let letter = |node: &ContactNode| match node.slope {
        Slope::Free(_) => 'f',
        Slope::OfGround { from_the_left: true } => 'e',
        Slope::OfGround { .. } if node.lies => 's',
        Slope::OfGround { .. } => 't',
    };
    for (given, kinds) in [
        (&[][..], "ff"),
        (&[[5.0, 5.0], [5.5, 5.5]], "fftf"),
        (&[[3.0, 3.0], [4.0, 7.0]], "ftsef"),
        (&[[0.0, 1.0], [7.5, 8.0]], "sese"),
        (&[[1e-12, 1.0]], "fsef"),
        (&[[0.0, 0.0], [8.0, 8.0]], "ff"),
        (&[[1.0, 1.0], [1.0, 1.0], [6.0, 2.0]], "fttsef"),
        (&[[f64::NAN, f64::NAN], [2.0, f64::INFINITY]], "sefsse"),
    ] {
        let contacts: Vec<Contact> =
            given.iter().map(|&[from, to]| Contact { from, to, force: 1.0, end_forces: None }).collect();
        let found =
            enclosed(&scene, |enclosed, scaled| (nodes(enclosed, &contacts, &[], &scaled.scale), scaled.scale.length));
        let (found, unit) = found.expect("in range");
        assert_eq!(found.iter().map(letter).collect::<String>(), kinds, "{given:?}: {found:?}");
        let mut inside: Vec<u64> = found.iter().map(|j| (j.x * unit).to_bits()).collect();
        let all = given.iter().flat_map(|&[from, to]| {
            if from.total_cmp(&to).is_eq() && !from.is_nan() { vec![from] } else { vec![from, to] }
        });
        for place in all.map(f64::to_bits) {
            let at = inside.iter().position(|x| *x == place);
            assert!(at.is_some(), "{given:?}: {found:?}");
            inside.remove(at.unwrap_or(0));
        }
        assert!(inside.iter().all(|x| [0.0, LENGTH].map(f64::to_bits).contains(x)), "{given:?}: {found:?}");
    }
}

/// However a zone is divided, and whatever point is named at one of its ends, the same is proven as of the whole.
#[test]
fn zones_that_share_an_end_are_one() {
    const LENGTH: f64 = 10.0;
    const STIFFNESS: f64 = 1.3;
    let beam = Beam::new(LENGTH, STIFFNESS).expect("positive");
    for (q, depth) in [(1.0, 1.0), (3.0, 0.2), (700.0, 1e-3)] {
        let load = Load::uniform_on(&beam, q).expect("finite");
        let scene = Scene::new(beam.clone(), load, Some(Foundation::Flat { depth })).expect("well posed");
        // a⁴ = 24 EI u/q.
        let a = (24.0 * STIFFNESS * depth / q).sqrt().sqrt();
        let contact = |[from, to]: [f64; 2]| Contact { from, to, force: 1.0, end_forces: None };
        let said = |list: &[[f64; 2]]| {
            let contacts: Vec<Contact> = list.iter().copied().map(contact).collect();
            crate::certificate::certify(&scene, crate::certificate::Judged::Witness, &contacts).expect("in range")
        };
        let whole = said(&[[a, LENGTH - a]]);
        assert!(whole.contacts_proven, "{whole:?}");
        for share in [1e-9, 0.125, 0.3, 0.5, 0.9] {
            let between = a + share * (LENGTH - 2.0 * a);
            let middle = 0.5 * (between + LENGTH - a);
            assert_eq!(said(&[[a, between], [between, LENGTH - a]]), whole, "at {between}");
            assert_eq!(said(&[[a, between], [between, middle], [middle, LENGTH - a]]), whole, "twice");
            assert_eq!(said(&[[a, between], [between, between], [between, LENGTH - a]]), whole, "a point between");
        }
        assert_eq!(said(&[[a, LENGTH - a], [LENGTH - a, LENGTH - a]]), whole, "a point at the end");
    }
}

/// Corners of the gap: of the ground, of the own shape, and of both at one place, where only their difference counts.
#[test]
fn corners_of_the_gap_are_those_that_point_upwards() {
    let ground = line(&[
        [0.0, 2.0],
        [1.0, 2.0],
        [2.0, 2.0],
        [3.0, 4.0],
        [4.0, 3.0],
        [5.0, 2.0],
        [5.0, 1.0],
        [6.0, 3.0],
        [7.0, 2.0],
        [8.0, 2.5],
        [8.0, 3.5],
        [LENGTH, 3.5],
    ]);
    let corners = |shape: Option<&Foundation>| {
        let beam = Beam::new(LENGTH, STIFFNESS).expect("positive").with_supports(Vec::new()).expect("none");
        let beam = shape.map_or(beam.clone(), |shape| beam.with_shape(shape.clone()).expect("an axis"));
        let load = Load::uniform_on(&beam, 1.0).expect("finite");
        let scene = Scene::new(beam, load, Some(ground.clone())).expect("well posed");
        let places = (1..40).map(|k| 0.5 * f64::from(k));
        in_intervals(&scene, Balance::Held, |enclosed| {
            places.filter(|&x| enclosed.gap.is_corner(x)).collect::<Vec<f64>>()
        })
    };
    assert_eq!(corners(None), [2.0, 5.0, 7.0, 8.0]);
    let shape = line(&[[0.0, 0.0], [2.0, 0.0], [3.0, 3.0], [12.0, 3.0], [14.0, 4.0], [LENGTH, 4.0]]);
    assert_eq!(corners(Some(&shape)), [5.0, 7.0, 8.0, 14.0], "more of the beam falls away at 2 than of the ground");
}
