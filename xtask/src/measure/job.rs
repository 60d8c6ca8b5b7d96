//! One measurement: an answer, our verdict on it, and how long it takes.

use std::time::Instant;

use palkki::adaptive::{End, Request, adapt};
use palkki::scene::Scene;
use palkki::state::ContactState;
use palkki::{Settings, solve_raw, theory};

use super::line::Line;
use super::plan::{Job, Route};
use super::references::References;
use crate::Cause;
use crate::data::rounded;

/// Runs of each job that is quick enough: few microseconds, and memory that is fetched anew, are a matter of luck.
const RUNS: usize = 25;
/// No more runs after so many seconds.
const ENOUGH: f64 = 0.25;

/// The line of a job that `begun` says which it is: it is run several times; the answer is the same each time.
pub(super) fn measured(begun: Line, scene: &Scene, job: Job, references: &References) -> Result<Line, Cause> {
    if matches!(job.route, Route::Optimum(_)) {
        return Ok(match references.reference(scene, job) {
            Some(found) => Line { iterations: Some(found.exchanges + 1), ..begun.ended("proven") }
                .with(vec![found.seconds], &references.of_grid(&found)),
            None => begun.ended("not-proven"),
        });
    }
    let mut seconds = Vec::new();
    let mut last: Option<Answer> = None;
    while seconds.len() < RUNS && seconds.iter().sum::<f64>() < ENOUGH {
        // The answer of the last run goes first: no run has to share memory with it.
        drop(last.take());
        let start = Instant::now();
        let answer = once(&begun, scene, job)?;
        seconds.push(start.elapsed().as_secs_f64());
        last = Some(answer);
    }
    let Answer { state, residual, line, .. } = last.ok_or("no run at all")?;
    // A solver that refuses hands back no number at all.
    if residual.is_infinite() && line.iterations == Some(0) {
        return Ok(begun.ended("refused"));
    }
    let line = Line { residual: rounded(residual, 2), ..line };
    Ok(line.with(seconds, &references.errors(scene, job, &state)))
}

/// An answer, and what is known of it but for times and errors.
struct Answer {
    state: ContactState,
    residual: f64,
    line: Line,
}

fn once(begun: &Line, scene: &Scene, job: Job) -> Result<Answer, Cause> {
    let line = |status: &str, success: bool, iterations: usize, unknowns: usize| Line {
        says_solved: Some(success),
        iterations: Some(iterations),
        unknowns: Some(unknowns),
        ..begun.clone().ended(status)
    };
    match job.route {
        Route::Optimum(_) => Err("the proven optimum is no solver".into()),
        Route::Exact => {
            let exact = theory::solve(scene)?;
            let line = line(exact.ended(), exact.solved, exact.iterations, exact.unknowns);
            Ok(Answer { state: exact.state, residual: exact.residual, line })
        }
        Route::Solver(method, solver) => {
            let Job { intervals, tolerance, .. } = job;
            let found = solve_raw(scene, &Settings { method, solver, intervals, tolerance })?;
            let line = Line {
                did_as_asked: found.own_residual.map(|own| own.is_met()),
                own_residual: found.own_residual.and_then(|own| rounded(own.residual, 2)),
                ..line(found.ended(), found.solver_reports_success, found.iterations, found.unknowns)
            };
            Ok(Answer { state: found.state, residual: found.residual, line })
        }
        Route::Adaptive(method, solver) => {
            let found = adapt(scene, &Request::new(method, solver, job.tolerance))?;
            let iterations = found.trials.iter().map(|tried| tried.iterations).sum();
            let reached = found.end == End::Reached;
            let line = Line {
                last_intervals: Some(found.settings.intervals),
                certified_error: rounded(found.solution.verdict.error, 2),
                ..line(found.solution.verdict.status.name(), reached, iterations, found.solution.unknowns)
            };
            Ok(Answer { state: found.solution.state, residual: found.solution.residual, line })
        }
    }
}
