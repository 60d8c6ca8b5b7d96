//! A route: one of the paper's methods with one of the solvers. What a route ends with, and how it went.

use std::fmt;

use crate::state::ContactState;

/// The three methods of the paper.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Method {
    /// Complementarity problem by finite differences, (4)–(16).
    Complementarity,
    /// Potential energy, no penetration, (17)–(24).
    Displacement,
    /// Complementary energy, no tension, (25)–(31).
    Force,
}

impl Method {
    /// All of them, in the order of the paper.
    pub const ALL: [Self; 3] = [Self::Complementarity, Self::Displacement, Self::Force];

    /// The word that command line, JSON and report use.
    #[must_use]
    pub fn word(self) -> &'static str {
        match self {
            Self::Complementarity => "complementarity",
            Self::Displacement => "displacement",
            Self::Force => "force",
        }
    }
}

impl fmt::Display for Method {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.word())
    }
}

/// The solvers of the programme (32).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Solver {
    /// The paper's own algorithm, as printed; it may stop at a point that is not optimal.
    FourStep,
    /// Block principal pivoting with a finite fallback, by hand.
    ActiveSet,
    /// Projected successive over-relaxation, by hand.
    Nsor,
    /// The interior-point solver `clarabel`.
    Clarabel,
    /// The operator-splitting solver `osqp`.
    Osqp,
}

impl Solver {
    /// All of them.
    pub const ALL: [Self; 5] = [Self::FourStep, Self::ActiveSet, Self::Nsor, Self::Clarabel, Self::Osqp];

    /// The four that are meant to reach the optimum: all but the paper's four steps.
    pub const OPTIMAL: [Self; 4] = [Self::ActiveSet, Self::Nsor, Self::Clarabel, Self::Osqp];

    /// The word that command line, JSON and report use.
    #[must_use]
    pub fn word(self) -> &'static str {
        match self {
            Self::FourStep => "four-step",
            Self::ActiveSet => "active-set",
            Self::Nsor => "nsor",
            Self::Clarabel => "clarabel",
            Self::Osqp => "osqp",
        }
    }
}

impl fmt::Display for Solver {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.word())
    }
}

/// Our own verdict on an answer. A solver's own word is never it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Status {
    /// The answer passes our own check.
    Certified,
    /// An answer came back and fails it.
    NotCertified,
    /// The solver gave up, and what it had fails our check.
    NotConverged,
}

impl Status {
    /// The word that JSON and report use.
    #[must_use]
    pub fn word(self) -> &'static str {
        match self {
            Self::Certified => "certified",
            Self::NotCertified => "not-certified",
            Self::NotConverged => "not-converged",
        }
    }
}

impl fmt::Display for Status {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.word())
    }
}

/// What a route hands back.
#[derive(Debug, Clone)]
pub struct Outcome {
    /// The beam in its final position, in the units of the scene.
    pub state: ContactState,
    /// Our verdict.
    pub status: Status,
    /// What the solver says of itself, in its own words.
    pub solver_status: String,
    /// True if the solver says that it solved the problem.
    pub solver_claims_success: bool,
    /// Dimensionless KKT residual of the discrete problem, by our judge; NaN is never "small".
    pub residual: f64,
    /// Unknowns of the programme that was solved.
    pub unknowns: usize,
    /// Steps, pivots, sweeps or iterations, in the solver's own count.
    pub iterations: usize,
}
