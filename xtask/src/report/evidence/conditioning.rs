//! Forward error, residual, and what the condition number promises: every route on the example, against eighty digits.

mod grazing;
mod matrix;
mod routes;
mod wide;

use palkki::methods::Method;
use palkki::plot::{Axis, Figure, Layer, Panel, PlotError, Style};
use serde::Serialize;

use crate::report::csv::csv;
use crate::report::error::Cause;
use crate::report::evidence::Evidence;
use crate::report::numbers::power;
use crate::report::study::Study;

use self::routes::{Grid, NAMES, Run};

#[derive(Debug, Serialize)]
struct Values {
    names: [&'static str; 6],
    methods: Vec<Table>,
    finest: usize,
    /// Worst errors of the active set over all methods and grids: end reaction and deflection; and of a contact force, on
    /// all grids but the finest and on that one.
    active_set: [String; 4],
    /// What residual and condition number promise for the active set at worst.
    promised: String,
    /// The solver that is certified with the worst contact force, on which grid, with which residual and error.
    certified: Certified,
    grazing: grazing::Values,
}

/// A run that passes the judge.
#[derive(Debug, Serialize)]
struct Certified {
    runs: usize,
    route: String,
    intervals: usize,
    residual: String,
    error: String,
}

#[derive(Debug, Serialize)]
struct Table {
    method: &'static str,
    figure: String,
    /// The last grid on which the factorised matrix passes the judge.
    matrix_until: usize,
    rows: Vec<Row>,
}

/// One grid.
#[derive(Debug, Serialize)]
struct Row {
    intervals: usize,
    condition: String,
    cells: Vec<Option<Cell>>,
}

/// The error of the largest contact force over the load, and what residual and condition number promise; powers of ten.
#[derive(Debug, Serialize)]
struct Cell {
    error: String,
    promised: String,
    certified: bool,
}

pub(super) fn evidence(_: &Study<'_>) -> Result<Evidence, Cause> {
    let (mut tables, mut files, mut all): (_, _, Vec<(Method, Grid)>) = (Vec::new(), Vec::new(), Vec::new());
    for method in Method::ALL {
        let grids = routes::measured(method)?;
        let figure = format!("conditioning-{}", method.word());
        files.push((figure.clone(), drawn(method, &grids)?, table(&grids)));
        tables.push(Table {
            method: method.word(),
            figure,
            matrix_until: matrix_until(&grids),
            rows: grids.iter().map(row).collect(),
        });
        all.extend(grids.into_iter().map(|grid| (method, grid)));
    }
    let finest = all.iter().map(|(_, grid)| grid.intervals).max().unwrap_or_default();
    let (grazing, svg, data) = grazing::measured()?;
    let values = Values {
        names: NAMES,
        methods: tables,
        finest,
        active_set: [
            worst(&all, |run, _| Some(run.reaction)),
            worst(&all, |run, _| Some(run.deflection)),
            worst(&all, |run, grid| (grid.intervals < finest).then_some(run.contact_force)),
            worst(&all, |run, grid| (grid.intervals == finest).then_some(run.contact_force)),
        ],
        promised: worst(&all, |run, grid| Some(run.promised(grid))),
        certified: certified(&all)?,
        grazing,
    };
    let evidence = Evidence::new(values).figure("conditioning-grazing", svg, data);
    Ok(files.into_iter().fold(evidence, |with, (name, svg, csv)| with.figure(&name, svg, csv)))
}

/// The largest of some powers of ten of the active set.
fn worst(all: &[(Method, Grid)], of: impl Fn(&Run, &Grid) -> Option<i32>) -> String {
    let runs = all.iter().flat_map(|(_, grid)| grid.runs.iter().map(move |run| (run, grid)));
    let of_active_set = runs.filter(|(run, _)| run.name == "active-set").filter_map(|(run, grid)| of(run, grid));
    power(of_active_set.max().unwrap_or_default())
}

/// The certified run of an iterative solver with the worst contact force.
fn certified(all: &[(Method, Grid)]) -> Result<Certified, Cause> {
    let runs = all.iter().flat_map(|(method, grid)| grid.runs.iter().map(move |run| (method, grid, run)));
    let runs: Vec<_> =
        runs.filter(|(_, _, run)| run.certified && ["nsor", "clarabel", "osqp"].contains(&run.name)).collect();
    let worst = runs.iter().max_by_key(|(_, grid, run)| (run.contact_force, std::cmp::Reverse(grid.intervals)));
    let (method, grid, run) = worst.ok_or("some run of a library is certified")?;
    Ok(Certified {
        runs: runs.len(),
        route: format!("{method} / {}", run.name),
        intervals: grid.intervals,
        residual: power(run.residual),
        error: power(run.contact_force),
    })
}

fn matrix_until(grids: &[Grid]) -> usize {
    let passes = |grid: &&Grid| grid.runs.iter().any(|run| run.name == "matrix" && run.certified);
    grids.iter().take_while(passes).last().map_or(0, |grid| grid.intervals)
}

fn row(grid: &Grid) -> Row {
    let cell = |name: &&str| {
        let run = grid.runs.iter().find(|run| run.name == *name)?;
        let (error, promised) = (power(run.contact_force), power(run.promised(grid)));
        Some(Cell { error, promised, certified: run.certified })
    };
    Row { intervals: grid.intervals, condition: power(grid.condition), cells: NAMES.iter().map(cell).collect() }
}

/// `10ᵏ`
fn ten_to(exponent: i32) -> f64 {
    format!("1e{exponent}").parse().unwrap_or(f64::NAN)
}

#[expect(clippy::cast_precision_loss, reason = "grids stay far below 2⁵³ intervals")]
fn drawn(method: Method, grids: &[Grid]) -> Result<String, PlotError> {
    let y = Axis::new("error of a contact force over the load").log();
    let mut panel = Panel::new(Axis::new("intervals N").log(), y).tall(760.0);
    let place = |grid: &Grid, exponent: i32| [grid.intervals as f64, ten_to(exponent)];
    for (i, name) in NAMES.iter().enumerate() {
        let of_route = |grid: &Grid| {
            grid.runs.iter().find(|run| run.name == *name).map(|run| place(grid, run.contact_force.min(0)))
        };
        let points: Vec<_> = grids.iter().filter_map(of_route).collect();
        if !points.is_empty() {
            panel = panel.with(Layer::Series { points, style: Style::of_series(i), label: (*name).to_owned() });
        }
    }
    let promise = |grid: &Grid| {
        let run = grid.runs.iter().find(|run| run.name == "active-set")?;
        Some(place(grid, run.promised(grid).min(0)))
    };
    let points = grids.iter().filter_map(promise).collect();
    panel =
        panel.with(Layer::Series { points, style: Style::theory(), label: "residual · cond, active-set".to_owned() });
    Figure::new(
        format!("Forward error of contact forces: {} method", method.word()),
        "Error of the worst contact force against eighty digits over the number of intervals, both axes logarithmic, rounded up to \
         powers of ten; one line for each solver, one for the factorised matrix, which rises with the fourth power of the number \
         of intervals, and dashed what residual times condition number promises for the active set.",
        vec![panel],
    )
    .svg()
}

fn table(grids: &[Grid]) -> String {
    let rows = grids.iter().flat_map(|grid| {
        grid.runs.iter().map(|run| {
            let printed = [run.residual, run.promised(grid), run.reaction, run.deflection, run.contact_force]
                .map(|k| k.to_string());
            let mut row = vec![run.name.to_owned(), grid.intervals.to_string(), grid.condition.to_string()];
            row.extend(printed);
            row
        })
    });
    let header = ["solver", "intervals", "log10_condition", "log10_residual", "log10_promised", "log10_reaction_error"];
    csv(&[&header[..], &["log10_deflection_error", "log10_contact_force_error"]].concat(), rows)
}

#[cfg(test)]
mod tests {
    use palkki::methods::Method;

    use super::{grazing, routes};

    /// Certified, every power of ten of the condition number in its residual, and nothing of it in its error.
    #[test]
    fn the_active_set_has_an_error_of_rounding_where_the_condition_number_promises_nothing() {
        for method in Method::ALL {
            let grid = routes::grid(&palkki::paper::example().expect("well posed"), method, 1000).expect("a grid");
            let run = grid.runs.iter().find(|run| run.name == "active-set").expect("it goes that far");
            assert!(run.certified && -4 < run.promised(&grid), "{method}: {run:?}");
            // Contact forces near lift-off lose a factor n; a few units in the last place of that, and the margin of three.
            assert!(run.contact_force <= -12 && run.reaction.max(run.deflection) <= -14, "{method}: {run:?}");
        }
    }

    /// What the errors are measured against is no contact force at all.
    #[test]
    fn contact_without_pressure_has_none() {
        /// Rounding of a depth, a few units in the last place, is worth some thousand times as much force here.
        const ROUNDING: f64 = 1e-12;
        for method in Method::ALL {
            let (found, load) = grazing::reference(method).expect("a scene of the example");
            let worst = found.iter().fold(0.0_f64, |most, p| most.max(p.abs()));
            assert!(worst <= ROUNDING * load, "{method}: {worst:e}");
        }
    }

    #[test]
    fn errors_at_contact_without_pressure_go_with_the_root_of_the_tolerance() {
        let (values, _, _) = grazing::measured().expect("scenes of the example");
        for row in &values.rows {
            for (grazing, pressed) in row.grazing.iter().zip(row.pressed) {
                // Iterations end where they end: a step of the path is a power of ten or two, over seven powers of ten.
                assert!((grazing - 0.5).abs() < 0.1, "{}: exponent {grazing:.2}", row.method);
                assert!(0.8 < pressed, "{}: exponent {pressed:.2}", row.method);
            }
        }
    }
}
