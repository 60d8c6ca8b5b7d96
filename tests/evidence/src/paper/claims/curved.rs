//! "A curved beam (a ski) on a straight base is almost the same problem."

use palkki::methods::Method;
use palkki::scene::{Foundation, Load, Scene, SceneError, Support};
use palkki::solvers::Solver;
use palkki::{Settings, solve_raw, theory};

use super::{Claim, Verdict, bound};
use crate::compare::apart_if_any;
use crate::paper::{DEPTH, INTERVALS, LENGTH, UNIFORM, beam};

/// Beam and load of the example on other supports, with a shape of its own, over another foundation.
pub(in crate::paper) fn scene_on(
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

/// A curved beam over flat ground beside a straight beam over ground that is curved the other way. Only the gap `u − w₀` enters.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Curved {
    /// Largest difference of the forces and places of the exact solutions, over the load and the length.
    pub exact: f64,
    /// Largest difference of a nodal contact force of the three methods, over the load.
    pub nodal: f64,
    /// Contact force of the curved beam with supports, on the grid of the last method.
    pub contact_force: f64,
}

/// Camber of the curved beam at mid-span, upwards: `w₀ = −4 CAMBER x (l − x)/l²`.
const CAMBER: f64 = 0.75;

/// Solves both beams, on two simple supports and without supports, exactly and by the three methods.
///
/// # Errors
///
/// None; the type is that of [`solve_raw`].
pub fn curved_beam() -> Result<Curved, SceneError> {
    let rise = 4.0 * CAMBER / LENGTH;
    let shape = || Foundation::Polynomial { coefficients: vec![0.0, -rise, rise / LENGTH] };
    let hollow = || Foundation::Polynomial { coefficients: vec![DEPTH, rise, -rise / LENGTH] };
    let mut found = Curved { exact: 0.0, nodal: 0.0, contact_force: f64::NAN };
    for supports in [vec![], vec![Support::simple(0.0), Support::simple(LENGTH)]] {
        let curved = scene_on(supports.clone(), Some(shape()), Foundation::Flat { depth: DEPTH })?;
        let straight = scene_on(supports, None, hollow())?;
        found.exact = found.exact.max(apart_if_any(&numbers(&curved), &numbers(&straight)));
        for method in Method::ALL {
            let settings = Settings::new(method, Solver::ActiveSet, INTERVALS);
            let [curved, straight] = [solve_raw(&curved, &settings)?, solve_raw(&straight, &settings)?];
            found.contact_force = curved.state.contact_force();
            let [a, b] = [curved, straight].map(|answer| answer.state.nodes.unwrap_or_default().contact_force);
            found.nodal = found.nodal.max(apart_if_any(&a, &b) / (UNIFORM * LENGTH));
        }
    }
    Ok(found)
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

impl Curved {
    /// Rounding of the exact solution and of the methods.
    const ROUNDING: f64 = 1e-12;

    /// Confirmed if forces and places are the same up to rounding.
    #[must_use]
    pub fn verdict(&self) -> Verdict {
        if self.exact <= Self::ROUNDING && self.nodal <= Self::ROUNDING { Verdict::Confirmed } else { Verdict::Refuted }
    }

    pub(super) fn claim(&self) -> Claim {
        let [exact, nodal] = [self.exact, self.nodal].map(|value| bound(value.max(f64::EPSILON)));
        Claim {
            name: "curved_beam",
            statement: "A curved beam (a ski) on a straight base is almost the same problem.",
            verdict: self.verdict(),
            reading: None,
            summary: format!("contact forces differ by less than {exact} of the load: only u − w₀ enters"),
            evidence: format!(
                "It is the same problem, since only u − w₀ enters, w₀ being the unloaded shape. A beam with a camber of {CAMBER} u₀ \
                 over flat ground and a straight beam over ground that is deeper by the camber, on two supports and without \
                 supports: forces and places of the exact solutions differ by less than {exact} of load and length, nodal forces of \
                 the three methods on {INTERVALS} intervals by less than {nodal} of the load (contact force {:.4} on two supports, on that grid).",
                self.contact_force
            ),
        }
    }
}
