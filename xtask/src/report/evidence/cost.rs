//! Speed and accuracy: rendered from the file of `cargo xtask measure`, which alone knows times. Only runs that solve their
//! problem count as results; what did not end, or failed our check, is marked and never fitted.

mod advice;
mod price;
mod runs;
mod stopping;

use super::prelude::*;
use crate::measure::line::{Line, Store};
use crate::measure::plan::{EXAMPLE, LIMIT, is_survey};

/// Solvers in the order of figures and tables, the libraries among them, and the methods.
pub(super) const SOLVERS: [&str; 5] = ["active-set", "four-step", "nsor", "clarabel", "osqp"];
const LIBRARIES: [&str; 2] = ["clarabel", "osqp"];
const METHODS: [&str; 3] = ["complementarity", "displacement", "force"];

/// What solvers that can be asked for a tolerance are asked for, where one is shown.
const ASKED: f64 = 1e-10;

/// The lines of a scene that have a result.
pub(super) fn ended<'a>(store: &'a Store, scene: &str) -> Vec<&'a Line> {
    store.lines.iter().filter(|line| line.scene == scene && line.median_s.is_some()).collect()
}

/// Whether a line is asked for what is shown, or cannot be asked for anything.
pub(super) fn shown(line: &Line) -> bool {
    line.asks(0.0) || line.asks(ASKED)
}

/// Milliseconds of the median run.
fn milliseconds(line: &Line) -> f64 {
    1e3 * line.median_s.unwrap_or(f64::NAN)
}

pub(super) fn evidence(study: &Study<'_>) -> Result<Evidence, Cause> {
    let (file, mut store) = Store::read(study.root)?;
    // Surveys have a page of their own.
    store.lines.retain(|line| !is_survey(&line.scene));
    let (price, price_figure) = price::of(study, &store)?;
    let (stopping, stopping_figure) = stopping::of(study, &store)?;
    let (runs, runs_figure) = runs::of(study, &store)?;
    let values = context! {
        made => store.provenance(),
        limit => LIMIT,
        finest => finest(&store),
        nsor_gave_up => nsor_gave_up(&store),
        measured => store.lines.iter().filter(|line| line.median_s.is_some()).count(),
        price,
        stopping,
        runs,
        reactions => reactions(&store),
        thirty => {
            let error = |ground: &(&str, &str)| reaction_error(&store, ground.0, 30);
            let uneven = GROUNDS[1..].iter().map(error).reduce(|a, b| Some(a?.min(b?))).flatten();
            context! { flat => error(&GROUNDS[0]), least_uneven => uneven }
        },
        advice => advice::table(&advice::held(study.root, &store)?, &store),
    };
    Evidence::new(values).file("measurements", file).figures([price_figure, stopping_figure, runs_figure])
}

/// The finest grid of the plan, solver by solver: on the example, and on the other scenes.
fn finest(store: &Store) -> Table {
    Table::new(["solver", "finest grid of the example", "finest grid of the other scenes"]).rows(SOLVERS.map(
        |solver| {
            let finest = |example: bool| {
                let lines =
                    store.lines.iter().filter(|line| line.solver == solver && (line.scene == EXAMPLE) == example);
                lines.map(|line| line.intervals).max().map_or_else(|| "–".to_owned(), count)
            };
            row![solver, finest(true), finest(false)]
        },
    ))
}

/// The finest grid of NSOR on the example, if it gave up there by every method, and the longest that it took for that \[s\].
fn nsor_gave_up(store: &Store) -> Option<Value> {
    let lines = ended(store, EXAMPLE);
    let of_nsor = || lines.iter().filter(|line| line.solver == "nsor" && shown(line));
    let intervals = of_nsor().map(|line| line.intervals).max()?;
    let finest = || of_nsor().filter(|line| line.intervals == intervals);
    let seconds = finest().filter_map(|line| line.median_s).max_by(f64::total_cmp)?;
    finest().all(|line| !line.succeeded()).then(|| context! { intervals, seconds })
}

/// Scenes whose left reaction has a table, flat ground first, in words.
const GROUNDS: [(&str, &str); 4] =
    [(EXAMPLE, "flat, the example"), ("wave", "smooth crests"), ("survey", "worn floor"), ("hump", "one hump")];

/// The error of the left reaction by the force method with the active set, if that is solved.
fn reaction_error(store: &Store, scene: &str, intervals: usize) -> Option<f64> {
    let lines = ended(store, scene);
    let line = lines.into_iter().find(|line| line.is("force", "active-set") && line.intervals == intervals)?;
    line.reaction_total.filter(|_| line.succeeded())
}

/// The same, scene by scene.
fn reactions(store: &Store) -> Table {
    const GRIDS: [usize; 3] = [30, 100, 1000];
    let header = row!["ground"].into_iter().chain(GRIDS.map(|grid| format!("{} intervals", count(grid))));
    Table::new(header).rows(GROUNDS.map(|(scene, ground)| {
        let errors = GRIDS.map(|grid| {
            reaction_error(store, scene, grid)
                .map_or_else(|| "–".to_owned(), |error| format!("{} %", cell(Some(100.0 * error), 2)))
        });
        row![ground].into_iter().chain(errors)
    }))
}
