//! Advice as data: each recommendation of a route is a row of a file, which says what is promised and where it has to hold.

use std::path::Path;

use palkki::methods::Method;
use palkki::solvers::Solver;
use serde::Deserialize;

use super::plan::Route;
use crate::{Cause, data};

/// Where it is, below the root.
pub(crate) const PATH: &str = "report/advice.csv";

/// One recommendation.
#[derive(Debug, Clone, Deserialize)]
pub(crate) struct Advice {
    /// Whose case it is.
    pub(crate) case: String,
    /// Scenes on which its time is measured, with blanks between them.
    pub(crate) scenes: String,
    /// Families of the population on which its promise has to hold, with semicolons between them.
    pub(crate) families: String,
    pub(crate) method: String,
    pub(crate) solver: String,
    /// 0 for no grid, or one that the route chooses.
    pub(crate) intervals: usize,
    /// What is asked for; 0 for nothing.
    pub(crate) tolerance: f64,
    /// The largest errors that are promised, observable by observable; none where nothing is.
    pub(crate) supports: Option<f64>,
    pub(crate) contact: Option<f64>,
    pub(crate) deflection: Option<f64>,
    pub(crate) moment: Option<f64>,
    pub(crate) energy: Option<f64>,
    /// What one types.
    pub(crate) command: String,
    /// What to believe of the answer.
    pub(crate) believe: String,
}

impl Advice {
    pub(crate) fn families(&self) -> impl Iterator<Item = &str> {
        self.families.split(';').map(str::trim).filter(|name| !name.is_empty())
    }

    /// Whether anything is promised.
    pub(crate) fn has_promise(&self) -> bool {
        self.promises().iter().any(Option::is_some)
    }

    /// In the order of [`palkki_evidence::observables::NAMES`].
    pub(crate) fn promises(&self) -> [Option<f64>; 5] {
        [self.supports, self.contact, self.deflection, self.moment, self.energy]
    }

    /// What answers the case; none if nobody knows the names.
    pub(crate) fn route(&self) -> Option<Route> {
        if self.method == "exact" {
            return Some(Route::Exact);
        }
        let method = Method::ALL.into_iter().find(|method| method.name() == self.method)?;
        let (solver, adaptive) = match self.solver.strip_suffix("-adaptive") {
            Some(solver) => (solver, true),
            None => (self.solver.as_str(), false),
        };
        let solver = Solver::ALL.into_iter().find(|known| known.name() == solver)?;
        Some(if adaptive { Route::Adaptive(method, solver) } else { Route::Solver(method, solver) })
    }
}

/// All advice.
pub(crate) fn read(root: &Path) -> Result<Vec<Advice>, Cause> {
    Ok(data::read(root, PATH)?.1)
}
