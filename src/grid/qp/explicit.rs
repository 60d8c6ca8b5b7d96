//! A quadratic program given by its matrix, whatever the matrix stands for.

use super::ordering::elimination_order;
use super::{FreeSet, Matrix, NotPositiveDefinite, Profile, Qp, Sizes, SparseForm, Stationary, Sums};
use crate::double::Double;

/// The quadratic program (32) of a matrix `A` and a vector `b`, in twice the precision where that matters.
#[derive(Debug, Clone, PartialEq)]
pub struct Explicit {
    matrix: Profile,
    /// The difference between `A` and `matrix`: `A` may be a sum that 64 bits cannot represent.
    rest: Profile,
    /// The elimination order of the unknowns.
    order: Vec<usize>,
    /// The factor of `matrix` in this order.
    factor: Profile,
    linear: Sums,
    sizes: Sizes,
}

/// Rounds of refinement. Each gains as many digits as the condition of the matrix leaves of sixteen; two or three are usual.
const ROUNDS: usize = 40;

/// Values below this fraction of the largest one are rounding of a refined solve. With condition numbers up to 1e14 refinement leaves
/// less than `1e14 · 2⁻¹⁰⁶`, which is 1.2e-18.
const ROUNDING: f64 = 2e-18;

/// A solve counts as one pass over all unknowns for this many products of its factorisation per unknown, which is the cost in a
/// banded program.
const PRODUCTS: usize = 128;

impl Explicit {
    /// The program of `A` and `b`, a vector of length n.
    ///
    /// # Errors
    ///
    /// [`NotPositiveDefinite`] if a pivot of `A` is not positive.
    pub fn new(matrix: Profile, linear: &[f64]) -> Result<Self, NotPositiveDefinite> {
        let mut sums = Sums::zero(linear.len());
        linear.iter().enumerate().for_each(|(i, b)| sums.add(i, 1.0, Double::exact(*b)));
        Ok(Self::factored([matrix, Profile::default()])?.with_linear(sums))
    }

    /// The program of `A` in two parts, the second being the rounding error of the first, with `b = 0`.
    pub(crate) fn factored([matrix, rest]: [Profile; 2]) -> Result<Self, NotPositiveDefinite> {
        let order = elimination_order(&matrix);
        let factor = matrix.part(&order, 0.0).cholesky();
        let factor = factor.map_err(|error| NotPositiveDefinite { index: order[error.index], ..error })?;
        let (linear, sizes) = (Sums::zero(order.len()), Sizes { x: 1.0, gradient: 1.0 });
        Ok(Self { matrix, rest, order, factor, linear, sizes })
    }

    /// The same with `b` in twice the precision.
    pub(crate) fn with_linear(self, linear: Sums) -> Self {
        let b = linear.rounded();
        let most = |values: &mut dyn Iterator<Item = f64>| match values.fold(0.0, f64::max) {
            0.0 => 1.0,
            most => most,
        };
        // The value of a variable if all others are zero.
        let x = most(&mut b.iter().zip(self.matrix.diagonal()).map(|(b, a)| b.abs() / a));
        let sizes = Sizes { x, gradient: most(&mut b.iter().map(|b| b.abs())) };
        Self { linear, sizes, ..self }
    }

    /// `A`, rounded to 64 bits.
    #[must_use]
    pub fn profile(&self) -> &Profile {
        &self.matrix
    }

    /// The difference between `A` and its rounded value.
    pub(crate) fn rest(&self) -> &Profile {
        &self.rest
    }

    /// The elimination order of the unknowns.
    pub(crate) fn order(&self) -> &[usize] {
        &self.order
    }

    /// The factor of `A` in this order.
    pub(crate) fn factor(&self) -> &Profile {
        &self.factor
    }

    /// Solves `A x = b` without refinement.
    pub(crate) fn solve(&self, b: &[f64]) -> Vec<f64> {
        solved_in(&self.order, &self.factor, b)
    }

    /// `b` with a bound on its rounding.
    pub(crate) fn right(&self) -> &Sums {
        &self.linear
    }

    /// The gradient `A x − b` with a bound on its rounding.
    pub(crate) fn gradient_at(&self, x: &[Double]) -> Sums {
        let mut sums = self.linear.negative();
        self.matrix.times_into(x, &mut sums);
        self.rest.times_into(x, &mut sums);
        sums
    }

    /// `x` with the given gradient, or gradient zero where none is given, at the chosen variables. The other variables keep their
    /// value from `before`, or zero. The solution is refined as long as corrections become smaller.
    pub(crate) fn solved(
        &self,
        chosen: &[usize],
        gradient: &[Double],
        before: Option<Vec<Double>>,
    ) -> Result<Vec<Double>, NotPositiveDefinite> {
        let mut x = before.unwrap_or_else(|| vec![Double::ZERO; self.dimension()]);
        let mut is_chosen = vec![false; x.len()];
        chosen.iter().for_each(|i| is_chosen[*i] = true);
        let chosen: Vec<usize> = self.order.iter().copied().filter(|i| is_chosen[*i]).collect();
        let own;
        let factor = if chosen.len() == x.len() {
            &self.factor
        } else {
            own = self.matrix.part(&chosen, 0.0).cholesky()?;
            &own
        };
        let mut last = f64::INFINITY;
        for _ in 0..ROUNDS {
            let found = self.gradient_at(&x);
            let wanted = |i: usize| gradient.get(i).copied().unwrap_or(Double::ZERO);
            let mut step: Vec<f64> = chosen.iter().map(|&i| (wanted(i) - found.values[i]).rounded()).collect();
            factor.solve(&mut step);
            let size = step.iter().fold(0.0_f64, |most, step| most.max(step.abs()));
            // Also ends if a number is NaN.
            if !(0.0 < size && size < 0.5 * last) {
                break;
            }
            last = size;
            chosen.iter().zip(&step).for_each(|(&i, step)| x[i] = x[i] + Double::exact(*step));
        }
        Ok(x)
    }
}

impl Qp for Explicit {
    fn dimension(&self) -> usize {
        self.matrix.dimension()
    }

    fn matrix(&self) -> Matrix {
        Matrix::Profile(self.matrix.clone())
    }

    fn linear(&self) -> Vec<f64> {
        self.linear.rounded()
    }

    fn sparse(&self) -> Option<SparseForm> {
        Some(SparseForm::of_matrix(self))
    }

    fn gradient(&self, x: &[f64]) -> Vec<f64> {
        self.gradient_at(&x.iter().copied().map(Double::exact).collect::<Vec<_>>()).rounded()
    }

    fn stationary(&self, free: &FreeSet) -> Result<Stationary, NotPositiveDefinite> {
        let chosen: Vec<usize> = free.variables().collect();
        let x = self.solved(&chosen, &[], None)?;
        let mut gradient = self.gradient_at(&x).rounded();
        chosen.iter().for_each(|&i| gradient[i] = 0.0);
        let mut x: Vec<f64> = x.iter().map(|x| x.rounded()).collect();
        without_rounding(&mut x, self.sizes.x);
        without_rounding(&mut gradient, self.sizes.gradient);
        Ok(Stationary { x, gradient })
    }

    fn solve_work(&self) -> usize {
        self.dimension().max(self.factor.products() / PRODUCTS)
    }

    fn sizes(&self) -> Sizes {
        self.sizes
    }
}

/// Solves `L Lᵀ x = b` with a factor in the given elimination order.
pub(crate) fn solved_in(order: &[usize], factor: &Profile, b: &[f64]) -> Vec<f64> {
    let mut ordered: Vec<f64> = order.iter().map(|i| b[*i]).collect();
    factor.solve(&mut ordered);
    let mut x = vec![0.0; b.len()];
    order.iter().zip(ordered).for_each(|(i, value)| x[*i] = value);
    x
}

/// Sets values to zero that may be rounding, relative to the largest value and to at least the given size.
fn without_rounding(values: &mut [f64], size: f64) {
    let most = ROUNDING * values.iter().fold(size, |most, value| most.max(value.abs()));
    values.iter_mut().filter(|value| value.abs() <= most).for_each(|value| *value = 0.0);
}
