//! What an answer is made of, without its numbers: between two scenes with the same pattern nothing happens.

use super::carried::{AT_ONE_PLACE, Carried, NO_FORCE, no_force, rest};
use super::exact::Exact;
use super::list::Node;
use super::shape::Wave;
use crate::state::Contact;

/// The kind of an exact solution.
#[derive(Debug, Clone, PartialEq)]
pub struct Pattern {
    /// What each of its contacts is, in their order.
    pub touches: Vec<Touch>,
    /// Whether the ground holds the slope of the beam beside each support, to its left and to its right.
    pub clamped: Vec<[bool; 2]>,
    /// Which of the supports pull the beam down.
    pub pulls: Vec<bool>,
    /// On which crest each of its contacts lies.
    crests: Vec<Crest>,
    /// Smooth pieces of the profile; where this is another number, their indices mean something else.
    pieces: usize,
}

/// Where on a smooth piece a contact lies: two contacts of one kind are the same one only if they are near to each other.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Crest {
    /// Where the contact starts and ends, as shares of the beam.
    ends: [f64; 2],
    /// How many waves of the profile lie before that, of the one that bends it most; 0 without waves.
    waves: [f64; 2],
}

impl Crest {
    /// True if this may be the same contact as another one, moved by a little: by less than from one crest to the next.
    fn is_near(&self, other: &Self) -> bool {
        let less = |a: [f64; 2], b: [f64; 2], most: f64| a.iter().zip(b).all(|(a, b)| (a - b).abs() <= most);
        less(self.ends, other.ends, NEAR) && less(self.waves, other.waves, HALF_A_WAVE)
    }
}

/// A contact that moves farther than this share of the beam, or than half a wave of the ground, may be another one.
const NEAR: f64 = 0.02;
const HALF_A_WAVE: f64 = 0.5;

/// A contact.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Touch {
    /// A point on the smooth piece of that index.
    Point(usize),
    /// The edge at which the smooth piece of that index starts, or a free end of the beam.
    Edge(usize),
    /// The support of that index, of those that only push.
    Bearing(usize),
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

impl Pattern {
    /// True if nothing happens between two scenes that differ in numbers only, and by little, and have these patterns: their contacts
    /// are of the same kinds, and lie on the same crests.
    #[must_use]
    pub fn is_same(&self, other: &Self) -> bool {
        self.is_same_kind(other) && self.crests.iter().zip(&other.crests).all(|(a, b)| a.is_near(b))
    }

    /// True if the contacts of two answers are of the same kinds, wherever on their smooth pieces of the profile they lie.
    #[must_use]
    pub fn is_same_kind(&self, other: &Self) -> bool {
        if self.clamped != other.clamped || self.pulls != other.pulls {
            return false;
        }
        if self.pieces == other.pieces {
            return self.touches == other.touches;
        }
        // Points of a survey that come to lie on one line are one piece less.
        let kinds = |touches: &[Touch]| touches.iter().map(|touch| matches!(touch, Touch::Zone(_))).collect::<Vec<_>>();
        kinds(&self.touches) == kinds(&other.touches)
    }
}

impl Exact {
    /// Its pattern.
    #[must_use]
    pub fn pattern(&self) -> Pattern {
        let (given, nodes) = (&self.given, &self.list.nodes);
        let clamped = |(i, node): (usize, &Node)| Some(self.clamped(i, node.support(given)?));
        let supports = nodes.iter().enumerate().filter_map(clamped);
        let holding: Vec<_> = self.state.supports.iter().filter(|support| !support.pushes_only).collect();
        let pulling = nodes.iter().enumerate().filter_map(|(i, node)| {
            let support = holding.get(node.support(given)?)?;
            let no_force = no_force(given, &self.spans, i) * self.stiffness * self.scale.force;
            Some(support.force < -no_force.max(NO_FORCE * self.load_on(node)))
        });
        let (touches, contacts): (Vec<_>, Vec<_>) = self.touches().into_iter().unzip();
        let forces = || self.state.supports.iter().map(|support| support.force);
        let no_force = NO_FORCE * forces().fold(self.state.contact_force(), |sum, force| sum + force.abs());
        let pulls =
            if self.springs.is_some() { forces().map(|force| force < -no_force).collect() } else { pulling.collect() };
        Pattern {
            touches,
            clamped: supports.collect(),
            pulls,
            crests: contacts.iter().map(|contact| self.crest(contact)).collect(),
            pieces: given.shapes.len(),
        }
    }

    /// Its contacts and the supports that only push and carry something, each with what it is.
    pub(crate) fn touches(&self) -> Vec<(Touch, Contact)> {
        if self.springs.is_some() {
            let sunk = self.state.contacts.iter().map(|contact| (self.sunk(contact), *contact));
            let bearings = self.state.supports.iter().filter(|support| support.pushes_only).enumerate();
            let pressed = bearings.filter(|(_, support)| 0.0 < support.force);
            let pushed = pressed.map(|(i, support)| (Touch::Bearing(i), Contact::at(support.at, support.force)));
            let mut touches: Vec<_> = sunk.chain(pushed).collect();
            touches.sort_by(|a, b| a.1.from.total_cmp(&b.1.from));
            return touches;
        }
        let contact = |carried: &Carried| (carried.touch, carried.contact(&self.scale, self.stiffness));
        self.carried.iter().map(contact).collect()
    }

    /// A contact on ground that gives.
    fn sunk(&self, contact: &Contact) -> Touch {
        let given = &self.given;
        let at = |x: f64, place: f64| (x - place).abs() <= AT_ONE_PLACE * given.length;
        Touch::Zone([(contact.from, true), (contact.to, false)].map(|(x, right)| {
            let x = x / self.scale.length;
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

    /// On which sides of a support the ground holds the slope of the beam, and takes a couple for it.
    fn clamped(&self, i: usize, index: usize) -> [bool; 2] {
        let support = &self.given.supports[index];
        if support.slope.is_some() && !support.built_in {
            return [true; 2];
        }
        let sides = super::sensitivity::ends(&self.spans, i);
        let [left, right] = [sides[0].map_or(0.0, |span| span.beam_b[2]), sides[1].map_or(0.0, |span| span.beam_a[2])];
        let lever = NO_FORCE * left.abs().max(right.abs()).max(rest(&self.given) * self.given.length);
        let couple = lever < (right - left).abs();
        let rests = self.list.rests(i);
        [0, 1].map(|side| rests[side] && !self.list.in_zone_before(i + side) && couple)
    }

    /// The load that stands on a support.
    fn load_on(&self, node: &Node) -> f64 {
        let support = node.support(&self.given).map(|index| &self.given.supports[index]);
        let load = support.map_or(0.0, |support| self.given.breakpoints[support.breakpoint].force);
        load.abs() * self.stiffness * self.scale.force
    }

    /// On which crest of the profile a contact lies.
    fn crest(&self, contact: &Contact) -> Crest {
        let places = [contact.from, contact.to].map(|x| x / self.scale.length);
        let waves = |x: f64| {
            let waves = self.given.shapes[self.given.cells[self.given.cell_from(x)].shape].waves();
            let bends = |wave: &Wave| wave.amplitude.abs() * wave.number * wave.number;
            let most = waves.into_iter().flatten().max_by(|a, b| bends(a).total_cmp(&bends(b)));
            most.map_or(0.0, |wave| wave.angle(x) / std::f64::consts::TAU)
        };
        Crest { ends: places.map(|x| x / self.given.length), waves: places.map(waves) }
    }
}
