//! "In the example computed here it turned out that the optimum was found directly by this algorithm", the four steps.

use super::{Claim, Verdict};
use crate::paper::uneven::{Unevenness, scenes};
use crate::paper::{INTERVALS, example};
use palkki::methods::Method;
use palkki::scene::{Scene, SceneError};
use palkki::solvers::Solver;
use palkki::{Settings, solve_raw};
use serde_json::json;

/// Grids of the example: 4 to this many intervals.
pub const FINEST: usize = 200;
/// How many these are.
pub const GRIDS: usize = FINEST - 3;
/// Random foundations of each kind.
pub const SCENES: usize = 150;
/// Seed of the random foundations.
pub const SEED: u64 = 4;

/// How often the four steps end at the optimum, for one method.
#[derive(Debug, Clone, PartialEq)]
pub struct Count {
    /// Which method.
    pub method: Method,
    /// Whether they do on the example with 30 intervals.
    pub on_the_example: bool,
    /// On how many of the grids of the example.
    pub grids: usize,
    /// Number of intervals of each grid of the example, and whether they do on it.
    pub by_grid: Vec<(usize, bool)>,
    /// The smallest number of intervals on which they do not.
    pub first_failure: Option<usize>,
    /// On how many of the random foundations of each kind, 30 intervals.
    pub uneven: [usize; 2],
    /// End points that are not feasible, on all of these.
    pub infeasible: usize,
}

/// Runs the four steps on every grid and every foundation.
pub(super) fn measure() -> Result<Vec<Count>, SceneError> {
    let example = example()?;
    let uneven = [scenes(Unevenness::Wave, SCENES, SEED)?, scenes(Unevenness::Rough, SCENES, SEED)?];
    let mut counts = Vec::new();
    for method in Method::ALL {
        let mut infeasible = 0;
        let mut optimal = |scene: &Scene, intervals: usize| -> Result<bool, SceneError> {
            let raw = solve_raw(scene, &Settings::new(method, Solver::FourStep, intervals))?;
            let nodes = raw.state.nodes.unwrap_or_default();
            // Step 2° looks at the unknown alone: the clearance, or the contact force.
            let unknown = if method == Method::Force { &nodes.contact_force } else { &nodes.clearance };
            infeasible += usize::from(!unknown.iter().all(|x| -1e-9 <= *x));
            Ok(raw.solved)
        };
        let on_the_example = optimal(&example, INTERVALS)?;
        let grids: Vec<(usize, bool)> =
            (4..=FINEST).map(|n| Ok((n, optimal(&example, n)?))).collect::<Result<_, SceneError>>()?;
        let mut count_uneven = [0; 2];
        for (count, scenes) in count_uneven.iter_mut().zip(&uneven) {
            for scene in scenes {
                *count += usize::from(optimal(scene, INTERVALS)?);
            }
        }
        counts.push(Count {
            method,
            on_the_example,
            grids: grids.iter().filter(|(_, optimal)| *optimal).count(),
            first_failure: grids.iter().find(|(_, optimal)| !optimal).map(|(n, _)| *n),
            by_grid: grids,
            uneven: count_uneven,
            infeasible,
        });
    }
    Ok(counts)
}

/// That the optimum is found directly, which the paper says of its example; and that the end point is on the edge of the feasible set,
/// which follows from step 2° wherever the algorithm ends.
pub(super) fn claims(counts: &[Count]) -> [Claim; 2] {
    for count in counts {
        assert!(count.uneven.iter().any(|optimal| *optimal < SCENES), "{count:?}");
        // The paper's own method fails on finer grids of the paper's own example.
        let fails = count.grids < GRIDS && count.first_failure.is_some_and(|n| INTERVALS < n);
        assert!(fails || count.method != Method::Displacement, "{count:?}");
    }
    let direct = Verdict::of(counts.iter().all(|c| c.on_the_example));
    let line = |c: &Count| {
        json!({
            "method": c.method.to_string(), "grids": c.grids, "first_failure": c.first_failure,
            "waves": c.uneven[0], "polylines": c.uneven[1],
        })
    };
    let numbers = json!({
        "finest": FINEST, "grids": GRIDS, "scenes": SCENES, "uneven": 2 * SCENES,
        "counts": counts.iter().map(line).collect::<Vec<_>>(),
        "fewest_grids": counts.iter().map(|c| c.grids).min(),
        "fewest_uneven": counts.iter().map(|c| c.uneven.iter().sum::<usize>()).min(),
    });
    let runs = counts.len() * (1 + GRIDS + 2 * SCENES);
    let infeasible: usize = counts.iter().map(|c| c.infeasible).sum();
    let edge = json!({ "runs": runs, "feasible": runs - infeasible });
    [
        Claim { name: "four_steps_find_the_optimum", verdict: direct, numbers },
        Claim { name: "four_steps_reach_the_edge", verdict: Verdict::of(infeasible == 0), numbers: edge },
    ]
}
