//! Speed and accuracy: rendered from the file of `cargo xtask measure`, which alone knows times. Only runs that solve their
//! problem count as results; what did not end, or failed our check, is marked and never fitted.

mod advice;
mod price;
mod runs;
mod stopping;

use super::population;
use super::prelude::*;
use crate::measure::line::{Line, Store};
use crate::measure::plan::is_survey;

/// Solvers in the order of figures and tables, the libraries among them, and the methods.
pub(super) const SOLVERS: [&str; 5] = ["active-set", "four-step", "nsor", "clarabel", "osqp"];
const LIBRARIES: [&str; 2] = ["clarabel", "osqp"];
const METHODS: [&str; 3] = ["complementarity", "displacement", "force"];

/// What solvers that can be asked for a tolerance are asked for, where one is shown.
const ASKED: f64 = 1e-10;

/// The lines of a scene that have a result.
pub(super) fn ended<'a>(store: &'a Store, scene: &str) -> Vec<&'a Line> {
    store.lines.iter().filter(|line| line.scene == scene && line.median_s.is_some()).collect()
}

/// Whether a line is asked for what is shown, or cannot be asked for anything.
pub(super) fn shown(line: &Line) -> bool {
    line.asks(0.0) || line.asks(ASKED)
}

/// Milliseconds of the median run.
fn milliseconds(line: &Line) -> f64 {
    1e3 * line.median_s.unwrap_or(f64::NAN)
}

pub(super) fn evidence(study: &Study<'_>) -> Result<Evidence, Cause> {
    let (file, mut store) = Store::read(study.root)?;
    // Surveys have a page of their own.
    store.lines.retain(|line| !is_survey(&line.scene));
    let (price, price_figure) = price::of(study, &store)?;
    let (stopping, stopping_figure) = stopping::of(study, &store)?;
    let (runs, runs_figure) = runs::of(study, &store)?;
    let [advice, kept] = advice::tables(study, &store, &population::lines(study)?)?;
    let values = context! {
        made => store.provenance(),
        measured => store.lines.iter().filter(|line| line.median_s.is_some()).count(),
        price,
        stopping,
        runs,
        advice,
        kept,
    };
    Evidence::new(values).file("measurements", file).figures([price_figure, stopping_figure, runs_figure])
}
