//! Many random uneven foundations: the active set always ends, at a state that the judge certifies.

use palkki::certificate::CERTIFIED_RESIDUAL;
use palkki::methods::Discrete;
use palkki::route::{Method, Solver};
use palkki::scene::Scene;
use palkki::state::Regime;
use palkki_evidence::faults::Truth;
use palkki_evidence::paper::uneven::{Unevenness, scenes};
use palkki_evidence::random::Random;

use super::some;
use crate::scenes::{nodes, run};

/// All the random scenes there are: waves, rough polylines, and both with all kinds of load.
fn all() -> Vec<Scene> {
    let mut all = Vec::new();
    for kind in Unevenness::ALL {
        all.extend(scenes(kind, 60, 11).expect("depths are positive"));
    }
    all.extend(some(60, 12).iter().map(super::scene));
    all
}

#[test]
fn the_active_set_is_certified_on_every_uneven_scene() {
    let mut random = Random::new(13);
    let mut failures = Vec::new();
    let mut touched = 0;
    for (k, scene) in all().iter().enumerate() {
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "between 10 and 501")]
        let intervals = random.between(11.0, 501.0) as usize;
        for method in Method::ALL {
            let raw = run(scene, method, Solver::ActiveSet, intervals);
            touched += usize::from(raw.state.regime != Regime::None);
            if !raw.solved || !raw.run.reports_success || 5000 < raw.run.iterations {
                failures.push(format!(
                    "scene {k}, {method}, {intervals} intervals: {}, residual {:.1e}, {}",
                    raw.ended(),
                    raw.residual,
                    raw.run.message
                ));
            }
        }
    }
    assert!(failures.is_empty(), "{} failures:\n{}", failures.len(), failures.join("\n"));
    assert!(500 < touched, "the scenes have contacts, {touched} of 540 do");
}

/// Wherever the four steps stop, no variable is negative and the free ones have no gradient: on the edge, and stationary there. They
/// claim success everywhere, and are believed where the point is the optimum. What is guaranteed of their answers is true either way.
#[test]
fn four_steps_end_at_stationary_points_of_a_face_and_are_not_believed() {
    /// One scene in so many is compared with beam theory, which takes longer than the four steps.
    const COMPARED: usize = 4;
    let mut refused = 0;
    for (k, scene) in all().iter().enumerate() {
        let truth = k.is_multiple_of(COMPARED).then(|| Truth::of(scene).expect("theory has an answer"));
        let scaled = scene.scaled().expect("numbers in range");
        let discrete = Discrete::new(&scaled.scene, 30).expect("enough intervals");
        for method in Method::ALL {
            let qp = method.qp(&discrete);
            let sizes = qp.sizes();
            let answer = Solver::FourStep.run(qp.as_ref(), 0.0);
            assert!(answer.run.reports_success, "{method}: {}", answer.run.message);
            let raw = run(scene, method, Solver::FourStep, 30);
            assert!(raw.run.reports_success && raw.solved == (raw.residual <= CERTIFIED_RESIDUAL), "{method}");
            refused += usize::from(!raw.solved);
            if let Some(truth) = truth.as_ref().filter(|truth| truth.solved) {
                let judged = truth.nodes(nodes(&raw)).expect("numbers");
                assert!(judged.false_bounds.is_empty(), "scene {k}, {method}: {judged:?}");
            }
            // Anew, from x alone.
            let gradient = qp.gradient(&answer.x);
            for (x, g) in answer.x.iter().zip(gradient) {
                assert!(0.0 <= *x, "{method}: x = {x:e}");
                assert!(*x <= 0.0 || g.abs() <= STATIONARY * sizes.gradient, "{method}: x = {x:e}, g = {g:e}");
            }
        }
    }
    assert!(0 < refused, "on some uneven scene the four steps must fail, or the claim about them is wrong");
}

/// The gradient is computed again from clearances that have been rounded: `A` multiplies that by up to `10⁶` of its sizes.
const STATIONARY: f64 = 1e-8;

#[test]
fn energy_methods_have_the_same_contacts() {
    for scene in all().iter().take(90) {
        let [a, b] = [Method::Displacement, Method::Force].map(|method| run(scene, method, Solver::ActiveSet, 30));
        let touches = |raw| nodes(raw).contact_force.iter().map(|p: &f64| 0.0 < *p).collect::<Vec<_>>();
        assert_eq!(touches(&a), touches(&b), "nodes in contact");
    }
}
