//! Supports that give, in the energies of a pair.
//!
//! A spring of the stiffness `k` takes up `½k (v − d)²`, and one that only pushes `½k (v − d)₊²`; its dual, with a force `R` that is not
//! negative then, is `−R d − R²/2k`. What a pair has in its gap for it is, with the force `R` of `M` and `t = k (v̂ − d)`,
//!
//! ```text
//! (t − R)²/2k             one that only pushes:  (t₊ − R)²/2k + R (d − v̂)₊
//! (k (v̂' − φ) + C)²/2k    against turning, with the jump C of M
//! ```
//!
//! A support that gives is a node of `v̂`, at the level `d + R/k` that the witness says, with the force that `M` has there. Where the beam
//! touches the ground just there, and where it only pushes and is not pressed, it is a load `−R`, and `v̂` is what it is.

use super::contact_node::EnclosedScene;
use super::interval::Interval;
use super::polynomial::number;
use super::proof::Piece;
use crate::scene::Support;

/// What gives at a support.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Giving {
    /// `k` and `d`; [`None`] of a support that holds the level.
    pub(crate) spring: Option<[Interval; 2]>,
    /// `k` and `φ`.
    pub(crate) turning: Option<[Interval; 2]>,
    /// True if it only pushes.
    pub(crate) pushes: bool,
}

/// A support that gives as a load that the witness says.
#[derive(Debug, Clone, Copy)]
pub(crate) struct SaidSpring {
    pub(crate) x: f64,
    pub(crate) gives: Giving,
    /// `R`, upwards.
    pub(crate) force: f64,
    /// The jump of `M`.
    pub(crate) couple: f64,
}

impl Giving {
    /// That of a support of a scene, where the own shape has this value and slope.
    pub(crate) fn of(support: &Support, own: [Interval; 4]) -> Self {
        let of = |k: Option<f64>, without: f64, own: Interval| {
            k.map(|k| [Interval::exact(k), Interval::exact(without) - own])
        };
        let spring = of(support.stiffness, support.level, own[0]);
        let turning = of(support.turning_stiffness, support.slope.unwrap_or(0.0), own[1]);
        Self { spring, turning, pushes: support.pushes_only }
    }

    /// What the force and the jump of `M` leave in the gap, for a deflection and its slope.
    pub(super) fn misfit(&self, [force, jump]: [Interval; 2], [v, slope]: [Interval; 2]) -> Interval {
        let share = |off: Interval, k: Interval| off.square() / (number(2) * k);
        let sunk = self.spring.map_or(Interval::ZERO, |[k, d]| {
            let (t, above) = (k * (v - d), (d - v).positive_part());
            if self.pushes { share(t.positive_part() - force, k) + force * above } else { share(t - force, k) }
        });
        let turned = self.turning.map_or(Interval::ZERO, |[k, without]| share(k * (slope - without) + jump, k));
        sunk + turned
    }

    /// What springs take up.
    pub(super) fn energy(&self, [v, slope]: [Interval; 2]) -> Interval {
        let taken = |k: Interval, by: Interval| k * by.square() / number(2);
        let sunk = self
            .spring
            .map_or(Interval::ZERO, |[k, d]| taken(k, if self.pushes { (v - d).positive_part() } else { v - d }));
        sunk + self.turning.map_or(Interval::ZERO, |[k, without]| taken(k, slope - without))
    }

    /// By how much `M` jumps because of it where the beam has this slope.
    pub(super) fn jump(&self, slope: Interval) -> Interval {
        self.turning.map_or(Interval::ZERO, |[k, without]| -(k * (slope - without)))
    }
}

/// What springs that are loads leave in the gap, and by how much the energy is more than that of their loads.
pub(super) fn of_loads(enclosed: &EnclosedScene<'_>, pieces: &[Piece]) -> [Interval; 2] {
    let of = |[gap, energy]: [Interval; 2], said: &SaidSpring| {
        let Some(piece) = pieces.iter().find(|piece| piece.from <= said.x && said.x <= piece.to) else {
            return [Interval::exact(f64::INFINITY); 2];
        };
        let at = Interval::length(piece.from, said.x);
        let state = [piece.v.at(at), piece.v.derivative().at(at)];
        let [force, couple] = [said.force, said.couple].map(Interval::exact);
        // The loads `−R` and `C` do the work `−R v` and `C v'`.
        let done = couple * state[1] - force * state[0];
        [gap + said.gives.misfit([force, couple], state), energy + said.gives.energy(state) + done]
    };
    enclosed.said.iter().fold([Interval::ZERO; 2], of)
}
