//! The solvers with their settings, and the threshold of our check.

use palkki::DEFAULT_TOLERANCE;
use palkki::certificate::CERTIFIED_RESIDUAL;

use super::prelude::*;

pub(super) fn evidence(_: &Study<'_>) -> Result<Evidence, Cause> {
    let settings = Solver::ALL.map(|solver| row![solver, solver.settings(DEFAULT_TOLERANCE)]);
    Ok(Evidence::new(context! {
        settings => Table::new(["solver", "settings"]).rows(settings),
        threshold => tolerance(CERTIFIED_RESIDUAL),
        asked => tolerance(DEFAULT_TOLERANCE),
    }))
}
