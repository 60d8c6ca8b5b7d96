//! Solvers of the programme (32): two of the paper and one of ours by hand, two libraries. They know algorithms, and of
//! the programme only what [`Programme`] says.

mod active_set;
#[cfg(feature = "clarabel")]
mod clarabel;
mod descent;
mod four_step;
mod neighbourhood;
mod nsor;
#[cfg(feature = "osqp")]
mod osqp;
mod own_residual;
mod solver;

pub use own_residual::OwnResidual;
pub use solver::Solver;

#[cfg(any(feature = "clarabel", feature = "osqp"))]
use crate::problem::Native;
use crate::problem::Programme;

/// What a solver hands back. None of it is believed before the judge has seen it.
#[derive(Debug, Clone, PartialEq)]
pub struct Answer {
    /// The variables `x`, length n.
    pub x: Vec<f64>,
    /// The gradient `g`, or the multipliers of `x ≥ 0` where the solver has its own, length n.
    pub gradient: Vec<f64>,
    /// True if the solver says that it reached the optimum.
    pub claims_success: bool,
    /// The end of the run in the solver's own words.
    pub words: String,
    /// Of a library that came to an end: what it left of its own problem.
    pub own_residual: Option<OwnResidual>,
    /// Steps, pivots, sweeps or iterations.
    pub iterations: usize,
    /// Unknowns that all of these went through: n each, or as many as a neighbourhood has.
    pub work: usize,
}

impl Answer {
    /// An answer of a solver that could not even start.
    fn refused(n: usize, words: String) -> Self {
        Self {
            x: vec![f64::NAN; n],
            gradient: vec![f64::NAN; n],
            claims_success: false,
            words,
            own_residual: None,
            iterations: 0,
            work: 0,
        }
    }
}

impl Solver {
    /// Solves `programme`. `tolerance` is the scaled residual at which an iterative solver may stop.
    #[must_use]
    pub fn run(self, programme: &dyn Programme, tolerance: f64) -> Answer {
        match self {
            Self::FourStep => four_step::solve(programme),
            Self::ActiveSet => active_set::solve(programme),
            Self::Nsor => nsor::solve(programme, tolerance),
            #[cfg(feature = "clarabel")]
            Self::Clarabel => clarabel::solve(programme, tolerance),
            #[cfg(feature = "osqp")]
            Self::Osqp => osqp::solve(programme, tolerance),
        }
    }
}

/// The active set from a guess of the face: `free[i]` is false where `x_i = 0` is expected.
#[must_use]
pub fn active_set_from(programme: &dyn Programme, free: Vec<bool>) -> Answer {
    active_set::solve_from(programme, free).0
}

/// The same, and how many of the solves were of the whole.
pub(crate) fn active_set_counted(programme: &dyn Programme, free: Vec<bool>) -> (Answer, usize) {
    let (answer, cost) = active_set::solve_from(programme, free);
    (answer, cost.whole)
}

/// A guess of the optimal face from that of a coarser problem.
pub(crate) fn guess_from(programme: &dyn Programme, free: Vec<bool>) -> active_set::Guess {
    active_set::guess_from(programme, free)
}

impl Solver {
    /// What the solver is set to when it is asked for `tolerance`, in words.
    #[must_use]
    pub fn settings(self, tolerance: f64) -> String {
        match self {
            Self::FourStep => "nothing to set; at most n + 1 rounds".to_owned(),
            Self::ActiveSet => active_set::words(),
            Self::Nsor => nsor::words(tolerance),
            #[cfg(feature = "clarabel")]
            Self::Clarabel => clarabel::words(tolerance),
            #[cfg(feature = "osqp")]
            Self::Osqp => osqp::words(tolerance),
        }
    }
}

/// Largest dimension for which a solver that needs the matrix as numbers is tried: a dense matrix of this size takes
/// 32 MB, and its factors as much again.
const LARGEST_MATRIX: usize = 2000;

/// The sparse form for a library; from the matrix if the quadratic program has no other, or why it is not tried.
///
/// Both libraries fail on a programme without unknowns (clarabel panics), and on NaN (osqp calls `x = 0` solved);
/// osqp prints to standard output, whatever it was told, where a factorisation shows that there is no minimum.
#[cfg(any(feature = "clarabel", feature = "osqp"))]
fn native(programme: &dyn Programme) -> Result<Native, String> {
    if programme.dimension() == 0 {
        return Err("not tried: the quadratic program has no unknowns".to_owned());
    }
    let native = match programme.native() {
        Some(native) => native,
        None => match too_large(programme) {
            Some(words) => return Err(words),
            None => Native::of_matrix(programme),
        },
    };
    let words = if !native.is_finite() {
        "not tried: the quadratic program has numbers that are not finite"
    } else if !native.is_within(INFINITE) {
        "not tried: the quadratic program has numbers beyond 1e20, which the library takes for infinite"
    } else if native.has_negative_diagonal() {
        "not tried: the matrix of the quadratic program is not positive definite"
    } else {
        return Ok(native);
    };
    Err(words.to_owned())
}

/// What clarabel takes for infinite; osqp takes 1e30, and prints what it thinks of a factorisation that overflows.
#[cfg(any(feature = "clarabel", feature = "osqp"))]
const INFINITE: f64 = 1e20;

/// Why a solver is not tried that would need a larger matrix, if it would.
fn too_large(programme: &dyn Programme) -> Option<String> {
    let n = programme.dimension();
    (LARGEST_MATRIX < n)
        .then(|| format!("not tried: a matrix of {n} unknowns, {LARGEST_MATRIX} is the limit of this solver"))
}
