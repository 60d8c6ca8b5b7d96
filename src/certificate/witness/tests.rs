//! Slopes at corners and at supports against what the foundation allows there.

use super::*;
use crate::certificate::kernel::load::EnclosedLoad;
use crate::scene::{Beam, Load, Scene};

const LENGTH: f64 = 20.0;
const STIFFNESS: f64 = 70.0;

/// Contact nodes above a foundation on a beam without a load.
fn changed<R>(
    foundation: &Foundation,
    nodes: &mut [ContactNode],
    change: impl FnOnce(&EnclosedScene<'_>, &mut [ContactNode]) -> R,
) -> R {
    let beam = Beam::new(LENGTH, STIFFNESS).expect("positive");
    let load = Load::new(&beam, 0.0, Vec::new(), Vec::new()).expect("finite");
    let pieces = EnclosedLoad::of(&Scene::new(beam.clone(), load, None).expect("well posed"));
    let ground = EnclosedFoundation::on(foundation, LENGTH);
    change(&EnclosedScene { foundation: ground, load: &pieces, stiffness: STIFFNESS, length: LENGTH }, nodes)
}

fn node(kind: Kind, x: f64, slope: f64) -> ContactNode {
    ContactNode { kind, x, slope }
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
    let free = f64::INFINITY;
    for (foundation, [least, most], slope) in [
        (&ridge, [-2.5, 5.0], -7.0),
        (&ridge, [-2.5, 5.0], -2.5),
        (&ridge, [-2.5, 5.0], 0.1),
        (&ridge, [-2.5, 5.0], 5.0),
        (&ridge, [-2.5, 5.0], 7.0),
        (&down, [2.5, free], 0.1),
        (&down, [2.5, free], 9.0),
        (&up, [-free, -5.0], -0.1),
        (&up, [-free, -5.0], -9.0),
    ] {
        let mut nodes = [node(Kind::Support, 0.0, 7.0), node(Kind::Corner, 8.0, slope), node(Kind::Touch, 15.0, 7.0)];
        changed(foundation, &mut nodes, at_corners);
        let turned = nodes[1].slope;
        if least < slope && slope < most {
            assert_eq!(turned.to_bits(), slope.to_bits(), "between {least} and {most}");
        } else {
            let (bound, inside) = if slope <= least { (least, turned - least) } else { (most, most - turned) };
            let margin = INSIDE * (bound.abs() + slope.abs());
            assert!((0.8 * margin..1.2 * margin).contains(&inside), "{slope} becomes {turned} at {bound}: {inside:e}");
        }
        assert!([0, 2].iter().all(|k| (nodes[*k].slope - 7.0).abs() <= 0.0), "others are not asked");
    }
    let valley = line(&[[0.0, 1.0], [8.0, 21.0], [12.0, 16.0], [LENGTH, 0.0]]);
    let mut nodes = [node(Kind::Corner, 8.0, 9.0)];
    changed(&valley, &mut nodes, at_corners);
    assert!((nodes[0].slope - 0.625).abs() <= 4.0 * INSIDE, "between 2.5 and −1.25: {:?}", nodes[0]);
}

/// A support becomes a clamp where the beam would be steeper than ground that is level with it, on the beam's side.
#[test]
fn a_support_holds_a_beam_that_is_steeper_than_the_ground() {
    let level = line(&[[0.0, 0.0], [10.0, 2.0], [LENGTH, 0.0]]);
    let deep = line(&[[0.0, 1e-3], [10.0, 2.0], [LENGTH, 1e-3]]);
    let inner = line(&[[0.0, 1.0], [0.0, 0.0], [10.0, 2.0], [LENGTH, 0.0], [LENGTH, 1.0]]);
    let outer = line(&[[0.0, 0.0], [0.0, 1.0], [10.0, 3.0], [LENGTH, 1.0], [LENGTH, 0.0]]);
    for (foundation, slope, holds) in [
        (&level, 0.3, true),
        (&level, 0.2 * (1.0 + 1e-11), true),
        (&level, 0.2 * (1.0 + 1e-12), false),
        (&level, 0.1, false),
        (&level, -0.3, false),
        (&deep, 0.3, false),
        (&inner, 0.3, true),
        (&outer, 0.3, false),
    ] {
        for sides in [[true, false], [false, true]] {
            let [left, right] = sides.map(|this| if this { slope } else { 0.0 });
            let corner = node(Kind::Corner, 10.0, 0.0);
            let mut nodes = [node(Kind::Support, 0.0, left), corner, node(Kind::Support, LENGTH, -right)];
            assert_eq!(changed(foundation, &mut nodes, at_supports), holds, "{slope}: {foundation:?}");
            let clamps = [nodes[0].kind == Kind::Clamp, nodes[2].kind == Kind::Clamp];
            assert_eq!(clamps, sides.map(|this| this && holds), "{slope}: {nodes:?}");
        }
    }
}

/// A clamp lets go where it would have to pull, `EI v'' < 0` beside it: with the slope 0.2 of the ground and the slope `θ` at
/// the other end `v'' = −(0.8 + 2 θ)/L`.
#[test]
fn a_clamp_lets_go_of_a_beam_that_it_would_have_to_pull() {
    let level = line(&[[0.0, 0.0], [10.0, 2.0], [LENGTH, 0.0]]);
    for (slope, goes) in [(-0.3, true), (-0.5, false)] {
        let mut left = [node(Kind::Clamp, 0.0, 0.0), node(Kind::Corner, LENGTH, slope)];
        let mut right = [node(Kind::Corner, 0.0, -slope), node(Kind::Clamp, LENGTH, 0.0)];
        for (nodes, end) in [(&mut left, 0), (&mut right, 1)] {
            assert_eq!(changed(&level, nodes, at_supports), goes, "{slope}: {nodes:?}");
            assert_eq!(nodes[end].kind == Kind::Support, goes, "{slope}: {nodes:?}");
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
    let scaled = Scene::new(beam.clone(), load, Some(ground)).expect("well posed").scaled().expect("in range");
    let (scene, scale, unit) = (&scaled.scene, scaled.scale, scaled.scale.length);
    let pieces = EnclosedLoad::of(scene);
    let ground = EnclosedFoundation::of(scene).expect("there is a foundation");
    let stiffness = scene.beam().bending_stiffness();
    let enclosed = EnclosedScene { foundation: ground, load: &pieces, stiffness, length: scene.beam().length() };
    use Kind::{Corner, End, Start, Support, Touch};
    for (given, kinds) in [
        (&[][..], &[Support, Support][..]),
        (&[[5.0, 5.0], [5.5, 5.5]], &[Support, Corner, Touch, Support]),
        (&[[3.0, 3.0], [4.0, 7.0]], &[Support, Touch, Start, End, Support]),
        (&[[0.0, 1.0], [7.5, 8.0]], &[Start, End, Start, End]),
        (&[[1e-12, 1.0]], &[Support, Start, End, Support]),
        (&[[0.0, 0.0], [8.0, 8.0]], &[Support, Support]),
        (&[[6.0, 2.0], [1.0, 1.0], [1.0, 1.0], [9.0, 9.0]], &[Support, Start, End, Touch, Touch, Touch, Support]),
        (&[[f64::NAN, f64::NAN], [2.0, f64::INFINITY]], &[Support, Start, End, Start, End, Support]),
    ] {
        let contacts: Vec<Contact> =
            given.iter().map(|&[from, to]| Contact { from, to, force: 1.0, end_forces: None }).collect();
        let found = nodes(&enclosed, &contacts, &scale);
        assert!(found.iter().map(|j| j.kind).eq(kinds.iter().copied()), "{given:?}: {found:?}");
        let inside = found.iter().filter(|j| j.kind != Support).map(|j| (j.x * unit).to_bits());
        let all = given.iter().flat_map(|&[from, to]| {
            if from.total_cmp(&to).is_eq() && !from.is_nan() { vec![from] } else { vec![from, to] }
        });
        let expected: Vec<u64> = all.map(f64::to_bits).collect();
        let found: Vec<u64> = inside.collect();
        assert!(found == expected || given == [[0.0, 0.0], [8.0, 8.0]], "{given:?}: {found:?}");
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
