//! The CSV file of `--csv`: values along the beam.

use palkki::scene::Scene;
use palkki::state::Nodes;
use palkki::theory::{Exact, Sample};

use super::answer::Answer;

/// Columns of a discretised answer: position, deflection (positive downwards), clearance above the foundation, contact force (a force
/// at the node, not a density) and bending moment (positive with the underside in tension).
const NODES: &str = "x,deflection,clearance,contact_force,moment";

/// Columns of the exact answer. Pressure is a density and does not contain the concentrated contact forces, which are the jumps of
/// the shear force. Where a value jumps, a position has two rows, for its left and its right side.
const SAMPLES: &str = "x,deflection,slope,clearance,pressure,moment,shear";

/// Number of equal intervals between samples of the exact solution: drawn the width of a hand, they show no corners.
const INTERVALS: u32 = 240;

/// One row for each interior node, or for each sample of the exact solution. Numbers read back as the same `f64`. The clearance is
/// empty where there is no foundation.
pub(super) fn table(scene: &Scene, answer: &Answer) -> String {
    match (&answer.solution.exact, answer.nodes()) {
        (Some(exact), _) => of_samples(scene, exact),
        (None, Some(nodes)) => of_nodes(nodes),
        (None, None) => of_nodes(&Nodes::default()),
    }
}

fn of_nodes(nodes: &Nodes) -> String {
    let columns = [&nodes.x, &nodes.deflection, &nodes.clearance, &nodes.contact_force, &nodes.moment];
    rows(NODES, (0..nodes.x.len()).map(|i| columns.map(|column| column.get(i).copied().unwrap_or(f64::NAN))))
}

fn of_samples(scene: &Scene, exact: &Exact) -> String {
    let row = |s: Sample| [s.x, s.deflection, s.slope, s.clearance, s.pressure, s.moment, s.shear];
    rows(SAMPLES, exact.samples(scene, INTERVALS).into_iter().map(row))
}

fn rows<const COLUMNS: usize>(header: &str, rows: impl Iterator<Item = [f64; COLUMNS]>) -> String {
    let rows = rows.map(|row| row.map(field).join(",") + "\n");
    std::iter::once(format!("{header}\n")).chain(rows).collect()
}

/// The shortest text that reads back as the same number; empty for a number that is not finite.
pub(super) fn field(value: f64) -> String {
    if value.is_finite() { format!("{value:?}") } else { String::new() }
}
