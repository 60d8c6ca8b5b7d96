//! Cost against the number of intervals, with the fitted exponent.

use palkki::plot::{Axis, Figure, Layer, Panel, PlotError, Style};
use palkki::verification::observed_order;
use serde::Serialize;

use super::lines::{Lines, place};
use super::{METHODS, SOLVERS};
use crate::report::csv::{csv, scientific};

/// How the time of a route grows.
#[derive(Debug, Serialize)]
pub(super) struct Exponent {
    route: String,
    /// Finest grid that was measured.
    finest: f64,
    /// Slope of the time over the intervals, on grids of 100 intervals and more.
    exponent: Option<f64>,
    /// Iterations there.
    iterations: String,
    /// Seconds there.
    seconds: f64,
    /// Nanoseconds there for each unknown.
    per_unknown: f64,
}

/// The figure with its numbers.
type Drawn = (String, String);

/// The figure, if there is anything to draw, and the exponents.
pub(super) fn drawn(lines: &Lines<'_>) -> Result<(Option<Drawn>, Vec<Exponent>), PlotError> {
    let (mut rows, mut exponents) = (Vec::new(), Vec::new());
    let mut panels = Vec::new();
    for method in METHODS {
        let x = Axis::new("intervals N").log();
        let y = Axis::new(format!("{method} method, time")).unit(Some("s".to_owned())).log();
        let mut panel = Panel::new(x, y).tall(620.0);
        for (i, solver) in SOLVERS.iter().enumerate() {
            let route = format!("{method}/{solver}");
            let found = lines.asked(&route);
            let points: Vec<[f64; 2]> = found.iter().filter_map(|line| Some([place(line), line.seconds()?])).collect();
            let Some(&[finest, seconds]) = points.last() else { continue };
            rows.extend(points.iter().map(|p| vec![route.clone(), format!("{}", p[0]), scientific(p[1], 3)]));
            let fine: Vec<(f64, f64)> = points.iter().filter(|p| 100.0 <= p[0]).map(|p| (p[0], p[1])).collect();
            let slope = observed_order(&fine);
            let last = found.iter().rfind(|line| line.seconds().is_some());
            exponents.push(Exponent {
                route,
                finest,
                exponent: slope.is_finite().then_some(slope),
                iterations: last.and_then(|line| line.field("iterations")).unwrap_or("–").to_owned(),
                seconds,
                per_unknown: 1e9 * seconds / finest,
            });
            let (style, label) = (Style::of_series(i), (*solver).to_owned());
            panel = panel.with(Layer::Series { points, style, label });
        }
        if rows.iter().any(|row: &Vec<String>| row[0].starts_with(method)) {
            panels.push(panel);
        }
    }
    if panels.is_empty() {
        return Ok((None, exponents));
    }
    let svg = Figure::new(
        "Time of a solve over the number of intervals",
        "Three panels, one for each method: seconds of a solve over the number of intervals, both axes logarithmic, one line for \
         each solver. The active set grows slowest and reaches the finest grids.",
        panels,
    )
    .svg()?;
    Ok((Some((svg, csv(&["route", "intervals", "seconds"], rows))), exponents))
}
