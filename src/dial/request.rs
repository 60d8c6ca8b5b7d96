//! What is asked of a route, and how far it may go.

use crate::certificate::CERTIFIED_RESIDUAL;
use crate::route::{Method, Solver};
use crate::solve::DEFAULT_TOLERANCE;
use crate::verdict::Demand;

/// What is asked of a route.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Request {
    /// Which of the paper's methods sets up the programme.
    pub method: Method,
    /// Which solver solves it.
    pub solver: Solver,
    /// `EPS`: the guaranteed error of the deflection, as a share of the largest deflection.
    pub error: f64,
    /// The finest grid to be tried.
    pub most_intervals: usize,
}

impl Request {
    /// A request with the finest grid on which the solver still ends within seconds.
    #[must_use]
    pub fn new(method: Method, solver: Solver, error: f64) -> Self {
        Self { method, solver, error, most_intervals: most_intervals(solver) }
    }

    /// What the judge is asked.
    pub(super) fn demand(&self) -> Demand {
        Demand::of_error(self.error)
    }

    /// What an iterative solver is asked first: the same share of what is demanded as without a dial.
    pub(super) fn tolerance(&self) -> f64 {
        if iterates(self.solver) {
            self.demand().residual * (DEFAULT_TOLERANCE / CERTIFIED_RESIDUAL)
        } else {
            DEFAULT_TOLERANCE
        }
    }
}

/// Whether the solver stops at a tolerance; the others end at an optimum or not at all.
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

/// The finest grid of a solver. The active set needs seconds there; the libraries are no longer certified well before, and
/// the four steps solve `n` times.
fn most_intervals(solver: Solver) -> usize {
    match solver {
        Solver::ActiveSet => 1_000_000,
        #[cfg(feature = "clarabel")]
        Solver::Clarabel => 20_000,
        #[cfg(feature = "osqp")]
        Solver::Osqp => 20_000,
        Solver::Nsor | Solver::FourStep => 2_000,
    }
}
