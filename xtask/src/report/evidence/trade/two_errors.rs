//! The error of the solver beside the error of the grid: from which tolerance on a finer one buys nothing.

use palkki::plot::{Axis, Color, Figure, Layer, Marker, Panel, PlotError, Style};
use serde::Serialize;

use super::lines::{Lines, SOLVER, TOTAL, finite, intervals, place};
use super::{LIBRARIES, METHODS, tolerance};
use crate::measure::store::Line;
use crate::report::csv::{csv, scientific};

/// Grids of the tables.
const GRIDS: [usize; 4] = [30, 300, 3000, 30_000];

/// The route whose errors are drawn and listed in full.
const SHOWN: &str = "force/clarabel";

/// Errors of the grid below this are rounding of beam theory: they say nothing.
const MEANINGLESS: f64 = 1e-13;

#[derive(Debug, Serialize)]
pub(super) struct Values {
    grids: Vec<usize>,
    shown: &'static str,
    detail: Vec<Detail>,
    /// Route by route, grid by grid: the loosest tolerance with which the grid dominates in every observable.
    enough: Vec<Enough>,
}

/// One grid and one observable of the route that is shown.
#[derive(Debug, Serialize)]
struct Detail {
    intervals: usize,
    observable: &'static str,
    grid: f64,
    solver: Vec<Solver>,
}

#[derive(Debug, Serialize)]
struct Solver {
    tolerance: String,
    error: Option<f64>,
    /// Whether it is larger than that of the grid.
    dominates: bool,
}

#[derive(Debug, Serialize)]
struct Enough {
    route: String,
    cells: Vec<String>,
}

/// The figure and its numbers.
type Drawn = (String, String);

/// None where the optima were not measured.
pub(super) fn of(lines: &Lines<'_>) -> Result<Option<(Values, Drawn)>, PlotError> {
    let detail: Vec<Detail> = GRIDS.iter().flat_map(|grid| details(lines, *grid)).collect();
    if detail.is_empty() {
        return Ok(None);
    }
    let routes = METHODS.into_iter().flat_map(|method| LIBRARIES.map(|library| format!("{method}/{library}")));
    let enough = routes.map(|route| {
        let cells = GRIDS.iter().map(|grid| loosest(lines, &route, *grid)).collect();
        Enough { route, cells }
    });
    let values = Values { grids: GRIDS.into(), shown: SHOWN, detail, enough: enough.collect() };
    Ok(drawn(lines)?.map(|drawn| (values, drawn)))
}

/// The proven optimum of a method on a grid; displacement and force method have the same.
fn optimum<'a>(lines: &Lines<'a>, route: &str, grid: usize) -> Option<&'a Line> {
    let method = if route.starts_with("complementarity") { "complementarity" } else { "force" };
    lines.find(&format!("{method}/optimum"), grid, "0e0")
}

fn details(lines: &Lines<'_>, grid: usize) -> Vec<Detail> {
    let Some(optimum) = optimum(lines, SHOWN, grid) else { return Vec::new() };
    let mut details = Vec::new();
    for ((observable, of_solver), of_grid) in OBSERVABLES.into_iter().zip(SOLVER).zip(TOTAL) {
        let Some(error) = finite(optimum, of_grid).filter(|error| MEANINGLESS < *error) else { continue };
        let solver = lines.tolerances(SHOWN).into_iter().map(|asked| {
            let found = lines.find(SHOWN, grid, asked).and_then(|line| finite(line, of_solver));
            Solver { tolerance: tolerance(asked), error: found, dominates: found.is_none_or(|found| error < found) }
        });
        details.push(Detail { intervals: grid, observable, grid: error, solver: solver.collect() });
    }
    details
}

const OBSERVABLES: [&str; 4] = ["end reaction", "contact", "deflection", "energy"];

/// The loosest tolerance from which on, down to the finest, the solver's error stays below the grid's everywhere.
fn loosest(lines: &Lines<'_>, route: &str, grid: usize) -> String {
    let Some(optimum) = optimum(lines, route, grid) else { return "–".to_owned() };
    let below = |asked: &str| {
        lines.find(route, grid, asked).is_some_and(|line| {
            SOLVER.iter().zip(TOTAL).all(|(of_solver, of_grid)| {
                let meaningless = finite(optimum, of_grid).is_none_or(|error| error <= MEANINGLESS);
                meaningless
                    || finite(line, of_solver).zip(finite(optimum, of_grid)).is_some_and(|(solver, grid)| solver < grid)
            })
        })
    };
    let tolerances = lines.tolerances(route);
    let enough = tolerances.iter().rev().take_while(|asked| below(asked)).last();
    enough.map_or_else(|| "none".to_owned(), |asked| tolerance(asked))
}

/// Errors of end reaction and energy over the number of intervals: one line for the grid, one for each tolerance.
fn drawn(lines: &Lines<'_>) -> Result<Option<Drawn>, PlotError> {
    let mut rows = Vec::new();
    let mut panels = Vec::new();
    for i in [0, 3] {
        let y = Axis::new(format!("relative error: {}", OBSERVABLES[i])).log();
        let mut panel = Panel::new(Axis::new("intervals N").log(), y).tall(700.0);
        let mut line = |label: &str, route: &str, asked: &str, column: &str, style: Style| {
            let found =
                lines.of_route(route).filter(|line| line.field("tolerance") == Some(asked) && 0 < intervals(line));
            let points: Vec<[f64; 2]> = found
                .filter_map(|line| Some([place(line), finite(line, column).filter(|error| 1e-17 < *error)?]))
                .collect();
            rows.extend(
                points
                    .iter()
                    .map(|p| vec![OBSERVABLES[i].to_owned(), label.to_owned(), p[0].to_string(), scientific(p[1], 2)]),
            );
            (!points.is_empty()).then(|| Layer::Series { points, style, label: label.to_owned() })
        };
        let grid = Style { marker: Some(Marker::OpenCircle), ..Style::marks(Color::BLACK, Marker::OpenCircle) };
        let mut layers = vec![line("of the grid", "force/optimum", "0e0", TOTAL[i], grid)];
        for (k, asked) in lines.tolerances(SHOWN).into_iter().enumerate() {
            let label = format!("of the solver, asked for {}", tolerance(asked));
            layers.push(line(&label, SHOWN, asked, SOLVER[i], Style::of_series(k)));
        }
        let layers: Vec<Layer> = layers.into_iter().flatten().collect();
        if layers.is_empty() {
            return Ok(None);
        }
        panel = layers.into_iter().fold(panel, Panel::with);
        panels.push(panel);
    }
    let svg = Figure::new(
        "Error of the grid and error of the solver: force method by clarabel",
        "Two panels, end reaction and energy: relative error over the number of intervals, both axes logarithmic. Circles are \
         the error of the grid, which falls; one line for each tolerance is the error of the solver, which does not. Where a \
         line lies above the circles, a tighter tolerance buys accuracy; below them it buys nothing.",
        panels,
    )
    .svg()?;
    Ok(Some((svg, csv(&["observable", "error", "intervals", "relative_error"], rows))))
}
