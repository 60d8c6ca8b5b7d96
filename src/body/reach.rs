//! Bounds on the displacement that the loads can cause, whatever contacts occur. Beyond these bounds a foundation has no effect.
//!
//! ```text
//! J(v) = ½ (v − v0)ᵀ A (v − v0) + constant      v0: displacement without foundation,  A: stiffness of body and foundation together
//! J(v*) ≤ J(w),  w = min(g, 0)                  w is admissible
//! |v*_i − v0_i| ≤ √(A⁻¹)_ii ‖w − v0‖_A          Cauchy and Schwarz
//! (A⁻¹)_ii ≤ 1/(a_ii λ)                         λ: smallest eigenvalue of A scaled to a unit diagonal
//! ```
//!
//! A larger gap is replaced by `v0` plus a multiple of this bound (`ROOM`). The optimum remains the same, and a gap of 1e20
//! causes no loss of digits. `λ` is only an estimate. The [proof](super::proof) therefore checks that no contact occurs at the
//! reduced gap.

use super::Kind;
use crate::qp::{Explicit, Sums};

/// Steps of inverse iteration: the estimate needs one correct digit.
const STEPS: usize = 12;

/// Factor on the bound: it covers the error of the eigenvalue, which is estimated from above, and leaves a clearance below the
/// body.
const ROOM: f64 = 4.0;

/// Start vector, neither symmetric nor smooth, so that it contains a part of every eigenvector.
pub(super) fn start(n: usize) -> Vec<f64> {
    (0..n).map(|i| f64::from(u8::try_from(i * 7919 % 101).unwrap_or(0)) + 300.0).collect()
}

/// The smallest eigenvalue of the matrix of a program after division of its rows and columns by `roots`, by inverse iteration.
pub(super) fn least_eigenvalue(qp: &Explicit, roots: &[f64]) -> f64 {
    let norm = |v: &[f64]| v.iter().map(|v| v * v).sum::<f64>().sqrt();
    let mut v = start(roots.len());
    let mut estimate = f64::INFINITY;
    for _ in 0..STEPS {
        let size = norm(&v);
        let scaled: Vec<f64> = v.iter().zip(roots).map(|(v, root)| v / size * root).collect();
        v = qp.solve(&scaled).iter().zip(roots).map(|(v, root)| v * root).collect();
        estimate = 1.0 / norm(&v);
    }
    estimate
}

/// Bounds on displacements that are known before the program is solved.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Reach {
    /// Displacements without a foundation.
    pub(super) free: Vec<f64>,
    /// Gaps, reduced where the foundation is out of reach.
    pub(super) gap: Vec<f64>,
}

impl Reach {
    /// Computes the reduced gaps from the factored matrix, the gaps and the displacements without a foundation.
    pub(super) fn new(kind: Kind, qp: &Explicit, gap: &[f64], free: Vec<f64>) -> Self {
        let away: Vec<f64> = gap.iter().zip(&free).map(|(gap, free)| gap.min(0.0) - free).collect();
        let roots: Vec<f64> = qp.profile().diagonal().map(f64::sqrt).collect();
        let (other, spread): (_, Vec<f64>) = match kind {
            Kind::Stiffness => {
                let root = least_eigenvalue(qp, &roots).sqrt();
                (qp.profile().times(&away), roots.iter().map(|diagonal| 1.0 / (diagonal * root)).collect())
            }
            Kind::Flexibility => (qp.solve(&away), roots),
        };
        let square: f64 = away.iter().zip(&other).map(|(a, b)| a * b).sum();
        // Without loads nothing moves, and any distance is sufficient.
        let norm = if 0.0 < square { square.sqrt() } else { 1.0 };
        let within = |i: usize| gap[i].min(free[i] + ROOM * norm * spread[i]);
        let gap = (0..gap.len()).map(within).collect();
        Self { free, gap }
    }
}

/// The displacements without a foundation, in 64-bit numbers.
pub(super) fn displaced_by(qp: &Explicit, load: &[f64], sums: Option<&Sums>) -> Vec<f64> {
    sums.map_or_else(|| qp.solve(load), Sums::rounded)
}
