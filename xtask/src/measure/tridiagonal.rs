//! The yardstick: one solve of a tridiagonal system of n equations, by elimination and substitution without pivoting.
//!
//! ```text
//! M_{i−1} + 4 M_i + M_{i+1} = r_i         the three-moment equations of a beam that rests on every node
//! ```
//!
//! Coefficients and right-hand side stand in memory before the clock starts, and so does the memory for the answer: what is
//! timed is the bare solve. The coefficients are read and divided by, as if they were not all the same.

use std::hint::black_box;
use std::time::Instant;

/// A system of n equations: below the diagonal, on it, above it, right-hand side.
#[derive(Debug)]
pub(super) struct Tridiagonal {
    rows: Vec<[f64; 4]>,
    /// What an eliminated unknown keeps of its right neighbour.
    passed: Vec<f64>,
    x: Vec<f64>,
}

impl Tridiagonal {
    /// With a right-hand side of ones.
    pub(super) fn new(n: usize) -> Self {
        Self { rows: vec![[1.0, 4.0, 1.0, 1.0]; n], passed: vec![0.0; n], x: vec![0.0; n] }
    }

    /// Seconds of one solve.
    pub(super) fn seconds(&mut self) -> f64 {
        let rows = black_box(std::mem::take(&mut self.rows));
        let start = Instant::now();
        self.solve(&rows);
        let seconds = start.elapsed().as_secs_f64();
        self.rows = rows;
        black_box(&self.x);
        seconds
    }

    fn solve(&mut self, rows: &[[f64; 4]]) {
        let (mut passed, mut before) = (0.0, 0.0);
        for ((&[below, diagonal, above, right], keep), x) in rows.iter().zip(&mut self.passed).zip(&mut self.x) {
            let pivot = diagonal - below * passed;
            before = (right - below * before) / pivot;
            passed = above / pivot;
            (*keep, *x) = (passed, before);
        }
        let mut behind = 0.0;
        for (keep, x) in self.passed.iter().zip(&mut self.x).rev() {
            behind = *x - keep * behind;
            *x = behind;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Tridiagonal;

    #[test]
    fn it_solves_the_system() {
        /// A few roundings of numbers below one.
        const ROUNDING: f64 = 1e-15;
        let mut system = Tridiagonal::new(1000);
        system.seconds();
        let x = |i: usize| if (1..=1000).contains(&i) { system.x[i - 1] } else { 0.0 };
        for i in 1..=1000 {
            assert!((x(i - 1) + 4.0 * x(i) + x(i + 1) - 1.0).abs() < ROUNDING, "row {i}");
        }
    }
}
