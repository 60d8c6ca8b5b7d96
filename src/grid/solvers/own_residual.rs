//! The residual of a library on its own problem, recomputed from its answer in the norm of its stopping criterion. Whether the
//! library meets its own tolerance is one question; whether its answer passes our check is another.

#![cfg_attr(not(all(feature = "clarabel", feature = "osqp")), allow(dead_code, reason = "only libraries have one"))]

use crate::qp::SparseForm;

/// The residual of a library in its own norm, dimensionless.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct OwnResidual {
    /// The largest of its residuals: of the equations and sign constraints, of the gradient, and of the duality gap if the library
    /// checks it.
    pub residual: f64,
    /// The tolerance that the library was given.
    pub asked: f64,
    /// The possible effect of rounding on `residual`; at tolerances like 1e-15 this is the larger of the two.
    pub rounding: f64,
}

/// Roundings of a term: of its product, of the sum, and of the answer itself, which was scaled before it was returned.
const ROUNDINGS: f64 = 4.0 * f64::EPSILON;

impl OwnResidual {
    /// Whether the library meets its tolerance.
    #[must_use]
    pub fn is_met(&self) -> bool {
        self.residual <= self.asked + self.rounding
    }

    /// The largest of clarabel's three criteria: `‖E z − e, s − z‖ / (1 ∨ ‖e‖ + ‖z‖ + ‖s‖)`,
    /// `‖P z + c + Eᵀ y − μ‖ / (1 ∨ ‖c‖ + ‖z‖ + ‖y, μ‖)` and `|zᵀ P z + cᵀ z + eᵀ y| / (1 ∨ |J|)`, with Euclidean norms of
    /// residuals and variables and the largest entries of `e` and `c`; `y, μ` are the multipliers, `s` the slacks.
    pub(super) fn of_clarabel(form: &SparseForm, [z, multipliers, slacks]: [&[f64]; 3], asked: f64) -> Self {
        let (y, mu) = multipliers.split_at(form.right.len());
        let s = &slacks[form.right.len()..];
        let norm = |values: &[f64]| values.iter().map(|v| v * v).sum::<f64>().sqrt();
        let [of_z, of_multipliers, of_slacks] = [z, multipliers, slacks].map(norm);
        let sizes = [
            (largest(&form.right) + of_z + of_slacks).max(1.0),
            (largest(&form.linear) + of_z + of_multipliers).max(1.0),
        ];
        let dot = |a: &[f64], b: &[f64], part: fn(f64) -> f64| a.iter().zip(b).map(|(a, b)| part(a * b)).sum::<f64>();
        let worst = |part: fn(f64) -> f64| {
            let [mut equations, mut gradient] = form.left(z, y, part);
            equations.extend(z[form.signed..].iter().zip(s).map(|(z, s)| part(*s) + part(-z)));
            gradient[form.signed..].iter_mut().zip(mu).for_each(|(g, mu)| *g += part(-mu));
            // zᵀ P z from the gradient without its other terms.
            let linear = dot(&form.linear, z, part);
            let held = dot(&form.right, y, part);
            let bent: f64 = {
                let [_, products] = form.left(z, &vec![0.0; y.len()], part);
                dot(&products, z, part) - linear
            };
            let objective = (0.5 * bent + linear).abs().min((0.5 * bent + held).abs()).max(1.0);
            maximum([norm(&equations) / sizes[0], norm(&gradient) / sizes[1], (bent + linear + held).abs() / objective])
        };
        Self { residual: worst(|term| term), asked, rounding: ROUNDINGS * worst(f64::abs) }
    }

    /// The larger of osqp's two criteria: the distance of `E z` from `e` and of `z_k` from `z_k ≥ 0`, and
    /// `‖P z + c + Eᵀ y + μ‖`, both in the largest entry; `y, μ` are the multipliers.
    pub(super) fn of_osqp(form: &SparseForm, z: &[f64], multipliers: &[f64], asked: f64) -> Self {
        let (y, mu) = multipliers.split_at(form.right.len());
        let worst = |part: fn(f64) -> f64| {
            let [mut equations, mut gradient] = form.left(z, y, part);
            equations.extend(z[form.signed..].iter().map(|z| part(z.min(0.0))));
            gradient[form.signed..].iter_mut().zip(mu).for_each(|(g, mu)| *g += part(*mu));
            maximum([largest(&equations), largest(&gradient)])
        };
        Self { residual: worst(|term| term), asked, rounding: ROUNDINGS * worst(f64::abs) }
    }
}

/// The largest magnitude; NaN if a value is NaN.
fn largest(values: &[f64]) -> f64 {
    maximum(values.iter().map(|v| v.abs()))
}

/// Unlike `f64::max` this does not ignore NaN.
fn maximum(values: impl IntoIterator<Item = f64>) -> f64 {
    values.into_iter().fold(0.0, |most: f64, v| if most.is_nan() || v <= most { most } else { v })
}

#[cfg(test)]
mod tests {
    use super::{OwnResidual, maximum};
    use crate::qp::{Sizes, SparseForm, UpperColumns};

    /// Minimise ½ z² − z over z ≥ 0: z = 1, no multiplier.
    fn native() -> SparseForm {
        SparseForm {
            quadratic: UpperColumns { starts: vec![0, 1], rows: vec![0], values: vec![1.0] },
            linear: vec![-1.0],
            equations: vec![Vec::new()],
            right: Vec::new(),
            signed: 0,
            sizes: Sizes { x: 1.0, gradient: 1.0 },
        }
    }

    #[test]
    fn the_optimum_leaves_nothing() {
        let of_clarabel = OwnResidual::of_clarabel(&native(), [&[1.0], &[0.0], &[1.0]], 1e-12);
        let of_osqp = OwnResidual::of_osqp(&native(), &[1.0], &[0.0], 1e-12);
        for own in [of_clarabel, of_osqp] {
            assert!(own.residual == 0.0 && own.is_met(), "{own:?}");
        }
    }

    #[test]
    fn what_is_no_number_is_the_largest_wherever_it_stands() {
        for place in 0..3 {
            let mut values = [1.0, 3.0, 2.0];
            values[place] = f64::NAN;
            assert!(maximum(values).is_nan(), "at {place}");
        }
    }

    #[test]
    fn what_is_left_is_seen() {
        // z = 1 + d gives a gradient of d, relative to the sizes 1 and 1 + d, and a gap of about d.
        let d = 1.0 / f64::from(1_u32 << 20);
        let of_clarabel = OwnResidual::of_clarabel(&native(), [&[1.0 + d], &[0.0], &[1.0 + d]], 1e-9);
        assert!((of_clarabel.residual - d).abs() < 2.0 * d * d, "gap d + d² over 1: {of_clarabel:?}");
        // A slack or a multiplier with an error, relative to the size of all variables.
        let of = |mu: f64, s: f64| OwnResidual::of_clarabel(&native(), [&[1.0], &[mu], &[s]], 1e-9).residual;
        assert!((of(0.0, 4.0) - 3.0 / 5.0).abs() < f64::EPSILON && (of(4.0, 1.0) - 4.0 / 6.0).abs() < f64::EPSILON);
        // For a z of −d osqp measures d in the sign of z, and also the gradient.
        let of_osqp = OwnResidual::of_osqp(&native(), &[-d], &[0.0], 1e-9);
        assert!((of_osqp.residual - (1.0 + d)).abs() < f64::EPSILON, "the gradient −1 − d: {of_osqp:?}");
        for own in [of_clarabel, of_osqp, OwnResidual { residual: f64::NAN, asked: 1.0, rounding: 0.0 }] {
            assert!(!own.is_met(), "{own:?}");
        }
    }
}
