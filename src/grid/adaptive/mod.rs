//! Adaptive grids: the requested accuracy determines the grid.
//!
//! ```text
//! error ≤ EPS · largest of its kind      proven, for the continuous beam, with the least work
//! ```
//!
//! The grid is refined until the proven error bound of the answer is small enough. The module `plan` predicts the next grid from the
//! observed order of convergence. The module `breaks` puts nodes where the scene breaks. An iterative solver runs with the largest
//! tolerance that is still useful. The proven bound covers the errors of the grid, its nodal loads, the solver and rounding.
//!
//! ```text
//! residual              EPS/10, at least CERTIFIED_RESIDUAL     for the verdict
//! tolerance             EPS/100, at least DEFAULT_TOLERANCE     of an iterative solver
//! ```
//!
//! The solver runs again on the same grid with a smaller tolerance if its answer misses this residual. It also does so if the witness
//! is the answer's own contacts and they cannot be proven. Only then is a finer grid tried.
//!
//! ```
//! use palkki::adaptive::{Request, adapt};
//! use palkki::route::{Method, Solver};
//! use palkki::scene::{Beam, Foundation, Load, Scene};
//!
//! let beam = Beam::new(10.0, 500.0 / 384.0)?;
//! let scene = Scene::new(beam.clone(), Load::uniform_on(&beam, 1.0)?, Some(Foundation::Flat { depth: 1.0 }))?;
//! // The deflection and each number of the summary, certain to a thousandth of the largest of its kind.
//! let adapted = adapt(&scene, &Request::new(Method::Force, Solver::ActiveSet, 1e-3))?;
//! assert!(adapted.solution.verdict.largest_error() <= 1e-3, "{}", adapted.end);
//! // The grids that it took.
//! let grids: Vec<usize> = adapted.trials.iter().map(|trial| trial.intervals).collect();
//! assert_eq!(grids.last(), Some(&adapted.settings.intervals));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! All grids have equal intervals. Grids graded towards lift-off would need fewer nodes for the same error, but neither the methods
//! nor the certificate support them.

mod breaks;
mod order;
mod plan;

use crate::answer::solve::{DEFAULT_TOLERANCE, Settings, solve_raw};
use crate::certificate::CERTIFIED_RESIDUAL;
use crate::route::{Method, Solution, Solver};
use crate::scene::{Scene, SceneError};
use crate::verdict::{Demand, Refusal, Verdict};
use crate::witness::Witness;

use self::plan::{Next, Plan};

pub use self::order::observed_order;

/// A method, a solver and the error bound that their answer must satisfy.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Request {
    /// The method of the paper that sets up the quadratic program.
    pub method: Method,
    /// The solver.
    pub solver: Solver,
    /// `EPS`: the largest allowed error bound of the deflection and of each number of the summary, relative to the largest value of
    /// its kind. Values above [`USABLE`](crate::verdict::USABLE) are reduced to it, because no answer with a larger error is
    /// certified.
    pub error: f64,
    /// The finest grid that is tried.
    pub most_intervals: usize,
}

impl Request {
    /// A request whose finest grid is the finest on which the solver still ends within seconds.
    #[must_use]
    pub fn new(method: Method, solver: Solver, error: f64) -> Self {
        Self { method, solver, error, most_intervals: most_intervals(solver) }
    }

    /// The demand for the verdict.
    fn demand(&self) -> Demand {
        Demand::of_error(self.error)
    }

    /// The first tolerance of an iterative solver: the same fraction of the demanded residual as on a fixed grid.
    fn tolerance(&self) -> f64 {
        if iterates(self.solver) {
            self.demand().residual * (DEFAULT_TOLERANCE / CERTIFIED_RESIDUAL)
        } else {
            DEFAULT_TOLERANCE
        }
    }
}

/// Whether the solver stops at a tolerance. The others end at an optimum or not at all.
fn iterates(solver: Solver) -> bool {
    match solver {
        Solver::ActiveSet | Solver::FourStep => false,
        Solver::Nsor => true,
        #[cfg(feature = "clarabel")]
        Solver::Clarabel => true,
        #[cfg(feature = "osqp")]
        Solver::Osqp => true,
    }
}

/// The finest grid for a solver. The active set needs seconds there. The answers of the library solvers fail certification on much
/// coarser grids, and the four-step solver solves `n` times.
#[must_use]
pub fn most_intervals(solver: Solver) -> usize {
    match solver {
        Solver::ActiveSet => 1_000_000,
        #[cfg(feature = "clarabel")]
        Solver::Clarabel => 20_000,
        #[cfg(feature = "osqp")]
        Solver::Osqp => 20_000,
        Solver::Nsor | Solver::FourStep => 2_000,
    }
}

/// One grid that was tried.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Trial {
    /// `N`, the number of equal intervals.
    pub intervals: usize,
    /// The tolerance of an iterative solver.
    #[cfg_attr(feature = "serde", serde(rename = "solver_tolerance"))]
    pub tolerance: f64,
    /// Unknowns of the quadratic program.
    pub unknowns: usize,
    /// Iterations as the solver counts them.
    pub iterations: usize,
    /// Unknowns treated in all these iterations.
    #[cfg_attr(feature = "serde", serde(skip))]
    pub work: usize,
    /// KKT residual of the discrete problem.
    pub residual: f64,
    /// Largest error bound of the deflection and the numbers of the summary, each relative to the largest value of its kind.
    pub error: f64,
    /// Whether the contacts of the beam were proven.
    #[cfg_attr(feature = "serde", serde(skip))]
    pub contacts_proven: bool,
    /// Whether the solver reports success.
    #[cfg_attr(feature = "serde", serde(skip))]
    pub reports_success: bool,
    /// Why the answer is not good enough; [`None`] if it is.
    #[cfg_attr(feature = "serde", serde(skip))]
    pub refusal: Option<Refusal>,
}

/// How the search ended.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum End {
    /// The answer is good enough.
    #[error("reached")]
    Reached,
    /// The next grid would be finer than the finest allowed one.
    #[error("not reached: {intervals} intervals are the limit of this route")]
    Limit {
        /// The finest grid.
        intervals: usize,
    },
    /// The solves on all grids together have used up the allowed work.
    #[error(
        "not reached: up to {intervals} intervals, the solves have gone through {most} unknowns, which is their limit"
    )]
    Spent {
        /// The finest grid that was tried.
        intervals: usize,
        /// The allowed number of unknowns treated.
        most: usize,
    },
    /// The method and the solver do not solve their own discrete problem well enough.
    #[error("not reached: this route ends at {intervals} intervals, where its answer fails our check: {refusal}")]
    Failed {
        /// The grid on which the check failed.
        intervals: usize,
        /// The reason.
        refusal: Refusal,
    },
    /// Finer grids do not reduce the error, because of rounding or because something cannot be proven.
    #[error("not reached: up to {intervals} intervals, finer grids no longer reduce the proven error")]
    Stalled {
        /// The finest grid that was tried.
        intervals: usize,
    },
}

/// The best answer, and the grids that were tried to find it.
#[derive(Debug, Clone)]
pub struct Adapted {
    /// Method, solver, grid and tolerance of the answer.
    pub settings: Settings,
    /// The answer: certified if and only if the demanded error is reached.
    pub solution: Solution,
    /// All grids, in the order in which they were tried.
    pub trials: Vec<Trial>,
    /// How the search ended.
    pub end: End,
}

/// Chooses the grid for a scene, a method and a solver.
///
/// # Errors
///
/// A [`SceneError`] if the scene leaves the range of `f64`. An accuracy that cannot be reached is not an error: the function returns
/// the best answer, not certified, with the [`End`] that gives the reason.
pub fn adapt(scene: &Scene, request: &Request) -> Result<Adapted, SceneError> {
    let mut search = Search::new(scene, request);
    loop {
        let settings = search.settings();
        let raw = solve_raw(scene, &settings)?;
        if let Some(adapted) = search.record(settings, raw) {
            return Ok(adapted);
        }
    }
}

/// The search in single steps, for a caller that measures the time of each solve.
#[derive(Debug)]
pub struct Search<'a> {
    /// Shared by all grids.
    witness: Witness<'a>,
    request: Request,
    plan: Plan,
    next: (usize, f64),
    trials: Vec<Trial>,
    best: Option<(Settings, Solution)>,
}

impl<'a> Search<'a> {
    /// A search that has not solved anything yet.
    #[must_use]
    pub fn new(scene: &'a Scene, request: &Request) -> Self {
        let plan = Plan::new(scene, request);
        Self {
            witness: Witness::of(scene),
            request: *request,
            next: plan.start(),
            plan,
            trials: Vec::new(),
            best: None,
        }
    }

    /// The settings of the next solve.
    #[must_use]
    pub fn settings(&self) -> Settings {
        let (intervals, tolerance) = self.next;
        Settings { method: self.request.method, solver: self.request.solver, intervals, tolerance }
    }

    /// Judges the answer for [`Search::settings`] and plans the next grid. Returns the best answer when the search has ended.
    pub fn record(&mut self, settings: Settings, raw: Solution<()>) -> Option<Adapted> {
        let solution = raw.judged(&self.witness, &self.request.demand());
        let verdict = &solution.verdict;
        self.trials.push(Trial {
            intervals: settings.intervals,
            tolerance: settings.tolerance,
            unknowns: solution.unknowns,
            iterations: solution.run.iterations,
            work: solution.run.work,
            residual: solution.residual,
            error: verdict.largest_error(),
            contacts_proven: verdict.certificate.as_ref().is_some_and(|c| c.contacts_proven),
            reports_success: solution.run.reports_success,
            refusal: verdict.refusal,
        });
        let better = self.best.as_ref().is_none_or(|(_, best)| rank(verdict) <= rank(&best.verdict));
        let (settings, solution) = if better { (settings, solution) } else { self.best.take()? };
        match self.plan.next(&self.trials) {
            Next::Solve { intervals, tolerance } => {
                self.next = (intervals, tolerance);
                self.best = Some((settings, solution));
                None
            }
            Next::End(end) => Some(Adapted { settings, solution, trials: std::mem::take(&mut self.trials), end }),
        }
    }
}

/// The rank of an answer; lower is better. Certified answers come first, then answers whose only fault is too large an error, then
/// all others. Within a class the smaller error is better.
fn rank(verdict: &Verdict) -> (u8, f64) {
    let class = match verdict.refusal {
        None => 0,
        Some(Refusal::Error { .. } | Refusal::Number { .. }) => 1,
        Some(_) => 2,
    };
    let error = verdict.largest_error();
    (class, if error.is_nan() { f64::INFINITY } else { error })
}
