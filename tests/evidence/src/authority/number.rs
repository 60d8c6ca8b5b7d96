//! Numbers that do not round: fractions, and integers in units of 2⁻²⁵⁶, which round so late that it can be bounded.

use dashu_int::{IBig, UBig};
use dashu_ratio::RBig;

/// What the authority computes with.
pub trait Number: Clone + PartialOrd {
    /// A whole number.
    fn whole(value: i64) -> Self;
    /// The number itself, not a neighbour; zero for what is no number.
    fn of(value: f64) -> Self;
    /// The sum.
    fn plus(&self, other: &Self) -> Self;
    /// The difference.
    fn minus(&self, other: &Self) -> Self;
    /// The product.
    fn times(&self, other: &Self) -> Self;
    /// The quotient.
    fn over(&self, other: &Self) -> Self;
    /// The nearest 64-bit number, or one of its neighbours.
    fn to_double(&self) -> f64;

    /// Zero.
    #[must_use]
    fn zero() -> Self {
        Self::whole(0)
    }

    /// `|self|`.
    #[must_use]
    fn magnitude(&self) -> Self {
        if *self < Self::zero() { Self::zero().minus(self) } else { self.clone() }
    }

    /// `numerator / denominator`.
    fn fraction(numerator: i64, denominator: i64) -> Self {
        Self::whole(numerator).over(&Self::whole(denominator))
    }
}

/// `mantissa · 2^exponent`, exactly; zero for what is no number.
fn parts(value: f64) -> (i64, i32) {
    if !value.is_finite() || value == 0.0 {
        return (0, 0);
    }
    let bits = value.to_bits();
    let (exponent, fraction) = ((bits >> 52) & 0x7ff, bits & ((1 << 52) - 1));
    // Subnormal numbers have no leading one.
    let (mantissa, exponent) = if exponent == 0 { (fraction, 1) } else { (fraction | (1 << 52), exponent) };
    let mantissa = i64::try_from(mantissa).unwrap_or(0);
    (if value < 0.0 { -mantissa } else { mantissa }, i32::try_from(exponent).unwrap_or(0) - 1075)
}

fn shift(exponent: i32) -> usize {
    usize::try_from(exponent.unsigned_abs()).unwrap_or(0)
}

impl Number for RBig {
    fn whole(value: i64) -> Self {
        Self::from(IBig::from(value))
    }

    fn of(value: f64) -> Self {
        let (mantissa, exponent) = parts(value);
        let power = UBig::ONE << shift(exponent);
        if exponent < 0 {
            Self::from_parts(IBig::from(mantissa), power)
        } else {
            Self::from(IBig::from(mantissa) * IBig::from(power))
        }
    }

    fn plus(&self, other: &Self) -> Self {
        self + other
    }

    fn minus(&self, other: &Self) -> Self {
        self - other
    }

    fn times(&self, other: &Self) -> Self {
        self * other
    }

    fn over(&self, other: &Self) -> Self {
        self / other
    }

    fn to_double(&self) -> f64 {
        self.to_f64().value()
    }
}

/// Binary places of [`Fixed`]. A unit there is 10⁻⁷⁷; a grid of 10⁵ intervals multiplies it by 10⁴⁰ at the very most, and
/// [`Solution::uncertainty`](super::clapeyron::Solution::uncertainty) says by how much.
const PLACES: usize = 256;

/// Terms of a series of e^−1, of which the last is less than 2⁻²⁵⁶: 58! has 260 bits.
const TERMS: i64 = 60;

/// A multiple of 2⁻²⁵⁶. Sums and products with integers are exact; other products and quotients are off by a unit at most.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub struct Fixed(IBig);

impl Fixed {
    /// π by Machin's formula, 16 arctan(1/5) − 4 arctan(1/239).
    pub fn pi() -> Self {
        let arctan = |inverse: i64| {
            let square = Self::whole(inverse * inverse);
            let mut power = Self::fraction(1, inverse);
            let (mut sum, mut k) = (Self::zero(), 1);
            while power != Self::zero() {
                let term = power.over(&Self::whole(k));
                sum = if k % 4 == 1 { sum.plus(&term) } else { sum.minus(&term) };
                power = power.over(&square);
                k += 2;
            }
            sum
        };
        Self::whole(16).times(&arctan(5)).minus(&Self::whole(4).times(&arctan(239)))
    }

    /// `e^self` of a number that is not positive: the series of `self/2ⁿ`, which lies between −1 and 0, squared `n` times. Each square doubles
    /// the relative error.
    pub fn decay(&self) -> Self {
        let (mut part, mut halvings) = (self.clone(), 0);
        while part < Self::whole(-1) {
            part = Self(part.0 >> 1);
            halvings += 1;
        }
        let (mut term, mut sum, mut k) = (Self::whole(1), Self::zero(), 1);
        while k < TERMS {
            sum = sum.plus(&term);
            term = term.times(&part).over(&Self::whole(k));
            k += 1;
        }
        (0..halvings).fold(sum, |power, _| power.times(&power))
    }

    /// With so many digits behind the point, rounded.
    pub fn decimal(&self, places: usize) -> String {
        let scale = (0..places).fold(IBig::ONE, |power, _| power * IBig::from(10));
        let half = IBig::ONE << (PLACES - 1);
        let digits = ((self.magnitude().0 * scale + half) >> PLACES).to_string();
        let digits = format!("{digits:0>width$}", width = places + 1);
        let (whole, fraction) = digits.split_at(digits.len() - places);
        format!("{}{whole}.{fraction}", if *self < Self::zero() { "-" } else { "" })
    }

    /// The cosine by its series, the angle at most a few turns: digits are lost to terms of size e^|angle| only.
    pub fn cosine(&self) -> Self {
        let square = self.times(self);
        let (mut term, mut sum, mut k) = (Self::whole(1), Self::zero(), 0);
        while term != Self::zero() {
            sum = if k % 4 == 0 { sum.plus(&term) } else { sum.minus(&term) };
            term = Self((term.0 * &square.0 / IBig::from((k + 1) * (k + 2))) >> PLACES);
            k += 2;
        }
        sum
    }
}

impl Number for Fixed {
    fn whole(value: i64) -> Self {
        Self(IBig::from(value) << PLACES)
    }

    fn of(value: f64) -> Self {
        let (mantissa, exponent) = parts(value);
        let exponent = exponent + i32::try_from(PLACES).unwrap_or(0);
        let mantissa = IBig::from(mantissa);
        Self(if exponent < 0 { mantissa >> shift(exponent) } else { mantissa << shift(exponent) })
    }

    fn plus(&self, other: &Self) -> Self {
        Self(&self.0 + &other.0)
    }

    fn minus(&self, other: &Self) -> Self {
        Self(&self.0 - &other.0)
    }

    fn times(&self, other: &Self) -> Self {
        Self((&self.0 * &other.0) >> PLACES)
    }

    fn over(&self, other: &Self) -> Self {
        Self((&self.0 << PLACES) / &other.0)
    }

    fn to_double(&self) -> f64 {
        // 2⁻²⁵⁶ is a normal number; the integer has less than a thousand bits.
        self.0.to_f64().value() * f64::from_bits((1023 - 256) << 52)
    }
}
