//! The matrix `A` as numbers, for solvers that need rows or a list of entries.

use nalgebra::DMatrix;

use super::Profile;
use super::profile::dot;

/// A symmetric matrix, stored according to its shape.
#[derive(Debug, Clone, PartialEq)]
pub enum Matrix {
    /// Every entry, shape (n, n).
    Dense(DMatrix<f64>),
    /// Half bandwidth 2: row `i` contains `a_ii, a_i,i+1, a_i,i+2`, with arbitrary values beyond the last column.
    Pentadiagonal(Vec<[f64; 3]>),
    /// Rows from their first entry to the diagonal.
    Profile(Profile),
}

/// The upper triangle by columns. `starts` has n + 1 entries, `rows` and `values` one for each stored number.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct UpperColumns {
    /// Index in `rows` and `values` at which each column starts.
    pub starts: Vec<usize>,
    /// Row of each entry, ascending within a column.
    pub rows: Vec<usize>,
    /// Value of each entry.
    pub values: Vec<f64>,
}

impl UpperColumns {
    /// Appends a column with at most a diagonal entry. At least one column exists already.
    pub(crate) fn push(&mut self, diagonal: Option<f64>) {
        self.rows.extend(diagonal.map(|_| self.starts.len() - 1));
        self.values.extend(diagonal);
        self.starts.push(self.rows.len());
    }
}

impl Matrix {
    /// `n`.
    #[must_use]
    pub fn dimension(&self) -> usize {
        match self {
            Self::Dense(a) => a.nrows(),
            Self::Pentadiagonal(rows) => rows.len(),
            Self::Profile(rows) => rows.dimension(),
        }
    }

    /// Entry `a_ij`.
    #[must_use]
    pub fn entry(&self, i: usize, j: usize) -> f64 {
        match self {
            Self::Dense(a) => a[(i, j)],
            Self::Pentadiagonal(rows) => {
                let (i, j) = (i.min(j), i.max(j));
                rows[i].get(j - i).copied().unwrap_or(0.0)
            }
            Self::Profile(rows) => rows.entry(i, j),
        }
    }

    /// `(A x)_i`, the product of row `i` with `x`.
    #[must_use]
    pub fn row_times(&self, i: usize, x: &[f64]) -> f64 {
        match self {
            // Columns are contiguous, and the matrix is symmetric.
            Self::Dense(a) => dot(&a.as_slice()[i * a.nrows()..][..a.nrows()], x),
            Self::Pentadiagonal(_) | Self::Profile(_) => self.neighbours(i).map(|j| self.entry(i, j) * x[j]).sum(),
        }
    }

    /// Operations of one sweep over all rows, as a number of entries.
    #[must_use]
    pub(crate) fn entries(&self) -> usize {
        let n = self.dimension();
        match self {
            Self::Dense(_) => n * n,
            Self::Pentadiagonal(_) => 5 * n,
            Self::Profile(rows) => 2 * rows.numbers() - n,
        }
    }

    /// The upper triangle by columns, each entry multiplied by `factor`.
    #[must_use]
    pub(crate) fn upper_columns(&self, factor: f64) -> UpperColumns {
        let mut columns = UpperColumns::default();
        for j in 0..self.dimension() {
            columns.starts.push(columns.rows.len());
            for i in self.neighbours(j).take_while(|&i| i <= j) {
                columns.rows.push(i);
                columns.values.push(factor * self.entry(i, j));
            }
        }
        columns.starts.push(columns.rows.len());
        columns
    }

    /// The columns in which row `i` may have entries.
    fn neighbours(&self, i: usize) -> std::ops::Range<usize> {
        match self {
            Self::Dense(a) => 0..a.ncols(),
            Self::Pentadiagonal(rows) => i.saturating_sub(2)..(i + 3).min(rows.len()),
            Self::Profile(rows) => rows.across(i),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn both_shapes_agree() {
        let rows = vec![[5.0, -4.0, 1.0], [6.0, -4.0, 1.0], [6.0, -4.0, 1.0], [5.0, -4.0, 1.0]];
        let banded = Matrix::Pentadiagonal(rows);
        let dense = Matrix::Dense(DMatrix::from_fn(4, 4, |i, j| banded.entry(i, j)));
        let x = [1.0, -2.0, 4.0, 0.5];
        for i in 0..4 {
            assert_eq!(banded.row_times(i, &x).to_bits(), dense.row_times(i, &x).to_bits(), "row {i}");
        }
        // Column 3 of the dense matrix stores the zero at (0, 3) as well.
        let columns = banded.upper_columns(2.0);
        assert_eq!(columns.starts, [0, 1, 3, 6, 9]);
        assert_eq!(columns.values, [10.0, -8.0, 12.0, 2.0, -8.0, 12.0, 2.0, -8.0, 10.0]);
    }
}
