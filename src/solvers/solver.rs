//! The solvers, as names.

use std::fmt;

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
