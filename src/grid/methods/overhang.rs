//! Overhangs beyond the outermost nodes that hold a beam: their loads by statics, and their deflections from the slope at the root.

use super::Discrete;
use super::discrete::as_float;
use super::divisions::LOOSE;
use super::held_beam::{Beam, Stretch};
use super::span::Span;

/// The resultant of an overhang at its root: the sum of its loads, and their moment, negative where they bend the overhang down.
#[derive(Debug, Clone, Copy)]
pub(super) struct Overhang {
    pub(super) force: f64,
    pub(super) moment: f64,
}

impl Overhang {
    /// The overhang on the span between tip and root. `side` is the side of the tip, and `tip` the load on it.
    pub(super) fn of(span: Span, side: usize, tip: f64) -> Self {
        let at_tip = span.shares[side] + tip;
        Self { force: at_tip + span.shares[1 - side], moment: -at_tip * span.steps }
    }
}

impl<S: Fn(usize, usize) -> Span> Beam<'_, S> {
    /// The stretches of the overhang on one side between nodes where the beam changes, from the root to the tip. Empty without an
    /// overhang.
    pub(super) fn overhang(&self, side: usize) -> Vec<Stretch> {
        let Discrete { stiffness, spacing, loads, .. } = self.discrete;
        let Some(Overhang { moment, .. }) = self.overhangs[side] else { return Vec::new() };
        let end = self.nodes.len() - 1;
        let list = if side == 0 { [0, 1] } else { [end, end - 1] };
        // With a rotational spring the slope is that of the inner span, or of the spring if there is no inner span.
        let held = self.discrete.supports().at(self.nodes[list[0]]).and_then(|support| support.held.slope);
        let list = match (self.nodes[list[0]] == self.nodes[list[1]] && held.is_none(), side) {
            (true, 0) if 2 < self.nodes.len() => [1, 2],
            (true, 1) if 2 < self.nodes.len() => [end - 1, end - 2],
            _ => list,
        };
        let ([here, next], [own_moment, next_moment]) = (list.map(|i| self.nodes[i]), list.map(|i| self.moments[i]));
        let [level, next_level] = list.map(|i| self.level(i));
        let unit = 6.0 * stiffness / (spacing * spacing);
        // Slopes count in the direction away from the tip.
        let mut slope = if here == next {
            let turning = || self.discrete.supports().turning(here);
            let jump = (self.moments[list[0].max(list[1])] - self.moments[list[0].min(list[1])]) * spacing;
            let slope = held.or_else(|| turning().map(|[k, slope]| slope - jump / k)).unwrap_or(0.0);
            if side == 0 { slope } else { -slope }
        } else {
            let inner = (self.span)(here.min(next), here.max(next));
            let [own, beside] = inner.end_rotations(self.discretisation);
            (next_level - level) / (spacing * as_float(here.abs_diff(next)))
                + (own * own_moment + beside * next_moment + inner.rotations[side]) / unit
        };
        let tip = if side == 0 { 0 } else { self.discrete.intervals };
        let mut stretches = Vec::with_capacity(1 + self.beyond[side].len());
        let mut root = (here, moment, level);
        for &node in self.beyond[side].iter().chain([&tip]) {
            slope += 6.0 * self.discrete.divisions().joint(root.0).min(LOOSE) * root.1 / unit;
            let span = (self.span)(root.0.min(node), root.0.max(node));
            let beyond = if node == tip {
                0.0
            } else {
                Overhang::of((self.span)(node.min(tip), node.max(tip)), side, loads[tip]).moment
            };
            let [own, beside] = span.end_rotations(self.discretisation);
            let chord = slope + (own * root.1 + beside * beyond + span.rotations[1 - side]) / unit;
            let drop = chord * spacing * span.steps;
            let far = (node, beyond, root.2 - drop);
            let [left, right] = if side == 0 { [far, root] } else { [root, far] };
            stretches.push(Stretch {
                nodes: [left.0, right.0],
                moments: [left.1, right.1],
                levels: [left.2, right.2],
                lever: drop.abs() + stretches.last().map_or(0.0, |before: &Stretch| before.lever),
            });
            slope = chord + (own * beyond + beside * root.1 + span.rotations[side]) / unit;
            root = far;
        }
        stretches
    }
}
