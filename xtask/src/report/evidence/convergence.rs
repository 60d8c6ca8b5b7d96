//! How fast the methods converge to beam theory, with the observed order.

mod uneven;

use palkki::methods::Method;
use palkki::paper::convergence::{Quantity, Series, all};
use palkki::plot::study::{ErrorSeries, convergence};
use serde::Serialize;

use crate::report::csv::{csv, scientific};
use crate::report::error::Cause;
use crate::report::evidence::Evidence;
use crate::report::study::Study;

/// Multiples of 8: deflections are compared at an eighth of the span.
const GRIDS: [u32; 7] = [16, 32, 64, 128, 256, 512, 1024];

#[derive(Debug, Serialize)]
struct Values {
    coarsest: u32,
    finest: u32,
    grids: Vec<usize>,
    methods: Vec<Table>,
    /// Whether the energy of method 1 clearly beats second order.
    differences_energy_is_fast: bool,
    /// First contact force over that of beam theory, minus one, on the grids of the claims ledger.
    first_force: Vec<FirstForce>,
    uneven: uneven::Uneven,
}

#[derive(Debug, Serialize)]
struct Table {
    method: &'static str,
    figure: String,
    rows: Vec<Row>,
}

#[derive(Debug, Serialize)]
struct Row {
    quantity: &'static str,
    errors: Vec<f64>,
    order: f64,
}

#[derive(Debug, Serialize)]
struct FirstForce {
    intervals: usize,
    error: f64,
}

pub(super) fn evidence(study: &Study<'_>) -> Result<Evidence, Cause> {
    let grids: Vec<usize> = GRIDS.iter().map(|&n| usize::try_from(n)).collect::<Result<_, _>>()?;
    let mut tables = Vec::new();
    let mut files = Vec::new();
    let mut differences_energy_is_fast = false;
    // The force method has the same nodal values as the displacement method.
    for method in [Method::Complementarity, Method::Displacement] {
        let series = all(method, &grids)?;
        let energy = series.iter().find(|s| s.quantity == Quantity::Energy);
        differences_energy_is_fast |= method == Method::Complementarity && energy.is_some_and(|s| 2.5 < s.order);
        let name = format!("convergence-{}", method.word());
        tables.push(Table { method: method.word(), figure: name.clone(), rows: series.iter().map(row).collect() });
        files.push((name, drawn(method, &series)?, table(&series)));
    }
    let first_force = study.ledger()?.usable.grids.iter();
    let first_force = first_force.map(|grid| FirstForce { intervals: grid.intervals, error: grid.first_force });
    let (uneven, drawings) = uneven::measured(study)?;
    files.extend(drawings);
    let values = Values {
        uneven,
        coarsest: GRIDS[0],
        finest: GRIDS[GRIDS.len() - 1],
        grids,
        methods: tables,
        differences_energy_is_fast,
        first_force: first_force.collect(),
    };
    Ok(files.into_iter().fold(Evidence::new(values), |with, (name, svg, csv)| with.figure(&name, svg, csv)))
}

fn row(series: &Series) -> Row {
    let errors = series.errors.iter().map(|(_, error)| *error).collect();
    Row { quantity: series.quantity.word(), errors, order: series.order }
}

fn drawn(method: Method, series: &[Series]) -> Result<String, Cause> {
    let points: Vec<Vec<[f64; 2]>> = series
        .iter()
        .map(|s| GRIDS.iter().zip(&s.errors).map(|(&n, (_, error))| [f64::from(n), *error]).collect())
        .collect();
    // The order is in the table; five slopes would cover the points.
    let drawn: Vec<ErrorSeries<'_>> = series
        .iter()
        .zip(&points)
        .map(|(s, points)| ErrorSeries { label: s.quantity.word(), points, order: None })
        .collect();
    let of = if method == Method::Complementarity { "finite differences" } else { "the energy methods" };
    let listed: Vec<String> =
        Quantity::ALL.iter().zip(series).map(|(q, s)| format!("{} with order {:.1}", q.word(), s.order)).collect();
    Ok(convergence(
        &format!("The example: errors of {of} against beam theory"),
        &format!(
            "Relative errors over the number of intervals, both axes logarithmic. They fall: {}.",
            listed.join(", ")
        ),
        "relative error",
        &drawn,
    )?)
}

fn table(series: &[Series]) -> String {
    let rows = series.iter().flat_map(|s| {
        s.errors.iter().map(|(n, error)| vec![s.quantity.word().to_owned(), n.to_string(), scientific(*error, 2)])
    });
    csv(&["quantity", "intervals", "relative_error"], rows)
}
