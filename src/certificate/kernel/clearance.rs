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
use super::load::cells;
use super::polynomial::Polynomial;
use super::span::{Curve, Span};

/// Parts into which a cell is cut before it is given up.
const MOST_PARTS: usize = 200;
/// Penetration is bounded by parts until they are this share of their cell; a longer proof would make the lift less.
const SMALLEST_PART: f64 = 1.0 / 8.0;
/// And until the bound is no more than so many times of what there is at one of their ends.
const MOST_EXCESS: f64 = 2.0;

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
pub(crate) fn lift(enclosed: &EnclosedScene<'_>, span: &Span, parts: &[Curve], ends: Ends<'_>) -> Option<Polynomial> {
    // From each node to the middle, or to the free end.
    let middle = match ends {
        [None, _] => span.from,
        [_, None] => span.to,
        _ => 0.5 * (span.from + span.to),
    };
    let mut breaks = enclosed.gap.breaks(span.from, span.to);
    breaks.push(middle);
    breaks.extend(enclosed.load.breaks(span.from, span.to));
    let cells = cells(span.from, span.to, breaks);
    let meeting = cells.partition_point(|cell| cell[0] < middle);
    let powers = ends.map(|end| power(enclosed, end));
    let [about_left, about_right] = [powers, [powers[1], powers[0]]].map(|powers| shape(span, powers));
    let sides = [0, 1].map(|side| Side { enclosed, parts, from_the_left: side == 1 });
    let left = ends[0].map_or(Some(0.0), |node| sides[0].lift(node, about_left, &cells[..meeting]))?;
    let right = ends[1].map_or(Some(0.0), |node| sides[1].lift(node, about_right, &cells[meeting..]))?;
    Some(about_left.times(Interval::exact(left.max(right))))
}

/// Cells on one side of a node: seen from there, and each about that end of it that is nearer.
struct Side<'a> {
    enclosed: &'a EnclosedScene<'a>,
    /// The span, by parts known from both ends.
    parts: &'a [Curve],
    /// Whether the cells are on the left side of the node.
    from_the_left: bool,
}

impl Side<'_> {
    /// `v(place + s)` between two places of a part.
    fn deflection(&self, place: f64, [from, to]: [f64; 2]) -> Option<Polynomial> {
        let part = self.parts.partition_point(|(part, _)| part[1] <= from);
        let &(part, known) = self.parts.get(part).filter(|(part, _)| part[0] <= from && to <= part[1])?;
        let end = usize::from(self.from_the_left);
        Some(known[end].shifted(Interval::exact(place) - Interval::exact(part[end])))
    }

    /// Whether the span is clear of the foundation between two places, at a glance.
    fn is_clear(&self, [from, to]: [f64; 2]) -> bool {
        let most = self.deflection(from, [from, to]).map(|v| v.range(Interval::exact(to) - Interval::exact(from)).hi());
        most.is_some_and(|most| most <= self.enclosed.gap.least(from, to))
    }

    /// `α` for these cells, from left to right.
    fn lift(&self, node: &ContactNode, shape: Polynomial, cells: &[[f64; 2]]) -> Option<f64> {
        /// Cells that are looked at together, at most, and how many more at once than before.
        const MOST: usize = 4096;
        const MORE: usize = 4;
        let Self { enclosed, from_the_left, .. } = *self;
        let nth = |i: usize| cells[if from_the_left { cells.len() - 1 - i } else { i }];
        let apart = |a: f64, b: f64| Interval::exact(a.max(b)) - Interval::exact(a.min(b));
        let mut most = 0.0;
        let mut order = enclosed.order(node, from_the_left);
        // What vanishes at the node is small beside it, also behind the end of a short cell.
        let mut known = vec![Interval::ZERO; order];
        let (mut i, mut together) = (0, 1);
        while i < cells.len() {
            let count = together.min(cells.len() - i);
            if 1 < count {
                let [first, last] = [nth(i), nth(i + count - 1)];
                if self.is_clear([first[0].min(last[0]), first[1].max(last[1])]) {
                    (i, together) = (i + count, MOST.min(MORE * count));
                    known.clear();
                } else {
                    together = count / MORE;
                }
                continue;
            }
            let cell = nth(i);
            let [near, far] = if from_the_left { [cell[1], cell[0]] } else { cell };
            let (width, distance) = (apart(near, far), apart(near, node.x));
            let clearance = enclosed.gap.about(near, cell).minus(&self.deflection(near, cell)?);
            let clearance = if from_the_left { clearance.mirrored() } else { clearance }.known(&known);
            let [quotient, shape] = [clearance, shape].map(|of| of.divided(order));
            let part = Part { clearance: quotient, shape, width, distance, whole: width.hi() };
            most = part.lift(most, &mut MOST_PARTS.clone())?;
            order = 0;
            known.clear();
            if let Some(kink) = enclosed.gap.kink(far) {
                known.extend([clearance.at(width), clearance.derivative().at(width) + kink]);
            }
            (i, together) = (i + 1, MORE);
        }
        Some(most)
    }
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
        let deepest = self.clearance.at(Interval::ZERO).hi().min(self.clearance.at(self.width).hi());
        let inside = lowest >= MOST_EXCESS * deepest;
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
