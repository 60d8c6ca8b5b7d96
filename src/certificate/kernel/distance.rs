//! From a gap to the error of a deflection: its distance from the admissible one, and that one's from the true one.
//!
//! ```text
//! |v − v*| ≤ max |v − v̂| + max |v̂ − v*|        on each part of the beam
//! ```
//!
//! Both deflections, `v̂` that is admissible and `v` that is judged, are polynomials by pieces. A part lies in one piece of each,
//! and parts are so narrow that Bernstein's coefficients of their difference are next to its values.

use super::hold::OUTWARDS;
use super::interval::Interval;
use super::load::cells;
use super::polynomial::{Polynomial, number};
use super::proof::{Pair, Piece};

// Report: certificate
/// `√(2 gap / 3 EI)`, by which a lever is to be multiplied.
pub(crate) fn factor(gap: f64, stiffness: f64) -> f64 {
    (number(2) * Interval::exact(gap) / (number(3) * Interval::exact(stiffness))).sqrt().hi()
}

/// How far an admissible deflection can be off at most on a part of the beam, by the best of what holds it.
pub(crate) fn on_part(pair: &Pair, factor: f64, part: [f64; 2]) -> f64 {
    let bounds = pair.holds.iter().map(|hold| (factor * hold.lever(part) + hold.shift(part)) * OUTWARDS);
    bounds.fold(f64::INFINITY, f64::min)
}

/// The same anywhere: for a beam on two supports at its ends `l²/4 · √(2 gap / (3 EI l))`.
pub(crate) fn anywhere(pair: &Pair, stiffness: f64, length: f64) -> f64 {
    let factor = factor(pair.gap, stiffness);
    let places = pair.holds.iter().flat_map(|hold| [hold.0.from, hold.0.to, hold.1.from, hold.1.to]).collect();
    cells(0.0, length, places).into_iter().map(|part| on_part(pair, factor, part)).fold(0.0, f64::max)
}
// Report: end

/// No part of the beam that is compared at once is wider than this share of it, and a cell that is wider than [`SHORT`] has at least
/// [`PARTS`]: of what the coefficients of its difference are too large by, a sixty-fourth remains.
const NARROW: f64 = 1.0 / 512.0;
const SHORT: f64 = 1.0 / 2048.0;
const PARTS: f64 = 8.0;

/// A bound on the error of a deflection.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Error {
    /// The bound.
    pub(crate) most: f64,
    /// Where it is largest.
    pub(crate) at: f64,
    /// At least the largest magnitude of the deflection itself.
    pub(crate) size: f64,
}

impl Error {
    /// Nothing is known.
    pub(crate) const UNKNOWN: Self = Self { most: f64::INFINITY, at: 0.0, size: f64::INFINITY };
}

/// The ends of parts of a cell of the judged deflection, besides its own: those of the pieces of `v̂`, and some between.
fn between(pieces: &[Piece], [a, b]: [f64; 2], length: f64) -> Vec<f64> {
    let first = pieces.partition_point(|p| p.to <= a);
    let mut places: Vec<f64> = pieces[first..].iter().map(|p| p.to).take_while(|x| *x < b).collect();
    if SHORT * length < b - a {
        let parts = ((b - a) / (NARROW * length)).ceil().max(PARTS);
        places.extend((1..).map(f64::from).take_while(|k| *k < parts).map(|k| a + (b - a) * (k / parts)));
    }
    places
}

/// The error of a deflection by cells, from left to right, in each of them `v(from + s)`. One that is not there all the way cannot
/// be judged.
pub(crate) fn of(
    pair: &Pair,
    judged: impl Iterator<Item = ([f64; 2], Polynomial)>,
    stiffness: f64,
    length: f64,
) -> Error {
    let factor = factor(pair.gap, stiffness);
    let about = |v: &Polynomial, from: f64, x: f64| {
        if from < x { v.shifted(Interval::exact(x) - Interval::exact(from)) } else { *v }
    };
    let mut error = Error { most: 0.0, at: 0.0, size: 0.0 };
    let mut reached = 0.0;
    for (cell, v) in judged {
        if !(cell[0] <= reached && reached < cell[1]) {
            return Error::UNKNOWN;
        }
        for [a, b] in cells(cell[0], cell[1], between(&pair.pieces, cell, length)) {
            let piece = pair.pieces.get(pair.pieces.partition_point(|piece| piece.to <= a));
            let Some(piece) = piece.filter(|piece| piece.from <= a && b <= piece.to) else { return Error::UNKNOWN };
            let (v, width) = (about(&v, cell[0], a), Interval::exact(b) - Interval::exact(a));
            let apart = v.minus(&about(&piece.v, piece.from, a)).range(width).magnitude();
            let bound = (on_part(pair, factor, [a, b]) + apart) * OUTWARDS;
            error.size = error.size.max(v.range(width).magnitude());
            if error.most < bound {
                (error.most, error.at) = (bound, 0.5 * (a + b));
            }
        }
        reached = cell[1];
    }
    if length <= reached { error } else { Error::UNKNOWN }
}

/// The same for the deflection that the places of a witness make, off which `v̂` was lifted: the bound.
pub(crate) fn of_witness(pair: &Pair, stiffness: f64, length: f64) -> f64 {
    (anywhere(pair, stiffness, length) + pair.lifted) * OUTWARDS
}

#[cfg(test)]
mod tests;
