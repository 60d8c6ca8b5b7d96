//! Elastic supports, in the energies of a pair.
//!
//! A spring of the stiffness `k` stores `½k (v − d)²`, and a compression-only spring `½k (v − d)₊²`. Its dual is `−R d − R²/2k`, where
//! `R ≥ 0` for a compression-only spring. With the force `R` of `M` and `t = k (v̂ − d)`, a spring contributes to the gap of a pair
//!
//! ```text
//! (t − R)²/2k             compression-only:  (t₊ − R)²/2k + R (d − v̂)₊
//! (k (v̂' − φ) + C)²/2k    rotational, with the jump C of M
//! ```
//!
//! An elastic support is a node of `v̂`, at the level `d + R/k` with `R` from the candidate contact list, and its force follows from
//! `M`. It is a load `−R` instead, and does not prescribe `v̂`, where the beam touches the foundation at the same position, or where the
//! support is compression-only and not pressed.

use super::contact_node::EnclosedScene;
use super::interval::Interval;
use super::polynomial::number;
use super::proof::Piece;
use crate::scene::Support;

/// The springs of a support.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Giving {
    /// `k` and `d`; [`None`] for a support that is rigid vertically.
    pub(crate) spring: Option<[Interval; 2]>,
    /// `k` and `φ` of a rotational spring.
    pub(crate) turning: Option<[Interval; 2]>,
    /// True for a compression-only support.
    pub(crate) pushes: bool,
}

/// An elastic support that is treated as a load from the candidate contact list.
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
    /// The springs of a support of a scene, where the initial shape has this value and slope.
    pub(crate) fn of(support: &Support, own: [Interval; 4]) -> Self {
        let of = |k: Option<f64>, without: f64, own: Interval| {
            k.map(|k| [Interval::exact(k), Interval::exact(without) - own])
        };
        let spring = of(support.stiffness, support.level, own[0]);
        let turning = of(support.turning_stiffness, support.slope.unwrap_or(0.0), own[1]);
        Self { spring, turning, pushes: support.pushes_only }
    }

    /// The contribution to the gap of the force and the jump of `M`, for a deflection and its slope.
    pub(super) fn misfit(&self, [force, jump]: [Interval; 2], [v, slope]: [Interval; 2]) -> Interval {
        let share = |off: Interval, k: Interval| off.square() / (number(2) * k);
        let sunk = self.spring.map_or(Interval::ZERO, |[k, d]| {
            let (t, above) = (k * (v - d), (d - v).positive_part());
            if self.pushes { share(t.positive_part() - force, k) + force * above } else { share(t - force, k) }
        });
        let turned = self.turning.map_or(Interval::ZERO, |[k, without]| share(k * (slope - without) + jump, k));
        sunk + turned
    }

    /// The energy stored in the springs.
    pub(super) fn energy(&self, [v, slope]: [Interval; 2]) -> Interval {
        let taken = |k: Interval, by: Interval| k * by.square() / number(2);
        let sunk = self
            .spring
            .map_or(Interval::ZERO, |[k, d]| taken(k, if self.pushes { (v - d).positive_part() } else { v - d }));
        sunk + self.turning.map_or(Interval::ZERO, |[k, without]| taken(k, slope - without))
    }

    /// The jump of `M` caused by the rotational spring, for a beam with this slope.
    pub(super) fn jump(&self, slope: Interval) -> Interval {
        self.turning.map_or(Interval::ZERO, |[k, without]| -(k * (slope - without)))
    }
}

/// The contribution to the gap of springs that are treated as loads, and their energy plus the work of these loads.
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
