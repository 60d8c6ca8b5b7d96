//! The sparse form of a quadratic program, for solvers that accept sparse matrices and equations.
//!
//! ```text
//! minimise ½ zᵀ P z + cᵀ z   subject to   E z = e,  z_k ≥ 0 for k ≥ s
//!           (m,m)    (m)                  (r,m) (r)
//! ```
//!
//! The variables `z_s … z_{m−1}` are those of the program (32), `x_i = X z_{s+i}`, and the multipliers of their signs are its
//! gradient, `g_i = G μ_i`. The variables before them are free and have no meaning for (32). Eliminating them by the equations would
//! give the matrix `A`, full or banded, with its condition number.

use super::{Qp, Sizes, UpperColumns};

/// The sparse form of a program with n variables.
#[derive(Debug, Clone, PartialEq)]
pub struct SparseForm {
    /// `P`, symmetric, shape (m, m).
    pub quadratic: UpperColumns,
    /// `c`, length m.
    pub linear: Vec<f64>,
    /// `E` by columns, shape (r, m), each a list of rows and values with ascending rows.
    pub equations: Vec<Vec<(usize, f64)>>,
    /// `e`, length r.
    pub right: Vec<f64>,
    /// `s`, the first of the n variables with a sign constraint; `m = s + n`.
    pub signed: usize,
    /// `X` and `G`.
    pub sizes: Sizes,
}

/// Checks of a form before it is passed to a library.
#[cfg(any(feature = "clarabel", feature = "osqp"))]
impl SparseForm {
    /// All numbers of the form.
    fn numbers(&self) -> impl Iterator<Item = f64> {
        let equations = self.equations.iter().flatten().map(|(_, value)| value);
        self.quadratic.values.iter().chain(&self.linear).chain(&self.right).chain(equations).copied()
    }

    /// Whether all numbers are finite.
    #[must_use]
    pub(crate) fn is_finite(&self) -> bool {
        self.numbers().all(f64::is_finite)
    }

    /// Whether all numbers have a magnitude below `limit`.
    #[must_use]
    pub(crate) fn is_within(&self, limit: f64) -> bool {
        self.numbers().all(|number| number.abs() < limit)
    }

    /// Whether the diagonal of `P` alone shows that a minimum need not exist.
    #[must_use]
    pub(crate) fn has_negative_diagonal(&self) -> bool {
        let UpperColumns { starts, rows, values } = &self.quadratic;
        let columns = starts.windows(2).enumerate();
        columns.into_iter().any(|(j, s)| (s[0]..s[1]).any(|k| rows[k] == j && values[k] < 0.0))
    }
}

impl SparseForm {
    /// The form without equations, from the matrix alone: `z = x/X`, `P = A X/G`, `c = −b/G`.
    #[must_use]
    pub(crate) fn of_matrix(qp: &dyn Qp) -> Self {
        let sizes = qp.sizes();
        Self {
            quadratic: qp.matrix().upper_columns(sizes.x / sizes.gradient),
            linear: qp.linear().iter().map(|b| -b / sizes.gradient).collect(),
            equations: vec![Vec::new(); qp.dimension()],
            right: Vec::new(),
            signed: 0,
            sizes,
        }
    }

    /// The residuals of `z` and of the multipliers `y` of the equations: `E z − e`, length r, and `P z + c + Eᵀ y`, length m. `part`
    /// is applied to every term: the identity for the residuals, or the magnitude for the size of their terms.
    #[must_use]
    pub(crate) fn left(&self, z: &[f64], y: &[f64], part: fn(f64) -> f64) -> [Vec<f64>; 2] {
        let mut equations: Vec<f64> = self.right.iter().map(|e| part(-e)).collect();
        let mut gradient: Vec<f64> = self.linear.iter().map(|c| part(*c)).collect();
        let UpperColumns { starts, rows, values } = &self.quadratic;
        for (j, range) in starts.windows(2).enumerate() {
            for k in range[0]..range[1] {
                let i = rows[k];
                gradient[i] += part(values[k] * z[j]);
                if i != j {
                    gradient[j] += part(values[k] * z[i]);
                }
            }
        }
        for (j, column) in self.equations.iter().enumerate() {
            for &(i, value) in column {
                equations[i] += part(value * z[j]);
                gradient[j] += part(value * y[i]);
            }
        }
        [equations, gradient]
    }

    /// Equations and sign constraints as the rows of one matrix by columns. `E` is above, and below it `sign` times the unit vectors
    /// of the variables with a sign constraint. Returns starts, rows and values.
    #[must_use]
    pub fn constraints(&self, sign: f64) -> (Vec<usize>, Vec<usize>, Vec<f64>) {
        let (mut starts, mut rows, mut values) = (vec![0], Vec::new(), Vec::new());
        for (k, column) in self.equations.iter().enumerate() {
            for &(row, value) in column {
                rows.push(row);
                values.push(value);
            }
            if self.signed <= k {
                rows.push(self.right.len() + k - self.signed);
                values.push(sign);
            }
            starts.push(rows.len());
        }
        (starts, rows, values)
    }
}
