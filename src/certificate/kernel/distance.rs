//! From a gap to the error of a deflection: its distance from the admissible one, and that one's from the true one.
//!
//! Both deflections, `v̂` that is admissible and `v` that is judged, are polynomials between neighbouring **samples**: the ends of
//! the cells of `v`, those of the pieces of `v̂`, and as many places more as leave no part wider than a small share of the beam.
//! On a part of width `w` from `a` to `b` their difference `d` is
//!
//! ```text
//! |d| ≤ max(|d_a|, |d_b|) + w²/8 · max |d''|,      |d''| ≤ max(|d''_a|, |d''_b|) + w²/8 · max |v̂'''' − v''''|
//! ```
//!
//! Values at samples are plain numbers. What they may be off by is bounded once for a piece, for `Σ c_k s^k` by Horner's rule with
//! `0 ≤ s ≤ S` and degree at most ten by `Σ (r_k + 20 ε |c_k|) S^k`: `r_k` for what is not known of a coefficient, two roundings
//! and that of `s` for every power (Higham 2002, section 5.1).

use super::contact_node::{EnclosedScene, EnclosedSupport};
use super::hold::OUTWARDS;
use super::interval::Interval;
use super::largest::largest;
use super::load::cells;
use super::polynomial::{Polynomial, TERMS, number};
use super::proof::Pair;
use super::proof::Piece;
use crate::scene::Scale;
use crate::state::Nodes;

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
    let factor = factor(pair.gap.hi(), stiffness);
    let places = pair.holds.iter().flat_map(|hold| [hold.0.from, hold.0.to, hold.1.from, hold.1.to]).collect();
    cells(0.0, length, places).into_iter().map(|part| on_part(pair, factor, part)).fold(0.0, f64::max)
}
// Report: end

/// No part of the beam that is compared at once is wider than this share of it, and a cell that is wider has at least
/// [`PARTS`]: of what its values between samples are too large by, a sixty-fourth remains.
const NARROW: f64 = 1.0 / 2048.0;
const PARTS: f64 = 8.0;

/// Units of rounding in one value of a polynomial with [`TERMS`] coefficients: `3 · 10 + 2` halves, and a margin. So many are
/// also enough for the cubic between two nodes.
const ROUNDINGS: f64 = 20.0 * f64::EPSILON;

/// A bound on the error of a deflection.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Error {
    /// The bound.
    pub(crate) most: f64,
    /// Where it is largest.
    pub(crate) at: f64,
    /// The largest magnitude of the deflection itself: at most, and at least as far as that was looked for.
    pub(crate) size: f64,
    pub(crate) least: f64,
}

impl Error {
    /// Nothing is known.
    pub(crate) const UNKNOWN: Self = Self { most: f64::INFINITY, at: 0.0, size: f64::INFINITY, least: 0.0 };

    /// Takes in a bound on a part, and the largest magnitude of the judged deflection there. No number is no bound.
    fn include(&mut self, bound: f64, size: f64, at: f64) {
        if bound.is_nan() || size.is_nan() {
            *self = Self { at, ..Self::UNKNOWN };
            return;
        }
        self.size = self.size.max(size);
        if self.most < bound {
            (self.most, self.at) = (bound, at);
        }
    }
}

/// A polynomial with plain coefficients, and by how much its values for `0 ≤ s ≤ S` may be off.
struct Plain {
    coefficients: [f64; TERMS],
    terms: usize,
    off: f64,
}

impl Plain {
    fn of(polynomial: &Polynomial, width: f64) -> Self {
        let mut coefficients = [0.0; TERMS];
        let (mut off, mut power) = (0.0, 1.0);
        for (plain, c) in coefficients.iter_mut().zip(polynomial.coefficients()) {
            *plain = c.middle();
            let radius = (c.hi() - *plain).max(*plain - c.lo());
            off += (radius + ROUNDINGS * plain.abs()) * power;
            power *= width * OUTWARDS;
        }
        Self { coefficients, terms: polynomial.coefficients().len(), off: off * OUTWARDS + f64::MIN_POSITIVE }
    }

    fn at(&self, s: f64) -> f64 {
        self.coefficients[..self.terms].iter().rev().fold(0.0, |sum, c| sum * s + c)
    }
}

/// The judged deflection at a place: `v` and `v''`, and what each may be off by.
struct Sample {
    x: f64,
    values: [f64; 2],
    off: [f64; 2],
}

/// A piece of `v̂` in plain numbers: `v̂`, `v̂''`, and the largest `|v̂''''|`.
struct Admissible {
    from: f64,
    to: f64,
    plain: [Plain; 2],
    fourth: f64,
}

impl Admissible {
    fn of(piece: &Piece) -> Self {
        let width = (piece.to - piece.from) * OUTWARDS;
        let curvature = piece.v.derivative().derivative();
        let fourth = curvature.derivative().derivative().range(Interval::exact(width)).magnitude();
        Self { from: piece.from, to: piece.to, plain: [&piece.v, &curvature].map(|p| Plain::of(p, width)), fourth }
    }

    /// At least `|d|` and `|d''|` at a sample.
    fn apart(&self, sample: &Sample) -> [f64; 2] {
        let s = sample.x - self.from;
        [0, 1].map(|k| (self.plain[k].at(s) - sample.values[k]).abs() + (self.plain[k].off + sample.off[k]))
    }
}

/// The largest value of the bound on `|v̂ − v*|` and of `|v̂ − v|` together, and where it is. The judged deflection is known at
/// samples, the ends of all pieces among them, and its fourth derivative is at most `fourth`.
fn compare(pair: &Pair, mut samples: impl Iterator<Item = Sample>, fourth: f64, stiffness: f64) -> Error {
    let factor = factor(pair.gap.hi(), stiffness);
    let mut error = Error { most: 0.0, at: 0.0, size: 0.0, least: 0.0 };
    let mut pieces = pair.pieces.iter().map(Admissible::of);
    let mut current = pieces.next();
    let mut left: Option<(Sample, [f64; 2])> = None;
    let larger = |a: f64, b: f64| if a < b || b.is_nan() { b } else { a };
    let outwards = |sum: f64| sum * OUTWARDS + f64::MIN_POSITIVE;
    let all = samples.try_for_each(|right| {
        let piece = current.as_ref().filter(|piece| right.x <= piece.to)?;
        let mut after = piece.apart(&right);
        if let Some((left, before)) = &left {
            let arrow = 0.125 * (right.x - left.x) * (right.x - left.x);
            let turned = larger(before[1], after[1]) + arrow * (fourth + piece.fourth);
            let bound = on_part(pair, factor, [left.x, right.x]) + larger(before[0], after[0]) + arrow * turned;
            let [v, bend] = [0, 1].map(|k| larger(left.values[k].abs(), right.values[k].abs()));
            error.include(outwards(bound), outwards(v + arrow * bend), 0.5 * (left.x + right.x));
        }
        if piece.to <= right.x {
            current = pieces.next();
            after = current.as_ref().map_or(after, |piece| piece.apart(&right));
        }
        left = Some((right, after));
        Some(())
    });
    // A deflection that is not there all the way cannot be judged.
    if all.is_some() && current.is_none() { error } else { Error::UNKNOWN }
}

/// The places strictly between the ends of a cell at which it is sampled: mostly none.
fn between(pieces: &[Piece], [a, b]: [f64; 2], length: f64) -> Vec<f64> {
    let first = pieces.partition_point(|p| p.to <= a);
    let mut places: Vec<f64> = pieces[first..].iter().map(|p| p.to).take_while(|x| *x < b).collect();
    if NARROW * length < b - a {
        let parts = ((b - a) / (NARROW * length)).ceil().max(PARTS);
        places.extend((1..).map(f64::from).take_while(|k| *k < parts).map(|k| a + (b - a) * (k / parts)));
        places.retain(|x| a < *x && *x < b);
        places.sort_by(f64::total_cmp);
        places.dedup();
    }
    places
}

/// The error of a deflection by pieces.
pub(crate) fn of_pieces(pair: &Pair, judged: &[([f64; 2], Polynomial)], stiffness: f64, length: f64) -> Error {
    let fourth = |v: &Polynomial| v.derivative().derivative().derivative().derivative();
    let width = |[a, b]: [f64; 2]| Interval::exact(b) - Interval::exact(a);
    let most = judged.iter().fold(0.0, |most: f64, (cell, v)| most.max(fourth(v).range(width(*cell)).magnitude()));
    let samples = judged.iter().flat_map(|(cell, v)| {
        let plain = [*v, v.derivative().derivative()].map(|p| Plain::of(&p, width(*cell).hi()));
        let from = cell[0];
        let sample = move |x: f64| {
            let values = [0, 1].map(|k| plain[k].at(x - from));
            Sample { x, values, off: [plain[0].off, plain[1].off] }
        };
        std::iter::once(from).chain(between(&pair.pieces, *cell, length)).chain([cell[1]]).map(sample)
    });
    let error = compare(pair, samples, most, stiffness);
    let size = largest(judged.iter().copied());
    Error { size: error.size.min(size.hi()), least: size.lo(), ..error }
}

/// The error of the deflection that the places of a witness make, off which `v̂` was lifted.
pub(crate) fn of_witness(pair: &Pair, stiffness: f64, length: f64) -> Error {
    let size = largest(pair.pieces.iter().map(|p| ([p.from, p.to], p.v)));
    let [gap, lifted] = [anywhere(pair, stiffness, length), pair.lifted].map(Interval::exact);
    let most = (gap + lifted).hi();
    // What was lifted is not the deflection that the places make.
    let least = (Interval::exact(size.lo()) - Interval::exact(pair.lifted)).lo().max(0.0);
    if most.is_finite() { Error { most, at: 0.5 * length, size: size.hi(), least } } else { Error::UNKNOWN }
}

/// The error of the cubics between the nodes of a grid, with the given deflections and moments at both ends of each. Supports
/// that are none of the nodes are added: what they ask is known, and without moment but where the beam is built in.
pub(crate) fn of_nodes(pair: &Pair, given: &Nodes, scale: &Scale, enclosed: &EnclosedScene<'_>) -> Error {
    let EnclosedScene { stiffness, length, supports, .. } = *enclosed;
    let n = given.x.len();
    if given.deflection.len() != n || given.moment.len() != n {
        return Error::UNKNOWN;
    }
    // Place, deflection and curvature at a node, dimensionless.
    let mut nodes = Vec::with_capacity(n + supports.len());
    let mut left = supports.iter().peekable();
    let added = |support: &EnclosedSupport| [support.x, support.deflection.middle(), 0.0];
    for k in 0..n {
        let x = given.x[k] / scale.length;
        nodes.extend(std::iter::from_fn(|| left.next_if(|s| s.x < x)).map(added));
        left.next_if(|s| s.x <= x);
        nodes.push([x, given.deflection[k] / scale.depth, -(given.moment[k] / scale.moment()) / stiffness]);
    }
    nodes.extend(left.map(added));
    let reaches = nodes.first().is_some_and(|node| node[0].abs() <= 0.0)
        && nodes.last().is_some_and(|node| (node[0] - length).abs() <= 0.0);
    if !reaches || !nodes.is_sorted_by(|a, b| a[0] < b[0]) {
        return Error::UNKNOWN;
    }
    let built_in = |x: f64| enclosed.support(x).and_then(|support| support.slope);
    // The curvature at a support in which the beam is built in, from its slope and the other end of the cell.
    let turned = |[a, v0, _]: [f64; 3], [b, v1, k1]: [f64; 3], slope: Interval| {
        3.0 * (v1 - v0 - slope.middle() * (b - a)) / ((b - a) * (b - a)) - 0.5 * k1
    };
    let at_node = |[x, v, bent]: [f64; 3]| Sample { x, values: [v, bent], off: [0.0, f64::EPSILON * bent.abs()] };
    let samples = nodes.windows(2).flat_map(|cell| {
        let (mut left, mut right) = (cell[0], cell[1]);
        let (held, ends) = (built_in(left[0]), built_in(right[0]));
        left[2] = held.map_or(left[2], |slope| turned(left, right, slope));
        right[2] = ends.map_or(right[2], |slope| turned(right, left, slope));
        let [[a, v0, k0], [b, v1, k1]] = [left, right];
        let inside = move |x: f64| {
            let [r, s] = [(b - x) / (b - a), (x - a) / (b - a)];
            let bow = (b - a) * (b - a) / 6.0;
            let v = v0 * r + v1 * s - bow * (k0 * r * (1.0 - r * r) + k1 * s * (1.0 - s * s));
            let bent = k0.abs() + k1.abs();
            let off = [v0.abs() + v1.abs() + bow * bent, bent].map(|v| v * ROUNDINGS);
            Sample { x, values: [v, k0 * r + k1 * s], off }
        };
        let start = (a <= 0.0 || held.is_some()).then(|| at_node(left));
        start.into_iter().chain(between(&pair.pieces, [a, b], length).into_iter().map(inside)).chain([at_node(right)])
    });
    compare(pair, samples, 0.0, stiffness)
}

#[cfg(test)]
mod tests;
