//! Which condition of (4), (7) contact forces violate, by how much and where.

use super::contact_load::{ContactLoad, deflection};
use super::kernel::foundation::EnclosedFoundation;
use super::kernel::interval::Interval;
use super::kernel::load::EnclosedLoad;
use super::lumped::Lumped;
use crate::scene::{Scene, SceneError};

/// A condition of contact.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "cli", derive(serde::Serialize), serde(rename_all = "kebab-case"))]
pub enum ViolationKind {
    /// `p ≥ 0`: a force pulls.
    Tension,
    /// `v ≤ u`: the beam that these forces hold is inside the foundation.
    Penetration,
    /// `p (u − v) = 0`: a force acts where the beam that these forces hold is clear of the foundation.
    Complementarity,
}

impl ViolationKind {
    /// Its name in tables and JSON.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Tension => "tension",
            Self::Penetration => "penetration",
            Self::Complementarity => "complementarity",
        }
    }
}

/// The worst violation of one condition.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "cli", derive(serde::Serialize))]
pub struct Violation {
    /// Which condition.
    #[cfg_attr(feature = "cli", serde(rename = "condition"))]
    pub kind: ViolationKind,
    /// Where \[length\].
    pub at: f64,
    /// The force that pulls \[force\], or how deep the beam is in the foundation, or how clear of it \[length\].
    pub amount: f64,
    /// The amount as a share: of all contact forces, or of the largest deflection.
    pub relative: f64,
}

/// The worst violation of each condition that is violated at all, the worst of them first.
///
/// # Errors
///
/// A [`SceneError`] if the scene leaves the range of `f64` when it is scaled.
pub fn violations(scene: &Scene, given: &ContactLoad) -> Result<Vec<Violation>, SceneError> {
    scene.only_simple_beam("the check of contact forces")?;
    let scaled = scene.scaled()?;
    let (scene, scale) = (&scaled.scene, &scaled.scale);
    let forces = given.scaled(scale);
    let (load, stiffness, length) = (EnclosedLoad::of(scene), scene.beam().bending_stiffness(), scene.beam().length());
    let beam = deflection(&forces, &load, &[], stiffness, length);

    let all = sum(&forces);
    let moved = beam.iter().fold(0.0, |most: f64, (_, v)| most.max(v.at(Interval::ZERO).middle().abs()));
    let mut found: Vec<Violation> = tension(&forces, all).into_iter().collect();
    for tension in &mut found {
        (tension.at, tension.amount) = (tension.at * scale.length, tension.amount * scale.force);
    }
    let Some(foundation) = EnclosedFoundation::of(scene) else { return Ok(found) };
    let mut add = |kind, (at, amount): (f64, f64)| {
        if 0.0 < amount {
            let relative = share(amount, moved);
            found.push(Violation { kind, at: at * scale.length, amount: amount * scale.depth, relative });
        }
    };
    let mut deepest = (0.0, 0.0);
    for ([a, b], v) in deflection(&forces, &load, &foundation.breaks(0.0, length), stiffness, length) {
        let below = v.minus(&foundation.cell(a, b));
        // At both ends and in the middle of each cell.
        for share in [0.0, 0.5, 1.0] {
            let s = share * (b - a);
            let depth = below.at(Interval::exact(s)).middle();
            if deepest.1 < depth {
                deepest = (a + s, depth);
            }
        }
    }
    add(ViolationKind::Penetration, deepest);
    let clear = forces.pressing.iter().map(|&(x, force)| {
        let i = beam.partition_point(|c| c.0[1] < x).min(beam.len() - 1);
        let ([from, _], v) = &beam[i];
        let clearance = (foundation.depth(x) - v.at(Interval::exact(x) - Interval::exact(*from))).middle();
        // As in the check of a discrete state: a small force far from the foundation is as good as none.
        (x, clearance.min(share(force, all) * moved))
    });
    add(ViolationKind::Complementarity, worst(clear));
    found.sort_by(|a, b| b.relative.total_cmp(&a.relative));
    Ok(found)
}

/// The same for a beam whose load is lumped at nodes: the conditions at the nodes, which are all that such a beam keeps.
#[must_use]
pub fn violations_at_nodes(lumped: &Lumped) -> Vec<Violation> {
    let Lumped { load, nodes } = lumped;
    let all = sum(load);
    let moved = nodes.deflection.iter().fold(0.0, |most: f64, v| most.max(v.abs()));
    let deepest = worst(nodes.x.iter().zip(&nodes.clearance).map(|(&x, h)| (x, -h)));
    // Infinitely clear of a foundation that is not there.
    let forces = nodes.x.iter().zip(&nodes.clearance).zip(&nodes.contact_force).filter(|((_, h), _)| h.is_finite());
    let clear = worst(forces.map(|((&x, h), p)| (x, h.min(share(*p, all) * moved))));
    let of_depth = [(ViolationKind::Penetration, deepest), (ViolationKind::Complementarity, clear)];
    let of_depth = of_depth.into_iter().filter(|(_, (_, amount))| 0.0 < *amount);
    let of_depth = of_depth.map(|(kind, (at, amount))| Violation { kind, at, amount, relative: share(amount, moved) });
    let mut found: Vec<Violation> = tension(load, all).into_iter().chain(of_depth).collect();
    found.sort_by(|a, b| b.relative.total_cmp(&a.relative));
    found
}

impl<'a> EnclosedFoundation<'a> {
    /// [`None`] where there is no foundation.
    pub(crate) fn of(scene: &'a Scene) -> Option<Self> {
        Some(Self::on(scene.foundation()?, scene.beam().length()))
    }
}

/// The sum of all forces, those that pull included.
fn sum(forces: &ContactLoad) -> f64 {
    forces.pressing.iter().chain(&forces.pulling).map(|f| f.1.abs()).sum()
}

/// The force that pulls most.
fn tension(forces: &ContactLoad, all: f64) -> Option<Violation> {
    let strongest = forces.pulling.iter().min_by(|a, b| a.1.total_cmp(&b.1));
    strongest.map(|&(at, force)| Violation {
        kind: ViolationKind::Tension,
        at,
        amount: -force,
        relative: share(-force, all),
    })
}

/// The largest positive amount, and where it is; zero if there is none.
fn worst(amounts: impl Iterator<Item = (f64, f64)>) -> (f64, f64) {
    amounts.fold((0.0, 0.0), |worst, a| if worst.1 < a.1 { a } else { worst })
}

fn share(part: f64, whole: f64) -> f64 {
    let share = part / whole;
    if 0.0 < whole && !share.is_nan() { share } else { 1.0 }
}
