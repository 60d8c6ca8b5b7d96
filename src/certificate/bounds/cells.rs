//! How far a deflection that is given at nodes is from an admissible one, at the price of a few plain numbers a cell.
//!
//! Between two nodes at a distance `w` the judged deflection is the cubic with the given deflections `v` and moments `m` at both,
//! the admissible one `v̂` a polynomial. Their difference `d` and its second derivative are evaluated at the nodes, and
//!
//! ```text
//! |d| ≤ max(|d_i|, |d_{i+1}|) + w²/8 · max |d''|,      |d''| ≤ max(|d''_i|, |d''_{i+1}|) + w²/8 · max |v̂''''|
//! ```
//!
//! since the fourth derivative of a cubic is zero. Evaluation is in plain numbers. What they may be off by is bounded once for a
//! piece of `v̂`, for `Σ c_k s^k` by Horner's rule with `0 ≤ s ≤ S` and degree at most ten by `Σ (r_k + 20 ε |c_k|) S^k`:
//! `r_k` for what is not known of a coefficient, two roundings and that of `s` for every power (Higham 2002, section 5.1).
//! Cells that belong to more than one piece are left to intervals.

use super::curve::Piece;
use super::error::Error;
use super::polynomial::{Polynomial, TERMS, number};
use crate::certificate::interval::Interval;
use crate::scene::Scale;
use crate::state::Nodes;

/// Units of rounding in one value of a polynomial with [`TERMS`] coefficients: `3 · 10 + 2` halves, and a margin.
const ROUNDINGS: f64 = 20.0 * f64::EPSILON;

/// More than a dozen roundings of a sum of products without cancellation.
const OUTWARDS: f64 = 1.0 + 32.0 * f64::EPSILON;

/// A polynomial with plain coefficients, and by how much its values for `0 ≤ s ≤ S` may be off.
struct Plain {
    coefficients: [f64; TERMS],
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
        Self { coefficients, off: off * OUTWARDS + f64::MIN_POSITIVE }
    }

    fn at(&self, s: f64) -> f64 {
        self.coefficients.iter().rev().fold(0.0, |sum, c| sum * s + c)
    }
}

/// Deflection and moment at a place, dimensionless.
#[derive(Debug, Clone, Copy)]
pub(super) struct Node {
    pub(super) x: f64,
    pub(super) deflection: f64,
    pub(super) moment: f64,
}

/// The nodes of a grid with the two supports, dimensionless; [`None`] if they are not in order, or lists do not match.
pub(super) fn nodes(given: &Nodes, scale: &Scale, length: f64) -> Option<Vec<Node>> {
    let n = given.x.len();
    if given.deflection.len() != n || given.moment.len() != n {
        return None;
    }
    let support = |x: f64| Node { x, deflection: 0.0, moment: 0.0 };
    let mut nodes = Vec::with_capacity(n + 2);
    nodes.push(support(0.0));
    nodes.extend((0..n).map(|k| Node {
        x: given.x[k] / scale.length,
        deflection: given.deflection[k] / scale.depth,
        moment: given.moment[k] / scale.moment(),
    }));
    nodes.push(support(length));
    nodes.windows(2).all(|pair| pair[0].x < pair[1].x).then_some(nodes)
}

/// The cubic between two neighbouring nodes: `M = −EI v''` is linear, deflections and moments at the two ends are given.
pub(super) fn cubic(pair: &[Node], stiffness: f64) -> ([f64; 2], Polynomial) {
    let [left, right] = [pair[0], pair[1]];
    let [v0, m0, v1, m1] = [left.deflection, left.moment, right.deflection, right.moment].map(Interval::exact);
    let ei = Interval::exact(stiffness);
    let width = Interval::exact(right.x) - Interval::exact(left.x);
    let slope = (v1 - v0) / width + width * (number(2) * m0 + m1) / (number(6) * ei);
    let third = -((m1 - m0) / width) / (number(6) * ei);
    ([left.x, right.x], Polynomial::new(&[v0, slope, -(m0.half() / ei), third]))
}

/// Takes in the largest value of `factor · x (l − x) + |v̂ − v|` over all cells.
pub(super) fn compare(error: &mut Error, pieces: &[Piece], nodes: &[Node], factor: Interval, stiffness: f64) {
    let length = nodes.last().map_or(0.0, |last| last.x);
    let mut first = 0;
    for (p, piece) in pieces.iter().enumerate() {
        let within = first + nodes[first..].partition_point(|node| node.x <= piece.to);
        if first == within {
            continue;
        }
        narrow(error, piece, &nodes[first..within], factor.hi(), stiffness, length);
        first = within - 1;
        // The last cell that begins in this piece may end in another one.
        if first + 1 < nodes.len() {
            let cell = cubic(&nodes[first..first + 2], stiffness);
            error.compare(&pieces[p..], std::iter::once(cell), factor, length);
            first += 1;
        }
    }
    if first + 1 < nodes.len() {
        *error = Error::UNKNOWN;
    }
}

/// Takes in the cells between nodes that all lie in one piece.
fn narrow(error: &mut Error, piece: &Piece, nodes: &[Node], factor: f64, stiffness: f64, length: f64) {
    let width = (piece.to - piece.from) * OUTWARDS;
    let curvature = piece.v.derivative().derivative();
    let fourth = curvature.derivative().derivative().range(Interval::exact(width)).magnitude();
    let [value, second] = [&piece.v, &curvature].map(|p| Plain::of(p, width));
    let at = |node: &Node| {
        let s = node.x - piece.from;
        let bent = node.moment / stiffness;
        At {
            apart: (value.at(s) - node.deflection).abs() + value.off,
            turned: (second.at(s) + bent).abs() + (second.off + f64::EPSILON * bent.abs()),
            deflection: node.deflection.abs(),
            curvature: bent.abs(),
        }
    };
    let larger = |a: f64, b: f64| if a < b || b.is_nan() { b } else { a };
    let Some(start) = nodes.first() else { return };
    let mut left = at(start);
    for pair in nodes.windows(2) {
        let right = at(&pair[1]);
        let [from, to] = [pair[0].x, pair[1].x];
        let arrow = 0.125 * (to - from) * (to - from);
        // x (l − x) is concave with a second derivative of two.
        let lever = (from * (length - from)).max(to * (length - to)) + 2.0 * arrow;
        let turned = larger(left.turned, right.turned) + arrow * fourth;
        let bound = factor * lever + larger(left.apart, right.apart) + arrow * turned;
        let size = larger(left.deflection, right.deflection) + arrow * larger(left.curvature, right.curvature);
        error.include(outwards(bound), outwards(size), 0.5 * (from + to));
        left = right;
    }
}

/// What is needed of a node.
struct At {
    /// At least `|v̂ − v|`.
    apart: f64,
    /// At least `|v̂'' − v''|`.
    turned: f64,
    /// `|v|`.
    deflection: f64,
    /// `|v''|`.
    curvature: f64,
}

/// An upper bound of a sum of products of which none is negative.
fn outwards(sum: f64) -> f64 {
    sum * OUTWARDS + f64::MIN_POSITIVE
}

#[cfg(test)]
mod tests;
