//! The next list when a contact list fails its check: each fault has its repair.
//!
//! A point in tension is removed. A point at which the beam bends more than the profile becomes a zone. Where the beam penetrates the
//! profile deepest, a contact is added. Contacts that cannot be separate are joined to one zone ([`super::normal::normal_form`]). What is in
//! tension inside a zone or at a support is left to the next guess of the chain.

use super::check::Check;
use super::list::{List, Node};
use super::normal::{edge_node, normal_form};
use super::piecewise::PiecewiseScene;
use super::pull::zones_between;
use super::sensitivity::{ends, part_at, parts_before};
use super::span::{EndCondition, Span};
use super::violation::Violation;
use crate::certificate::Slope;

/// The list with those faults repaired that have a repair.
pub(super) fn repaired(given: &PiecewiseScene, list: &List, checked: &Check, faults: &[(usize, Violation)]) -> List {
    let mut repair = Repair { given, list, checked, keep: vec![true; list.nodes.len()], added: Vec::new() };
    let found = Found::of(faults, list.nodes.len());
    for &(i, fault) in faults {
        match fault {
            Violation::Inverted { .. } => repair.inverted(i),
            Violation::Broken { at } => repair.broken(at),
            Violation::PullAlong { .. } => repair.pull_along(i),
            Violation::Penetration { depth, .. } if depth < found.depths[i] && is_divided(checked, i) => {}
            Violation::Pull { .. } => repair.pull(i),
            Violation::CurvatureGap { .. } => repair.curvature_gap(i),
            Violation::Unresolved { .. } if !found.is_inverted_beside(i) => repair.unresolved(i),
            Violation::Jump { .. } => repair.lift_tip(i),
            Violation::Penetration { at, .. } => repair.penetration(i, at),
            _ => {}
        }
    }
    let Repair { keep, added, .. } = repair;
    let kept = |(i, node): (usize, &Node)| {
        // If the start of a zone was removed, its end at a support no longer fixes the slope.
        let lost = list.in_zone_before(i) && !keep[i - 1] && node.slope == (Slope::OfGround { from_the_left: true });
        let slope = if lost { Slope::Free(0.0) } else { node.slope };
        match node.support(given) {
            Some(_) => Some(Node { slope, ..*node }),
            None => keep[i].then_some(*node),
        }
    };
    let mut nodes: Vec<Node> = list.nodes.iter().enumerate().filter_map(kept).chain(added).collect();
    nodes.sort_by(|a, b| a.x.total_cmp(&b.x));
    normal_form(given, &nodes)
}

/// Whether the span before node `i` is divided: each of its parts has a deepest position, and the deepest of all becomes a contact
/// first.
fn is_divided(checked: &Check, i: usize) -> bool {
    1 < parts_before(&checked.spans, i).len()
}

/// Faults at other nodes that a repair needs to know; a list may have hundreds of thousands.
struct Found {
    /// Whether a zone would end before it starts, indexed by its first node.
    inverted: Vec<bool>,
    /// The deepest penetration in the span before each node.
    depths: Vec<f64>,
}

impl Found {
    /// Collects the faults of a list with this number of nodes.
    fn of(faults: &[(usize, Violation)], nodes: usize) -> Self {
        let mut found = Self { inverted: vec![false; nodes + 1], depths: vec![0.0; nodes + 1] };
        for &(i, fault) in faults {
            match fault {
                Violation::Inverted { .. } => found.inverted[i] = true,
                Violation::Penetration { depth, .. } => found.depths[i] = found.depths[i].max(depth),
                _ => {}
            }
        }
        found
    }

    /// Whether a zone next to the span before node `i` would end before it starts.
    fn is_inverted_beside(&self, i: usize) -> bool {
        self.inverted[i.saturating_sub(2)..=i].contains(&true)
    }
}

/// A list and its changes.
struct Repair<'a> {
    given: &'a PiecewiseScene,
    list: &'a List,
    checked: &'a Check,
    /// Whether each node is kept; supports always are.
    keep: Vec<bool>,
    /// Added nodes, in any order.
    added: Vec<Node>,
}

impl Repair<'_> {
    /// Removes a point in tension. The end of a zone moves by itself after other changes.
    fn pull(&mut self, i: usize) {
        if self.list.nodes[i].is_tip(self.given) {
            self.lift_tip(i);
        } else if !self.list.nodes[i].is_of_zone() {
            self.keep[i] = false;
        }
    }

    /// Replaces a zone that would end before it starts by a point between.
    fn inverted(&mut self, i: usize) {
        let [start, end] = [self.list.nodes[i], self.list.nodes[i + 1]];
        (self.keep[i], self.keep[i + 1]) = (false, false);
        let (from, to) = self.given.reach(start.cell);
        let place = 0.5 * (start.x + end.x);
        if end.ends_zone() && from < place && place < to {
            self.added.push(Node::touch(place, self.given.cell_from(place)));
        }
    }

    /// Adds gaps to a zone around its stretches in tension.
    fn pull_along(&mut self, i: usize) {
        let Some([start, end]) = self.list.nodes.get(i - 1..=i) else { return };
        let parts = zones_between(self.given, [start.x, end.x]);
        let is_new = |node: &&Node| self.added.iter().all(|added| added.x.total_cmp(&node.x).is_ne());
        let gaps = parts.get(1..parts.len().saturating_sub(1)).unwrap_or_default();
        let gaps: Vec<Node> = gaps.iter().filter(is_new).copied().collect();
        self.added.extend(gaps);
    }

    /// Adds a gap to a zone over a joint above a crest, where the beam lifts off. In a hollow the joint touches, and the chain finds it.
    fn broken(&mut self, at: f64) {
        let given = self.given;
        let Some(joint) = given.breakpoint_at(at).filter(|&joint| given.breakpoints[joint].is_jointed()) else {
            return;
        };
        let Some(gap) = gap_at(given, joint) else { return };
        self.added.push(Node::end(at - gap, given.cell_to(at)));
        self.added.push(Node::start(at + gap, given.cell_from(at)));
    }

    /// Replaces a point by a zone, because the profile bulges into the beam on both sides, unless the zone would be in tension.
    fn curvature_gap(&mut self, i: usize) {
        let Node { x, cell, .. } = self.list.nodes[i];
        if let Some(index) = self.list.nodes[i].support(self.given) {
            return self.bulge_at_support(i, index);
        }
        if !self.keep[i] || self.given.pulling_between(x, x).next().is_some() {
            return;
        }
        self.keep[i] = false;
        let nodes = &self.list.nodes;
        let ([lo, hi], (from, to)) = (self.given.next_pulling(x), self.given.reach(cell));
        let (lo, hi) = (lo.max(from), hi.min(to));
        let left = i.checked_sub(1).map_or(lo, |i| nodes[i].x.max(lo));
        let right = nodes.get(i + 1).map_or(hi, |n| n.x.min(hi));
        let half = 0.3 * (x - left).min(right - x);
        self.added.push(Node::start(x - half, cell));
        self.added.push(Node::end(x + half, cell));
    }

    /// Adds a zone next to a support, because the profile bulges into the beam there, or a point where a zone would be in tension. Next
    /// to the support the clearance is `h'' t²/2 + h''' t³/6`.
    fn bulge_at_support(&mut self, i: usize, index: usize) {
        // Both sides are treated at once and only once: supports are kept in any case.
        if !std::mem::take(&mut self.keep[i]) {
            return;
        }
        let given = self.given;
        let x = self.list.nodes[i].x;
        for (right, outwards) in [(i, -1.0), (i + 1, 1.0)] {
            let Some(span) = ends(&self.checked.spans, i)[right - i] else { continue };
            let (side, at) = if right == i { (0, &span.at_b) } else { (1, &span.at_a) };
            if !given.supports[index].tangent[side] || 0.0 <= at[2] {
                continue;
            }
            let turns = -at[2] / (outwards * at[3]);
            let most = 0.3 * span.length();
            let reach = if 0.0 < turns { turns.min(most) } else { most };
            let place = x + outwards * reach;
            let cell = given.cell_from(place);
            if given.pulling_between(x.min(place), x.max(place)).next().is_some() {
                self.added.push(Node::touch(x + 2.0 * outwards * reach, cell));
            } else if side == 0 {
                self.added.push(Node::start(place, cell));
            } else {
                self.added.push(Node::start(x, cell));
                self.added.push(Node::end(place, cell));
            }
        }
    }

    /// Removes an edge that a zone reaches as closely as can be resolved: the zone carries its force.
    fn unresolved(&mut self, i: usize) {
        let nodes = &self.list.nodes;
        let beside = [i.checked_sub(1), (i < nodes.len()).then_some(i)];
        if beside.iter().flatten().any(|&node| nodes[node].is_of_zone()) {
            for node in beside.into_iter().flatten().filter(|&node| nodes[node].is_edge(self.given)) {
                self.keep[node] = false;
            }
            // A zone may begin or end with a hinge on a straight foundation: the beam rotates there without a moment.
            let zone = beside.into_iter().flatten().find(|&node| nodes[node].is_of_zone());
            let edge = beside.into_iter().flatten().find(|&node| nodes[node].is_edge(self.given));
            let hinge = edge.and_then(|edge| nodes[edge].breakpoint).filter(|&i| self.given.is_hinge_on_a_line(i));
            if let (Some(zone), Some(hinge)) = (zone, hinge) {
                self.keep[zone] = false;
                self.added.push(Node::hinge_of_zone(self.given, hinge, nodes[zone].starts_zone()));
            }
        }
    }

    /// Lets a zone lift off before it reaches a free end, if it is in tension there, the foundation is curved or a couple acts. The end
    /// of the beam touches in addition in a hollow, whose curvature is opposite to the overhang, and where a couple bends it more than
    /// the foundation.
    fn lift_tip(&mut self, i: usize) {
        let (given, nodes) = (self.given, &self.list.nodes);
        let Some(&tip) = nodes.get(i).filter(|node| node.is_tip(given)) else { return };
        let left = tip.lies;
        let far = if left { nodes.get(i + 1) } else { i.checked_sub(1).map(|i| &nodes[i]) };
        let place = tip.x + 0.25 * far.map_or(0.0, |far| far.x - tip.x);
        self.keep[i] = false;
        let cell = given.cell_from(place);
        self.added.push(if left { Node::start(place, cell) } else { Node::end(place, cell) });
        let bent = if left { tip.couple(given) } else { -tip.couple(given) };
        if given.bent(tip.cell, tip.x, 2) < bent {
            self.added.extend(tip.breakpoint.map(|at| edge_node(given, at)));
        }
    }

    /// Adds a contact where the beam penetrates the foundation in the span before node `i`, deepest at `at`.
    fn penetration(&mut self, i: usize, at: f64) {
        let last = || parts_before(&self.checked.spans, i).last().map(|(_, span)| span);
        let Some(span) = part_at(&self.checked.spans, i, at).or_else(last) else { return };
        if let Some(breakpoint) = edge_at(self.given, span, at) {
            self.added.push(edge_node(self.given, breakpoint));
            return;
        }
        // If the beam leaves a neighbouring edge on the wrong side, it touches the slope there instead.
        let neighbours = [(i.checked_sub(1), span.a.x, span.at_a[1]), (Some(i), span.b.x, -span.at_b[1])];
        let joins = |node: &Node| node.breakpoint.is_some_and(|at| self.given.breakpoints[at].is_jointed());
        let is_edge = |node: &Node| node.is_edge(self.given) && node.is_ground(self.given) && !joins(node);
        for (node, x, turn) in neighbours {
            if let Some(node) = node.filter(|&node| self.list.nodes.get(node).is_some_and(is_edge))
                && (at - x).abs() < 0.5 * span.length()
                && turn < 0.0
            {
                self.keep[node] = false;
            }
        }
        self.added.push(Node::touch(at, self.given.cell_from(at)));
    }
}

/// Slightly more than half of the gap that a joint causes where a beam follows a crest under a pressure `p`; [`None`] in a hollow. With
/// `n = e g''` the joint rotates by `θ = w (n − p ℓ²/2)`, and
///
/// ```text
/// e θ = 2 p ℓ³/3
/// ```
///
/// For a stiff joint the first term of `θ` dominates; for a hinge the bracket vanishes. `ℓ` is less than either limit.
fn gap_at(given: &PiecewiseScene, joint: usize) -> Option<f64> {
    /// Factor by which the gap is longer.
    const MORE: f64 = 1.05;
    let x = given.breakpoints[joint].x;
    let [_, cell] = given.cells_beside(joint);
    let (bent, pressure, e) = (given.bent(cell, x, 2), -given.drive(cell, x), given.cells[cell].stiffness);
    let of_stiff = libm::cbrt(1.5 * (e * given.breakpoints[joint].joint * bent) / pressure);
    let gap = MORE * of_stiff.min((2.0 * bent / pressure).sqrt());
    (0.0 < bent && 0.0 < gap && gap.is_finite()).then_some(gap)
}

/// The edge at `at` in a span, if there is one.
fn edge_at(given: &PiecewiseScene, span: &Span, at: f64) -> Option<usize> {
    let near = 1e-6 * span.length();
    let ends = [(0.0, 0), (given.length, given.cells.len())];
    if let Some((_, end)) = ends.into_iter().find(|&(x, end)| given.is_free_end(end) && (at - x).abs() < near) {
        return Some(end);
    }
    let within = |j: usize| span.a.cell < j && j <= span.b.cell;
    let joined = |j: usize| {
        [(&span.a, span.a.cell), (&span.b, span.b.cell + 1)]
            .iter()
            .any(|(end, i)| end.hold == EndCondition::Within && *i == j)
    };
    given.breakpoints_inside(at - near, at + near).find(|&j| (within(j) || joined(j)) && given.is_edge(j))
}
