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

/// What derivatives are told of: forces of supports, the energy and the total contact force, the forces and places of contacts.
fn numbers(exact: &Exact) -> Vec<f64> {
    let state = &exact.state;
    let supports = state.supports.iter().map(|s| s.force);
    let contacts = state.contacts.iter().flat_map(|c| [c.force, c.from, c.to]);
    supports.chain([state.energy, state.contact_force()]).chain(contacts).collect()
}

fn claimed(derivative: &Derivative) -> Vec<f64> {
    let contacts = derivative.contacts.iter().flat_map(|c| [c.force, c.from, c.to]);
    let Derivative { energy, contact_force, .. } = *derivative;
    derivative.supports.iter().copied().chain([energy, contact_force]).chain(contacts).collect()
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
    supports.chain([other(force * size), Made { most: force, is_force: true }]).chain(contacts).collect()
}

/// A difference quotient in a step and in twice the step; the latter says how far the former is off. Where other contacts press after a
/// step, single contacts are left out, and supports, energy and the total contact force are compared.
fn quotients(here: &[f64], scene: &Scene, by: By, step: f64, sides: [f64; 2]) -> Option<Vec<[f64; 2]>> {
    let at = |share: f64| {
        if share == 0.0 { Some(here.to_vec()) } else { Some(numbers(&certified(&beside(scene, by, share * step)?)?)) }
    };
    let supports = scene.beam().supports_as_given().len();
    let quotient = |times: f64| {
        let [a, b] = [at(times * sides[0])?, at(times * sides[1])?];
        let kept = if [a.len(), b.len()] == [here.len(); 2] { here.len() } else { supports + 2 };
        Some(
            a.iter()
                .zip(&b)
                .take(kept)
                .map(|(a, b)| (b - a) / (times * step * (sides[1] - sides[0])))
                .collect::<Vec<f64>>(),
        )
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

/// The least change of the number after which a contact that moves as fast as is said comes to one of these places, or to another contact:
/// a quotient over more of it is that of another kind of answer.
fn passes(exact: &Exact, derivative: &Derivative, places: &[f64]) -> f64 {
    let contacts = exact.state.contacts.iter().zip(&derivative.contacts);
    let ends: Vec<[f64; 2]> = contacts.flat_map(|(c, by)| [[c.from, by.from], [c.to, by.to]]).collect();
    let others = || places.iter().copied().chain(ends.iter().map(|[at, _]| *at));
    let nearest = |at: f64| others().map(|x| (x - at).abs()).filter(|d| 0.0 < *d).fold(f64::INFINITY, f64::min);
    // Not a number counts as none.
    ends.iter().map(|[at, speed]| nearest(*at) / speed.abs()).fold(f64::INFINITY, f64::min)
}

/// What a derivative is wrong by: the place in its list, what it is claimed to be, and the quotients.
type Wrong = (usize, [f64; 3]);

/// A derivative that is not flagged is that of both sides, another that of one side at least: what each comparison says, as far as
/// there is an answer on that side. At `places` contacts change their kind.
fn compared(scene: &Scene, exact: &Exact, derivative: &Derivative, places: &[f64]) -> Vec<Option<Wrong>> {
    /// A force that is a smaller share of those beside is lost in their rounding, after the step that it asks for.
    const TOLD: f64 = 1e-6;
    /// Part of the way to another kind of answer over which the quotients of both steps are compared.
    const ON_THE_WAY: f64 = 1e-2;
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
    let passes = passes(exact, derivative, places);
    let on_the_way = Some(ON_THE_WAY * passes).filter(|step| *step < STEPS[1] * unit);
    let shares = [STEPS[0] * unit, STEPS[1] * unit, STEPS[0] * own].into_iter().chain(on_the_way);
    let steps = shares.filter(|step| step.is_normal() && 2.0 * step < passes);
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
    let supports = exact.state.supports.iter().map(|s| s.at);
    let places: Vec<f64> = draft.places().into_iter().chain(supports).collect();
    for _ in 0..4 {
        let derivative = &all[random.below(all.len())];
        if let Some(at) = moves(scene, derivative.by) {
            // What is nearer than the steps, and not at the place, is passed on the way.
            let passed = |x: f64| (x < at || at < x) && (x - at).abs() <= 4.0 * STEPS[0] * length;
            let contacts = exact.state.contacts.iter().flat_map(|c| [c.from, c.to]);
            if contacts.chain(places.iter().copied()).any(passed) {
                continue;
            }
        }
        let (told, here) = (claimed(derivative).len(), numbers(exact).len());
        if told != here {
            trial.wrong.push(format!("derivative by {}: {told} numbers for {here}", derivative.by));
            continue;
        }
        let compared = compared(scene, exact, derivative, &places);
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

#[cfg(test)]
mod tests {
    use super::*;
    use palkki::scene::Foundation;
    use palkki::theory;

    /// A load above a crest of the ground, or above a slope of it, where the contact is at a millionth of the beam from the load: a support
    /// that moves takes it past the load after that much, and force and place change otherwise from there on. With the derivative of an
    /// answer the law is content, and not with another one.
    #[test]
    fn a_step_does_not_take_a_contact_past_a_load() {
        let mut past = 0;
        for k in 1..=24_u32 {
            let (at, depth) = (0.2 + 0.02 * f64::from(k % 6), 1e-9 * f64::from(k));
            let coefficients = vec![depth, depth, -depth];
            let draft = Draft {
                length: 1.0,
                stiffness: 1.0,
                ground: Some(Foundation::Polynomial { coefficients }),
                ..Draft::default()
            };
            let draft = draft.with_points(&[(at, 1.0), (1.0, 1.0)]);
            let scene = draft.scene().expect("a scene");
            let exact = theory::solve(&scene).expect("an answer");
            let all = exact.derivatives(&scene);
            let by = |d: &&Derivative| d.by == By::Number(Quantity::SupportAt(1));
            let derivative = all.iter().find(by).expect("a derivative");
            past += usize::from(passes(&exact, derivative, &draft.places()) < STEPS[1]);
            let other =
                Derivative { supports: derivative.supports.iter().map(|by| 1.1 * by).collect(), ..derivative.clone() };
            for (derivative, right) in [(derivative, true), (&other, false)] {
                let compared = compared(&scene, &exact, derivative, &draft.places());
                assert_eq!(compared.iter().any(Option::is_none), right, "{k}: {compared:?}");
            }
        }
        assert!(past > 12, "{past} contacts are near a load");
    }
}
