//! Sharp extremes of a piecewise function, for comparing the extremes of an answer with those of its contacts.
//!
//! Bernstein coefficients enclose a polynomial on its cell, but not sharply. For a beam that deflects freely they are a thirtieth too
//! large, for a cubic that vanishes at both ends up to 9/4 times too large. A concave polynomial is below its tangents, and the tangent
//! at its maximum is sharp. Other cells are halved as long as a half could exceed the greatest value found at a point so far.

use super::kernel::interval::Interval;
use super::kernel::polynomial::{Polynomial, number};

/// Accuracy of an extreme, as a share of the largest magnitude.
const SHARP: f64 = 1e-13;

/// Largest number of halvings of a cell; a cell with a single maximum needs about twenty.
const HALVINGS: u32 = 200;

/// A remaining excess counts as rounding if it is at most this many times the uncertainty of the values.
const KNOWN: f64 = 4.0;

/// A bracket of the largest `|v|` over all cells.
pub(crate) fn largest(cells: impl Iterator<Item = ([f64; 2], Polynomial)> + Clone) -> Interval {
    let [greatest, least] = extremes(cells);
    Interval::between(greatest.lo().max(-least.hi()).max(0.0), greatest.hi().max(-least.lo()))
}

/// Brackets of the greatest and the least `v` over all cells, with a width of the share [`SHARP`] of the largest magnitude as far as
/// rounding allows. Where the beam follows a plateau all values are maxima, and halving cannot separate them. Their own uncertainty ends
/// the search.
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
            // The halves use the upper bound of the width, so the parts overlap by rounding and leave nothing out.
            let half = Interval::exact(width.hi()) / number(2);
            let right = v.shifted(half);
            (reached, size) = seen((reached, size), right.at(Interval::ZERO));
            open.extend([(v, half), (right, half)]);
        }
    }
    Interval::between(reached, bound)
}

/// A value of a polynomial for `0 ≤ s ≤ w`, usually near its maximum, and an upper bound of all values from the tangent there, which is
/// above a concave function. The bound is infinite for any other function.
fn tangent(v: &Polynomial, width: Interval) -> (Interval, f64) {
    /// Steps of Newton's method; if it needs more, the cell is halved.
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

    /// `x − 2 x³ + x⁴` on a beam of length one: 5/16 at midspan.
    #[test]
    fn a_free_beam_sags_by_five_sixteenths() {
        let v = Polynomial::new(&[0.0, 1.0, 0.0, -2.0, 1.0].map(Interval::exact));
        let most = largest(std::iter::once(([0.0, 1.0], v)));
        assert!((0.3125..=0.3125 * (1.0 + 2.0 * SHARP)).contains(&most.hi()), "{most:?}");
        assert!((0.3125 * (1.0 - 2.0 * SHARP)..=0.3125).contains(&most.lo()), "{most:?}");
    }
}
