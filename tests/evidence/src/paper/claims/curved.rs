//! "A curved beam (a ski) on a straight base is almost the same problem."

use palkki::methods::Method;
use palkki::scene::{Foundation, Load, Scene, SceneError, Support};
use palkki::solvers::Solver;
use palkki::{Settings, solve_raw, theory};
use serde_json::json;

use super::{Claim, Verdict};
use crate::compare::apart_if_any;
use crate::paper::{DEPTH, INTERVALS, LENGTH, UNIFORM, beam};

/// Beam and load of the example on other supports, with a shape of its own, over another foundation.
pub(super) fn scene_on(
    supports: Vec<Support>,
    shape: Option<Foundation>,
    foundation: Foundation,
) -> Result<Scene, SceneError> {
    let beam = beam()?.with_supports(supports)?;
    let beam = match shape {
        Some(shape) => beam.with_shape(shape)?,
        None => beam,
    };
    Scene::new(beam.clone(), Load::uniform_on(&beam, UNIFORM)?, Some(foundation))
}

/// Camber of the curved beam at mid-span, upwards: `w₀ = −4 CAMBER x (l − x)/l²`.
const CAMBER: f64 = 0.75;

/// A curved beam over flat ground beside a straight beam over ground that is curved the other way, on two simple supports and
/// without supports, exactly and by the three methods. Only the gap `u − w₀` enters.
pub(super) fn curved_beam() -> Result<Claim, SceneError> {
    // Rounding of the exact solution and of the methods.
    const ROUNDING: f64 = 1e-12;
    let rise = 4.0 * CAMBER / LENGTH;
    let shape = || Foundation::Polynomial { coefficients: vec![0.0, -rise, rise / LENGTH] };
    let hollow = || Foundation::Polynomial { coefficients: vec![DEPTH, rise, -rise / LENGTH] };
    let (mut exact, mut nodal, mut contact_force) = (0.0_f64, 0.0_f64, f64::NAN);
    for supports in [vec![], vec![Support::simple(0.0), Support::simple(LENGTH)]] {
        let curved = scene_on(supports.clone(), Some(shape()), Foundation::Flat { depth: DEPTH })?;
        let straight = scene_on(supports, None, hollow())?;
        exact = exact.max(apart_if_any(&numbers(&curved), &numbers(&straight)));
        for method in Method::ALL {
            let settings = Settings::new(method, Solver::ActiveSet, INTERVALS);
            let [curved, straight] = [solve_raw(&curved, &settings)?, solve_raw(&straight, &settings)?];
            contact_force = curved.state.contact_force();
            let [a, b] = [curved, straight].map(|answer| answer.state.nodes.unwrap_or_default().contact_force);
            nodal = nodal.max(apart_if_any(&a, &b) / (UNIFORM * LENGTH));
        }
    }
    assert!(0.0 < contact_force, "the curved beam on its supports touches: {contact_force}");
    let verdict = Verdict::of(exact <= ROUNDING && nodal <= ROUNDING);
    let numbers = json!({
        "camber": CAMBER, "intervals": INTERVALS, "contact_force": contact_force,
        "exact": exact.max(f64::EPSILON), "nodal": nodal.max(f64::EPSILON),
    });
    Ok(Claim { name: "curved_beam", verdict, numbers })
}

/// Forces over the load and places over the length of the exact solution; none if it is not solved.
fn numbers(scene: &Scene) -> Vec<f64> {
    let Ok(exact) = theory::solve(scene) else { return Vec::new() };
    if !exact.solved {
        return Vec::new();
    }
    let load = UNIFORM * LENGTH;
    let supports = exact.state.supports.iter().map(|support| support.force / load);
    let contacts = exact.state.contacts.iter().flat_map(|c| {
        let [left, right] = c.end_forces.unwrap_or([c.force; 2]);
        [c.from / LENGTH, c.to / LENGTH, c.force / load, left / load, right / load]
    });
    supports.chain(contacts).collect()
}
