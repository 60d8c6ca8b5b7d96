//! A quadratic program given by any symmetric positive definite matrix: what the methods become for a body that is not a beam.

use nalgebra::{Cholesky, DMatrix, DVector};

use super::{FreeSet, Matrix, NotPositiveDefinite, Qp, Sizes, Stationary};

/// The quadratic program (32) of a dense matrix `A`, shape (n, n), and a vector `b`, length n.
#[derive(Debug, Clone, PartialEq)]
pub struct Dense {
    /// `A`, symmetric.
    pub matrix: DMatrix<f64>,
    /// `b`.
    pub linear: DVector<f64>,
    /// Sizes of `x` and `g`.
    pub sizes: Sizes,
}

#[cfg(test)]
impl Dense {
    /// The program of `A_ij` and `b_i`, for `n` unknowns whose sizes are 1.
    pub(crate) fn of(n: usize, entry: impl Fn(usize, usize) -> f64, linear: impl Fn(usize) -> f64) -> Self {
        Self {
            matrix: DMatrix::from_fn(n, n, entry),
            linear: DVector::from_fn(n, |i, _| linear(i)),
            sizes: Sizes { x: 1.0, gradient: 1.0 },
        }
    }
}

impl Qp for Dense {
    fn dimension(&self) -> usize {
        self.matrix.nrows()
    }

    fn matrix(&self) -> Matrix {
        Matrix::Dense(self.matrix.clone())
    }

    fn gradient(&self, x: &[f64]) -> Vec<f64> {
        (&self.matrix * DVector::from_column_slice(x) - &self.linear).as_slice().to_vec()
    }

    fn stationary(&self, free: &FreeSet) -> Result<Stationary, NotPositiveDefinite> {
        let chosen: Vec<usize> = free.variables().collect();
        let reduced = self.matrix.select_rows(&chosen).select_columns(&chosen);
        let factor = Cholesky::new(reduced).ok_or(NotPositiveDefinite { index: 0, pivot: f64::NAN })?;
        let solved = factor.solve(&self.linear.select_rows(&chosen));
        let mut x = vec![0.0; free.dimension()];
        chosen.iter().zip(solved.iter()).for_each(|(&i, &value)| x[i] = value);
        let mut gradient = self.gradient(&x);
        chosen.iter().for_each(|&i| gradient[i] = 0.0);
        without_rounding(&mut x, self.sizes.x);
        without_rounding(&mut gradient, self.sizes.gradient);
        Ok(Stationary { x, gradient })
    }

    fn sizes(&self) -> Sizes {
        self.sizes
    }
}

/// Rounding of a solve, as a share of the size of what it gives: a few thousand units in the last place.
const ROUNDING: f64 = 1e-12;

/// Zero for what is negative by no more than rounding, of values whose size is the largest of them, and at least the given one.
fn without_rounding(values: &mut [f64], size: f64) {
    let least = -ROUNDING * values.iter().fold(size, |most, value| most.max(value.abs()));
    values.iter_mut().filter(|value| least <= **value && **value < 0.0).for_each(|value| *value = 0.0);
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::qp::residual;

    #[test]
    fn what_is_negative_by_rounding_is_zero() {
        let mut values = [-0.5 * ROUNDING, -2.0 * ROUNDING, 1.0];
        without_rounding(&mut values, 1.0);
        assert_eq!(values.map(f64::to_bits), [0.0, -2.0 * ROUNDING, 1.0].map(f64::to_bits));
    }

    #[test]
    fn a_number_that_is_none_is_no_optimum() {
        let sizes = Sizes { x: 2.0, gradient: 5.0 };
        assert!((residual(sizes, &[4.0, 1.0], &[0.0, 10.0]) - 0.5).abs() < f64::EPSILON);
        for (x, g) in [(f64::NAN, 0.0), (0.0, f64::NAN)] {
            assert!(residual(sizes, &[x], &[g]).is_infinite());
        }
    }
}
