//! Single changes of a list: what to choose from where mending all faults at once leads in circles.
//!
//! Beside an edge a beam may rest on the edge, on the slope beside it at a point or over a zone, or on both, and which of
//! them it is shows only once it has been tried. So each fault by itself offers every list that could be meant.

use super::gap::{half_bridge, settled_gap};
use super::given::Given;
use super::guess::edge_node;
use super::list::{Kind, List, Node};
use super::span::Span;
use super::tidy::consistent;
use super::verify::{Checked, Fault};

/// Faults that are looked at, the first ones of each kind: mending one often mends others.
const FAULTS: usize = 8;

/// Every list that differs from `list` by the mending of one fault.
pub(super) fn alternatives(given: &Given, list: &List, checked: &Checked) -> Vec<List> {
    let mut found: Vec<List> = Vec::new();
    let mut offer = |without: &[usize], with: &[Node]| {
        let kept = list.nodes.iter().enumerate().filter(|(i, _)| !without.contains(i)).map(|(_, node)| *node);
        let mut nodes: Vec<Node> = kept.chain(with.iter().copied()).collect();
        nodes.sort_by(|a, b| a.x.total_cmp(&b.x));
        let changed = consistent(given, List { supports: list.supports, nodes });
        if !found.contains(&changed) {
            found.push(changed);
        }
    };
    for fault in checked.faults.iter().take(FAULTS) {
        match *fault {
            Fault::Penetration { span: i, at, .. } => {
                let Some((_, span)) = checked.spans.iter().find(|(j, _)| *j == i) else { continue };
                if let Some(joint) = edge_at(given, span, at) {
                    offer(&[], &[edge_node(given, joint)]);
                    continue;
                }
                let cell = given.cell_from(at);
                let zone = zone_around(given, list, cell, at);
                offer(&[], &[Node::new(Kind::Smooth, at, cell)]);
                offer(&[], &zone);
                for node in [i.checked_sub(1), (i < list.nodes.len()).then_some(i)].into_iter().flatten() {
                    if matches!(list.nodes[node].kind, Kind::Smooth | Kind::Edge(_)) {
                        offer(&[node], &[Node::new(Kind::Smooth, at, cell)]);
                        offer(&[node], &zone);
                    }
                }
            }
            Fault::Tension { node, .. } => match list.nodes[node].kind {
                Kind::Smooth | Kind::Edge(_) => offer(&[node], &[]),
                Kind::ZoneStart => without_zone(given, list, [node, node + 1], &mut offer),
                Kind::ZoneEnd => without_zone(given, list, [node.saturating_sub(1), node], &mut offer),
            },
            Fault::Bulge { node, .. } => {
                let Node { x, cell, .. } = list.nodes[node];
                offer(&[node], &zone_around(given, list, cell, x));
                offer(&[node], &[]);
                for span in [node, node + 1] {
                    if let Some(joint) = edge_in_the_way(given, checked, span) {
                        offer(&[], &[edge_node(given, joint)]);
                    }
                }
            }
            Fault::Broken { joint, .. } => {
                // The joint is between two cells, the zone reaches further on both sides.
                let (left, right) = (given.reach(joint - 1).0, given.reach(joint).1);
                let x = given.joints[joint].x;
                let half = half_bridge(given, joint).min(0.1 * (x - left).min(right - x));
                let end = Node::new(Kind::ZoneEnd, x - half, joint - 1);
                let start = Node::new(Kind::ZoneStart, x + half, joint);
                if given.is_edge(joint) {
                    offer(&[], &[end, edge_node(given, joint), start]);
                } else {
                    offer(&[], &[end, start]);
                }
            }
            Fault::Pull { from, to, .. } => {
                let [end, start] = settled_gap(given, [from, to]);
                let end = Node::new(Kind::ZoneEnd, end, given.cell_to(end));
                offer(&[], &[end, Node::new(Kind::ZoneStart, start, given.cell_from(start))]);
            }
            Fault::Inverted { start } => without_zone(given, list, [start, start + 1], &mut offer),
            _ => {}
        }
    }
    for (i, node) in list.nodes.iter().enumerate() {
        // The end of a zone that was stopped by an edge: the beam rests on the edge as well.
        let (lo, hi) = given.reach(node.cell);
        let (stop, inwards) = match node.kind {
            Kind::ZoneStart => (lo, list.nodes.get(i + 1).map_or(given.length, |n| n.x)),
            Kind::ZoneEnd => (hi, i.checked_sub(1).map_or(0.0, |i| list.nodes[i].x)),
            _ => continue,
        };
        if (node.x - stop).abs() <= 1e-6 * (hi - lo) {
            let joint = given.joints.partition_point(|j| j.x < stop);
            if given.is_edge(joint) {
                let moved = Node { x: 0.9 * stop + 0.1 * inwards, rest: 0.0, ..*node };
                offer(&[i], &[edge_node(given, joint), moved]);
            }
        }
    }
    found
}

/// Offers the list without a zone, and with a point in its place.
fn without_zone(given: &Given, list: &List, [start, end]: [usize; 2], offer: &mut impl FnMut(&[usize], &[Node])) {
    let (Some(from), Some(to)) = (list.nodes.get(start), list.nodes.get(end)) else { return };
    let x = 0.5 * (from.x + to.x);
    offer(&[start, end], &[Node::new(Kind::Smooth, x, given.cell_from(x))]);
    offer(&[start, end], &[]);
}

/// A short zone around a place.
fn zone_around(given: &Given, list: &List, cell: usize, x: f64) -> [Node; 2] {
    let (lo, hi) = given.reach(cell);
    let left = list.nodes.iter().map(|n| n.x).filter(|&other| other < x).fold(lo, f64::max);
    let right = list.nodes.iter().map(|n| n.x).filter(|&other| x < other).fold(hi, f64::min);
    let half = 0.1 * (x - left).min(right - x);
    [Node::new(Kind::ZoneStart, x - half, cell), Node::new(Kind::ZoneEnd, x + half, cell)]
}

/// The edge at `at` in a span, if there is one.
fn edge_at(given: &Given, span: &Span, at: f64) -> Option<usize> {
    let near = 1e-6 * span.length();
    (span.a.cell + 1..=span.b.cell).find(|&j| given.is_edge(j) && (given.joints[j].x - at).abs() <= near)
}

/// The edge that the beam penetrates in the span before node `i`, if it is an edge where it does so most.
fn edge_in_the_way(given: &Given, checked: &Checked, i: usize) -> Option<usize> {
    let (_, span) = checked.spans.iter().find(|(j, _)| *j == i)?;
    checked.faults.iter().find_map(|fault| match *fault {
        Fault::Penetration { span: j, at, .. } if j == i => edge_at(given, span, at),
        _ => None,
    })
}
