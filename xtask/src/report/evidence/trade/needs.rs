//! Which route for which need: the quickest that reaches an accuracy.

use serde::Serialize;

use super::lines::{Lines, TOTAL, finite, intervals, worst};
use super::{METHODS, OURS, SOLVERS, tolerance};
use crate::measure::plan::{EXAMPLE, OTHERS};
use crate::measure::store::{Line, Store};
use crate::report::numbers::power;

/// Accuracies: in all four observables against beam theory, as powers of ten.
const NEEDS: [i32; 4] = [-2, -3, -4, -6];

#[derive(Debug, Serialize)]
pub(super) struct Scene {
    name: &'static str,
    /// Microseconds of beam theory.
    theory: Option<f64>,
    rows: Vec<Row>,
}

#[derive(Debug, Serialize)]
struct Row {
    need: String,
    /// Solver by solver; none where no grid and no tolerance of it reaches that.
    cells: Vec<Option<Cell>>,
}

#[derive(Debug, Serialize)]
struct Cell {
    milliseconds: f64,
    method: &'static str,
    intervals: usize,
    /// None where nothing is asked.
    tolerance: Option<String>,
}

/// Scene by scene.
pub(super) fn of(store: &Store) -> Vec<Scene> {
    let scenes = std::iter::once(EXAMPLE).chain(OTHERS).map(|name| {
        let lines = Lines::of(store, name);
        let row = |need: &i32| Row {
            need: power(*need),
            cells: SOLVERS.map(|solver| quickest(&lines, solver, 10.0_f64.powi(*need))).into(),
        };
        let theory = lines.seconds_of("exact/free-boundary", 0, "0e0").map(|seconds| 1e6 * seconds);
        Scene { name, theory, rows: NEEDS.iter().map(row).collect() }
    });
    scenes.filter(|scene| scene.rows.iter().any(|row| row.cells.iter().any(Option::is_some))).collect()
}

/// The quickest certified answer of a solver, by any method, on any grid, asked for anything.
fn quickest(lines: &Lines<'_>, solver: &str, need: f64) -> Option<Cell> {
    let mut best: Option<(f64, Cell)> = None;
    for method in METHODS {
        let route = format!("{method}/{solver}");
        for line in lines.of_route(&route) {
            let enough = worst(line, &TOTAL).is_some_and(|error| error <= need);
            let Some(seconds) = line.seconds().filter(|_| enough && line.field("status") == Some("certified")) else {
                continue;
            };
            if best.as_ref().is_none_or(|(quickest, _)| seconds < *quickest) {
                let asked = line.field("tolerance").filter(|asked| *asked != "0e0").map(tolerance);
                let cell = Cell { milliseconds: 1e3 * seconds, method, intervals: intervals(line), tolerance: asked };
                best = Some((seconds, cell));
            }
        }
    }
    best.map(|(_, cell)| cell)
}

/// Kinks between the nodes: a finer grid without nodes at the readings is worse than a coarser one with them.
#[derive(Debug, Serialize)]
pub(super) struct Survey {
    with: usize,
    error_with: f64,
    without: usize,
    error_without: f64,
    worse: f64,
    finer: f64,
}

/// A grid with a node at every reading, and the next finer one, which has none at most of them.
pub(super) fn survey(store: &Store) -> Option<Survey> {
    /// The readings of the survey divide the beam into so many equal parts.
    const PARTS: usize = 24;
    let lines = Lines::of(store, "survey");
    let ours: Vec<&Line> = lines.asked(OURS).into_iter().filter(|line| line.seconds().is_some()).collect();
    let error = |line: &Line| finite(line, "reaction_total");
    let pair = ours
        .windows(2)
        .find(|pair| intervals(pair[0]).is_multiple_of(PARTS) && !intervals(pair[1]).is_multiple_of(PARTS))?;
    let (error_with, error_without) = (error(pair[0])?, error(pair[1])?);
    let (with, without) = (intervals(pair[0]), intervals(pair[1]));
    let [a, b] = [pair[0], pair[1]].map(super::lines::place);
    if error_with <= 0.0 {
        return None;
    }
    Some(Survey { with, error_with, without, error_without, worse: error_without / error_with, finer: b / a })
}
