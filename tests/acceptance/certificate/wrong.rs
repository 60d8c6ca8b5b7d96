//! Wrong forces are bounded truthfully: perturbed, dropped, shifted, with the wrong sign, of another scene, of nobody. So is
//! everything with their places for a witness.

use palkki::certificate::{ContactLoad, Judged, certify};
use palkki::route::{Method, Solver};
use palkki::scene::{Beam, Foundation, Load, Scene};
use palkki::theory;

use super::{of_forces, places, true_error};
use crate::scenes::{nodes, report, run};

/// As in `uneven`.
const THEORY: f64 = 1e-11;

type Fault = (&'static str, fn(&mut Vec<f64>));

const FAULTS: [Fault; 9] = [
    ("a tenth more", |p| p.iter_mut().for_each(|p| *p *= 1.1)),
    ("every third one doubled", |p| p.iter_mut().step_by(3).for_each(|p| *p *= 2.0)),
    ("the largest one dropped", |p| {
        let most = p.iter().copied().fold(0.0, f64::max);
        p.iter_mut().filter(|p| most <= **p).for_each(|p| *p = 0.0);
    }),
    ("shifted by a node", |p| p.rotate_right(1)),
    ("shifted by five nodes", |p| p.rotate_left(5)),
    ("turned round", |p| p.reverse()),
    ("wrong sign", |p| p.iter_mut().for_each(|p| *p = -*p)),
    ("none", |p| p.iter_mut().for_each(|p| *p = 0.0)),
    ("the same everywhere", |p| p.iter_mut().for_each(|p| *p = 0.3)),
];

/// The judged deflection is still the one of the answer before the fault: what is bounded is any deflection whatsoever.
#[track_caller]
fn check(what: &str, scene: &Scene, forces: &[f64]) {
    let raw = run(scene, Method::Force, Solver::ActiveSet, forces.len() + 1);
    let nodes = nodes(&raw);
    let forces_at: Vec<(f64, f64)> = nodes.x.iter().copied().zip(forces.iter().copied()).collect();
    let witness = places(&forces_at);
    let truth = theory::solve(scene).expect("theory has an answer");
    let size = truth.state.deflection.magnitude();
    let certificate = certify(scene, Judged::Nodes(nodes), &witness).expect("the scene can be scaled");
    let error = true_error(scene, nodes, |x| truth.deflection(x));
    assert!(error <= certificate.deflection_error + THEORY * size, "{what}: {error} for {certificate:?}");
    let (energy, slack) = (truth.state.energy, THEORY * truth.state.energy.abs());
    assert!(certificate.energy_lower <= energy + slack, "{what}: {energy} for {certificate:?}");
    assert!(energy - slack <= certificate.energy_upper, "{what}: {energy} for {certificate:?}");
    assert!(certificate.gap.is_finite(), "{what}: there is always a bound, {certificate:?}");

    // The deflection that the wrong forces cause is off by at least what the force at the middle node would tell.
    let moved = caused_at_nodes(scene, nodes.x.len() + 1, forces);
    let off = nodes.x.iter().zip(&moved).map(|(x, v)| (v - truth.deflection(*x)).abs()).fold(0.0, f64::max);
    for witness in [&witness, &truth.state.contacts] {
        let caused = of_forces(scene, &forces_at, witness);
        assert!(off <= caused.deflection_error + THEORY * size.max(off), "{what}: {off} for {caused:?}");
    }
}

/// Deflections at the nodes under the true load and the forces that press, from the flexibility (26) and the beam's own
/// deflection without contact.
fn caused_at_nodes(scene: &Scene, intervals: usize, forces: &[f64]) -> Vec<f64> {
    let (l, ei) = (scene.beam().length(), scene.beam().bending_stiffness());
    let bare = Scene::new(scene.beam().clone(), scene.load().clone(), None).expect("a beam without a foundation");
    let free = theory::solve(&bare).expect("a free beam");
    let n = forces.len();
    (1..intervals)
        .map(|i| {
            #[expect(clippy::cast_precision_loss, reason = "few nodes")]
            let x = l * i as f64 / intervals as f64;
            let lifted: f64 = forces
                .iter()
                .enumerate()
                .map(|(k, p)| p.max(0.0) * palkki::methods::flexibility(l, ei, n, i, k + 1))
                .sum();
            free.deflection(x) - lifted
        })
        .collect()
}

#[test]
fn faults_in_forces_are_bounded() {
    for (name, scene) in report() {
        for intervals in [20, 75] {
            let raw = run(&scene, Method::Force, Solver::ActiveSet, intervals);
            for (what, fault) in FAULTS {
                let mut forces = nodes(&raw).contact_force.clone();
                fault(&mut forces);
                check(&format!("{name}, {intervals} intervals, {what}"), &scene, &forces);
            }
        }
    }
}

#[test]
fn forces_of_another_scene_are_bounded() {
    let scenes = report();
    for (name, scene) in &scenes {
        for (other, foreign) in &scenes {
            let raw = run(foreign, Method::Displacement, Solver::ActiveSet, 40);
            check(&format!("{name} with the forces of {other}"), scene, &nodes(&raw).contact_force);
        }
    }
}

#[test]
fn numbers_that_are_none_are_refused() {
    for force in [f64::NAN, f64::INFINITY] {
        assert!(ContactLoad::new(10.0, [(1.0, 1.0), (2.0, force)]).is_err(), "a force of {force}");
        assert!(ContactLoad::new(10.0, [(force, 1.0)]).is_err(), "a force at {force}");
    }
    assert!(ContactLoad::new(10.0, [(10.1, 1.0)]).is_err(), "a force beside the beam");
}

/// A force that throws the beam beyond all numbers, from a pattern of which nothing follows: no admissible deflection is found,
/// and nothing is bounded by its distance from one.
#[test]
fn where_no_admissible_deflection_is_found_nothing_is_bounded() {
    let beam = Beam::new(1.0, 1e-300).expect("positive");
    let load = Load::uniform_on(&beam, 1e-100).expect("finite");
    let slope = Foundation::Polynomial { coefficients: vec![1.0, 1.0] };
    let scene = Scene::new(beam, load, Some(slope)).expect("well posed");
    let forces = [(0.3, 1e-100), (0.5, 1e-100), (0.7, 1e300)];
    let certificate = of_forces(&scene, &forces, &places(&forces));
    let bounds = [certificate.gap, certificate.deflection_error, certificate.best_deflection_error];
    assert!(bounds.iter().all(|bound| bound.is_infinite()), "{certificate:?}");
    assert!(certificate.energy_upper.is_infinite() && certificate.energy_lower.is_infinite(), "{certificate:?}");
    assert!(!certificate.contacts_proven && certificate.reactions == [None, None], "{certificate:?}");
}
