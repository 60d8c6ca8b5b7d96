//! Numbers of 32 digits as sums of two, and symmetric systems with a band of three: stiffness matrices of short elements beside long
//! ones lose more digits than an `f64` has.

use std::ops::{Add, Div, Mul, Neg, Sub};

/// A number as a sum of two, of which the second is at most half a unit in the last place of the first (Dekker 1971).
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct Wide(f64, f64);

/// A sum, and what it is rounded by (Knuth).
#[inline]
fn two_sum(a: f64, b: f64) -> Wide {
    let sum = a + b;
    let part = sum - a;
    Wide(sum, (a - (sum - part)) + (b - part))
}

/// The same where the first one is larger.
#[inline]
fn quick_sum(a: f64, b: f64) -> Wide {
    let sum = a + b;
    Wide(sum, b - (sum - a))
}

/// The upper and the lower half of the digits (Veltkamp).
#[inline]
fn halves(a: f64) -> [f64; 2] {
    /// `2²⁷ + 1`, for 53 bits.
    const SPLIT: f64 = 134_217_729.0;
    let shifted = SPLIT * a;
    let upper = shifted - (shifted - a);
    [upper, a - upper]
}

impl Wide {
    /// Zero.
    pub(super) const ZERO: Self = Self(0.0, 0.0);

    /// Rounded.
    #[inline]
    pub(super) fn near(self) -> f64 {
        self.0
    }

    /// Times a number of 16 digits.
    #[inline]
    pub(super) fn times(self, by: f64) -> Self {
        let ([a, b], [c, d]) = (halves(self.0), halves(by));
        let product = self.0 * by;
        let rounded = ((a * c - product) + a * d + b * c) + b * d;
        quick_sum(product, rounded + self.1 * by)
    }

    /// Over a number of 16 digits.
    #[inline]
    pub(super) fn over(self, by: f64) -> Self {
        let first = self.0 / by;
        let rest = self - Self::from(by).times(first);
        let second = rest.0 / by;
        let rest = rest - Self::from(by).times(second);
        quick_sum(first, second) + (rest.0 / by).into()
    }
}

impl From<f64> for Wide {
    #[inline]
    fn from(value: f64) -> Self {
        Self(value, 0.0)
    }
}

impl Add for Wide {
    type Output = Self;
    #[inline]
    fn add(self, other: Self) -> Self {
        let (upper, lower) = (two_sum(self.0, other.0), two_sum(self.1, other.1));
        let sum = quick_sum(upper.0, upper.1 + lower.0);
        quick_sum(sum.0, sum.1 + lower.1)
    }
}

impl Neg for Wide {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        Self(-self.0, -self.1)
    }
}

impl Sub for Wide {
    type Output = Self;
    #[inline]
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Wide {
    type Output = Self;
    #[inline]
    fn mul(self, other: Self) -> Self {
        let ([a, b], [c, d]) = (halves(self.0), halves(other.0));
        let product = self.0 * other.0;
        let rounded = ((a * c - product) + a * d + b * c) + b * d;
        quick_sum(product, rounded + (self.0 * other.1 + self.1 * other.0))
    }
}

impl Div for Wide {
    type Output = Self;
    #[inline]
    fn div(self, other: Self) -> Self {
        let first = self.0 / other.0;
        let rest = self - other * first.into();
        let second = rest.0 / other.0;
        let rest = rest - other * second.into();
        quick_sum(first, second) + (rest.0 / other.0).into()
    }
}

/// A symmetric matrix with a diagonal and three entries to its right in each row.
#[derive(Debug, Clone, Default)]
pub(super) struct Band(Vec<[Wide; 4]>);

impl Band {
    /// Zeros.
    pub(super) fn zeros(rows: usize) -> Self {
        Self(vec![[Wide::ZERO; 4]; rows])
    }

    /// Adds to an entry on or above the diagonal.
    #[inline]
    pub(super) fn add(&mut self, row: usize, column: usize, value: Wide) {
        let entry = &mut self.0[row][column - row];
        *entry = *entry + value;
    }

    /// The solution for a right side, by `L D Lᵀ`.
    pub(super) fn solved(mut self, mut right: Vec<Wide>) -> Vec<Wide> {
        let rows = &mut self.0;
        let count = rows.len();
        for i in 0..count {
            let row = rows[i];
            let part = Wide::from(1.0) / row[0];
            for j in 1..4.min(count - i) {
                let factor = row[j] * part;
                for k in j..4.min(count - i) {
                    rows[i + j][k - j] = rows[i + j][k - j] - factor * row[k];
                }
                right[i + j] = right[i + j] - factor * right[i];
                rows[i][j] = factor;
            }
            right[i] = right[i] * part;
        }
        for i in (0..count).rev() {
            for j in 1..4.min(count - i) {
                right[i] = right[i] - rows[i][j] * right[i + j];
            }
        }
        right
    }
}

#[cfg(test)]
mod tests {
    use super::{Band, Wide};

    /// Of `1/3` the product with 3 is 1 to 31 digits, and of `1 + 2⁻⁸⁰` no digit is lost.
    #[test]
    fn numbers_have_thirty_digits() {
        let third = Wide::from(1.0) / 3.0.into();
        let off = third * 3.0.into() - 1.0.into();
        assert!(off.near().abs() < 1e-31, "{off:?}");
        let small = 2.0_f64.powi(-80);
        assert_eq!([third.times(3.0), third.over(7.0)], [third * 3.0.into(), third / 7.0.into()]);
        let sum = Wide::from(1.0) + small.into();
        let off = sum * sum - 1.0.into() - (2.0 * small).into();
        assert!((off.near() - small * small).abs() < 1e-31, "{off:?}");
    }

    /// Rows `6, −4, 1` of a band, times 1, 2, 3, …
    #[test]
    fn a_band_is_solved() {
        let rows = 9;
        let value = |i: usize| (i + 1) as f64;
        let entry = |i: usize, j: usize| [6.0, -4.0, 1.0, 0.25].get(i.abs_diff(j)).copied().unwrap_or(0.0);
        let mut band = Band::zeros(rows);
        (0..rows).for_each(|i| (i..rows.min(i + 4)).for_each(|j| band.add(i, j, entry(i, j).into())));
        let right = (0..rows).map(|i| Wide::from((0..rows).map(|j| entry(i, j) * value(j)).sum::<f64>())).collect();
        for (i, found) in band.solved(right).into_iter().enumerate() {
            assert!((found - value(i).into()).near().abs() < 1e-28, "{i}: {found:?}");
        }
    }
}
