//! Numbers with about 32 digits, each the unevaluated sum of two 64-bit numbers.
//!
//! The rounding error of an operation is itself a 64-bit number and is carried along (Dekker 1971).

use std::ops::{Add, Mul, Sub};

/// `high + low`, with `low` at most half a unit in the last place of `high`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Double {
    high: f64,
    low: f64,
}

impl Double {
    pub(crate) const ZERO: Self = Self { high: 0.0, low: 0.0 };

    /// Converts a 64-bit number exactly.
    pub(crate) fn exact(value: f64) -> Self {
        Self { high: value, low: 0.0 }
    }

    /// `self · x + other`, with an error of some units of `10⁻³²` relative to the two terms.
    pub(crate) fn times_plus(self, x: f64, other: Self) -> Self {
        let product = self.high * x;
        let lost = libm::fma(self.high, x, -product);
        let Self { high: sum, low: rest } = Self::sum(product, other.high);
        let low = rest + (lost + self.low * x + other.low);
        let high = sum + low;
        Self { high, low: low - (high - sum) }
    }

    /// The exact sum of two numbers (Knuth).
    fn sum(a: f64, b: f64) -> Self {
        let high = a + b;
        let part = high - a;
        Self { high, low: (a - (high - part)) + (b - part) }
    }

    /// The two 64-bit numbers, the larger one first.
    pub(crate) fn parts(self) -> [f64; 2] {
        [self.high, self.low]
    }

    /// The value rounded to 64 bits.
    pub(crate) fn rounded(self) -> f64 {
        self.high
    }
}

impl Add for Double {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        let (high, low) = (Self::sum(self.high, other.high), Self::sum(self.low, other.low));
        let first = Self::sum(high.high, high.low + low.high);
        Self::sum(first.high, first.low + low.low)
    }
}

impl Sub for Double {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        self + Self { high: -other.high, low: -other.low }
    }
}

impl Mul for Double {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        let product = self.high * other.high;
        let lost = libm::fma(self.high, other.high, -product);
        Self::sum(product, lost + (self.high * other.low + self.low * other.high))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// `(x − 1)(x + 1) = x² − 1` for a number close to 1: 64-bit arithmetic would lose half of the digits.
    #[test]
    fn what_is_rounded_off_is_kept() {
        let x = 1.0 + f64::EPSILON;
        let square = Double::exact(1.0).times_plus(x, Double::ZERO).times_plus(x, Double::exact(-1.0));
        let expected = f64::EPSILON * (2.0 + f64::EPSILON);
        assert_eq!(square.rounded().to_bits(), expected.to_bits());
    }
}
