//! Lists that make sense: zones with two ends, spans with a length, no span in which nothing happens.

use super::given::Given;
use super::list::{AtSupport, Kind, List, Node};

/// The list without nodes that make no sense: starts and ends of zones that have lost their partner, and neighbours that
/// leave no span between them.
pub(super) fn consistent(given: &Given, list: List) -> List {
    // A gap of this width between two contacts cannot be told from none; one between contacts on the same slope is more
    // likely the solution without a gap, which the equations have as well.
    let closed = 1e-11 * given.length;
    let least = 16.0 * f64::EPSILON * given.length;
    let mut nodes: Vec<Node> = Vec::with_capacity(list.nodes.len());
    let mut supports = list.supports;
    let mut inside = supports[0] == AtSupport::Zone;
    for node in list.nodes {
        let before = nodes.last().map_or(0.0, |n| n.x);
        let edge = |n: &Node| matches!(n.kind, Kind::Edge(_));
        let on_one_slope = !edge(&node) && nodes.last().is_some_and(|n| !edge(n));
        let gap = (if on_one_slope { closed } else { least }) < node.x - before;
        match node.kind {
            Kind::ZoneStart | Kind::Smooth | Kind::Edge(_) if inside => {}
            Kind::ZoneEnd if !inside => {}
            Kind::ZoneEnd => {
                inside = false;
                nodes.push(node);
            }
            _ if gap => {
                inside = node.kind == Kind::ZoneStart;
                nodes.push(node);
            }
            Kind::ZoneStart if nodes.last().is_some_and(|n| n.kind == Kind::ZoneEnd) => {
                // Two zones that meet are one.
                nodes.pop();
                inside = true;
            }
            Kind::ZoneStart => {
                nodes.pop();
                inside = true;
                nodes.push(node);
            }
            Kind::Smooth | Kind::Edge(_) => {}
        }
    }
    while nodes.last().is_some_and(|n| given.length - n.x <= least) {
        inside = nodes.pop().is_some_and(|n| n.kind == Kind::ZoneEnd);
    }
    // A zone that starts, or ends, in the last digits beside a support where the foundation starts as well.
    if nodes.first().is_some_and(|n| n.kind == Kind::ZoneStart && n.x <= least) && given.starts_at_zero(0) {
        nodes.remove(0);
        supports[0] = AtSupport::Zone;
    }
    if inside && given.starts_at_zero(1) {
        supports[1] = AtSupport::Zone;
    }
    if inside && supports[1] != AtSupport::Zone {
        // The zone that was opened last has no end.
        match nodes.iter().rposition(|n| n.kind == Kind::ZoneStart) {
            Some(i) => {
                nodes.remove(i);
            }
            None => supports[0] = AtSupport::Free,
        }
    } else if !inside && supports[1] == AtSupport::Zone {
        supports[1] = AtSupport::Free;
    }
    List { supports, nodes }
}

/// Joins the contacts on both sides of every span in which nothing drives the beam away from a profile that it follows:
/// it rests there without pressure, and where exactly is nowhere to be found.
pub(super) fn joined(given: &Given, mut list: List) -> List {
    let smooth = |node: &Node| !matches!(node.kind, Kind::Edge(_));
    let n = list.nodes.len();
    let mut keep = vec![true; n];
    for (i, span) in list.spans(given) {
        let idle = span.at_a.iter().chain(&span.at_b).all(|&h| h == 0.0);
        let inside = given.joints_between(span.a.cell, span.b.cell);
        if !idle || inside.iter().any(|j| j.force != 0.0 || j.kink != 0.0 || j.step != 0.0) {
            continue;
        }
        let (left, right) = (i.checked_sub(1), (i < n).then_some(i));
        let can_join = |node: Option<usize>, support: usize| match node {
            Some(node) => smooth(&list.nodes[node]),
            None => list.supports[support] == AtSupport::Free && given.starts_at_zero(support),
        };
        if !can_join(left, 0) || !can_join(right, 1) || (left.is_none() && right.is_none()) {
            continue;
        }
        match left {
            Some(node) if list.nodes[node].kind == Kind::Smooth => list.nodes[node].kind = Kind::ZoneStart,
            Some(node) => keep[node] = false,
            None => list.supports[0] = AtSupport::Zone,
        }
        match right {
            // A point with idle spans on both sides is inside the zone.
            Some(node) if list.nodes[node].kind == Kind::Smooth => list.nodes[node].kind = Kind::ZoneEnd,
            Some(node) => keep[node] = false,
            None => list.supports[1] = AtSupport::Zone,
        }
    }
    let mut kept = keep.into_iter();
    list.nodes.retain(|_| kept.next().unwrap_or(true));
    list
}
