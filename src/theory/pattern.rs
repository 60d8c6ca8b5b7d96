//! What an answer is made of, without its numbers: between two scenes with the same pattern nothing happens.

use super::exact::Exact;
use super::list::{Beside, Kind};
use super::piecewise::PiecewiseScene;

/// The kind of an exact solution.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Pattern {
    /// What each of its contacts is, in their order.
    pub touches: Vec<Touch>,
    /// Whether the ground holds the slope of the beam beside each support, to its left and to its right.
    pub clamped: Vec<[bool; 2]>,
    /// Which of the supports pull the beam down.
    pub pulls: Vec<bool>,
    /// Smooth pieces of the profile; where this is another number, their indices mean something else.
    pieces: usize,
}

/// A contact.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Touch {
    /// A point on the smooth piece of that index.
    Point(usize),
    /// The edge at which the smooth piece of that index starts, or a free end of the beam.
    Edge(usize),
    /// A zone.
    Zone([ZoneEnd; 2]),
}

/// How a zone of contact ends.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ZoneEnd {
    /// Where the beam lifts off, on the smooth piece of that index.
    LiftOff(usize),
    /// At the support of that index.
    Support(usize),
    /// At a free end of the beam.
    FreeEnd,
}

/// A force that is smaller than this share of the largest one has no sign.
const NO_FORCE: f64 = 1e-12;

impl Pattern {
    /// True if nothing happens between two scenes that differ in numbers only and have these patterns.
    #[must_use]
    pub fn is_same(&self, other: &Self) -> bool {
        if self.pieces == other.pieces {
            return self == other;
        }
        // Points of a survey that come to lie on one line are one piece less.
        let kinds = |touches: &[Touch]| touches.iter().map(|touch| matches!(touch, Touch::Zone(_))).collect::<Vec<_>>();
        self.clamped == other.clamped && self.pulls == other.pulls && kinds(&self.touches) == kinds(&other.touches)
    }
}

impl Exact {
    /// Its pattern.
    #[must_use]
    pub fn pattern(&self) -> Pattern {
        let (given, nodes) = (&self.given, &self.list.nodes);
        let mut touches = Vec::with_capacity(self.state.contacts.len());
        let mut clamped = Vec::with_capacity(given.supports.len());
        for i in 0..=nodes.len() {
            if self.list.in_zone_before(i) {
                touches.push(Touch::Zone([i - 1, i].map(|end| zone_end(given, nodes[end].kind, nodes[end].cell))));
            }
            match nodes.get(i).map(|node| (node.kind, node.cell)) {
                Some((Kind::Smooth, cell)) => touches.push(Touch::Point(given.cells[cell].shape)),
                Some((Kind::Edge(breakpoint), _)) => touches.push(Touch::Edge(edge(given, breakpoint))),
                Some((Kind::Support(_, beside), _)) => clamped.push(beside.map(|side| side == Beside::Clamped)),
                _ => {}
            }
        }
        let supports = &self.state.supports;
        let contacts = self.state.contacts.iter().map(|c| c.force);
        let largest = supports.iter().map(|s| s.force).chain(contacts).fold(0.0, |most: f64, f| most.max(f.abs()));
        let pulls = supports.iter().map(|s| s.force < -NO_FORCE * largest).collect();
        Pattern { touches, clamped, pulls, pieces: given.shapes.len() }
    }
}

fn zone_end(given: &PiecewiseScene, kind: Kind, cell: usize) -> ZoneEnd {
    match kind {
        Kind::Support(index, _) => ZoneEnd::Support(index),
        Kind::Tip => ZoneEnd::FreeEnd,
        _ => ZoneEnd::LiftOff(given.cells[cell].shape),
    }
}

/// The piece of the profile that starts at an edge; one more than there are for the right end of the beam.
fn edge(given: &PiecewiseScene, breakpoint: usize) -> usize {
    given.cells.get(breakpoint).map_or(given.shapes.len(), |cell| cell.shape)
}
