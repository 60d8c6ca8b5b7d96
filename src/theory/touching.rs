//! Where the beam presses, and where it only touches without pressing.
//!
//! A beam without weight on a level foundation touches it along its whole length and presses where its loads are. One answer then has
//! several contact lists, which differ in contacts without force. The pressing contacts and the touching stretches do not depend on the
//! list: they follow from forces and clearances.

use super::check::Nothing;
use super::exact::Exact;
use super::pattern::ContactKind;
use super::piece::{Piece, derivatives};
use super::piecewise::PiecewiseScene;
use super::summary::add_extremes;
use crate::state::{Contact, Regime, Touch};

/// Length as a share of the beam below which a stretch counts as a point.
const PLACE: f64 = 1e-9;

impl Exact {
    /// Replaces its contacts by the pressing ones, and adds the stretches and points where it touches without pressing.
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

    /// Where the beam touches without pressing. Under a load that drives it down it presses or is clear, except at positions where a
    /// contact begins or ends just in this scene.
    fn touches(&self, pressed: &[Contact], nothing: &Nothing) -> Vec<Touch> {
        let (given, unit) = (&self.given, self.units.length);
        if !given.has_obstacle() {
            return Vec::new();
        }
        let mut found =
            Lying { given, nothing, taylor: vec![0.0; given.terms], stretches: Vec::new(), places: Vec::new() };
        // Parts are made only if some cell has no load that drives the beam down.
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

    /// Whether the clearance of the beam at a position is rounding.
    fn is_near_ground(&self, x: f64, nothing: &Nothing) -> bool {
        self.clearance(x * self.units.length) <= nothing.depth * self.units.depth
    }

    /// Whether the beam has no clearance between a position and the nearest known contact on either side.
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

/// Whether a cell has no load that drives the beam down.
fn is_idle(given: &PiecewiseScene, cell: usize) -> bool {
    let cell = &given.cells[cell];
    cell.load == 0.0 && cell.load_slope == 0.0
}

/// Stretches and points at which a beam without load touches the foundation.
struct Lying<'a> {
    given: &'a PiecewiseScene,
    nothing: &'a Nothing,
    taylor: Vec<f64>,
    stretches: Vec<[f64; 2]>,
    places: Vec<f64>,
}

impl Lying<'_> {
    /// Adds the contact of a part of the beam in one cell: the whole part if it is bent like the foundation, or the points where it is
    /// closest.
    fn add(&mut self, part: &Piece) {
        if part.state.is_none() {
            // In a zone: the beam touches without pressing where its pressure is zero.
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
        // Inside, only values below the lower end value matter.
        let least = ends[0][0].min(ends[1][0]);
        let mut values = Vec::new();
        add_extremes(part, &self.taylor, [least, f64::INFINITY], &mut values);
        self.places.extend(values.into_iter().filter(|(_, h)| *h <= self.nothing.depth).map(|(x, _)| x));
    }
}

/// Joins stretches that follow each other.
fn joined(mut stretches: Vec<[f64; 2]>, gap: f64) -> Vec<[f64; 2]> {
    stretches.sort_by(|a, b| a[0].total_cmp(&b[0]));
    stretches.dedup_by(|next, last| {
        let joins = next[0] <= last[1] + gap;
        last[1] = if joins { last[1].max(next[1]) } else { last[1] };
        joins
    });
    stretches
}
