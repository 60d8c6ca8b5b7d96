//! What the bounds know of a scene.

use super::curve::Piece;
use super::ground::Ground;
use super::joints::Setting;
use super::load::Pieces;
use super::proof::{self, Pair};
use super::{error, witness};
use crate::certificate::interval::Interval;
use crate::scene::{Foundation, Scale, Scene};
use crate::state::Contact;

/// A dimensionless scene, taken apart.
pub(super) struct Inner<'a> {
    pub(super) ground: Option<Ground<'a>>,
    pub(super) load: Pieces,
    pub(super) stiffness: f64,
    pub(super) length: f64,
}

impl<'a> Inner<'a> {
    pub(super) fn of(scene: &'a Scene, foundation: Option<&'a Foundation>) -> Self {
        Self {
            ground: foundation.map(|foundation| Ground::on(foundation, scene.beam().length())),
            load: Pieces::of(scene),
            stiffness: scene.beam().bending_stiffness(),
            length: scene.beam().length(),
        }
    }

    pub(super) fn setting(&self) -> Option<Setting<'_>> {
        Some(Setting { ground: self.ground?, load: &self.load, stiffness: self.stiffness, length: self.length })
    }

    /// The pair that a list of contacts proves. With another list that proves less than nothing, the beam that touches nowhere
    /// is better: whatever the list, there is a bound.
    pub(super) fn pair(&self, contacts: &[Contact], scale: &Scale) -> Option<Pair> {
        let Some(setting) = self.setting() else { return Some(proof::free(&self.load, self.stiffness, self.length)) };
        let of = |contacts: &[Contact]| proof::pair(&setting, &witness::joints(&setting, contacts, scale));
        let pair = of(contacts);
        if contacts.is_empty() || pair.as_ref().is_some_and(|pair| self.is_sharp(pair)) {
            return pair;
        }
        let none = of(&[]).map(|none| Pair { lifted: f64::INFINITY, ..none });
        pair.into_iter().chain(none).min_by(|a, b| a.gap.hi().total_cmp(&b.gap.hi()))
    }

    /// Whether what a pair leaves open is no more than what rounding explains.
    pub(super) fn is_sharp(&self, pair: &Pair) -> bool {
        /// Of the largest deflection.
        const SHARP: f64 = 1e-6;
        let width = |p: &Piece| Interval::exact(p.to) - Interval::exact(p.from);
        let size = pair.curve.pieces.iter().fold(0.0, |most: f64, p| most.max(p.v.range(width(p)).magnitude()));
        error::of_gap(pair.gap.hi(), self.stiffness, self.length) <= SHARP * size
    }
}
