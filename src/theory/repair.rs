//! What to try next when a list of contacts fails its check: each fault says what it changes.
//!
//! A point that pulls goes, one at which the beam bends more than the profile becomes a zone, and where the beam penetrates
//! the profile deepest it touches. Two contacts that cannot be two are one zone afterwards ([`super::list::normalised`]).

use super::check::Checked;
use super::gap::zones_between;
use super::given::Given;
use super::list::{AtSupport, Kind, List, Node, edge_node, normalised};
use super::span::Span;
use super::violation::Violation;

/// The list with its faults repaired as far as each of them says how.
pub(super) fn repaired(given: &Given, list: &List, checked: &Checked) -> List {
    let (supports, keep) = (list.supports, vec![true; list.nodes.len()]);
    let mut repair = Repair { given, list, checked, supports, keep, added: Vec::new() };
    for &(i, fault) in &checked.faults {
        match fault {
            Violation::Inverted { from, to } => {
                (repair.keep[i], repair.keep[i + 1]) = (false, false);
                repair.touch(0.5 * (from + to));
            }
            Violation::Tension { .. } => repair.tension(i),
            Violation::Bulge { moment, .. } => repair.bulge(i, moment),
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
    given: &'a Given,
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
    fn bulge(&mut self, i: usize, moment: f64) {
        let Node { x, cell, .. } = self.list.nodes[i];
        if !self.keep[i] || self.given.tension_between(x, x).next().is_some() {
            return;
        }
        self.keep[i] = false;
        let nodes = &self.list.nodes;
        let (lo, hi) = self.given.reach(cell);
        let left = i.checked_sub(1).map_or(lo, |i| nodes[i].x.max(lo));
        let right = nodes.get(i + 1).map_or(hi, |n| n.x.min(hi));
        // The moment falls to that of the profile over this length.
        let falls = 2.0 * moment / self.checked.forces[i].abs();
        let half = falls.min(0.3 * (x - left).min(right - x));
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
            for node in beside.into_iter().flatten().filter(|&node| matches!(nodes[node].kind, Kind::Edge(_))) {
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
        if let Some(joint) = edge_at(given, span, at) {
            self.added.push(edge_node(given, joint));
            return;
        }
        let n = list.nodes.len();
        let beside = |x: f64| (at - x).abs() < 0.5 * span.length();
        // A support at the level of the foundation, which the beam leaves too steeply.
        for (support, end, turn) in [(0, span.a, span.at_a[1]), (1, span.b, -span.at_b[1])] {
            let here = if support == 0 { i == 0 } else { i == n };
            let held = list.supports[support] == AtSupport::Clamped;
            let steep = list.supports[support] == AtSupport::Free && given.starts_at_zero(support) && turn < 0.0;
            if here && (steep || held && beside(end.x)) {
                self.supports[support] = AtSupport::Clamped;
                if held || given.derivative(end.cell, end.x, 2) <= 0.0 {
                    self.start_zone_at_support(support, 0.1 * span.length());
                }
                return;
            }
        }
        let neighbours = [(i.checked_sub(1), span.a.x, span.at_a[1]), ((i < n).then_some(i), span.b.x, -span.at_b[1])];
        for (node, x, turn) in neighbours {
            let Some(node) = node.filter(|_| beside(x)) else { continue };
            if matches!(list.nodes[node].kind, Kind::Edge(_)) && turn < 0.0 {
                // The beam leaves the edge on the wrong side: it touches the slope beside it instead.
                self.keep[node] = false;
            } else if !self.keep[node] || list.nodes[node].kind.is_of_zone() && self.checked.forces[node] < 0.0 {
                // A point that goes or becomes a zone, or the end of a zone that will move.
                return;
            }
        }
        self.touch(at);
    }

    /// A zone from a support over `length`.
    fn start_zone_at_support(&mut self, support: usize, length: f64) {
        self.supports[support] = AtSupport::Zone;
        self.added.push(if support == 0 {
            Node::new(Kind::ZoneEnd, length, 0)
        } else {
            Node::new(Kind::ZoneStart, self.given.length - length, self.given.cells.len() - 1)
        });
    }
}

/// The edge at `at` in a span, if there is one.
fn edge_at(given: &Given, span: &Span, at: f64) -> Option<usize> {
    let near = 1e-6 * span.length();
    given.joints_inside(at - near, at + near).find(|&j| span.a.cell < j && j <= span.b.cell && given.is_edge(j))
}
