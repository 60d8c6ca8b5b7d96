//! The instances of `dense.csv`: dense contact, where exchanges of one variable of each run go round in circles or wander.

use palkki::problem::{NotPositiveDefinite, Programme};
use palkki::scene::Scene;

use super::instances::{End, exchanges};
use crate::theory::random;

/// One line: the force method on a [smooth](random::smooth) scene, the solves of the exchanges, and the length of the circle at their
/// end, 0 if that is the optimum.
#[derive(Debug)]
pub(crate) struct Dense {
    pub(crate) line: &'static str,
    pub(crate) intervals: usize,
    pub(crate) end: End,
    pub(crate) scene: Scene,
}

/// All of them; the error is the line that is none.
pub(crate) fn dense() -> Result<Vec<Dense>, &'static str> {
    include_str!("dense.csv").lines().skip(1).map(|line| instance(line).ok_or(line)).collect()
}

fn instance(line: &'static str) -> Option<Dense> {
    let fields: Vec<&str> = line.split(',').collect();
    let [intervals, segments, load, seed, solves, period] = fields[..] else { return None };
    let (solves, period) = (solves.parse().ok()?, period.parse().ok()?);
    Some(Dense {
        line,
        intervals: intervals.parse().ok()?,
        end: if period == 0 { End::Optimum { solves } } else { End::Circle { solves, period } },
        scene: random::smooth(segments.parse().ok()?, load.parse().ok()?, seed.parse().ok()?),
    })
}

/// Exchanges as the active set has them before windows: of each run of neighbours with a negative gradient the steepest one.
pub(crate) fn exchange_of_runs(programme: &dyn Programme) -> Result<End, NotPositiveDefinite> {
    exchanges(programme, |negative, gradient| {
        let runs = negative.chunk_by(|i, j| i + 1 == *j);
        runs.filter_map(|run| run.iter().copied().min_by(|&i, &j| gradient[i].total_cmp(&gradient[j]))).collect()
    })
}
