//! "In the example computed here it turned out that the optimum was found directly by this algorithm", the four steps.

use super::{Claim, Verdict};
use crate::paper::uneven::{Unevenness, scenes};
use crate::paper::{INTERVALS, example};
use palkki::methods::Method;
use palkki::scene::{Scene, SceneError};
use palkki::solvers::Solver;
use palkki::{Settings, solve_raw};

/// Grids of the example: 4 to this many intervals.
pub const FINEST: usize = 200;
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

/// What was measured, by method.
#[derive(Debug, Clone, PartialEq)]
pub struct Evidence {
    /// One count for each method.
    pub counts: Vec<Count>,
    /// Grids of the example that were tried.
    pub grids: usize,
}

/// Runs the four steps on every grid and every foundation.
///
/// # Errors
///
/// None for these scenes; the type is that of [`solve_raw`].
pub fn measure() -> Result<Evidence, SceneError> {
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
    Ok(Evidence { counts, grids: FINEST - 3 })
}

impl Evidence {
    /// Confirmed for the example, refuted as an algorithm.
    #[must_use]
    pub fn verdict(&self) -> Verdict {
        let example = self.counts.iter().all(|c| c.on_the_example);
        let always = self.counts.iter().all(|c| c.grids == self.grids && c.uneven == [SCENES; 2]);
        match (example, always) {
            (true, true) => Verdict::Confirmed,
            (true, false) => Verdict::Qualified,
            _ => Verdict::Refuted,
        }
    }

    /// Whether the end point is always on the edge of the feasible set.
    #[must_use]
    pub fn edge_verdict(&self) -> Verdict {
        if self.counts.iter().all(|c| c.infeasible == 0) { Verdict::Confirmed } else { Verdict::Refuted }
    }

    pub(super) fn claims(&self) -> [Claim; 2] {
        let lines: Vec<String> = self
            .counts
            .iter()
            .map(|c| {
                format!(
                    "by the {} method {} of {} grids ({}), {} of {SCENES} waves and {} of {SCENES} polylines",
                    c.method,
                    c.grids,
                    self.grids,
                    c.first_failure.map_or("all of them".to_owned(), |n| format!("it fails first on {n} intervals")),
                    c.uneven[0],
                    c.uneven[1],
                )
            })
            .collect();
        let fewest = |of: &dyn Fn(&Count) -> usize| self.counts.iter().map(of).min().unwrap_or(0);
        let direct = Claim {
            name: "four_steps_find_the_optimum",
            statement: "In the example, the optimum was found directly by the four steps.",
            verdict: self.verdict(),
            reading: None,
            summary: format!(
                "true on 30 intervals; by the weakest method on {} of {} grids of the example and {} of {} uneven foundations",
                fewest(&|c| c.grids),
                self.grids,
                fewest(&|c| c.uneven.iter().sum()),
                2 * SCENES,
            ),
            evidence: format!(
                "It is true for the example on 30 intervals by every method. It is no property of the algorithm: of the grids of the \
                 example with 4 to {FINEST} intervals, and of {} random uneven foundations on 30 intervals, half of them cosine waves \
                 and half of them polylines, it ends at the optimum on the following: {}. \
                 Elsewhere it stops at a point where a variable that was set to zero has a negative gradient.",
                2 * SCENES,
                lines.join("; "),
            ),
        };
        let runs = self.counts.len() * (1 + self.grids + 2 * SCENES);
        let infeasible: usize = self.counts.iter().map(|c| c.infeasible).sum();
        let edge = Claim {
            name: "four_steps_reach_the_edge",
            statement: "The first three steps lead to the edge of the feasible set, from where another algorithm can continue.",
            verdict: self.edge_verdict(),
            reading: None,
            summary: format!("{} of {runs} runs end with x ≥ 0", runs - infeasible),
            evidence: format!(
                "Of {runs} runs, {} end with x ≥ 0 up to rounding. The solver `active-set` continues from there; it may also release \
                 variables that were set to zero.",
                runs - infeasible,
            ),
        };
        [direct, edge]
    }
}
