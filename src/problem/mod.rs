//! The quadratic programme (32), in plain mathematics:
//!
//! ```text
//! minimise ½ xᵀ A x − bᵀ x   subject to   x ≥ 0
//!           (n,n)   (n)
//!
//! gradient     g = A x − b                                            (33)
//! optimality   x ≥ 0,  g ≥ 0,  x_i g_i = 0                            (34), (35)
//! ```
//!
//! `A` is symmetric and positive definite, so the optimum exists and is unique. This room knows nothing of
//! what a variable stands for; how the optimum is found is the business of [`crate::solvers`].

use std::ops::Range;

mod dense;
mod ldl;
mod matrix;
mod native;

pub use dense::Dense;
pub use ldl::{Band, NotPositiveDefinite};
pub use matrix::{Matrix, UpperColumns};
pub use native::Native;

/// A programme (32) that can use its structure.
pub trait Programme {
    /// `n`, the number of variables; at least 1.
    fn dimension(&self) -> usize;

    /// The matrix `A`, shape (n, n), banded where it is.
    fn matrix(&self) -> Matrix;

    /// The vector `b`, length n.
    fn linear(&self) -> Vec<f64>;

    /// The programme in the variables in which it is sparse, if it has such.
    fn native(&self) -> Option<Native> {
        None
    }

    /// The gradient `g = A x − b` (33), length n.
    ///
    /// An implementation uses the structure of its problem, so that fewer digits are lost than by the product.
    fn gradient(&self, x: &[f64]) -> Vec<f64>;

    /// Step 1° of the paper's algorithm on the free variables: `x_i = 0` where `free[i]` is false, `g_i = 0` where it is
    /// true.
    ///
    /// # Errors
    ///
    /// [`NotPositiveDefinite`] if rounding destroys the definiteness of `A` on the free set.
    fn stationary(&self, free: &[bool]) -> Result<Stationary, NotPositiveDefinite>;

    /// The same point, but only at the variables of `range`, which are alone in the result.
    ///
    /// For problems in which a change of the face is felt in its neighbourhood only. What comes back is the whole point up to
    /// rounding.
    ///
    /// # Errors
    ///
    /// [`NotPositiveDefinite`] as above.
    fn stationary_near(&self, free: &[bool], range: Range<usize>) -> Result<Stationary, NotPositiveDefinite> {
        let Stationary { x, gradient } = self.stationary(free)?;
        Ok(Stationary { x: x[range.clone()].to_vec(), gradient: gradient[range].to_vec() })
    }

    /// Whether [`stationary_near`](Self::stationary_near) is cheaper than the whole.
    fn has_neighbourhoods(&self) -> bool {
        false
    }

    /// The programme in the gradient, up to units, if there is one that [has neighbourhoods](Self::has_neighbourhoods):
    ///
    /// ```text
    /// minimise ½ gᵀ A⁻¹ g + bᵀ A⁻¹ g   subject to   g ≥ 0,      with the gradient A⁻¹ (g + b) = x
    /// ```
    ///
    /// Free is there what is not free here, and the optimum is the same.
    fn dual(&self) -> Option<Box<dyn Programme + '_>> {
        None
    }

    /// Rounding of `x` and `g` at a stationary point, as a share of their sizes: a sign below that means nothing. Zero if signs
    /// can be taken at their word.
    ///
    /// By default a few thousand units in the last place.
    fn rounding(&self) -> f64 {
        1e-12
    }

    /// Sizes with which `x` and `g` become dimensionless numbers of order one.
    fn sizes(&self) -> Sizes;
}

/// A point that is stationary on a face of the feasible set.
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
