//! What was required of the force method with the active set, on the example, and what was measured: medians.

use crate::measure::plan::EXAMPLE;
use crate::measure::store::{Line, Store};
use crate::report::numbers::{cell, error_cell};
use crate::report::table::Table;

use super::{ended, milliseconds};

/// A requirement that holds if the measured number is at most the limit.
fn row(what: &str, limit: &str, most: f64, found: Option<f64>, shown: String) -> Vec<String> {
    let met = match found {
        Some(found) if found <= most => "yes",
        Some(_) => "**no**",
        None => "not measured",
    };
    [what, limit, &shown, met].map(str::to_owned).into()
}

/// All requirements.
pub(super) fn of(store: &Store) -> Table {
    let lines = ended(store, EXAMPLE);
    let ours =
        |intervals: usize| lines.iter().find(|line| line.is("force", "active-set") && line.intervals == intervals);
    let (million, coarser) = (ours(1_000_000), ours(100_000));
    let seconds = |line: Option<&&&Line>| line.and_then(|line| line.median_s);
    let ratio = |a: Option<f64>, b: Option<f64>| a.zip(b).map(|(a, b)| a / b);
    let times = |value: Option<f64>| format!("{} times", cell(value, 2));
    let solver_error = |intervals| {
        let errors = ours(intervals).and_then(|line| line.of_solver());
        errors.map(|errors| errors.into_iter().fold(0.0, f64::max))
    };

    let tridiagonal = ratio(seconds(million.as_ref()), million.and_then(|line| line.tridiagonal_s));
    let growth = ratio(seconds(million.as_ref()), seconds(coarser.as_ref()));
    let certificate = ratio(coarser.and_then(|line| line.certificate_s), seconds(coarser.as_ref()));
    let reaction = million.and_then(|line| line.reaction_total);
    let residual = million.and_then(|line| line.residual);
    let megabytes = million
        .and_then(|line| line.peak_kb)
        .map(|kilobytes| 1e-3 * f64::from(u32::try_from(kilobytes).unwrap_or(u32::MAX)));
    let interior = lines.iter().filter(|line| {
        line.solver == "clarabel"
            && line.intervals == 100_000
            && line.method != "repair"
            && line.says_solved == Some(true)
    });
    let quickest = interior.map(|line| milliseconds(line)).min_by(f64::total_cmp);
    let slower = ratio(coarser.map(|line| milliseconds(line)), quickest);

    Table::new(["quantity", "required", "measured", "met"])
        .row(row(
            "1 000 000 intervals, time over one tridiagonal solve",
            "at most 5 times",
            5.0,
            tridiagonal,
            times(tridiagonal),
        ))
        .row(row("1 000 000 intervals, end reaction", "error at most 10⁻⁹", 1e-9, reaction, error_cell(reaction)))
        .row(row("1 000 000 intervals, residual of our check", "at most 10⁻¹²", 1e-12, residual, error_cell(residual)))
        .row(row(
            "1 000 000 intervals, memory of the process",
            "at most 300 MB",
            300.0,
            megabytes,
            format!("{} MB", cell(megabytes, 2)),
        ))
        .row(row("time over that of 100 000 intervals", "at most 13 times", 13.0, growth, times(growth)))
        .row(row(
            "100 000 intervals, time of the quickest interior point over ours",
            "at least 30 times",
            1.0 / 30.0,
            slower,
            times(slower.map(|slower| 1.0 / slower)),
        ))
        .row(row(
            "30 intervals, error of the solver",
            "at most 10⁻¹⁴",
            1e-14,
            solver_error(30),
            error_cell(solver_error(30)),
        ))
        .row(row(
            "10 000 intervals, error of the solver",
            "at most 10⁻¹¹",
            1e-11,
            solver_error(10_000),
            error_cell(solver_error(10_000)),
        ))
        .row(row(
            "100 000 intervals, time of the certificate over the solve",
            "at most 1",
            1.0,
            certificate,
            times(certificate),
        ))
}
