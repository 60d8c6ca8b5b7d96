//! What it took to find a grid.

use palkki::dial::{End, Try};
use serde::Serialize;

use super::super::answer::{Answer, Search};

#[derive(Debug, Serialize)]
pub(super) struct DialObject {
    tolerance: f64,
    reached: bool,
    end: String,
    error: f64,
    seconds: f64,
    grids: Vec<GridObject>,
}

impl DialObject {
    /// Of an answer and the search that found its grid.
    pub(super) fn of(answer: &Answer, search: &Search) -> Self {
        Self {
            tolerance: search.demanded,
            reached: search.end == End::Reached,
            end: search.end.to_string(),
            error: answer.error,
            seconds: search.seconds,
            grids: search.tries.iter().map(GridObject::from).collect(),
        }
    }
}

/// A grid that was tried; `error` is the guaranteed one, over the largest deflection, and `null` if there is none.
#[derive(Debug, Serialize)]
struct GridObject {
    intervals: usize,
    solver_tolerance: f64,
    unknowns: usize,
    iterations: usize,
    residual: f64,
    error: f64,
    seconds: f64,
}

impl From<&(Try, f64)> for GridObject {
    fn from((tried, seconds): &(Try, f64)) -> Self {
        Self {
            intervals: tried.intervals,
            solver_tolerance: tried.tolerance,
            unknowns: tried.unknowns,
            iterations: tried.iterations,
            residual: tried.residual,
            error: tried.error,
            seconds: *seconds,
        }
    }
}
