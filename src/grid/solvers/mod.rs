//! Solvers of the quadratic program (32): two of the paper, one of ours, and two libraries. They use a program only through the trait
//! [`Qp`].

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

/// The solvers of the quadratic program (32). A build contains only the names of the solvers that it includes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Solver {
    /// The paper's own algorithm, as printed; it may stop at a point that is not optimal.
    FourStep,
    /// Block principal pivoting with a finite fallback, our implementation.
    ActiveSet,
    /// Projected successive over-relaxation, our implementation.
    Nsor,
    /// The interior-point solver `clarabel`, with the feature of that name.
    #[cfg(feature = "clarabel")]
    Clarabel,
    /// The operator-splitting solver `osqp`, with the feature of that name.
    #[cfg(feature = "osqp")]
    Osqp,
}

/// Number of solver libraries in this build.
const LIBRARIES: usize = cfg!(feature = "clarabel") as usize + cfg!(feature = "osqp") as usize;

impl Solver {
    /// All solvers.
    pub const ALL: [Self; 3 + LIBRARIES] = [
        Self::FourStep,
        Self::ActiveSet,
        Self::Nsor,
        #[cfg(feature = "clarabel")]
        Self::Clarabel,
        #[cfg(feature = "osqp")]
        Self::Osqp,
    ];

    /// The solvers that are meant to reach the optimum: all except the paper's four steps.
    pub const OPTIMAL: [Self; 2 + LIBRARIES] = {
        let [Self::FourStep, optimal @ ..] = Self::ALL else { panic!("the four steps come first") };
        optimal
    };

    /// The name used by command line, JSON and report.
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

    /// The tolerance that a solver uses for `tolerance` here: `tol_gap_abs`, `tol_gap_rel` and `tol_feas` of clarabel, `eps_abs` of
    /// osqp, the scaled residual of NSOR; [`None`] for a solver without a tolerance.
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

    /// The settings of the solver for `tolerance`, as text.
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

/// The result of a solver, not yet checked.
#[derive(Debug, Clone, PartialEq)]
pub struct Answer {
    /// The variables `x`, length n.
    pub x: Vec<f64>,
    /// The gradient `g`, length n, or the multipliers of `x ≥ 0` if the solver computes its own.
    pub gradient: Vec<f64>,
    /// The solver's report and its cost.
    pub run: Run,
}

/// A run of a solver: its own report, from which nothing is concluded, and its cost.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Run {
    /// Whether the solver reports that it reached the optimum to its tolerance.
    pub reports_success: bool,
    /// Whether the solver reports that it almost did, to a larger tolerance than the given one, as `AlmostSolved` of clarabel and
    /// `SolvedInaccurate` of osqp do. This does not count as success.
    pub reports_almost: bool,
    /// The solver's final message.
    pub message: String,
    /// For a library that returned a point: the residual of its own problem.
    pub own_residual: Option<OwnResidual>,
    /// Steps, pivots, sweeps or iterations, as the solver counts them.
    pub iterations: usize,
    /// Unknowns treated in all iterations: n for each, or as many as a neighbourhood contains. A measure of cost without a clock, up
    /// to a factor for each solver.
    pub work: usize,
}

impl Answer {
    /// The answer to a program without unknowns, where there is nothing to solve.
    pub(crate) fn empty(message: String) -> Self {
        Self::without_numbers(0, Run { reports_success: true, message, ..Run::default() })
    }

    /// The answer of a solver that could not start.
    pub(crate) fn refused(n: usize, message: String) -> Self {
        Self::without_numbers(n, Run { message, ..Run::default() })
    }

    /// The answer of a run that ended without a point.
    pub(crate) fn without_numbers(n: usize, run: Run) -> Self {
        Self { x: vec![f64::NAN; n], gradient: vec![f64::NAN; n], run }
    }
}

/// The active set, starting from a guess of the free variables.
#[must_use]
pub fn active_set_from(qp: &dyn Qp, free: FreeSet) -> Answer {
    active_set::solve_from(qp, free)
}

/// The active set, starting from a guess by interior points, for a program given by its matrix.
#[must_use]
pub(crate) fn active_set_of(qp: &Explicit) -> Answer {
    active_set::solve_from(qp, interior::free_set(qp))
}

/// Limit on the unknowns in all solves of one run of the active set: a few hundred solves of a million unknowns. The limit on solves
/// follows from it, so that no clock is needed.
pub(crate) const MOST_WORK: usize = 1 << 28;

/// Largest number of unknowns for which a library is tried: up to here it needs seconds and some hundred megabytes.
#[cfg(any(feature = "clarabel", feature = "osqp"))]
const LARGEST_SPARSE: usize = 100_000;

/// Largest dimension for which a solver that needs the matrix as numbers is tried. A dense matrix of this size needs 32 MB, and its
/// factors as much again.
const LARGEST_MATRIX: usize = 2000;

/// Memory per unknown while a library runs; up to 2600 bytes were measured on 10⁵ unknowns.
#[cfg(any(feature = "clarabel", feature = "osqp"))]
const BYTES_PER_UNKNOWN: usize = 3000;

/// The sparse form for a library, from the matrix if the quadratic program has no other; or the reason why the library is not tried.
///
/// Both libraries fail on a program without unknowns (clarabel panics) and on NaN (osqp calls `x = 0` solved). If a factorisation
/// shows that there is no minimum, osqp prints to standard output whatever its settings.
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

/// The reason why a library is not tried on so many unknowns, if it is not.
#[cfg(any(feature = "clarabel", feature = "osqp"))]
fn too_many(n: usize) -> Option<String> {
    (LARGEST_SPARSE < n).then(|| format!("not tried: {n} unknowns, {LARGEST_SPARSE} is the limit of this solver"))
}

/// The value that clarabel treats as infinite. osqp treats 1e30 so, and prints a message if a factorisation overflows.
#[cfg(any(feature = "clarabel", feature = "osqp"))]
const INFINITE: f64 = 1e20;

/// The reason why a solver that needs the matrix is not tried, if there is no matrix.
fn no_matrix(qp: &dyn Qp) -> Option<String> {
    qp.without_matrix().map(|why| format!("not tried: {why}"))
}

/// The reason why a solver that needs the matrix is not tried, if the matrix would be too large.
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
