//! What forces and deflections of a certified answer have to be, by laws that need no other answer than proven energies and statics.
//!
//! The least energy `J*` is convex in the levels of supports and the depth of the ground, jointly, and concave in the forces of loads.
//! So a derivative of it, a reaction, the sum of the contact forces or a deflection under a load, lies between the difference quotients
//! to its two sides, and these between what is proven of the three energies.

use palkki::certificate::{Judged, certify};
use palkki::scene::{Foundation, PointLoad, Quantity, Scene, Support};
use palkki::state::ContactState;
use palkki::theory::{self, Exact};
use palkki::verdict::{USABLE, Verdict};

use super::laws::{CERTAIN, exceeds, flexibility, grounded, sizes};
use super::trial::Trial;
use crate::draft::Draft;

/// Steps to each side, as shares of the size of what is varied.
const STEPS: [f64; 4] = [1e-1, 1e-2, 1e-3, 1e-5];

/// Of a certified answer the guaranteed error is a small share of its deflection; of a beam that does not move, of what its loads
/// would do to it.
pub(super) fn backed(trial: &mut Trial, who: &str, scene: &Scene, state: &ContactState, verdict: &Verdict) {
    if verdict.refusal.is_some() {
        return;
    }
    let error = verdict.certificate.as_ref().map_or(f64::INFINITY, |c| c.deflection_error);
    let share = if state.nodes.is_some() { USABLE } else { CERTAIN };
    let size = state.deflection.magnitude();
    let free = flexibility(scene) * scene.load().magnitude(scene.beam().length());
    // Beams move by no less than what rounding of their loads does to them; and bounds are rounded outwards, of what is nothing to
    // the least number times the powers of two that the scene is scaled by, where numbers have no digits left. Where nothing at all
    // says how large deflections are, a bound is the root of the least energy.
    let nothing = if size + free == 0.0 { f64::MIN_POSITIVE.sqrt() } else { f64::MIN_POSITIVE / f64::EPSILON };
    let rounding = 64.0 * f64::EPSILON * free + nothing;
    if exceeds(error, (1.0 + 1e-9) * (share * size).max(rounding)) {
        trial.wrong.push(format!("{who}: certified with an error of {error:e} of {size:e}"));
    }
}

/// What stands does not fall.
pub(super) fn stands(trial: &mut Trial, state: &ContactState) {
    if let Some(standing) = state.standing.filter(|standing| standing.margin < -CERTAIN) {
        trial.wrong.push(format!("theory: it stands with a margin of {}", standing.margin));
    }
}

/// Nowhere is the beam inside the ground by what a force that is felt beside there would take away, and more than rounding.
pub(super) fn locally(trial: &mut Trial, draft: &Draft, scene: &Scene, exact: &Exact) {
    let (Some(ground), length) = (&draft.ground, draft.length) else { return };
    let (state, (force, _)) = (&exact.state, sizes(scene, &exact.state));
    // A force beside one that dwarfs it counts by itself, but for the last digits of that.
    let least = 1e-9 * force;
    let contacts = state.contacts.iter().flat_map(|c| [c.from, c.to]);
    let places: Vec<f64> = state.supports.iter().map(|s| s.at).chain(contacts).collect();
    let held = |x: f64| places.iter().map(|at| (at - x).abs()).fold(f64::INFINITY, f64::min);
    for at in &places {
        for k in 1..40 {
            for side in [1.0, -1.0] {
                let x = at + side * length * libm::exp2(-f64::from(k));
                if !(0.0..=length).contains(&x) {
                    continue;
                }
                let inside = -exact.clearance(x);
                let own = draft.shape.as_ref().map_or(0.0, |own| own.magnitude_at(x));
                let rounding = 16.0 * f64::EPSILON * (ground.magnitude_at(x) + own + exact.deflection(x).abs());
                let lever = held(x);
                let force = inside * 3.0 * draft.stiffness / (lever * lever * lever);
                let beside =
                    exact.shear(x).into_iter().chain(exact.shear(*at)).fold(least, |most: f64, v| most.max(v.abs()));
                if rounding < inside && exceeds(force, CERTAIN * beside) {
                    trial.wrong.push(format!("theory: {inside:e} inside the ground at {x}, {lever:e} beside {at}"));
                    return;
                }
            }
        }
    }
}

/// What is proven of the energy of a scene, from the contacts of beam theory.
fn energy(scene: &Scene) -> Option<[f64; 2]> {
    let exact = theory::solve(scene).ok()?;
    let certificate = certify(scene, Judged::Witness, &exact.state.contacts).ok()?;
    let bounds = [certificate.energy_lower, certificate.energy_upper];
    bounds.iter().all(|bound| bound.is_finite()).then_some(bounds)
}

/// What the derivative of a convex function lies between at zero, from bounds of its values there and at some steps to both sides.
fn between(here: [f64; 2], at: impl Fn(f64) -> Option<[f64; 2]>, size: f64) -> [f64; 2] {
    let mut bracket = [f64::NEG_INFINITY, f64::INFINITY];
    for step in STEPS.map(|share| share * size) {
        if let Some([_, upper]) = at(-step) {
            bracket[0] = bracket[0].max((here[0] - upper) / step);
        }
        if let Some([_, upper]) = at(step) {
            bracket[1] = bracket[1].min((upper - here[0]) / step);
        }
    }
    bracket
}

/// Reactions and the sum of contact forces are derivatives of the energy.
pub(super) fn castigliano(trial: &mut Trial, scene: &Scene, exact: &Exact) {
    let Some(here) = energy(scene) else { return };
    let (force, size) = sizes(scene, &exact.state);
    // Levels, and what is felt of them beside each other.
    let mut wrong = |what: String, value: f64, [least, most]: [f64; 2], size: f64| {
        if exceeds(least - value, CERTAIN * size) || exceeds(value - most, CERTAIN * size) {
            trial.wrong.push(format!("theory: certified, but {what} is {value:e} and not in [{least:e}, {most:e}]"));
        }
    };
    let given = scene.beam().supports_as_given();
    for support in exact.state.supports.iter().take(6) {
        let Some(i) = given.iter().position(|s| s.at <= support.at && support.at <= s.at) else { continue };
        // Ground at the level of a support takes part in its force, and not in its movement.
        if grounded(scene, support.at, given[i].level, size) {
            continue;
        }
        let quantity = Quantity::SupportLevel(i);
        let at = |step: f64| energy(&scene.with_number(quantity, given[i].level + step).ok()?);
        // J' = −R.
        let [least, most] = between(here, at, size);
        wrong(
            format!("the force at {}", support.at),
            support.force,
            [-most, -least],
            support.force.abs().max(1e-3 * force),
        );
    }
    if scene.foundation().is_some() {
        let [least, most] = between(here, |step| energy(&scene.with_ground_moved(step).ok()?), size);
        let sum = exact.state.contact_force();
        // Ground at the level of a support shares its force with it.
        if least.is_finite() && most.is_finite() {
            wrong("the contact force".to_owned(), sum, [-most, -least], sum.abs().max(1e-3 * force));
        }
    }
    // −J is convex in a load, with −J' = v.
    for (i, load) in scene.load().point().iter().enumerate().take(3) {
        let quantity = Quantity::PointForce(i);
        let at = |step: f64| {
            let [lower, upper] = energy(&scene.with_number(quantity, load.force + step).ok()?)?;
            Some([-upper, -lower])
        };
        let bracket = between([-here[1], -here[0]], at, force);
        if exact.state.standing.is_none_or(|standing| standing.motion.is_none()) {
            // An own shape counts from where it is.
            wrong(format!("the deflection at {}", load.at), exact.deflection(load.at), bracket, size);
        }
    }
}

/// A single load above a crest of points that lies above all chords of others, or above the one support: the crest carries it, and the
/// beam turns freely between the slopes at which it touches another point.
pub(super) fn in_balance(trial: &mut Trial, draft: &Draft, exact: Option<&Exact>, certified: bool) {
    let Draft { length, uniform, linear, point, ground, supports: Some(supports), shape: None, .. } = draft else {
        return;
    };
    let ([PointLoad { at, force }], Some(Foundation::Polyline { points }), true) =
        (&point[..], ground, linear.is_empty())
    else {
        return;
    };
    if *uniform != 0.0 || !(0.0 < *force && 0.0 < *at && at < length) {
        return;
    }
    let depth = match supports[..] {
        [] => points.iter().filter(|p| p[0] <= *at && *at <= p[0]).map(|p| p[1]).fold(f64::INFINITY, f64::min),
        [Support { at: held, level, slope: None, .. }] if held <= *at && *at <= held => level,
        _ => return,
    };
    if !depth.is_finite() {
        return;
    }
    let slope = |p: &[f64; 2]| (p[1] - depth) / (p[0] - at);
    let least = points.iter().filter(|p| p[0] < *at).map(slope).fold(f64::NEG_INFINITY, f64::max);
    let most = points.iter().filter(|p| *at < p[0]).map(slope).fold(f64::INFINITY, f64::min);
    // Otherwise a load between crests bends the beam.
    if most < least {
        return;
    }
    let Some(exact) = exact.filter(|_| certified) else {
        trial.wrong.push(format!("in balance above {at} with slopes from {least} to {most}, and not certified"));
        return;
    };
    // With one position that is not motion.
    if most - least < 1e-6 * (least.abs() + most.abs()) || most <= least {
        return;
    }
    let Some(motion) = exact.state.standing.and_then(|standing| standing.motion) else {
        trial.wrong.push(format!("in balance above {at} with slopes from {least} to {most}, and said to be at rest"));
        return;
    };
    let off = |found: Option<f64>, slope: f64| found.map_or(f64::INFINITY, |found| (found - slope).abs());
    let size = least.abs().max(most.abs());
    if exceeds(off(motion.slope[0], least).max(off(motion.slope[1], most)), CERTAIN * size) {
        trial.wrong.push(format!("in balance with slopes from {least} to {most}, and not {:?}", motion.slope));
    }
}
