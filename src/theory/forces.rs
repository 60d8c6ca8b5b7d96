//! Forces that follow from the spans: at the contacts and beside the supports.

use super::given::Given;
use super::list::List;
use super::span::Span;

/// Concentrated forces at the nodes, `R = P + v'''(x−) − v'''(x+)`, and the shear force `−v'''` beside the supports.
pub(super) fn forces(given: &Given, list: &List, spans: &[(usize, Span)]) -> (Vec<f64>, [f64; 2]) {
    // A profile with edges is made of straight lines: u''' is the same on both sides of every node, and h''' will do.
    let mut forces: Vec<f64> = list.nodes.iter().map(|node| given.force_at(node.x)).collect();
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
            *force = given.force_at(node.x) + left - right;
        }
    }
    (forces, shear)
}

/// `∫ q − u'''' dx` over the inside of a zone, with the point loads there.
pub(super) fn zone_force(given: &Given, from: f64, to: f64) -> f64 {
    let (first, last) = (given.cell_from(from), given.cell_to(to));
    let mut sum = 0.0;
    for cell in first..=last {
        let c = &given.cells[cell];
        let (lo, hi) = (c.lo.max(from), c.hi.min(to));
        if lo < hi {
            sum += 0.5 * (given.load(cell, lo) + given.load(cell, hi)) * (hi - lo);
        }
    }
    sum += given.joints.iter().filter(|j| from < j.x && j.x < to).map(|j| j.force).sum::<f64>();
    sum + given.derivative(first, from, 3) - given.derivative(last, to, 3)
}
