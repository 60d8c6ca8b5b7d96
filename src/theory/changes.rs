//! Further properties of an answer in addition to its contacts.

use super::exact::Exact;
use super::piecewise::Cell;
use super::span::Span;
use crate::state::Contact;

impl Exact {
    /// `v''` to the left and to the right of a node; in a zone the second derivative of the gap, and zero beyond the ends of the beam.
    pub(super) fn curvatures_beside(&self, i: usize) -> [f64; 2] {
        let (given, x) = (&self.given, self.list.nodes[i].x);
        let [left, right] = super::sensitivity::ends(&self.spans, i);
        let zone = |before: usize, cell: usize| {
            if self.list.in_zone_before(before) { given.derivative(cell, x, 2) } else { 0.0 }
        };
        [
            left.map_or_else(|| zone(i, given.cell_to(x)), |span| span.beam_b[2]),
            right.map_or_else(|| zone(i + 1, given.cell_from(x)), |span| span.beam_a[2]),
        ]
    }

    /// Whether part of a zone has no load that presses the beam onto the foundation, or the beam has no clearance between two nodes.
    /// One answer then has several contact lists. On an elastic foundation there is no list.
    pub(super) fn lies_without_load(&self) -> bool {
        let mut zones = self.listed.iter().filter(|contact| contact.from < contact.to);
        let along = |span: &Span| span.at_a.iter().chain(&span.at_b).all(|h| *h == 0.0);
        self.springs.is_none()
            && (zones.any(|zone| self.is_idle(zone)) || self.spans.iter().any(|(_, span)| along(span)))
    }

    fn is_idle(&self, contact: &Contact) -> bool {
        let given = &self.given;
        let straight = |shape: usize| given.shapes[shape].degree().is_some_and(|degree| degree < 4);
        let idle = |cell: &Cell| cell.load == 0.0 && cell.load_slope == 0.0 && straight(cell.shape);
        let [from, to] = [contact.from, contact.to].map(|x| x / self.units.length);
        given.cells.get(given.cell_to(from)..=given.cell_from(to)).is_some_and(|cells| cells.iter().any(idle))
    }
}
