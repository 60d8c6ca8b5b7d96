//! One measurement: an answer, our verdict on it, and how long it takes.

use std::hint::black_box;
use std::time::Instant;

use palkki::adaptive::{End, Request, adapt};
use palkki::certificate::Kkt;
use palkki::methods::{Discrete, Method, contact_state};
use palkki::problem::FreeSet;
use palkki::route::Status;
use palkki::scene::{Scene, SceneError};
use palkki::solvers::{OwnResidual, Solver};
use palkki::state::ContactState;
use palkki::{Settings, Witness, solve, theory, verdict};

use super::memory;
use super::plan::{Job, Route};
use super::tridiagonal::Tridiagonal;

/// Runs of each job that is quick enough: few microseconds, and memory that is fetched anew, are a matter of luck.
const RUNS: usize = 25;
/// No more runs after so many seconds, unless the yardstick lies beside them.
const ENOUGH: f64 = 0.25;

/// An answer and what it cost.
#[derive(Debug, Clone)]
pub(crate) struct Measured {
    pub(crate) state: ContactState,
    pub(crate) status: Status,
    pub(crate) claims_success: bool,
    pub(crate) residual: f64,
    /// Of a library: what it left of its own problem.
    pub(crate) own_residual: Option<OwnResidual>,
    pub(crate) iterations: usize,
    pub(crate) unknowns: usize,
    /// Seconds of each run, ascending.
    pub(crate) seconds: Vec<f64>,
    /// Seconds of a repair without those of the library, the median.
    pub(crate) added: Option<f64>,
    /// Seconds of a tridiagonal solve of the same size, run in turns with it, the median.
    pub(crate) yardstick: Option<f64>,
    /// Seconds of the certificate of the answer, run in turns with it as well, the median.
    pub(crate) certificate: Option<f64>,
    /// Of the adaptive grid: intervals of the last grid, and the certified error of the deflection over its largest value.
    pub(crate) adaptive: Option<(usize, f64)>,
    /// Kilobytes at the most, in a process of its own.
    pub(crate) peak: Option<u64>,
}

impl Measured {
    /// Runs a job several times; the answer is the same each time.
    pub(crate) fn of(scene_name: &str, scene: &Scene, job: Job) -> Result<Self, String> {
        let mut seconds = Vec::new();
        let mut measured: Option<Self> = None;
        // The yardstick and the certificate are laid beside the same jobs, in turns with them.
        let mut ruler = job.is_ruled().then(|| Tridiagonal::new(job.intervals - 1));
        let (mut added, mut yardstick, mut certificate) = (Vec::new(), Vec::new(), Vec::new());
        while seconds.len() < RUNS && (job.is_ruled() || seconds.iter().sum::<f64>() < ENOUGH) {
            // The answer of the last run goes first: no run has to share memory with it.
            drop(measured.take());
            if let Some(ruler) = &mut ruler {
                yardstick.push(ruler.seconds());
            }
            let start = Instant::now();
            let answer = once(scene, job)?;
            seconds.push(start.elapsed().as_secs_f64());
            if job.is_ruled() {
                let start = Instant::now();
                black_box(verdict::certificate(&answer.state, &Witness::of(scene)));
                certificate.push(start.elapsed().as_secs_f64());
            }
            added.extend(answer.added);
            measured = Some(answer);
        }
        seconds.sort_by(f64::total_cmp);
        let peak = if job.is_weighed() { memory::peak(scene_name, job) } else { None };
        let [added, yardstick, certificate] = [added, yardstick, certificate].map(median);
        measured
            .map(|answer| Self { seconds, added, yardstick, certificate, peak, ..answer })
            .ok_or_else(|| "no run at all".to_owned())
    }

    /// A state of which nothing else is known yet.
    fn untimed(state: ContactState) -> Self {
        let status = Status::NotCertified;
        let (claims_success, residual, iterations, unknowns) = (false, f64::INFINITY, 0, 0);
        let own_residual = None;
        let (seconds, added, yardstick, certificate, peak) = (Vec::new(), None, None, None, None);
        Self {
            state,
            status,
            claims_success,
            residual,
            own_residual,
            iterations,
            unknowns,
            seconds,
            added,
            yardstick,
            certificate,
            adaptive: None,
            peak,
        }
    }
}

/// The median, if there is anything.
fn median(mut seconds: Vec<f64>) -> Option<f64> {
    seconds.sort_by(f64::total_cmp);
    seconds.get(seconds.len() / 2).copied()
}

fn once(scene: &Scene, job: Job) -> Result<Measured, String> {
    match job.route {
        Route::Optimum(_) => Err("the proven optimum is no solver".to_owned()),
        Route::Exact => {
            let exact = theory::solve(scene).map_err(|error| error.to_string())?;
            Ok(Measured {
                status: exact.status,
                claims_success: exact.status == Status::Certified,
                residual: exact.residual,
                iterations: exact.iterations,
                unknowns: exact.unknowns,
                ..Measured::untimed(exact.state)
            })
        }
        Route::Solver(method, solver) => {
            let settings = Settings { method, solver, intervals: job.intervals, tolerance: job.tolerance };
            let outcome = solve(scene, &settings).map_err(|error| error.to_string())?;
            Ok(Measured {
                status: outcome.status,
                claims_success: outcome.solver_claims_success,
                residual: outcome.residual,
                own_residual: outcome.own_residual,
                iterations: outcome.iterations,
                unknowns: outcome.unknowns,
                ..Measured::untimed(outcome.state)
            })
        }
        Route::Adaptive(method, solver) => {
            let found =
                adapt(scene, &Request::new(method, solver, job.tolerance)).map_err(|error| error.to_string())?;
            Ok(Measured {
                status: found.solution.verdict.status,
                claims_success: found.end == End::Reached,
                residual: found.solution.residual,
                iterations: found.trials.iter().map(|tried| tried.iterations).sum(),
                unknowns: found.solution.unknowns,
                adaptive: Some((found.settings.intervals, found.solution.verdict.error)),
                ..Measured::untimed(found.solution.state)
            })
        }
        Route::Repair(solver) => repair(scene, solver, job).map_err(|error| error.to_string()),
    }
}

/// Takes the contact set that a library ends with, solves it exactly, and lets the judge decide.
fn repair(scene: &Scene, solver: Solver, job: Job) -> Result<Measured, SceneError> {
    let scaled = scene.scaled()?;
    let discrete = Discrete::new(&scaled.scene, job.intervals)?;
    let programme = Method::Force.programme(&discrete);
    let answer = solver.run(programme.as_ref(), job.tolerance);
    let start = Instant::now();
    let sizes = programme.sizes();
    // In contact where the force is larger than the clearance, each in its own measure.
    let touching: FreeSet =
        answer.x.iter().zip(&answer.gradient).map(|(p, h)| h / sizes.gradient < p / sizes.x).collect();
    let (x, gradient) = match programme.stationary(&touching) {
        Ok(point) => (point.x, point.gradient),
        Err(_) => (answer.x, answer.gradient),
    };
    let unknowns = programme.dimension();
    drop(programme);
    let nodal = Method::Force.nodal(&discrete, x, gradient);
    let state = contact_state(discrete, nodal);
    let verdict = Kkt::of(&scaled.scene, &state);
    Ok(Measured {
        status: if verdict.is_some_and(|kkt| kkt.holds()) { Status::Certified } else { Status::NotCertified },
        claims_success: answer.claims_success,
        residual: verdict.map_or(f64::INFINITY, |kkt| kkt.residual()),
        iterations: answer.iterations,
        unknowns,
        added: Some(start.elapsed().as_secs_f64()),
        ..Measured::untimed(state.in_units_of(&scaled.scale))
    })
}
