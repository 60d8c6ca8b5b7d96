//! Forces of the nodes and zones of a list, and moments next to the nodes.

use super::list::{List, Node};
use super::piecewise::PiecewiseScene;
use super::sensitivity::{ends, parts_before};
use super::span::{EndCondition, Span};

/// Concentrated forces at the nodes, `R = P + v'''(x−) − v'''(x+) + N [v']`, with zero beyond the ends of the beam; at a support
/// without the load `P` directly on it.
pub(super) fn forces(given: &PiecewiseScene, list: &List, spans: &[(usize, Span)]) -> Vec<f64> {
    // The profile jumps in depth and slope only: g''' is the same on both sides of a contact, so h''' can be used.
    let last = given.cells.len() - 1;
    let of_zone = |node: usize, cell: usize| given.bent(cell, list.nodes[node].x, 3);
    let mut forces: Vec<f64> = Vec::with_capacity(list.nodes.len());
    for (i, node) in list.nodes.iter().enumerate() {
        let in_beam = !node.can_move() && !node.is_edge(given);
        let mut force = if node.support(given).is_some() { 0.0 } else { given.force_at(node.x, node.cell) };
        if in_beam {
            // In a zone the beam follows the profile.
            if list.in_zone_before(i) {
                force += of_zone(i, given.cell_to(node.x));
            }
            if list.in_zone_before(i + 1) {
                force -= of_zone(i, given.cell_from(node.x).min(last));
            }
        }
        forces.push(force);
    }
    for (i, span) in spans {
        if let Some(left) = i.checked_sub(1).filter(|_| span.a.hold != EndCondition::Within) {
            let node = &list.nodes[left];
            forces[left] += match node.can_move() || node.is_edge(given) && span.a.x > 0.0 {
                true => span.at_a[3],
                false => -span.beam_a[3],
            };
        }
        if let (Some(force), Some(node)) = (forces.get_mut(*i), list.nodes.get(*i))
            && span.b.hold != EndCondition::Within
        {
            *force -= match node.can_move() || node.is_edge(given) && span.b.x < given.length {
                true => span.at_b[3],
                false => -span.beam_b[3],
            };
        }
    }
    if given.tension != 0.0 {
        add_turns(given, list, spans, &mut forces);
    }
    forces
}

/// Adds the jumps of `N v'`: the vertical force is `V + N v'`, and the slope jumps at the ends of the beam and in joints.
fn add_turns(given: &PiecewiseScene, list: &List, spans: &[(usize, Span)], forces: &mut [f64]) {
    for (i, (node, force)) in list.nodes.iter().zip(forces).enumerate() {
        let is_end = node.x <= 0.0 || given.length <= node.x;
        if !is_end && !node.breakpoint.is_some_and(|at| given.breakpoints[at].is_jointed()) {
            continue;
        }
        let [before, behind] = ends(spans, i);
        let along = |lies: bool, cell: usize| if lies { given.derivative(cell, node.x, 1) } else { 0.0 };
        let left = before.map_or(along(list.in_zone_before(i), given.cell_to(node.x)), |span| span.beam_b[1]);
        let right = behind.map_or(along(list.in_zone_before(i + 1), given.cell_from(node.x)), |span| span.beam_a[1]);
        *force += given.tension * (right - left);
    }
}

/// The largest shear force in the spans next to a node, including the largest shear force that the end moments of a span alone could
/// cause; under an axial force those of all its parts together. The rounding of a concentrated force is a share of this number.
pub(super) fn force_beside(given: &PiecewiseScene, spans: &[(usize, Span)], node: usize) -> f64 {
    let of = |(before, span): (usize, Option<&Span>)| {
        let Some(span) = span else { return 0.0 };
        let whole = || parts_before(spans, before).iter().map(|(_, part)| part.length()).sum();
        let length: f64 = if given.tension == 0.0 { span.length() } else { whole() };
        let of_moments = (span.beam_a[2].abs() + span.beam_b[2].abs()) / length;
        of_moments.max(span.beam_a[3].abs()).max(span.beam_b[3].abs())
    };
    [node, node + 1].into_iter().zip(ends(spans, node)).map(of).fold(0.0, f64::max)
}

/// Moments `−e v''` just to the left and just to the right of the nodes, with zero beyond the ends of the beam.
pub(super) fn moments(given: &PiecewiseScene, list: &List, spans: &[(usize, Span)]) -> Vec<[f64; 2]> {
    let of_zone = |zone: bool, cell: usize, x: f64| if zone { -given.bent(cell, x, 2) } else { 0.0 };
    let beside = |(i, node): (usize, &Node)| {
        let left = of_zone(list.in_zone_before(i), given.cell_to(node.x), node.x);
        [left, of_zone(list.in_zone_before(i + 1), given.cell_from(node.x), node.x)]
    };
    let mut moments: Vec<[f64; 2]> = list.nodes.iter().enumerate().map(beside).collect();
    for (i, span) in spans {
        if let Some(left) = i.checked_sub(1).filter(|_| span.a.hold != EndCondition::Within) {
            moments[left][1] = -span.beam_a[2];
        }
        if let Some(moment) = moments.get_mut(*i).filter(|_| span.b.hold != EndCondition::Within) {
            moment[0] = -span.beam_b[2];
        }
    }
    moments
}

/// The force on the inside of a zone: `∫ q − e u'''' + N u'' dx` with the point loads there, less the forces of elastic supports.
pub(super) fn zone_force(given: &PiecewiseScene, from: f64, to: f64) -> f64 {
    let (first, last) = (given.cell_from(from), given.cell_to(to));
    let loads = given.load_inside(from, to) + given.bent(first, from, 3) - given.bent(last, to, 3);
    let loads = given.springs_in_zone(from, to).fold(loads, |loads, (_, force)| loads - force);
    if given.tension == 0.0 {
        return loads;
    }
    loads + given.tension * (given.derivative(last, to, 1) - given.derivative(first, from, 1))
}

/// The equilibrium residual: the load less reactions and contact forces.
pub(super) fn unbalanced(given: &PiecewiseScene, list: &List, forces: &[f64]) -> f64 {
    let zones = list.zones().map(|zone| zone_force(given, zone.from, zone.to));
    let at_supports: f64 =
        given.supports.iter().map(|support| given.breakpoints[support.breakpoint].acts.force()).sum();
    let of = |support: bool| move |(node, _): &(&Node, &f64)| node.support(given).is_some() == support;
    let pairs = || list.nodes.iter().zip(forces);
    let carried = pairs().filter(of(true)).fold(given.resultant - at_supports, |rest, (_, force)| rest - force);
    carried - pairs().filter(of(false)).map(|(_, force)| force).sum::<f64>() - zones.sum::<f64>()
}

/// The moment by which the foundation and the support `index` would require tension between them; `jump` is the moment to the right of
/// the support less the moment to its left. A foundation to the right pushes the beam up and the support pulls it down: the jump is
/// negative. To the left it is positive. [`None`] if the foundation fixes the slope on neither side, or could on both, and for a
/// built-in support, which takes any moment.
pub(super) fn pulling_couple(given: &PiecewiseScene, index: usize, rests: [bool; 2], jump: f64) -> Option<f64> {
    let support = &given.supports[index];
    let pinned = rests.iter().position(|&rests| rests)?;
    match pinned {
        _ if support.slope.is_some() => None,
        1 => Some(jump),
        _ => Some(-jump),
    }
}
