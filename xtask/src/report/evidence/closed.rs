//! Beam theory with free lift-off points beside closed forms, for the scenes that have one.

use palkki::scene::PointLoad;
use palkki::theory::Exact;
use palkki_evidence::closed::{flat, incline, lifted, parabola};

use super::prelude::*;

/// Twelve digits are what the check of the exact solution asks for, of reactions and the resultant of the contact.
const DIGITS: f64 = 1e-12;

/// How far anything may be from its closed form, over the load, the length or the energy.
const AGREES: f64 = 1e-11;

pub(super) fn evidence(study: &Study<'_>) -> Result<Evidence, Cause> {
    let (mut count, mut worst) = (0, 0.0_f64);
    for (name, scene) in scenes::all(study.root)? {
        let exact = theory::solve(&scene)?;
        checked(&name, &scene, &exact)?;
        if let Some(off) = closed(&scene).and_then(|(_, closed)| closed.differences(&scene, &exact).0) {
            (count, worst) = (count + 1, worst.max(off));
        }
    }
    let example = palkki_evidence::paper::theory();
    Ok(Evidence::new(context! {
        count,
        most => bound(DIGITS),
        agree => worst <= DIGITS,
        unknowns => theory::solve(&palkki_evidence::paper::example()?)?.unknowns,
        lift_off => example.lift_off,
        reaction => example.reaction,
    }))
}

/// The closed form of a scene, if it has one that is known: beam theory agrees with it.
pub(super) fn checked(name: &str, scene: &Scene, exact: &Exact) -> Result<Option<&'static str>, Cause> {
    let Some((formula, closed)) = closed(scene) else { return Ok(None) };
    let (_, off) = closed.differences(scene, exact);
    if AGREES < off {
        return Err(format!("beam theory differs from the closed form by {off:e} in {name}").into());
    }
    Ok(Some(formula))
}

/// What follows from a closed form.
#[derive(Default)]
pub(super) struct Closed {
    contact: f64,
    reactions: Option<[f64; 2]>,
    energy: Option<f64>,
    /// Ends of the zones, and the forces there.
    zones: Vec<[[f64; 2]; 2]>,
}

impl Closed {
    /// Of one zone: the forces of both supports, its ends, the forces there, all of its force, and the energy.
    fn zone(reactions: [f64; 2], zone: [f64; 2], ends: [f64; 2], contact: f64, energy: f64) -> Self {
        Self { reactions: Some(reactions), zones: vec![[zone, ends]], contact, energy: Some(energy) }
    }

    /// How far beam theory is from it: reactions and contact force over the load, if it has reactions; and everything.
    fn differences(&self, scene: &Scene, exact: &Exact) -> (Option<f64>, f64) {
        let (state, load, length) = (&exact.state, load(scene), scene.beam().length());
        let contact = (state.contact_force() - self.contact).abs() / load;
        let reactions = [state.reactions.left, state.reactions.right];
        let of_reactions = self.reactions.map(|closed| largest([contact, apart_if_any(&closed, &reactions) / load]));
        let of_energy = self.energy.map_or(0.0, |energy| (state.energy - energy).abs() / energy.abs());
        let found = state.contacts.iter().filter_map(|c| Some([[c.from, c.to], c.end_forces?]));
        let mut all = vec![of_reactions.unwrap_or(contact), of_energy];
        for (found, closed) in found.zip(&self.zones) {
            all.extend([apart_if_any(&found[0], &closed[0]) / length, apart_if_any(&found[1], &closed[1]) / load]);
        }
        (of_reactions, largest(all))
    }
}

/// A closed form in words, and what follows from it.
type Form = (&'static str, Closed);

/// The closed form of a scene, if it has one that is known. Derivations: `tests/evidence/src/closed/simple.rs`.
fn closed(scene: &Scene) -> Option<Form> {
    if !scene.load().linear().is_empty() {
        return None;
    }
    if !scene.beam().is_simple() {
        return on_elastic_bearings(scene);
    }
    match (scene.foundation()?, scene.load().point()) {
        (Foundation::Flat { .. }, []) => on_level_ground(scene),
        (Foundation::Flat { .. }, [lift]) => lifted_off_level_ground(scene, lift),
        (Foundation::Polynomial { coefficients }, []) if coefficients.len() == 2 => on_an_incline(scene),
        (Foundation::Polynomial { coefficients }, points) => match coefficients[..] {
            [_, slope, bend] => on_a_parabola(scene, [slope, bend], points),
            _ => None,
        },
        (Foundation::Polyline { points }, [load]) => match points[..] {
            [_, [kink, _], _] if kink < load.at => on_a_kink(scene, kink, load),
            _ => None,
        },
        _ => None,
    }
}

/// Length and bending stiffness of the beam, and the uniform load.
fn numbers(scene: &Scene) -> (f64, f64, f64) {
    (scene.beam().length(), scene.beam().bending_stiffness(), scene.load().uniform())
}

/// Three equal bearings under two equal spans: the simple beam on the outer ones and the force of the middle one.
fn on_elastic_bearings(scene: &Scene) -> Option<Form> {
    let (l, ei, q) = numbers(scene);
    let supports = scene.beam().all_supports();
    let places: Vec<f64> = supports.iter().map(|support| support.at).collect();
    let k = supports.first()?.stiffness?;
    let plain = scene.foundation().is_none() && scene.load().point().is_empty() && scene.load().couple().is_empty();
    if !plain || places != [0.0, 0.5 * l, l] || supports.iter().any(|support| support.stiffness != Some(k)) {
        return None;
    }
    let middle = (5.0 * q * l.powi(4) / (384.0 * ei) + 0.5 * q * l / k) / (l.powi(3) / (48.0 * ei) + 1.5 / k);
    Some((
        "R = (5 q l⁴/(384 EI) + q l/(2k)) / (l³/(48 EI) + 3/(2k)) on the pier, with the length l of both spans and the stiffness k of each bearing",
        Closed { reactions: Some([0.5 * (q * l - middle); 2]), ..Closed::default() },
    ))
}

fn on_level_ground(scene: &Scene) -> Option<Form> {
    let (l, ei, q) = numbers(scene);
    let e = flat(l, ei, scene.depth(0.0), q);
    let a = e.lift_off?;
    Some(if a < 0.5 * l {
        (
            "a⁴ = 24 EI u₀/q, T = q a/2, zone from a to l − a, force T at each end of it, J = −q u₀ (l − 4a/5)",
            Closed::zone([e.reaction; 2], [a, l - a], [e.end_force; 2], e.contact_force, e.energy),
        )
    } else {
        let (reactions, energy) = (Some([e.reaction; 2]), Some(e.energy));
        (
            "F = 5 q l/8 − 48 EI u₀/l³ at mid-span, T = (q l − F)/2, J = −q² l⁵/(240 EI) + F² l³/(96 EI)",
            Closed { reactions, contact: e.contact_force, energy, zones: Vec::new() },
        )
    })
}

fn lifted_off_level_ground(scene: &Scene, lift: &PointLoad) -> Option<Form> {
    let (l, ei, q) = numbers(scene);
    if 0.0 <= lift.force || f64::EPSILON * l < (lift.at - 0.5 * l).abs() {
        return None;
    }
    let e = lifted(l, ei, scene.depth(0.0), q, -lift.force)?;
    let ends = [e.reaction, e.inner_force];
    let mut values = Closed::zone([e.reaction; 2], e.zones[0], ends, 2.0 * e.zone_force, e.energy);
    values.zones.push([e.zones[1], [ends[1], ends[0]]]);
    Some(("a⁴ = 24 EI u₀/q, T = q a/2, gap g = 3P/(2q) below the lift P, force P/4 at each end of the gap", values))
}

fn on_an_incline(scene: &Scene) -> Option<Form> {
    let (l, ei, q) = numbers(scene);
    let e = incline(l, ei, [scene.depth(0.0), scene.depth(l)], q)?;
    let ends = [e.lift_off[0], l - e.lift_off[1]];
    Some((
        "at each end a⁴ = 24 EI u/q with the depth u below that support, T = q a/2, force T at the end of the zone",
        Closed::zone(e.reactions, ends, e.reactions, e.contact_force, e.energy),
    ))
}

fn on_a_parabola(scene: &Scene, [slope, bend]: [f64; 2], points: &[PointLoad]) -> Option<Form> {
    let (l, ei, q) = numbers(scene);
    let is_symmetric = (slope + bend * l).abs() <= 4.0 * f64::EPSILON * slope.abs();
    let e = parabola(l, ei, scene.depth(0.0), scene.depth(0.5 * l) - scene.depth(0.0), q);
    let a = e.lift_off.filter(|_| 0.0 < e.end_force && is_symmetric)?;
    // A point load on the zone goes straight into the ground.
    if !points.iter().all(|p| a < p.at && p.at < l - a) {
        return None;
    }
    let contact = e.contact_force + points.iter().map(|p| p.force).sum::<f64>();
    let energy = e.energy - points.iter().map(|p| p.force * scene.depth(p.at)).sum::<f64>();
    Some((
        "with w = u″: q a⁴/(24 EI) + w a²/6 = u(0), T = q a/2 − EI w/a, force q a/2 + EI w/a at each end of the zone; \
         the point load is carried where it acts",
        Closed::zone([e.reaction; 2], [a, l - a], [e.end_force; 2], contact, energy),
    ))
}

/// `a` is the place of the kink, to the left of the point load.
fn on_a_kink(scene: &Scene, a: f64, load: &PointLoad) -> Option<Form> {
    let (l, ei, q) = numbers(scene);
    let (b, c) = (l - a, l - load.at);
    let by_load = q * a * (l * l * l - 2.0 * l * a * a + a * a * a) / (24.0 * ei);
    let free = by_load + load.force * c * a * (l * l - c * c - a * a) / (6.0 * ei * l);
    let contact = (free - scene.depth(a)) * 3.0 * ei * l / (a * a * b * b);
    Some((
        "F = (v₀ − u) 3 EI l/(a² b²) at the kink, at a and b from the supports, with the deflection v₀ of the simple \
         beam there",
        Closed { contact, ..Closed::default() },
    ))
}
