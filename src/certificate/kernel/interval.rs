//! Interval arithmetic with outward rounding: each computed interval encloses the exact result.
//!
//! IEEE 754 rounds `+ − × ÷ √` to the nearest number, so the true result is between the two neighbours of the rounded one.
//! [`f64::next_down`] and [`f64::next_up`] give these neighbours. This widens an interval by one unit in the last place on each side and
//! needs no rounding mode. An operation that leaves the range of `f64`, or has no value, gives the whole line: a bound that is useless,
//! but true.
//!
//! Cosine and sine are computed by libm. Their error is assumed to be at most one unit in the last place; two are allowed.

use std::ops::{Add, Div, Mul, Neg, Sub};

/// All numbers from `lo` to `hi`.
#[must_use]
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Interval {
    lo: f64,
    hi: f64,
}

impl Interval {
    /// Zero, exactly.
    pub const ZERO: Self = Self { lo: 0.0, hi: 0.0 };
    /// All numbers.
    pub const WHOLE: Self = Self { lo: f64::NEG_INFINITY, hi: f64::INFINITY };
    /// `2π`: the double below it and the one above.
    pub(crate) const TAU: Self = Self { lo: std::f64::consts::TAU, hi: 6.283_185_307_179_587 };

    /// A number, exactly; the whole line for NaN.
    pub fn exact(value: f64) -> Self {
        Self::between(value, value)
    }

    /// From `lo` to `hi`, in this order; NaN leaves that side open.
    pub fn between(lo: f64, hi: f64) -> Self {
        Self { lo: if lo.is_nan() { f64::NEG_INFINITY } else { lo }, hi: if hi.is_nan() { f64::INFINITY } else { hi } }
    }

    /// `to − from`.
    pub(crate) fn length(from: f64, to: f64) -> Self {
        Self::exact(to) - Self::exact(from)
    }

    /// `−radius … radius`.
    pub fn around_zero(radius: f64) -> Self {
        Self::between(-radius.abs(), radius.abs())
    }

    /// Widens two rounded results to their outer neighbours.
    fn outward(lo: f64, hi: f64) -> Self {
        Self::between(lo.next_down(), hi.next_up())
    }

    /// From the smallest to the largest of some rounded results.
    fn of_corners(corners: [f64; 4]) -> Self {
        if corners.iter().any(|c| c.is_nan()) {
            return Self::WHOLE;
        }
        // Not `f64::min` and `f64::max`: these also check for NaN, which is excluded here, and are slower.
        let least = |a: f64, b: f64| if b < a { b } else { a };
        let most = |a: f64, b: f64| if a < b { b } else { a };
        let [a, b, c, d] = corners;
        Self::outward(least(least(a, b), least(c, d)), most(most(a, b), most(c, d)))
    }

    /// Lower end.
    #[inline]
    pub fn lo(self) -> f64 {
        self.lo
    }

    /// Upper end.
    #[inline]
    pub fn hi(self) -> f64 {
        self.hi
    }

    /// The midpoint, rounded; zero if an end is infinite.
    #[must_use]
    pub(crate) fn middle(self) -> f64 {
        let middle = 0.5 * self.lo + 0.5 * self.hi;
        if middle.is_finite() { middle } else { 0.0 }
    }

    /// The largest magnitude in the interval.
    #[must_use]
    pub(crate) fn magnitude(self) -> f64 {
        self.lo.abs().max(self.hi.abs())
    }

    /// True only for the interval that contains nothing but zero.
    #[inline]
    pub fn is_zero(self) -> bool {
        // Both signed zeros, and no other number.
        self.lo.to_bits() << 1 == 0 && self.hi.to_bits() << 1 == 0
    }

    /// True if both ends are finite.
    #[inline]
    pub fn is_finite(self) -> bool {
        self.lo.is_finite() && self.hi.is_finite()
    }

    /// The smallest interval that contains both.
    pub(crate) fn hull(self, other: Self) -> Self {
        Self { lo: self.lo.min(other.lo), hi: self.hi.max(other.hi) }
    }

    /// The part that is not negative: a better enclosure of a number that is known not to be negative.
    pub(crate) fn not_negative(self) -> Self {
        self.meet(Self::between(0.0, f64::INFINITY))
    }

    /// The interval of `max(x, 0)`.
    pub(crate) fn positive_part(self) -> Self {
        Self { lo: self.lo.max(0.0), hi: self.hi.max(0.0) }
    }

    /// The square. It is narrower than the product of two independent numbers of the interval.
    pub fn square(self) -> Self {
        (self * self).not_negative()
    }

    /// The square root of the part that is not negative.
    pub fn sqrt(self) -> Self {
        if self.is_zero() {
            return Self::ZERO;
        }
        let root = |x: f64| x.max(0.0).sqrt();
        Self::outward(root(self.lo), root(self.hi)).not_negative()
    }

    /// `cos(2π turns + phase)` and `sin(2π turns + phase)`.
    pub fn cos_sin(turns: Self, phase: Self) -> [Self; 2] {
        let angle = Self::TAU * turns + phase;
        let middle = angle.middle();
        // Neither function is steeper than 1.
        let radius = (angle - Self::exact(middle)).magnitude();
        let around = |value: f64| {
            let near = Self::between(value.next_down().next_down(), value.next_up().next_up());
            (near + Self::around_zero(radius)).meet(Self::around_zero(1.0))
        };
        [around(libm::cos(middle)), around(libm::sin(middle))]
    }

    /// The intersection: a better enclosure of one number from two.
    pub(crate) fn meet(self, other: Self) -> Self {
        Self { lo: self.lo.max(other.lo), hi: self.hi.min(other.hi) }
    }
}

impl Add for Interval {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        // A sum with zero is exact, and so is the sum of a number and its negative.
        match (self.is_zero(), other.is_zero()) {
            (true, _) => other,
            (_, true) => self,
            _ if self == -other && self.hi <= self.lo && self.is_finite() => Self::ZERO,
            _ => Self::outward(self.lo + other.lo, self.hi + other.hi),
        }
    }
}

impl Sub for Interval {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Neg for Interval {
    type Output = Self;

    fn neg(self) -> Self {
        Self { lo: -self.hi, hi: -self.lo }
    }
}

impl Mul for Interval {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        // A product with zero is exact if the other factor is finite.
        if (self.is_zero() && other.is_finite()) || (other.is_zero() && self.is_finite()) {
            return Self::ZERO;
        }
        Self::of_corners([self.lo * other.lo, self.lo * other.hi, self.hi * other.lo, self.hi * other.hi])
    }
}

impl Div for Interval {
    type Output = Self;

    fn div(self, other: Self) -> Self {
        if other.lo <= 0.0 && 0.0 <= other.hi {
            return Self::WHOLE;
        }
        if self.is_zero() {
            return Self::ZERO;
        }
        Self::of_corners([self.lo / other.lo, self.lo / other.hi, self.hi / other.lo, self.hi / other.hi])
    }
}
