//! The solvers, as names. A solver that is not part of a build has no name in it.

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
    /// The interior-point solver `clarabel`, with the feature of that name.
    #[cfg(feature = "clarabel")]
    Clarabel,
    /// The operator-splitting solver `osqp`, with the feature of that name.
    #[cfg(feature = "osqp")]
    Osqp,
}

/// How many of the libraries are part of this build.
const LIBRARIES: usize = cfg!(feature = "clarabel") as usize + cfg!(feature = "osqp") as usize;

impl Solver {
    /// All of them.
    pub const ALL: [Self; 3 + LIBRARIES] = [
        Self::FourStep,
        Self::ActiveSet,
        Self::Nsor,
        #[cfg(feature = "clarabel")]
        Self::Clarabel,
        #[cfg(feature = "osqp")]
        Self::Osqp,
    ];

    /// Those that are meant to reach the optimum: all but the paper's four steps.
    pub const OPTIMAL: [Self; 2 + LIBRARIES] = [
        Self::ActiveSet,
        Self::Nsor,
        #[cfg(feature = "clarabel")]
        Self::Clarabel,
        #[cfg(feature = "osqp")]
        Self::Osqp,
    ];

    /// The word that command line, JSON and report use.
    #[must_use]
    pub fn word(self) -> &'static str {
        match self {
            Self::FourStep => "four-step",
            Self::ActiveSet => "active-set",
            Self::Nsor => "nsor",
            #[cfg(feature = "clarabel")]
            Self::Clarabel => "clarabel",
            #[cfg(feature = "osqp")]
            Self::Osqp => "osqp",
        }
    }
}

impl fmt::Display for Solver {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.word())
    }
}
