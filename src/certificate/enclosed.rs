//! The enclosure of a scene: all its data as intervals.

use super::kernel::contact_node::{EnclosedScene, EnclosedSupport};
use super::kernel::foundation::EnclosedFoundation;
use super::kernel::gap::EnclosedGap;
use super::kernel::giving::{Giving, SaidSpring};
use super::kernel::interval::Interval;
use super::kernel::load::EnclosedLoad;
use super::kernel::tension::Hung;
use super::standing;
use crate::scene::{Balance, Foundation, Scaled, Scene, SceneError, Support};

/// Reactions and couples of elastic supports, and the proposed deflection between contacts.
pub(super) type Said<'a> = (&'a [[f64; 2]], &'a [Hung]);

/// The result of `act` on a scene that is first made dimensionless and enclosed in intervals.
pub(super) fn enclosed<R>(scene: &Scene, act: impl FnOnce(&EnclosedScene<'_>, &Scaled) -> R) -> Result<R, SceneError> {
    let scaled = scene.scaled()?;
    Ok(in_intervals(&scaled.scene, scaled.balance, |enclosed| act(enclosed, &scaled)))
}

/// The result of `act` on a scene that is enclosed in intervals as it is, without elastic supports.
pub(super) fn in_intervals<R>(scene: &Scene, balance: Balance, act: impl FnOnce(&EnclosedScene<'_>) -> R) -> R {
    with_springs(scene, balance, (&[], &[]), act)
}

/// The same with elastic supports and, under an axial force, with the proposed deflection between contacts. For each elastic support the
/// candidate contact list states whether the beam touches the foundation at its position, its reaction, and its jump of the moment.
pub(super) fn with_springs<R>(
    scene: &Scene,
    balance: Balance,
    (springs, hung): (&[(bool, [f64; 2])], &[Hung]),
    act: impl FnOnce(&EnclosedScene<'_>) -> R,
) -> R {
    /// Without a foundation the gap is infinite.
    const NONE: Foundation = Foundation::Flat { depth: f64::INFINITY };
    const STRAIGHT: Foundation = Foundation::Flat { depth: 0.0 };
    let (stiffness, length) = (scene.beam().bending_stiffness(), scene.beam().length());
    let given = [scene.foundation(), scene.beam().shape()];
    let fewer = given.map(|profile| profile.and_then(Foundation::without_collinear_points));
    let [ground, shape] = [0, 1].map(|k| fewer[k].as_ref().or(given[k]));
    let profile = |given| EnclosedFoundation { given, length, bearings: &[] };
    let alone = |bearing: &Support| [f64::INFINITY, bearing.level, f64::INFINITY].map(|depth| [bearing.at, depth]);
    let bearings: Vec<_> = scene.beam().bearings().iter().flat_map(alone).collect();
    let ground = EnclosedFoundation { bearings: &bearings, ..profile(ground.unwrap_or(&NONE)) };
    let gap = EnclosedGap { ground, shape: profile(shape.unwrap_or(&STRAIGHT)) };
    let (mut load, mut supports) = (standing::between(scene), EnclosedSupport::of(scene, &gap));
    let giving = scene.beam().springs().iter().zip(springs);
    let giving =
        giving.map(|(support, said)| (Giving::of(support, gap.shape.jet(support.at, false)), support.at, *said));
    let said = if springs.is_empty() { Vec::new() } else { with_said(giving, &mut load, &mut supports) };
    let turns = |about: &f64| !supports.iter().any(|s| s.is_fixed && (s.x - about).abs() <= 0.0);
    let balanced_at = match balance {
        Balance::Neutral { about, .. } => Some(about).filter(turns),
        Balance::Held | Balance::Stands(_) => None,
    };
    let beam = scene.beam();
    let (changes, mut joints): (Vec<f64>, Vec<(f64, f64)>) = (
        beam.changes().collect(),
        beam.joints().iter().map(|joint| (joint.at, joint.stiffness.unwrap_or(0.0))).collect(),
    );
    joints.sort_by(|a, b| a.0.total_cmp(&b.0));
    let ground_parts: Vec<([f64; 2], f64)> = scene.ground_parts().collect();
    let stiffest = beam.steps().iter().fold(stiffness, |most, step| most.max(step[1]));
    act(&EnclosedScene {
        gap,
        load: &load,
        supports: &supports,
        balanced_at,
        stiffness,
        stiffest,
        length,
        beam,
        ground: &ground_parts,
        changes: &changes,
        joints: &joints,
        said: &said,
        tension: beam.tension(),
        hung,
    })
}

/// Adds elastic supports as supports or as loads, depending on what is stated for each; returns those added as loads.
fn with_said(
    springs: impl Iterator<Item = (Giving, f64, (bool, [f64; 2]))>,
    load: &mut EnclosedLoad,
    supports: &mut Vec<EnclosedSupport>,
) -> Vec<SaidSpring> {
    let mut said = Vec::new();
    for (gives, x, (touches, [force, couple])) in springs {
        if !touches && (0.0 < force || !gives.pushes) {
            supports.push(EnclosedSupport::giving(x, gives, force));
            continue;
        }
        let force = if gives.pushes { force.max(0.0) } else { force };
        said.push(SaidSpring { x, gives, force, couple });
        load.points.push((x, Interval::exact(-force)));
        load.couples.extend(gives.turning.map(|_| (x, Interval::exact(couple))));
    }
    supports.sort_by(|a, b| a.x.total_cmp(&b.x));
    load.points.sort_by(|a, b| a.0.total_cmp(&b.0));
    load.couples.sort_by(|a, b| a.0.total_cmp(&b.0));
    said
}
