//! How far a span has to be lifted to be clear of the foundation: mostly not at all.
//!
//! The span is lifted by `α φ`, which vanishes at its nodes with its slope, where the beam goes on or the slope is given or turns a spring:
//!
//! ```text
//! φ(s) = (s/L)^a (1 − s/L)^b,     a, b = 2 at a node, 1 at one where the beam ends and its slope is free, 0 at a free end, under an axial force 2
//! ```
//!
//! so that what it costs is of the size of `α`, and not of its root: where the beam is pressed it stays where it is. `α = 0`
//! proves `v ≤ g`. Where beam and foundation are one curve but for rounding, no arithmetic can tell, and `α` is of the size
//! of the rounding.

use super::contact_node::{ContactNode, EnclosedScene, EnclosedSupport, Slope};
use super::interval::Interval;
use super::polynomial::Polynomial;
use super::span::{Curve, Span};

/// Penetration is bounded by parts until they are this share of their cell; a longer proof would make the lift less.
const SMALLEST_PART: f64 = 1.0 / 8.0;
/// Cells that are not looked at together: near a contact, where mostly none is clear, a look costs as much as a proof.
const FEW: usize = 8;

/// The ends of a span: nodes, or free ends of the beam.
type Ends<'a> = [Option<&'a ContactNode>; 2];

/// The power of the distance from an end of a span in `φ`.
fn power(enclosed: &EnclosedScene<'_>, end: Option<&ContactNode>) -> usize {
    // Under an axial force the moments of an overhang depend on where its free end is.
    let Some(node) = end else { return if enclosed.tension == 0.0 { 0 } else { 2 } };
    // A lift that turned a spring would have its share in the gap, too.
    let holds_slope = enclosed.support(node.x).is_some_and(EnclosedSupport::holds_slope);
    let ends = node.x <= 0.0 || enclosed.length <= node.x;
    if ends && !holds_slope && matches!(node.slope, Slope::Free(_)) { 1 } else { 2 }
}

/// `α φ` about the left end of the span, zero where it is clear; [`None`] if no lift of this shape is enough.
pub(crate) fn lift(enclosed: &EnclosedScene<'_>, span: &Span, parts: &[Curve], ends: Ends<'_>) -> Option<Polynomial> {
    // From each node to the middle, or to the free end.
    let middle = match ends {
        [None, _] => span.from,
        [_, None] => span.to,
        _ => 0.5 * (span.from + span.to),
    };
    let places = parts.iter().map(|(part, _)| part[0]).chain([middle]).collect();
    let cells = enclosed.cells(span.from, span.to, places);
    let meeting = cells.partition_point(|cell| cell[0] < middle);
    let powers = ends.map(|end| power(enclosed, end));
    let lift = |side: usize, cells: &[[f64; 2]]| {
        let Some(node) = ends[side] else { return Some(0.0) };
        let (order, shape) = (enclosed.order(node, side == 1), shape(span, [powers[side], powers[1 - side]]));
        let side = Side { enclosed, parts, node, shape, from_the_left: side == 1 };
        // What vanishes at the node is small beside it, also behind the end of a short cell.
        Some(side.lift(cells, (0.0, vec![Interval::ZERO; order]))?.0)
    };
    let (left, right) = (lift(0, &cells[..meeting])?, lift(1, &cells[meeting..])?);
    Some(shape(span, powers).times(Interval::exact(left.max(right))))
}

/// Cells on one side of a node: seen from there, and each about that end of it that is nearer.
struct Side<'a> {
    enclosed: &'a EnclosedScene<'a>,
    /// The span, by parts known from both ends.
    parts: &'a [Curve],
    node: &'a ContactNode,
    /// `φ` from the node.
    shape: Polynomial,
    /// Whether the cells are on the left side of the node.
    from_the_left: bool,
}

/// What is known where the cells next to a node were looked at: `α` for them, and of the clearance and its derivatives at their end. At
/// the node itself that they are zero.
type Seen = (f64, Vec<Interval>);

impl Side<'_> {
    /// `v(place + s)` between two places of a part.
    fn deflection(&self, place: f64, [from, to]: [f64; 2]) -> Option<Polynomial> {
        let part = self.parts.partition_point(|(part, _)| part[1] <= from);
        let &(part, known) = self.parts.get(part).filter(|(part, _)| part[0] <= from && to <= part[1])?;
        let end = usize::from(self.from_the_left);
        Some(known[end].shifted(Interval::length(part[end], place)))
    }

    /// Whether the span is clear of the foundation between two places, at a glance.
    fn is_clear(&self, [from, to]: [f64; 2]) -> bool {
        let least = self.enclosed.gap.least(from, to);
        let below = |v: Polynomial| v.range(Interval::length(from, to)).hi() <= least;
        f64::NEG_INFINITY < least && self.deflection(from, [from, to]).is_some_and(below)
    }

    /// Cells, from left to right, next to those that were seen: together if they are clear at a glance, and otherwise by halves.
    fn lift(&self, cells: &[[f64; 2]], (most, known): Seen) -> Option<Seen> {
        let Self { enclosed, node, from_the_left, .. } = *self;
        let ([first, ..], [.., last]) = (cells, cells) else { return Some((most, known)) };
        if 1 < cells.len() {
            if FEW < cells.len() && self.is_clear([first[0], last[1]]) {
                return Some((most, Vec::new()));
            }
            let (left, right) = cells.split_at(cells.len() / 2);
            let [near, far] = if from_the_left { [right, left] } else { [left, right] };
            return self.lift(far, self.lift(near, (most, known))?);
        }
        let [near, far] = if from_the_left { [first[1], first[0]] } else { *first };
        let width = Interval::length(first[0], first[1]);
        let distance = Interval::length(near.min(node.x), near.max(node.x));
        let clearance = enclosed.gap.about(near, *first).minus(&self.deflection(near, *first)?);
        let clearance = if from_the_left { clearance.mirrored() } else { clearance }.known(&known);
        let order = if distance.is_zero() { known.len() } else { 0 };
        let [quotient, shape] = [clearance, self.shape].map(|of| of.divided(order));
        let most = enough(&quotient, &shape, [distance, width], most)?;
        let Some(kink) = enclosed.gap.kink(far) else {
            // What stands alone there is no part of any cell.
            let clearance = enclosed.gap.depth(far) - self.deflection(far, *first)?.at(Interval::ZERO);
            let place = [distance + width, Interval::ZERO];
            return Some((enough(&Polynomial::new(&[clearance]), &self.shape, place, most)?, Vec::new()));
        };
        let mut known = vec![clearance.at(width)];
        // In a joint the beam has a kink of its own.
        if !enclosed.is_joint(far) {
            known.push(clearance.derivative().at(width) + kink);
        }
        Some((most, known))
    }
}

/// `φ` about the left end of the span, with its powers at both ends; and with these exchanged, seen from the right end.
fn shape(span: &Span, powers: [usize; 2]) -> Polynomial {
    /// Of Pascal's triangle, with the signs of `(1 − s)ⁿ`.
    const BINOMIALS: [&[f64]; 3] = [&[1.0], &[1.0, -1.0], &[1.0, -2.0, 1.0]];
    let mut coefficients = vec![Interval::ZERO; powers[0]];
    coefficients.extend(BINOMIALS[powers[1]].iter().copied().map(Interval::exact));
    let length = Interval::length(span.from, span.to);
    Polynomial::new(&coefficients).scaled(Interval::exact(1.0) / length)
}

/// `α` for a cell at a distance from a node if that is more than the `most` of others, and otherwise that: of the clearance there, and of
/// `φ` from the node, both over a power of the distance.
fn enough(clearance: &Polynomial, shape: &Polynomial, [distance, whole]: [Interval; 2], most: f64) -> Option<f64> {
    let mut most = most;
    clearance.negative(whole, |below, [start, width], [is_settled, is_last]| {
        let distance = distance + start;
        // No bound, if `φ` may vanish.
        let least = shape.shifted(distance).range(width).lo().max(0.0);
        let enough = (Interval::exact(below) / Interval::exact(least)).hi();
        // Close to a node, and not at it, `φ` may be far smaller at one end of a part than at the other.
        let is_even = distance.is_zero() || width.hi() <= distance.hi();
        let is_small = width.hi() <= SMALLEST_PART * whole.hi();
        let is_taken = is_last || enough <= most || enough.is_finite() && is_even && is_small && is_settled;
        most = if is_taken { most.max(enough) } else { most };
        is_taken
    });
    Some(most).filter(|most| most.is_finite())
}

#[cfg(test)]
mod tests;
