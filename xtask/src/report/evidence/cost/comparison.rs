//! The active set beside the other solvers: how many times as long they take, and how accurate they are.

use minijinja::{Value, context};

use super::{ASKED, METHODS, SOLVERS, ended, milliseconds};
use crate::measure::plan::{EXAMPLE, OTHERS};
use crate::measure::store::{Line, Store};
use crate::report::numbers::{cell, count, error_cell};
use crate::report::table::Table;

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
        times => times.to_string(),
        accuracy => accuracy(&lines).to_string(),
        reactions => reactions(store).to_string(),
        elsewhere => elsewhere(store).to_string(),
        libraries_least_at_30 => least(&|grid| grid == 30),
        libraries_least_from_300 => least(&|grid| 300 <= grid),
        comparisons => ratios.iter().filter(|(grid, _)| 300 <= *grid).count(),
    }
}

/// The quickest certified run of a solver on a grid, by any method and asked for anything.
fn quickest(lines: &[&Line], solver: &str, grid: usize) -> Option<f64> {
    let certified = lines.iter().filter(|line| line.is_certified() && line.solver == solver && line.intervals == grid);
    certified.map(|line| milliseconds(line)).min_by(f64::total_cmp)
}

/// Milliseconds of the active set, and how many times as long the others take; the factors of the libraries with their grids.
fn times(lines: &[&Line]) -> (Table, Vec<(usize, f64)>) {
    let others = &SOLVERS[1..];
    let header = ["intervals", "active-set, ms"].into_iter().map(str::to_owned);
    let mut table = Table::new(header.chain(others.iter().map(|solver| format!("{solver}, times as long"))));
    let mut ratios = Vec::new();
    for grid in GRIDS {
        let ours = quickest(lines, "active-set", grid);
        let mut row = vec![count(grid), cell(ours, 2)];
        for solver in others {
            let ratio = quickest(lines, solver, grid).zip(ours).map(|(theirs, ours)| theirs / ours);
            ratios.extend(ratio.filter(|_| super::LIBRARIES.contains(solver)).map(|ratio| (grid, ratio)));
            row.push(cell(ratio, 2));
        }
        table = table.row(row);
    }
    (table, ratios)
}

/// The error of the solver alone: the worst of four observables by the best method, asked for [`ASKED`], certified or not.
fn accuracy(lines: &[&Line]) -> Table {
    let header = std::iter::once("intervals".to_owned()).chain(SOLVERS.map(str::to_owned));
    let mut table = Table::new(header);
    for grid in GRIDS {
        let best = SOLVERS.map(|solver| {
            let asked = |line: &&&Line| line.tolerance == 0.0 || line.tolerance.total_cmp(&ASKED).is_eq();
            let runs = lines.iter().filter(|line| {
                line.solver == solver && METHODS.contains(&line.method.as_str()) && line.intervals == grid
            });
            let worst = |line: &&Line| line.of_solver().map(|errors| errors.into_iter().fold(0.0, f64::max));
            error_cell(runs.filter(asked).filter_map(worst).min_by(f64::total_cmp))
        });
        table = table.row(std::iter::once(count(grid)).chain(best));
    }
    table
}

/// The error of the end reaction by the force method with the active set, scene by scene.
fn reactions(store: &Store) -> Table {
    const GRIDS: [usize; 3] = [30, 100, 1000];
    let header = std::iter::once("ground".to_owned()).chain(GRIDS.map(|grid| format!("{} intervals", count(grid))));
    let mut table = Table::new(header);
    let scenes =
        [(EXAMPLE, "flat, the example"), ("wave", "smooth crests"), ("survey", "worn floor"), ("hump", "one hump")];
    for (scene, ground) in scenes {
        let lines = ended(store, scene);
        let errors = GRIDS.map(|grid| {
            let line = lines.iter().find(|line| line.is("force", "active-set") && line.intervals == grid);
            let error = line.filter(|line| line.is_certified()).and_then(|line| line.reaction_total);
            error.map_or_else(|| "–".to_owned(), |error| format!("{} %", cell(Some(100.0 * error), 2)))
        });
        table = table.row(std::iter::once(ground.to_owned()).chain(errors));
    }
    table
}

/// Other scenes: milliseconds of the force method with the active set, and how many times as long clarabel takes where it is
/// certified.
fn elsewhere(store: &Store) -> Table {
    const GRIDS: [usize; 4] = [300, 3000, 30_000, 1_000_000];
    let header = std::iter::once("scene".to_owned())
        .chain(GRIDS.map(|grid| format!("{} intervals, ms (clarabel)", count(grid))));
    let mut table = Table::new(header);
    for scene in std::iter::once(EXAMPLE).chain(OTHERS) {
        let lines = ended(store, scene);
        let lines: Vec<&Line> = lines.into_iter().filter(|line| line.method == "force").collect();
        let cells = GRIDS.map(|grid| {
            let ours = quickest(&lines, "active-set", grid);
            let ratio = quickest(&lines, "clarabel", grid).zip(ours).map(|(theirs, ours)| theirs / ours);
            ratio.map_or_else(|| cell(ours, 2), |ratio| format!("{} (× {})", cell(ours, 2), cell(Some(ratio), 2)))
        });
        table = table.row(std::iter::once(scene.to_owned()).chain(cells));
    }
    table
}
