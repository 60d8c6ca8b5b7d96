//! Method 3, the force method: the complementary energy is minimised and no contact force may be tensile, (25)–(31).
//!
//! The unknowns are the nodal contact forces `p`, and the gradient is the clearance `h`:
//!
//! ```text
//! v = C t,  t = q − p                             (25), (27)
//! h = C p + u − C q,   so  A = C,  b = C q − u    (28)
//! ```
//!
//! If the supports do not hold the beam, there is no `C`. The contact forces must then also balance the loads,
//!
//! ```text
//! minimise ½ pᵀC₀p − (C₀q − g)ᵀp,   p ≥ 0,   Σ p = W,   Σ x p = W x_W
//! ```
//!
//! with the flexibility `C₀` of the beam on any two additional supports. The two multipliers are its rigid motion.
//!
//! `C` (26) is for solvers that need a matrix. On a given set of contacts the three-moment equations of `contact_set.rs` give the
//! same answer in O(n). They do not have the condition number of `C`, which grows like `n⁴`.

// Discrepancy: quadratic-program
//
// The quadratic program (32) is rebuilt from (28), its gradient (33) and its optimality conditions (34), (35).

use nalgebra::DMatrix;

use super::Discrete;
use crate::qp::Matrix;

/// Flexibility `c_ij`, (26): the deflection of node `i` under a unit force at node `j`, for `1 ≤ i, j ≤ n`.
#[must_use]
#[expect(clippy::cast_precision_loss, reason = "dense matrices end long before 2⁵³ nodes")]
pub fn flexibility(length: f64, stiffness: f64, n: usize, i: usize, j: usize) -> f64 {
    // (i, j, n, l) are those of (26), which is printed for i < j and is also valid for i = j.
    let (i, j, n, l) = (i.min(j) as f64, i.max(j) as f64, n as f64, length);
    let m = n + 1.0;
    l * l * l * (1.0 + n - j) * i * (2.0 * j * m - j * j - i * i) / (6.0 * stiffness * (m * m) * (m * m))
}

/// `C` (26) of the paper's beam, shape (n, n).
pub(super) fn matrix(discrete: &Discrete) -> Matrix {
    let (n, Discrete { spacing, stiffness, .. }) = (discrete.unknowns(), discrete);
    #[expect(clippy::cast_precision_loss, reason = "dense matrices end long before 2⁵³ nodes")]
    let length = spacing * (n + 1) as f64;
    Matrix::Dense(DMatrix::from_fn(n, n, |i, j| flexibility(length, *stiffness, n, i + 1, j + 1)))
}
