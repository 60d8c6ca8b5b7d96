//! The quadratic program (32), in plain mathematics:
//!
//! ```text
//! minimise ½ xᵀ A x − bᵀ x   subject to   x ≥ 0
//!           (n,n)   (n)
//!
//! gradient     g = A x − b                                            (33)
//! optimality   x ≥ 0,  g ≥ 0,  x_i g_i = 0                            (34), (35)
//! ```
//!
//! `A` is symmetric and positive definite, so the optimum exists and is unique. In rare cases `A` is only semidefinite, but definite
//! on the sets of free variables that occur. Nothing here depends on what a variable stands for. The optimum is found by
//! [`crate::solvers`].

mod band;
pub(crate) mod blocks;
mod explicit;
mod free_set;
mod matrix;
mod ordering;
mod profile;
mod sparse;

pub use band::NotPositiveDefinite;
pub(crate) use band::{Band, Row};
pub use explicit::Explicit;
pub(crate) use explicit::solved_in;
pub use free_set::FreeSet;
pub use matrix::{Matrix, UpperColumns};
pub use profile::Profile;
pub(crate) use profile::Sums;
pub use sparse::SparseForm;

/// A quadratic program (32) that can use its structure.
pub trait Qp {
    /// `n`, the number of variables; at least 1.
    fn dimension(&self) -> usize;

    /// The matrix `A`, shape (n, n), in banded form if it is banded.
    fn matrix(&self) -> Matrix;

    /// The vector `b`, length n: the gradient at zero is `−b`.
    fn linear(&self) -> Vec<f64> {
        self.gradient(&vec![0.0; self.dimension()]).iter().map(|g| -g).collect()
    }

    /// The sparse form of the program, if it has one.
    fn sparse(&self) -> Option<SparseForm> {
        None
    }

    /// The gradient `g = A x − b` (33), length n.
    ///
    /// An implementation uses the structure of its problem, so that it loses fewer digits than the matrix product.
    fn gradient(&self, x: &[f64]) -> Vec<f64>;

    /// Step 1° of the paper's algorithm on the free variables: `g_i = 0` where `x_i` is free, `x_i = 0` elsewhere. A negative number
    /// that may be only the rounding of this solve is set to zero, so that every negative sign is significant.
    ///
    /// # Errors
    ///
    /// [`NotPositiveDefinite`] if rounding destroys the definiteness of `A` on the free set.
    fn stationary(&self, free: &FreeSet) -> Result<Stationary, NotPositiveDefinite>;

    /// The number of unknowns as which a [stationary point](Self::stationary) counts: that of the variables, or more if a solve costs
    /// more per variable.
    fn solve_work(&self) -> usize {
        self.dimension()
    }

    /// If the free variables have no stationary point, replaces them by a set that has one with `x ≥ 0`. This can happen only if `A`
    /// is semidefinite; by default nothing changes.
    fn make_definite(&self, _free: &mut FreeSet) {}

    /// The reason why there is no matrix `A`, if there is none because the variables must also satisfy equations. The
    /// [sparse form](Self::sparse) contains these equations, and [`stationary`](Self::stationary) satisfies them.
    fn without_matrix(&self) -> Option<&'static str> {
        None
    }

    /// Sizes that make `x` and `g` dimensionless numbers of order one.
    fn sizes(&self) -> Sizes;
}

/// A point that is stationary in its free variables.
#[derive(Debug, Clone, PartialEq)]
pub struct Stationary {
    /// `x`, zero where it is not free.
    pub x: Vec<f64>,
    /// `g`, zero where `x` is free.
    pub gradient: Vec<f64>,
}

/// Sizes of the variables and of the gradient, both positive.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sizes {
    /// Size of `x`.
    pub x: f64,
    /// Size of `g`.
    pub gradient: f64,
}

/// The distance of `(x, g)` from optimality: `max_i |min(x_i / X, g_i / G)|`, with the [`Sizes`] `X` and `G`.
///
/// Zero if and only if (34), (35) are satisfied. Infinite for NaN, which `max` alone would ignore.
#[must_use]
pub fn residual(sizes: Sizes, x: &[f64], gradient: &[f64]) -> f64 {
    x.iter().zip(gradient).fold(0.0, |worst: f64, (x, g)| {
        let (x, g) = (x / sizes.x, g / sizes.gradient);
        if x.is_nan() || g.is_nan() { f64::INFINITY } else { worst.max(x.min(g).abs()) }
    })
}
