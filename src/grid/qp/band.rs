//! The factorisation `UᵀDU` of a symmetric positive definite matrix of small bandwidth, row by row: O(n w²) operations, O(n w) numbers.

/// Equations `A x = r` with a symmetric matrix that has `W` diagonals above the main one.
///
/// [`push`](Self::push) eliminates each row as it arrives, from the first to the last; [`solve`](Self::solve) substitutes back.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Band<const W: usize> {
    /// `u_i,i+1 … u_i,i+W`: the entries above the diagonal, divided by the pivot.
    above: Vec<[f64; W]>,
    /// The right-hand side after elimination, divided by the pivot.
    right: Vec<f64>,
    /// The amounts that the rows so far subtract from the next `W` rows.
    taken: [Row<W>; W],
}

/// Row `i` of a symmetric matrix with its right-hand side.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Row<const W: usize> {
    /// `a_ii`.
    pub(crate) diagonal: f64,
    /// `a_i,i+1 … a_i,i+W`; zero beyond the last column.
    pub(crate) above: [f64; W],
    /// `r_i`.
    pub(crate) right: f64,
}

/// A pivot is not positive, or a right-hand side is not finite.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[error("pivot {index} of the factorisation must be positive, but is {pivot}: rounding destroyed definiteness")]
pub struct NotPositiveDefinite {
    /// Index of the pivot, from 0.
    pub index: usize,
    /// Its value.
    pub pivot: f64,
}

impl<const W: usize> Band<W> {
    const ZERO: Row<W> = Row { diagonal: 0.0, above: [0.0; W], right: 0.0 };

    /// No equations yet, with memory for n of them.
    #[must_use]
    pub(crate) fn with_capacity(n: usize) -> Self {
        Self { above: Vec::with_capacity(n), right: Vec::with_capacity(n), taken: [Self::ZERO; W] }
    }

    /// Adds a row.
    ///
    /// # Errors
    ///
    /// [`NotPositiveDefinite`] if its pivot is not positive, or its right-hand side is not finite.
    #[inline]
    pub(crate) fn push(&mut self, row: Row<W>) -> Result<(), NotPositiveDefinite> {
        let taken = self.taken[0];
        let pivot = row.diagonal - taken.diagonal;
        let rest = row.right - taken.right;
        // The comparisons also reject NaN, and the sum rejects infinite values.
        if !((0.0 < pivot) & (pivot + rest.abs() < f64::INFINITY)) {
            return Err(self.refused(pivot));
        }
        let inverse = 1.0 / pivot;
        let right = rest * inverse;
        let mut entries = row.above;
        entries.iter_mut().zip(taken.above).for_each(|(entry, taken)| *entry -= taken);
        let above = entries.map(|entry| entry * inverse);
        for k in 1..W {
            self.taken[k - 1] = self.taken[k];
        }
        self.taken[W - 1] = Self::ZERO;
        for (k, taken) in self.taken.iter_mut().enumerate() {
            taken.diagonal += entries[k] * above[k];
            taken.right += entries[k] * right;
            for (l, taken) in taken.above[..W - 1 - k].iter_mut().enumerate() {
                *taken += entries[k] * above[k + 1 + l];
            }
        }
        self.above.push(above);
        self.right.push(right);
        Ok(())
    }

    #[cold]
    fn refused(&self, pivot: f64) -> NotPositiveDefinite {
        NotPositiveDefinite { index: self.right.len(), pivot }
    }

    /// The solution `x`.
    #[must_use]
    pub(crate) fn solve(self) -> Vec<f64> {
        let mut x = self.right;
        let mut behind = [0.0; W];
        for (x, above) in x.iter_mut().zip(&self.above).rev() {
            for (u, behind) in above.iter().zip(behind) {
                *x -= u * behind;
            }
            behind.rotate_right(1);
            behind[0] = *x;
        }
        x
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn solves_small_systems_exactly() {
        // [4 2 0; 2 5 2; 0 2 5] (1, 2, 3) = (8, 18, 19); all pivots are 4.
        let mut a = Band::with_capacity(3);
        for (diagonal, above, right) in [(4.0, 2.0, 8.0), (5.0, 2.0, 18.0), (5.0, 0.0, 19.0)] {
            a.push(Row { diagonal, above: [above], right }).expect("all pivots are 4");
        }
        assert_eq!(a.solve().into_iter().map(f64::to_bits).collect::<Vec<_>>(), [1.0_f64, 2.0, 3.0].map(f64::to_bits));
        // Uᵀ 4 U with u_01 = 1/2, u_02 = 1/4, u_12 = 1/2, times (1, 2, 4).
        let mut a = Band::with_capacity(3);
        for (diagonal, above, right) in [(4.0, [2.0, 1.0], 12.0), (5.0, [2.5, 0.0], 22.0), (5.25, [0.0, 0.0], 27.0)] {
            a.push(Row { diagonal, above, right }).expect("all pivots are 4");
        }
        assert_eq!(a.solve().into_iter().map(f64::to_bits).collect::<Vec<_>>(), [1.0_f64, 2.0, 4.0].map(f64::to_bits));
    }

    #[test]
    fn refuses_an_indefinite_matrix_and_what_is_no_number() {
        let mut a = Band::with_capacity(2);
        a.push(Row { diagonal: 1.0, above: [2.0], right: 0.0 }).expect("the first pivot is 1");
        let error = a.push(Row { diagonal: 1.0, above: [0.0], right: 0.0 }).expect_err("1 − 2² < 0");
        assert_eq!(error, NotPositiveDefinite { index: 1, pivot: -3.0 });
        let row = Row { diagonal: 1.0, above: [0.0], right: f64::NAN };
        assert!(Band::with_capacity(1).push(row).is_err());
    }
}
