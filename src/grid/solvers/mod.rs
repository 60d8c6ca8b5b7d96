//! Solvers of the quadratic program (32): two of the paper and one of ours by hand, two libraries. Of a program they use the trait
//! [`Qp`] alone.

pub(crate) mod active_set;
#[cfg(feature = "clarabel")]
mod clarabel;
mod four_step;
mod interior;
mod nsor;
#[cfg(feature = "osqp")]
mod osqp;
mod own_residual;

pub use own_residual::OwnResidual;

use std::fmt;

#[cfg(any(feature = "clarabel", feature = "osqp"))]
use crate::memory::can_be_had;
#[cfg(any(feature = "clarabel", feature = "osqp"))]
use crate::qp::SparseForm;
use crate::qp::{Explicit, FreeSet, Qp};

/// The solvers of the quadratic program (32). A solver that is not part of a build has no name in it.
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
    pub const OPTIMAL: [Self; 2 + LIBRARIES] = {
        let [Self::FourStep, optimal @ ..] = Self::ALL else { panic!("the four steps come first") };
        optimal
    };

    /// The word that command line, JSON and report use.
    #[must_use]
    pub fn name(self) -> &'static str {
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

    /// Solves a quadratic program. `tolerance` is the scaled residual at which an iterative solver may stop.
    #[must_use]
    pub fn run(self, qp: &dyn Qp, tolerance: f64) -> Answer {
        match self {
            _ if qp.dimension() == 0 => Answer::empty("no unknowns, nothing to solve".to_owned()),
            Self::FourStep => four_step::solve(qp),
            Self::ActiveSet => active_set::solve(qp),
            Self::Nsor => nsor::solve(qp, tolerance),
            #[cfg(feature = "clarabel")]
            Self::Clarabel => clarabel::solve(qp, tolerance),
            #[cfg(feature = "osqp")]
            Self::Osqp => osqp::solve(qp, tolerance),
        }
    }

    /// The solver's own tolerance, by the name that it has there, for `tolerance` here: of clarabel `tol_gap_abs`,
    /// `tol_gap_rel` and `tol_feas`, of osqp `eps_abs`, of NSOR the scaled residual; none of a solver that has no tolerance.
    #[must_use]
    pub fn own_tolerance(self, tolerance: f64) -> Option<f64> {
        match self {
            Self::FourStep | Self::ActiveSet => None,
            Self::Nsor => Some(tolerance),
            #[cfg(feature = "clarabel")]
            Self::Clarabel => Some(clarabel::own_tolerance(tolerance)),
            #[cfg(feature = "osqp")]
            Self::Osqp => Some(tolerance),
        }
    }

    /// The solver's settings for `tolerance`.
    #[must_use]
    pub fn settings(self, tolerance: f64) -> String {
        match self {
            Self::FourStep => "nothing to set; at most n + 1 rounds".to_owned(),
            Self::ActiveSet => active_set::settings_text(),
            Self::Nsor => nsor::settings_text(tolerance),
            #[cfg(feature = "clarabel")]
            Self::Clarabel => clarabel::settings_text(tolerance),
            #[cfg(feature = "osqp")]
            Self::Osqp => osqp::settings_text(tolerance),
        }
    }
}

impl fmt::Display for Solver {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.name())
    }
}

/// The result of a solver, which is not checked yet.
#[derive(Debug, Clone, PartialEq)]
pub struct Answer {
    /// The variables `x`, length n.
    pub x: Vec<f64>,
    /// The gradient `g`, or the multipliers of `x ≥ 0` where the solver has its own, length n.
    pub gradient: Vec<f64>,
    /// What the solver says of it, and what it took.
    pub run: Run,
}

/// A run of a solver: what it says of its end, which nothing is concluded from, and what it took.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Run {
    /// True if the solver reports that it reached the optimum to its tolerance.
    pub reports_success: bool,
    /// True if it reports that it almost did, to a larger tolerance than the given one, as `AlmostSolved` of clarabel and
    /// `SolvedInaccurate` of osqp. That is no success.
    pub reports_almost: bool,
    /// The solver's message at its end.
    pub message: String,
    /// Of a library that came to an end: what it left of its own problem.
    pub own_residual: Option<OwnResidual>,
    /// Steps, pivots, sweeps or iterations, in the solver's own count.
    pub iterations: usize,
    /// Unknowns that all of these went through, n each, or as many as a neighbourhood has: a measure of cost without a clock, up to a
    /// factor for each solver.
    pub work: usize,
}

impl Answer {
    /// Without unknowns there is nothing to solve.
    pub(crate) fn empty(message: String) -> Self {
        Self::without_numbers(0, Run { reports_success: true, message, ..Run::default() })
    }

    /// An answer of a solver that could not even start.
    pub(crate) fn refused(n: usize, message: String) -> Self {
        Self::without_numbers(n, Run { message, ..Run::default() })
    }

    /// The end of a run that has no point.
    pub(crate) fn without_numbers(n: usize, run: Run) -> Self {
        Self { x: vec![f64::NAN; n], gradient: vec![f64::NAN; n], run }
    }
}

/// The active set from a guess of the free variables.
#[must_use]
pub fn active_set_from(qp: &dyn Qp, free: FreeSet) -> Answer {
    active_set::solve_from(qp, free)
}

/// The active set from a guess by interior points, where there is only a matrix.
#[must_use]
pub(crate) fn active_set_of(qp: &Explicit) -> Answer {
    active_set::solve_from(qp, interior::free_set(qp))
}

/// Unknowns that one run of the active set may go through, all its solves together: a few hundred solves of a million unknowns.
/// The limit on solves follows from it, so that no clock is needed.
pub(crate) const MOST_WORK: usize = 1 << 28;

/// Most unknowns for which a library is tried: up to here it ends within seconds and some hundred megabytes.
#[cfg(any(feature = "clarabel", feature = "osqp"))]
const LARGEST_SPARSE: usize = 100_000;

/// Largest dimension for which a solver that needs the matrix as numbers is tried: a dense matrix of this size takes
/// 32 MB, and its factors as much again.
const LARGEST_MATRIX: usize = 2000;

/// Memory for an unknown while a library runs: up to 2600 bytes were measured on 10⁵ unknowns.
#[cfg(any(feature = "clarabel", feature = "osqp"))]
const BYTES_PER_UNKNOWN: usize = 3000;

/// The sparse form for a library; from the matrix if the quadratic program has no other, or why it is not tried.
///
/// Both libraries fail on a program without unknowns (clarabel panics), and on NaN (osqp calls `x = 0` solved);
/// osqp prints to standard output, whatever it was told, where a factorisation shows that there is no minimum.
#[cfg(any(feature = "clarabel", feature = "osqp"))]
fn sparse_form(qp: &dyn Qp) -> Result<SparseForm, String> {
    if let Some(message) = too_many(qp.dimension()) {
        return Err(message);
    }
    if !can_be_had(qp.dimension(), BYTES_PER_UNKNOWN) {
        let megabytes = qp.dimension().saturating_mul(BYTES_PER_UNKNOWN) / 1_000_000;
        return Err(format!(
            "not tried: there is no memory for {} unknowns, which take {megabytes} MB",
            qp.dimension()
        ));
    }
    let form = match qp.sparse() {
        Some(form) => form,
        None => match no_matrix(qp).or_else(|| too_large(qp)) {
            Some(message) => return Err(message),
            None => SparseForm::of_matrix(qp),
        },
    };
    let message = if !form.is_finite() {
        "not tried: the quadratic program has numbers that are not finite"
    } else if !form.is_within(INFINITE) {
        "not tried: the quadratic program has numbers beyond 1e20, which the library takes for infinite"
    } else if form.has_negative_diagonal() {
        "not tried: the matrix of the quadratic program is not positive definite"
    } else {
        return Ok(form);
    };
    Err(message.to_owned())
}

/// Why a library is not tried on so many unknowns, if it is not.
#[cfg(any(feature = "clarabel", feature = "osqp"))]
fn too_many(n: usize) -> Option<String> {
    (LARGEST_SPARSE < n).then(|| format!("not tried: {n} unknowns, {LARGEST_SPARSE} is the limit of this solver"))
}

/// What clarabel takes for infinite; osqp takes 1e30, and prints a message where a factorisation overflows.
#[cfg(any(feature = "clarabel", feature = "osqp"))]
const INFINITE: f64 = 1e20;

/// Why a solver is not tried that needs the matrix, if there is none.
fn no_matrix(qp: &dyn Qp) -> Option<String> {
    qp.without_matrix().map(|why| format!("not tried: {why}"))
}

/// Why a solver is not tried that would need a larger matrix, if it would.
fn too_large(qp: &dyn Qp) -> Option<String> {
    let n = qp.dimension();
    (LARGEST_MATRIX < n)
        .then(|| format!("not tried: a matrix of {n} unknowns, {LARGEST_MATRIX} is the limit of this solver"))
}

#[cfg(all(test, any(feature = "clarabel", feature = "osqp")))]
mod tests {
    use super::*;

    #[test]
    fn a_library_is_tried_up_to_its_limit() {
        assert_eq!(too_many(LARGEST_SPARSE), None);
        let message = too_many(LARGEST_SPARSE + 1).expect("one more is too many");
        assert_eq!(message, "not tried: 100001 unknowns, 100000 is the limit of this solver");
    }
}
