//! The file of measurements: what a line of it is.

use serde::{Deserialize, Serialize};

use super::errors::Errors;
use super::job::Measured;
use super::rows::{Row, Rows, rounded};

/// Where the file is, below the root.
pub(crate) const PATH: &str = "report/data/measurements.csv";

/// The status of a job that was not run.
const LEFT_OUT: &str = "left-out";

/// A line of the file: what was solved by which route, and what came of it. Errors are relative; those of the solver are
/// against the proven optimum of the same discrete problem, the total ones against beam theory.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub(crate) struct Line {
    pub(crate) scene: String,
    pub(crate) method: String,
    pub(crate) solver: String,
    /// 0 where the route has no grid, or chooses it.
    pub(crate) intervals: usize,
    /// What was asked for; 0 where nothing is.
    pub(crate) tolerance: f64,
    /// Our check: `certified`, `not-certified`, `not-converged`; `proven` for an optimum; or why there is no result.
    pub(crate) status: String,
    /// Whether the solver says that it solved the problem.
    pub(crate) says_solved: Option<bool>,
    /// Of a library: whether it did what it was asked, in its own norm.
    pub(crate) did_as_asked: Option<bool>,
    /// Residual by our check.
    pub(crate) residual: Option<f64>,
    /// Of a library: residual in its own norm.
    pub(crate) own_residual: Option<f64>,
    pub(crate) iterations: Option<usize>,
    pub(crate) unknowns: Option<usize>,
    pub(crate) runs: Option<usize>,
    pub(crate) median_s: Option<f64>,
    pub(crate) min_s: Option<f64>,
    pub(crate) max_s: Option<f64>,
    pub(crate) reaction_solver: Option<f64>,
    pub(crate) contact_solver: Option<f64>,
    pub(crate) deflection_solver: Option<f64>,
    pub(crate) energy_solver: Option<f64>,
    pub(crate) reaction_total: Option<f64>,
    pub(crate) contact_total: Option<f64>,
    pub(crate) deflection_total: Option<f64>,
    pub(crate) energy_total: Option<f64>,
    /// Of the adaptive grid: intervals of its last grid, and the certified error of the deflection.
    pub(crate) last_intervals: Option<usize>,
    pub(crate) certified_error: Option<f64>,
    /// Median seconds of what is measured in turns with the solve.
    pub(crate) added_s: Option<f64>,
    pub(crate) tridiagonal_s: Option<f64>,
    pub(crate) certificate_s: Option<f64>,
    pub(crate) peak_kb: Option<u64>,
}

/// What identifies a line: scene, route, intervals, tolerance.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Key {
    pub(crate) scene: &'static str,
    pub(crate) route: String,
    pub(crate) intervals: usize,
    pub(crate) tolerance: f64,
}

impl Line {
    fn new(key: &Key, status: impl Into<String>) -> Self {
        let (method, solver) = key.route.split_once('/').unwrap_or((&key.route, ""));
        let (scene, method, solver) = (key.scene.to_owned(), method.to_owned(), solver.to_owned());
        let (intervals, tolerance) = (key.intervals, key.tolerance);
        Self { scene, method, solver, intervals, tolerance, status: status.into(), ..Self::default() }
    }

    /// A result.
    pub(super) fn measured(key: &Key, m: &Measured, errors: &Errors) -> Self {
        Self {
            says_solved: Some(m.claims_success),
            did_as_asked: m.own_residual.map(|own| own.is_met()),
            residual: rounded::<2>(m.residual),
            own_residual: m.own_residual.and_then(|own| rounded::<2>(own.residual)),
            iterations: Some(m.iterations),
            unknowns: Some(m.unknowns),
            last_intervals: m.adaptive.map(|(intervals, _)| intervals),
            certified_error: m.adaptive.and_then(|(_, error)| rounded::<2>(error)),
            added_s: m.added.and_then(rounded::<3>),
            tridiagonal_s: m.yardstick.and_then(rounded::<3>),
            certificate_s: m.certificate.and_then(rounded::<3>),
            peak_kb: m.peak,
            ..Self::new(key, m.status.word())
        }
        .with(&m.seconds, errors)
    }

    /// The proven optimum of a discrete problem: its errors are those of the grid.
    pub(super) fn proven(key: &Key, exchanges: usize, seconds: f64, errors: &Errors) -> Self {
        Self { iterations: Some(exchanges + 1), ..Self::new(key, "proven") }.with(&[seconds], errors)
    }

    /// With the seconds of all runs, ascending, and the errors.
    fn with(mut self, seconds: &[f64], errors: &Errors) -> Self {
        self.runs = Some(seconds.len());
        self.median_s = rounded::<3>(seconds[seconds.len() / 2]);
        self.min_s = rounded::<3>(seconds[0]);
        self.max_s = rounded::<3>(seconds[seconds.len() - 1]);
        [self.reaction_solver, self.contact_solver, self.deflection_solver, self.energy_solver] =
            errors.solver.map(rounded::<2>);
        [self.reaction_total, self.contact_total, self.deflection_total, self.energy_total] =
            errors.total.map(rounded::<2>);
        self
    }

    /// A job that was not run, because a coarser grid took too long.
    pub(super) fn left_out(key: &Key) -> Self {
        Self::new(key, LEFT_OUT)
    }

    /// A job that ends without a result.
    pub(super) fn without_result(key: &Key, why: &str) -> Self {
        Self::new(key, why)
    }

    pub(crate) fn is_left_out(&self) -> bool {
        self.status == LEFT_OUT
    }

    pub(crate) fn is_certified(&self) -> bool {
        self.status == "certified"
    }

    pub(crate) fn is(&self, method: &str, solver: &str) -> bool {
        self.method == method && self.solver == solver
    }

    /// Errors against beam theory: end reaction, largest contact, deflection of the worst node, energy; none if one of them
    /// is no number.
    pub(crate) fn total(&self) -> Option<[f64; 4]> {
        Some([self.reaction_total?, self.contact_total?, self.deflection_total?, self.energy_total?])
    }

    /// Errors against the proven optimum, in the same order.
    pub(crate) fn of_solver(&self) -> Option<[f64; 4]> {
        Some([self.reaction_solver?, self.contact_solver?, self.deflection_solver?, self.energy_solver?])
    }

    /// The worst of the errors against beam theory.
    pub(crate) fn worst(&self) -> Option<f64> {
        self.total().map(|errors| errors.into_iter().fold(0.0, f64::max))
    }

    /// Correct decimal digits of the worst observable.
    pub(crate) fn digits(&self) -> Option<f64> {
        self.worst().filter(|worst| 0.0 < *worst).map(|worst| -worst.log10())
    }
}

impl Row for Line {
    const PATH: &'static str = PATH;

    /// `scene,method/solver,intervals,tolerance`
    fn name(&self) -> String {
        format!("{},{}/{},{},{:e}", self.scene, self.method, self.solver, self.intervals, self.tolerance)
    }
}

impl Key {
    /// As [`Line::name`].
    pub(super) fn name(&self) -> String {
        format!("{},{},{},{:e}", self.scene, self.route, self.intervals, self.tolerance)
    }
}

/// All lines, on disk and in memory.
pub(crate) type Store = Rows<Line>;

impl Store {
    /// The line of a key.
    pub(super) fn find(&self, key: &Key) -> Option<&Line> {
        self.named(&key.name())
    }
}

#[cfg(test)]
mod tests;
