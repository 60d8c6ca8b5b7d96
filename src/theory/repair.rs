//! What to try next when a list of contacts fails its check: each fault says what it changes.
//!
//! A point that pulls goes, one at which the beam bends more than the profile becomes a zone, and where the beam penetrates
//! the profile deepest it touches. Two contacts that cannot be two are one zone afterwards ([`super::list::normalised`]).

use super::check::Checked;
use super::list::{AtSupport, Kind, List, Node, edge_node, normalised};
use super::piecewise::PiecewiseScene;
use super::span::Span;
use super::tension::zones_between;
use super::violation::Violation;

/// The list with its faults repaired as far as each of them says how.
pub(super) fn repaired(given: &PiecewiseScene, list: &List, checked: &Checked) -> List {
    let (supports, keep) = (list.supports, vec![true; list.nodes.len()]);
    let mut repair = Repair { given, list, checked, supports, keep, added: Vec::new() };
    for &(i, fault) in &checked.faults {
        match fault {
            Violation::Inverted { .. } => (repair.keep[i], repair.keep[i + 1]) = (false, false),
            Violation::Tension { .. } => repair.tension(i),
            Violation::CurvatureGap { .. } => repair.curvature_gap(i),
            Violation::Pull { .. } => repair.pull(i),
            Violation::Unresolved { .. } => repair.unresolved(i),
            Violation::Couple { .. } => repair.couple(i),
            Violation::Penetration { at, .. } => repair.penetration(i, at),
            _ => {}
        }
    }
    let Repair { supports, keep, added, .. } = repair;
    let kept = list.nodes.iter().zip(keep).filter(|(_, kept)| *kept).map(|(node, _)| *node);
    let mut nodes: Vec<Node> = kept.chain(added).collect();
    nodes.sort_by(|a, b| a.x.total_cmp(&b.x));
    normalised(given, List { supports, nodes })
}

/// A list and what becomes of it.
struct Repair<'a> {
    given: &'a PiecewiseScene,
    list: &'a List,
    checked: &'a Checked,
    supports: [AtSupport; 2],
    /// Which nodes of the list are kept.
    keep: Vec<bool>,
    /// Additions, in any order.
    added: Vec<Node>,
}

impl Repair<'_> {
    /// The beam touches the smooth profile at `x`.
    fn touch(&mut self, x: f64) {
        self.added.push(Node::new(Kind::Smooth, x, self.given.cell_from(x)));
    }

    /// A point that pulls goes. The end of a zone moves by itself when others have changed.
    fn tension(&mut self, i: usize) {
        if !self.list.nodes[i].kind.is_of_zone() {
            self.keep[i] = false;
        }
    }

    /// The profile bulges into the beam from both sides of the point: it carries a zone, unless that would pull.
    fn curvature_gap(&mut self, i: usize) {
        let Node { x, cell, .. } = self.list.nodes[i];
        if !self.keep[i] || self.given.tension_between(x, x).next().is_some() {
            return;
        }
        self.keep[i] = false;
        let nodes = &self.list.nodes;
        let (lo, hi) = self.given.reach(cell);
        let left = i.checked_sub(1).map_or(lo, |i| nodes[i].x.max(lo));
        let right = nodes.get(i + 1).map_or(hi, |n| n.x.min(hi));
        let half = 0.3 * (x - left).min(right - x);
        self.added.push(Node::new(Kind::ZoneStart, x - half, cell));
        self.added.push(Node::new(Kind::ZoneEnd, x + half, cell));
    }

    /// A zone that pulls is split where it does.
    fn pull(&mut self, i: usize) {
        let ends = [i.checked_sub(1), (i < self.keep.len()).then_some(i)];
        if ends.iter().flatten().any(|&end| !self.keep[end]) {
            return;
        }
        let place = |end: Option<usize>, support: f64| end.map_or(support, |end| self.list.nodes[end].x);
        let zones = zones_between(self.given, [place(ends[0], 0.0), place(ends[1], self.given.length)]);
        ends.iter().flatten().for_each(|&end| self.keep[end] = false);
        for support in [0, 1].into_iter().filter(|&support| ends[support].is_none()) {
            self.supports[support] = AtSupport::Free;
        }
        self.added.extend(zones);
    }

    /// A zone that reaches an edge as far as can be told carries what the edge would.
    fn unresolved(&mut self, i: usize) {
        let nodes = &self.list.nodes;
        let beside = [i.checked_sub(1), (i < nodes.len()).then_some(i)];
        if beside.iter().flatten().any(|&node| nodes[node].kind.is_of_zone()) {
            for node in beside.into_iter().flatten().filter(|&node| nodes[node].is_edge()) {
                self.keep[node] = false;
            }
        }
    }

    /// Support and foundation would pull at each other: the beam lifts off before it reaches the support.
    fn couple(&mut self, support: usize) {
        let (given, nodes) = (self.given, &self.list.nodes);
        if self.list.supports[support] == AtSupport::Zone {
            let far = if support == 0 { nodes.first() } else { nodes.last() }.map_or(given.length, |n| n.x);
            let (kind, x) = if support == 0 {
                (Kind::ZoneStart, 0.3 * far)
            } else {
                (Kind::ZoneEnd, 0.7 * given.length + 0.3 * far)
            };
            self.added.push(Node::new(kind, x, given.cell_from(x)));
        }
        self.supports[support] = AtSupport::Free;
    }

    /// The beam penetrates the foundation in the span before node `i`, deepest at `at`.
    fn penetration(&mut self, i: usize, at: f64) {
        let Ok(index) = self.checked.spans.binary_search_by_key(&i, |(j, _)| *j) else {
            return;
        };
        let (given, list) = (self.given, self.list);
        let (_, span) = &self.checked.spans[index];
        if let Some(breakpoint) = edge_at(given, span, at) {
            self.added.push(edge_node(given, breakpoint));
            return;
        }
        // The beam leaves an edge beside it on the wrong side: it touches the slope there instead.
        let neighbours = [(i.checked_sub(1), span.a.x, span.at_a[1]), (Some(i), span.b.x, -span.at_b[1])];
        for (node, x, turn) in neighbours {
            if let Some(node) = node.filter(|&node| node < list.nodes.len())
                && list.nodes[node].is_edge()
                && (at - x).abs() < 0.5 * span.length()
                && turn < 0.0
            {
                self.keep[node] = false;
            }
        }
        self.touch(at);
    }
}

/// The edge at `at` in a span, if there is one.
fn edge_at(given: &PiecewiseScene, span: &Span, at: f64) -> Option<usize> {
    let near = 1e-6 * span.length();
    given.breakpoints_inside(at - near, at + near).find(|&j| span.a.cell < j && j <= span.b.cell && given.is_edge(j))
}
