//! The lift that makes a span clear the foundation. In most spans the lift is zero.
//!
//! The span is lifted by `α φ`. At a node `φ` vanishes. Its slope vanishes there too if the beam continues, the slope is given or the
//! beam rotates a spring:
//!
//! ```text
//! φ(s) = (s/L)^a (1 − s/L)^b
//! a, b = 2 at a node; 1 at a node where the beam ends and its slope is free; 0 at a free end, or 2 under an axial force
//! ```
//!
//! With this shape the cost of a lift is proportional to `α` and not to its square root, because the beam does not move where it is
//! pressed. `α = 0` proves `v ≤ g`. Where beam and foundation are the same curve up to rounding, no arithmetic can prove a clearance,
//! and `α` has the size of the rounding.

use super::contact_node::{ContactNode, EnclosedScene, EnclosedSupport, Slope};
use super::interval::Interval;
use super::polynomial::Polynomial;
use super::span::{Curve, Span};

/// The penetration is bounded on parts down to this share of their cell; smaller parts would give a smaller lift but a longer proof.
const SMALLEST_PART: f64 = 1.0 / 8.0;
/// Cells up to this number are not tested together: near a contact most groups of cells fail the test, which then costs as much as a
/// proof.
const FEW: usize = 8;

/// The nodes at the ends of a span; [`None`] for a free end of the beam.
type Ends<'a> = [Option<&'a ContactNode>; 2];

/// The exponent in `φ` of the distance from an end of a span.
fn power(enclosed: &EnclosedScene<'_>, end: Option<&ContactNode>) -> usize {
    // Under an axial force the moments of an overhang depend on the deflection of its free end.
    let Some(node) = end else { return if enclosed.tension == 0.0 { 0 } else { 2 } };
    // A lift that rotates a spring would add to the gap too.
    let holds_slope = enclosed.support(node.x).is_some_and(EnclosedSupport::holds_slope);
    let ends = node.x <= 0.0 || enclosed.length <= node.x;
    if ends && !holds_slope && matches!(node.slope, Slope::Free(_)) { 1 } else { 2 }
}

/// `α φ` about the left end of the span, zero if the span is clear; [`None`] if no lift of this shape is enough.
pub(crate) fn lift(enclosed: &EnclosedScene<'_>, span: &Span, parts: &[Curve], ends: Ends<'_>) -> Option<Polynomial> {
    // Each side extends from its node to the middle, or to the free end.
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
        // At the node the clearance and its lower derivatives are zero. This makes it small near the node, also past the end of a short
        // cell.
        Some(side.lift(cells, (0.0, vec![Interval::ZERO; order]))?.0)
    };
    let (left, right) = (lift(0, &cells[..meeting])?, lift(1, &cells[meeting..])?);
    Some(shape(span, powers).times(Interval::exact(left.max(right))))
}

/// The cells on one side of a node, expressed by the distance from the node; each cell is expanded about its nearer end.
struct Side<'a> {
    enclosed: &'a EnclosedScene<'a>,
    /// The deflection of the span, in parts that are known from both ends.
    parts: &'a [Curve],
    node: &'a ContactNode,
    /// `φ` from the node.
    shape: Polynomial,
    /// Whether the cells are to the left of the node.
    from_the_left: bool,
}

/// The result of the cells examined so far from the node: their `α`, and the clearance and its derivatives at their far end. At the node
/// itself these are zero.
type Seen = (f64, Vec<Interval>);

impl Side<'_> {
    /// `v(place + s)` on an interval within one part.
    fn deflection(&self, place: f64, [from, to]: [f64; 2]) -> Option<Polynomial> {
        let part = self.parts.partition_point(|(part, _)| part[1] <= from);
        let &(part, known) = self.parts.get(part).filter(|(part, _)| part[0] <= from && to <= part[1])?;
        let end = usize::from(self.from_the_left);
        Some(known[end].shifted(Interval::length(part[end], place)))
    }

    /// Whether a single comparison of ranges proves that the span is clear of the foundation between two positions.
    fn is_clear(&self, [from, to]: [f64; 2]) -> bool {
        let least = self.enclosed.gap.least(from, to);
        let below = |v: Polynomial| v.range(Interval::length(from, to)).hi() <= least;
        f64::NEG_INFINITY < least && self.deflection(from, [from, to]).is_some_and(below)
    }

    /// Treats neighbouring cells, given from left to right, that follow the cells already seen. Cells that are clear by one comparison
    /// are done together, others by halves.
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
            // A point that stands alone there is not part of any cell.
            let clearance = enclosed.gap.depth(far) - self.deflection(far, *first)?.at(Interval::ZERO);
            let place = [distance + width, Interval::ZERO];
            return Some((enough(&Polynomial::new(&[clearance]), &self.shape, place, most)?, Vec::new()));
        };
        let mut known = vec![clearance.at(width)];
        // At a joint the beam has a kink of its own.
        if !enclosed.is_joint(far) {
            known.push(clearance.derivative().at(width) + kink);
        }
        Some((most, known))
    }
}

/// `φ` about the left end of the span, for the exponents at both ends. With the exponents exchanged it is `φ` as seen from the right
/// end.
fn shape(span: &Span, powers: [usize; 2]) -> Polynomial {
    /// Pascal's triangle, with the signs of `(1 − s)ⁿ`.
    const BINOMIALS: [&[f64]; 3] = [&[1.0], &[1.0, -1.0], &[1.0, -2.0, 1.0]];
    let mut coefficients = vec![Interval::ZERO; powers[0]];
    coefficients.extend(BINOMIALS[powers[1]].iter().copied().map(Interval::exact));
    let length = Interval::length(span.from, span.to);
    Polynomial::new(&coefficients).scaled(Interval::exact(1.0) / length)
}

/// The larger of `most` and the `α` that a cell at a given distance from a node needs. `clearance` and `shape` (`φ` from the node) are
/// both divided by the same power of the distance.
fn enough(clearance: &Polynomial, shape: &Polynomial, [distance, whole]: [Interval; 2], most: f64) -> Option<f64> {
    let mut most = most;
    clearance.negative(whole, |below, [start, width], [is_settled, is_last]| {
        let distance = distance + start;
        // If `φ` may vanish, `least` is zero and there is no finite bound.
        let least = shape.shifted(distance).range(width).lo().max(0.0);
        let enough = (Interval::exact(below) / Interval::exact(least)).hi();
        // Near a node, but not at it, `φ` may be far smaller at one end of a part than at the other.
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
