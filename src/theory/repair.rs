//! What to try next when a list of contacts fails its check.

use super::edge::{edge_at, edge_node};
use super::fault::Fault;
use super::gap::half_bridge;
use super::given::Given;
use super::list::{AtSupport, Kind, List, Node};
use super::tidy::consistent;
use super::verify::Checked;
use super::zones::add_zones;

/// The list with its faults mended as far as each of them tells what to do.
pub(super) fn mended(given: &Given, lifting: &[(f64, f64)], list: &List, checked: &Checked) -> List {
    let mut repair = Repair {
        given,
        lifting,
        list,
        checked,
        supports: list.supports,
        nodes: list.nodes.clone(),
        keep: vec![true; list.nodes.len()],
        added: Vec::new(),
    };
    for fault in &checked.faults {
        match *fault {
            Fault::Inverted { start } => repair.inverted(start),
            Fault::Tension { node, .. } => repair.tension(node),
            Fault::Bulge { node, bend } => repair.bulge(node, bend),
            Fault::Pull { zone, .. } => repair.pull(zone),
            Fault::Broken { zone, joint } => repair.broken(zone, joint),
            Fault::Couple { support, .. } => repair.couple(support),
            Fault::Penetration { span, at, .. } => repair.penetration(span, at),
            Fault::Astray { node } => repair.astray(node),
            Fault::Unresolved { .. } | Fault::Unbalanced { .. } | Fault::Residual { .. } => {}
        }
    }
    repair.done()
}

/// A list and what becomes of it.
struct Repair<'a> {
    given: &'a Given,
    lifting: &'a [(f64, f64)],
    list: &'a List,
    checked: &'a Checked,
    supports: [AtSupport; 2],
    /// Those of the list, some of them moved.
    nodes: Vec<Node>,
    /// Which of them are kept.
    keep: Vec<bool>,
    /// Replacements and additions, in any order.
    added: Vec<Node>,
}

impl Repair<'_> {
    fn done(self) -> List {
        let kept = self.nodes.into_iter().zip(self.keep).filter(|(_, kept)| *kept).map(|(node, _)| node);
        let mut nodes: Vec<Node> = kept.chain(self.added).collect();
        nodes.sort_by(|a, b| a.x.total_cmp(&b.x));
        consistent(self.given, List { supports: self.supports, nodes })
    }

    /// A zone that ends before it starts is a point.
    fn inverted(&mut self, start: usize) {
        let x = 0.5 * (self.nodes[start].x + self.nodes[start + 1].x);
        (self.keep[start], self.keep[start + 1]) = (false, false);
        self.add(Kind::Smooth, x);
    }

    /// A point that pulls goes; the end of a zone that pulls has to move outwards.
    fn tension(&mut self, node: usize) {
        /// How far, as a share of the way to what is next.
        const OUTWARDS: f64 = 0.3;
        let Node { kind, x, cell, .. } = self.nodes[node];
        let (lo, hi) = self.given.reach(cell);
        match kind {
            Kind::Smooth | Kind::Edge(_) => self.keep[node] = false,
            Kind::ZoneStart => {
                let left = node.checked_sub(1).map_or(0.0, |i| self.list.nodes[i].x);
                self.nodes[node].x -= OUTWARDS * (x - left).min(x - lo);
            }
            Kind::ZoneEnd => {
                let right = self.list.nodes.get(node + 1).map_or(self.given.length, |n| n.x);
                self.nodes[node].x += OUTWARDS * (right - x).min(hi - x);
            }
        }
    }

    /// The profile bulges into the beam from both sides of the point: it carries a zone, unless that would pull.
    fn bulge(&mut self, node: usize, bend: f64) {
        let Node { x, cell, .. } = self.list.nodes[node];
        if self.keep[node] && !self.lifting.iter().any(|l| l.0 < x && x < l.1) {
            self.keep[node] = false;
            // The moment falls to that of the profile over this length.
            let falls = -2.0 * bend / self.checked.forces[node].abs();
            let half = falls.min(0.3 * self.nearest(node));
            self.added.push(Node::new(Kind::ZoneStart, x - half, cell));
            self.added.push(Node::new(Kind::ZoneEnd, x + half, cell));
        }
    }

    /// A zone that pulls is split where it does.
    fn pull(&mut self, zone: usize) {
        let [from, to] = self.take_out(zone);
        self.add_zones_between([from, to]);
    }

    /// On each side of the break the zone ends somewhat before it.
    fn broken(&mut self, zone: usize, joint: usize) {
        /// How much, as a share of the zone on that side.
        const SHORTER: f64 = 0.1;
        let [from, to] = self.take_out(zone);
        let x = self.given.joints[joint].x;
        let bridge = half_bridge(self.given, joint);
        let (left, right) = ((SHORTER * (x - from)).min(bridge), (SHORTER * (to - x)).min(bridge));
        self.add_zones_between([from, x - left]);
        if self.given.is_edge(joint) {
            self.added.push(edge_node(self.given, joint));
        }
        self.add_zones_between([x + right, to]);
    }

    /// Support and foundation would pull at each other: the beam has to lift off before it reaches the support.
    fn couple(&mut self, support: usize) {
        if self.list.supports[support] == AtSupport::Zone {
            let (length, nodes) = (self.given.length, &self.list.nodes);
            let far = if support == 0 { nodes.first() } else { nodes.last() }.map_or(length, |n| n.x);
            if support == 0 {
                self.add(Kind::ZoneStart, 0.3 * far);
            } else {
                self.add(Kind::ZoneEnd, 0.7 * length + 0.3 * far);
            }
        }
        self.supports[support] = AtSupport::Free;
    }

    /// The contact belongs to another piece of the profile.
    fn astray(&mut self, node: usize) {
        self.keep[node] = false;
        let Node { kind, x, .. } = self.list.nodes[node];
        self.add(kind, x);
    }

    /// The beam penetrates the foundation in the span before node `i`, deepest at `at`.
    fn penetration(&mut self, i: usize, at: f64) {
        let Some((_, span)) = self.checked.spans.iter().find(|(j, _)| *j == i) else {
            return;
        };
        let (given, list) = (self.given, self.list);
        if let Some(joint) = edge_at(given, span, at) {
            self.added.push(edge_node(given, joint));
            return;
        }
        let n = list.nodes.len();
        let beside = |x: f64| (at - x).abs() < 0.5 * span.length();
        // A support at the level of the foundation, which the beam leaves too steeply.
        for (support, end, turn) in [(0, span.a, span.at_a[1]), (1, span.b, -span.at_b[1])] {
            let here = if support == 0 { i == 0 } else { i == n };
            if here && list.supports[support] == AtSupport::Free && given.starts_at_zero(support) && turn < 0.0 {
                self.supports[support] = AtSupport::Clamped;
                if given.derivative(end.cell, end.x, 2) <= 0.0 {
                    self.start_zone_at_support(support, 0.1 * span.length());
                }
                return;
            }
            if here && list.supports[support] == AtSupport::Clamped && beside(end.x) {
                self.start_zone_at_support(support, 0.1 * span.length());
                return;
            }
        }
        let neighbours = [i.checked_sub(1), (i < n).then_some(i)];
        // An edge that the beam leaves on the wrong side: it touches the slope beside it instead.
        for (node, end, turn) in [(neighbours[0], span.a, span.at_a[1]), (neighbours[1], span.b, -span.at_b[1])] {
            if let Some(node) = node.filter(|&node| matches!(list.nodes[node].kind, Kind::Edge(_)))
                && turn < 0.0
                && beside(end.x)
            {
                self.keep[node] = false;
                self.add(Kind::Smooth, at);
                return;
            }
        }
        for node in neighbours.into_iter().flatten().filter(|&node| beside(list.nodes[node].x)) {
            // A point that bulges, or that becomes a zone, is mended by itself; and beside a zone that ends in tension the
            // zone has to move, which the tension says already.
            let moves = list.nodes[node].kind.is_of_zone() && self.checked.forces[node] < 0.0;
            if !self.keep[node] || moves {
                return;
            }
        }
        self.add(Kind::Smooth, at);
    }

    fn add(&mut self, kind: Kind, x: f64) {
        self.added.push(Node::new(kind, x, self.given.cell_from(x)));
    }

    /// Takes a zone out of the list; returns from where to where it went.
    fn take_out(&mut self, zone: usize) -> [f64; 2] {
        match zone.checked_sub(1) {
            Some(i) => self.keep[i] = false,
            None => self.supports[0] = AtSupport::Free,
        }
        match self.keep.get_mut(zone) {
            Some(kept) => *kept = false,
            None => self.supports[1] = AtSupport::Free,
        }
        let nodes = &self.list.nodes;
        [zone.checked_sub(1).map_or(0.0, |i| nodes[i].x), nodes.get(zone).map_or(self.given.length, |n| n.x)]
    }

    /// Adds zones between two places, split where they would pull.
    fn add_zones_between(&mut self, ends: [f64; 2]) {
        let mut parts = List::free();
        add_zones(self.given, self.lifting, ends, 0.0, &mut parts);
        for (support, part) in self.supports.iter_mut().zip(parts.supports) {
            if part == AtSupport::Zone {
                *support = AtSupport::Zone;
            }
        }
        self.added.extend(parts.nodes);
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

    /// Distance to the nearest neighbour or break of the profile.
    fn nearest(&self, node: usize) -> f64 {
        let nodes = &self.list.nodes;
        let x = nodes[node].x;
        let (lo, hi) = self.given.reach(nodes[node].cell);
        let left = node.checked_sub(1).map_or(lo, |i| nodes[i].x.max(lo));
        let right = nodes.get(node + 1).map_or(hi, |n| n.x.min(hi));
        (x - left).min(right - x)
    }
}
