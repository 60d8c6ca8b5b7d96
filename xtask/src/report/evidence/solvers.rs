//! The solvers, their settings, our check, and how far a solver's own criterion and our check agree; and instances that are
//! hard for exchanges.

use std::path::Path;

use palkki::DEFAULT_TOLERANCE;
use palkki::certificate::CERTIFIED_RESIDUAL;
use palkki::methods::Discrete;

use super::prelude::*;
use crate::text;
use palkki_evidence::exchanges::{End, Instance, corpus, full_exchange};

pub(super) fn evidence(study: &Study<'_>) -> Result<Evidence, Cause> {
    let settings = Solver::ALL.map(|solver| row![solver, solver.settings(DEFAULT_TOLERANCE)]);
    let (word, runs) = own_criteria(study.root)?;
    let (corpus, instances) = hard_instances()?;
    let values = context! {
        settings => Table::new(["solver", "settings"]).rows(settings),
        threshold => text::tolerance(CERTIFIED_RESIDUAL),
        asked => text::tolerance(DEFAULT_TOLERANCE),
        word,
        corpus,
    };
    Ok(Evidence::new(values).data("solver-runs", runs).data("exchanges", instances))
}

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
fn own_criteria(root: &Path) -> Result<(Value, Table), Cause> {
    let scenes = SCENES.map(|name| scenes::read(root, name).map(|scene| (name, scene)));
    let scenes = scenes.into_iter().collect::<Result<Vec<_>, _>>()?;
    let header =
        ["solver", "asked for", "own tolerance", "runs", "says solved", "did what it was asked", "passes our check"];
    let mut table = Table::new(header);
    let header = ["scene", "method", "solver", "intervals", "asked", "says_solved", "did_what_it_was_asked", "passes"];
    let (mut data, mut all) = (Table::new(header), Vec::new());
    for solver in Solver::ALL {
        let is_library = matches!(solver, Solver::Clarabel | Solver::Osqp);
        for tolerance in [LOOSE, DEFAULT_TOLERANCE].into_iter().filter(|&t| is_library || t == DEFAULT_TOLERANCE) {
            let (mut runs, mut own_tolerance) = (Vec::new(), None);
            for (name, scene) in &scenes {
                for (method, intervals) in Method::ALL.into_iter().flat_map(|m| GRIDS.map(|n| (m, n))) {
                    if too_long(solver, intervals) {
                        continue;
                    }
                    let outcome =
                        solve_raw(scene, &Settings { tolerance, ..Settings::new(method, solver, intervals) })?;
                    own_tolerance = outcome.own_residual.map(|own| own.asked);
                    let (says, passes) = (outcome.solver_reports_success, outcome.solved);
                    let met = outcome.own_residual.map(|own| own.is_met());
                    let [says_word, met_word, passes_word] =
                        [Some(says), met, Some(passes)].map(|is| is.map_or("", yes_no));
                    let asked = format!("{tolerance:e}");
                    data.push(row![name, method, solver, intervals, asked, says_word, met_word, passes_word]);
                    runs.push(Run { is_library, says, met, passes });
                }
            }
            let count = |of: fn(&Run) -> bool| runs.iter().filter(|run| of(run)).count().to_string();
            let dash = || "–".to_owned();
            table.push(row![
                solver,
                if is_library || solver == Solver::Nsor { text::tolerance(tolerance) } else { dash() },
                own_tolerance.map_or_else(dash, text::tolerance),
                runs.len(),
                count(|run| run.says),
                if is_library { count(|run| run.met == Some(true)) } else { dash() },
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
        loose => text::tolerance(LOOSE),
        runs => all.len(),
        says_and_fails => libraries(|run| run.says && !run.passes),
        met_and_fails => libraries(|run| run.says && run.met == Some(true) && !run.passes),
        unmet_and_passes => libraries(|run| run.met == Some(false) && run.passes),
    };
    Ok((values, data))
}

/// Runs all three on all instances: a summary, and every run as data.
fn hard_instances() -> Result<(Value, Table), Cause> {
    let instances = corpus().map_err(|line| format!("tests/corpus/exchanges.csv: no instance: {line}"))?;
    // For each algorithm: how often it ends at the optimum, and the most solves that it takes.
    let mut ends = [("four steps", 0, 0), ("full exchanges alone", 0, 0), ("active set", 0, 0)];
    let mut periods = Vec::new();
    let header = "method,intervals,foundation,four_steps,solves,full_exchanges,solves,active_set,solves";
    let mut data = Table::new(header.split(','));
    for instance in &instances {
        let (exchange, solves) = match exchanged(instance)? {
            End::Optimum { solves } => (true, solves),
            End::Circle { solves, period } => {
                periods.push(period);
                (false, solves)
            }
        };
        let runs = [ended(instance, Solver::FourStep)?, (exchange, solves), ended(instance, Solver::ActiveSet)?];
        let foundation = instance.line.rsplit(',').next().unwrap_or_default();
        let mut row = row![instance.method, instance.intervals, foundation].to_vec();
        for ((_, right, most), (is_right, solves)) in ends.iter_mut().zip(runs) {
            *right += usize::from(is_right);
            *most = solves.max(*most);
            row.extend(row![if is_right { "optimum" } else { "no optimum" }, solves]);
        }
        data.push(row);
    }
    let rows = ends.map(|(name, right, most)| row![name, right, most]);
    let values = context! {
        table => Table::new(["algorithm", "ends at the optimum", "most solves"]).rows(rows),
        count => instances.len(),
        circles => periods.iter().min().zip(periods.iter().max()),
        active_set => ends[2].1,
    };
    Ok((values, data))
}

fn exchanged(instance: &Instance) -> Result<End, Cause> {
    let scaled = instance.scene.scaled()?;
    let discrete = Discrete::new(&scaled.scene, instance.intervals)?;
    let qp = instance.method.qp(&discrete);
    full_exchange(qp.as_ref()).map_err(|error| error.to_string().into())
}

/// Whether the answer passes our check, and the solves that it took.
fn ended(instance: &Instance, solver: Solver) -> Result<(bool, usize), Cause> {
    let outcome = on_grid(&instance.scene, instance.method, solver, instance.intervals)?;
    Ok((outcome.solved, outcome.iterations))
}
