//! Foundations that are polynomials, `u = c₀ + c₁ x + c₂ x² + …`.
//!
//! The terms of a polynomial of high degree are far larger than their sum. On the beam, the terms of Chebyshev's polynomial of
//! degree `d` add up to `(3 + √8)^d / 2` times its largest value. With ten coefficients a sum in 64-bit arithmetic still has nine
//! correct digits in this case, and error bounds account for the rest. A polynomial with more than [`COEFFICIENTS`] coefficients
//! is rejected.

/// The greatest number of coefficients of a polynomial.
pub(super) const COEFFICIENTS: usize = 10;

/// The coefficients up to the last nonzero one, and at least the first one.
pub(crate) fn used(coefficients: &[f64]) -> &[f64] {
    let last = coefficients.iter().rposition(|&c| c != 0.0).unwrap_or(0);
    &coefficients[..coefficients.len().min(last + 1)]
}

/// `u(x)`.
pub(super) fn value(coefficients: &[f64], x: f64) -> f64 {
    coefficients.iter().rev().fold(0.0, |sum, &c| sum * x + c)
}

/// `[u, u']` by Horner's scheme.
pub(super) fn with_slope(coefficients: impl DoubleEndedIterator<Item = f64>, x: f64) -> [f64; 2] {
    coefficients.rev().fold([0.0; 2], |[value, slope], c| [value * x + c, slope * x + value])
}

/// The sums of the magnitudes of the terms of `u(x)` and `u'(x)`. Rounding is relative to them.
pub(super) fn magnitudes_at(coefficients: &[f64], x: f64) -> [f64; 2] {
    with_slope(coefficients.iter().map(|c| c.abs()), x.abs())
}

/// `(a + b) u[x − a, x, x + b]`; the divided difference is computed by a scheme like Horner's.
pub(super) fn bend(coefficients: &[f64], x: f64, a: f64, b: f64) -> f64 {
    // For u = c + t w(t): u[y] = c + y w[y], u[y, z] = w[y] + z w[y, z], u[x, y, z] = w[x, y] + z w[x, y, z].
    let (mut one, mut two, mut three) = (0.0, 0.0, 0.0);
    for c in coefficients.iter().rev() {
        three = (x + b) * three + two;
        two = x * two + one;
        one = (x - a) * one + c;
    }
    (a + b) * three
}
