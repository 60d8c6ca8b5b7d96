//! True errors beside certified ones: every scene, method, solver and grid; answers that failed their check included.

use palkki::methods::Method;
use palkki::solvers::Solver;
use palkki::{Settings, solve_raw};
use palkki_evidence::faults::{FalseBound, THEORY, Truth};

use serde::{Deserialize, Serialize};

use super::Subject;
use crate::{Cause, data};

/// Where the file is, below the root.
pub(crate) const PATH: &str = "report/data/certificates.csv";

/// Intervals of all grids, and of those that are computed with every report.
pub(crate) const GRIDS: [usize; 5] = [10, 30, 100, 300, 1000];
pub(crate) const AGAIN: [usize; 2] = [10, 30];

/// What became of an answer. Errors are shares of the largest deflection.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(crate) struct Row {
    pub(crate) scene: String,
    pub(crate) method: String,
    pub(crate) solver: String,
    pub(crate) intervals: usize,
    pub(crate) status: String,
    pub(crate) outcome: String,
    #[serde(rename = "true_error", serialize_with = "data::three_digits")]
    pub(crate) truth: f64,
    #[serde(rename = "certified_error", serialize_with = "data::three_digits")]
    pub(crate) certified: f64,
}

/// The outcomes besides exceptions.
pub(crate) const BOUNDED: &str = "bounded";
pub(crate) const REFUSED: &str = "refused";
pub(crate) const EXCEPTION: &str = "exception";

/// All routes on some grids.
pub(crate) fn rows(subject: &Subject, grids: &[usize]) -> Result<Vec<Row>, Cause> {
    let truth = subject.truth()?;
    let mut rows = Vec::new();
    for &intervals in grids {
        for method in Method::ALL {
            for solver in Solver::ALL {
                rows.push(row(&subject.name, &truth, method, solver, intervals)?);
            }
        }
    }
    Ok(rows)
}

/// One route on one grid.
pub(crate) fn row(
    name: &str,
    truth: &Truth<'_>,
    method: Method,
    solver: Solver,
    intervals: usize,
) -> Result<Row, Cause> {
    let outcome = solve_raw(truth.scene, &Settings::new(method, solver, intervals))?;
    let ended = outcome.ended();
    let nodes = outcome.state.nodes.ok_or("a discretised state has nodes")?;
    let (word, error, certified) = match truth.nodes(&nodes) {
        None => (REFUSED, f64::INFINITY, f64::INFINITY),
        Some(judged) => {
            let word = if judged.false_bounds.is_empty() { BOUNDED } else { word(&judged.false_bounds) };
            (word, judged.error / truth.deflection, judged.certificate.deflection_error / truth.deflection)
        }
    };
    Ok(Row {
        scene: name.to_owned(),
        method: method.name().to_owned(),
        solver: solver.name().to_owned(),
        intervals,
        status: ended.to_owned(),
        outcome: word.to_owned(),
        // Digits of an error that is rounding are rounding themselves.
        truth: if error < THEORY { 0.0 } else { error },
        certified,
    })
}

fn word(false_bounds: &[FalseBound]) -> &'static str {
    match false_bounds.first() {
        None => BOUNDED,
        Some(FalseBound::Deflection) => "exception: deflection",
        Some(FalseBound::EnergyLower | FalseBound::EnergyUpper) => "exception: energy",
        Some(FalseBound::Reaction) => "exception: reaction",
    }
}

impl Row {
    /// What identifies the row.
    pub(crate) fn key(&self) -> (&str, &str, &str, usize) {
        (&self.scene, &self.method, &self.solver, self.intervals)
    }

    /// True error over certified error; [`None`] where either is rounding or there is none.
    pub(crate) fn ratio(&self) -> Option<f64> {
        (self.outcome == BOUNDED && 0.0 < self.truth && self.certified.is_finite()).then(|| self.truth / self.certified)
    }
}
