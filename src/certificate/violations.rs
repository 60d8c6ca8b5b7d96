//! The conditions of (4), (7) that contact forces violate, with amount and position.

use super::contact_load::{ContactLoad, deflection};
use super::enclosed;
use super::kernel::contact_node::EnclosedScene;
use super::kernel::interval::Interval;
use super::kernel::load::cells;
use super::kernel::polynomial::Polynomial;
use super::kernel::tension::Hung;
use super::lumped::Lumped;
use super::spread;
use crate::scene::{Resultant, Scaled, Scene, SceneError};

/// A condition of contact.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize), serde(rename_all = "kebab-case"))]
pub enum ViolationKind {
    /// `p ≥ 0`: a contact force is in tension.
    Tension,
    /// `v ≤ u`: the beam under these forces penetrates the foundation.
    Penetration,
    /// `p (u − v) = 0`: a force acts where the beam under these forces is clear of the foundation.
    Complementarity,
    /// `p = k (v − g)₊`: a force differs from the force of the foundation springs that it represents, for the deflection caused by these
    /// forces.
    SpringLaw,
    /// `∫p = W`, `∫p x = W x_W`: the forces do not balance the loads of a beam that its supports do not hold.
    Balance,
}

impl ViolationKind {
    /// The name used in tables and JSON.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Tension => "tension",
            Self::Penetration => "penetration",
            Self::Complementarity => "complementarity",
            Self::SpringLaw => "spring-law",
            Self::Balance => "balance",
        }
    }
}

/// The largest violation of one condition.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Violation {
    /// The violated condition.
    #[cfg_attr(feature = "serde", serde(rename = "condition"))]
    pub kind: ViolationKind,
    /// Position \[length\].
    pub at: f64,
    /// The tensile or missing force \[force\], or the depth of penetration, or the clearance \[length\].
    pub amount: f64,
    /// The amount as a share of the sum of all contact forces, or of the largest deflection.
    pub relative: f64,
}

/// The largest violation of each violated condition, the largest share first. On an elastic foundation the forces are compared with the
/// forces of the foundation springs for the deflection that they cause.
///
/// # Errors
///
/// A [`SceneError`] if the scene leaves the range of `f64` when it is scaled, and [`SceneError::NotKnown`] if the forces alone do not
/// determine how the beam bends; in this case a [`Witness`](crate::Witness) can.
pub fn violations(scene: &Scene, given: &ContactLoad) -> Result<Vec<Violation>, SceneError> {
    scene.has_to_bend_under_forces("a check of contact forces")?;
    violations_by(scene, given, None)
}

/// The same for forces whose deflection is already computed, in the units of [`Scene::scaled`]; an empty deflection means that there is
/// none.
pub(crate) fn violations_by(
    scene: &Scene,
    given: &ContactLoad,
    caused: Option<&[Hung]>,
) -> Result<Vec<Violation>, SceneError> {
    enclosed(scene, |enclosed, scaled| {
        let scale = &scaled.scale;
        let forces = given.scaled(scale);
        let all = sum(&forces);
        let mut found: Vec<Violation> = tension(&forces, all).into_iter().collect();
        found.extend(imbalance(scaled, &forces).filter(|_| caused.is_none()));
        let breaks = enclosed.gap.breaks(0.0, enclosed.length);
        let beam = match caused {
            Some(caused) => (!caused.is_empty()).then(|| cut(caused, enclosed)),
            None if scene.ground_stiffness().is_some() => spread::deflection(&scaled.scene, enclosed, &forces),
            None => deflection(&forces, enclosed, &breaks),
        };
        found.extend(beam.as_ref().and_then(|beam| of_springs(scaled, enclosed, &forces, beam)));
        for of_force in &mut found {
            (of_force.at, of_force.amount) = (of_force.at * scale.length, of_force.amount * scale.force);
        }
        let is_rigid = scene.has_obstacle() && scene.ground_stiffness().is_none();
        if let Some(beam) = beam.filter(|_| is_rigid) {
            found.extend(of_depth(enclosed, &forces, &beam).map(|found| Violation {
                at: found.at * scale.length,
                amount: found.amount * scale.depth,
                ..found
            }));
        }
        found.sort_by(|a, b| b.relative.total_cmp(&a.relative));
        found
    })
}

/// The largest deviation of a force from the force of the foundation springs that it represents, over its share of the beam.
fn of_springs(
    scaled: &Scaled,
    enclosed: &EnclosedScene<'_>,
    forces: &ContactLoad,
    beam: &[([f64; 2], Polynomial)],
) -> Option<Violation> {
    scaled.scene.ground_stiffness()?;
    let off = spread::spread(&scaled.scene, forces).into_iter().filter(|f| 0.0 < f.width).map(|f| {
        let sunk = spread::at(beam, f.x) - enclosed.gap.depth(f.x).middle();
        (f.x, (f.force - f.spring * sunk.max(0.0)).abs())
    });
    let (at, amount) = worst(off);
    let relative = share(amount, sum(forces));
    (0.0 < amount).then_some(Violation { kind: ViolationKind::SpringLaw, at, amount, relative })
}

/// A deflection given by parts, divided into the cells of the gap.
fn cut(caused: &[Hung], enclosed: &EnclosedScene<'_>) -> Vec<([f64; 2], Polynomial)> {
    let cells = caused.iter().flat_map(|part| {
        let ([from, to], v) = part.curve();
        let cells = cells(from, to, enclosed.gap.breaks(from, to));
        cells.into_iter().map(move |cell| (cell, v.shifted(Interval::length(from, cell[0]))))
    });
    cells.collect()
}

/// The penetration of the beam under these forces, and the clearance at which a force acts.
fn of_depth(
    enclosed: &EnclosedScene<'_>,
    forces: &ContactLoad,
    beam: &[([f64; 2], Polynomial)],
) -> impl Iterator<Item = Violation> {
    let all = sum(forces);
    let moved = beam.iter().fold(0.0, |most: f64, (_, v)| most.max(v.at(Interval::ZERO).middle().abs()));
    let below = beam.iter().flat_map(|([a, b], v)| {
        let below = v.minus(&enclosed.gap.about(*a, [*a, *b]));
        // At both ends and in the middle of each cell.
        [0.0, 0.5, 1.0].map(|share| (a + share * (b - a), below.at(Interval::exact(share * (b - a))).middle()))
    });
    let clear_at = |x: f64| {
        let i = beam.partition_point(|c| c.0[1] < x).min(beam.len().saturating_sub(1));
        let clear_of = |([from, _], v): &([f64; 2], Polynomial)| {
            enclosed.gap.depth(x) - v.at(Interval::exact(x) - Interval::exact(*from))
        };
        beam.get(i).map_or(0.0, |cell| clear_of(cell).middle())
    };
    // A support that stands alone is not in any cell.
    let alone = enclosed.gap.ground.bearings.iter().map(|p| (p[0], -clear_at(p[0])));
    let below = below.chain(alone);
    // As in the check of a discrete state, a small force far from the foundation counts as negligible.
    let clear = forces.pressing.iter().map(|&(x, force)| (x, clear_at(x).min(share(force, all) * moved)));
    let found = [(ViolationKind::Penetration, worst(below)), (ViolationKind::Complementarity, worst(clear))];
    let found = found.into_iter().filter(|(_, (_, amount))| 0.0 < *amount);
    found.map(move |(kind, (at, amount))| Violation { kind, at, amount, relative: share(amount, moved) })
}

/// The imbalance of a beam that its supports do not hold: a force, or a couple over the length of the beam, at the resultant of the
/// loads. Rounding of printed digits is not counted.
fn imbalance(scaled: &Scaled, forces: &ContactLoad) -> Option<Violation> {
    /// Tolerance, as a share of the load.
    const ROUNDING: f64 = 1e-9;
    let Resultant { force, at } = scaled.balance.resultant()?;
    let length = scaled.scene.beam().length();
    let about = scaled.scene.beam().supports().first().map(|support| support.at);
    let carried: f64 = forces.pressing.iter().map(|f| f.1).sum();
    let turning: f64 = forces.pressing.iter().map(|f| f.1 * (f.0 - about.unwrap_or(0.0))).sum();
    let couple = force * (at - about.unwrap_or(0.0)) - turning;
    let missing = if about.is_none() { (force - carried).abs() } else { 0.0 };
    let amount = missing.max(couple.abs() / length);
    let relative = share(amount, scaled.scene.load().magnitude(length));
    (ROUNDING < relative).then_some(Violation { kind: ViolationKind::Balance, at, amount, relative })
}

/// The same for a beam whose load is lumped at nodes: the conditions at the nodes, the only ones that such a beam satisfies.
#[must_use]
pub fn violations_at_nodes(lumped: &Lumped) -> Vec<Violation> {
    let Lumped { load, nodes, feet, .. } = lumped;
    let all = sum(load);
    let moved = nodes.deflection.iter().fold(0.0, |most: f64, v| most.max(v.abs()));
    let deepest = worst(nodes.x.iter().zip(feet).map(|(&x, h)| (x, -h)));
    // Where there is no foundation the clearance is infinite.
    let forces = nodes.x.iter().zip(feet).zip(&nodes.contact_force).filter(|((_, h), _)| h.is_finite());
    let clear = worst(forces.map(|((&x, h), p)| (x, h.min(share(*p, all) * moved))));
    let of_depth = [(ViolationKind::Penetration, deepest), (ViolationKind::Complementarity, clear)];
    let of_depth = of_depth.into_iter().filter(|(_, (_, amount))| 0.0 < *amount);
    let of_depth = of_depth.map(|(kind, (at, amount))| Violation { kind, at, amount, relative: share(amount, moved) });
    let mut found: Vec<Violation> = tension(load, all).into_iter().chain(of_depth).collect();
    found.sort_by(|a, b| b.relative.total_cmp(&a.relative));
    found
}

/// The sum of the magnitudes of all forces, including tension.
fn sum(forces: &ContactLoad) -> f64 {
    forces.pressing.iter().chain(&forces.pulling).map(|f| f.1.abs()).sum()
}

/// The largest tensile force.
fn tension(forces: &ContactLoad, all: f64) -> Option<Violation> {
    let strongest = forces.pulling.iter().min_by(|a, b| a.1.total_cmp(&b.1));
    strongest.map(|&(at, force)| Violation {
        kind: ViolationKind::Tension,
        at,
        amount: -force,
        relative: share(-force, all),
    })
}

/// The largest positive amount and its position; zero if there is none.
fn worst(amounts: impl Iterator<Item = (f64, f64)>) -> (f64, f64) {
    amounts.fold((0.0, 0.0), |worst, a| if worst.1 < a.1 { a } else { worst })
}

fn share(part: f64, whole: f64) -> f64 {
    let share = part / whole;
    if 0.0 < whole && !share.is_nan() { share } else { 1.0 }
}
