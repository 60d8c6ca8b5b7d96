//! Derivatives of answers against differences of solves.

use palkki::scene::{Quantity, Scene, Support};
use palkki::theory::{By, Derivative, Exact};

use super::laws::{certified, exceeds, sizes};
use super::trial::Trial;
use crate::definition::moved_on_waves;
use crate::draft::Draft;
use crate::random::Random;

/// Steps, as shares of the size of what is varied.
const STEPS: [f64; 2] = [1e-4, 1e-5];

/// The same scene with a number changed by a step.
fn beside(scene: &Scene, by: By, step: f64) -> Option<Scene> {
    match by {
        By::Depth => scene.with_ground_moved(step).ok(),
        By::Number(quantity) => scene.with_number(quantity, scene.number(quantity)? + step).ok(),
    }
}

/// What derivatives are told of: forces of supports, the forces and places of contacts, the energy.
fn numbers(exact: &Exact) -> Vec<f64> {
    let state = &exact.state;
    let supports = state.supports.iter().map(|s| s.force);
    let contacts = state.contacts.iter().flat_map(|c| [c.force, c.from, c.to]);
    supports.chain([state.energy]).chain(contacts).collect()
}

fn claimed(derivative: &Derivative) -> Vec<f64> {
    let contacts = derivative.contacts.iter().flat_map(|c| [c.force, c.from, c.to]);
    derivative.supports.iter().copied().chain([derivative.energy]).chain(contacts).collect()
}

/// Rounding of numbers, as a share of what they are made of.
const ROUNDING: f64 = 1e-11;

/// What a number is made of.
struct Made {
    most: f64,
    is_force: bool,
}

/// What the numbers that derivatives are told of are made of: a force of the shear forces beside it, whatever the largest force is, but
/// for a unit in the last place of that, and on waves for one of the places.
fn made_of(scene: &Scene, exact: &Exact, force: f64, size: f64) -> Vec<Made> {
    let length = scene.beam().length();
    let [_, moved] = moved_on_waves(scene, f64::EPSILON * length);
    let least = (f64::EPSILON * force).max(moved) / ROUNDING;
    let at = |x: f64| exact.shear(x).into_iter().fold(least, |most: f64, shear| most.max(shear.abs()));
    let force_of = |own: f64, places: [f64; 2]| Made {
        most: places.map(at).into_iter().fold(own.abs(), f64::max),
        is_force: true,
    };
    let other = |most: f64| Made { most, is_force: false };
    let supports = exact.state.supports.iter().map(|s| force_of(s.force, [s.at; 2]));
    let contacts = exact.state.contacts.iter();
    let contacts = contacts.flat_map(|c| [force_of(c.force, [c.from, c.to]), other(length), other(length)]);
    supports.chain([other(force * size)]).chain(contacts).collect()
}

/// A difference quotient in a step and in twice the step; the latter says how far the former is off.
fn quotients(here: &[f64], scene: &Scene, by: By, step: f64, sides: [f64; 2]) -> Option<Vec<[f64; 2]>> {
    let at = |share: f64| {
        if share == 0.0 { Some(here.to_vec()) } else { Some(numbers(&certified(&beside(scene, by, share * step)?)?)) }
    };
    let quotient = |times: f64| {
        let [a, b] = [at(times * sides[0])?, at(times * sides[1])?];
        if a.len() != here.len() || b.len() != here.len() {
            return None;
        }
        Some(a.iter().zip(&b).map(|(a, b)| (b - a) / (times * step * (sides[1] - sides[0]))).collect::<Vec<f64>>())
    };
    let [one, two] = [quotient(1.0)?, quotient(2.0)?];
    Some(one.into_iter().zip(two).map(|(a, b)| [a, b]).collect())
}

/// The place that is moved, if one is.
fn moves(scene: &Scene, by: By) -> Option<f64> {
    match by {
        By::Number(quantity @ (Quantity::PointAt(_) | Quantity::SupportAt(_))) => scene.number(quantity),
        _ => None,
    }
}

/// What a derivative is wrong by: the place in its list, what it is claimed to be, and the quotients.
type Wrong = (usize, [f64; 3]);

/// A derivative that is not flagged is that of both sides, another that of one side at least: what each comparison says, as far as
/// there is an answer on that side.
fn compared(scene: &Scene, exact: &Exact, derivative: &Derivative) -> Vec<Option<Wrong>> {
    /// A force that is a smaller share of those beside is lost in their rounding, after the step that it asks for.
    const TOLD: f64 = 1e-6;
    /// Half the step halves what the quotients are off by, or, where a zone ends without pressure, divides it by a root of two: they are
    /// off by the third root of the step where a load falls to zero at a corner of the ground. The fourth root of one half.
    const NEARER: f64 = 0.841;
    let (force, size) = sizes(scene, &exact.state);
    let length = scene.beam().length();
    let unit = match derivative.by {
        By::Depth | By::Number(Quantity::SupportLevel(_)) => size,
        By::Number(Quantity::BendingStiffness) => scene.beam().bending_stiffness(),
        By::Number(Quantity::Uniform) => force / length,
        By::Number(Quantity::PointForce(_)) => force,
        By::Number(_) => length,
    };
    let (here, claimed) = (numbers(exact), claimed(derivative));
    let sides: &[[f64; 2]] = if derivative.one_sided { &[[-1.0, 0.0], [0.0, 1.0]] } else { &[[-1.0, 1.0]] };
    // Of a derivative that does not exist at all the quotients grow, by less than the double from a step to its half.
    let agree = if derivative.one_sided { 2.0 } else { 8.0 };
    let sizes = made_of(scene, exact, force, size);
    // Where a large force moves, or ground is nearly level with a support, small forces are others after any part of the unit.
    let forces = here.iter().zip(&claimed).zip(&sizes).filter(|(_, size)| size.is_force);
    let own = forces.filter(|((now, change), size)| TOLD * size.most <= now.abs() && 0.0 < change.abs());
    let own = own.fold(unit, |least, ((now, change), _)| least.min((now / change).abs()));
    // The smaller step sees no other kind of answer, the larger one is above rounding.
    let shares = [STEPS[0] * unit, STEPS[1] * unit, STEPS[0] * own];
    let steps = shares.into_iter().filter(|step| step.is_normal());
    let tried = steps.flat_map(|step| sides.iter().map(move |side| (step, *side)));
    let found = tried.filter_map(|(step, side)| {
        let found = quotients(&here, scene, derivative.by, step, side)?;
        found.iter().flatten().all(|value| value.is_finite()).then_some((step, found))
    });
    let wrong = |(step, found): (f64, Vec<[f64; 2]>)| {
        found.iter().zip(&claimed).zip(&sizes).enumerate().find_map(|(i, ((&[one, two], &claimed), size))| {
            let most = agree * (one - two).abs() + ROUNDING * size.most / step + 1e-5 * one.abs();
            // Said to have none: whether there is one is another question.
            let none = claimed.is_nan() && derivative.missing.is_some();
            let comes_nearer = derivative.one_sided && (claimed - one).abs() <= NEARER * (claimed - two).abs();
            (!none && !comes_nearer && exceeds((claimed - one).abs(), most)).then_some((i, [claimed, one, two]))
        })
    };
    found.map(wrong).collect()
}

/// Derivatives against differences of solves in a step and in twice the step.
pub(super) fn derivatives(trial: &mut Trial, draft: &Draft, scene: &Scene, exact: &Exact, random: &mut Random) {
    /// Ground nearer to the level of a support, as a share of the deflection, is passed by the steps.
    const NEAR: f64 = 1e-2;
    let (_, size) = sizes(scene, &exact.state);
    let gap = |s: &Support| draft.ground.as_ref().map_or(size, |ground| ground.depth(s.at) - s.level);
    let near = draft.all_supports().iter().map(gap).any(|gap| 0.0 < gap && gap < NEAR * size);
    let all = exact.derivatives(scene);
    if all.is_empty() || near {
        return;
    }
    let length = draft.length;
    for _ in 0..4 {
        let derivative = &all[random.below(all.len())];
        if let Some(at) = moves(scene, derivative.by) {
            // What is nearer than the steps, and not at the place, is passed on the way.
            let passed = |x: f64| (x < at || at < x) && (x - at).abs() <= 4.0 * STEPS[0] * length;
            let places = exact.state.contacts.iter().flat_map(|c| [c.from, c.to]);
            let places = places.chain(draft.places()).chain(exact.state.supports.iter().map(|s| s.at));
            if places.into_iter().any(passed) {
                continue;
            }
        }
        let (told, here) = (claimed(derivative).len(), numbers(exact).len());
        if told != here {
            trial.wrong.push(format!("derivative by {}: {told} numbers for {here}", derivative.by));
            continue;
        }
        let compared = compared(scene, exact, derivative);
        trial.derived |= !compared.is_empty();
        let wrong: Vec<Wrong> = compared.iter().flatten().copied().collect();
        if let Some((i, [claimed, one, two])) = wrong.first().filter(|_| wrong.len() == compared.len()) {
            let flag = if derivative.one_sided { "one-sided " } else { "" };
            trial.wrong.push(format!(
                "{flag}derivative by {}, number {i}: {claimed:e}, differences are {one:e} and {two:e}",
                derivative.by
            ));
        }
    }
}
