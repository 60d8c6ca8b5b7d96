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
pub(crate) type Ends<'a> = [Option<&'a ContactNode>; 2];

/// The power of the distance from an end of a span in `φ`.
pub(crate) fn power(enclosed: &EnclosedScene<'_>, end: Option<&ContactNode>) -> usize {
    let Some(node) = end else { return 0 };
    let built_in = enclosed.support(node.x).is_some_and(|s| s.slope.is_some());
    let ends = node.x <= 0.0 || enclosed.length <= node.x;
    if ends && !built_in && matches!(node.slope, Slope::Free(_)) { 1 } else { 2 }
}

/// `α`, not negative; [`None`] if no lift of this shape is enough.
pub(crate) fn lift(enclosed: &EnclosedScene<'_>, span: &Span, ends: Ends<'_>) -> Option<f64> {
    // From each node to the middle, or to the free end.
    let middle = match ends {
        [None, _] => span.from,
        [_, None] => span.to,
        _ => 0.5 * (span.from + span.to),
    };
    let mut breaks = enclosed.gap.breaks(span.from, span.to);
    breaks.push(middle);
    let curve = span.curve(breaks, enclosed.load, enclosed.stiffness);
    let width = |[from, to]: [f64; 2]| Interval::exact(to) - Interval::exact(from);
    // The clearance about that end of a cell that is nearer to the node.
    let from_the_left = curve.iter().take_while(|(cell, _)| cell[0] < middle).map(|(cell, v)| {
        let [from, to] = *cell;
        (from, width(*cell), enclosed.gap.cell(from, to).minus(v))
    });
    let [v, slope, curvature, third] = span.end;
    let at_end = [v, -slope, curvature / number(2), -third / number(6)];
    let from_the_right = curve.iter().rev().take_while(|(cell, _)| middle < cell[1]).map(|(cell, v)| {
        let [from, to] = *cell;
        let v = v.shifted(width(*cell)).mirrored();
        let v = if span.to <= to { v.known(&at_end) } else { v };
        (to, width(*cell), enclosed.gap.mirrored_cell(from, to).minus(&v))
    });
    let powers = ends.map(|end| power(enclosed, end));
    let mut most = 0.0_f64;
    if let Some(node) = ends[0] {
        most = most.max(beside(enclosed, span, node, powers, from_the_left)?);
    }
    if let Some(node) = ends[1] {
        most = most.max(beside(enclosed, span, node, [powers[1], powers[0]], from_the_right)?);
    }
    most.is_finite().then_some(most)
}

/// `α` for cells from a node to the middle of its span, with the powers of `φ` at this node and at the other end.
fn beside(
    enclosed: &EnclosedScene<'_>,
    span: &Span,
    node: &ContactNode,
    powers: [usize; 2],
    cells: impl Iterator<Item = (f64, Interval, Polynomial)>,
) -> Option<f64> {
    let length = Interval::exact(span.to) - Interval::exact(span.from);
    let mut most = 0.0;
    let mut before: Option<(Interval, Polynomial)> = None;
    for (near, width, clearance) in cells {
        let order = if before.is_none() { enclosed.order(node, span.to <= node.x) } else { 0 };
        let clearance = match before {
            // What vanishes at the node is small beside it, also behind the end of a short cell.
            Some((width, ref before)) if enclosed.gap.is_smooth_at(near) => {
                clearance.known(&[before.at(width), before.derivative().at(width)])
            }
            Some(_) => clearance,
            None => clearance.vanishing(order),
        };
        let [less, more] = [near.min(node.x), near.max(node.x)].map(Interval::exact);
        let distance = if before.is_none() { Interval::ZERO } else { more - less };
        let powers = [order, powers[0], powers[1]];
        let part = Part { clearance: clearance.divided(order), width, distance, whole: width.hi(), length, powers };
        most = part.lift(most, &mut MOST_PARTS.clone())?;
        before = Some((width, clearance));
    }
    Some(most)
}

/// `φ` about the left end of the span, with its powers at both ends.
pub(crate) fn shape(span: &Span, powers: [usize; 2]) -> Polynomial {
    const BINOMIALS: [&[f64]; 3] = [&[1.0], &[1.0, -1.0], &[1.0, -2.0, 1.0]];
    let per = Interval::exact(1.0) / (Interval::exact(span.to) - Interval::exact(span.from));
    let mut factor = Interval::exact(1.0);
    let mut coefficients = vec![Interval::ZERO; powers[0]];
    for order in 0..powers[0] + powers[1] + 1 {
        if powers[0] <= order {
            coefficients.push(Interval::exact(BINOMIALS[powers[1]][order - powers[0]]) * factor);
        }
        factor = if order == 0 { per } else { factor * per };
    }
    Polynomial::new(&coefficients)
}

/// A part of a cell: the clearance over a power `order` of the distance from a contact node.
#[derive(Clone, Copy)]
struct Part {
    clearance: Polynomial,
    width: Interval,
    distance: Interval,
    /// Width of the cell, and length of the span.
    whole: f64,
    length: Interval,
    /// The order, and the powers of `φ` at this node and at the other one.
    powers: [usize; 3],
}

impl Part {
    /// The least value of `φ` over that power.
    fn least(&self) -> f64 {
        let [order, own, other] = self.powers;
        let per = Interval::exact(1.0) / self.length;
        let rest = (self.length - (self.distance + self.width)) * per;
        let least = |base: Interval, times: usize| {
            (0..times).fold(Interval::exact(1.0), |product, _| product * Interval::exact(base.lo().max(0.0)))
        };
        (least(per, own) * least(self.distance, own - order) * least(rest, other)).lo()
    }

    /// `α` for this part if that is more than the `most` of others, and otherwise that.
    fn lift(&self, most: f64, parts: &mut usize) -> Option<f64> {
        let lowest = self.clearance.range(self.width).lo();
        if 0.0 <= lowest {
            return Some(most);
        }
        let enough = (Interval::exact(-lowest) / Interval::exact(self.least())).hi();
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
