//! Speed and accuracy: rendered from the file of `cargo xtask measure`, which alone knows times. Only certified runs count
//! as results; what did not end, or failed our check, is marked and never fitted.

mod advice;
mod comparison;
mod price;
mod runs;
mod stopping;

use std::collections::BTreeMap;

use palkki_evidence::paper::example;

use super::prelude::*;
use crate::measure::line::{Line, Store};
use crate::measure::plan::{EXAMPLE, LIMIT, OTHERS, Route, all};

/// Solvers in the order of figures and tables, the libraries among them, and the methods.
const SOLVERS: [&str; 5] = ["active-set", "four-step", "nsor", "clarabel", "osqp"];
const LIBRARIES: [&str; 2] = ["clarabel", "osqp"];
const METHODS: [&str; 3] = ["complementarity", "displacement", "force"];

/// What solvers that can be asked for a tolerance are asked for, where one is shown.
const ASKED: f64 = 1e-10;

/// The lines of a scene that have a result.
fn ended<'a>(store: &'a Store, scene: &str) -> Vec<&'a Line> {
    store.lines.iter().filter(|line| line.scene == scene && line.median_s.is_some()).collect()
}

/// Whether a line is asked for what is shown, or cannot be asked for anything.
fn shown(line: &Line) -> bool {
    line.asks(0.0) || line.asks(ASKED)
}

/// Milliseconds of the median run.
fn milliseconds(line: &Line) -> f64 {
    1e3 * line.median_s.unwrap_or(f64::NAN)
}

pub(super) fn evidence(study: &Study<'_>) -> Result<Evidence, Cause> {
    let (file, store) = Store::read(study.root)?;
    let (price, price_figure) = price::of(&store)?;
    let (stopping, stopping_figure) = stopping::of(&store)?;
    let (runs, runs_figure) = runs::of(&store)?;
    let values = context! {
        commit => store.description("commit"),
        date => store.description("date"),
        processor => store.description("machine"),
        compiler => store.description("compiler"),
        libraries => store.description("libraries"),
        limit => LIMIT,
        measured => store.lines.iter().filter(|line| line.median_s.is_some()).count(),
        price,
        stopping,
        runs,
        comparison => comparison::of(&store),
        requirements => comparison::requirements(&store),
        repair => repair(&store),
        left_out => left_out(&store),
        planned => planned(),
        work => work()?,
        advice => advice::table(&advice::held(study.root, &store)?, &store),
    };
    let evidence = Evidence::new(values).file("measurements", file);
    Ok(evidence.figures([price_figure, stopping_figure, runs_figure]))
}

/// How often the contact set of a library, solved by the three-moment equations, is better or worse than its forces.
fn repair(store: &Store) -> Value {
    let (mut answers, mut gained, mut lost, mut kept) = (0, 0, 0, 0);
    for after in store.lines.iter().filter(|line| line.method == "repair" && line.median_s.is_some()) {
        let same = |line: &&Line| {
            line.scene == after.scene
                && line.is("force", &after.solver)
                && line.intervals == after.intervals
                && line.asks(after.tolerance)
                && line.median_s.is_some()
        };
        let Some(before) = store.lines.iter().find(same) else { continue };
        answers += 1;
        match (before.succeeded(), after.succeeded()) {
            (false, true) => gained += 1,
            (true, false) => lost += 1,
            (true, true) => kept += 1,
            (false, false) => {}
        }
    }
    context! { answers, gained, lost, kept }
}

/// What the plan has and the file has no result for: how many entries, and for each scene and route from which grid on.
fn left_out(store: &Store) -> Value {
    let mut coarsest: BTreeMap<String, usize> = BTreeMap::new();
    let missing = || store.lines.iter().filter(|line| line.median_s.is_none());
    for line in missing() {
        let why = if line.is_left_out() { "" } else { &format!(" ({})", line.status) };
        let route = format!("{}, {}, {}{why}", line.scene, line.method, line.solver);
        coarsest.entry(route).and_modify(|least| *least = line.intervals.min(*least)).or_insert(line.intervals);
    }
    let rows = coarsest.into_iter().map(|(route, least)| format!("{route}: from {} intervals on", count(least)));
    context! { entries => missing().count(), routes => rows.collect::<Vec<_>>() }
}

/// The finest grids of the plan.
fn planned() -> Table {
    let plan = all();
    let finest = |of: &dyn Fn(Route) -> bool, on_example: bool| {
        let scenes = plan.iter().filter(|(scene, _)| (*scene == EXAMPLE) == on_example);
        let jobs = scenes.flat_map(|(_, jobs)| jobs).filter(|job| of(job.route));
        jobs.map(|job| job.intervals).max().map_or_else(|| "–".to_owned(), count)
    };
    let row = |name: &str, of: &dyn Fn(Route) -> bool| row![name, finest(of, true), finest(of, false)];
    let solvers =
        Solver::ALL.map(|solver| row(solver.name(), &move |route| matches!(route, Route::Solver(_, s) if s == solver)));
    let optimum = row("proven optimum", &|route| matches!(route, Route::Optimum(_)));
    let others = format!("on {}", OTHERS.join(", "));
    Table::new(["solver", "finest grid on the example", &others]).rows(solvers.into_iter().chain([optimum]))
}

/// What the active set costs without a clock: unknowns that all its solves go through, over the unknowns of the problem.
fn work() -> Result<Table, Cause> {
    const GRIDS: [usize; 5] = [30, 300, 3000, 30_000, 300_000];
    let scene = example()?;
    let mut table =
        Table::new(row!["method"].into_iter().chain(GRIDS.map(|grid| format!("{} intervals", count(grid)))));
    for method in Method::ALL {
        let mut row = row![method].to_vec();
        for grid in GRIDS {
            let outcome = on_grid(&scene, method, Solver::ActiveSet, grid)?;
            row.push(cell(Some(as_number(outcome.work) / as_number(outcome.unknowns)), 2));
        }
        table.push(row);
    }
    Ok(table)
}
