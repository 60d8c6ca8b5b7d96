//! One measurement: an answer, our verdict on it, and how long it takes.

use std::hint::black_box;
use std::time::Instant;

use palkki::adaptive::{End, Request, adapt};
use palkki::certificate::Kkt;
use palkki::methods::{Discrete, Method, contact_state};
use palkki::qp::FreeSet;
use palkki::scene::Scene;
use palkki::solvers::Solver;
use palkki::state::ContactState;
use palkki::{Settings, Witness, solve_raw, theory, verdict};

use super::instruments::{Tridiagonal, peak};
use super::line::Line;
use super::plan::{Job, Route};
use super::references::References;
use crate::Cause;
use crate::data::rounded;

/// Runs of each job that is quick enough: few microseconds, and memory that is fetched anew, are a matter of luck.
const RUNS: usize = 25;
/// No more runs after so many seconds, unless the yardstick lies beside them.
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
    // The yardstick and the certificate are laid beside the same jobs, in turns with them.
    let mut ruler = job.is_ruled().then(|| Tridiagonal::new(job.intervals - 1));
    let (mut added, mut yardstick, mut certificate) = (Vec::new(), Vec::new(), Vec::new());
    while seconds.len() < RUNS && (job.is_ruled() || seconds.iter().sum::<f64>() < ENOUGH) {
        // The answer of the last run goes first: no run has to share memory with it.
        drop(last.take());
        if let Some(ruler) = &mut ruler {
            yardstick.push(ruler.seconds());
        }
        let start = Instant::now();
        let answer = once(&begun, scene, job)?;
        seconds.push(start.elapsed().as_secs_f64());
        if job.is_ruled() {
            let start = Instant::now();
            black_box(verdict::certificate(&answer.state, &Witness::of(scene)));
            certificate.push(start.elapsed().as_secs_f64());
        }
        added.extend(answer.added);
        last = Some(answer);
    }
    let Answer { state, residual, line, .. } = last.ok_or("no run at all")?;
    // A solver that refuses hands back no number at all.
    if residual.is_infinite() && line.iterations == Some(0) {
        return Ok(begun.ended("refused"));
    }
    let peak_kb = if job.is_weighed() { peak(&begun.scene, job) } else { None };
    let [added_s, tridiagonal_s, certificate_s] = [added, yardstick, certificate].map(median);
    let residual = rounded(residual, 2);
    let line = Line { residual, added_s, tridiagonal_s, certificate_s, peak_kb, ..line };
    Ok(line.with(seconds, &references.errors(scene, job, &state)))
}

/// The median, if there is anything.
fn median(mut seconds: Vec<f64>) -> Option<f64> {
    seconds.sort_by(f64::total_cmp);
    rounded(*seconds.get(seconds.len() / 2)?, 3)
}

/// An answer, and what is known of it but for times and errors.
struct Answer {
    state: ContactState,
    residual: f64,
    line: Line,
    /// Seconds of a repair without those of the library.
    added: Option<f64>,
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
            Ok(Answer { state: exact.state, residual: exact.residual, line, added: None })
        }
        Route::Solver(method, solver) => {
            let Job { intervals, tolerance, .. } = job;
            let found = solve_raw(scene, &Settings { method, solver, intervals, tolerance })?;
            let line = Line {
                did_as_asked: found.own_residual.map(|own| own.is_met()),
                own_residual: found.own_residual.and_then(|own| rounded(own.residual, 2)),
                ..line(found.ended(), found.solver_reports_success, found.iterations, found.unknowns)
            };
            Ok(Answer { state: found.state, residual: found.residual, line, added: None })
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
            Ok(Answer { state: found.solution.state, residual: found.solution.residual, line, added: None })
        }
        Route::Repair(solver) => repair(scene, solver, job, line),
    }
}

/// Takes the contact set that a library ends with, solves it exactly, and lets the judge decide.
fn repair(
    scene: &Scene,
    solver: Solver,
    job: Job,
    line: impl Fn(&str, bool, usize, usize) -> Line,
) -> Result<Answer, Cause> {
    let scaled = scene.scaled()?;
    let discrete = Discrete::new(&scaled.scene, job.intervals)?;
    let qp = Method::Force.qp(&discrete);
    let answer = solver.run(qp.as_ref(), job.tolerance);
    let start = Instant::now();
    let sizes = qp.sizes();
    // In contact where the force is larger than the clearance, each in its own measure.
    let touching: FreeSet =
        answer.x.iter().zip(&answer.gradient).map(|(p, h)| h / sizes.gradient < p / sizes.x).collect();
    let (x, gradient) = match qp.stationary(&touching) {
        Ok(point) => (point.x, point.gradient),
        Err(_) => (answer.x, answer.gradient),
    };
    let unknowns = qp.dimension();
    drop(qp);
    let nodal = Method::Force.nodal(&discrete, x, gradient);
    let state = contact_state(discrete, nodal);
    let verdict = Kkt::of(&scaled.scene, &state);
    let solved = verdict.is_some_and(|kkt| kkt.holds());
    let line = line(if solved { "solved" } else { "not solved" }, answer.reports_success, answer.iterations, unknowns);
    let added = Some(start.elapsed().as_secs_f64());
    let residual = verdict.map_or(f64::INFINITY, |kkt| kkt.residual());
    Ok(Answer { state: state.in_units_of(&scaled.scale), residual, line, added })
}
