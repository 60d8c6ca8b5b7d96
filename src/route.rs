//! A route: one of the paper's methods with one of the solvers. Its result before the verdict.

pub use crate::methods::Method;
use crate::solvers::OwnResidual;
pub use crate::solvers::Solver;
use crate::state::ContactState;
pub use crate::verdict::Status;

/// The result of a route, not judged yet.
#[derive(Debug, Clone)]
pub struct RawSolution {
    /// The beam in its final position, in the units of the scene.
    pub state: ContactState,
    /// True if the answer solves the discrete problem: its KKT residual is at most
    /// [`CERTIFIED_RESIDUAL`](crate::certificate::CERTIFIED_RESIDUAL), and all its numbers are finite. How far the beam may be
    /// off is another question, which the [verdict](crate::verdict::Verdict) answers.
    pub solved: bool,
    /// The solver's own message.
    pub solver_status: String,
    /// True if the solver reports that it solved the problem to its tolerance.
    pub solver_reports_success: bool,
    /// True if it reports that it almost did, as `AlmostSolved` of clarabel and `SolvedInaccurate` of osqp. That is no success.
    pub solver_reports_almost: bool,
    /// Of a library: what it left of its own problem, in the norm by which it stops.
    pub own_residual: Option<OwnResidual>,
    /// Dimensionless KKT residual of the discrete problem, by our check; NaN is never "small".
    pub residual: f64,
    /// Unknowns of the quadratic program that was solved.
    pub unknowns: usize,
    /// Steps, pivots, sweeps or iterations, in the solver's own count.
    pub iterations: usize,
    /// Unknowns that all of these went through: a measure of cost without a clock, up to a factor for each solver.
    pub work: usize,
}

impl RawSolution {
    /// The word of tables for how it ended.
    #[must_use]
    pub fn ended(&self) -> &'static str {
        ended(self.solved, self.solver_reports_success || self.solver_reports_almost)
    }
}

/// `solved`, `not solved`, or `gave up` where the solver does not report even an approximate answer.
pub(crate) fn ended(solved: bool, reports_an_answer: bool) -> &'static str {
    match (solved, reports_an_answer) {
        (true, _) => "solved",
        (false, true) => "not solved",
        (false, false) => "gave up",
    }
}
