//! What is measured: every route over grids and tolerances.

use palkki::methods::Method;
use palkki::solvers::Solver;

/// Seconds after which a series is not continued on finer grids.
pub(crate) const LIMIT: f64 = 3.0;

/// Scenes: the paper's example and an uneven foundation.
pub(crate) const SCENES: [&str; 2] = ["heinisuo-1984", "wave"];

/// Tolerances that iterative solvers are asked for.
const TOLERANCES: [f64; 6] = [1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-13];

/// How an answer is found.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Route {
    /// Beam theory with free lift-off points; no grid.
    Exact,
    /// A method with a solver.
    Solver(Method, Solver),
    /// The contact set of a library on the force method, solved by the three-moment equations.
    Repair(Solver),
}

/// One thing to measure.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Job {
    pub(crate) route: Route,
    /// Intervals; 0 for beam theory.
    pub(crate) intervals: usize,
    /// What an iterative solver is asked for; 0 for the others.
    pub(crate) tolerance: f64,
}

impl Job {
    /// `method/solver` as the file has it.
    pub(crate) fn route_word(&self) -> String {
        match self.route {
            Route::Exact => "exact/free-boundary".to_owned(),
            Route::Solver(method, solver) => format!("{method}/{solver}"),
            Route::Repair(solver) => format!("repair/{solver}"),
        }
    }

    /// What identifies the line of the file.
    pub(crate) fn key(&self, scene: &str) -> String {
        format!("{scene},{},{},{:e}", self.route_word(), self.intervals, self.tolerance)
    }

    /// For a person who waits.
    pub(crate) fn describe(&self) -> String {
        format!("{} on {} intervals, asked for {:e}", self.route_word(), self.intervals, self.tolerance)
    }

    /// Whether the other job is the same on another grid.
    pub(crate) fn same_series(&self, other: &Self) -> bool {
        self.route == other.route && self.tolerance.total_cmp(&other.tolerance).is_eq()
    }
}

/// All jobs of all scenes; a series runs from coarse to fine grids.
pub(crate) fn all() -> Vec<(&'static str, Vec<Job>)> {
    SCENES.iter().map(|&scene| (scene, jobs())).collect()
}

fn jobs() -> Vec<Job> {
    let mut jobs = vec![Job { route: Route::Exact, intervals: 0, tolerance: 0.0 }];
    let mut series = |route, tolerance, grids: &[usize]| {
        jobs.extend(grids.iter().map(|&intervals| Job { route, intervals, tolerance }));
    };
    let fine = [10, 30, 100, 300, 1000, 3000, 10_000, 30_000, 100_000, 300_000, 1_000_000];
    for method in Method::ALL {
        series(Route::Solver(method, Solver::ActiveSet), 0.0, &fine);
        series(Route::Solver(method, Solver::FourStep), 0.0, &fine[..7]);
        for solver in [Solver::Nsor, Solver::Clarabel, Solver::Osqp] {
            for tolerance in TOLERANCES {
                series(Route::Solver(method, solver), tolerance, &fine[..if solver == Solver::Nsor { 4 } else { 8 }]);
            }
        }
    }
    for solver in [Solver::Clarabel, Solver::Osqp] {
        for tolerance in [1e-4, 1e-8] {
            series(Route::Repair(solver), tolerance, &fine[..8]);
        }
    }
    jobs
}
