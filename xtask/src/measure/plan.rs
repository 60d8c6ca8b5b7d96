//! What is measured: every route over grids and tolerances.

use palkki::methods::Method;
use palkki::solvers::Solver;

use super::line::Line;
use crate::data::Row;

/// Seconds after which a series is not continued on finer grids.
pub(crate) const LIMIT: f64 = 3.0;

/// The scene of the requirements: the paper's example, with all tolerances and the finest grids.
pub(crate) const EXAMPLE: &str = "heinisuo-1984";

/// Others, on which the trade is another one: contact at single points, kinks between the nodes, a beam bent over a hump.
pub(crate) const OTHERS: [&str; 3] = ["wave", "survey", "hump"];

/// Tolerances that iterative solvers are asked for, on the example and on the others.
const TOLERANCES: [f64; 6] = [1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-13];
const FEWER: [f64; 3] = [1e-4, 1e-7, 1e-10];

/// Errors that are demanded of the adaptive grid.
const DEMANDED: [f64; 4] = [1e-2, 1e-3, 1e-4, 1e-6];

/// Intervals of the grids, up to the finest of each series.
pub(crate) const GRIDS: [usize; 11] = [10, 30, 100, 300, 1000, 3000, 10_000, 30_000, 100_000, 300_000, 1_000_000];

/// How an answer is found.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Route {
    /// Beam theory with free lift-off points; no grid.
    Exact,
    /// The proven optimum of the discrete problem of a method, in integers of hundreds of bits.
    Optimum(Method),
    /// A method with a solver.
    Solver(Method, Solver),
    /// A method with a solver on the grid that the demanded error takes.
    Adaptive(Method, Solver),
}

/// One thing to measure.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Job {
    pub(crate) route: Route,
    /// Intervals; 0 for beam theory and for the adaptive grid.
    pub(crate) intervals: usize,
    /// What an iterative solver is asked for, or the error that is demanded of the adaptive grid; 0 for the others.
    pub(crate) tolerance: f64,
}

impl Route {
    /// `method/solver` as the files have it.
    pub(crate) fn name(self) -> String {
        match self {
            Self::Exact => "exact/free-boundary".to_owned(),
            Self::Optimum(method) => format!("{method}/optimum"),
            Self::Solver(method, solver) => format!("{method}/{solver}"),
            Self::Adaptive(method, solver) => format!("{method}/{solver}-adaptive"),
        }
    }
}

impl Job {
    /// What identifies the line of the file.
    pub(crate) fn name(&self, scene: &str) -> String {
        Line::of(scene, *self).name()
    }

    /// Whether the other job is the same on another grid.
    pub(crate) fn same_series(&self, other: &Self) -> bool {
        self.route == other.route && self.tolerance.total_cmp(&other.tolerance).is_eq()
    }
}

/// All jobs of all scenes; a series runs from coarse to fine grids.
pub(crate) fn all() -> Vec<(&'static str, Vec<Job>)> {
    std::iter::once((EXAMPLE, jobs(&TOLERANCES, true)))
        .chain(OTHERS.map(|scene| (scene, jobs(&FEWER, false))))
        .collect()
}

fn up_to(finest: usize) -> impl Iterator<Item = usize> {
    GRIDS.into_iter().take_while(move |intervals| *intervals <= finest)
}

/// The jobs of a scene, with `tolerances`; `all` of the grids, or not those on which the example has said enough.
fn jobs(tolerances: &[f64], all: bool) -> Vec<Job> {
    let mut jobs = vec![Job { route: Route::Exact, intervals: 0, tolerance: 0.0 }];
    let adaptive = Route::Adaptive(Method::Force, Solver::ActiveSet);
    jobs.extend(DEMANDED.map(|tolerance| Job { route: adaptive, intervals: 0, tolerance }));
    let mut series = |route, tolerance, finest: usize| {
        jobs.extend(up_to(finest).map(|intervals| Job { route, intervals, tolerance }));
    };
    for method in [Method::Complementarity, Method::Force] {
        series(Route::Optimum(method), 0.0, if all { 100_000 } else { 30_000 });
    }
    for method in Method::ALL {
        series(Route::Solver(method, Solver::ActiveSet), 0.0, 1_000_000);
        series(Route::Solver(method, Solver::FourStep), 0.0, if all { 10_000 } else { 1000 });
        for &tolerance in tolerances {
            series(Route::Solver(method, Solver::Nsor), tolerance, 300);
            // Interior-point iterations are as many on fine grids: two tolerances are enough to know the price of the finest.
            let finest = if all && matches!(tolerance, 1e-8 | 1e-10) { 100_000 } else { 30_000 };
            series(Route::Solver(method, Solver::Clarabel), tolerance, finest);
            series(Route::Solver(method, Solver::Osqp), tolerance, if all { 30_000 } else { 3000 });
        }
    }
    jobs
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::all;

    #[test]
    fn every_job_has_a_key_of_its_own() {
        let keys: Vec<String> =
            all().iter().flat_map(|(scene, jobs)| jobs.iter().map(|job| job.name(scene)).collect::<Vec<_>>()).collect();
        assert_eq!(keys.iter().collect::<BTreeSet<_>>().len(), keys.len(), "a key is a line of the file");
    }
}
