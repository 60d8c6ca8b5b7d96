//! Speed and accuracy: rendered from the file of `cargo xtask measure`, which alone knows times. Only certified runs count
//! as results; what did not end, or failed our check, is marked and never fitted.

mod advice;
mod comparison;
mod price;
mod requirements;
mod runs;
mod stopping;

use std::collections::BTreeMap;

use minijinja::context;
use palkki::route::{Method, Solver};
use palkki::scene::SceneError;
use palkki::{Settings, solve};
use palkki_evidence::paper::example;

use crate::measure::plan::{EXAMPLE, LIMIT, OTHERS, Route, all};
use crate::measure::store::{self, Line, Store};
use crate::report::error::Cause;
use crate::report::evidence::Evidence;
use crate::report::numbers::{as_number, cell, count};
use crate::report::study::Study;
use crate::report::table::Table;

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

/// Milliseconds of the median run.
fn milliseconds(line: &Line) -> f64 {
    1e3 * line.median_s.unwrap_or(f64::NAN)
}

pub(super) fn evidence(study: &Study<'_>) -> Result<Evidence, Cause> {
    let file = std::fs::read_to_string(study.root.join(store::PATH))?;
    let store = Store::read(study.root)?;
    let price = price::of(&store)?;
    let stopping = stopping::of(&store)?;
    let runs = runs::of(&store)?;
    let values = context! {
        commit => store.description("commit"),
        date => store.description("date"),
        processor => store.description("machine"),
        compiler => store.description("compiler"),
        libraries => store.description("libraries"),
        limit => LIMIT,
        measured => store.lines.iter().filter(|line| line.median_s.is_some()).count(),
        price => price.values,
        stopping => stopping.values,
        runs => runs.values,
        comparison => comparison::of(&store),
        requirements => requirements::of(&store).to_string(),
        repair => repair(&store),
        left_out => left_out(&store),
        planned => planned().to_string(),
        work => work()?.to_string(),
        advice => advice::table(&advice::held(study.root, &store)?, &store).to_string(),
    };
    let evidence = Evidence::new(values).data("measurements", file);
    let figures = [price.figure, stopping.figure, runs.figure];
    Ok(figures.into_iter().fold(evidence, |evidence, (name, svg, csv)| evidence.figure(name, svg, csv)))
}

/// How often the contact set of a library, solved by the three-moment equations, is better or worse than its forces.
fn repair(store: &Store) -> minijinja::Value {
    let (mut answers, mut gained, mut lost, mut kept) = (0, 0, 0, 0);
    for after in store.lines.iter().filter(|line| line.method == "repair" && line.median_s.is_some()) {
        let same = |line: &&Line| {
            line.scene == after.scene
                && line.is("force", &after.solver)
                && line.intervals == after.intervals
                && line.tolerance.total_cmp(&after.tolerance).is_eq()
                && line.median_s.is_some()
        };
        let Some(before) = store.lines.iter().find(same) else { continue };
        answers += 1;
        match (before.is_certified(), after.is_certified()) {
            (false, true) => gained += 1,
            (true, false) => lost += 1,
            (true, true) => kept += 1,
            (false, false) => {}
        }
    }
    context! { answers, gained, lost, kept }
}

/// What the plan has and the file has no result for: how many entries, and for each scene and route from which grid on.
fn left_out(store: &Store) -> minijinja::Value {
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
    let row = |name: &str, of: &dyn Fn(Route) -> bool| [name.to_owned(), finest(of, true), finest(of, false)];
    let solvers =
        Solver::ALL.map(|solver| row(solver.word(), &move |route| matches!(route, Route::Solver(_, s) if s == solver)));
    let optimum = row("proven optimum", &|route| matches!(route, Route::Optimum(_)));
    let others = format!("on {}", OTHERS.join(", "));
    Table::new(["solver", "finest grid on the example", &others]).rows(solvers.into_iter().chain([optimum]))
}

/// What the active set costs without a clock: unknowns that all its solves go through, over the unknowns of the problem.
fn work() -> Result<Table, SceneError> {
    const GRIDS: [usize; 5] = [30, 300, 3000, 30_000, 300_000];
    let scene = example()?;
    let header = std::iter::once("method".to_owned()).chain(GRIDS.map(|grid| format!("{} intervals", count(grid))));
    let mut table = Table::new(header);
    for method in Method::ALL {
        let mut row = vec![method.word().to_owned()];
        for grid in GRIDS {
            let outcome = solve(&scene, &Settings::new(method, Solver::ActiveSet, grid))?;
            row.push(cell(Some(as_number(outcome.work) / as_number(outcome.unknowns)), 2));
        }
        table = table.row(row);
    }
    Ok(table)
}
