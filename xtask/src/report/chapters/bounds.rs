//! Guaranteed bounds for the continuous beam, beside the true errors, on every scene of the gallery.

use palkki::certificate::{ContactLoad, Judged, certify};
use palkki::methods::Method;
use palkki::scene::Scene;
use palkki::solvers::Solver;
use palkki::{Settings, solve, theory};
use serde::Serialize;

use crate::report::csv::{csv, scientific};
use crate::report::error::Cause;
use crate::report::evidence::Evidence;
use crate::report::scenes;
use crate::report::study::Study;

/// Grids of the table.
const GRIDS: [usize; 3] = [30, 100, 300];

#[derive(Debug, Serialize)]
struct Values {
    grids: [usize; 3],
    rows: Vec<Row>,
    /// Runs in which the true error is at most the certified one, and all runs.
    truthful: usize,
    runs: usize,
}

#[derive(Debug, Serialize)]
struct Row {
    title: String,
    cells: Vec<Cell>,
}

/// Errors of the deflection over the largest deflection.
#[derive(Debug, Clone, Serialize)]
struct Cell {
    intervals: usize,
    /// Largest difference from beam theory at the nodes.
    truth: f64,
    certified: f64,
}

pub(super) fn evidence(study: &Study<'_>) -> Result<Evidence, Cause> {
    let mut rows = Vec::new();
    for (_, scene) in scenes::all(study.root)? {
        let cells = GRIDS.iter().map(|&n| cell(&scene, n)).collect::<Result<Vec<_>, _>>()?;
        rows.push(Row { title: scene.title().to_owned(), cells });
    }
    let cells = || rows.iter().flat_map(|row| &row.cells);
    let data = rows.iter().flat_map(|row| {
        row.cells.iter().map(|cell| {
            let title = row.title.replace(',', ";");
            vec![title, cell.intervals.to_string(), scientific(cell.truth, 2), scientific(cell.certified, 2)]
        })
    });
    let table = csv(&["scene", "intervals", "true_error", "certified_error"], data);
    let truthful = cells().filter(|cell| cell.truth <= cell.certified).count();
    let runs = cells().count();
    Ok(Evidence::new(Values { grids: GRIDS, truthful, runs, rows }).data("bounds", table))
}

/// The force method with the active set on one grid: how far it is from beam theory, and how far it can be.
fn cell(scene: &Scene, intervals: usize) -> Result<Cell, Cause> {
    let exact = theory::solve(scene)?;
    let state = solve(scene, &Settings::new(Method::Force, Solver::ActiveSet, intervals))?.state;
    let nodes = state.nodes.ok_or("a discretised state has nodes")?;
    let forces = nodes.x.iter().copied().zip(nodes.contact_force.iter().copied());
    let load = ContactLoad::new(scene.beam().length(), forces)?;
    let certificate = certify(scene, &load, Judged::Nodes(&nodes))?;
    let largest = exact.state.deflection.max.max(-exact.state.deflection.min);
    let apart = nodes.x.iter().zip(&nodes.deflection).map(|(&x, v)| (v - exact.deflection(x)).abs());
    Ok(Cell {
        intervals,
        truth: some(apart.fold(0.0, f64::max) / largest),
        certified: certificate.deflection_error / largest,
    })
}

/// An error that is more than rounding, whose digits differ between machines.
fn some(error: f64) -> f64 {
    const ROUNDING: f64 = 1e-12;
    if error < ROUNDING { 0.0 } else { error }
}
