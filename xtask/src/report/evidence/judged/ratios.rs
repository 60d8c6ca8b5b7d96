//! True error over certified error: at most 1, and the nearer to 1 the sharper.

use std::collections::BTreeSet;

use palkki::methods::Method;
use palkki::solvers::Solver;
use serde::Serialize;

use crate::judge::answers::{GRIDS, Row};

/// One route over all grids.
#[derive(Debug, Serialize)]
pub(super) struct Route {
    method: &'static str,
    solver: &'static str,
    cells: Vec<Cell>,
}

/// One route on one grid: ratios of all scenes that have one.
#[derive(Debug, Serialize)]
struct Cell {
    count: usize,
    median: f64,
    smallest: f64,
}

/// One answer.
#[derive(Debug, Serialize)]
pub(super) struct Place {
    scene: String,
    method: String,
    solver: String,
    intervals: usize,
    truth: f64,
    certified: f64,
    ratio: f64,
    status: String,
}

/// The middle of some numbers, the upper one of two; 0 if there are none.
pub(super) fn median(numbers: &mut [f64]) -> f64 {
    numbers.sort_by(f64::total_cmp);
    numbers.get(numbers.len() / 2).copied().unwrap_or(0.0)
}

pub(super) fn routes(rows: &[Row]) -> Vec<Route> {
    let route = |method: Method, solver: Solver| {
        let of_route = |row: &&Row| row.method == method.word() && row.solver == solver.word();
        let cell = |intervals: usize| {
            let on_grid = rows.iter().filter(of_route).filter(|row| row.intervals == intervals);
            let mut ratios: Vec<f64> = on_grid.filter_map(Row::ratio).collect();
            let smallest = ratios.iter().copied().fold(1.0, f64::min);
            Cell { count: ratios.len(), median: median(&mut ratios), smallest }
        };
        Route { method: method.word(), solver: solver.word(), cells: GRIDS.map(cell).into() }
    };
    Method::ALL.into_iter().flat_map(|method| Solver::ALL.map(|solver| route(method, solver))).collect()
}

/// The answer of each scene with the loosest bound, the loosest first.
pub(super) fn loosest(rows: &[Row]) -> Vec<Place> {
    let mut places = places(rows);
    places.sort_by(|a, b| a.ratio.total_cmp(&b.ratio));
    let mut seen = BTreeSet::new();
    places.retain(|place| seen.insert(place.scene.clone()));
    places
}

fn places(rows: &[Row]) -> Vec<Place> {
    let place = |row: &Row| {
        Some(Place {
            scene: row.scene.clone(),
            method: row.method.clone(),
            solver: row.solver.clone(),
            intervals: row.intervals,
            truth: row.truth,
            certified: row.certified,
            ratio: row.ratio()?,
            status: row.status.clone(),
        })
    };
    rows.iter().filter_map(place).collect()
}
