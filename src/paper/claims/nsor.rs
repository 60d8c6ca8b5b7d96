//! "If the dimension n is large, a usable algorithm is the iterative NSOR algorithm."

use super::{Claim, Verdict};
use crate::methods::Method;
use crate::paper::{INTERVALS, example};
use crate::scene::SceneError;
use crate::solve::{Settings, solve};
use crate::solvers::Solver;
use crate::verification::observed_order;

/// Grids on which sweeps are counted.
pub const GRIDS: [usize; 5] = [10, 15, 20, 30, 40];

/// A fine grid.
pub const FINE: usize = 300;

/// Sweeps of NSOR for one method.
#[derive(Debug, Clone, PartialEq)]
pub struct Count {
    /// Which method.
    pub method: Method,
    /// Intervals and sweeps, all candidates for `ω` together.
    pub sweeps: Vec<(usize, usize)>,
    /// Whether NSOR converged on every grid.
    pub converged: bool,
    /// Exponent of the sweeps over the number of intervals.
    pub exponent: f64,
    /// Solves of the active set on the finest of the grids, for comparison.
    pub active_set_solves: usize,
    /// Whether NSOR converges on [`FINE`] intervals within its budget.
    pub converged_at_300: bool,
}

/// What was measured, by method.
#[derive(Debug, Clone, PartialEq)]
pub struct Evidence {
    /// One count for each method.
    pub counts: Vec<Count>,
}

/// Counts sweeps on the example.
///
/// # Errors
///
/// None for the example; the type is that of [`solve`].
#[expect(clippy::cast_precision_loss, reason = "counts of sweeps")]
pub fn measure() -> Result<Evidence, SceneError> {
    let scene = example()?;
    let run = |method, solver, intervals| solve(&scene, &Settings::new(method, solver, intervals));
    let mut counts = Vec::new();
    for method in Method::ALL {
        let (mut sweeps, mut converged) = (Vec::new(), true);
        for intervals in GRIDS {
            let outcome = run(method, Solver::Nsor, intervals)?;
            converged &= outcome.solver_claims_success;
            sweeps.push((intervals, outcome.iterations));
        }
        let pairs: Vec<(f64, f64)> = sweeps.iter().map(|&(n, s)| (n as f64, s as f64)).collect();
        counts.push(Count {
            method,
            sweeps,
            converged,
            exponent: observed_order(&pairs),
            active_set_solves: run(method, Solver::ActiveSet, GRIDS[GRIDS.len() - 1])?.iterations,
            converged_at_300: run(method, Solver::Nsor, FINE)?.solver_claims_success,
        });
    }
    Ok(Evidence { counts })
}

impl Count {
    /// Sweeps on the grid of the paper.
    #[must_use]
    pub fn on_the_paper_grid(&self) -> usize {
        self.sweeps.iter().find(|(n, _)| *n == INTERVALS).map_or(0, |(_, sweeps)| *sweeps)
    }
}

impl Evidence {
    /// Refuted if sweeps grow faster than `n`, so that a direct solve is cheaper at every size, and NSOR fails on a fine
    /// grid; qualified if only one of these holds.
    #[must_use]
    pub fn verdict(&self) -> Verdict {
        let grows = self.counts.iter().all(|c| 1.0 < c.exponent);
        let fails = self.counts.iter().any(|c| !c.converged_at_300);
        match (grows, fails) {
            (true, true) => Verdict::Refuted,
            (false, false) => Verdict::Confirmed,
            _ => Verdict::Qualified,
        }
    }

    #[expect(clippy::cast_precision_loss, reason = "counts of sweeps")]
    pub(super) fn claim(&self) -> Claim {
        let line = |c: &Count| {
            format!(
                "{}: {:.1} thousand sweeps on {INTERVALS} intervals, growing like n^{:.1}, {} on {FINE} intervals",
                c.method,
                1e-3 * c.on_the_paper_grid() as f64,
                c.exponent,
                if c.converged_at_300 { "converged" } else { "not converged within its budget" },
            )
        };
        let lines: Vec<String> = self.counts.iter().map(line).collect();
        Claim {
            name: "nsor_for_large_n",
            statement: "If n is large, NSOR is the usable algorithm.",
            verdict: self.verdict(),
            evidence: format!(
                "{}. A sweep costs n² multiplications for K and C. On {} intervals the active set needs {} solves, each O(n).",
                lines.join("; "),
                GRIDS[GRIDS.len() - 1],
                self.counts.iter().map(|c| c.active_set_solves.to_string()).collect::<Vec<_>>().join(", "),
            ),
        }
    }
}
