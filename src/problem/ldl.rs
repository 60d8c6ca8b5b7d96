//! `LDLᵀ` of a symmetric positive definite matrix of small bandwidth: O(n w²) operations, O(n w) numbers.

/// A symmetric matrix of half bandwidth `W − 1`: row `i` holds `a_ii, a_i,i+1, …, a_i,i+W−1`.
#[derive(Debug, Clone, PartialEq)]
pub struct Band<const W: usize> {
    rows: Vec<[f64; W]>,
}

/// A pivot that should be positive is not.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[error("pivot {index} of the factorisation must be positive, but is {pivot}: rounding destroyed definiteness")]
pub struct NotPositiveDefinite {
    /// Which pivot, from 0.
    pub index: usize,
    /// Its value.
    pub pivot: f64,
}

impl<const W: usize> Band<W> {
    /// The zero matrix of shape (n, n).
    #[must_use]
    pub fn zeros(n: usize) -> Self {
        Self { rows: vec![[0.0; W]; n] }
    }

    /// Adds `value` to `a_ij` and `a_ji`, where `i ≤ j < i + W`.
    pub fn add(&mut self, i: usize, j: usize, value: f64) {
        debug_assert!(i <= j && j < i + W, "({i}, {j}) lies outside the upper half of a band of {W}");
        self.rows[i][j - i] += value;
    }

    /// Solves `A x = r` for several right-hand sides at once, in place; consumes the matrix.
    ///
    /// # Errors
    ///
    /// [`NotPositiveDefinite`] at the first pivot that is not positive.
    pub fn solve(mut self, right_hand_sides: &mut [&mut [f64]]) -> Result<(), NotPositiveDefinite> {
        let n = self.rows.len();
        for i in 0..n {
            let row = self.rows[i];
            let pivot = row[0];
            // The comparison also refuses NaN.
            if !(0.0 < pivot && pivot < f64::INFINITY) {
                return Err(NotPositiveDefinite { index: i, pivot });
            }
            for k in 1..W.min(n - i) {
                let factor = row[k] / pivot;
                for (entry, above) in self.rows[i + k].iter_mut().zip(&row[k..]) {
                    *entry -= factor * above;
                }
                self.rows[i][k] = factor;
                for r in right_hand_sides.iter_mut() {
                    r[i + k] -= factor * r[i];
                }
            }
        }
        for r in right_hand_sides.iter_mut() {
            for i in (0..n).rev() {
                let mut sum = r[i] / self.rows[i][0];
                for k in 1..W.min(n - i) {
                    sum -= self.rows[i][k] * r[i + k];
                }
                r[i] = sum;
            }
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn solves_a_small_system_exactly() {
        // [4 2 0; 2 5 2; 0 2 5] (1, 2, 3) = (8, 18, 19); all pivots are 4.
        let mut a = Band::<2>::zeros(3);
        for (i, j, value) in [(0, 0, 4.0), (0, 1, 2.0), (1, 1, 5.0), (1, 2, 2.0), (2, 2, 5.0)] {
            a.add(i, j, value);
        }
        let mut x = [8.0, 18.0, 19.0];
        a.solve(&mut [&mut x]).expect("the matrix is positive definite");
        assert_eq!(x.map(f64::to_bits), [1.0_f64, 2.0, 3.0].map(f64::to_bits));
    }

    #[test]
    fn refuses_an_indefinite_matrix() {
        let mut a = Band::<2>::zeros(2);
        a.add(0, 0, 1.0);
        a.add(0, 1, 2.0);
        a.add(1, 1, 1.0);
        let error = a.solve(&mut []).expect_err("1 − 2² < 0");
        assert_eq!(error, NotPositiveDefinite { index: 1, pivot: -3.0 });
    }
}
