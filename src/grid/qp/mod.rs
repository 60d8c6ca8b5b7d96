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
//! `A` is symmetric and positive definite, so the optimum exists and is unique; in rare cases it is only semidefinite, and definite
//! on the sets of free variables that occur. Nothing here depends on what a variable stands for; the optimum is found by
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

    /// The matrix `A`, shape (n, n), banded where it is.
    fn matrix(&self) -> Matrix;

    /// The vector `b`, length n: the gradient at zero is `−b`.
    fn linear(&self) -> Vec<f64> {
        self.gradient(&vec![0.0; self.dimension()]).iter().map(|g| -g).collect()
    }

    /// The program in the variables in which it is sparse, if it has such.
    fn sparse(&self) -> Option<SparseForm> {
        None
    }

    /// The gradient `g = A x − b` (33), length n.
    ///
    /// An implementation uses the structure of its problem, so that fewer digits are lost than by the product.
    fn gradient(&self, x: &[f64]) -> Vec<f64>;

    /// Step 1° of the paper's algorithm on the free variables: `g_i = 0` where `x_i` is free, `x_i = 0` elsewhere. A negative
    /// number that may be nothing but the rounding of this solve is zero, so that every negative sign counts.
    ///
    /// # Errors
    ///
    /// [`NotPositiveDefinite`] if rounding destroys the definiteness of `A` on the free set.
    fn stationary(&self, free: &FreeSet) -> Result<Stationary, NotPositiveDefinite>;

    /// Unknowns that a [stationary point](Self::stationary) goes through: the variables, or more where a solve costs more for each.
    fn solve_work(&self) -> usize {
        self.dimension()
    }

    /// Changes which variables are free, if there is no stationary point on those that are, to a set on which there is one with
    /// `x ≥ 0`: where `A` is only positive semidefinite. Nothing to do for others.
    fn make_definite(&self, _free: &mut FreeSet) {}

    /// Why there is no matrix `A`, if there is none: where variables have to satisfy equations besides. The
    /// [sparse form](Self::sparse) has these, and [`stationary`](Self::stationary) keeps them.
    fn without_matrix(&self) -> Option<&'static str> {
        None
    }

    /// Sizes with which `x` and `g` become dimensionless numbers of order one.
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

/// How far `(x, g)` is from optimality: `max_i |min(x_i / X, g_i / G)|`, with the [`Sizes`] `X` and `G`.
///
/// Zero if and only if (34), (35) hold. Infinite for NaN, which `max` alone would overlook.
#[must_use]
pub fn residual(sizes: Sizes, x: &[f64], gradient: &[f64]) -> f64 {
    x.iter().zip(gradient).fold(0.0, |worst: f64, (x, g)| {
        let (x, g) = (x / sizes.x, g / sizes.gradient);
        if x.is_nan() || g.is_nan() { f64::INFINITY } else { worst.max(x.min(g).abs()) }
    })
}
