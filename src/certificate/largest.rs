//! The largest magnitude of a deflection by pieces, sharply: an answer is recognised by it.
//!
//! The coefficients of Bernstein enclose a polynomial on its cell, but generously: those of a beam that sags freely are a
//! thirtieth too large, those of a cubic that vanishes at both ends up to 9/4 times. Halving a cell makes the excess four times
//! smaller; of the halves only those are kept that could exceed the largest value that was found at a point.

use super::kernel::interval::Interval;
use super::kernel::polynomial::{Polynomial, number};

/// Share of the largest magnitude to which it is found.
const SHARP: f64 = 1e-13;

/// Halvings of a cell, at most; one that has a single largest value needs some twenty.
const HALVINGS: u32 = 200;

/// What is left of the excess is rounding if it is no more than this many times what is not known of the values.
const KNOWN: f64 = 4.0;

/// What the largest `|v|` over all cells lies between, apart by a share [`SHARP`] as far as rounding allows. Where the beam
/// follows a plateau all values are the largest, and no halving would tell them apart: their own uncertainty ends that.
pub(crate) fn largest(cells: impl Iterator<Item = ([f64; 2], Polynomial)> + Clone) -> Interval {
    let mut reached = cells.clone().fold(0.0, |most: f64, (_, v)| most.max(least_magnitude(v.at(Interval::ZERO))));
    let mut bound = 0.0_f64;
    let mut open = Vec::new();
    for ([from, to], v) in cells {
        let mut left = HALVINGS;
        open.push((v, Interval::exact(to) - Interval::exact(from)));
        while let Some((v, width)) = open.pop() {
            let range = v.range(width).magnitude();
            if range.is_nan() {
                return Interval::between(reached, f64::INFINITY);
            }
            if range <= reached * (1.0 + SHARP) + KNOWN * v.uncertainty(width.hi()) || left == 0 {
                bound = bound.max(range);
                continue;
            }
            left -= 1;
            // Half of the upper bound of the width: parts overlap by rounding and leave nothing out.
            let half = Interval::exact(width.hi()) / number(2);
            let right = v.shifted(half);
            reached = reached.max(least_magnitude(right.at(Interval::ZERO)));
            open.extend([(v, half), (right, half)]);
        }
    }
    Interval::between(reached, bound)
}

/// The smallest magnitude in an interval.
pub(super) fn least_magnitude(interval: Interval) -> f64 {
    interval.lo().max(-interval.hi()).max(0.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// `x − 2 x³ + x⁴` on a beam of length one: 5/16 in the middle.
    #[test]
    fn a_free_beam_sags_by_five_sixteenths() {
        let v = Polynomial::new(&[0.0, 1.0, 0.0, -2.0, 1.0].map(Interval::exact));
        let most = largest(std::iter::once(([0.0, 1.0], v)));
        assert!((0.3125..=0.3125 * (1.0 + 2.0 * SHARP)).contains(&most.hi()), "{most:?}");
        assert!((0.3125 * (1.0 - 2.0 * SHARP)..=0.3125).contains(&most.lo()), "{most:?}");
    }
}
