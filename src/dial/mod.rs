//! The dial: how accurate an answer has to be chooses the grid, not the other way round.
//!
//! ```text
//! deflection_error ≤ EPS · max |v|      guaranteed, for the continuous beam, with the least work
//! ```
//!
//! Grids are refined until the certificate of the answer is good enough. Which grid that will be is predicted from the
//! observed order of convergence (module `plan`), nodes are put where the scene breaks (module `breaks`), and an iterative
//! solver is asked for no more than is of use. The guaranteed error has everything in it: that of the grid, of its
//! nodal loads, of the solver and of rounding.
//!
//! ```text
//! residual demanded     EPS/10, at least CERTIFIED_RESIDUAL     by the judge
//! tolerance asked       EPS/100, at least DEFAULT_TOLERANCE     of an iterative solver
//! ```
//!
//! If the answer to such a loose question fails the judge, or if its own contacts have to serve as a witness and cannot be
//! proven, the solver is asked more strictly on the same grid before a finer one is tried.
//!
//! Grids are of equal intervals. Grids graded towards lift-off would need fewer nodes for the same error, but neither the
//! methods nor the judge know them.

mod breaks;
mod order;
mod plan;
mod request;

use crate::route::Outcome;
use crate::scene::{Scene, SceneError};
use crate::solve::{Settings, solve};
use crate::verdict::{Refusal, Verdict};
use crate::witness::Witness;

use self::plan::{Next, Plan};

pub use self::order::observed_order;
pub use self::request::Request;

/// One grid that was tried.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Try {
    /// `N`, the number of equal intervals.
    pub intervals: usize,
    /// What an iterative solver was asked for.
    pub tolerance: f64,
    /// Unknowns of the programme.
    pub unknowns: usize,
    /// Iterations in the solver's own count.
    pub iterations: usize,
    /// Unknowns that these went through.
    pub work: usize,
    /// KKT residual of the discrete problem.
    pub residual: f64,
    /// Guaranteed error of the deflection, over the largest deflection.
    pub error: f64,
    /// Whether the contacts of the beam were proven.
    pub contacts_proven: bool,
    /// Whether the solver says that it succeeded.
    pub claims_success: bool,
    /// Why it is not enough; none if it is.
    pub refusal: Option<Refusal>,
}

/// How the search ended.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum End {
    /// With an answer that is good enough.
    #[error("reached")]
    Reached,
    /// The next grid would be finer than the finest.
    #[error("not reached: {intervals} intervals are the limit of this route")]
    Limit {
        /// The finest grid.
        intervals: usize,
    },
    /// The route does not solve its own discrete problem well enough.
    #[error("not reached: this route ends at {intervals} intervals, where its answer fails our check: {refusal}")]
    Failed {
        /// On this grid.
        intervals: usize,
        /// Why.
        refusal: Refusal,
    },
    /// Finer grids do not make the error smaller: rounding, or something that cannot be proven.
    #[error("not reached: up to {intervals} intervals, finer grids have stopped making the guaranteed error smaller")]
    Stalled {
        /// The finest grid that was tried.
        intervals: usize,
    },
}

/// The best answer, and what it took.
#[derive(Debug, Clone)]
pub struct Dialled {
    /// Route, grid and tolerance of the answer.
    pub settings: Settings,
    /// The answer.
    pub outcome: Outcome,
    /// The verdict on it: certified if and only if what was asked for is reached.
    pub verdict: Verdict,
    /// All grids, in the order in which they were tried.
    pub tries: Vec<Try>,
    /// How it ended.
    pub end: End,
}

/// Chooses the grid for a scene and a route.
///
/// # Errors
///
/// A [`SceneError`] if the scene leaves the range of `f64`. An error that cannot be reached is none: the best answer comes
/// back, not certified, with the [`End`] that says why.
pub fn dial(scene: &Scene, request: &Request) -> Result<Dialled, SceneError> {
    let mut dial = Dial::new(scene, request);
    loop {
        let settings = dial.settings();
        let outcome = solve(scene, &settings)?;
        if let Some(dialled) = dial.learn(settings, outcome) {
            return Ok(dialled);
        }
    }
}

/// The search step by step, for a caller who looks at a clock in between.
#[derive(Debug)]
pub struct Dial<'a> {
    /// One for all grids.
    witness: Witness<'a>,
    request: Request,
    plan: Plan,
    next: (usize, f64),
    tries: Vec<Try>,
    best: Option<(Settings, Outcome, Verdict)>,
}

impl<'a> Dial<'a> {
    /// Nothing is solved yet.
    #[must_use]
    pub fn new(scene: &'a Scene, request: &Request) -> Self {
        let plan = Plan::new(scene, request);
        Self { witness: Witness::of(scene), request: *request, next: plan.start(), plan, tries: Vec::new(), best: None }
    }

    /// What to solve next.
    #[must_use]
    pub fn settings(&self) -> Settings {
        let (intervals, tolerance) = self.next;
        Settings { method: self.request.method, solver: self.request.solver, intervals, tolerance }
    }

    /// Takes the answer for [`Dial::settings`]; hands back the best one when the search has ended.
    pub fn learn(&mut self, settings: Settings, outcome: Outcome) -> Option<Dialled> {
        let verdict = Verdict::of_outcome(&outcome, &self.witness, &self.request.demand());
        self.tries.push(Try {
            intervals: settings.intervals,
            tolerance: settings.tolerance,
            unknowns: outcome.unknowns,
            iterations: outcome.iterations,
            work: outcome.work,
            residual: outcome.residual,
            error: verdict.error,
            contacts_proven: verdict.certificate.as_ref().is_some_and(|c| c.contacts_proven),
            claims_success: outcome.solver_claims_success,
            refusal: verdict.refusal,
        });
        let better = self.best.as_ref().is_none_or(|(_, _, best)| rank(&verdict) <= rank(best));
        let (settings, outcome, verdict) = if better { (settings, outcome, verdict) } else { self.best.take()? };
        match self.plan.next(&self.tries) {
            Next::Solve { intervals, tolerance } => {
                self.next = (intervals, tolerance);
                self.best = Some((settings, outcome, verdict));
                None
            }
            Next::End(end) => Some(Dialled { settings, outcome, verdict, tries: std::mem::take(&mut self.tries), end }),
        }
    }
}

/// What makes an answer better: that it is certified, that only its error is too large, and then a small error.
fn rank(verdict: &Verdict) -> (u8, f64) {
    let class = match verdict.refusal {
        None => 0,
        Some(Refusal::Error { .. }) => 1,
        Some(_) => 2,
    };
    (class, if verdict.error.is_nan() { f64::INFINITY } else { verdict.error })
}
