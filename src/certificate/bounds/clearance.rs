//! How far a span has to be lifted to be clear of the foundation: mostly not at all.
//!
//! The span is lifted by `α φ`, which vanishes at its joints and, where the slope is given, with its slope:
//!
//! ```text
//! φ(s) = (s/L)^a (1 − s/L)^b,     a, b = 1 at a support, 2 at all other joints
//! ```
//!
//! so that what it costs is of the size of `α`, and not of its root: where the beam is pressed it stays where it is. `α = 0`
//! proves `v ≤ u`. Where beam and foundation are one curve but for rounding, no arithmetic can tell, and `α` is of the size
//! of the rounding.

use super::joints::{Joint, Kind, Setting};
use super::polynomial::Polynomial;
use super::span::Span;
use crate::certificate::interval::Interval;

/// Parts into which a cell is cut before it is given up.
const MOST_PARTS: usize = 100;
/// Penetration is bounded by parts until they are this share of their cell; a longer proof would make the lift less.
const SMALLEST_PART: f64 = 1.0 / 8.0;

/// The power of the distance from a joint in `φ`.
pub(super) fn power(joint: &Joint) -> usize {
    if joint.kind == Kind::Support { 1 } else { 2 }
}

/// `α`, not negative; [`None`] if no lift of this shape is enough.
pub(super) fn lift(setting: &Setting<'_>, span: &Span, left: &Joint, right: &Joint) -> Option<f64> {
    let smooth = |j: &Joint| j.kind.is_hinge() || setting.ground.is_smooth_at(j.x);
    if !smooth(left) || !smooth(right) {
        return None;
    }
    let mut breaks = setting.ground.breaks(span.from, span.to);
    breaks.push(0.5 * (span.from + span.to));
    let curve = span.curve(breaks, setting.load, setting.stiffness);
    let last = curve.len() - 1;
    let length = Interval::exact(span.to) - Interval::exact(span.from);
    let mut most = 0.0_f64;
    for (k, ([from, to], v)) in curve.iter().enumerate() {
        let (from, to) = (*from, *to);
        let width = Interval::exact(to) - Interval::exact(from);
        let (clearance, shape, distance) = if k == last {
            let v = span.mirrored(from, setting.load, setting.stiffness);
            let order = order(setting, right, true);
            let h = setting.ground.mirrored_cell(from, to).minus(&v).divided(order);
            (h, Shape { length, order, own: power(right), other: power(left) }, Interval::ZERO)
        } else {
            let order = if k == 0 { order(setting, left, false) } else { 0 };
            let h = setting.ground.cell(from, to).minus(v).divided(order);
            let shape = Shape { length, order, own: power(left), other: power(right) };
            (h, shape, Interval::exact(from) - Interval::exact(span.from))
        };
        let part = Part { clearance, width, distance, whole: width.hi() };
        most = most.max(part.lift(&shape, &mut MOST_PARTS.clone())?);
    }
    most.is_finite().then_some(most)
}

/// `φ` about the left end of the span.
pub(super) fn shape(span: &Span, left: &Joint, right: &Joint) -> Polynomial {
    let per = Interval::exact(1.0) / (Interval::exact(span.to) - Interval::exact(span.from));
    let binomial: &[f64] = if power(right) == 1 { &[1.0, -1.0] } else { &[1.0, -2.0, 1.0] };
    let mut factor = per;
    if power(left) == 2 {
        factor = factor * per;
    }
    let mut coefficients = vec![Interval::ZERO; power(left)];
    for &c in binomial {
        coefficients.push(Interval::exact(c) * factor);
        factor = factor * per;
    }
    Polynomial::new(&coefficients)
}

/// Which power of the distance from a joint is a factor of the clearance beside it.
fn order(setting: &Setting<'_>, joint: &Joint, from_the_left: bool) -> usize {
    let touches =
        setting.ground.side(joint.x, from_the_left).is_none_or(|u| (u - setting.end(joint)[0].middle()).abs() <= 0.0);
    match joint.kind {
        Kind::Support => usize::from(setting.ground.depth(joint.x).magnitude() <= 0.0),
        Kind::Corner => usize::from(touches),
        Kind::Clamp | Kind::Touch | Kind::Start | Kind::End => 2,
    }
}

/// `φ` over the power `order` of the distance from one of its joints.
struct Shape {
    length: Interval,
    order: usize,
    own: usize,
    other: usize,
}

impl Shape {
    /// The least value between two distances from the joint.
    fn least(&self, near: Interval, far: Interval) -> f64 {
        let per = Interval::exact(1.0) / self.length;
        let mut product = Interval::exact(1.0);
        for _ in 0..self.own {
            product = product * per;
        }
        for _ in self.order..self.own {
            product = product * near;
        }
        let rest = (self.length - far) * per;
        for _ in 0..self.other {
            product = product * rest;
        }
        if rest.lo() <= 0.0 { 0.0 } else { product.lo().max(0.0) }
    }
}

/// A part of a cell, with the clearance over a power of the distance.
struct Part {
    clearance: Polynomial,
    width: Interval,
    distance: Interval,
    /// Width of the cell.
    whole: f64,
}

impl Part {
    fn lift(&self, shape: &Shape, parts: &mut usize) -> Option<f64> {
        let lowest = self.clearance.range(self.width).lo();
        if 0.0 <= lowest {
            return Some(0.0);
        }
        let least = shape.least(self.distance, self.distance + self.width);
        let enough = (Interval::exact(-lowest) / Interval::exact(least)).hi();
        *parts = parts.saturating_sub(1);
        let is_rounding = -lowest <= 4.0 * self.clearance.uncertainty(self.width.hi());
        let inside = self.clearance.at(Interval::ZERO).hi() < 0.0 || self.clearance.at(self.width).hi() < 0.0;
        let is_small = self.width.hi() <= SMALLEST_PART * self.whole;
        if enough.is_finite() && (is_rounding || (inside && is_small) || *parts == 0) {
            return Some(enough);
        }
        if *parts == 0 {
            return None;
        }
        // Halves of the upper bound of the width: they overlap by rounding and leave nothing out.
        let half = Interval::exact(0.5 * self.width.hi());
        let first = Self { clearance: self.clearance, width: half, ..*self };
        let second = Self { clearance: self.clearance.shifted(half), distance: self.distance + half, ..first };
        Some(first.lift(shape, parts)?.max(second.lift(shape, parts)?))
    }
}

#[cfg(test)]
mod tests;
