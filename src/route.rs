//! A route: one of the paper's methods with one of the solvers. What a route ends with, and how it went.

pub use crate::methods::Method;
use crate::solvers::OwnResidual;
pub use crate::solvers::Solver;
use crate::state::ContactState;
pub use crate::verdict::Status;

/// What a route hands back.
#[derive(Debug, Clone)]
pub struct RawSolution {
    /// The beam in its final position, in the units of the scene.
    pub state: ContactState,
    /// Our verdict.
    pub status: Status,
    /// What the solver says of itself, in its own words.
    pub solver_status: String,
    /// True if the solver says that it solved the problem.
    pub solver_reports_success: bool,
    /// Of a library: what it left of its own problem, in the norm by which it stops.
    pub own_residual: Option<OwnResidual>,
    /// Dimensionless KKT residual of the discrete problem, by our judge; NaN is never "small".
    pub residual: f64,
    /// Unknowns of the quadratic program that was solved.
    pub unknowns: usize,
    /// Steps, pivots, sweeps or iterations, in the solver's own count.
    pub iterations: usize,
    /// Unknowns that all of these went through: what they cost, without a clock and up to a factor for each solver.
    pub work: usize,
}
