//! Single changes of a list: what to choose from where mending all faults at once leads in circles.
//!
//! Beside an edge a beam may rest on the edge, on the slope beside it at a point or over a zone, or on both, and which of
//! them it is shows only once it has been tried. So each fault by itself offers every list that could be meant.

use super::edge::{edge_at, edge_node};
use super::fault::Fault;
use super::gap::{half_bridge, settled_gap};
use super::given::Given;
use super::list::{Kind, List, Node};
use super::tidy::consistent;
use super::verify::Checked;

/// Faults that are looked at, the first ones of each kind: mending one often mends others.
const FAULTS: usize = 8;

/// Every list that differs from `list` by the mending of one fault.
pub(super) fn alternatives(given: &Given, list: &List, checked: &Checked) -> Vec<List> {
    let mut offers = Offers { given, list, found: Vec::new() };
    for fault in checked.faults.iter().take(FAULTS) {
        match *fault {
            Fault::Penetration { span, at, .. } => offers.penetration(checked, span, at),
            Fault::Tension { node, .. } => offers.tension(node),
            Fault::Bulge { node, .. } => offers.bulge(checked, node),
            Fault::Broken { joint, .. } => offers.broken(joint),
            Fault::Pull { from, to, .. } => offers.pull([from, to]),
            Fault::Inverted { start } => offers.without_zone([start, start + 1]),
            _ => {}
        }
    }
    for i in 0..list.nodes.len() {
        offers.stopped(i);
    }
    offers.found
}

/// The changed lists of one list.
struct Offers<'a> {
    given: &'a Given,
    list: &'a List,
    found: Vec<List>,
}

impl Offers<'_> {
    /// The list without some of its nodes and with others.
    fn offer(&mut self, without: &[usize], with: &[Node]) {
        let List { supports, ref nodes } = *self.list;
        let kept = nodes.iter().enumerate().filter(|(i, _)| !without.contains(i)).map(|(_, node)| *node);
        let mut nodes: Vec<Node> = kept.chain(with.iter().copied()).collect();
        nodes.sort_by(|a, b| a.x.total_cmp(&b.x));
        let changed = consistent(self.given, List { supports, nodes });
        if !self.found.contains(&changed) {
            self.found.push(changed);
        }
    }

    /// The beam rests on the edge that it penetrates; or at a point or a zone there, besides the contacts beside it or in
    /// the place of one of them.
    fn penetration(&mut self, checked: &Checked, i: usize, at: f64) {
        let Some((_, span)) = checked.spans.iter().find(|(j, _)| *j == i) else { return };
        if let Some(joint) = edge_at(self.given, span, at) {
            self.offer(&[], &[edge_node(self.given, joint)]);
            return;
        }
        let cell = self.given.cell_from(at);
        let point = [Node::new(Kind::Smooth, at, cell)];
        let zone = zone_around(self.given, self.list, cell, at);
        self.offer(&[], &point);
        self.offer(&[], &zone);
        for node in [i.checked_sub(1), (i < self.list.nodes.len()).then_some(i)].into_iter().flatten() {
            if !self.list.nodes[node].kind.is_of_zone() {
                self.offer(&[node], &point);
                self.offer(&[node], &zone);
            }
        }
    }

    /// The contact that pulls goes.
    fn tension(&mut self, node: usize) {
        match self.list.nodes[node].kind {
            Kind::Smooth | Kind::Edge(_) => self.offer(&[node], &[]),
            Kind::ZoneStart => self.without_zone([node, node + 1]),
            Kind::ZoneEnd => self.without_zone([node.saturating_sub(1), node]),
        }
    }

    /// The point is a zone, or is none, or the beam rests on an edge beside it.
    fn bulge(&mut self, checked: &Checked, node: usize) {
        let Node { x, cell, .. } = self.list.nodes[node];
        self.offer(&[node], &zone_around(self.given, self.list, cell, x));
        self.offer(&[node], &[]);
        for span in [node, node + 1] {
            if let Some(joint) = edge_in_the_way(self.given, checked, span) {
                self.offer(&[], &[edge_node(self.given, joint)]);
            }
        }
    }

    /// The zone ends before the break and starts again behind it; on an edge the beam rests between them.
    fn broken(&mut self, joint: usize) {
        let given = self.given;
        // The joint is between two cells, the zone reaches further on both sides.
        let (left, right) = (given.reach(joint - 1).0, given.reach(joint).1);
        let x = given.joints[joint].x;
        let half = half_bridge(given, joint).min(0.1 * (x - left).min(right - x));
        let end = Node::new(Kind::ZoneEnd, x - half, joint - 1);
        let start = Node::new(Kind::ZoneStart, x + half, joint);
        if given.is_edge(joint) {
            self.offer(&[], &[end, edge_node(given, joint), start]);
        } else {
            self.offer(&[], &[end, start]);
        }
    }

    /// The beam lifts off where the zone would pull.
    fn pull(&mut self, stretch: [f64; 2]) {
        let [end, start] = settled_gap(self.given, stretch);
        let end = Node::new(Kind::ZoneEnd, end, self.given.cell_to(end));
        let start = Node::new(Kind::ZoneStart, start, self.given.cell_from(start));
        self.offer(&[], &[end, start]);
    }

    /// The list without a zone, and with a point in its place.
    fn without_zone(&mut self, [start, end]: [usize; 2]) {
        let (Some(from), Some(to)) = (self.list.nodes.get(start), self.list.nodes.get(end)) else { return };
        let x = 0.5 * (from.x + to.x);
        self.offer(&[start, end], &[Node::new(Kind::Smooth, x, self.given.cell_from(x))]);
        self.offer(&[start, end], &[]);
    }

    /// The end of a zone that was stopped by an edge: the beam rests on the edge as well.
    fn stopped(&mut self, i: usize) {
        let (given, nodes) = (self.given, &self.list.nodes);
        let node = nodes[i];
        let (lo, hi) = given.reach(node.cell);
        let (stop, inwards) = match node.kind {
            Kind::ZoneStart => (lo, nodes.get(i + 1).map_or(given.length, |n| n.x)),
            Kind::ZoneEnd => (hi, i.checked_sub(1).map_or(0.0, |i| nodes[i].x)),
            Kind::Smooth | Kind::Edge(_) => return,
        };
        let joint = given.joints.partition_point(|j| j.x < stop);
        if (node.x - stop).abs() <= 1e-6 * (hi - lo) && given.is_edge(joint) {
            let moved = Node { x: 0.9 * stop + 0.1 * inwards, rest: 0.0, ..node };
            self.offer(&[i], &[edge_node(given, joint), moved]);
        }
    }
}

/// A short zone around a place.
fn zone_around(given: &Given, list: &List, cell: usize, x: f64) -> [Node; 2] {
    let (lo, hi) = given.reach(cell);
    let left = list.nodes.iter().map(|n| n.x).filter(|&other| other < x).fold(lo, f64::max);
    let right = list.nodes.iter().map(|n| n.x).filter(|&other| x < other).fold(hi, f64::min);
    let half = 0.1 * (x - left).min(right - x);
    [Node::new(Kind::ZoneStart, x - half, cell), Node::new(Kind::ZoneEnd, x + half, cell)]
}

/// The edge that the beam penetrates in the span before node `i`, if it is an edge where it does so most.
fn edge_in_the_way(given: &Given, checked: &Checked, i: usize) -> Option<usize> {
    let (_, span) = checked.spans.iter().find(|(j, _)| *j == i)?;
    checked.faults.iter().find_map(|fault| match *fault {
        Fault::Penetration { span: j, at, .. } if j == i => edge_at(given, span, at),
        _ => None,
    })
}
