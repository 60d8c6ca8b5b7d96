//! The active set beside the other solvers, how many times as long they take and how accurate they are, and beside what was
//! required of it.

use super::{METHODS, SOLVERS, ended, milliseconds, shown};
use crate::measure::line::{Line, Store};
use crate::measure::plan::{EXAMPLE, OTHERS};
use crate::report::evidence::prelude::*;

/// Grids of the tables.
const GRIDS: [usize; 6] = [10, 30, 100, 300, 3000, 30_000];

pub(super) fn of(store: &Store) -> Value {
    let lines = ended(store, EXAMPLE);
    let (times, ratios) = times(&lines);
    let least = |of: &dyn Fn(usize) -> bool| {
        let of_grids = ratios.iter().filter(|(grid, _)| of(*grid)).map(|(_, ratio)| *ratio);
        of_grids.min_by(f64::total_cmp)
    };
    context! {
        times,
        accuracy => accuracy(&lines),
        reactions => reactions(store),
        elsewhere => elsewhere(store),
        libraries_least_at_30 => least(&|grid| grid == 30),
        libraries_least_from_300 => least(&|grid| 300 <= grid),
        comparisons => ratios.iter().filter(|(grid, _)| 300 <= *grid).count(),
    }
}

/// The quickest certified run of a solver on a grid, by any method and asked for anything.
fn quickest(lines: &[&Line], solver: &str, grid: usize) -> Option<f64> {
    let certified = lines.iter().filter(|line| line.succeeded() && line.solver == solver && line.intervals == grid);
    certified.map(|line| milliseconds(line)).min_by(f64::total_cmp)
}

/// Milliseconds of the active set, and how many times as long the others take; the factors of the libraries with their grids.
fn times(lines: &[&Line]) -> (Table, Vec<(usize, f64)>) {
    let others = &SOLVERS[1..];
    let header = others.iter().map(|solver| format!("{solver}, times as long"));
    let mut table = Table::new(row!["intervals", "active-set, ms"].into_iter().chain(header));
    let mut ratios = Vec::new();
    for grid in GRIDS {
        let ours = quickest(lines, "active-set", grid);
        let mut row = vec![count(grid), cell(ours, 2)];
        for solver in others {
            let ratio = quickest(lines, solver, grid).zip(ours).map(|(theirs, ours)| theirs / ours);
            ratios.extend(ratio.filter(|_| super::LIBRARIES.contains(solver)).map(|ratio| (grid, ratio)));
            row.push(cell(ratio, 2));
        }
        table.push(row);
    }
    (table, ratios)
}

/// The error of the solver alone: the worst of four observables by the best method, certified or not.
fn accuracy(lines: &[&Line]) -> Table {
    Table::new(["intervals"].into_iter().chain(SOLVERS)).rows(GRIDS.map(|grid| {
        let best = SOLVERS.map(|solver| {
            let runs = lines.iter().filter(|line| {
                line.solver == solver && METHODS.contains(&line.method.as_str()) && line.intervals == grid
            });
            let worst = |line: &&Line| line.of_solver().map(|errors| errors.into_iter().fold(0.0, f64::max));
            error_cell(runs.filter(|line| shown(line)).filter_map(worst).min_by(f64::total_cmp))
        });
        [count(grid)].into_iter().chain(best)
    }))
}

/// The error of the end reaction by the force method with the active set, scene by scene.
fn reactions(store: &Store) -> Table {
    const GRIDS: [usize; 3] = [30, 100, 1000];
    let header = row!["ground"].into_iter().chain(GRIDS.map(|grid| format!("{} intervals", count(grid))));
    let scenes =
        [(EXAMPLE, "flat, the example"), ("wave", "smooth crests"), ("survey", "worn floor"), ("hump", "one hump")];
    Table::new(header).rows(scenes.map(|(scene, ground)| {
        let lines = ended(store, scene);
        let errors = GRIDS.map(|grid| {
            let line = lines.iter().find(|line| line.is("force", "active-set") && line.intervals == grid);
            let error = line.filter(|line| line.succeeded()).and_then(|line| line.reaction_total);
            error.map_or_else(|| "–".to_owned(), |error| format!("{} %", cell(Some(100.0 * error), 2)))
        });
        row![ground].into_iter().chain(errors)
    }))
}

/// Other scenes: milliseconds of the force method with the active set, and how many times as long clarabel takes where it is
/// certified.
fn elsewhere(store: &Store) -> Table {
    const GRIDS: [usize; 4] = [300, 3000, 30_000, 1_000_000];
    let header = GRIDS.map(|grid| format!("{} intervals, ms (clarabel)", count(grid)));
    let scenes = std::iter::once(EXAMPLE).chain(OTHERS);
    Table::new(row!["scene"].into_iter().chain(header)).rows(scenes.map(|scene| {
        let lines = ended(store, scene);
        let lines: Vec<&Line> = lines.into_iter().filter(|line| line.method == "force").collect();
        let cells = GRIDS.map(|grid| {
            let ours = quickest(&lines, "active-set", grid);
            let ratio = quickest(&lines, "clarabel", grid).zip(ours).map(|(theirs, ours)| theirs / ours);
            ratio.map_or_else(|| cell(ours, 2), |ratio| format!("{} (× {})", cell(ours, 2), cell(Some(ratio), 2)))
        });
        row![scene].into_iter().chain(cells)
    }))
}

/// What was required of the force method with the active set, on the example, and what was measured: medians.
pub(super) fn requirements(store: &Store) -> Table {
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

    let mut table = Table::new(["quantity", "required", "measured", "met"]);
    // A requirement holds if the number that was found is at most the limit.
    let mut require = |what: &str, limit: &str, most: f64, found: Option<f64>, shown: String| {
        let met = match found {
            Some(found) if found <= most => "yes",
            Some(_) => "**no**",
            None => "not measured",
        };
        table.push(row![what, limit, shown, met]);
    };
    let what = "1 000 000 intervals, time over one tridiagonal solve";
    require(what, "at most 5 times", 5.0, tridiagonal, times(tridiagonal));
    require("1 000 000 intervals, end reaction", "error at most 10⁻⁹", 1e-9, reaction, error_cell(reaction));
    require("1 000 000 intervals, residual of our check", "at most 10⁻¹²", 1e-12, residual, error_cell(residual));
    let what = "1 000 000 intervals, memory of the process";
    require(what, "at most 300 MB", 300.0, megabytes, format!("{} MB", cell(megabytes, 2)));
    require("time over that of 100 000 intervals", "at most 13 times", 13.0, growth, times(growth));
    let what = "100 000 intervals, time of the quickest interior point over ours";
    require(what, "at least 30 times", 1.0 / 30.0, slower, times(slower.map(|slower| 1.0 / slower)));
    for (what, intervals, limit, most) in [
        ("30 intervals, error of the solver", 30, "at most 10⁻¹⁴", 1e-14),
        ("10 000 intervals, error of the solver", 10_000, "at most 10⁻¹¹", 1e-11),
    ] {
        require(what, limit, most, solver_error(intervals), error_cell(solver_error(intervals)));
    }
    let what = "100 000 intervals, time of the certificate over the solve";
    require(what, "at most 1", 1.0, certificate, times(certificate));
    table
}
