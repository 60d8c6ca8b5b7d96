//! The paper's advice, and what was measured of it.

use minijinja::context;
use palkki::scene::SceneError;
use palkki_evidence::paper::claims::accuracy::{Errors, errors};
use palkki_evidence::paper::claims::four_step::{Count, SCENES};

use super::claims::thousands;
use crate::report::error::Cause;
use crate::report::evidence::Evidence;
use crate::report::study::Study;

/// Every grid of the example between these numbers of intervals is looked at.
const COARSEST: usize = 12;
const FINEST: usize = 200;

/// What an engineer calls usable without asking.
const USABLE: f64 = 0.01;

pub(super) fn evidence(study: &Study<'_>) -> Result<Evidence, Cause> {
    let ledger = study.ledger()?;
    let [paper, coarse, _] = &ledger.usable.grids;
    let solved = |count: &Count| count.uneven.iter().sum::<usize>();
    let grid = |grid: &Errors| context! { intervals => grid.intervals, worst => grid.worst(), first_force => grid.first_force };
    let four_steps = || ledger.four_step.counts.iter().map(solved);
    let sweeps = || ledger.nsor.counts.iter().map(|count| thousands(count.on_the_paper_grid()));
    Ok(Evidence::new(context! {
        usable => USABLE,
        coarsest => COARSEST,
        finest => FINEST,
        // From this many intervals on, end reaction, largest moment and deflection are usable on every grid looked at.
        safe => safe()?,
        paper => grid(paper),
        coarse => grid(coarse),
        uneven_scenes => 2 * SCENES,
        four_steps_fewest => four_steps().min(),
        four_steps_most => four_steps().max(),
        sweeps_fewest => sweeps().fold(f64::INFINITY, f64::min),
        sweeps_most => sweeps().fold(0.0, f64::max),
    }))
}

/// One more than the finest grid that is not usable.
fn safe() -> Result<usize, SceneError> {
    for intervals in (COARSEST..=FINEST).rev() {
        if USABLE < errors(intervals)?.worst() {
            return Ok(intervals + 1);
        }
    }
    Ok(COARSEST)
}
