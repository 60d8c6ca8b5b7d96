//! Work and precision: forward error against time, one panel for each observable, one line for each solver.

use palkki::plot::{Axis, Figure, Layer, Panel, PlotError, Style};

use super::SOLVERS;
use super::lines::{Lines, TOTAL, finite};
use crate::measure::plan::EXAMPLE;
use crate::report::csv::{csv, scientific};

/// Errors below this are drawn here: they are rounding.
const FLOOR: f64 = 1e-14;

/// One figure for a method: grids and tolerances of a solver become the frontier of what it can do in a given time.
/// None where nothing of it was measured.
pub(super) fn drawn(scene: &str, method: &str, lines: &Lines<'_>) -> Result<Option<(String, String)>, PlotError> {
    let mut rows = Vec::new();
    let panels = OBSERVABLES.iter().zip(TOTAL).map(|(observable, column)| {
        let x = Axis::new("time").unit(Some("s".to_owned())).log();
        let y = Axis::new(format!("relative error: {observable}")).log();
        let mut panel = Panel::new(x, y).tall(620.0);
        for (i, solver) in SOLVERS.iter().enumerate() {
            let points = frontier(lines, &format!("{method}/{solver}"), column);
            rows.extend(points.iter().map(|p| {
                vec![(*observable).to_owned(), (*solver).to_owned(), scientific(p[0], 3), scientific(p[1], 2)]
            }));
            if !points.is_empty() {
                let (style, label) = (Style::of_series(i), (*solver).to_owned());
                panel = panel.with(Layer::Series { points, style, label });
            }
        }
        let exact = frontier(lines, "exact/free-boundary", column);
        if exact.is_empty() {
            return panel;
        }
        let style = Style::marks(palkki::plot::Color::BLACK, palkki::plot::Marker::OpenCircle);
        panel.with(Layer::Series { points: exact, style, label: "beam theory".to_owned() })
    });
    let panels: Vec<Panel> = panels.collect();
    if rows.is_empty() {
        return Ok(None);
    }
    let title = match scene {
        EXAMPLE => format!("Forward error against time: {method} method"),
        _ => format!("Forward error against time: {method} method, scene {scene}"),
    };
    let svg = Figure { columns: 2, ..Figure::new(
        title,
        "Four panels, one for each observable: relative error against beam theory over the time of a solve, both axes \
         logarithmic, one line for each solver. Each point is a grid and a tolerance that nothing quicker beats.",
        panels,
    ) }
    .svg()?;
    Ok(Some((svg, csv(&["observable", "solver", "seconds", "relative_error"], rows))))
}

/// Points `[seconds, error]` that no quicker point of the route beats.
fn frontier(lines: &Lines<'_>, route: &str, column: &str) -> Vec<[f64; 2]> {
    let mut points: Vec<[f64; 2]> = lines
        .of_route(route)
        .filter_map(|line| Some([line.seconds()?, finite(line, column)?]))
        .map(|[seconds, error]| [seconds, error.max(FLOOR)])
        .collect();
    points.sort_by(|a, b| a[0].total_cmp(&b[0]));
    let mut best = f64::INFINITY;
    points.retain(|point| {
        let better = point[1] < best;
        best = best.min(point[1]);
        better
    });
    points
}

const OBSERVABLES: [&str; 4] = ["end reaction", "largest contact force", "deflection", "energy"];
