//! Foundations that are polynomials, `u = c₀ + c₁ x + c₂ x² + …`, short and long ones.
//!
//! The terms of a polynomial of high degree are far larger than their sum: those of Chebyshev's polynomial of degree 20 on the
//! beam, which is at most 1, add up to `10¹⁵`. A **long** polynomial is therefore evaluated in twice the precision, from
//! coefficients that are taken as they are given, and is known to the last bit but one. How the user's decimals were rounded to
//! these coefficients is not considered: for such a polynomial that rounding may change depths visibly, and cannot be told from a
//! change that is meant.

use std::f64::consts::PI;

use crate::double::Double;

/// A polynomial with more coefficients is long. Those of Chebyshev's polynomial of degree `d` add up to `(3 + √8)^d / 2` times its
/// largest value: with seven coefficients a sum in 64 bits still has eleven digits of it, with ten no more than nine, and the
/// conditions of beam theory are met to twelve.
pub(crate) const SHORT: usize = 7;
/// Parts of a beam for each degree of a long polynomial, see [`cuts`].
const PARTS_PER_DEGREE: usize = 3;
/// Terms of its expansion that count over half of such a part: the polynomial is of the size of its largest magnitude `M` on
/// the beam, and its Taylor series there no larger than that of `M cos(d θ)`. With `d |Δθ| ≤ π/6` what is left out is below
/// `0.53²²/22! < 10⁻²⁷` of `M`.
pub(crate) const LONG_TERMS: usize = 22;

/// The degree of a long polynomial; [`None`] for a short one.
pub(crate) fn long_degree(coefficients: &[f64]) -> Option<usize> {
    let used = coefficients.iter().rposition(|&c| c != 0.0)?;
    (SHORT <= used).then_some(used)
}

/// Where a beam of this length is cut into equally many parts as for `parts` equal angles of a circle above it: the places
/// between its ends, closer together towards them, as a polynomial can be steeper there.
///
/// ```text
/// x = l/2 (1 − cos θ),     θ = π k / parts
/// ```
#[expect(clippy::cast_precision_loss, reason = "a few thousand at most")]
pub(crate) fn cuts(length: f64, parts: usize) -> impl Iterator<Item = f64> {
    // sin² of half the angle, which does not cancel beside the left end.
    let sine = move |k: usize| libm::sin(0.5 * PI * (k as f64 / parts as f64));
    (1..parts).map(move |k| length * (sine(k) * sine(k)))
}

/// Parts into which a beam is cut for a polynomial of this degree.
pub(crate) fn parts(degree: usize) -> usize {
    PARTS_PER_DEGREE * degree
}

/// Coefficients that the expansions on so many parts are made from, all together.
pub(crate) fn coefficients_of(parts: usize) -> usize {
    parts * (parts / PARTS_PER_DEGREE)
}

/// `u(x)`.
pub(super) fn value(coefficients: &[f64], x: f64) -> f64 {
    if long_degree(coefficients).is_some() {
        let value = coefficients.iter().rev().fold(Double::ZERO, |sum, &c| sum.times_plus(x, Double::exact(c)));
        if value.rounded().is_finite() {
            return value.rounded();
        }
    }
    coefficients.iter().rev().fold(0.0, |sum, &c| sum * x + c)
}

/// `u'(x)`.
pub(super) fn slope(coefficients: &[f64], x: f64) -> f64 {
    if long_degree(coefficients).is_some() {
        let [_, slope] = expanded(coefficients, x);
        if f64::is_finite(slope) {
            return slope;
        }
    }
    with_slope(coefficients.iter().copied(), x)[1]
}

/// `[u, u']` by Horner's scheme.
fn with_slope(coefficients: impl DoubleEndedIterator<Item = f64>, x: f64) -> [f64; 2] {
    coefficients.rev().fold([0.0; 2], |[value, slope], c| [value * x + c, slope * x + value])
}

/// What the rounding of `u(x)` and of `u'(x)` is relative to: of a short polynomial their terms, of a long one what they are and what
/// the rounding of the place changes them by, `|u| + |x u'|` and `|u'| + |x u''|`.
pub(super) fn magnitudes_at(coefficients: &[f64], x: f64) -> [f64; 2] {
    let terms = with_slope(coefficients.iter().map(|c| c.abs()), x.abs());
    if long_degree(coefficients).is_none() || !terms.iter().all(|terms| terms.is_finite()) {
        return terms;
    }
    let [depth, slope, half] = expanded(coefficients, x);
    [(depth.abs() + (x * slope).abs()).min(terms[0]), (slope.abs() + (2.0 * x * half).abs()).min(terms[1])]
}

/// A bound on `|u|` over a beam; infinite if the terms overflow. For a long polynomial of degree `d` the largest magnitude at the
/// `N + 1` places of [`cuts`] with the ends, over `cos(π d / 2 N)` (Ehlich and Zeller 1964).
#[expect(clippy::cast_precision_loss, reason = "a few thousand at most")]
pub(super) fn magnitude(coefficients: &[f64], length: f64) -> f64 {
    let terms = coefficients.iter().rev().fold(0.0, |sum, c| sum * length + c.abs());
    let Some(degree) = long_degree(coefficients).filter(|_| f64::is_finite(terms)) else { return terms };
    let parts = parts(degree);
    let places = [0.0, length].into_iter().chain(cuts(length, parts));
    let most = places.fold(0.0, |most: f64, x| most.max(value(coefficients, x).abs()));
    (most / libm::cos(0.5 * PI * (degree as f64 / parts as f64))).min(terms)
}

/// `(a + b) u[x − a, x, x + b]`, the divided difference by a scheme like Horner's.
pub(super) fn bend(coefficients: &[f64], x: f64, a: f64, b: f64) -> f64 {
    // For u = c + t w(t): u[y] = c + y w[y], u[y, z] = w[y] + z w[y, z], u[x, y, z] = w[x, y] + z w[x, y, z].
    if long_degree(coefficients).is_some() {
        let (mut one, mut two, mut three) = (Double::ZERO, Double::ZERO, Double::ZERO);
        for &c in coefficients.iter().rev() {
            three = three.times_plus(x + b, two);
            two = two.times_plus(x, one);
            one = one.times_plus(x - a, Double::exact(c));
        }
        let bend = (a + b) * three.rounded();
        if bend.is_finite() {
            return bend;
        }
    }
    let (mut one, mut two, mut three) = (0.0, 0.0, 0.0);
    for c in coefficients.iter().rev() {
        three = (x + b) * three + two;
        two = x * two + one;
        one = (x - a) * one + c;
    }
    (a + b) * three
}

/// The first coefficients of `u(x + t)` in powers of `t`, each off by its last bit and `10⁻³¹` of the terms that add up to it.
pub(crate) fn expanded<const N: usize>(coefficients: &[f64], x: f64) -> [f64; N] {
    let mut work: Vec<Double> = coefficients.iter().copied().map(Double::exact).collect();
    let mut taylor = [0.0; N];
    // Horner's scheme, repeated: each pass leaves one coefficient behind.
    for (pass, out) in taylor.iter_mut().enumerate().take(work.len()) {
        for j in (pass..work.len() - 1).rev() {
            work[j] = work[j + 1].times_plus(x, work[j]);
        }
        *out = work[pass].rounded();
    }
    taylor
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Coefficients of Chebyshev's polynomial `T_d(2x − 1)`, whole numbers below `2⁵³` up to degree 20.
    fn chebyshev(degree: usize) -> Vec<f64> {
        let (mut last, mut this) = (vec![1.0], vec![-1.0, 2.0]);
        for _ in 1..degree {
            // T_{d+1} = 2 (2x − 1) T_d − T_{d−1}.
            let mut next = vec![0.0; this.len() + 1];
            for (j, c) in this.iter().enumerate() {
                next[j] -= 2.0 * c;
                next[j + 1] += 4.0 * c;
            }
            next.iter_mut().zip(&last).for_each(|(next, last)| *next -= last);
            (last, this) = (this, next);
        }
        this
    }

    #[test]
    fn long_polynomials_are_known_to_the_last_bit() {
        for degree in 10..=20_u32 {
            let coefficients = chebyshev(degree as usize);
            for k in 0..=64_u32 {
                // T_d(cos θ) = cos(d θ), at a place that is a 64-bit number: the value there by its recurrence.
                let x = f64::from(k) / 64.0;
                let t = 2.0 * x - 1.0;
                let (mut last, mut this) = (1.0, t);
                for _ in 1..degree {
                    (last, this) = (this, 2.0 * t * this - last);
                }
                let found = value(&coefficients, x);
                assert!((found - this).abs() < 1e-13, "T_{degree} at {x}: {found} for {this}");
            }
            assert!((magnitude(&coefficients, 1.0) - 1.0).abs() < 0.16, "degree {degree}");
        }
    }

    /// At the end of the beam Chebyshev's polynomial is 1, its slope `2 d²` and its second derivative `4 d² (d² − 1) / 3`.
    #[test]
    fn what_the_rounding_of_a_place_changes_counts() {
        for degree in [10, 15, 20_u32] {
            let square = f64::from(degree * degree);
            let (slope, second) = (2.0 * square, 4.0 * square * (square - 1.0) / 3.0);
            let found = magnitudes_at(&chebyshev(degree as usize), 1.0);
            for (found, known) in found.into_iter().zip([1.0 + slope, slope + second]) {
                assert!((found / known - 1.0).abs() < 1e-12, "degree {degree}: {found} for {known}");
            }
        }
    }

    /// The bend of a long polynomial on a fine grid is that of its curvature.
    #[test]
    fn long_polynomials_bend_as_their_second_derivative() {
        const STEP: f64 = 1e-6;
        let coefficients = chebyshev(20);
        for x in [0.1, 0.3, 0.7, 0.9] {
            let [_, _, curvature] = expanded(&coefficients, x);
            let found = bend(&coefficients, x, STEP, STEP);
            assert!((found / (2.0 * STEP * curvature) - 1.0).abs() < 1e-6, "{found} at {x}");
        }
    }

    /// What is expanded about the middle of a part is the polynomial at its ends.
    #[test]
    fn few_terms_are_enough_for_a_part() {
        let mut power = vec![0.0; 301];
        power[300] = 1.0;
        for coefficients in [chebyshev(20), power] {
            let degree = coefficients.len() - 1;
            let mut ends: Vec<f64> = [0.0, 1.0].into_iter().chain(cuts(1.0, parts(degree))).collect();
            ends.sort_by(f64::total_cmp);
            assert_eq!(ends.len(), parts(degree) + 1);
            for part in ends.windows(2) {
                let middle = 0.5 * (part[0] + part[1]);
                let taylor: [f64; LONG_TERMS] = expanded(&coefficients, middle);
                for x in part {
                    let found = taylor.iter().rev().fold(0.0, |sum, c| sum * (x - middle) + c);
                    assert!((found - value(&coefficients, *x)).abs() < 1e-14, "degree {degree} at {x}");
                }
            }
        }
    }
}
