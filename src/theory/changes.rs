//! What is asked of an answer beside its contacts.

use super::exact::Exact;
use super::piecewise::Cell;
use super::span::Span;
use crate::state::Contact;

impl Exact {
    /// `v''` to the left and to the right of a node, that of the ground in a zone, and zero where there is no beam.
    pub(super) fn bends(&self, i: usize) -> [f64; 2] {
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

    /// True if a zone of the list lies in part where no load drives the beam onto the ground, or the beam is nowhere off the ground between
    /// two nodes: one answer has several lists of contacts there. On ground that gives there is no list.
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
        let [from, to] = [contact.from, contact.to].map(|x| x / self.scale.length);
        given.cells.get(given.cell_to(from)..=given.cell_from(to)).is_some_and(|cells| cells.iter().any(idle))
    }
}
