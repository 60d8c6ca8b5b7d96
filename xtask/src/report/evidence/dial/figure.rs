//! Certified error, true error and work over what is demanded.

use palkki::plot::{Axis, Color, Figure, Layer, Marker, Panel, PlotError, Style};

use super::{Run, SCENES, as_number};
use crate::report::csv::{csv, scientific};

/// True errors below this are rounding, and are drawn here.
const FLOOR: f64 = 1e-13;

/// The figure and its numbers: for each scene a panel of errors and one of work, one line for each route.
pub(super) fn drawn(runs: &[Run]) -> Result<(String, String), PlotError> {
    let panels: Vec<Panel> = SCENES.iter().flat_map(|scene| [errors(runs, scene), work(runs, scene)]).collect();
    let rows = runs.iter().map(|run| {
        vec![
            run.scene.to_owned(),
            run.route.clone(),
            format!("1e{}", run.exponent),
            if run.reached { "reached" } else { "not reached" }.to_owned(),
            run.intervals.to_string(),
            scientific(run.certified, 2),
            scientific(run.truth.max(FLOOR), 2),
            run.work.to_string(),
        ]
    });
    let header = ["scene", "route", "demanded", "end", "intervals", "certified_error", "true_error", "work"];
    let figure = Figure::new(
        "The dial: errors demanded, certified and true, and the work",
        "Two scenes, two panels each. On the left the certified errors of all routes and the true errors over the error that is \
         demanded: all lie below the diagonal. On the right the work, unknowns gone through, over the error that is demanded: \
         it grows as the error becomes smaller, and each line ends where its route does.",
        panels,
    );
    Ok((Figure { columns: 2, ..figure }.svg()?, csv(&header, rows)))
}

fn axis() -> Axis {
    Axis::new("error that is demanded, EPS").log()
}

/// Routes in their order, each with its runs that reached what was demanded.
fn routes<'a>(runs: &'a [Run], scene: &str) -> Vec<(&'a str, Vec<&'a Run>)> {
    let mut routes: Vec<(&str, Vec<&Run>)> = Vec::new();
    for run in runs.iter().filter(|run| run.scene == scene && run.reached) {
        match routes.last_mut() {
            Some((route, found)) if *route == run.route => found.push(run),
            _ => routes.push((&run.route, vec![run])),
        }
    }
    routes
}

fn points(runs: &[&Run], value: impl Fn(&Run) -> f64) -> Vec<[f64; 2]> {
    runs.iter().map(|run| [10_f64.powi(run.exponent), value(run)]).collect()
}

fn errors(runs: &[Run], scene: &str) -> Panel {
    let mut panel = Panel::new(axis(), Axis::new(format!("{scene}: relative error")).log()).tall(620.0);
    let diagonal = [[1e-1, 1e-1], [1e-8, 1e-8]].to_vec();
    panel = panel.with(Layer::Series { points: diagonal, style: Style::theory(), label: "demanded".to_owned() });
    for (i, (route, found)) in routes(runs, scene).into_iter().enumerate() {
        let certified = points(&found, |run| run.certified);
        panel = panel.with(Layer::Series { points: certified, style: Style::of_series(i), label: route.to_owned() });
        if i == 0 {
            let truth = points(&found, |run| run.truth.max(FLOOR));
            let style = Style::marks(Color::BLACK, Marker::OpenCircle);
            panel = panel.with(Layer::Series { points: truth, style, label: format!("{route}, true error") });
        }
    }
    panel
}

fn work(runs: &[Run], scene: &str) -> Panel {
    let y = Axis::new(format!("{scene}: work, unknowns gone through")).log();
    let mut panel = Panel::new(axis(), y).tall(620.0);
    for (i, (route, found)) in routes(runs, scene).into_iter().enumerate() {
        let work = points(&found, |run| as_number(run.work.max(1)));
        panel = panel.with(Layer::Series { points: work, style: Style::of_series(i), label: route.to_owned() });
    }
    panel
}
