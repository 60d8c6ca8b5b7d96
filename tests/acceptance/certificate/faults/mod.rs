//! The judge is judged: faults in the answers of every route are refused by the check of the discrete problem or harmless,
//! and whatever is guaranteed about an answer, however wrong, is true.

mod exact;
mod foreign;
mod held;
mod nodal;

use palkki::certificate::CERTIFIED_RESIDUAL;
use palkki::route::{Method, Solver};
use palkki::scene::Scene;
use palkki::state::ContactState;
use palkki_evidence::faults::{Distance, Truth};

use super::passes;
use crate::scenes::run;

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

fn load(scene: &Scene) -> f64 {
    scene.load().magnitude(scene.beam().length())
}

/// How far `state` is from the solution `sound`.
fn distance(scene: &Scene, sound: &ContactState, state: &ContactState) -> Distance {
    Distance::between(sound, state, scene.beam().length(), load(scene))
}

/// What passes is near the solution; true if it passes.
#[track_caller]
fn passes_only_near(what: &str, truth: &Truth<'_>, sound: &ContactState, state: &ContactState) -> bool {
    let passed = passes(truth.scene, state);
    if passed {
        let distance = distance(truth.scene, sound, state);
        assert!(is_near(truth, &distance), "{what} passes, and is off by {distance:?}");
    }
    passed
}

fn is_near(truth: &Truth<'_>, distance: &Distance) -> bool {
    distance.shape() <= NEAR && distance.force <= unseen_force(truth.scene, truth.deflection, load(truth.scene))
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

/// The states of all solvers, and that of the active set, which is the solution.
fn states(scene: &Scene, method: Method) -> (ContactState, Vec<(Solver, ContactState)>) {
    let states: Vec<_> = Solver::ALL.map(|solver| (solver, run(scene, method, solver, INTERVALS).state)).into();
    (run(scene, method, Solver::ActiveSet, INTERVALS).state, states)
}
