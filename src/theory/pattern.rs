//! What an answer is made of, without its numbers: between two scenes with the same pattern nothing happens.

use super::exact::Exact;
use super::list::{Beside, Kind};
use super::piecewise::PiecewiseScene;
use crate::state::Contact;

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

/// Places that are nearer to each other than this share of the beam are one.
const AT_ONE_PLACE: f64 = 1e-12;

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
        let supports = nodes.iter().enumerate().filter_map(|(i, node)| match node.kind {
            Kind::Support(index, beside) => Some(self.clamped(i, index, beside)),
            _ => None,
        });
        let least = NO_FORCE * self.largest_force();
        let pulls = self.state.supports.iter().map(|s| s.force < -least).collect();
        Pattern {
            touches: self.touches().into_iter().map(|(touch, _)| touch).collect(),
            clamped: supports.collect(),
            pulls,
            pieces: given.shapes.len(),
        }
    }

    /// What carries something, with its contact: a contact without a force is none, and a zone goes no farther than its pressure.
    pub(crate) fn touches(&self) -> Vec<(Touch, Contact)> {
        let (given, nodes) = (&self.given, &self.list.nodes);
        let least = NO_FORCE * self.largest_force();
        let mut contacts = self.state.contacts.iter();
        let mut touches = Vec::with_capacity(contacts.len());
        for i in 0..=nodes.len() {
            if self.list.in_zone_before(i) {
                touches.extend(contacts.next().into_iter().flat_map(|contact| self.pressed(i, *contact, least)));
            }
            let Some(node) = nodes.get(i) else { continue };
            let touch = match node.kind {
                Kind::Smooth => Touch::Point(given.cells[node.cell].shape),
                Kind::Edge(breakpoint) => Touch::Edge(edge(given, breakpoint)),
                _ => continue,
            };
            touches.extend(contacts.next().filter(|contact| least < contact.force).map(|contact| (touch, *contact)));
        }
        touches
    }

    /// What carries something of the zone before node `i`: the stretches with a pressure, and the places with a force.
    fn pressed(&self, i: usize, contact: Contact, least: f64) -> Vec<(Touch, Contact)> {
        let (given, unit) = (&self.given, self.scale.length);
        let nodes = [&self.list.nodes[i - 1], &self.list.nodes[i]];
        let [from, to] = nodes.map(|node| node.x);
        let within = |x: f64| x.max(from).min(to);
        let presses = |cell: usize| {
            let [lo, hi] = [given.cells[cell].lo, given.cells[cell].hi].map(within);
            let places = [lo, 0.5 * (lo + hi), hi].into_iter();
            let most = places.fold(0.0, |most: f64, x| most.max(given.drive(cell, x).abs()));
            (lo < hi && least < most * given.length * self.stiffness * self.scale.force).then_some([lo, hi])
        };
        let (first, last) = (given.cell_from(from), given.cell_to(to));
        let loads = given.breakpoints_inside(from, to).map(|i| &given.breakpoints[i]).filter(|b| b.force != 0.0);
        // Of the force at a support only the sum with that of the support is unique.
        let ends = [i - 1, i].into_iter().filter(|&end| {
            self.list.nodes[end].support().is_none() && least < self.forces[end] * self.stiffness * self.scale.force
        });
        let mut pieces: Vec<[f64; 2]> = (first..=last).filter_map(presses).collect();
        pieces.extend(loads.map(|breakpoint| [breakpoint.x; 2]));
        pieces.extend(ends.map(|end| [self.list.nodes[end].x; 2]));
        pieces.sort_by(|a, b| a[0].total_cmp(&b[0]));
        pieces.dedup_by(|next, last| {
            let joined = next[0] <= last[1] + AT_ONE_PLACE * given.length;
            last[1] = if joined { last[1].max(next[1]) } else { last[1] };
            joined
        });
        let shape = |x: f64| given.cells[given.cell_from(x).clamp(first, last)].shape;
        let end = |x: f64| nodes.into_iter().find(|node| (node.x - x).abs() <= AT_ONE_PLACE * given.length);
        let touch = |[from, to]: [f64; 2]| {
            if AT_ONE_PLACE * given.length < to - from {
                let ends =
                    [from, to].map(|x| end(x).map_or(ZoneEnd::LiftOff(shape(x)), |n| zone_end(given, n.kind, n.cell)));
                return Touch::Zone(ends);
            }
            match end(from).map(|node| node.kind) {
                Some(Kind::Tip) => Touch::Edge(edge(given, if from <= 0.0 { 0 } else { given.cells.len() })),
                _ => Touch::Point(shape(from)),
            }
        };
        let piece = |ends: [f64; 2]| (touch(ends), Contact { from: ends[0] * unit, to: ends[1] * unit, ..contact });
        pieces.into_iter().map(piece).collect()
    }

    /// On which sides of a support the ground holds the slope of the beam, and takes a couple for it.
    fn clamped(&self, i: usize, index: usize, beside: [Beside; 2]) -> [bool; 2] {
        let support = &self.given.supports[index];
        if support.slope.is_some() && !support.built_in {
            return [true; 2];
        }
        let sides = super::sensitivity::ends(&self.spans, i);
        let [left, right] = [sides[0].map_or(0.0, |span| span.beam_b[2]), sides[1].map_or(0.0, |span| span.beam_a[2])];
        let lever = NO_FORCE * self.largest_force() * self.given.length / (self.stiffness * self.scale.force);
        let couple = lever < (right - left).abs();
        beside.map(|side| side == Beside::Clamped && couple)
    }

    fn largest_force(&self) -> f64 {
        let contacts = self.state.contacts.iter().map(|c| c.force);
        let supports = self.state.supports.iter().map(|s| s.force);
        supports.chain(contacts).fold(0.0, |most: f64, force| most.max(force.abs()))
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
