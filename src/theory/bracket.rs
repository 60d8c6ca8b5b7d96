//! What keeps Newton's method from jumping to and fro: the values seen so far tell where a root can be.

/// Between which places the root of a node's equation must lie, as long as its neighbours do not move much.
#[derive(Debug, Clone, Copy)]
pub(super) struct Bracket {
    lo: f64,
    hi: f64,
}

impl Bracket {
    pub(super) const EVERYWHERE: Self = Self { lo: f64::NEG_INFINITY, hi: f64::INFINITY };

    /// Takes notice of the value at `x` of an equation that falls from left to right.
    pub(super) fn narrow(&mut self, x: f64, value: f64) {
        if 0.0 < value {
            self.lo = x;
        } else {
            self.hi = x;
        }
        if self.hi <= self.lo {
            // The neighbours have moved.
            *self = if 0.0 < value { Self { lo: x, ..Self::EVERYWHERE } } else { Self { hi: x, ..Self::EVERYWHERE } };
        }
    }

    /// Where to go instead of `wanted`: the middle, if it lies outside. Beside a point load Newton's method would jump
    /// from one side to the other for ever.
    pub(super) fn keep(&mut self, wanted: f64, rounding: f64) -> f64 {
        if self.hi - self.lo <= rounding {
            *self = Self::EVERYWHERE;
        }
        if self.lo <= wanted && wanted <= self.hi || !(self.lo.is_finite() && self.hi.is_finite()) {
            wanted
        } else {
            0.5 * (self.lo + self.hi)
        }
    }
}
