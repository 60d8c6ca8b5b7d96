//! Maps of verdicts over grids and routes: who says solved, and what our judge says.

use palkki::plot::PlotError;
use palkki::plot::table::{Cell, Row, Tone, verdict_map};
use serde::Serialize;

use super::lines::{Lines, intervals};
use super::{ASKED, METHODS, SOLVERS};
use crate::measure::plan::OTHERS;
use crate::measure::store::{Line, Store};
use crate::report::csv::csv;

/// What a map says.
#[derive(Debug, Serialize)]
pub(super) struct Counts {
    /// How often a solver claims a success that our judge does not see.
    wrong: usize,
    /// How many runs were judged.
    judged: usize,
    /// Rows that are certified on every grid.
    everywhere: Vec<String>,
}

/// Counts, and the figure with its numbers.
type Map = (Counts, (String, String));

/// All routes on the example.
pub(super) fn of_example(lines: &Lines<'_>) -> Result<Option<Map>, PlotError> {
    let routes = METHODS.into_iter().flat_map(|method| SOLVERS.map(|solver| format!("{method}/{solver}")));
    let rows = routes.map(|route| (route.clone(), lines.asked(&route))).collect();
    map("Verdicts over the number of intervals", rows)
}

/// The routes that are meant for fine grids on the other scenes, those of which something is measured.
pub(super) fn of_others(store: &Store) -> Result<Option<Map>, PlotError> {
    let mut rows = Vec::new();
    for scene in OTHERS {
        let lines = Lines::of(store, scene);
        for method in METHODS {
            for solver in ["active-set", "clarabel", "osqp"] {
                let route = format!("{method}/{solver}");
                let asked = lines.asked(&route);
                if asked.iter().any(|line| verdict(Some(line)).0 != Tone::Absent) {
                    rows.push((format!("{scene}: {route}"), asked));
                }
            }
        }
    }
    map("Verdicts over the number of intervals, on other scenes", rows)
}

/// None if there is nothing to judge.
fn map(title: &str, routes: Vec<(String, Vec<&Line>)>) -> Result<Option<Map>, PlotError> {
    let mut grids: Vec<usize> = routes.iter().flat_map(|(_, lines)| lines.iter().map(|line| intervals(line))).collect();
    grids.sort_unstable();
    grids.dedup();
    if grids.is_empty() {
        return Ok(None);
    }
    let mut counts = Counts { wrong: 0, judged: 0, everywhere: Vec::new() };
    let (mut data, mut rows) = (Vec::new(), Vec::new());
    for (name, lines) in &routes {
        let cells = grids.iter().map(|grid| {
            let (tone, text) = verdict(lines.iter().copied().find(|line| intervals(line) == *grid));
            counts.judged += usize::from(tone != Tone::Absent);
            counts.wrong += usize::from(text == "W");
            data.push(vec![name.clone(), grid.to_string(), text.to_owned()]);
            Cell { tone, text: text.to_owned() }
        });
        let cells: Vec<Cell> = cells.collect();
        if cells.iter().all(|cell| cell.tone == Tone::Good) {
            counts.everywhere.push(name.clone());
        }
        rows.push((name.as_str(), cells));
    }
    let columns: Vec<String> = grids.iter().map(usize::to_string).collect();
    let columns: Vec<&str> = columns.iter().map(String::as_str).collect();
    let rows: Vec<Row<'_>> = rows;
    let cell = |tone, text: &str| Cell { tone, text: text.to_owned() };
    let legend = [
        (cell(Tone::Good, "C"), "certified by our judge"),
        (cell(Tone::Bad, "W"), "the solver says solved, our judge says no"),
        (cell(Tone::Fair, "G"), "the solver gave up, or refused the size"),
        (cell(Tone::Absent, "–"), "left out: a coarser grid took too long, or not in the plan"),
    ];
    let description = format!(
        "A map: rows are routes asked for {ASKED}, columns are numbers of intervals. C certified, W claimed but wrong, G gave \
         up, – left out."
    );
    let svg = verdict_map(title, &description, &columns, &rows, &legend)?;
    Ok(Some((counts, (svg, csv(&["route", "intervals", "verdict"], data)))))
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
