//! What must be true of what is refused, and of what is not: judged by the numbers of the draft, and by its statics in fractions.

use std::cmp::Ordering;

use palkki::scene::file::{FileError, Problem};
use palkki::scene::{Balance, Foundation, Quantity, Scene, SceneError, Support, Unheld};

use crate::authority::RBig;
use crate::authority::statics::{exactly, resultant_and_moment};

use super::trial::Trial;
use crate::draft::Draft;

/// What loads and ground do to a beam that its supports may leave free.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Statics {
    Held,
    Stands,
    /// Within what is not known of the last digits, at a border.
    Border,
    Falls,
}

/// The statics of a draft in fractions; [`None`] if its loads are none.
fn statics(draft: &Draft) -> Option<Statics> {
    let (load, length, grounded) = (draft.load().ok()?, draft.length, draft.ground.is_some());
    let within = exactly(5.0 * f64::EPSILON * load.magnitude(length) * length)?;
    let sign = |value: &RBig| match value {
        value if *value <= within && -value <= within => Ordering::Equal,
        value => value.cmp(&RBig::ZERO),
    };
    let turn = |about: f64| resultant_and_moment(&load, length, about).map(|[_, moment]| sign(&moment));
    Some(match draft.all_supports()[..] {
        [] if !grounded => Statics::Falls,
        [] => match [turn(0.0)?, turn(length)?.reverse()] {
            [Ordering::Less, _] | [_, Ordering::Less] => Statics::Falls,
            [Ordering::Greater, Ordering::Greater] => Statics::Stands,
            _ => Statics::Border,
        },
        [Support { at, slope: None, .. }] => match turn(at)? {
            Ordering::Equal => Statics::Border,
            Ordering::Greater if grounded && at < length => Statics::Stands,
            Ordering::Less if grounded && 0.0 < at => Statics::Stands,
            _ => Statics::Falls,
        },
        _ => Statics::Held,
    })
}

/// Whether the resultant of the loads is above a place.
fn above(draft: &Draft, about: f64) -> bool {
    let turn = draft.load().ok().and_then(|load| {
        let [_, moment] = resultant_and_moment(&load, draft.length, about)?;
        Some((moment, exactly(5.0 * f64::EPSILON * load.magnitude(draft.length) * draft.length)?))
    });
    turn.is_some_and(|(moment, within)| moment <= within && -moment <= within)
}

/// A scene is none of those that have to be refused, and is said to be held by what holds it.
pub(super) fn accepted(trial: &mut Trial, draft: &Draft, scene: &Scene) {
    /// Of the depth of the ground: far more than what is level but for rounding.
    const CLEARLY: f64 = 1e-9;
    let supports = draft.all_supports();
    if let Some(ground) = &draft.ground {
        for Support { at, level, .. } in &supports {
            if ground.depth(*at) < level - CLEARLY * (level.abs() + ground.magnitude(draft.length)) {
                trial.wrong.push(format!("a support at {at} below the ground is accepted"));
            }
        }
    }
    let scaled = scene.scaled();
    let unit = scaled.as_ref().map_or(1.0, |scaled| scaled.scale.length);
    let balance = scaled.map(|scaled| scaled.balance);
    let agree = match (statics(draft), &balance) {
        (None, _) | (_, Err(_)) | (Some(Statics::Held), Ok(Balance::Held)) => true,
        (Some(Statics::Stands), Ok(Balance::Stands(_))) => true,
        // On an inner crest, with the resultant above it.
        (Some(Statics::Stands), Ok(Balance::Neutral { about, .. })) => above(draft, about * unit),
        (Some(Statics::Border), Ok(balance)) => *balance != Balance::Held,
        (Some(_), Ok(_)) => false,
    };
    if !agree {
        trial.wrong.push(format!("{balance:?} of loads that are {:?}", statics(draft)));
    }
}

/// A refusal names its place in the file and a value, and what it says is so.
pub(super) fn refused(trial: &mut Trial, draft: &Draft, error: &FileError) {
    let message = error.problem.to_string();
    let place = error.place.as_ref().is_some_and(|place| 0 < place.line && 0 < place.column);
    let without_a_value = [Unheld::NothingPresses, Unheld::NothingCarries].map(|why| why.to_string());
    let told = message.contains(|c: char| c.is_ascii_digit()) || message.ends_with("is inf");
    let value = told || without_a_value.contains(&message);
    if !place || !value {
        trial.wrong.push(format!("a refusal without a place or a value: {message}"));
    }
    if let Problem::Scene { error, .. } = &error.problem
        && !so(draft, error)
    {
        trial.wrong.push(format!("refused without a reason: {message}"));
    }
}

/// Whether a refusal is so, of those that supports and shapes are refused with. Others have tests of their own.
fn so(draft: &Draft, error: &SceneError) -> bool {
    /// Supports that are farther apart, as a share of the beam, have to be accepted.
    const NEAR: f64 = 5e-10;
    let supports = draft.all_supports();
    let at_support = |at: f64| supports.iter().find(|s| (s.at - at).abs() <= 0.0);
    let ground = draft.ground.as_ref();
    match *error {
        SceneError::OutsideBeam { quantity: Quantity::SupportAt(i), value, length } => {
            let named = supports.get(i).is_some_and(|s| (s.at - value).abs() <= 0.0);
            named && !(0.0..=length).contains(&value)
        }
        SceneError::SupportsTooClose { quantity: Quantity::SupportAt(i), value, other, .. } => {
            let at = |s: &Support, place: f64| (s.at - place).abs() <= 0.0;
            let named = supports.get(i).is_some_and(|s| at(s, value));
            let beside = supports.iter().enumerate().any(|(j, s)| j != i && at(s, other));
            named && beside && (value - other).abs() <= NEAR * draft.length
        }
        SceneError::AboveSupport { at, .. } => {
            at_support(at).is_some_and(|s| ground.is_some_and(|ground| ground.depth(at) < s.level))
        }
        SceneError::RisesAtBuiltIn { at, .. } => at_support(at).is_some_and(|s| s.slope.is_some() && ground.is_some()),
        SceneError::ValleyAtSupport { at, .. } => at_support(at).is_some_and(|s| s.slope.is_none() && ground.is_some()),
        SceneError::CornerAtBuiltIn { at } => {
            at_support(at).is_some_and(|s| s.slope.is_some()) && draft.shape.is_some()
        }
        SceneError::Coefficients { count, .. } => match ground {
            Some(Foundation::Polynomial { coefficients }) => 10 < count && coefficients[count - 1] != 0.0,
            _ => false,
        },
        SceneError::Unheld(_) => matches!(statics(draft), None | Some(Statics::Falls | Statics::Border)),
        _ => true,
    }
}
