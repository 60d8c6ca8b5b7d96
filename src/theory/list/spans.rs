//! The spans between the nodes of a list, from left to right.
//!
//! Beyond the outermost node on a side the beam overhangs, or is supported by springs. In the latter case it is a chain of spans up to
//! the outermost spring ([`divided`]), and beyond that it follows from statics. A beam without nodes is such a chain from end to end.

use super::super::divided::{self, Parts};
use super::super::piecewise::PiecewiseScene;
use super::super::span::{End, Span};
use super::{List, Node};

impl List {
    /// The spans and overhangs from left to right, each with the number of nodes to its left; a divided span is given by its parts.
    pub(in crate::theory) fn spans(&self, given: &PiecewiseScene) -> Vec<(usize, Span)> {
        let mut spans = Vec::with_capacity(self.nodes.len() + 1);
        self.each_span(given, |i, span| spans.push((i, *span)));
        spans
    }

    /// Visits the same spans one by one: a list may have hundreds of thousands.
    pub(in crate::theory) fn each_span(&self, given: &PiecewiseScene, mut visit: impl FnMut(usize, &Span)) {
        let n = self.nodes.len();
        if let Some(parts) = self.outer(given, true) {
            parts.iter().for_each(|span| visit(0, span));
        }
        for i in (1..n).filter(|&i| !self.in_zone_before(i)) {
            self.span(given, i).iter().for_each(|span| visit(i, span));
        }
        if let Some(parts) = self.outer(given, false).filter(|_| 0 < n) {
            parts.iter().for_each(|span| visit(n, span));
        }
    }

    /// On which sides of node `i` the beam has no further support, so that statics determines the moment at the node.
    pub(super) fn overhangs(&self, given: &PiecewiseScene, i: usize) -> [bool; 2] {
        let x = self.nodes[i].x;
        let beyond = |outermost: bool, at_left| outermost && given.spring_beyond(x, at_left).is_none();
        [beyond(i == 0, true), beyond(i + 1 == self.nodes.len(), false)]
    }

    /// The part of the beam beyond the outermost node on a side; the whole beam if it has no nodes.
    fn outer(&self, given: &PiecewiseScene, at_left: bool) -> Option<Parts> {
        let Some(node) = (if at_left { self.nodes.first() } else { self.nodes.last() }) else {
            return given.acting().next().map(|_| match given.tension == 0.0 {
                true => Parts::of(divided::on_springs(given, [None; 2], 0.0)),
                false => divided::parts(given, [true, false].map(|left| End::free_of(given, left)), 0.0),
            });
        };
        // Under an axial force an overhang is a span as well, including its springs.
        if given.tension == 0.0 && given.spring_beyond(node.x, at_left).is_some() {
            return Some(self.sprung(given, at_left));
        }
        let is_inside = if at_left { 0.0 < node.x } else { node.x < given.length };
        is_inside.then(|| self.overhang(given, node, at_left))
    }

    /// The beam beyond the outermost node on a side, up to the outermost spring and beyond it.
    fn sprung(&self, given: &PiecewiseScene, at_left: bool) -> Parts {
        let i = if at_left { 0 } else { self.nodes.len() - 1 };
        let (node, [right, left]) = (&self.nodes[i], self.nodes[i].cells(given));
        let mut end = node.span_end(given, if at_left { left } else { right });
        if self.overhangs(given, i)[usize::from(at_left)] {
            node.hinge(given, &mut end, !at_left);
        }
        Parts::of(match at_left {
            true => divided::on_springs(given, [None, Some(end)], node.joint(given)),
            false => divided::on_springs(given, [Some(end), None], 0.0),
        })
    }

    /// The overhang beyond the outermost node on a side.
    fn overhang(&self, given: &PiecewiseScene, node: &Node, at_left: bool) -> Parts {
        let [right, left] = node.cells(given);
        let cell = if at_left { left } else { right };
        // If the node leaves the slope free, the slope is the end slope of the neighbouring span.
        let beside = || {
            let i = if at_left { 1 } else { self.nodes.len() - 1 };
            let joint = node.joint(given);
            let turned = |bent: f64| if joint == 0.0 { 0.0 } else { joint * bent };
            let parts = match (0 < i && i < self.nodes.len()).then(|| self.in_zone_before(i)) {
                Some(true) => None,
                Some(false) => Some(self.span(given, i)),
                None => given.spring_beyond(node.x, !at_left).map(|_| self.sprung(given, !at_left)),
            };
            parts.map(|parts| match at_left {
                true => parts.first.beam_a[1] - turned(parts.first.beam_a[2] - node.couple(given)),
                false => parts.last().beam_b[1] + turned(parts.last().beam_b[2]),
            })
        };
        if given.tension != 0.0 {
            let (mut held, free) = (node.span_end(given, cell), End::free_of(given, at_left));
            node.hinge(given, &mut held, !at_left);
            let (ends, joint) = if at_left { ([free, held], node.joint(given)) } else { ([held, free], 0.0) };
            return divided::parts(given, ends, joint);
        }
        let slope = node.held_slope(given).or_else(beside).unwrap_or(node.free_slope()[0]);
        let held = node.span_end(given, cell);
        let divisions =
            if at_left { given.divisions_between(0.0, node.x) } else { given.divisions_between(node.x, given.length) };
        if divisions.is_empty() {
            return Parts::one(Span::overhang(given, held, slope, at_left));
        }
        Parts::of(divided::overhang(given, held, slope, at_left))
    }

    /// The span between node `i − 1` and node `i`.
    fn span(&self, given: &PiecewiseScene, i: usize) -> Parts {
        let (left, right) = (&self.nodes[i - 1], &self.nodes[i]);
        let ([from, _], [_, to]) = (left.cells(given), right.cells(given));
        let (mut a, mut b): (End, End) = (left.span_end(given, from), right.span_end(given, to));
        if self.overhangs(given, i - 1)[0] {
            left.hinge(given, &mut a, true);
        }
        if self.overhangs(given, i)[1] {
            right.hinge(given, &mut b, false);
        }
        divided::parts(given, [a, b], right.joint(given))
    }
}
