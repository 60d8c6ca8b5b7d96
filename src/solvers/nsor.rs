//! NSOR: successive over-relaxation with projection on `x ≥ 0` (Mangasarian 1977; today also PSOR), which the paper
//! recommends for large `n`:
//!
//! ```text
//! x_i ← max(0, x_i − ω g_i / a_ii),   i = 1 … n,   g_i = (A x − b)_i with the newest x
//! ```
//!
//! It converges for every symmetric positive definite `A` and `0 < ω < 2`. The best `ω` depends on the matrix and is found
//! by trying: each candidate makes the same number of pilot sweeps, and the one with the smallest residual goes on.

// Discrepancy: nsor-relaxation
//
// The paper gives neither a relaxation factor nor a stopping rule for NSOR; its reference /19/ is not available to us.
// We try the factors listed in `nsor.rs` and stop on the scaled residual of the optimality conditions.

use super::{Answer, too_large};
use crate::problem::{Matrix, Programme, residual};

/// Relaxation factors that are tried.
const FACTORS: [f64; 8] = [1.0, 1.2, 1.4, 1.6, 1.7, 1.8, 1.9, 1.95];

/// Sweeps of each pilot run.
const PILOT_SWEEPS: usize = 200;

/// Sweeps between two looks at the residual.
const SWEEPS_PER_LOOK: usize = 10;

/// Budget of a run in multiplications: some seconds on any machine. The limit on sweeps follows from it, so that the
/// answer does not depend on a clock.
const MULTIPLICATIONS: usize = 1 << 30;

/// Runs NSOR until the scaled residual is at most `tolerance`, or the budget is used up.
pub(super) fn solve(programme: &dyn Programme, tolerance: f64) -> Answer {
    if let Some(refusal) = too_large(programme) {
        return refusal;
    }
    let relaxation = Relaxation { programme, matrix: programme.matrix(), linear: programme.linear() };
    let n = programme.dimension();
    let limit = (MULTIPLICATIONS / relaxation.matrix.entries()).max(SWEEPS_PER_LOOK);
    let mut sweeps = 0;

    let mut best: Option<(f64, Vec<f64>, f64)> = None;
    for factor in FACTORS {
        let mut x = vec![0.0; n];
        for _ in 0..PILOT_SWEEPS.min(limit / (2 * FACTORS.len())) {
            relaxation.sweep(&mut x, factor);
            sweeps += 1;
        }
        let left = relaxation.residual(&x);
        if best.as_ref().is_none_or(|(_, _, least)| left < *least) {
            best = Some((factor, x, left));
        }
    }
    let (factor, mut x, mut left) = best.unwrap_or_else(|| (1.0, vec![0.0; n], f64::INFINITY));
    while tolerance < left && sweeps < limit {
        for _ in 0..SWEEPS_PER_LOOK {
            relaxation.sweep(&mut x, factor);
        }
        sweeps += SWEEPS_PER_LOOK;
        left = relaxation.residual(&x);
    }
    let claims_success = left <= tolerance;
    let words = if claims_success {
        format!("converged with ω = {factor}")
    } else {
        format!("not converged: residual {left:.1e} after {sweeps} sweeps with ω = {factor}")
    };
    Answer { gradient: programme.gradient(&x), x, claims_success, words, iterations: sweeps }
}

struct Relaxation<'a> {
    programme: &'a dyn Programme,
    matrix: Matrix,
    linear: Vec<f64>,
}

impl Relaxation<'_> {
    /// One sweep over all variables.
    fn sweep(&self, x: &mut [f64], factor: f64) {
        for i in 0..x.len() {
            let gradient = self.matrix.row_times(i, x) - self.linear[i];
            x[i] = (x[i] - factor * gradient / self.matrix.entry(i, i)).max(0.0);
        }
    }

    fn residual(&self, x: &[f64]) -> f64 {
        residual(self.programme.sizes(), x, &self.programme.gradient(x))
    }
}
