//! When to stop: the error of the solver beside the error of the grid.

use palkki::plot::{Axis, Color, Layer, Marker, Panel, Place, Style};

use super::{ASKED, LIBRARIES, METHODS, ended, milliseconds};
use crate::measure::line::{Line, Store};
use crate::measure::plan::EXAMPLE;
use crate::report::evidence::prelude::*;

/// Grids of the table.
const GRIDS: [usize; 4] = [30, 300, 3000, 30_000];

/// Errors of the grid below this are rounding of the exact solution: they say nothing.
const MEANINGLESS: f64 = 1e-13;

/// Tolerances that are enough, what tighter ones cost, and the figure of the two errors.
pub(super) fn of(study: &Study<'_>, store: &Store) -> Result<(Value, Drawn), Cause> {
    let lines = ended(store, EXAMPLE);
    let header = GRIDS.map(|grid| format!("{} intervals", count(grid)));
    let mut table = Table::new(row!["method and solver"].into_iter().chain(header));
    for solver in LIBRARIES {
        for method in METHODS {
            let cells = GRIDS.map(|grid| {
                let of_route = of_route(&lines, method, solver, grid);
                let optimum = optimum(&lines, method, grid);
                let enough = loosest(&of_route, |line| optimum.is_some_and(|optimum| grid_dominates(line, optimum)));
                format!("{enough} / {}", loosest(&of_route, |line| line.succeeded()))
            });
            table.push([format!("{method}, {solver}")].into_iter().chain(cells));
        }
    }
    let [clarabel, osqp] = LIBRARIES.map(|solver| decades(&lines, solver));
    Ok((context! { table, clarabel, osqp }, drawn(study, &lines)?))
}

/// The lines of a route on a grid, loose tolerances first.
fn of_route<'a>(lines: &[&'a Line], method: &str, solver: &str, grid: usize) -> Vec<&'a Line> {
    let mut found: Vec<&Line> =
        lines.iter().filter(|line| line.is(method, solver) && line.intervals == grid).copied().collect();
    found.sort_by(|a, b| b.tolerance.total_cmp(&a.tolerance));
    found
}

/// The proven optimum of a method on a grid; displacement and force method have the same.
fn optimum<'a>(lines: &[&'a Line], method: &str, grid: usize) -> Option<&'a Line> {
    let method = if method == "complementarity" { method } else { "force" };
    lines.iter().find(|line| line.is(method, "optimum") && line.intervals == grid).copied()
}

/// Whether in every observable the error of the grid is larger than that of the solver.
fn grid_dominates(line: &Line, optimum: &Line) -> bool {
    let (Some(of_solver), Some(of_grid)) = (line.of_solver(), optimum.total()) else { return false };
    of_solver.iter().zip(of_grid).all(|(solver, grid)| grid <= MEANINGLESS || *solver < grid)
}

/// The loosest tolerance from which on, down to the tightest that was tried, all lines hold: the library's own.
fn loosest(lines: &[&Line], holds: impl Fn(&Line) -> bool) -> String {
    let enough = lines.iter().rev().take_while(|line| holds(line)).last();
    enough.map_or_else(|| "none".to_owned(), |line| tolerance(own(&line.solver, line.tolerance)))
}

/// A library's own tolerance when it is asked for `asked`; rounded, as it is a power of ten.
fn own(solver: &str, asked: f64) -> f64 {
    let solver = Solver::ALL.into_iter().find(|known| known.name() == solver);
    let own = solver.and_then(|solver| solver.own_tolerance(asked)).unwrap_or(asked);
    format!("{own:.0e}").parse().unwrap_or(own)
}

/// Of [`decades`]: what the loose one of a pair is asked for.
const LOOSE: f64 = 1e-4;

/// How many times as long a run takes that is asked for 10⁻¹⁰ and not for 10⁻⁴: the least and the most over methods and grids
/// of 30 intervals and more, among runs of which the tight one passes our check; with the library's own two tolerances.
fn decades(lines: &[&Line], solver: &str) -> Option<Value> {
    let tight = lines.iter().filter(|line| line.solver == solver && line.asks(ASKED) && 30 <= line.intervals);
    let factors: Vec<f64> = tight
        .filter_map(|tight| {
            let of_route = of_route(lines, &tight.method, solver, tight.intervals);
            let loose = of_route.into_iter().find(|line| line.asks(LOOSE))?;
            let succeeded = tight.succeeded() && loose.says_solved == Some(true);
            succeeded.then(|| milliseconds(tight) / milliseconds(loose))
        })
        .collect();
    let [least, most] = range(factors.iter().copied())?;
    let [loose, tight] = [LOOSE, ASKED].map(|asked| tolerance(own(solver, asked)));
    Some(context! { least, most, pairs => factors.len(), loose, tight })
}

/// Error of the left reaction over the number of intervals, by the force method: of the grid, and of clarabel for each tolerance.
fn drawn(study: &Study<'_>, lines: &[&Line]) -> Result<Drawn, Cause> {
    const TOLERANCES: [f64; 4] = [1e-2, 1e-4, 1e-6, 1e-8];
    let of_grid = |line: &Line| line.is("force", "optimum").then_some(line.reaction_total?);
    let marks = Style::marks(Color::BLACK, Marker::OpenCircle);
    let mut series = vec![("of the grid".to_owned(), marks, places(lines, of_grid))];
    for (k, asked) in TOLERANCES.into_iter().enumerate() {
        let of_solver =
            |line: &Line| (line.is("force", "clarabel") && line.asks(asked)).then_some(line.reaction_solver?);
        series.push((
            format!("clarabel, {}", tolerance(own("clarabel", asked))),
            Style::of_series(k),
            places(lines, of_solver),
        ));
    }
    let mut data = Table::new(["error", "intervals", "relative_error"]);
    let y = Axis::new("relative error of the left reaction").log();
    let mut panel = Panel::new(Axis::new("intervals N").log(), y).tall(800.0).room(60.0, 0.0);
    for (label, style, places) in series {
        data = data.rows(places.iter().map(|[grid, error]| row![label, grid, scientific(*error, 2)]));
        // From fine grids to coarse ones: the name of the marks stands at the last, where there is room.
        panel = panel.with(Layer::named(places.into_iter().rev().collect(), style, label));
    }
    study.drawn("two-errors", context! {}, 1, vec![panel], data)
}

/// Errors over intervals, up to the finest grid of the table, without those that are rounding.
fn places(lines: &[&Line], error: impl Fn(&Line) -> Option<f64>) -> Vec<Place> {
    let shown = lines.iter().filter(|line| line.intervals <= GRIDS[GRIDS.len() - 1]);
    let mut places: Vec<Place> = shown
        .filter_map(|line| Some([as_number(line.intervals), error(line).filter(|error| f64::EPSILON < *error)?]))
        .collect();
    places.sort_by(|a, b| a[0].total_cmp(&b[0]));
    places
}
