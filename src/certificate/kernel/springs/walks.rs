//! Short pressed stretches of a beam on an elastic foundation. Only one of their ends is given, and the pair is continued to the other
//! end.
//!
//! A cubic through given values at both ends divides the rounding of these values by the square of the width `w`. Over a stretch far
//! shorter than `(4 EI/k)^¼` this would be the largest part of the gap. With the given polynomial `t` and `c = ∬(k t − q)`, use instead
//!
//! ```text
//! δ(s) = δ(0) + a s,    a = w'(0) − t'(0),       hence    w(w) = w(0) + (t(w) − t(0)) + a w,      w'(w) = t'(w) + a
//! r(s) = M(0) + b s,    b = V(0) − c'(0),        hence    M(w) = M(0) + (c(w) − c(0)) + b w,      V(w) = c'(w) + b
//! ```
//!
//! from the left end to the right one, or the mirror image. The numbers at the far end are enclosed, and the next stretch starts with
//! them. The shear force at an end may instead follow from a part that hangs next to it, or from a support. Then `r` is the cubic with
//! the shear forces of both ends and the mean slope `b`. It has the same `M(w)`, and its second derivative is a difference of shear
//! forces over `w`, not of moments over `w²`.
//!
//! *Proof that the result is still a pair.* A pair needs that `v̂` and `v̂'` are continuous and satisfy the supports, and that `M` is in
//! equilibrium. So both sides of a node must use the same numbers. Which numbers these are does not matter, whatever the candidate
//! contact list contains. Each enclosure represents one number, the one that the exact continuation has there, and all stretches next to
//! the node read the same entry. A node is reached at most once, and never if its number is prescribed: by a support for `v̂`; for `M`
//! by a hinged or free end of the beam and by statics at the inner end of an overhang; for `V` by a support, by statics where a part
//! hangs, and at the ends of the beam. A cubic has the value `M(w)` at its far end for any `b`, since its mean slope is its rise over
//! its width.

use super::OnSprings;
use crate::certificate::kernel::contact_node::EnclosedSupport;
use crate::certificate::kernel::interval::Interval;
use crate::certificate::kernel::polynomial::Polynomial;
use crate::certificate::kernel::span::Span;

/// A pressed stretch is continued from one end if it is shorter than this share of `(4 EI/k)^¼`. *Tuned* on nearly coincident features;
/// the bounds are true for any value.
const SHORT: f64 = 1.0 / 1024.0;

/// The end towards which a stretch is continued.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Towards {
    Left,
    Right,
}

/// The continuation along a short stretch, by a polynomial and a line.
#[derive(Debug, Clone, Copy)]
pub(super) struct Walk {
    /// The slope of the line.
    pub(super) slope: Interval,
    /// The rise of both together from the left end to the right one.
    rise: Interval,
    /// Whether only the line is used: the slope at the far end is not given either.
    pub(super) is_all: bool,
}

impl Walk {
    /// The continuation for a given slope of polynomial and line together at the start.
    fn along(polynomial: &Polynomial, slope: Interval, towards: Towards, width: Interval) -> Self {
        let start = if towards == Towards::Right { Interval::ZERO } else { width };
        let slope = slope - polynomial.derivative().at(start);
        // The constant term is common to both ends.
        Self { slope, rise: (polynomial.divided(1).at(width) + slope) * width, is_all: true }
    }
}

/// `w` and `w'` at a node that was reached along a short stretch; the flag is true if the stretch is on the left side of the node.
pub(super) type Reached = (bool, [Interval; 2]);

impl OnSprings<'_> {
    /// The stretches that are continued, in order. In each run of short stretches the first node at which the number is known is the
    /// start for all of them; if there is none, the left end of the run.
    fn walks(&self, is_known: impl Fn(usize) -> bool) -> Vec<(usize, Towards)> {
        // Under an axial force errors grow over the length `√(EI/N)`.
        let pulled = (self.enclosed.stiffness / self.enclosed.tension.abs()).sqrt();
        let is_short = |i: &usize| {
            let width = self.stretches[*i].to - self.stretches[*i].from;
            self.is_pressed(*i, false) && width <= SHORT * self.length(*i).lo().min(pulled)
        };
        let (mut walks, mut from) = (Vec::new(), 0);
        while from < self.stretches.len() {
            let to = (from..self.stretches.len()).find(|i| !is_short(i)).unwrap_or(self.stretches.len());
            let start = (from..=to).find(|node| is_known(*node)).unwrap_or(from);
            walks.extend((from..start).rev().map(|i| (i, Towards::Left)));
            walks.extend((start..to).filter(|i| !is_known(i + 1)).map(|i| (i, Towards::Right)));
            from = to + 1;
        }
        walks
    }

    /// Whether a support prescribes `v̂` at a node, or a joint lets its slope jump.
    fn is_held_or_turns(&self, node: usize) -> bool {
        self.enclosed.support(self.x(node)).is_some() || self.enclosed.joint(self.x(node)).is_some()
    }

    /// Continues `v̂` along short stretches.
    pub(super) fn walk(&mut self) -> Vec<Option<Walk>> {
        self.reached = vec![None; self.stretches.len() + 1];
        let mut walked = vec![None; self.stretches.len()];
        for (i, towards) in self.walks(|node| self.is_held_or_turns(node)) {
            let (start, to_the_right) = (i + usize::from(towards == Towards::Left), towards == Towards::Right);
            let (width, t) = self.polynomial(i);
            let Some([w, slope]) = self.sunk(start, !to_the_right) else { continue };
            let walk = Walk::along(&t, slope, towards, width);
            let there = walk.slope + t.derivative().at(if to_the_right { width } else { Interval::ZERO });
            let far = if to_the_right { w + walk.rise } else { w - walk.rise };
            self.reached[if to_the_right { i + 1 } else { i }] = Some((to_the_right, [far, there]));
            walked[i] = Some(walk);
        }
        walked
    }

    /// The same for `M` and `V`, including the moments on both sides of the nodes reached.
    pub(super) fn walk_moments(&mut self, spans: &[Option<Span>], moments: &mut [[Interval; 2]]) -> Vec<Option<Walk>> {
        let is_built_in =
            |on: &Self, node: usize| on.enclosed.support(on.x(node)).is_some_and(EnclosedSupport::holds_slope);
        let is_known = |node: usize| {
            let is_end = node == 0 || node == spans.len();
            let overhangs = || [true, false].into_iter().any(|left| self.overhanging(spans, node, left).is_some());
            let is_hinge = self.enclosed.joint(self.x(node)) == Some(0.0);
            is_end && !is_built_in(self, node) || is_hinge || overhangs()
        };
        let walks = self.walks(is_known);
        self.sheared = vec![None; spans.len() + 1];
        let mut walked = vec![None; spans.len()];
        for (i, towards) in walks {
            let to_the_right = towards == Towards::Right;
            let (start, node) = if to_the_right { (i, i + 1) } else { (i + 1, i) };
            let ((width, t), load) = (self.polynomial(i), |node: usize| self.enclosed.load.point(self.x(node)));
            let is_free = |node: usize| self.enclosed.support(self.x(node)).is_none();
            let own = match self.sheared[start] {
                Some([left, right]) => Some(if to_the_right { right } else { left }),
                // The same rule as in `shears`.
                None if is_free(start) && start == i + 1 && start < spans.len() => {
                    self.said(start, false, 3).map(|v| v + load(start))
                }
                None => self.said(start, !to_the_right, 3),
            };
            let Some(shear) = own else { continue };
            let caused = self.caused(i, &t);
            let mut walk = Walk::along(&caused, shear, towards, width);
            walk.is_all = is_free(node)
                && self.is_pressed(node, !to_the_right)
                && (!is_free(start) || self.is_pressed(start, to_the_right));
            if walk.is_all {
                let there = walk.slope + caused.derivative().at(if to_the_right { width } else { Interval::ZERO });
                let both = if to_the_right { [there, there - load(node)] } else { [there + load(node), there] };
                self.sheared[node] = Some(both);
            }
            let side = usize::from(!to_the_right);
            let rise = walk.rise - self.pulled(i);
            let moment = if to_the_right { moments[i][1] + rise } else { moments[i + 1][0] - rise };
            // At a built-in support the moment on the other side may be different.
            if is_built_in(self, node) {
                moments[node][side] = moment;
            } else {
                let couple = self.enclosed.load.couple(self.x(node));
                moments[node] = if to_the_right { [moment, moment + couple] } else { [moment - couple, moment] };
            }
            walked[i] = Some(walk);
        }
        walked
    }
}
