//! What the paper recommends, what the measurements say, and for whom.

use palkki::paper::claims::four_step::SCENES;
use palkki::paper::claims::usable::{Errors, errors};
use palkki::scene::SceneError;
use serde::Serialize;

use super::claims::{thousands, worst};
use crate::report::error::Cause;
use crate::report::evidence::Evidence;
use crate::report::study::Study;

/// Every grid of the example between these numbers of intervals is looked at.
const COARSEST: usize = 12;
const FINEST: usize = 200;

/// What an engineer calls usable without asking.
const USABLE: f64 = 0.01;

#[derive(Debug, Serialize)]
struct Values {
    /// Per cent that count as usable.
    usable: f64,
    finest: usize,
    /// From this many intervals on, end reaction, largest moment and deflection are usable on every grid looked at.
    safe: usize,
    paper: Usable,
    coarse: Usable,
    four_step: FourStep,
    nsor: Nsor,
}

#[derive(Debug, Serialize)]
struct Usable {
    intervals: usize,
    worst: f64,
    first_force: f64,
    word: &'static str,
}

#[derive(Debug, Serialize)]
struct FourStep {
    scenes: usize,
    /// Method with the most uneven scenes solved, and how many.
    best: &'static str,
    best_solved: usize,
    worst_solved: usize,
}

#[derive(Debug, Serialize)]
struct Nsor {
    fewest_thousands: f64,
    most_thousands: f64,
    most_solves: usize,
    intervals: usize,
}

pub(super) fn evidence(study: &Study<'_>) -> Result<Evidence, Cause> {
    let ledger = study.ledger()?;
    let [paper, coarse, _] = &ledger.usable.grids;
    let solved = |c: &palkki::paper::claims::four_step::Count| c.uneven.iter().sum::<usize>();
    let counts = &ledger.four_step.counts;
    let best = counts.iter().max_by_key(|c| solved(c));
    let sweeps = |of: fn(f64, f64) -> f64, start: f64| {
        ledger.nsor.counts.iter().map(|c| thousands(c.on_the_paper_grid())).fold(start, of)
    };
    Ok(Evidence::new(Values {
        usable: USABLE,
        finest: FINEST,
        safe: safe()?,
        paper: usable(paper),
        coarse: usable(coarse),
        four_step: FourStep {
            scenes: 2 * SCENES,
            best: best.map_or("no", |c| c.method.word()),
            best_solved: best.map_or(0, solved),
            worst_solved: counts.iter().map(solved).min().unwrap_or(0),
        },
        nsor: Nsor {
            fewest_thousands: sweeps(f64::min, f64::INFINITY),
            most_thousands: sweeps(f64::max, 0.0),
            most_solves: ledger.nsor.counts.iter().map(|c| c.active_set_solves).max().unwrap_or(0),
            intervals: palkki::paper::INTERVALS,
        },
    }))
}

fn usable(grid: &Errors) -> Usable {
    let word = if worst(grid) <= USABLE { "is" } else { "is not" };
    Usable { intervals: grid.intervals, worst: worst(grid), first_force: grid.first_force, word }
}

/// One more than the finest grid that is not usable.
fn safe() -> Result<usize, SceneError> {
    for intervals in (COARSEST..=FINEST).rev() {
        if USABLE < worst(&errors(intervals)?) {
            return Ok(intervals + 1);
        }
    }
    Ok(COARSEST)
}
