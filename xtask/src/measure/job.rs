//! One measurement: an answer, our verdict on it, and how long it takes.

use std::path::Path;
use std::time::Instant;

use palkki::adaptive::{End, Request, adapt};
use palkki::route::Status;
use palkki::scene::Scene;
use palkki::state::ContactState;
use palkki::{Settings, solve_exactly, solve_raw, theory};
use palkki_evidence::paper::claims::nsor::own_sweeps;

use super::line::{Line, STOPPED};
use super::plan::{Job, Route, Subject};
use super::process::{self, Process};
use super::references::References;
use crate::Cause;
use crate::data::{rounded, spread};

/// Runs of each job that is quick enough: few microseconds, and memory that is fetched anew, are a matter of luck.
const RUNS: usize = 25;
/// No more runs after so many seconds, but the fewest of what is quicker than this.
const ENOUGH: f64 = 0.25;
const FEWEST: usize = 3;
const QUICK: f64 = 1.0;

/// Seconds of some runs, and what comes of the last.
pub(super) fn timed<T>(mut once: impl FnMut() -> Result<T, Cause>) -> Result<(Vec<f64>, T), Cause> {
    let mut seconds: Vec<f64> = Vec::new();
    loop {
        let start = Instant::now();
        let found = once()?;
        seconds.push(start.elapsed().as_secs_f64());
        let all: f64 = seconds.iter().sum();
        let fewest = if seconds.iter().all(|run| *run < QUICK) { FEWEST } else { 1 };
        if RUNS <= seconds.len() || fewest <= seconds.len() && ENOUGH <= all {
            return Ok((seconds, found));
        }
        // No run has to share memory with the answer of the one before.
        drop(found);
    }
}

/// The line of a job: it is run several times; the answer is the same each time. A survey is solved by the program as well,
/// before: what takes too long there is not run here, where nothing can stop it.
pub(super) fn measured(root: &Path, scene: &Scene, job: Job, references: &References) -> Result<Line, Cause> {
    let mut begun = Line::of(job);
    if matches!(job.route, Route::Optimum(_)) {
        return Ok(match references.reference(scene, job) {
            Some(found) => Line { iterations: Some(found.exchanges + 1), ..begun.ended("proven") }
                .with(vec![found.seconds], &references.of_grid(&found)),
            None => begun.ended("not-proven"),
        });
    }
    if let Subject::Survey(_) = job.subject {
        let Some(Process { seconds, peak_kb }) = process::run(root, job)? else { return Ok(begun.ended(STOPPED)) };
        let [process_s, ..] = spread(seconds);
        begun = Line { process_s, peak_kb, ..begun };
    }
    let (seconds, answer) = match timed(|| once(scene, job.route, job.intervals, job.tolerance)) {
        Ok(found) => found,
        Err(why) => return Ok(begun.refused(why)),
    };
    // A solver that refuses hands back no number at all.
    if answer.residual.is_infinite() && answer.iterations == 0 {
        return Ok(begun.refused(format_args!("the solver has no answer, {}", answer.status)));
    }
    let line = Line {
        says_solved: Some(answer.reports_success),
        did_as_asked: answer.only.own_residual.map(|(is_met, _)| is_met),
        residual: rounded(answer.residual, 2),
        own_residual: answer.only.own_residual.and_then(|(_, residual)| rounded(residual, 2)),
        iterations: Some(answer.iterations),
        own_sweeps: answer.only.own_sweeps,
        unknowns: Some(answer.unknowns),
        last_intervals: answer.only.adapted.map(|(intervals, _)| intervals),
        certified_error: answer.only.adapted.and_then(|(_, error)| rounded(error, 2)),
        lists: answer.only.lists,
        contacts: answer.only.lists.map(|_| answer.state.contacts.len()),
        ..begun.ended(answer.status)
    };
    Ok(line.with(seconds, &references.errors(scene, job, &answer.state)))
}

/// An answer, and what is known of it but for times and errors.
pub(super) struct Answer {
    pub(super) state: ContactState,
    /// How it ended: our check, of the adaptive grid its verdict.
    pub(super) status: &'static str,
    /// Whether the solver says that it succeeded.
    reports_success: bool,
    /// Residual by our check.
    residual: f64,
    iterations: usize,
    unknowns: usize,
    only: Only,
}

/// What some routes know besides.
#[derive(Default)]
struct Only {
    /// Of a library: whether the residual in its own norm is what it was asked for, and that residual.
    own_residual: Option<(bool, f64)>,
    /// Of NSOR: the sweeps of the factor that won the race.
    own_sweeps: Option<usize>,
    /// Lists of contacts that were tried; of the exact solution.
    lists: Option<usize>,
    /// Of the adaptive grid: intervals of its last grid, and the certified error of the deflection.
    adapted: Option<(usize, f64)>,
}

/// Solves by the route of a job, without a clock.
pub(super) fn once(scene: &Scene, route: Route, intervals: usize, tolerance: f64) -> Result<Answer, Cause> {
    match route {
        Route::Optimum(_) => Err("the proven optimum is no solver".into()),
        Route::Exact => {
            let exact = theory::solve(scene)?;
            Ok(Answer {
                status: exact.ended(),
                reports_success: exact.solved,
                residual: exact.residual,
                iterations: exact.iterations,
                unknowns: exact.unknowns,
                only: Only { lists: Some(exact.lists), ..Only::default() },
                state: exact.state,
            })
        }
        Route::Certified => {
            let found = solve_exactly(scene)?;
            Ok(Answer {
                status: found.verdict.status.name(),
                reports_success: found.verdict.status == Status::Certified,
                residual: found.residual,
                iterations: found.run.iterations,
                unknowns: found.unknowns,
                only: Only::default(),
                state: found.state,
            })
        }
        Route::Solver(method, solver) => {
            let found = solve_raw(scene, &Settings { method, solver, intervals, tolerance })?;
            Ok(Answer {
                status: found.ended(),
                reports_success: found.run.reports_success,
                residual: found.residual,
                iterations: found.run.iterations,
                unknowns: found.unknowns,
                only: Only {
                    own_residual: found.run.own_residual.map(|own| (own.is_met(), own.residual)),
                    own_sweeps: own_sweeps(&found.run.message),
                    ..Only::default()
                },
                state: found.state,
            })
        }
        Route::Adaptive(method, solver) => {
            let found = adapt(scene, &Request::new(method, solver, tolerance))?;
            Ok(Answer {
                status: found.solution.verdict.status.name(),
                reports_success: found.end == End::Reached,
                residual: found.solution.residual,
                iterations: found.trials.iter().map(|tried| tried.iterations).sum(),
                unknowns: found.solution.unknowns,
                only: Only {
                    adapted: Some((found.settings.intervals, found.solution.verdict.error)),
                    ..Only::default()
                },
                state: found.solution.state,
            })
        }
    }
}
