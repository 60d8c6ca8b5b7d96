//! The judge is judged: faults in the answers of every route are refused by the check of the discrete problem or harmless,
//! and whatever is guaranteed about an answer, however wrong, is true.

mod exact;

use std::collections::BTreeSet;

use palkki::certificate::{CERTIFIED_RESIDUAL, Kkt};
use palkki::route::{Method, Solver};
use palkki::scene::{Scene, Support};
use palkki::state::ContactState;
use palkki_evidence::closed;
use palkki_evidence::draft::{Draft, Units};
use palkki_evidence::faults::{Distance, FAULTS, Fault, Truth, every_fault, every_second, scaled_ground, scaled_load};

use super::passes;
use crate::scenes::{example, on_supports, report, run};

/// Few, so that every solver takes part.
const INTERVALS: usize = 20;

/// What the check lets pass is so near to the solution in deflections, clearances, moments, reactions and places: ten times
/// its own threshold, which is measured by deflections and loads of the answer that is checked, not by those of the solution.
const NEAR: f64 = 10.0 * CERTIFIED_RESIDUAL;

/// The check sees a nodal force through the deflection that it causes, `p Δ³ / EI` times a number of order one for forces
/// that balance each other among neighbours: its threshold in clearance is worth so many forces of the size of the load.
fn unseen_force(scene: &Scene, deflection: f64, load: f64) -> f64 {
    #[expect(clippy::cast_precision_loss, reason = "few intervals")]
    let spacing = scene.beam().length() / INTERVALS as f64;
    // The norm of the pentadiagonal matrix of finite differences, which is larger than that of K: 16 EI/Δ³.
    let stiffness = 16.0 * scene.beam().bending_stiffness() / (spacing * spacing * spacing);
    NEAR * (1.0 + stiffness * deflection / load)
}

/// What passes is near the solution `sound`; true if it passes.
#[track_caller]
fn passes_only_near(what: &str, truth: &Truth<'_>, sound: &ContactState, state: &ContactState) -> bool {
    let passed = passes(truth.scene, state);
    if passed {
        let length = truth.scene.beam().length();
        let load = truth.scene.load().magnitude(length);
        let distance = Distance::between(sound, state, length, load);
        let near = distance.shape() <= NEAR && distance.force <= unseen_force(truth.scene, truth.deflection, load);
        assert!(near, "{what} passes, and is off by {distance:?}");
    }
    passed
}

/// Nothing untrue is guaranteed about `state`; true if something is guaranteed.
#[track_caller]
fn bounded_truthfully(what: &str, truth: &Truth<'_>, state: &ContactState) -> bool {
    let judged = state.nodes.as_ref().and_then(|nodes| truth.nodes(nodes));
    judged.is_some_and(|judged| {
        assert!(judged.false_bounds.is_empty(), "{what}: {:?} of {judged:?}", judged.false_bounds);
        judged.certificate.deflection_error.is_finite()
    })
}

/// Faults of this size and above are refused wherever there is contact on the scenes of the report; where there is none, forces are
/// rounding, and a share of rounding is harmless.
const REFUSED: f64 = 1e-6;

/// Every fault in the answers of every route on the scenes of the report, and a middle and the largest size of each in those of the
/// active set where there is a closed form. Bounds are asked of these two sizes and of one method; the report has all of them.
#[test]
fn faults_are_refused_or_harmless_and_bounded_truthfully() {
    let (gallery, held) = (report(), closed::held().expect("well-posed scenes"));
    let beside_theory =
        gallery.iter().map(|(name, scene)| (name, Truth::of(scene).expect("an answer"), &Solver::ALL[..]));
    let beside_closed = held.iter().map(|known| (&known.name, Truth::closed(known), &[Solver::ActiveSet][..]));
    let mut effective = BTreeSet::new();
    for (name, truth, solvers) in beside_theory.chain(beside_closed) {
        let mut bounded = 0;
        for (method, &solver) in Method::ALL.into_iter().flat_map(|m| solvers.iter().map(move |s| (m, s))) {
            let by_active_set = solver == Solver::ActiveSet;
            let sound = run(truth.scene, method, Solver::ActiveSet, INTERVALS).state;
            let state = if by_active_set { sound.clone() } else { run(truth.scene, method, solver, INTERVALS).state };
            let what = format!("{name}, {method}, {solver}");
            if by_active_set {
                assert!(passes(truth.scene, &state), "{what}: without a fault it passes");
                assert!(bounded_truthfully(&what, &truth, &state), "{what}: without a fault it has a bound");
            }
            let of_report = 1 < solvers.len();
            for (fault, size, broken) in every_fault(&state, truth.scene) {
                let middle_or_largest = !fault.sized || [1e-6, 1e-1].contains(&size);
                if !of_report && !middle_or_largest {
                    continue;
                }
                let what = format!("{what}: {}, {size:e}", fault.name);
                effective.insert(fault.name);
                let passed = passes_only_near(&what, &truth, &sound, &broken);
                // A mirror image may be the answer itself.
                let seen = (REFUSED <= size || !fault.sized) && !fault.name.ends_with("round");
                let touches = of_report && by_active_set && !state.contacts.is_empty();
                assert!(!(passed && seen && touches), "{what} goes unnoticed");
                if method == Method::Force && by_active_set && middle_or_largest {
                    bounded += usize::from(bounded_truthfully(&what, &truth, &broken));
                }
            }
        }
        assert!(20 < bounded, "{name}: something can be said of {bounded} wrong answers");
    }
    assert_eq!(effective.len(), FAULTS.len(), "every fault changes some answer: {effective:?}");
}

/// What our check finds of each fault in the answers of the active set.
fn found(scene: &Scene) -> Vec<String> {
    let of_method = |method: Method| {
        let state = run(scene, method, Solver::ActiveSet, INTERVALS).state;
        let told = |(fault, size, broken): (Fault, f64, ContactState)| {
            format!("{method}, {}, {size:e}: {:?}", fault.name, Kkt::of(scene, &broken))
        };
        every_fault(&state, scene).map(told).collect::<Vec<_>>()
    };
    Method::ALL.into_iter().flat_map(of_method).collect()
}

/// What is found of a fault is a share: in units that are powers of two it has the same bits. Without loads a fault has no size.
#[test]
fn a_fault_is_as_large_in_any_unit() {
    let two_to = |power: i32| 2.0_f64.powi(power);
    let held = closed::held().expect("well-posed scenes").into_iter().map(|known| (known.name, known.scene));
    let loaded = |scene: &Scene| 0.0 < scene.load().magnitude(scene.beam().length());
    let bearing = [Support::simple(0.0), Support::pushing(5.0).at_level(0.3), Support::simple(10.0)];
    let bearing = ("a bearing".to_owned(), on_supports([10.0, 70.0], &bearing, (2.0, &[]), None));
    let mut compared = 0;
    for (name, scene) in report().into_iter().chain(held).chain([bearing]).filter(|(_, scene)| loaded(scene)) {
        let expected = found(&scene);
        for [length, depth, force] in [[0, -10, 0], [0, 0, -20], [-10, 10, 20]].map(|unit| unit.map(two_to)) {
            let other = Draft::from(&scene).in_units(Units { length, depth, force }).scene().expect("the same scene");
            let others = found(&other);
            expected.iter().zip(&others).for_each(|(expected, other)| assert_eq!(other, expected, "{name}"));
            assert_eq!(others.len(), expected.len(), "{name}");
            compared += others.len();
        }
    }
    assert!(10_000 < compared, "{compared} faults");
}

#[test]
fn answers_of_other_scenes_are_refused_or_the_same_and_bounded_truthfully() {
    let scenes = report();
    for method in Method::ALL {
        let states: Vec<_> =
            scenes.iter().map(|(_, scene)| run(scene, method, Solver::ActiveSet, INTERVALS).state).collect();
        for ((name, scene), sound) in scenes.iter().zip(&states) {
            let truth = Truth::of(scene).expect("theory has an answer");
            for ((other, _), state) in scenes.iter().zip(&states) {
                let what = format!("{name}, {method}: the answer of {other}");
                assert!(passes_only_near(&what, &truth, sound, state) || other != name, "{what}: its own answer");
                bounded_truthfully(&what, &truth, state);
            }
            let finer = every_second(&run(scene, method, Solver::ActiveSet, 2 * INTERVALS).state);
            let what = format!("{name}, {method}: every second node of a finer grid");
            assert!(!passes_only_near(&what, &truth, sound, &finer), "{what}");
            bounded_truthfully(&what, &truth, &finer);
        }
    }
}

#[test]
fn stale_answers_are_refused_by_every_route() {
    /// A change of ground or load by this share is seen on the example, whoever solved it.
    const SEEN: f64 = 1e-6;
    let scene = example();
    let truth = Truth::of(&scene).expect("theory has an answer");
    for share in [SEEN, 1e-3] {
        for other in [scaled_ground(&scene, share), scaled_load(&scene, share), scaled_ground(&scene, -share)] {
            let other = other.expect("the scene is well posed");
            for (method, solver) in Method::ALL.into_iter().flat_map(|m| Solver::ALL.map(|s| (m, s))) {
                let stale = run(&other, method, solver, INTERVALS).state;
                let what = format!("{method}, {solver}: stale by {share:e}");
                assert!(!passes(&scene, &stale), "{what} goes unnoticed");
                assert!(bounded_truthfully(&what, &truth, &stale), "{what}: there is a bound");
            }
        }
    }
}
