//! What to try next when a list of contacts fails its check: each fault says what it changes.
//!
//! A point that pulls goes, one at which the beam bends more than the profile becomes a zone, and where the beam penetrates
//! the profile deepest it touches. Two contacts that cannot be two are one zone afterwards ([`super::normal::normalised`]).

use super::check::Checked;
use super::list::{Beside, Kind, List, Node, support_node};
use super::normal::{edge_node, normalised};
use super::piecewise::PiecewiseScene;
use super::span::{Overhang, Span};
use super::tension::zones_between;
use super::violation::Violation;

/// The list with its faults repaired as far as each of them says how.
pub(super) fn repaired(given: &PiecewiseScene, list: &List, checked: &Checked) -> List {
    let (nodes, keep) = (list.nodes.clone(), vec![true; list.nodes.len()]);
    let mut repair = Repair { given, list, checked, nodes, keep, added: Vec::new() };
    for &(i, fault) in &checked.faults {
        match fault {
            Violation::Inverted { .. } => (repair.keep[i], repair.keep[i + 1]) = (false, false),
            Violation::Tension { .. } => repair.tension(i),
            Violation::CurvatureGap { .. } => repair.curvature_gap(i),
            Violation::Pull { .. } => repair.pull(i),
            Violation::Unresolved { .. } => repair.unresolved(i),
            Violation::Couple { .. } => repair.couple(i),
            Violation::Jump { .. } => repair.jump(i),
            Violation::Penetration { at, .. } => repair.penetration(i, at),
            _ => {}
        }
    }
    let Repair { nodes, keep, added, .. } = repair;
    let kept =
        nodes.into_iter().zip(keep).filter(|(node, kept)| *kept || node.support().is_some()).map(|(node, _)| node);
    let mut nodes: Vec<Node> = kept.chain(added).collect();
    nodes.sort_by(|a, b| a.x.total_cmp(&b.x));
    normalised(given, List { nodes })
}

/// A list and what becomes of it.
struct Repair<'a> {
    given: &'a PiecewiseScene,
    list: &'a List,
    checked: &'a Checked,
    /// The nodes, changed in place.
    nodes: Vec<Node>,
    /// Which of them are kept; supports always are.
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
        if self.list.nodes[i].kind == Kind::Tip {
            self.lift_tip(i);
        } else if !self.list.nodes[i].kind.is_of_zone() {
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
        let Some(ends) = i.checked_sub(1).map(|left| [left, i]).filter(|[_, right]| *right < self.keep.len()) else {
            return;
        };
        if ends.iter().any(|&end| !self.keep[end]) {
            return;
        }
        let zones = zones_between(self.given, ends.map(|end| self.list.nodes[end].x));
        for (side, end) in ends.into_iter().enumerate() {
            self.keep[end] = false;
            if let Kind::Support(_, beside) = &mut self.nodes[end].kind {
                beside[1 - side] = Beside::Apart;
            }
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
    fn couple(&mut self, i: usize) {
        let (given, nodes) = (self.given, &self.list.nodes);
        let (node, list) = (nodes[i], self.list);
        let Kind::Support(index, _) = node.kind else { return };
        if list.in_zone_before(i + 1) {
            let far = nodes[i + 1].x;
            let x = node.x + 0.3 * (far - node.x);
            self.added.push(Node::new(Kind::ZoneStart, x, given.cell_from(x)));
        }
        if list.in_zone_before(i) {
            let far = nodes[i - 1].x;
            let x = 0.7 * node.x + 0.3 * far;
            self.added.push(Node::new(Kind::ZoneEnd, x, given.cell_from(x)));
        }
        self.nodes[i] = support_node(given, index, [Beside::Apart; 2]);
    }

    /// A zone that reaches a free end on ground that is bent there lifts off before, or touches with its end alone.
    fn jump(&mut self, i: usize) {
        if self.list.nodes.get(i).is_some_and(|node| node.kind == Kind::Tip) {
            self.lift_tip(i);
        }
    }

    /// The zone of tip `i` ends where the overhang that it leaves is bent as the ground is, `∫q r = g''`; in a hollow, which
    /// bends the other way, the end of the beam touches besides.
    fn lift_tip(&mut self, i: usize) {
        /// Places that are tried; Newton's method does the rest.
        const PLACES: u32 = 64;
        let (given, nodes) = (self.given, &self.list.nodes);
        let (tip, left) = (nodes[i], nodes[i].x <= 0.0);
        let far = if left { nodes.get(i + 1) } else { i.checked_sub(1).map(|i| &nodes[i]) };
        let zone = far.map_or(0.0, |far| far.x - tip.x);
        let place = |k: u32| tip.x + zone * (f64::from(k) / f64::from(PLACES));
        let bent = |x: f64| Overhang::of(given, x, left).moment - given.derivative(given.cell_from(x), x, 2);
        let hollow = given.derivative(tip.cell, tip.x, 2) < 0.0;
        let place = match hollow {
            true => place(PLACES / 4),
            false => (1..PLACES).map(place).find(|&x| 0.0 <= bent(x)).unwrap_or(place(PLACES / 2)),
        };
        self.keep[i] = false;
        self.added.push(Node::new(if left { Kind::ZoneStart } else { Kind::ZoneEnd }, place, given.cell_from(place)));
        if hollow {
            self.added.push(edge_node(given, if left { 0 } else { given.cells.len() }));
        }
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
    let ends = [(0.0, 0), (given.length, given.cells.len())];
    if let Some((_, end)) = ends.into_iter().find(|&(x, end)| given.is_free_end(end) && (at - x).abs() < near) {
        return Some(end);
    }
    given.breakpoints_inside(at - near, at + near).find(|&j| span.a.cell < j && j <= span.b.cell && given.is_edge(j))
}
