//! What to try next when a list of contacts fails its check.

use super::gap::half_bridge;
use super::given::Given;
use super::guess::{add_zones, edge_node};
use super::list::{AtSupport, Kind, List, Node};
use super::tidy::consistent;
use super::verify::{Checked, Fault};

/// The list with its faults mended as far as each of them tells what to do.
pub(super) fn mended(given: &Given, lifting: &[(f64, f64)], list: &List, checked: &Checked) -> List {
    let n = list.nodes.len();
    let mut supports = list.supports;
    let mut keep = vec![true; n];
    // Replacements and additions; sorted by place in the end.
    let mut added: Vec<Vec<Node>> = Vec::new();
    let mut nodes = list.nodes.clone();

    for fault in &checked.faults {
        match *fault {
            Fault::Inverted { start } => {
                let x = 0.5 * (nodes[start].x + nodes[start + 1].x);
                (keep[start], keep[start + 1]) = (false, false);
                added.push(vec![Node::new(Kind::Smooth, x, given.cell_from(x))]);
            }
            Fault::Tension { node, .. } => match nodes[node].kind {
                Kind::Smooth | Kind::Edge(_) => keep[node] = false,
                // The end of a zone that pulls: it has to move outwards.
                Kind::ZoneStart => {
                    let left = node.checked_sub(1).map_or(0.0, |i| list.nodes[i].x);
                    nodes[node].x -= 0.3 * (nodes[node].x - left).min(nodes[node].x - given.reach(nodes[node].cell).0);
                }
                Kind::ZoneEnd => {
                    let right = list.nodes.get(node + 1).map_or(given.length, |n| n.x);
                    let x = nodes[node].x;
                    nodes[node].x += 0.3 * (right - x).min(given.reach(nodes[node].cell).1 - x);
                }
            },
            // The profile bulges into the beam from both sides of the point: it carries a zone, unless that would pull.
            Fault::Bulge { node, bend } => {
                let Node { x, cell, .. } = list.nodes[node];
                if keep[node] && !lifting.iter().any(|l| l.0 < x && x < l.1) {
                    keep[node] = false;
                    // The moment falls to that of the profile over this length.
                    let half = (-2.0 * bend / checked.forces[node].abs()).min(0.3 * nearest(given, list, node));
                    added.push(vec![
                        Node::new(Kind::ZoneStart, x - half, cell),
                        Node::new(Kind::ZoneEnd, x + half, cell),
                    ]);
                }
            }
            Fault::Pull { zone, .. } => {
                let [from, to] = without_zone(given, list, zone, &mut supports, &mut keep);
                added.push(zones_between(given, lifting, [from, to], &mut supports));
            }
            // On each side of the break the zone ends somewhat before it.
            Fault::Broken { zone, joint } => {
                const SHORTER: f64 = 0.1;
                let [from, to] = without_zone(given, list, zone, &mut supports, &mut keep);
                let x = given.joints[joint].x;
                let bridge = half_bridge(given, joint);
                let (left, right) = ((SHORTER * (x - from)).min(bridge), (SHORTER * (to - x)).min(bridge));
                added.push(zones_between(given, lifting, [from, x - left], &mut supports));
                if given.is_edge(joint) {
                    added.push(vec![edge_node(given, joint)]);
                }
                added.push(zones_between(given, lifting, [x + right, to], &mut supports));
            }
            Fault::Couple { support, .. } => {
                if list.supports[support] == AtSupport::Zone {
                    // The beam has to lift off before it reaches the support.
                    let node = if support == 0 { 0 } else { n.saturating_sub(1) };
                    let far = list.nodes.get(node).map_or(given.length, |n| n.x);
                    let (kind, x) = if support == 0 {
                        (Kind::ZoneStart, 0.3 * far)
                    } else {
                        (Kind::ZoneEnd, 0.7 * given.length + 0.3 * far)
                    };
                    added.push(vec![Node::new(kind, x, given.cell_from(x))]);
                }
                supports[support] = AtSupport::Free;
            }
            Fault::Penetration { span, at, .. } => penetrated(
                given,
                list,
                checked,
                span,
                at,
                &mut Edit { supports: &mut supports, keep: &mut keep, added: &mut added },
            ),
            Fault::Astray { node } => {
                keep[node] = false;
                let Node { kind, x, .. } = list.nodes[node];
                added.push(vec![Node::new(kind, x, given.cell_from(x))]);
            }
            Fault::Unresolved { .. } | Fault::Unbalanced { .. } | Fault::Residual { .. } => {}
        }
    }
    let mut all: Vec<Node> = nodes.into_iter().zip(&keep).filter(|(_, kept)| **kept).map(|(node, _)| node).collect();
    all.extend(added.into_iter().flatten());
    all.sort_by(|a, b| a.x.total_cmp(&b.x));
    consistent(given, List { supports, nodes: all })
}

/// Takes a zone out of the list; returns from where to where it went.
fn without_zone(given: &Given, list: &List, zone: usize, supports: &mut [AtSupport; 2], keep: &mut [bool]) -> [f64; 2] {
    match zone.checked_sub(1) {
        Some(i) => keep[i] = false,
        None => supports[0] = AtSupport::Free,
    }
    match keep.get_mut(zone) {
        Some(kept) => *kept = false,
        None => supports[1] = AtSupport::Free,
    }
    let from = zone.checked_sub(1).map_or(0.0, |i| list.nodes[i].x);
    [from, list.nodes.get(zone).map_or(given.length, |n| n.x)]
}

/// The nodes of zones between two places, split where they would pull.
fn zones_between(given: &Given, lifting: &[(f64, f64)], ends: [f64; 2], supports: &mut [AtSupport; 2]) -> Vec<Node> {
    let mut parts = List::free();
    add_zones(given, lifting, ends, 0.0, &mut parts);
    for (support, part) in supports.iter_mut().zip(parts.supports) {
        if part == AtSupport::Zone {
            *support = AtSupport::Zone;
        }
    }
    parts.nodes
}

/// What a repair may change.
struct Edit<'a> {
    supports: &'a mut [AtSupport; 2],
    keep: &'a mut Vec<bool>,
    added: &'a mut Vec<Vec<Node>>,
}

/// The beam penetrates the foundation in the span before node `i`, deepest at `at`.
fn penetrated(given: &Given, list: &List, checked: &Checked, i: usize, at: f64, edit: &mut Edit<'_>) {
    let Some((_, span)) = checked.spans.iter().find(|(j, _)| *j == i) else {
        return;
    };
    let n = list.nodes.len();
    let near = 1e-6 * span.length();
    let edge = (span.a.cell + 1..=span.b.cell).find(|&j| given.is_edge(j) && (given.joints[j].x - at).abs() <= near);
    if let Some(joint) = edge {
        edit.added.push(vec![edge_node(given, joint)]);
        return;
    }
    // A support at the level of the foundation, which the beam leaves too steeply.
    for (support, end, turn) in [(0, span.a, span.at_a[1]), (1, span.b, -span.at_b[1])] {
        let here = if support == 0 { i == 0 } else { i == n };
        if here && list.supports[support] == AtSupport::Free && given.starts_at_zero(support) && turn < 0.0 {
            let curved = given.derivative(end.cell, end.x, 2);
            edit.supports[support] = AtSupport::Clamped;
            if curved <= 0.0 {
                start_zone_at_support(given, support, 0.1 * span.length(), edit);
            }
            return;
        }
        if here && list.supports[support] == AtSupport::Clamped && (at - end.x).abs() < 0.5 * span.length() {
            start_zone_at_support(given, support, 0.1 * span.length(), edit);
            return;
        }
    }
    // An edge that the beam leaves on the wrong side: it touches the slope beside it instead.
    for (node, end, turn) in [(i.checked_sub(1), span.a, span.at_a[1]), ((i < n).then_some(i), span.b, -span.at_b[1])] {
        if let Some(node) = node
            && matches!(list.nodes[node].kind, Kind::Edge(_))
            && turn < 0.0
            && (at - end.x).abs() < 0.5 * span.length()
        {
            edit.keep[node] = false;
            edit.added.push(vec![Node::new(Kind::Smooth, at, given.cell_from(at))]);
            return;
        }
    }
    // A point that bulges, or that becomes a zone, is mended by itself.
    for node in [i.checked_sub(1), (i < n).then_some(i)].into_iter().flatten() {
        if !edit.keep[node] && (at - list.nodes[node].x).abs() < 0.5 * span.length() {
            return;
        }
    }
    // Beside a zone that ends in tension the zone has to move, which the tension says already.
    for node in [i.checked_sub(1), (i < n).then_some(i)].into_iter().flatten() {
        let zone = matches!(list.nodes[node].kind, Kind::ZoneStart | Kind::ZoneEnd);
        if zone && checked.forces[node] < 0.0 && (at - list.nodes[node].x).abs() < 0.5 * span.length() {
            return;
        }
    }
    edit.added.push(vec![Node::new(Kind::Smooth, at, given.cell_from(at))]);
}

/// Distance to the nearest neighbour or break of the profile.
fn nearest(given: &Given, list: &List, node: usize) -> f64 {
    let x = list.nodes[node].x;
    let (lo, hi) = given.reach(list.nodes[node].cell);
    let left = node.checked_sub(1).map_or(lo, |i| list.nodes[i].x.max(lo));
    let right = list.nodes.get(node + 1).map_or(hi, |n| n.x.min(hi));
    (x - left).min(right - x)
}

/// A zone from a support over `length`.
fn start_zone_at_support(given: &Given, support: usize, length: f64, edit: &mut Edit<'_>) {
    edit.supports[support] = AtSupport::Zone;
    let (kind, x) = if support == 0 { (Kind::ZoneEnd, length) } else { (Kind::ZoneStart, given.length - length) };
    let last = given.cells.len() - 1;
    edit.added.push(vec![Node::new(kind, x, if support == 0 { 0 } else { last })]);
}
