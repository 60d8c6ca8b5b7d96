//! A route: one of the paper's methods with one of the solvers. An answer, before its verdict and with it.

pub use crate::methods::Method;
use crate::solvers::Run;
pub use crate::solvers::Solver;
use crate::state::ContactState;
use crate::theory::Exact;
pub use crate::verdict::Status;
use crate::verdict::Verdict;

/// An answer of a method on a grid or of beam theory; a `Solution<()>` is not judged yet.
#[derive(Debug, Clone)]
pub struct Solution<V = Verdict> {
    /// The beam in its final position, in the units of the scene.
    pub state: ContactState,
    /// Our verdict: certified or not, why not, and guaranteed bounds.
    pub verdict: V,
    /// True if it solves its own problem: on a grid its residual is at most
    /// [`CERTIFIED_RESIDUAL`](crate::certificate::CERTIFIED_RESIDUAL), of beam theory every condition holds, and all its numbers are
    /// finite. How far the beam may be off is another question, which the [verdict](Verdict) answers.
    pub solved: bool,
    /// What the solver says of it, on which the verdict does not depend, and what it took. The work of beam theory is
    /// [`Exact::work`] and zero here.
    pub run: Run,
    /// On a grid the KKT residual of its discrete problem by our check, of beam theory the worst violation of its conditions;
    /// dimensionless. NaN is never "small".
    pub residual: f64,
    /// Unknowns of what was solved.
    pub unknowns: usize,
    /// Of beam theory: the solution as functions of `x`.
    pub exact: Option<Box<Exact>>,
}

impl<V> Solution<V> {
    /// False if the solver gave none, or one that is not all numbers: the numbers of `state` mean nothing then.
    #[must_use]
    pub fn has_answer(&self) -> bool {
        self.residual.is_finite()
    }

    /// The word of tables for how it ended.
    #[must_use]
    pub fn ended(&self) -> &'static str {
        ended(self.solved, self.run.reports_success || self.run.reports_almost)
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
