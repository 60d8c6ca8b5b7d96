//! The libraries beside the force method with the active set: how much longer, how much less accurate.

use serde::Serialize;

use super::lines::{Lines, SOLVER, finite, verdict};
use super::{ASKED, LIBRARIES, METHODS, OURS, tolerance};
use crate::measure::store::Line;

/// Grids of the comparison, and those of them that the requirement names.
const GRIDS: [usize; 4] = [30, 300, 3000, 30_000];
const REQUIRED: [usize; 3] = [300, 3000, 30_000];

/// What is asked: so many times faster, so many times more accurate.
const FASTER: f64 = 50.0;
const SHARPER: f64 = 100.0;

/// Half a unit in the last place of one: less than that is no error of a 64-bit answer.
const ROUNDING: f64 = 0.5 * f64::EPSILON;

#[derive(Debug, Serialize)]
pub(super) struct Values {
    faster: f64,
    sharper: f64,
    rounding: f64,
    grids: Vec<Grid>,
    /// Comparisons on the required grids, and how many of them meet each of the two.
    compared: usize,
    fast: usize,
    observed: usize,
    sharp: usize,
    /// Where it falls short.
    slow: Vec<Short>,
    blunt: usize,
    /// Observable by observable, grid by grid.
    accuracy: Vec<Accuracy>,
}

/// How many times less accurate the libraries are in one observable.
#[derive(Debug, Serialize)]
struct Accuracy {
    observable: &'static str,
    /// On the required grids that were measured.
    cells: Vec<Spread>,
}

/// Comparisons on one grid.
#[derive(Debug, Serialize, Default)]
struct Spread {
    intervals: usize,
    sharp: usize,
    compared: usize,
    /// The least of the factors.
    least: Option<f64>,
}

#[derive(Debug, Serialize)]
struct Grid {
    intervals: usize,
    milliseconds: f64,
    /// Solver errors of ours.
    errors: Vec<Option<f64>>,
    /// Our other routes, for whoever has to use another method.
    own: Vec<Row>,
    rows: Vec<Row>,
}

#[derive(Debug, Serialize)]
struct Row {
    method: &'static str,
    solver: &'static str,
    verdict: String,
    /// Its time over ours, and over that of the active set on the same method.
    times: f64,
    same_method: Option<f64>,
    /// Solver errors in the four observables.
    errors: Vec<Option<f64>>,
    /// The least of its four errors over ours.
    sharper: Option<f64>,
    /// The quickest setting of it that our judge certifies: what it was asked for, and its time over ours.
    certified: Option<(String, f64)>,
}

#[derive(Debug, Serialize)]
struct Short {
    intervals: usize,
    route: String,
    factor: f64,
}

/// See [`Values`].
pub(super) fn of(lines: &Lines<'_>) -> Values {
    let mut values = Values {
        faster: FASTER,
        sharper: SHARPER,
        rounding: ROUNDING,
        grids: GRIDS.iter().filter_map(|grid| on(lines, *grid)).collect(),
        compared: 0,
        fast: 0,
        observed: 0,
        sharp: 0,
        slow: Vec::new(),
        blunt: 0,
        accuracy: Vec::new(),
    };
    let required = || values.grids.iter().filter(|grid| REQUIRED.contains(&grid.intervals));
    for grid in required() {
        for row in &grid.rows {
            values.compared += 1;
            if FASTER <= row.times {
                values.fast += 1;
            } else {
                let (intervals, route) = (grid.intervals, format!("{}/{}", row.method, row.solver));
                values.slow.push(Short { intervals, route, factor: row.times });
            }
        }
    }
    for (i, observable) in OBSERVABLES.into_iter().enumerate() {
        let cells: Vec<Spread> = required().map(|grid| spread(grid, i)).collect();
        values.accuracy.push(Accuracy { observable, cells });
    }
    let cells = || values.accuracy.iter().flat_map(|row| &row.cells);
    values.observed = cells().map(|cell| cell.compared).sum();
    values.sharp = cells().map(|cell| cell.sharp).sum();
    values.blunt = values.observed - values.sharp;
    values
}

/// The libraries on one grid, in one observable. What a library has to the last digit cannot be told apart.
fn spread(grid: &Grid, observable: usize) -> Spread {
    let ours = grid.errors.get(observable).copied().flatten();
    let theirs = grid.rows.iter().filter_map(|row| row.errors.get(observable).copied().flatten());
    let told_apart = theirs.filter(|theirs| 2.0 * ROUNDING < *theirs);
    let factors: Vec<f64> = told_apart.filter_map(|theirs| Some(ratio(theirs, ours?))).collect();
    Spread {
        intervals: grid.intervals,
        sharp: factors.iter().filter(|factor| SHARPER <= **factor).count(),
        compared: factors.len(),
        least: factors.into_iter().min_by(f64::total_cmp),
    }
}

const OBSERVABLES: [&str; 4] = ["end reaction", "contact", "deflection", "energy"];

/// Their error over ours, both at least rounding.
fn ratio(theirs: f64, ours: f64) -> f64 {
    theirs.max(ROUNDING) / ours.max(ROUNDING)
}

fn on(lines: &Lines<'_>, intervals: usize) -> Option<Grid> {
    let ours = lines.find(OURS, intervals, "0e0")?;
    let seconds = ours.seconds()?;
    let errors = |line: &Line| SOLVER.map(|column| finite(line, column));
    let own_errors = errors(ours);
    let row = |method: &'static str, solver: &'static str, asked: &str| {
        let route = format!("{method}/{solver}");
        let line = lines.find(&route, intervals, asked)?;
        let same_method = lines.seconds_of(&format!("{method}/active-set"), intervals, "0e0");
        let errors = errors(line);
        let ratios = errors.iter().zip(&own_errors).filter_map(|(theirs, ours)| Some(ratio((*theirs)?, (*ours)?)));
        let on_this = lines.of_route(&route).filter(|line| super::lines::intervals(line) == intervals);
        let certified = on_this.filter(|line| line.field("status") == Some("certified"));
        let quickest = certified.filter_map(|line| Some((line.field("tolerance")?, line.seconds()?)));
        let quickest = quickest.min_by(|a, b| a.1.total_cmp(&b.1));
        Some(Row {
            method,
            solver,
            verdict: verdict(line),
            times: line.seconds()? / seconds,
            same_method: line.seconds().zip(same_method).map(|(theirs, ours)| theirs / ours),
            sharper: ratios.min_by(f64::total_cmp),
            errors: errors.into(),
            certified: quickest.map(|(asked, time)| (tolerance(asked), time / seconds)),
        })
    };
    let peers = METHODS.into_iter().flat_map(|method| LIBRARIES.map(|library| (method, library)));
    Some(Grid {
        intervals,
        milliseconds: 1e3 * seconds,
        own: METHODS.into_iter().filter_map(|method| row(method, "active-set", "0e0")).collect(),
        rows: peers.filter_map(|(method, library)| row(method, library, ASKED)).collect(),
        errors: own_errors.into(),
    })
}
