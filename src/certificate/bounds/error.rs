//! From a gap to deflections.

use super::cells;
use super::curve::{Piece, overlay};
use super::largest::largest;
use super::polynomial::{Polynomial, number};
use super::proof::Pair;
use crate::certificate::interval::Interval;
use crate::scene::Scale;
use crate::state::Nodes;

// Report: certificate
/// `√(2 gap / (3 EI l))`, by which `x (l − x)` is to be multiplied.
pub(super) fn factor(gap: f64, stiffness: f64, length: f64) -> Interval {
    let below = number(3) * Interval::exact(stiffness) * Interval::exact(length);
    (number(2) * Interval::exact(gap) / below).sqrt()
}

/// At least `|v − v*|` from `a` to `b`: `factor · x (l − x) + |v̂ − v|`, with `apart` for the largest `|v̂ − v|` there.
fn bound_between([a, b]: [f64; 2], factor: Interval, apart: f64, length: f64) -> f64 {
    let l = Interval::exact(length);
    let lever = |x: f64| (Interval::exact(x) * (l - Interval::exact(x))).hi();
    // x (l − x) is largest in the middle of the beam, and monotone on either side of it.
    let in_the_middle = a <= 0.5 * length && 0.5 * length <= b;
    let most = if in_the_middle { (l * l / number(4)).hi() } else { lever(a).max(lever(b)) };
    (factor * Interval::exact(most) + Interval::exact(apart)).hi()
}
// Report: end

/// How far an admissible deflection can be off at most, anywhere: `l²/4 · √(2 gap / (3 EI l))`.
pub(super) fn of_gap(gap: f64, stiffness: f64, length: f64) -> f64 {
    let l = Interval::exact(length);
    (factor(gap, stiffness, length) * (l * l / number(4))).hi()
}

/// A bound on the error of a deflection.
#[derive(Debug, Clone, Copy)]
pub(super) struct Error {
    /// The bound.
    pub(super) most: f64,
    /// Where it is largest.
    pub(super) at: f64,
    /// The largest magnitude of the deflection itself.
    pub(super) size: f64,
}

impl Error {
    /// Nothing is known.
    pub(super) const UNKNOWN: Self = Self { most: f64::INFINITY, at: 0.0, size: f64::INFINITY };

    /// Nothing has been compared.
    const NONE: Self = Self { most: 0.0, at: 0.0, size: 0.0 };

    /// Takes in a bound in a cell, and the largest magnitude of the judged deflection there. No number is no bound.
    pub(super) fn include(&mut self, bound: f64, size: f64, at: f64) {
        if bound.is_nan() || size.is_nan() {
            *self = Self { at, ..Self::UNKNOWN };
            return;
        }
        self.size = self.size.max(size);
        if self.most < bound {
            (self.most, self.at) = (bound, at);
        }
    }

    /// Compares pieces of the admissible deflection with cells of the judged one in intervals. Returns how far they go.
    pub(super) fn compare(
        &mut self,
        pieces: &[Piece],
        judged: impl Iterator<Item = ([f64; 2], Polynomial)>,
        factor: Interval,
        length: f64,
    ) -> f64 {
        let mut reached = 0.0;
        let curve = pieces.iter().map(|p| ([p.from, p.to], p.v));
        overlay(curve, judged, |a, b, v, own| {
            reached = b;
            let width = Interval::exact(b) - Interval::exact(a);
            let difference = v.minus(own);
            let mut apart = difference.range(width).magnitude();
            if WIDE * length < b - a && self.most < apart {
                apart = closer(&difference, width);
            }
            let bound = bound_between([a, b], factor, apart, length);
            self.include(bound, own.range(width).magnitude(), Interval::between(a, b).middle());
        });
        reached
    }
}

/// The range of a cell that is wider than this share of the beam is found in parts: the coefficients of Bernstein, between
/// which it lies, are up to `9/4` times a cubic that vanishes at both ends. Narrow cells share their values with their
/// neighbours.
const WIDE: f64 = 1.0 / 1024.0;

/// The largest magnitude of a polynomial for `0 ≤ s ≤ w`, by parts.
fn closer(polynomial: &Polynomial, width: Interval) -> f64 {
    /// Parts of a cell: of what the coefficients are too large by, a sixty-fourth remains.
    const PARTS: usize = 8;
    // An eighth of the upper bound of the width: parts overlap by rounding and leave nothing out.
    let part = Interval::exact(width.hi() / 8.0);
    (0..PARTS).fold(0.0, |most: f64, k| most.max(polynomial.shifted(number(k) * part).range(part).magnitude()))
}

/// The largest value of `√(2 gap x² (l − x)²/(3 EI l)) + |v̂ − v|`, and where it is, for a deflection by pieces.
pub(super) fn of_pieces(
    pair: &Pair,
    judged: impl Iterator<Item = ([f64; 2], Polynomial)> + Clone,
    stiffness: f64,
    length: f64,
) -> Error {
    let mut error = Error::NONE;
    let factor = factor(pair.gap.hi(), stiffness, length);
    let reached = error.compare(&pair.curve.pieces, judged.clone(), factor, length);
    error.size = largest(judged);
    // A deflection that is not there all the way cannot be judged.
    if length <= reached { error } else { Error::UNKNOWN }
}

/// The same for the deflection that the places of a witness make, off which `v̂` was lifted.
pub(super) fn of_witness(pair: &Pair, stiffness: f64, length: f64) -> Error {
    let size = largest(pair.curve.pieces.iter().map(|p| ([p.from, p.to], p.v)));
    let [gap, lifted] = [of_gap(pair.gap.hi(), stiffness, length), pair.lifted].map(Interval::exact);
    let most = (gap + lifted).hi();
    if most.is_finite() { Error { most, at: 0.5 * length, size } } else { Error::UNKNOWN }
}

/// The same for the cubics between the nodes of a grid: cell by cell in plain numbers where cells are narrow.
pub(super) fn of_nodes(pair: &Pair, given: &Nodes, scale: &Scale, stiffness: f64, length: f64) -> Error {
    let Some(nodes) = cells::nodes(given, scale, length) else { return Error::UNKNOWN };
    if WIDE * length < nodes.windows(2).map(|w| w[1].x - w[0].x).fold(0.0, f64::max) {
        return of_pieces(pair, nodes.windows(2).map(|w| cells::cubic(w, stiffness)), stiffness, length);
    }
    let mut error = Error::NONE;
    cells::compare(&mut error, &pair.curve.pieces, &nodes, factor(pair.gap.hi(), stiffness, length), stiffness);
    error
}

#[cfg(test)]
mod tests;
