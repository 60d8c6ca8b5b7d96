//! All routes on two scenes and three grids, and two questions for each: did the solver do what it was asked, and does its
//! answer pass our check?

use std::path::Path;

use minijinja::{Value, context};
use palkki::route::{Method, Solver, Status};
use palkki::{DEFAULT_TOLERANCE, Settings, solve};

use super::exactly_a_power;
use crate::report::csv::csv;
use crate::report::error::Cause;
use crate::report::scenes;
use crate::report::table::Table;

/// The example, and ground that is not flat.
const SCENES: [&str; 2] = ["heinisuo-1984", "wave"];
const GRIDS: [usize; 3] = [30, 100, 300];

/// What the libraries are asked for besides the default.
const LOOSE: f64 = 1e-4;

/// NSOR runs out of its budget on the finest grid; it takes many seconds to.
fn too_long(solver: Solver, intervals: usize) -> bool {
    200 < intervals && solver == Solver::Nsor
}

/// Of one run: whether the solver says that it solved the problem, did what it was asked, and passes our check.
struct Run {
    is_library: bool,
    says: bool,
    met: Option<bool>,
    passes: bool,
}

/// Runs everything: the counts, and every run as data.
pub(super) fn evidence(root: &Path) -> Result<(Value, String), Cause> {
    let scenes = SCENES.map(|name| scenes::read(root, name).map(|scene| (name, scene)));
    let scenes = scenes.into_iter().collect::<Result<Vec<_>, _>>()?;
    let header =
        ["solver", "asked for", "own tolerance", "runs", "says solved", "did what it was asked", "passes our check"];
    let mut table = Table::new(header);
    let (mut data, mut all) = (Vec::new(), Vec::new());
    for solver in Solver::ALL {
        let is_library = matches!(solver, Solver::Clarabel | Solver::Osqp);
        for tolerance in [LOOSE, DEFAULT_TOLERANCE].into_iter().filter(|&t| is_library || t == DEFAULT_TOLERANCE) {
            let (mut runs, mut own_tolerance) = (Vec::new(), None);
            for (name, scene) in &scenes {
                for (method, intervals) in Method::ALL.into_iter().flat_map(|m| GRIDS.map(|n| (m, n))) {
                    if too_long(solver, intervals) {
                        continue;
                    }
                    let outcome = solve(scene, &Settings { tolerance, ..Settings::new(method, solver, intervals) })?;
                    own_tolerance = outcome.own_residual.map(|own| own.asked);
                    let (says, passes) = (outcome.solver_claims_success, outcome.status == Status::Certified);
                    let met = outcome.own_residual.map(|own| own.is_met());
                    let route = [name, method.word(), solver.word()].map(str::to_owned);
                    let settings = [intervals.to_string(), format!("{tolerance:e}")];
                    let ends = [Some(says), met, Some(passes)].map(|yes| yes.map_or("", word).to_owned());
                    data.push([&route[..], &settings, &ends].concat());
                    runs.push(Run { is_library, says, met, passes });
                }
            }
            let has_tolerance = is_library || solver == Solver::Nsor;
            let count = |of: fn(&Run) -> bool| runs.iter().filter(|run| of(run)).count().to_string();
            table = table.row([
                solver.word().to_owned(),
                if has_tolerance { exactly_a_power(tolerance) } else { "–".to_owned() },
                own_tolerance.map_or("–".to_owned(), exactly_a_power),
                runs.len().to_string(),
                count(|run| run.says),
                if is_library { count(|run| run.met == Some(true)) } else { "–".to_owned() },
                count(|run| run.passes),
            ]);
            all.extend(runs);
        }
    }
    let libraries = |of: fn(&Run) -> bool| all.iter().filter(|run| run.is_library && of(run)).count();
    let values = context! {
        table,
        grids => GRIDS,
        scenes => scenes.iter().map(|(_, scene)| scene.title().to_owned()).collect::<Vec<_>>(),
        loose => exactly_a_power(LOOSE),
        runs => all.len(),
        says_and_fails => libraries(|run| run.says && !run.passes),
        met_and_fails => libraries(|run| run.says && run.met == Some(true) && !run.passes),
        unmet_and_passes => libraries(|run| run.met == Some(false) && run.passes),
    };
    let header = ["scene", "method", "solver", "intervals", "asked", "says_solved", "did_what_it_was_asked", "passes"];
    Ok((values, csv(&header, data)))
}

fn word(yes: bool) -> &'static str {
    if yes { "yes" } else { "no" }
}
