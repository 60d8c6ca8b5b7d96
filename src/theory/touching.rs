//! Where the beam presses, and where it only lies on what it could press.
//!
//! A beam without weight on level ground lies on all of it and presses where its loads are. One answer has several lists of contacts
//! then, which differ in contacts without force. What presses, and where the beam lies without pressing, do not depend on the list:
//! they follow from forces and clearances.

use super::check::Nothing;
use super::exact::Exact;
use super::pattern::ContactKind;
use super::piece::{Piece, derivatives};
use super::piecewise::PiecewiseScene;
use super::summary::add_extremes;
use crate::state::{Contact, Regime, Touch};

/// Stretches shorter than this share of the beam are places.
const PLACE: f64 = 1e-9;

impl Exact {
    /// With what presses for its contacts, and where it lies without pressing beside them.
    pub(super) fn with_touches(mut self, nothing: &Nothing) -> Self {
        let pressing = self.contacts_by_kind();
        let ground = pressing.iter().filter(|(kind, _)| !matches!(kind, ContactKind::Bearing(_)));
        self.state.contacts = ground.map(|(_, contact)| *contact).collect();
        let contacts = &self.state.contacts;
        let presses = |listed: &&Contact| {
            let first = contacts.partition_point(|contact| contact.from < listed.from);
            contacts[first..].iter().take_while(|contact| contact.from <= listed.from).any(|contact| contact == *listed)
        };
        self.idle = self.listed.iter().filter(|listed| !presses(listed)).copied().collect();
        self.state.regime = Regime::of(&self.state.contacts);
        let pressed: Vec<Contact> = pressing.into_iter().map(|(_, contact)| contact).collect();
        self.state.touches = self.touches(&pressed, nothing);
        self
    }

    /// Where the beam lies without pressing: where a load drives it down, it presses or is clear, but for places at which a contact
    /// appears or goes just in this scene.
    fn touches(&self, pressed: &[Contact], nothing: &Nothing) -> Vec<Touch> {
        let (given, unit) = (&self.given, self.scale.length);
        if !given.has_obstacle() {
            return Vec::new();
        }
        let mut found =
            Lying { given, nothing, taylor: vec![0.0; given.terms], stretches: Vec::new(), places: Vec::new() };
        // Parts are made before they are looked at: not where a load drives all of the beam down.
        let looks = given.founded && (0..given.cells.len()).any(|cell| is_idle(given, cell));
        for piece in self.pieces.iter().filter(|_| looks) {
            for part in piece.parts(given).filter(|part| is_idle(given, part.cell)) {
                found.add(&part);
            }
        }
        let Lying { stretches, mut places, .. } = found;
        let mut touches = joined(stretches, PLACE * given.length);
        touches.retain(|touch| PLACE * given.length < touch[1] - touch[0]);
        places.extend(given.bearings.iter().map(|&bearing| given.breakpoints[bearing].x));
        places.sort_by(f64::total_cmp);
        let supports = given.supports.iter().map(|support| [given.breakpoints[support.breakpoint].x; 2]);
        let mut known: Vec<[f64; 2]> = pressed.iter().map(|contact| [contact.from / unit, contact.to / unit]).collect();
        known.extend(supports.chain(touches.iter().copied()));
        for x in places {
            if self.is_near_ground(x, nothing) && !self.is_one_with(x, &known, nothing) {
                known.push([x; 2]);
                touches.push([x; 2]);
            }
        }
        touches.sort_by(|a, b| a[0].total_cmp(&b[0]));
        touches.into_iter().map(|[from, to]| Touch { from: from * unit, to: to * unit }).collect()
    }

    /// True if the beam is off what is below it by rounding.
    fn is_near_ground(&self, x: f64, nothing: &Nothing) -> bool {
        self.clearance(x * self.scale.length) <= nothing.depth * self.scale.depth
    }

    /// True if the beam is not clear of the ground between a place and the nearest one on either side of those that it touches already.
    fn is_one_with(&self, x: f64, known: &[[f64; 2]], nothing: &Nothing) -> bool {
        let nearest = |distance: fn(f64, &[f64; 2]) -> f64| {
            let distances = known.iter().map(|known| distance(x, known)).filter(|distance| 0.0 <= *distance);
            distances.fold(f64::INFINITY, f64::min)
        };
        let [before, beyond] = [nearest(|x, [_, to]| x - to), nearest(|x, [from, _]| from - x)];
        let inside = known.iter().any(|[from, to]| *from <= x && x <= *to);
        let is_one = |distance: f64, way: f64| {
            distance <= PLACE * self.given.length
                || distance.is_finite() && self.is_near_ground(x + 0.5 * way * distance, nothing)
        };
        inside || is_one(before, -1.0) || is_one(beyond, 1.0)
    }
}

/// True if no load drives the beam down over a cell.
fn is_idle(given: &PiecewiseScene, cell: usize) -> bool {
    let cell = &given.cells[cell];
    cell.load == 0.0 && cell.load_slope == 0.0
}

/// Stretches and places at which a beam without load is on the ground.
struct Lying<'a> {
    given: &'a PiecewiseScene,
    nothing: &'a Nothing,
    taylor: Vec<f64>,
    stretches: Vec<[f64; 2]>,
    places: Vec<f64>,
}

impl Lying<'_> {
    /// Adds those of a part of the beam in one cell: all of it, if it is bent as the ground is, or where it comes nearest.
    fn add(&mut self, part: &Piece) {
        if part.state.is_none() {
            // In a zone; where it presses, the ground bends the beam.
            let is_straight = self.given.drive(part.cell, 0.5 * (part.lo + part.hi)) == 0.0;
            self.stretches.extend(is_straight.then_some([part.lo, part.hi]));
            return;
        }
        part.clearance(self.given, &mut self.taylor);
        let ends = [part.lo, part.hi].map(|x| derivatives(&self.taylor, x - part.anchor));
        if ends.iter().all(|[h, _, bend, _]| h.abs() <= self.nothing.depth && bend.abs() <= self.nothing.bend) {
            return self.stretches.push([part.lo, part.hi]);
        }
        part.outwards(&mut self.taylor);
        // Only what goes below the lower end is looked for inside.
        let least = ends[0][0].min(ends[1][0]);
        let mut values = Vec::new();
        add_extremes(part, &self.taylor, [least, f64::INFINITY], &mut values);
        self.places.extend(values.into_iter().filter(|(_, h)| *h <= self.nothing.depth).map(|(x, _)| x));
    }
}

/// Stretches in the place of those that follow each other.
fn joined(mut stretches: Vec<[f64; 2]>, gap: f64) -> Vec<[f64; 2]> {
    stretches.sort_by(|a, b| a[0].total_cmp(&b[0]));
    stretches.dedup_by(|next, last| {
        let joins = next[0] <= last[1] + gap;
        last[1] = if joins { last[1].max(next[1]) } else { last[1] };
        joins
    });
    stretches
}
