//! The pattern of an answer: its kinds of contacts without their numbers. Between two scenes with the same pattern no contact changes its
//! kind.

use super::check::{AT_REST, TOLERANCE};
use super::exact::Exact;
use super::forces::{force_beside, zone_force};
use super::list::Node;
use super::piecewise::PiecewiseScene;
use super::shape::Wave;
use crate::state::{Contact, SupportForce};

/// The kind of an exact solution.
#[derive(Debug, Clone, PartialEq)]
pub struct Pattern {
    /// The kinds of its contacts, in their order.
    pub(crate) kinds: Vec<ContactKind>,
    /// Whether the foundation restrains the slope of the beam next to each support, on its left and on its right.
    pub(crate) clamped: Vec<[bool; 2]>,
    /// Whether each of the supports pulls the beam down.
    pub(crate) pulls: Vec<bool>,
    /// The crest of each contact.
    crests: Vec<Crest>,
    /// Number of smooth pieces of the profile; the indices of two patterns are comparable only if these numbers are equal.
    pieces: usize,
}

/// The position of a contact on a smooth piece: two contacts of one kind are the same one only if they are near each other.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Crest {
    /// Start and end of the contact, as shares of the beam.
    ends: [f64; 2],
    /// Number of waves of the profile to the left of both, for the wave with the largest curvature; 0 without waves.
    waves: [f64; 2],
}

impl Crest {
    /// Whether this may be the same contact as another one after a small motion, shorter than from one crest to the next.
    fn is_near(&self, other: &Self) -> bool {
        let less = |a: [f64; 2], b: [f64; 2], most: f64| a.iter().zip(b).all(|(a, b)| (a - b).abs() <= most);
        less(self.ends, other.ends, NEAR) && less(self.waves, other.waves, HALF_A_WAVE)
    }
}

/// A contact that moves farther than this share of the beam may be another one.
const NEAR: f64 = 0.02;
/// Waves from a crest to the next hollow: beyond it the next crest is nearer.
const HALF_A_WAVE: f64 = 0.5;

/// The kind of a contact.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum ContactKind {
    /// A point on the smooth piece of that index.
    Point(usize),
    /// The edge at which the smooth piece of that index starts, or a free end of the beam.
    Edge(usize),
    /// The compression-only support of that index, counted among the compression-only supports.
    Bearing(usize),
    /// A zone.
    Zone([ZoneEnd; 2]),
}

/// The kind of an end of a contact zone.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum ZoneEnd {
    /// A lift-off position, on the smooth piece of that index.
    LiftOff(usize),
    /// The support of that index.
    Support(usize),
    /// A free end of the beam.
    FreeEnd,
}

/// Positions that are nearer to each other than this share of the beam count as one.
const AT_ONE_PLACE: f64 = 1e-12;

impl Pattern {
    /// Whether no contact changes between two scenes with these patterns that differ only a little, and only in numbers: the contacts are
    /// of the same kinds, and on the same crests.
    #[must_use]
    pub fn is_same(&self, other: &Self) -> bool {
        self.is_same_kind(other) && self.crests.iter().zip(&other.crests).all(|(a, b)| a.is_near(b))
    }

    /// Whether the contacts of two answers are of the same kinds, regardless of their positions on their smooth pieces of the profile.
    #[must_use]
    pub fn is_same_kind(&self, other: &Self) -> bool {
        if self.clamped != other.clamped || self.pulls != other.pulls {
            return false;
        }
        if self.pieces == other.pieces {
            return self.kinds == other.kinds;
        }
        // If points of a survey become collinear, there is one piece less.
        let zones =
            |kinds: &[ContactKind]| kinds.iter().map(|kind| matches!(kind, ContactKind::Zone(_))).collect::<Vec<_>>();
        zones(&self.kinds) == zones(&other.kinds)
    }
}

impl Exact {
    /// The pattern of this solution.
    #[must_use]
    pub fn pattern(&self) -> Pattern {
        let (given, nodes, rest) = (&self.given, &self.list.nodes, self.rest());
        let clamped = |(i, node): (usize, &Node)| Some(self.clamped(i, node.support(given)?, rest));
        let mut clamped = nodes.iter().enumerate().filter_map(clamped);
        let holding: Vec<_> = self.state.supports.iter().filter(|support| !support.pushes_only).collect();
        let firm: Vec<_> = holding.iter().filter(|support| !self.gives(support.at)).collect();
        let mut pulling = nodes.iter().enumerate().filter_map(|(i, node)| {
            let support = firm.get(node.support(given)?)?;
            Some(support.force < -self.no_force(i, rest).max(TOLERANCE * self.load_on(node)))
        });
        let (kinds, contacts): (Vec<_>, Vec<_>) = self.contacts_by_kind().into_iter().unzip();
        let forces = || self.state.supports.iter().map(|support| support.force);
        let no_force = TOLERANCE * forces().fold(self.state.contact_force(), |sum, force| sum + force.abs());
        let of = |support: &&SupportForce| match self.gives(support.at) {
            true => Some(support.force < -no_force),
            false => pulling.next(),
        };
        let pulls = if self.springs.is_some() {
            forces().map(|force| force < -no_force).collect()
        } else {
            holding.iter().filter_map(of).collect()
        };
        Pattern {
            kinds,
            clamped: holding
                .iter()
                .filter_map(|support| if self.gives(support.at) { Some([false; 2]) } else { clamped.next() })
                .collect(),
            pulls,
            crests: contacts.iter().map(|contact| self.crest(contact)).collect(),
            pieces: given.shapes.len(),
        }
    }

    /// The contacts that carry a force, with their kinds. A contact without a force is omitted, and a zone extends only as far as its
    /// pressure.
    pub(crate) fn contacts_by_kind(&self) -> Vec<(ContactKind, Contact)> {
        if self.springs.is_some() {
            let sunk = self.state.contacts.iter().map(|contact| (self.sunk(contact), *contact));
            let bearings = self.state.supports.iter().filter(|support| support.pushes_only).enumerate();
            let pressed = bearings.filter(|(_, support)| 0.0 < support.force);
            let pushed = pressed.map(|(i, support)| (ContactKind::Bearing(i), Contact::at(support.at, support.force)));
            let mut found: Vec<_> = sunk.chain(pushed).collect();
            found.sort_by(|a, b| a.1.from.total_cmp(&b.1.from));
            return found;
        }
        let (given, nodes, rest) = (&self.given, &self.list.nodes, self.rest());
        let mut contacts = self.listed.iter();
        let mut found = Vec::with_capacity(contacts.len());
        for i in 0..=nodes.len() {
            if self.list.in_zone_before(i) {
                found.extend(contacts.next().into_iter().flat_map(|contact| self.pressed(i, *contact, rest)));
            }
            let Some(node) = nodes.get(i) else { continue };
            let kind = match node.breakpoint {
                None if node.is_smooth() => ContactKind::Point(given.cells[node.cell].shape),
                Some(breakpoint) if node.is_edge(given) => match given.bearings.binary_search(&breakpoint) {
                    Ok(bearing) => ContactKind::Bearing(bearing + self.stops_before(breakpoint)),
                    Err(_) => ContactKind::Edge(edge(given, breakpoint)),
                },
                _ => continue,
            };
            let pushed = |bearing: usize| {
                let support = self.state.supports.iter().filter(|support| support.pushes_only).nth(bearing)?;
                Some(Contact::at(support.at, support.force))
            };
            found.extend(
                if let ContactKind::Bearing(bearing) = kind { pushed(bearing) } else { contacts.next().copied() }
                    .filter(|contact| self.no_force(i, rest) < contact.force)
                    .map(|contact| (kind, contact)),
            );
        }
        found.extend(self.pressed_stops());
        if !given.springs.is_empty() {
            found.sort_by(|a, b| a.1.from.total_cmp(&b.1.from));
        }
        found
    }

    /// The elastic compression-only supports that are pressed, counted among all compression-only supports.
    fn pressed_stops(&self) -> impl Iterator<Item = (ContactKind, Contact)> + '_ {
        let most = self.state.supports.iter().fold(0.0, |most: f64, support| most.max(support.force.abs()));
        let pushing = self.state.supports.iter().filter(|support| support.pushes_only).enumerate();
        let pressed = pushing.filter(move |(_, support)| self.gives(support.at) && TOLERANCE * most < support.force);
        pressed.map(|(i, support)| (ContactKind::Bearing(i), Contact::at(support.at, support.force)))
    }

    /// The kind of a contact on an elastic foundation.
    fn sunk(&self, contact: &Contact) -> ContactKind {
        let given = &self.given;
        let at = |x: f64, place: f64| (x - place).abs() <= AT_ONE_PLACE * given.length;
        ContactKind::Zone([(contact.from, true), (contact.to, false)].map(|(x, right)| {
            let x = x / self.units.length;
            let support = given.supports.iter().position(|support| at(x, given.breakpoints[support.breakpoint].x));
            match support {
                Some(index) => ZoneEnd::Support(index),
                None if at(x, 0.0) || at(x, given.length) => ZoneEnd::FreeEnd,
                None => {
                    let cell = if right { given.cell_from(x) } else { given.cell_to(x) };
                    ZoneEnd::LiftOff(given.cells[cell].shape)
                }
            }
        }))
    }

    /// The parts of the zone before node `i` that carry a force: stretches with pressure, and positions with a concentrated force.
    fn pressed(&self, i: usize, contact: Contact, rest: f64) -> Vec<(ContactKind, Contact)> {
        let given = &self.given;
        let nodes = [&self.list.nodes[i - 1], &self.list.nodes[i]];
        let [from, to] = nodes.map(|node| node.x);
        let within = |x: f64| x.max(from).min(to);
        let least = self.no_force(i - 1, rest).max(self.no_force(i, rest)).max(TOLERANCE * contact.force.abs());
        let presses = |cell: usize| {
            let [lo, hi] = [given.cells[cell].lo, given.cells[cell].hi].map(within);
            let places = [lo, 0.5 * (lo + hi), hi].into_iter();
            let most = places.fold(0.0, |most: f64, x| most.max(given.drive(cell, x).abs()));
            (lo < hi && least < most * given.length * self.units.force).then_some([lo, hi])
        };
        let (first, last) = (given.cell_from(from), given.cell_to(to));
        let loads = given.breakpoints_inside(from, to).map(|i| &given.breakpoints[i]).filter(|b| b.acts.force() != 0.0);
        // At a support only the sum of contact force and reaction is unique.
        let ends = [i - 1, i].into_iter().filter(|&end| {
            self.list.nodes[end].support(given).is_none() && least < self.forces[end] * self.units.force
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
        let kind = |[from, to]: [f64; 2]| {
            if AT_ONE_PLACE * given.length < to - from {
                let ends = [from, to].map(|x| end(x).map_or(ZoneEnd::LiftOff(shape(x)), |node| zone_end(given, node)));
                return ContactKind::Zone(ends);
            }
            match end(from).filter(|node| node.is_tip(given)).and_then(|tip| tip.breakpoint) {
                Some(breakpoint) => ContactKind::Edge(edge(given, breakpoint)),
                None => ContactKind::Point(shape(from)),
            }
        };
        let is_whole =
            |ends: &[[f64; 2]]| matches!(ends, [[lo, hi]] if end(*lo).is_some() && end(*hi).is_some() && lo < hi);
        if is_whole(&pieces) {
            return vec![(kind([from, to]), contact)];
        }
        let piece = |ends: [f64; 2]| (kind(ends), self.part_of_zone(i, ends).in_units_of(&self.units));
        pieces.into_iter().map(piece).collect()
    }

    /// The contact force on a part of the zone before node `i`, over `EI`. The part reaches from one of the ends of the zone, or a
    /// position where the load changes, to another.
    fn part_of_zone(&self, i: usize, ends: [f64; 2]) -> Contact {
        let (given, nodes) = (&self.given, &self.list.nodes);
        let near = |x: f64, place: f64| (x - place).abs() <= AT_ONE_PLACE * given.length;
        let concentrated = ends.map(|x| {
            let at_end = [i - 1, i].into_iter().filter(|&i| near(nodes[i].x, x) && nodes[i].support(given).is_none());
            let loads = given.breakpoints_inside(nodes[i - 1].x, nodes[i].x).map(|i| &given.breakpoints[i]);
            let loads = loads.filter(|breakpoint| near(breakpoint.x, x)).map(|breakpoint| breakpoint.acts.force());
            at_end.map(|i| self.forces[i]).chain(loads).sum::<f64>()
        });
        let [from, to] = ends;
        if from < to {
            let force = concentrated[0] + concentrated[1] + zone_force(given, from, to);
            Contact { from, to, force, end_forces: Some(concentrated) }
        } else {
            Contact::at(from, concentrated[0])
        }
    }

    /// The sides of a support on which the foundation restrains the slope of the beam, with a couple.
    fn clamped(&self, i: usize, index: usize, rest: f64) -> [bool; 2] {
        let support = &self.given.supports[index];
        if support.slope.is_some() && !support.built_in {
            return [true; 2];
        }
        let sides = super::sensitivity::ends(&self.spans, i);
        let [left, right] = [sides[0].map_or(0.0, |span| span.beam_b[2]), sides[1].map_or(0.0, |span| span.beam_a[2])];
        let lever = TOLERANCE * left.abs().max(right.abs()).max(rest * self.given.length);
        let couple = lever < (right - left).abs();
        let rests = self.list.follows_foundation(i);
        [0, 1].map(|side| rests[side] && !self.list.in_zone_before(i + side) && couple)
    }

    /// The limit below which a force at node `i` has no reliable sign. It does not depend on forces elsewhere: a load of any size may act
    /// beyond a support. `rest` is [`Self::rest`].
    fn no_force(&self, i: usize, rest: f64) -> f64 {
        TOLERANCE * force_beside(&self.given, &self.spans, i).max(rest) * self.units.force
    }

    /// The smallest scale of forces, over `EI`: next to a stretch without a load all forces may be zero.
    pub(super) fn rest(&self) -> f64 {
        AT_REST * self.given.total_load
    }

    /// The load directly on a support.
    fn load_on(&self, node: &Node) -> f64 {
        let support = node.support(&self.given).map(|index| &self.given.supports[index]);
        let load = support.map_or(0.0, |support| self.given.breakpoints[support.breakpoint].acts.force());
        load.abs() * self.units.force
    }

    /// The crest of the profile on which a contact is.
    fn crest(&self, contact: &Contact) -> Crest {
        let places = [contact.from, contact.to].map(|x| x / self.units.length);
        let waves = |x: f64| {
            let waves = self.given.shapes[self.given.cells[self.given.cell_from(x)].shape].waves();
            let bends = |wave: &Wave| wave.amplitude.abs() * wave.number * wave.number;
            let most = waves.into_iter().flatten().max_by(|a, b| bends(a).total_cmp(&bends(b)));
            most.map_or(0.0, |wave| wave.angle(x) / std::f64::consts::TAU)
        };
        Crest { ends: places.map(|x| x / self.given.length), waves: places.map(waves) }
    }
}

fn zone_end(given: &PiecewiseScene, node: &Node) -> ZoneEnd {
    match node.support(given) {
        Some(index) => ZoneEnd::Support(index),
        None if node.can_move() => ZoneEnd::LiftOff(given.cells[node.cell].shape),
        None => ZoneEnd::FreeEnd,
    }
}

/// The piece of the profile that starts at an edge; for the right end of the beam, the number of pieces.
fn edge(given: &PiecewiseScene, breakpoint: usize) -> usize {
    given.cells.get(breakpoint).map_or(given.shapes.len(), |cell| cell.shape)
}
