//! How far the loads can move a freedom at all, whatever it touches: ground beyond that is no ground.
//!
//! ```text
//! J(v) = ½ (v − v0)ᵀ A (v − v0) + constant      v0: displacement without ground,  A: stiffness, of body and ground together
//! J(v*) ≤ J(w),  w = min(g, 0)                  w touches nothing from below
//! |v*_i − v0_i| ≤ √(A⁻¹)_ii ‖w − v0‖_A          Cauchy and Schwarz
//! (A⁻¹)_ii ≤ 1/(a_ii λ)                         λ: least eigenvalue of A scaled to a diagonal of ones
//! ```
//!
//! A gap that is larger is taken for twice that: the optimum is the same, and no digits are lost beside a gap of 1e20. `λ` is an
//! estimate, so that the [proof](super::proof) asks whether the ground there is clear of the body after all.

use super::Kind;
use crate::qp::{Explicit, Sums};

/// Steps of inverse iteration: an estimate needs one digit.
const STEPS: usize = 12;

/// What a spread is multiplied by: what an estimate of the eigenvalue from above may lack, and room below the body.
const ROOM: f64 = 4.0;

/// Neither symmetric nor smooth, so that no eigenvector is missing in it.
pub(super) fn start(n: usize) -> Vec<f64> {
    (0..n).map(|i| f64::from(u8::try_from(i * 7919 % 101).unwrap_or(0)) + 300.0).collect()
}

/// The least eigenvalue of the matrix of a program whose rows and columns are divided by some numbers, by inverse iteration.
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

/// What is known of displacements before anything is solved.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Reach {
    /// Displacements without ground.
    pub(super) free: Vec<f64>,
    /// Gaps, those out of reach nearer.
    pub(super) gap: Vec<f64>,
}

impl Reach {
    /// From the factored matrix, the gaps and the displacements without ground.
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
        // Without loads nothing moves, and any distance will do.
        let norm = if 0.0 < square { square.sqrt() } else { 1.0 };
        let within = |i: usize| gap[i].min(free[i] + ROOM * norm * spread[i]);
        let gap = (0..gap.len()).map(within).collect();
        Self { free, gap }
    }
}

/// The displacements without ground, once in 64 bits.
pub(super) fn displaced_by(qp: &Explicit, load: &[f64], sums: Option<&Sums>) -> Vec<f64> {
    sums.map_or_else(|| qp.solve(load), Sums::rounded)
}
