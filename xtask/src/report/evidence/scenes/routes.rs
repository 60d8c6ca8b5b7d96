//! Which discrete routes the judge certifies on a scene.

use palkki::route::{Method, Solver, Status};
use palkki::scene::Scene;
use palkki::{Settings, solve};
use serde::Serialize;

use crate::report::error::Cause;

/// The paper's grid, on which every solver has a chance.
pub(super) const INTERVALS: usize = palkki::paper::INTERVALS;

/// Certified routes of one scene.
#[derive(Debug, Serialize)]
pub(super) struct Routes {
    pub(super) certified: usize,
    pub(super) of: usize,
    pub(super) four_step: usize,
    pub(super) four_step_of: usize,
    /// Routes meant to reach the optimum that the judge does not certify, and whether they claim success.
    failed: Vec<String>,
}

/// Runs every method with every solver.
pub(super) fn judged(scene: &Scene) -> Result<Routes, Cause> {
    let (mut routes, mut failed) = ([0; 4], Vec::new());
    for method in Method::ALL {
        for solver in Solver::ALL {
            let outcome = solve(scene, &Settings::new(method, solver, INTERVALS))?;
            let passes = outcome.status == Status::Certified;
            let optimal = Solver::OPTIMAL.contains(&solver);
            let first = if optimal { 0 } else { 2 };
            routes[first] += usize::from(passes);
            routes[first + 1] += 1;
            if optimal && !passes {
                let word = if outcome.solver_claims_success { "success" } else { "failure" };
                failed.push(format!("{solver} on the {method} method (it reports {word})"));
            }
        }
    }
    let [certified, of, four_step, four_step_of] = routes;
    Ok(Routes { certified, of, four_step, four_step_of, failed })
}
