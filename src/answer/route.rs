//! A route is one of the paper's methods with one of the solvers. This module defines its answer, before and after the verdict.

pub use crate::methods::Method;
use crate::solvers::Run;
pub use crate::solvers::Solver;
use crate::state::ContactState;
use crate::theory::Exact;
pub use crate::verdict::Status;
use crate::verdict::Verdict;

/// An answer from a method on a grid or from beam theory. A `Solution<()>` has no verdict yet.
#[derive(Debug, Clone)]
pub struct Solution<V = Verdict> {
    /// The beam in its final position, in the units of the scene.
    pub state: ContactState,
    /// The verdict: certified or not, the reason if not, and proven error bounds.
    pub verdict: V,
    /// True if the answer solves its own problem and all its numbers are finite. On a grid the residual must be at most
    /// [`CERTIFIED_RESIDUAL`](crate::certificate::CERTIFIED_RESIDUAL); in beam theory all conditions must be satisfied. The error
    /// of the beam is a separate question, which the [verdict](Verdict) answers.
    pub solved: bool,
    /// The status and the work that the solver reports; the verdict does not depend on them. For beam theory the work is
    /// [`Exact::work`] and zero here.
    pub run: Run,
    /// On a grid the KKT residual of the discrete problem, computed by our own check. In beam theory the maximum violation of its
    /// conditions. Dimensionless; NaN never counts as small.
    pub residual: f64,
    /// Number of unknowns of the problem that was solved.
    pub unknowns: usize,
    /// For beam theory, the solution as functions of `x`.
    pub exact: Option<Box<Exact>>,
}

impl<V> Solution<V> {
    /// False if the solver returned no answer, or one with numbers that are not finite. The numbers of `state` are then
    /// meaningless.
    #[must_use]
    pub fn has_answer(&self) -> bool {
        self.residual.is_finite()
    }

    /// The outcome in one or two words, for tables.
    #[must_use]
    pub fn ended(&self) -> &'static str {
        ended(self.solved, self.run.reports_success || self.run.reports_almost)
    }
}

/// `solved`, `not solved`, or `gave up` if the solver does not even report an approximate answer.
pub(crate) fn ended(solved: bool, reports_an_answer: bool) -> &'static str {
    match (solved, reports_an_answer) {
        (true, _) => "solved",
        (false, true) => "not solved",
        (false, false) => "gave up",
    }
}
