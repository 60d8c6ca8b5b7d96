//! Guaranteed bounds for the continuous beam, beside the true errors, on every scene of the gallery; and for forces that
//! somebody brought.

mod brought;
mod springs;

use palkki::certificate::{ACCEPTED_ERROR, ContactLoad, Judged, certify};
use palkki::methods::Method;
use palkki::plot::{Axis, Figure, Layer, Panel, PlotError, Style};
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
    /// Springs, libraries, the paper.
    brought: Vec<brought::Row>,
    /// Intervals between the springs.
    spaced: usize,
    /// The softest and the stiffest springs.
    softest: brought::Row,
    stiffest: brought::Row,
    /// Share of the largest deflection to which it has to be certain.
    accepted: f64,
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
    let springs = brought::of_springs()?;
    let (svg, springs_csv) = of_springs(&springs)?;
    let nothing = || "no springs were tried";
    let softest = springs.first().ok_or_else(nothing)?.1.clone();
    let stiffest = springs.last().ok_or_else(nothing)?.1.clone();
    let mut all: Vec<brought::Row> = springs.into_iter().map(|(_, row)| row).collect();
    all.extend(brought::of_libraries(study)?);
    all.extend(brought::of_the_paper()?);
    let values = Values {
        grids: GRIDS,
        truthful,
        runs,
        rows,
        brought: all,
        spaced: brought::SPACED,
        softest,
        stiffest,
        accepted: ACCEPTED_ERROR,
    };
    Ok(Evidence::new(values).data("bounds", table).figure("springs", svg, springs_csv))
}

/// The figure of the springs, and its numbers.
fn of_springs(springs: &[(i32, brought::Row)]) -> Result<(String, String), PlotError> {
    let line = |value: fn(&brought::Row) -> Option<f64>| {
        let point = |(exponent, row): &(i32, brought::Row)| Some([10_f64.powi(*exponent), value(row)?]);
        springs.iter().filter_map(point).collect::<Vec<_>>()
    };
    let lines = [
        ("certified error of the deflection", line(|row| row.certified)),
        ("worst violation", line(|row| Some(row.relative))),
        ("true error of the end reaction", line(|row| row.reaction)),
    ];
    let x = Axis::new("stiffness of a spring over that of the beam, k l³/48EI").log();
    let mut panel = Panel::new(x, Axis::new("relative error").log()).tall(700.0);
    let mut rows = Vec::new();
    for (i, (label, points)) in lines.into_iter().enumerate() {
        rows.extend(points.iter().map(|p| vec![label.to_owned(), scientific(p[0], 0), scientific(p[1], 2)]));
        panel = panel.with(Layer::Series { points, style: Style::of_series(i), label: label.to_owned() });
    }
    let svg = Figure::new(
        "Springs instead of a rigid foundation",
        "Relative errors over the stiffness of the springs, both axes logarithmic: the certified error of the deflection, the worst \
         violation and the true error of the end reaction fall as the springs become stiffer, until the grid is what remains.",
        vec![panel],
    )
    .svg()?;
    Ok((svg, csv(&["quantity", "stiffness_ratio", "relative_error"], rows)))
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
