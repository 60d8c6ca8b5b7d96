//! The adaptive grid: an error that is demanded, the grid that it takes, and the error that is true.

use palkki::adaptive::{Adapted, End, Request, adapt};
use palkki::plot::{Axis, Figure, Layer, Panel, PlotError, Style};
use palkki::theory::Exact;

use super::prelude::*;

/// Scenes of the figure.
const SCENES: [&str; 2] = ["heinisuo-1984", "ridge"];
/// Powers of ten that are demanded, of these scenes and of every scene of the gallery.
const DEMANDED: [i32; 8] = [-1, -2, -3, -4, -5, -6, -7, -8];
const EVERYWHERE: [i32; 3] = [-2, -4, -6];

/// At most so many intervals in every scene: a second for all of them.
const MOST: usize = 20_000;

/// Routes of the figure, and the finest grid that each may try here: a report is made within seconds.
const ROUTES: [(Method, Solver, usize); 5] = [
    (Method::Force, Solver::ActiveSet, 50_000),
    (Method::Complementarity, Solver::ActiveSet, 20_000),
    (Method::Force, Solver::Clarabel, 3_000),
    (Method::Displacement, Solver::Osqp, 250),
    (Method::Force, Solver::FourStep, 500),
];

/// True errors below this are rounding, and are printed as this.
const FLOOR: f64 = 1e-13;

/// One demand on one scene by one route.
#[derive(Debug)]
struct Run {
    scene: &'static str,
    route: String,
    exponent: i32,
    found: Adapted,
    /// The largest difference of a nodal deflection from the exact solution, over the largest deflection.
    truth: f64,
}

impl Run {
    fn reached(&self) -> bool {
        self.found.end == End::Reached
    }

    /// Unknowns that all solves went through, over all grids.
    fn work(&self) -> usize {
        self.found.trials.iter().map(|tried| tried.work).sum()
    }

    fn is_of(&self, scene: &str, (method, solver, _): (Method, Solver, usize)) -> bool {
        self.scene == scene && self.route == format!("{method}/{solver}")
    }
}

pub(super) fn evidence(study: &Study<'_>) -> Result<Evidence, Cause> {
    let mut runs = Vec::new();
    for name in SCENES {
        let scene = scenes::read(study.root, name)?;
        let exact = theory::solve(&scene)?;
        for (method, solver, most_intervals) in ROUTES {
            for exponent in DEMANDED {
                let request = Request { most_intervals, ..Request::new(method, solver, ten_to(exponent)) };
                let found = adapt(&scene, &request)?;
                let truth = truth(&found, &exact)?;
                let run = Run { scene: name, route: format!("{method}/{solver}"), exponent, found, truth };
                // A smaller error ends in the same place.
                let ended = !run.reached();
                runs.push(run);
                if ended {
                    break;
                }
            }
        }
    }
    let (everywhere, everywhere_data) = everywhere(study)?;
    let (svg, data) = drawn(&runs)?;
    Ok(Evidence::new(context! {
        steps => steps(&runs),
        limits => limits(&runs),
        everywhere,
        most => MOST,
        runs => runs.len(),
        truthful => runs.iter().filter(|run| run.truth <= run.found.solution.verdict.error).count(),
    })
    .figure("adaptive", svg, data)
    .data("adaptive-everywhere", everywhere_data))
}

fn truth(found: &Adapted, exact: &Exact) -> Result<f64, Cause> {
    let nodes = nodes_of(&found.solution.state)?;
    let apart = nodes.x.iter().zip(&nodes.deflection).map(|(&x, v)| (v - exact.deflection(x)).abs());
    // The same size as that of the certified error.
    let deflection = found.solution.state.deflection;
    Ok(apart.fold(0.0, f64::max) / deflection.max.max(-deflection.min))
}

/// The grids of the force method with the active set on the example, demand by demand.
fn steps(runs: &[Run]) -> Table {
    let ours = runs.iter().filter(|run| run.is_of(SCENES[0], ROUTES[0]));
    let rows = ours.map(|run| {
        let grids: Vec<String> = run.found.trials.iter().map(|tried| tried.intervals.to_string()).collect();
        let [certified, truth] = [run.found.solution.verdict.error, run.truth].map(|error| cell(Some(error), 2));
        [power_of_ten(run.exponent), grids.join(", "), certified, truth, count(run.work())]
    });
    Table::new(["EPS", "grids tried, intervals", "certified error", "true error", "unknowns gone through"]).rows(rows)
}

/// How small an error each route reaches with the grids that it may try, and what ends it.
fn limits(runs: &[Run]) -> Table {
    let header = ["method and solver", "smallest EPS on the example", "smallest EPS over a ridge", "what ends it"];
    let rows = ROUTES.map(|route| {
        let of_scene = |scene| runs.iter().filter(move |run| run.is_of(scene, route));
        let smallest = SCENES.map(|scene| {
            let reached = of_scene(scene).filter(|run| run.reached()).map(|run| run.exponent).min();
            reached.map_or_else(|| "none".to_owned(), power_of_ten)
        });
        let last = of_scene(SCENES[1]).next_back();
        let [example, ridge] = smallest;
        [format!("{}, {}", route.0, route.1), example, ridge, last.map_or_else(String::new, |run| ended(run.found.end))]
    });
    Table::new(header).rows(rows)
}

/// In few words; residuals in them would be rounding.
fn ended(end: End) -> String {
    match end {
        End::Reached => "nothing smaller was demanded".to_owned(),
        End::Limit { intervals } => format!("its limit of intervals here, {}", count(intervals)),
        End::Failed { intervals, .. } => format!("its answer fails our check on {} intervals", count(intervals)),
        End::Spent { intervals, .. } => format!("its limit of work, at {} intervals", count(intervals)),
        End::Stalled { intervals } => format!("finer grids do not help up to {} intervals", count(intervals)),
    }
}

/// The grid that the force method with the active set takes on every scene of the gallery.
fn everywhere(study: &Study<'_>) -> Result<(Table, Table), Cause> {
    let header = EVERYWHERE.map(|exponent| format!("EPS = {}: intervals (certified error)", power_of_ten(exponent)));
    let mut table = Table::new(row!["scene"].into_iter().chain(header));
    let mut data = Table::new(["scene", "demanded", "end", "intervals", "certified_error"]);
    for (name, scene) in scenes::all(study.root)? {
        let mut cells = row![name].to_vec();
        for exponent in EVERYWHERE {
            let request = Request::new(Method::Force, Solver::ActiveSet, ten_to(exponent));
            let found = adapt(&scene, &Request { most_intervals: MOST, ..request })?;
            let intervals = found.settings.intervals;
            let error = Some(found.solution.verdict.error).filter(|error| error.is_finite());
            let reached = found.end == End::Reached;
            let shown = error_cell(error);
            cells.push(if reached {
                format!("{} ({shown})", count(intervals))
            } else {
                format!("not reached ({shown})")
            });
            let error = error.map_or_else(String::new, |error| scientific(error, 2));
            data.push(row![name, format!("1e{exponent}"), end_name(reached), intervals, error]);
        }
        table.push(cells);
    }
    Ok((table, data))
}

fn end_name(reached: bool) -> &'static str {
    if reached { "reached" } else { "not reached" }
}

/// Certified errors over what is demanded: a panel for each scene, a line for each route.
fn drawn(runs: &[Run]) -> Result<(String, Table), PlotError> {
    let panels = SCENES.map(|scene| {
        let y = Axis::new(format!("certified error, {scene}")).log();
        let diagonal = vec![[1e-8, 1e-8], [1e-1, 1e-1]];
        let panel = Panel::new(Axis::new("error that is demanded, EPS").log(), y).tall(520.0);
        let demanded = Layer::Series { points: diagonal, style: Style::theory(), label: "demanded".to_owned() };
        ROUTES.into_iter().enumerate().fold(panel.with(demanded), |panel, (i, route)| {
            let reached = runs.iter().filter(|run| run.is_of(scene, route) && run.reached());
            // From small errors to large ones: names stand at the right.
            let points = reached.rev().map(|run| [ten_to(run.exponent), run.found.solution.verdict.error]).collect();
            let label = format!("{}, {}", route.0, route.1);
            panel.with(Layer::Series { points, style: Style::of_series(i), label })
        })
    });
    let header = ["scene", "route", "demanded", "end", "intervals", "certified_error", "true_error", "work"];
    let data = Table::new(header).rows(runs.iter().map(|run| {
        let errors = [run.found.solution.verdict.error, run.truth.max(FLOOR)].map(|error| scientific(error, 2));
        let (demanded, intervals) = (format!("1e{}", run.exponent), run.found.settings.intervals);
        row![run.scene, run.route, demanded, end_name(run.reached()), intervals, errors[0], errors[1], run.work()]
    }));
    let figure = Figure::new(
        "The certified error is at most what was demanded",
        "Two scenes, one panel each: the certified error over the error that is demanded, both logarithmic, one line for each \
         route. All lie below the dashed diagonal; each line ends where its route does.",
        panels.into(),
    );
    Ok((figure.svg()?, data))
}
