//! The extremes of a function by pieces, sharply: those of an answer are compared with those of its contacts.
//!
//! The coefficients of Bernstein enclose a polynomial on its cell, but generously: those of a beam that sags freely are a
//! thirtieth too large, those of a cubic that vanishes at both ends up to 9/4 times. A concave polynomial is below its tangents, of
//! which that at its greatest value is sharp. Of another cell the halves are looked at that could exceed the greatest value that was
//! found at a point.

use super::kernel::interval::Interval;
use super::kernel::polynomial::{Polynomial, number};

/// Share of the largest magnitude to which it is found.
const SHARP: f64 = 1e-13;

/// Halvings of a cell, at most; one that has a single largest value needs some twenty.
const HALVINGS: u32 = 200;

/// What is left of the excess is rounding if it is no more than this many times what is not known of the values.
const KNOWN: f64 = 4.0;

/// What the largest `|v|` over all cells lies between.
pub(crate) fn largest(cells: impl Iterator<Item = ([f64; 2], Polynomial)> + Clone) -> Interval {
    let [greatest, least] = extremes(cells);
    Interval::between(greatest.lo().max(-least.hi()).max(0.0), greatest.hi().max(-least.lo()))
}

/// What the greatest and the least `v` over all cells lie between, apart by a share [`SHARP`] of the largest magnitude as far as
/// rounding allows. Where the beam follows a plateau all values are the largest, and no halving would tell them apart: their own
/// uncertainty ends that.
pub(crate) fn extremes(cells: impl Iterator<Item = ([f64; 2], Polynomial)> + Clone) -> [Interval; 2] {
    let least = greatest(cells.clone().map(|(cell, v)| (cell, Polynomial::ZERO.minus(&v))));
    [greatest(cells), -least]
}

fn greatest(cells: impl Iterator<Item = ([f64; 2], Polynomial)> + Clone) -> Interval {
    let none = (f64::NEG_INFINITY, 0.0_f64);
    let seen = |(reached, size): (f64, f64), v: Interval| (reached.max(v.lo()), size.max(least_magnitude(v)));
    let (mut reached, mut size) = cells.clone().fold(none, |best, (_, v)| seen(best, v.at(Interval::ZERO)));
    let mut bound = reached;
    let mut open = Vec::new();
    for ([from, to], v) in cells {
        let mut left = HALVINGS;
        open.push((v, Interval::exact(to) - Interval::exact(from)));
        while let Some((v, width)) = open.pop() {
            let most = v.range(width).hi();
            if most.is_nan() {
                return Interval::between(reached, f64::INFINITY);
            }
            if most <= reached + SHARP * size + KNOWN * v.uncertainty(width.hi()) || left == 0 {
                bound = bound.max(most);
                continue;
            }
            let (value, tangent) = tangent(&v, width);
            (reached, size) = seen((reached, size), value);
            if tangent <= reached + SHARP * size + KNOWN * v.uncertainty(width.hi()) {
                bound = bound.max(tangent);
                continue;
            }
            left -= 1;
            // Half of the upper bound of the width: parts overlap by rounding and leave nothing out.
            let half = Interval::exact(width.hi()) / number(2);
            let right = v.shifted(half);
            (reached, size) = seen((reached, size), right.at(Interval::ZERO));
            open.extend([(v, half), (right, half)]);
        }
    }
    Interval::between(reached, bound)
}

/// A value of a polynomial for `0 ≤ s ≤ w`, mostly near its greatest one, and a bound of all from the tangent there, below which a
/// concave function lies; infinite for any other.
fn tangent(v: &Polynomial, width: Interval) -> (Interval, f64) {
    /// Of Newton's method; where it needs more the cell is halved.
    const STEPS: usize = 6;
    let (slope, w) = (v.derivative(), width.hi());
    let bend = slope.derivative();
    if 0.0 < bend.range(width).hi() {
        return (v.at(Interval::ZERO), f64::INFINITY);
    }
    let mut s = 0.5 * width.lo();
    for _ in 0..STEPS {
        let [first, second] =
            [&slope, &bend].map(|of| of.coefficients().iter().rev().fold(0.0, |sum, c| sum * s + c.middle()));
        let step = (s - first / second).clamp(0.0, width.lo());
        if step.is_nan() {
            break;
        }
        s = step;
    }
    let here = Interval::exact(s);
    let (value, slope) = (v.at(here), slope.at(here));
    let beyond = (slope * (Interval::exact(w) - here)).hi().max((slope * -here).hi()).max(0.0);
    (value, (value + Interval::exact(beyond)).hi())
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
