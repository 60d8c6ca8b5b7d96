//! Forces that follow from the spans, at the contacts and beside the supports, and their balance.

use super::given::Given;
use super::list::{AtSupport, List};
use super::span::Span;

/// Concentrated forces at the nodes, `R = P + v'''(x−) − v'''(x+)`, and the shear force `−v'''` beside the supports.
pub(super) fn forces(given: &Given, list: &List, spans: &[(usize, Span)]) -> (Vec<f64>, [f64; 2]) {
    // A profile with edges is made of straight lines: u''' is the same on both sides of every node, and h''' will do.
    let mut forces: Vec<f64> = list.nodes.iter().map(|node| given.force_at(node.x, node.cell)).collect();
    let mut in_beam = vec![[None; 2]; forces.len()];
    let last = given.cells.len() - 1;
    let mut shear = [-given.derivative(0, 0.0, 3), -given.derivative(last, given.length, 3)];
    for (i, span) in spans {
        match i.checked_sub(1) {
            Some(left) => {
                forces[left] += span.at_a[3];
                in_beam[left][0] = span.in_beam.then_some(span.beam_a[3]);
            }
            None => shear[0] = -span.beam_a[3],
        }
        match forces.get_mut(*i) {
            Some(force) => {
                *force -= span.at_b[3];
                in_beam[*i][1] = span.in_beam.then_some(span.beam_b[3]);
            }
            None => shear[1] = -span.beam_b[3],
        }
    }
    for ((force, node), sides) in forces.iter_mut().zip(&list.nodes).zip(in_beam) {
        if let [Some(right), Some(left)] = sides {
            *force = given.force_at(node.x, node.cell) + left - right;
        }
    }
    (forces, shear)
}

/// `∫ q − u'''' dx` over the inside of a zone, with the point loads there.
pub(super) fn zone_force(given: &Given, from: f64, to: f64) -> f64 {
    let (first, last) = (given.cell_from(from), given.cell_to(to));
    let mut sum = 0.0;
    for cell in first..=last.max(first) {
        let c = &given.cells[cell];
        let (lo, hi) = (c.lo.max(from), c.hi.min(to));
        if lo < hi {
            sum += 0.5 * (given.load(cell, lo) + given.load(cell, hi)) * (hi - lo);
        }
    }
    sum += given.joints_inside(from, to).map(|j| given.joints[j].force).sum::<f64>();
    sum + given.derivative(first, from, 3) - given.derivative(last, to, 3)
}

/// What is left of the load when reactions and contact forces are taken off.
pub(super) fn unbalanced(given: &Given, list: &List, forces: &[f64], shear: &[f64; 2]) -> f64 {
    let zones = list.zones(given).into_iter().map(|(from, to)| zone_force(given, from, to));
    let at_supports = [given.joints.first(), given.joints.last()].into_iter().flatten().map(|j| j.force).sum::<f64>();
    given.resultant - at_supports - shear[0] + shear[1] - forces.iter().sum::<f64>() - zones.sum::<f64>()
}

/// The moment `−v''` that foundation and support exert on the beam at a support together; it may only be negative.
pub(super) fn couple(given: &Given, list: &List, spans: &[(usize, Span)], support: usize) -> Option<f64> {
    let (cell, x) = if support == 0 { (0, 0.0) } else { (given.cells.len() - 1, given.length) };
    let bend = given.derivative(cell, x, 2);
    match list.supports[support] {
        AtSupport::Free => None,
        AtSupport::Zone => Some(-bend),
        AtSupport::Clamped => {
            let (_, span) = if support == 0 { spans.first()? } else { spans.last()? };
            Some(if support == 0 { span.at_a[2] } else { span.at_b[2] } - bend)
        }
    }
}
