//! What of a list carries something: a contact without a force is none, and a zone goes no farther than its pressure.
//!
//! Where no load drives the beam onto the ground that it lies on, one answer has several lists of contacts. What carries is the same
//! in all of them, and that is what an answer says.

use super::check::Checked;
use super::exact::Exact;
use super::forces::{force_beside, zone_force};
use super::list::{List, Node};
use super::pattern::{Touch, ZoneEnd};
use super::piecewise::PiecewiseScene;
use super::span::Span;
use crate::scene::Scale;
use crate::state::Contact;

/// A contact that carries something.
#[derive(Debug, Clone, Copy)]
pub(super) struct Carried {
    /// What it is.
    pub(super) touch: Touch,
    /// Dimensionless, forces over `EI`.
    contact: Contact,
    /// Its node, of a zone that to its right.
    pub(super) node: usize,
    /// True for a zone, or a part of one.
    pub(super) in_zone: bool,
    /// False for a part of a zone that goes on without pressure.
    pub(super) whole: bool,
}

impl Carried {
    /// The contact in the units of the scene.
    pub(super) fn contact(&self, scale: &Scale, stiffness: f64) -> Contact {
        let force = |force: f64| force * stiffness * scale.force;
        let Contact { from, to, force: all, end_forces } = self.contact;
        Contact {
            from: from * scale.length,
            to: to * scale.length,
            force: force(all),
            end_forces: end_forces.map(|ends| ends.map(force)),
        }
    }
}

impl Exact {
    /// Where the beam rests without being held, whether that carries something or not: the witness of a certificate. A zone is said to
    /// have no force.
    #[must_use]
    pub fn touched(&self) -> Vec<Contact> {
        if self.springs.is_some() {
            return self.state.touched();
        }
        let (given, nodes) = (&self.given, &self.list.nodes);
        let place = |i: usize| on_the_beam(nodes[i].x, given.length) * self.scale.length;
        let mut all = Vec::with_capacity(nodes.len());
        for i in 0..=nodes.len() {
            if self.list.in_zone_before(i) {
                all.push(Contact { to: place(i), ..Contact::at(place(i - 1), 0.0) });
            }
            let rests = |node: &Node| node.is_ground(given) || node.is_point(given) && 0.0 < self.forces[i];
            let contact = |_| Contact::at(place(i), self.forces[i] * self.stiffness * self.scale.force);
            all.extend(nodes.get(i).filter(|node| rests(node)).map(contact));
        }
        all
    }
}

/// A force that is smaller than this share of the forces beside it has no sign. Forces elsewhere say nothing of it: behind a support a
/// load of any size may stand.
pub(super) const NO_FORCE: f64 = 1e-12;

/// Forces are compared with this share of all loads at least, but for those that stand on supports: beside a stretch without a load
/// there are none.
const AT_REST: f64 = 1e-3;

/// Places that are nearer to each other than this share of the beam are one.
pub(super) const AT_ONE_PLACE: f64 = 1e-12;

/// What forces are compared with at least, over `EI`.
pub(super) fn rest(given: &PiecewiseScene) -> f64 {
    AT_REST * given.total_load
}

/// A force at node `i` that is no larger has no sign, over `EI`.
pub(super) fn no_force(given: &PiecewiseScene, spans: &[(usize, Span)], i: usize) -> f64 {
    NO_FORCE * force_beside(spans, i).max(rest(given))
}

/// What carries something, from left to right.
pub(super) fn carried(given: &PiecewiseScene, list: &List, checked: &Checked) -> Vec<Carried> {
    let mut all = Vec::with_capacity(list.nodes.len());
    for i in 0..=list.nodes.len() {
        if list.in_zone_before(i) {
            all.extend(pressed(given, list, checked, i));
        }
        let Some(node) = list.nodes.get(i) else { continue };
        let touch = match node.breakpoint {
            None if node.is_smooth() => Touch::Point(given.cells[node.cell].shape),
            Some(breakpoint) if node.is_edge(given) => match given.bearings.binary_search(&breakpoint) {
                Ok(bearing) => Touch::Bearing(bearing),
                Err(_) => Touch::Edge(edge(given, breakpoint)),
            },
            _ => continue,
        };
        let force = checked.forces[i];
        if no_force(given, &checked.spans, i) < force.abs() {
            let contact = Contact::at(on_the_beam(node.x, given.length), force);
            all.push(Carried { touch, contact, node: i, in_zone: false, whole: true });
        }
    }
    all
}

/// What carries something of the zone before node `i`: the stretches with a pressure, and the places with a force.
fn pressed(given: &PiecewiseScene, list: &List, checked: &Checked, i: usize) -> Vec<Carried> {
    let both = [i - 1, i];
    let at = |end: usize| &list.nodes[end];
    let [from, to] = both.map(|end| at(end).x);
    let within = |x: f64| x.max(from).min(to);
    // Of the force at a support only the sum with that of the support is unique, and the support is said to take all.
    let held = |end: usize| if at(end).support(given).is_some() { 0.0 } else { checked.forces[end] };
    let whole = zone_force(given, from, to) + held(i - 1) + held(i);
    let least = both.map(|end| no_force(given, &checked.spans, end)).into_iter().fold(NO_FORCE * whole.abs(), f64::max);
    let presses = |cell: usize| {
        let [lo, hi] = [given.cells[cell].lo, given.cells[cell].hi].map(within);
        let places = [lo, 0.5 * (lo + hi), hi].into_iter();
        let most = places.fold(0.0, |most: f64, x| most.max(given.drive(cell, x).abs()));
        (lo < hi && least < most * given.length).then_some([lo, hi])
    };
    let (first, last) = (given.cell_from(from), given.cell_to(to));
    let loads = || given.breakpoints_inside(from, to).map(|i| &given.breakpoints[i]).filter(|b| b.force != 0.0);
    let ends = both.into_iter().filter(|&end| least < held(end).abs());
    let mut pieces: Vec<[f64; 2]> = (first..=last).filter_map(presses).collect();
    pieces.extend(loads().map(|breakpoint| [breakpoint.x; 2]));
    pieces.extend(ends.map(|end| [at(end).x; 2]));
    pieces.sort_by(|a, b| a[0].total_cmp(&b[0]));
    pieces.dedup_by(|next, last| {
        let joined = next[0] <= last[1] + AT_ONE_PLACE * given.length;
        last[1] = if joined { last[1].max(next[1]) } else { last[1] };
        joined
    });
    let shape = |x: f64| given.cells[given.cell_from(x).clamp(first, last)].shape;
    let node_at = |x: f64| both.into_iter().find(|&end| (at(end).x - x).abs() <= AT_ONE_PLACE * given.length);
    // A load inside the zone goes into the ground just where it stands.
    let inside = |lo: f64, hi: f64| loads().filter(move |b| lo <= b.x && b.x <= hi).map(|b| b.force).sum::<f64>();
    // At the border of two regimes a zone has no length: it is a point.
    let is_short = to - from <= AT_ONE_PLACE * given.length;
    let carried = |piece: [f64; 2]| {
        let ends = piece.map(node_at);
        let [from, to] = [0, 1].map(|side| ends[side].map_or(piece[side], |end| at(end).x));
        let [left, right] = [from, to].map(|x| on_the_beam(x, given.length));
        if AT_ONE_PLACE * given.length < to - from {
            let kind = |x: f64, end: Option<usize>| match end.map(at) {
                Some(node) => zone_end(given, node),
                None => ZoneEnd::LiftOff(shape(x)),
            };
            let touch = Touch::Zone([kind(from, ends[0]), kind(to, ends[1])]);
            let end_forces = [(from, ends[0]), (to, ends[1])].map(|(x, end)| end.map_or_else(|| inside(x, x), held));
            let force = end_forces[0] + end_forces[1] + zone_force(given, from, to);
            let contact = Contact { from: left, to: right, force, end_forces: Some(end_forces) };
            let whole = ends == both.map(Some);
            return Carried { touch, contact, node: i, in_zone: true, whole };
        }
        let tip = ends[0].map(at).filter(|node| node.is_tip(given)).and_then(|tip| tip.breakpoint);
        let touch = tip.map_or_else(|| Touch::Point(shape(from)), |tip| Touch::Edge(edge(given, tip)));
        let force = if is_short { whole } else { ends[0].map_or(0.0, held) + inside(piece[0], piece[1]) };
        Carried { touch, contact: Contact::at(left, force), node: i, in_zone: true, whole: is_short }
    };
    pieces.into_iter().map(carried).collect()
}

fn zone_end(given: &PiecewiseScene, node: &Node) -> ZoneEnd {
    match node.support(given) {
        Some(index) => ZoneEnd::Support(index),
        None if node.can_move() => ZoneEnd::LiftOff(given.cells[node.cell].shape),
        None => ZoneEnd::FreeEnd,
    }
}

/// The piece of the profile that starts at an edge; one more than there are for the right end of the beam.
fn edge(given: &PiecewiseScene, breakpoint: usize) -> usize {
    given.cells.get(breakpoint).map_or(given.shapes.len(), |cell| cell.shape)
}

/// A place beside a support that rounding has put off the beam, on it.
fn on_the_beam(x: f64, length: f64) -> f64 {
    /// That of the check, which takes a contact that would have to move by less for being where it should be.
    const ROUNDING: f64 = 4e-15;
    let nearest = x.clamp(0.0, length);
    if (x - nearest).abs() <= ROUNDING * length { nearest } else { x }
}
