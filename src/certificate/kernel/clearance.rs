//! How far a span has to be lifted to be clear of the foundation: mostly not at all.
//!
//! The span is lifted by `α φ`, which vanishes at its nodes with its slope, where the beam goes on or the slope is given:
//!
//! ```text
//! φ(s) = (s/L)^a (1 − s/L)^b,     a, b = 2 at a node, 1 at one where the beam ends and its slope is free, 0 at a free end
//! ```
//!
//! so that what it costs is of the size of `α`, and not of its root: where the beam is pressed it stays where it is. `α = 0`
//! proves `v ≤ g`. Where beam and foundation are one curve but for rounding, no arithmetic can tell, and `α` is of the size
//! of the rounding.

use super::contact_node::{ContactNode, EnclosedScene, Slope};
use super::interval::Interval;
use super::polynomial::{Polynomial, number};
use super::span::Span;

/// Parts into which a cell is cut before it is given up.
const MOST_PARTS: usize = 200;
/// Penetration is bounded by parts until they are this share of their cell; a longer proof would make the lift less.
const SMALLEST_PART: f64 = 1.0 / 8.0;

/// The ends of a span: nodes, or free ends of the beam.
type Ends<'a> = [Option<&'a ContactNode>; 2];

/// The power of the distance from an end of a span in `φ`.
fn power(enclosed: &EnclosedScene<'_>, end: Option<&ContactNode>) -> usize {
    let Some(node) = end else { return 0 };
    let built_in = enclosed.support(node.x).is_some_and(|s| s.slope.is_some());
    let ends = node.x <= 0.0 || enclosed.length <= node.x;
    if ends && !built_in && matches!(node.slope, Slope::Free(_)) { 1 } else { 2 }
}

/// `α φ` about the left end of the span, zero where it is clear; [`None`] if no lift of this shape is enough.
pub(crate) fn lift(enclosed: &EnclosedScene<'_>, span: &Span, ends: Ends<'_>) -> Option<Polynomial> {
    // From each node to the middle, or to the free end.
    let middle = match ends {
        [None, _] => span.from,
        [_, None] => span.to,
        _ => 0.5 * (span.from + span.to),
    };
    let mut breaks = enclosed.gap.breaks(span.from, span.to);
    breaks.push(middle);
    let curve = span.curve(breaks, enclosed.load, enclosed.stiffness);
    // The clearance about that end of a cell that is nearer to the node, and seen from there.
    let from_the_left = curve
        .iter()
        .take_while(|(cell, _)| cell[0] < middle)
        .map(|(cell, v)| (cell[0], cell[1], enclosed.gap.about(cell[0], *cell).minus(v)));
    let [v, slope, curvature, third] = span.end;
    let at_end = [v, slope, curvature / number(2), third / number(6)];
    let from_the_right = curve.iter().rev().take_while(|(cell, _)| middle < cell[1]).map(|(cell, v)| {
        let v = v.shifted(Interval::exact(cell[1]) - Interval::exact(cell[0]));
        let v = if span.to <= cell[1] { v.known(&at_end) } else { v };
        (cell[1], cell[0], enclosed.gap.about(cell[1], *cell).minus(&v).mirrored())
    });
    let powers = ends.map(|end| power(enclosed, end));
    let [about_left, about_right] = [powers, [powers[1], powers[0]]].map(|powers| shape(span, powers));
    let left = ends[0].map_or(Some(0.0), |node| beside(enclosed, node, false, about_left, from_the_left))?;
    let right = ends[1].map_or(Some(0.0), |node| beside(enclosed, node, true, about_right, from_the_right))?;
    Some(about_left.times(Interval::exact(left.max(right))))
}

/// `α` for cells on the left or the right side of a node, with `φ` and the clearance as seen from there.
fn beside(
    enclosed: &EnclosedScene<'_>,
    node: &ContactNode,
    from_the_left: bool,
    shape: Polynomial,
    cells: impl Iterator<Item = (f64, f64, Polynomial)>,
) -> Option<f64> {
    let apart = |a: f64, b: f64| Interval::exact(a.max(b)) - Interval::exact(a.min(b));
    let mut most = 0.0;
    let mut order = enclosed.order(node, from_the_left);
    // What vanishes at the node is small beside it, also behind the end of a short cell.
    let mut known = vec![Interval::ZERO; order];
    for (near, far, clearance) in cells {
        let (width, distance) = (apart(near, far), apart(near, node.x));
        let clearance = clearance.known(&known);
        let [quotient, shape] = [clearance, shape].map(|of| of.divided(order));
        let part = Part { clearance: quotient, shape, width, distance, whole: width.hi() };
        most = part.lift(most, &mut MOST_PARTS.clone())?;
        order = 0;
        known.clear();
        // Over a kink the value goes on, and over a smooth place the slope as well.
        if enclosed.gap.is_continuous_at(far) {
            known.push(clearance.at(width));
        }
        if enclosed.gap.is_smooth_at(far) {
            known.push(clearance.derivative().at(width));
        }
    }
    Some(most)
}

/// `φ` about the left end of the span, with its powers at both ends; and with these exchanged, seen from the right end.
fn shape(span: &Span, powers: [usize; 2]) -> Polynomial {
    const BINOMIALS: [&[f64]; 3] = [&[1.0], &[1.0, -1.0], &[1.0, -2.0, 1.0]];
    let mut coefficients = vec![Interval::ZERO; powers[0]];
    coefficients.extend(BINOMIALS[powers[1]].iter().copied().map(Interval::exact));
    let length = Interval::exact(span.to) - Interval::exact(span.from);
    Polynomial::new(&coefficients).scaled(Interval::exact(1.0) / length)
}

/// A part of a cell: the clearance, from its beginning, and `φ`, from a contact node, both over a power of the distance from there.
#[derive(Clone, Copy)]
struct Part {
    clearance: Polynomial,
    shape: Polynomial,
    width: Interval,
    distance: Interval,
    /// Width of the cell.
    whole: f64,
}

impl Part {
    /// `α` for this part if that is more than the `most` of others, and otherwise that.
    fn lift(&self, most: f64, parts: &mut usize) -> Option<f64> {
        let lowest = self.clearance.range(self.width).lo();
        if 0.0 <= lowest {
            return Some(most);
        }
        let least = self.shape.shifted(self.distance).range(self.width).lo();
        // No bound, if `φ` may vanish.
        let enough = (Interval::exact(-lowest) / Interval::exact(least.max(0.0))).hi();
        if enough <= most {
            return Some(most);
        }
        *parts = parts.saturating_sub(1);
        // Close to a node, and not at it, `φ` may be far smaller at one end of a part than at the other.
        let is_even = self.distance.is_zero() || self.width.hi() <= self.distance.hi();
        let is_rounding = -lowest <= 4.0 * self.clearance.uncertainty(self.width.hi());
        let inside = self.clearance.at(Interval::ZERO).hi() < 0.0 || self.clearance.at(self.width).hi() < 0.0;
        let is_small = self.width.hi() <= SMALLEST_PART * self.whole;
        let is_known = is_even && is_small && (is_rounding || inside);
        if enough.is_finite() && (is_known || *parts == 0) {
            return Some(most.max(enough));
        }
        if *parts == 0 {
            return None;
        }
        // Halves of the upper bound of the width: they overlap by rounding and leave nothing out.
        let half = Interval::exact(0.5 * self.width.hi());
        let first = Self { width: half, ..*self };
        let second = Self { clearance: self.clearance.shifted(half), distance: self.distance + half, ..first };
        second.lift(first.lift(most, parts)?, parts)
    }
}

#[cfg(test)]
mod tests;
