//! What the bounds know of a scene.

use super::curve::{Curve, overlay};
use super::ground::Ground;
use super::joints::{Joint, Setting};
use super::load::Pieces;
use super::polynomial::Polynomial;
use super::proof::{self, Pair};
use crate::certificate::interval::Interval;
use crate::scene::{Foundation, Scene};

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

    /// The pair of some joints.
    pub(super) fn pair(&self, joints: &[Joint]) -> Option<Pair> {
        match self.setting() {
            Some(setting) => proof::pair(&setting, joints),
            None => Some(proof::free(&self.load, self.stiffness, self.length)),
        }
    }

    /// `½ ∫ (EI v̂'' + M)²/EI dx` with the moments of the deflection that the forces cause.
    pub(super) fn mismatch(&self, curve: &Curve, own: impl Iterator<Item = ([f64; 2], Polynomial)>) -> Interval {
        let half = Interval::exact(0.5 * self.stiffness);
        let mut sum = Interval::ZERO;
        let second = |v: &Polynomial| v.derivative().derivative();
        let curve = curve.pieces.iter().map(|p| ([p.from, p.to], second(&p.v)));
        overlay(curve, own.map(|(cell, v)| (cell, second(&v))), |a, b, f, g| {
            let width = Interval::exact(b) - Interval::exact(a);
            sum = sum + half * f.minus(g).integral_of_square(width);
        });
        sum
    }
}
