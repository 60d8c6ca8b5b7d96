//! What was left out of the measurements, and why.

use std::collections::BTreeMap;

use palkki::solvers::Solver;
use serde::Serialize;

use super::tolerance;
use crate::measure::plan::{EXAMPLE, Route, all};
use crate::measure::store::Store;

#[derive(Debug, Serialize)]
pub(super) struct Values {
    count: usize,
    /// Grids beyond which the plan does not go.
    planned: Vec<Planned>,
    rows: Vec<Row>,
}

#[derive(Debug, Serialize)]
struct Planned {
    solver: &'static str,
    /// On the example, and on the other scenes.
    finest: [usize; 2],
}

/// What the plan has and the file has not.
#[derive(Debug, Serialize)]
struct Row {
    scene: String,
    route: String,
    intervals: usize,
    why: String,
    tolerances: Vec<String>,
}

/// See [`Values`].
pub(super) fn of(store: &Store) -> Values {
    let mut found: BTreeMap<(String, String, usize, String), Vec<String>> = BTreeMap::new();
    let missing = store.lines.iter().filter(|line| line.seconds().is_none());
    for line in missing.clone() {
        let field = |column: &str| line.field(column).unwrap_or("–").to_owned();
        let why = match line.field("status").unwrap_or("–").split_once(':') {
            Some(_) => "the grid before took too long",
            None => match line.field("status") {
                Some("refused") => "the solver refuses the size",
                Some("not-proven") => "no proof: the search for the contact set did not end",
                _ => "a coarser grid took too long",
            },
        };
        let key = (field("scene"), field("route"), super::lines::intervals(line), why.to_owned());
        found.entry(key).or_default().push(field("tolerance"));
    }
    let row = |((scene, route, intervals, why), tolerances): ((String, String, usize, String), Vec<String>)| {
        let tolerances = tolerances.iter().filter(|asked| *asked != "0e0").map(|asked| tolerance(asked)).collect();
        Row { scene, route, intervals, why, tolerances }
    };
    Values { count: missing.count(), planned: planned(), rows: found.into_iter().map(row).collect() }
}

fn planned() -> Vec<Planned> {
    let plan = all();
    let finest = |of: &dyn Fn(Route) -> bool| {
        let finest = |on_example: bool| {
            let scenes = plan.iter().filter(|(scene, _)| (*scene == EXAMPLE) == on_example);
            scenes.flat_map(|(_, jobs)| jobs).filter(|job| of(job.route)).map(|job| job.intervals).max()
        };
        Some([finest(true)?, finest(false)?])
    };
    let solvers = Solver::ALL.map(|solver| {
        let of = move |route: Route| matches!(route, Route::Solver(_, s) if s == solver);
        (solver.word(), finest(&of))
    });
    let optimum = ("proven optimum", finest(&|route| matches!(route, Route::Optimum(_))));
    let rows = solvers.into_iter().chain([optimum]);
    rows.filter_map(|(solver, finest)| Some(Planned { solver, finest: finest? })).collect()
}
