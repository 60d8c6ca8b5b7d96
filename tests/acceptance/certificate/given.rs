//! What is given: forces as they are read, and which condition they violate, against closed forms.

use palkki::certificate::{ContactLoad, NotAForce, Violation, ViolationKind, violations};
use palkki::scene::{Foundation, Support};

use crate::scenes::{on_supports, uniform};

const LENGTH: f64 = 20.0;
const STIFFNESS: f64 = 70.0;
const LOAD: f64 = 3.0;
/// Of a closed form with a few powers.
const ROUNDING: f64 = 1e-12;

fn load(forces: &[(f64, f64)]) -> ContactLoad {
    ContactLoad::new(LENGTH, forces.iter().copied()).expect("finite forces on the beam")
}

#[test]
fn forces_are_put_in_order_and_those_at_one_place_add_up() {
    let given = load(&[(15.0, 1.0), (2.0, -3.0), (15.0, 2.0), (2.0, 1.0), (16.0, 0.0), (20.0, 1.0), (0.0, 1.0)]);
    assert_eq!(given, load(&[(0.0, 1.0), (2.0, -2.0), (15.0, 3.0), (16.0, 0.0), (20.0, 1.0)]));
    assert_eq!(given.pulling(), [(2.0, -2.0)]);
    let without = load(&[(0.0, 1.0), (2.0, -2.0), (15.0, 3.0), (20.0, 1.0)]);
    assert_ne!(given, without, "a zero is no force, and still a node between two others");
}

#[test]
fn what_is_refused_is_named() {
    let refused = |forces: [(f64, f64); 2]| ContactLoad::new(LENGTH, forces).expect_err("no force on the beam");
    let sound = (1.0, 1.0);
    let infinite = refused([sound, (2.0, f64::INFINITY)]);
    assert!(matches!(infinite, NotAForce::NotFinite { index: 1, .. }), "{infinite}");
    assert_eq!(infinite.index(), 1);
    let nowhere = refused([(f64::NAN, 1.0), sound]);
    assert!(matches!(nowhere, NotAForce::NotFinite { index: 0, .. }), "{nowhere}");
    assert_eq!(nowhere.index(), 0);
    for x in [-1e-9, LENGTH + 1e-9] {
        let outside = refused([sound, (x, 1.0)]);
        assert!(matches!(outside, NotAForce::OutsideBeam { index: 1, .. }), "{outside}");
        assert_eq!(outside.index(), 1);
    }
}

/// Deflection `q x (l³ − 2 l x² + x³)/24 EI` of the free beam, less `F b x (l² − b² − x²)/6 EI l` for a force at `l − b`, `x ≤ l − b`.
fn deflection(x: f64, forces: &[(f64, f64)]) -> f64 {
    let free = LOAD * x * (LENGTH * LENGTH * LENGTH - 2.0 * LENGTH * x * x + x * x * x) / (24.0 * STIFFNESS);
    let lifted = forces.iter().map(|&(at, force)| {
        let (x, b) = if x <= at { (x, LENGTH - at) } else { (LENGTH - x, at) };
        force * b * x * (LENGTH * LENGTH - b * b - x * x) / (6.0 * STIFFNESS * LENGTH)
    });
    free - lifted.sum::<f64>()
}

#[track_caller]
fn check(depth: f64, forces: &[(f64, f64)], expected: &[(ViolationKind, f64, f64, f64)]) {
    let scene = uniform(LENGTH, STIFFNESS, LOAD, Foundation::Flat { depth });
    let mut found = violations(&scene, &load(forces)).expect("the scene can be scaled");
    found.retain(|violation| ROUNDING < violation.relative);
    assert_eq!(found.len(), expected.len(), "{found:?}");
    for (Violation { kind, at, amount, relative }, expected) in found.iter().zip(expected) {
        assert_eq!(*kind, expected.0, "{found:?}");
        for (number, expected) in [at, amount, relative].into_iter().zip([expected.1, expected.2, expected.3]) {
            assert!((number - expected).abs() <= ROUNDING * expected, "{kind:?}: {number}, not {expected}");
        }
    }
}

#[test]
fn penetration_is_measured_by_the_largest_deflection() {
    let forces = [(10.0, 10.0)];
    let most = deflection(10.0, &forces);
    check(0.4, &forces, &[(ViolationKind::Penetration, 10.0, most - 0.4, (most - 0.4) / most)]);
}

#[test]
fn a_force_across_a_clearance_is_measured_by_the_smaller_one() {
    let forces = [(10.0, 10.0)];
    let (most, depth) = (deflection(10.0, &forces), 100.0);
    assert!(most < depth && depth - most < most, "clear, and less so than the beam has moved");
    check(depth, &forces, &[(ViolationKind::Complementarity, 10.0, depth - most, (depth - most) / most)]);
    // Of two forces the small one is far from the ground; the large one counts.
    let forces = [(4.0, 0.01), (10.0, 10.0)];
    let most = deflection(10.0, &forces);
    check(depth, &forces, &[(ViolationKind::Complementarity, 10.0, depth - most, (depth - most) / most)]);
    // Both count, and the beam is where both of them hold it.
    let forces = [(4.0, 8.0), (10.0, 10.0)];
    let most = deflection(10.0, &forces);
    assert!(
        deflection(4.0, &forces) < most && 70.0 - most < most * 8.0 / 18.0,
        "the force at mid-span is clear by less"
    );
    let share = most * 8.0 / 18.0;
    assert!(share < 70.0 - deflection(4.0, &forces), "the other one by more than it is worth");
    check(70.0, &forces, &[(ViolationKind::Complementarity, 4.0, share, 8.0 / 18.0)]);
    let forces = [(4.0, 4.0), (10.0, 4.0)];
    let (most, depth) = (deflection(10.0, &forces), 100.0);
    let share = 0.5 * most;
    assert!(depth - most < share && share < depth - deflection(4.0, &forces));
    check(depth, &forces, &[(ViolationKind::Complementarity, 4.0, share, 0.5)]);
    // A force that is far from the ground, but as good as none.
    let forces = [(4.0, 1.0), (10.0, 30.0)];
    let (small, most) = (deflection(4.0, &forces), deflection(10.0, &forces));
    assert!(most / 31.0 < most - small, "the force is the smaller one");
    check(most, &forces, &[(ViolationKind::Complementarity, 4.0, most / 31.0, 1.0 / 31.0)]);
}

#[test]
fn a_pull_is_measured_by_all_forces_and_is_not_there_for_the_beam() {
    let most = deflection(10.0, &[(10.0, 10.0)]);
    let forces = [(4.0, -2.0), (10.0, 10.0), (12.0, -1.0)];
    check(most, &forces, &[(ViolationKind::Tension, 4.0, 2.0, 2.0 / 13.0)]);
    let [penetration, pull] = [(most - 0.4) / most, 2.0 / 13.0];
    let both = [(ViolationKind::Penetration, 10.0, most - 0.4, penetration), (ViolationKind::Tension, 4.0, 2.0, pull)];
    check(0.4, &forces, &both);
}

/// On one hinge, at 4 of 20, the resultant `3 · 20` at 10 is held by `60 · 6/12` at 16: of a force more there `12/20` is not in balance.
#[test]
fn forces_on_a_beam_with_one_hinge_are_in_balance_about_it() {
    let ground = Some(Foundation::Flat { depth: 0.5 });
    let scene = on_supports([LENGTH, STIFFNESS], &[Support::simple(4.0)], (LOAD, &[]), ground);
    for (force, expected) in [(30.0, None), (31.0, Some(0.6))] {
        let found = violations(&scene, &load(&[(16.0, force)])).expect("the scene can be scaled");
        let balance = found.into_iter().find(|violation| violation.kind == ViolationKind::Balance);
        assert_eq!(balance.is_some(), expected.is_some(), "{force}: {balance:?}");
        for (Violation { at, amount, relative, .. }, expected) in balance.iter().zip(expected) {
            for (number, expected) in [(*at, 10.0), (*amount, expected), (*relative, expected / 60.0)] {
                assert!((number - expected).abs() <= ROUNDING * expected, "{number}, not {expected}");
            }
        }
    }
}
