//! Verdicts over grids and routes, and what a digit costs beside the force method with the active set.

use palkki::plot::PlotError;
use palkki::plot::table::{Cell, Row, Tone, verdict_map};
use serde::Serialize;

use super::{SOLVERS, asked, intervals};
use crate::measure::store::Line;
use crate::report::csv::csv;

/// The route that others are set beside.
const OURS: &str = "force/active-set";

/// Grids of the comparison.
const GRIDS: [&str; 4] = ["30", "300", "3000", "30000"];

/// Routes beside [`OURS`] on one grid.
#[derive(Debug, Serialize)]
pub(super) struct Beside {
    intervals: &'static str,
    /// Milliseconds of [`OURS`].
    milliseconds: f64,
    rows: Vec<Ratio>,
}

#[derive(Debug, Serialize)]
struct Ratio {
    route: String,
    status: String,
    /// Its time over ours.
    time: f64,
    /// Largest of its solver errors in the four observables.
    error: f64,
}

/// Every route that was measured on a grid, at the tolerance of the chapter.
pub(super) fn beside(lines: &[&Line]) -> Vec<Beside> {
    let on = |grid: &'static str| {
        let find = |route: &str| asked(lines, route).into_iter().find(|line| line.field("intervals") == Some(grid));
        let ours = find(OURS)?.seconds()?;
        let rows = routes().filter(|route| route != OURS).filter_map(|route| {
            let line = find(&route)?;
            let columns = ["reaction_solver", "contact_solver", "deflection_solver", "energy_solver"];
            let error = columns.iter().filter_map(|column| line.number(column)).fold(0.0, f64::max);
            let status = line.field("status")?.to_owned();
            Some(Ratio { time: line.seconds()? / ours, error, status, route })
        });
        Some(Beside { intervals: grid, milliseconds: 1e3 * ours, rows: rows.collect() })
    };
    GRIDS.iter().filter_map(|grid| on(grid)).collect()
}

fn routes() -> impl Iterator<Item = String> {
    let methods = ["complementarity", "displacement", "force"];
    methods.into_iter().flat_map(|method| SOLVERS.map(|solver| format!("{method}/{solver}")))
}

/// What the map says.
pub(super) struct Map {
    pub(super) svg: String,
    pub(super) csv: String,
    /// How often a solver claims a success that our judge does not see.
    pub(super) wrong: usize,
    /// How many runs were judged.
    pub(super) judged: usize,
    /// Routes that are certified on every grid.
    pub(super) everywhere: Vec<String>,
}

/// The map and its numbers.
pub(super) fn map(lines: &[&Line]) -> Result<Map, PlotError> {
    let mut columns: Vec<(f64, String)> = Vec::new();
    for route in routes() {
        for line in asked(lines, &route) {
            let (n, name) = (intervals(line), line.field("intervals").unwrap_or("–").to_owned());
            if !columns.iter().any(|(_, known)| *known == name) {
                columns.push((n, name));
            }
        }
    }
    columns.sort_by(|a, b| a.0.total_cmp(&b.0));
    let (mut wrong, mut judged, mut data, mut everywhere) = (0, 0, Vec::new(), Vec::new());
    let mut rows: Vec<(String, Vec<Cell>)> = Vec::new();
    for route in routes() {
        let found = asked(lines, &route);
        let cells = columns.iter().map(|(_, name)| {
            let line = found.iter().find(|line| line.field("intervals") == Some(name));
            let (tone, text) = verdict(line.copied());
            judged += usize::from(tone != Tone::Absent);
            wrong += usize::from(text == "W");
            data.push(vec![route.clone(), name.clone(), text.to_owned()]);
            Cell { tone, text: text.to_owned() }
        });
        let cells: Vec<Cell> = cells.collect();
        if cells.iter().all(|cell| cell.tone == Tone::Good) {
            everywhere.push(route.clone());
        }
        rows.push((route, cells));
    }
    let names: Vec<&str> = columns.iter().map(|(_, name)| name.as_str()).collect();
    let rows: Vec<Row<'_>> = rows.iter().map(|(name, cells)| (name.as_str(), cells.clone())).collect();
    let cell = |tone, text: &str| Cell { tone, text: text.to_owned() };
    let legend = [
        (cell(Tone::Good, "C"), "certified by our judge"),
        (cell(Tone::Bad, "W"), "the solver says solved, our judge says no"),
        (cell(Tone::Fair, "G"), "the solver gave up, or refused the size"),
        (cell(Tone::Absent, "–"), "left out: a coarser grid took too long, or not in the plan"),
    ];
    let svg = verdict_map(
        "Verdicts over the number of intervals",
        "A map: rows are routes, columns are numbers of intervals. C certified, W claimed but wrong, G gave up, – left out.",
        &names,
        &rows,
        &legend,
    )?;
    Ok(Map { svg, csv: csv(&["route", "intervals", "verdict"], data), wrong, judged, everywhere })
}

fn verdict(line: Option<&Line>) -> (Tone, &'static str) {
    let Some(line) = line else { return (Tone::Absent, "–") };
    if line.field("status") == Some("refused") {
        return (Tone::Fair, "G");
    }
    if line.seconds().is_none() {
        return (Tone::Absent, "–");
    }
    match (line.field("status"), line.field("claims")) {
        (Some("certified"), _) => (Tone::Good, "C"),
        (_, Some("success")) => (Tone::Bad, "W"),
        _ => (Tone::Fair, "G"),
    }
}
