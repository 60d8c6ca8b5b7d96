//! From a gap to the error of a deflection: its distance from the admissible one plus the distance between the admissible and the true one.
//!
//! ```text
//! |v − v*| ≤ max |v − v̂| + max |v̂ − v*|        on each part of the beam
//! ```
//!
//! Both deflections, the admissible `v̂` and the judged `v`, are piecewise polynomials. On a part of width `w` from `a` to `b` that lies
//! in one piece of each, their difference `d` satisfies
//!
//! ```text
//! |d| ≤ max(|d_a|, |d_b|) + w²/8 · max |d''|,      |d''| ≤ max(|d''_a|, |d''_b|) + w²/8 · max |v̂'''' − v''''|
//! ```

use super::interval::Interval;
use super::load::cells;
use super::polynomial::number;
use super::proof::{Pair, Piece};
use super::reference::{Line, OUTWARDS, near};

/// `√(2 gap / 3 EI)`, the factor for a lever.
pub(crate) fn factor(gap: f64, stiffness: f64) -> f64 {
    (number(2) * Interval::exact(gap) / (number(3) * Interval::exact(stiffness))).sqrt().hi()
}

/// The lines that hold the beam near a part of it. The nearest lines of supports and of zones are selected separately, because the line
/// of two supports also holds the beam where there are many parts of zones between them.
pub(crate) fn lines(pair: &Pair, part: [f64; 2]) -> impl Iterator<Item = &Line> {
    near(&pair.lines, part).iter().chain(near(&pair.zones, part))
}

/// The largest error of an admissible deflection on a part of the beam, by the best of the lines that hold it.
pub(crate) fn on_part(pair: &Pair, factor: f64, part: [f64; 2]) -> f64 {
    let bounds = lines(pair, part).map(|of| (factor * of.lever(part, pair.soft) + of.shift(part)) * OUTWARDS);
    bounds.fold(pair.taut.on_part(factor, part), f64::min)
}

/// The same on the whole beam: for a beam on two supports at its ends `l²/4 · √(2 gap / (3 EI l))`.
pub(crate) fn anywhere(pair: &Pair, stiffness: f64, length: f64) -> f64 {
    let factor = factor(pair.gap, stiffness);
    let places = |Line(a, b): &Line| [a.from, a.to, b.from, b.to, a.reach[0], a.reach[1]];
    let places = pair.lines.iter().chain(&pair.zones).flat_map(places);
    let places = places.chain(pair.taut.places()).collect();
    cells(0.0, length, places).into_iter().map(|part| on_part(pair, factor, part)).fold(0.0, f64::max)
}

/// A bound on the error of a deflection.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Error {
    /// The bound.
    pub(crate) most: f64,
    /// Position of the largest bound.
    pub(crate) at: f64,
    /// An upper bound of the largest magnitude of the deflection itself.
    pub(crate) size: f64,
}

/// A part of the judged deflection: its ends, `v` and `v''` at both, and the largest `|v''''|`.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Part {
    pub(crate) ends: [f64; 2],
    pub(crate) values: [[Interval; 2]; 2],
    pub(crate) fourth: f64,
}

/// A bound on the magnitude between two ends, from the magnitudes at both ends and a bound on the second derivative.
fn bow(at_ends: [f64; 2], width: f64, second: f64) -> f64 {
    at_ends[0].max(at_ends[1]) + 0.125 * width * width * second
}

/// The error of a deflection given by parts from left to right, each within one piece of `v̂`; [`None`] if the parts do not cover the
/// whole beam or a bound is not a number.
pub(crate) fn of(pair: &Pair, parts: impl Iterator<Item = Part>, stiffness: f64, length: f64) -> Option<Error> {
    let factor = factor(pair.gap, stiffness);
    let mut parts = parts.peekable();
    let mut error = Error { most: 0.0, at: 0.0, size: 0.0 };
    let mut reached = 0.0;
    for Piece { from, to, v, .. } in &pair.pieces {
        let bent = v.derivative().derivative();
        let at = |x: f64| [v, &bent].map(|of| of.at(Interval::length(*from, x)));
        let most_fourth = bent.derivative().derivative().range(Interval::length(*from, *to)).magnitude();
        let mut left = at(reached);
        while let Some(Part { ends: [a, b], values, fourth }) = parts.next_if(|part| part.ends[1] <= *to) {
            if !(*from <= a && a <= reached && reached <= a && a < b) {
                return None;
            }
            let right = at(b);
            let off = |k: usize| [(left[k] - values[0][k]).magnitude(), (right[k] - values[1][k]).magnitude()];
            let own = |k: usize| values.map(|end| end[k].magnitude());
            let width = b - a;
            let apart = bow(off(0), width, bow(off(1), width, most_fourth + fourth));
            let bound = (on_part(pair, factor, [a, b]) + apart) * OUTWARDS + f64::MIN_POSITIVE;
            let size = bow(own(0), width, bow(own(1), width, fourth)) * OUTWARDS + f64::MIN_POSITIVE;
            if bound.is_nan() || size.is_nan() {
                return None;
            }
            error.size = error.size.max(size);
            if error.most < bound {
                (error.most, error.at) = (bound, 0.5 * (a + b));
            }
            (reached, left) = (b, right);
        }
    }
    (length <= reached && parts.peek().is_none()).then_some(error)
}

/// The bound for the deflection that follows from the positions of the candidate contact list, from which `v̂` was lifted.
pub(crate) fn of_witness(pair: &Pair, stiffness: f64, length: f64) -> f64 {
    (anywhere(pair, stiffness, length) + pair.lifted) * OUTWARDS
}

#[cfg(test)]
mod tests;
