//! The dial: an error that is demanded, the grid that it takes, and the error that is true.

mod figure;

use palkki::dial::{Dialled, End, Request, dial};
use palkki::route::{Method, Solver};
use palkki::scene::Scene;
use palkki::theory::{self, Exact};
use serde::Serialize;

use crate::report::csv::{csv, scientific};
use crate::report::error::Cause;
use crate::report::evidence::Evidence;
use crate::report::numbers::power;
use crate::report::scenes;
use crate::report::study::Study;

/// Scenes of the figure.
const SCENES: [&str; 2] = ["heinisuo-1984", "ridge"];
/// Powers of ten that are demanded.
const DEMANDED: [i32; 8] = [-1, -2, -3, -4, -5, -6, -7, -8];
/// Powers of ten that are demanded in every scene of the gallery.
const EVERYWHERE: [i32; 3] = [-2, -4, -6];

/// At most so many intervals there: a second for all scenes.
const EVERYWHERE_INTERVALS: usize = 20_000;

/// Routes of the figure, and the finest grid that each may try here: a report is made within seconds.
const ROUTES: [(Method, Solver, usize); 5] = [
    (Method::Force, Solver::ActiveSet, 50_000),
    (Method::Complementarity, Solver::ActiveSet, 20_000),
    (Method::Force, Solver::Clarabel, 3_000),
    (Method::Displacement, Solver::Osqp, 250),
    (Method::Force, Solver::FourStep, 500),
];

#[derive(Debug, Serialize)]
struct Values {
    rows: Vec<Run>,
    everywhere: Vec<Everywhere>,
    demanded: Vec<String>,
    /// Runs that reached what was demanded, and those of them in which the true error is at most the certified one.
    reached: usize,
    truthful: usize,
    runs: usize,
    /// The largest part of the work that went into grids before the last one, of our own route on the example.
    before: f64,
    routes: Vec<Limits>,
    /// Finest grid that is tried in every scene.
    finest: usize,
}

/// One turn of the dial.
#[derive(Debug, Clone, Serialize)]
struct Run {
    scene: &'static str,
    route: String,
    exponent: i32,
    demanded: String,
    reached: bool,
    end: String,
    /// Grids in the order in which they were tried.
    grids: String,
    intervals: usize,
    /// Over the largest deflection.
    certified: f64,
    truth: f64,
    /// Iterations × unknowns, over all grids, and on the last one.
    work: usize,
    last: usize,
}

/// A scene of the gallery.
#[derive(Debug, Serialize)]
struct Everywhere {
    title: String,
    cells: Vec<Cell>,
}

#[derive(Debug, Serialize)]
struct Cell {
    intervals: usize,
    certified: Option<f64>,
    reached: bool,
}

/// How small an error a route reaches.
#[derive(Debug, Serialize)]
struct Limits {
    route: String,
    scene: &'static str,
    smallest: String,
    end: String,
}

pub(super) fn evidence(study: &Study<'_>) -> Result<Evidence, Cause> {
    let mut runs = Vec::new();
    for name in SCENES {
        let scene = scenes::read(study.root, name)?;
        let exact = theory::solve(&scene)?;
        for (method, solver, most_intervals) in ROUTES {
            for exponent in DEMANDED {
                let error = 10_f64.powi(exponent);
                let request = Request { most_intervals, ..Request::new(method, solver, error) };
                let run = run(name, &scene, &exact, exponent, &request)?;
                let reached = run.reached;
                runs.push(run);
                // A smaller error ends in the same place.
                if !reached {
                    break;
                }
            }
        }
    }
    let everywhere = scenes::all(study.root)?.into_iter().map(|(_, scene)| everywhere(&scene));
    let everywhere = everywhere.collect::<Result<Vec<_>, Cause>>()?;
    let ours = |run: &&Run| run.scene == SCENES[0] && run.route == route(ROUTES[0].0, ROUTES[0].1);
    let share = |part: usize, whole: usize| if whole == 0 { 0.0 } else { as_number(part) / as_number(whole) };
    let (svg, data) = figure::drawn(&runs)?;
    let values = Values {
        reached: runs.iter().filter(|run| run.reached).count(),
        truthful: runs.iter().filter(|run| run.truth <= run.certified).count(),
        runs: runs.len(),
        before: runs.iter().filter(ours).map(|run| share(run.work - run.last, run.work)).fold(0.0, f64::max),
        routes: limits(&runs),
        rows: runs.iter().filter(ours).cloned().collect(),
        demanded: EVERYWHERE.map(power).to_vec(),
        everywhere,
        finest: EVERYWHERE_INTERVALS,
    };
    let everywhere = values.everywhere.iter().flat_map(|row| {
        row.cells.iter().zip(EVERYWHERE).map(|(cell, exponent)| {
            let certified = cell.certified.map_or_else(String::new, |error| scientific(error, 2));
            let reached = if cell.reached { "reached" } else { "not reached" };
            let title = row.title.replace(',', ";");
            vec![title, format!("1e{exponent}"), reached.to_owned(), cell.intervals.to_string(), certified]
        })
    });
    let table = csv(&["scene", "demanded", "end", "intervals", "certified_error"], everywhere);
    Ok(Evidence::new(values).figure("dial", svg, data).data("dial-everywhere", table))
}

fn run(name: &'static str, scene: &Scene, exact: &Exact, exponent: i32, request: &Request) -> Result<Run, Cause> {
    let dialled = dial(scene, request)?;
    let work = dialled.tries.iter().map(|tried| tried.work).sum();
    let grids: Vec<String> = dialled.tries.iter().map(|t| t.intervals.to_string()).collect();
    Ok(Run {
        scene: name,
        route: route(request.method, request.solver),
        exponent,
        demanded: power(exponent),
        reached: dialled.end == End::Reached,
        end: ended(dialled.end),
        grids: grids.join(", "),
        intervals: dialled.settings.intervals,
        certified: dialled.verdict.error,
        truth: truth(&dialled, exact)?,
        work,
        last: dialled.tries.last().map_or(0, |tried| tried.work),
    })
}

fn route(method: Method, solver: Solver) -> String {
    format!("{method}/{solver}")
}

/// In few words; residuals in them would be rounding.
fn ended(end: End) -> String {
    match end {
        End::Reached => "reached".to_owned(),
        End::Limit { intervals } => format!("{intervals} intervals are its limit here"),
        End::Failed { intervals, .. } => format!("its answer fails the judge on {intervals} intervals"),
        End::Stalled { intervals } => format!("finer grids do not help up to {intervals} intervals"),
    }
}

/// The largest difference of a nodal deflection from beam theory, over the largest deflection.
fn truth(dialled: &Dialled, exact: &Exact) -> Result<f64, Cause> {
    let nodes = dialled.outcome.state.nodes.as_ref().ok_or("a discretised state has nodes")?;
    let apart = nodes.x.iter().zip(&nodes.deflection).map(|(&x, v)| (v - exact.deflection(x)).abs());
    // The same size as that of the certified error.
    let deflection = dialled.outcome.state.deflection;
    let largest = deflection.max.max(-deflection.min);
    Ok(apart.fold(0.0, f64::max) / largest)
}

fn everywhere(scene: &Scene) -> Result<Everywhere, Cause> {
    let cell = |exponent: i32| -> Result<Cell, Cause> {
        let request = Request {
            most_intervals: EVERYWHERE_INTERVALS,
            ..Request::new(Method::Force, Solver::ActiveSet, 10_f64.powi(exponent))
        };
        let dialled = dial(scene, &request)?;
        let certified = dialled.verdict.error;
        Ok(Cell {
            intervals: dialled.settings.intervals,
            certified: certified.is_finite().then_some(certified),
            reached: dialled.end == End::Reached,
        })
    };
    let cells = EVERYWHERE.iter().map(|&exponent| cell(exponent)).collect::<Result<Vec<_>, _>>()?;
    Ok(Everywhere { title: scene.title().to_owned(), cells })
}

/// The last turn of each route in each scene that reached something, and how the next one ended.
fn limits(runs: &[Run]) -> Vec<Limits> {
    let mut found: Vec<Limits> = Vec::new();
    for (i, run) in runs.iter().enumerate() {
        let same = |other: &Run| other.scene == run.scene && other.route == run.route;
        if runs.get(i + 1).is_some_and(same) {
            continue;
        }
        let smallest = runs.iter().filter(|other| same(other) && other.reached).map(|run| run.exponent).min();
        found.push(Limits {
            route: run.route.clone(),
            scene: run.scene,
            smallest: smallest.map_or_else(|| "–".to_owned(), power),
            end: if run.reached { "nothing smaller was asked".to_owned() } else { run.end.clone() },
        });
    }
    found
}

#[expect(clippy::cast_precision_loss, reason = "counts far below 2⁵³")]
fn as_number(count: usize) -> f64 {
    count as f64
}
