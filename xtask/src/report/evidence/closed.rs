//! Beam theory with free lift-off points beside closed forms, for the scenes that have one.

use palkki::theory::Exact;
use palkki::theory::closed::{incline, lifted, parabola};
use palkki::theory::flat;

use super::prelude::*;

/// Twelve digits are what the check of the exact solution asks for.
const DIGITS: f64 = 1e-12;

/// Names of quantities, as the cards of the gallery have them.
pub(super) const REACTIONS: &str = "reactions, left and right";
pub(super) const CONTACT: &str = "contact force, total";
const ZONES: [&str; 2] = ["zone 1, from and to", "zone 2, from and to"];
const ENDS: [&str; 2] = ["forces at the ends of zone 1", "forces at the ends of zone 2"];
const ENERGY: &str = "energy";

pub(super) fn evidence(study: &Study<'_>) -> Result<Evidence, Cause> {
    let (mut count, mut worst) = (0, 0.0_f64);
    for (_, scene) in scenes::all(study.root)? {
        let Some(closed) = closed(&scene) else { continue };
        if closed.of(REACTIONS).is_none() {
            continue;
        }
        count += 1;
        worst = worst.max(difference(&scene, &theory::solve(&scene)?, &closed));
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

/// The largest difference of the reactions and of the contact force, over the load.
fn difference(scene: &Scene, exact: &Exact, closed: &Closed) -> f64 {
    let reactions = [exact.state.reactions.left, exact.state.reactions.right];
    let of = |name: &str, found: &[f64]| apart_if_any(closed.of(name).unwrap_or_default(), found);
    of(REACTIONS, &reactions).max(of(CONTACT, &[exact.state.contact_force()])) / load(scene)
}

/// The closed form of a scene, and what follows from it.
pub(super) struct Closed {
    pub(super) formula: &'static str,
    values: Vec<(&'static str, Vec<f64>)>,
}

impl Closed {
    /// The values of a quantity, if they follow.
    pub(super) fn of(&self, name: &str) -> Option<&[f64]> {
        self.values.iter().find(|(of, _)| *of == name).map(|(_, values)| values.as_slice())
    }
}

/// The closed form of a scene, if it has one that the library knows. Derivations: `src/theory/closed.rs`.
pub(super) fn closed(scene: &Scene) -> Option<Closed> {
    let (l, ei, q) = (scene.beam().length(), scene.beam().bending_stiffness(), scene.load().uniform());
    let depth = |x: f64| scene.depth(x);
    let zone = |reactions: [f64; 2], zone: [f64; 2], ends: [f64; 2], contact: f64, energy: f64| {
        vec![
            (REACTIONS, reactions.to_vec()),
            (ZONES[0], zone.to_vec()),
            (ENDS[0], ends.to_vec()),
            (CONTACT, vec![contact]),
            (ENERGY, vec![energy]),
        ]
    };
    if !scene.load().linear().is_empty() || !scene.beam().is_simple() {
        return None;
    }
    let (formula, values) = match (scene.foundation()?, scene.load().point()) {
        (Foundation::Flat { .. }, []) => {
            let e = flat(l, ei, depth(0.0), q);
            match e.lift_off {
                Some(a) if a < 0.5 * l => (
                    "a⁴ = 24 EI u₀/q, T = q a/2, zone from a to l − a, force T at each end of it, J = −q u₀ (l − 4a/5)",
                    zone([e.reaction; 2], [a, l - a], [e.end_force; 2], e.contact_force, e.energy),
                ),
                Some(_) => (
                    "F = 5 q l/8 − 48 EI u₀/l³ at mid-span, T = (q l − F)/2, J = −q² l⁵/(240 EI) + F² l³/(96 EI)",
                    vec![(REACTIONS, vec![e.reaction; 2]), (CONTACT, vec![e.contact_force]), (ENERGY, vec![e.energy])],
                ),
                None => return None,
            }
        }
        (Foundation::Flat { .. }, [lift]) if lift.force < 0.0 && (lift.at - 0.5 * l).abs() <= f64::EPSILON * l => {
            let e = lifted(l, ei, depth(0.0), q, -lift.force)?;
            let ends = [e.reaction, e.inner_force];
            let mut values = zone([e.reaction; 2], e.zones[0], ends, 2.0 * e.zone_force, e.energy);
            values.extend([(ZONES[1], e.zones[1].to_vec()), (ENDS[1], vec![ends[1], ends[0]])]);
            let formula =
                "a⁴ = 24 EI u₀/q, T = q a/2, gap g = 3P/(2q) below the lift P, force P/4 at each end of the gap";
            (formula, values)
        }
        (Foundation::Polynomial { coefficients }, []) if coefficients.len() == 2 => {
            let e = incline(l, ei, [depth(0.0), depth(l)], q)?;
            let ends = [e.lift_off[0], l - e.lift_off[1]];
            (
                "at each end a⁴ = 24 EI u/q with the depth u below that support, T = q a/2, force T at the end of the zone",
                zone(e.reactions, ends, e.reactions, e.contact_force, e.energy),
            )
        }
        (Foundation::Polynomial { coefficients }, points) if coefficients.len() == 3 => {
            let is_symmetric =
                (coefficients[1] + coefficients[2] * l).abs() <= 4.0 * f64::EPSILON * coefficients[1].abs();
            let e = parabola(l, ei, depth(0.0), depth(0.5 * l) - depth(0.0), q);
            let a = e.lift_off.filter(|_| 0.0 < e.end_force && is_symmetric)?;
            // A point load on the zone goes straight into the ground.
            if !points.iter().all(|p| a < p.at && p.at < l - a) {
                return None;
            }
            let contact = e.contact_force + points.iter().map(|p| p.force).sum::<f64>();
            let energy = e.energy - points.iter().map(|p| p.force * depth(p.at)).sum::<f64>();
            (
                "with w = u″: q a⁴/(24 EI) + w a²/6 = u(0), T = q a/2 − EI w/a, force q a/2 + EI w/a at each end of the \
                 zone, and the point load goes into the ground where it stands",
                zone([e.reaction; 2], [a, l - a], [e.end_force; 2], contact, energy),
            )
        }
        (Foundation::Polyline { points }, [p]) if points.len() == 3 && points[1][0] < p.at => {
            let a = points[1][0];
            // The deflection of the simple beam at the kink, which is left of the point load.
            let (b, c) = (l - a, l - p.at);
            let by_load = q * a * (l * l * l - 2.0 * l * a * a + a * a * a) / (24.0 * ei);
            let free = by_load + p.force * c * a * (l * l - c * c - a * a) / (6.0 * ei * l);
            let force = (free - depth(a)) * 3.0 * ei * l / (a * a * b * b);
            (
                "F = (v₀ − u) 3 EI l/(a² b²) at the kink, at a and b from the supports, with the deflection v₀ of the simple \
                 beam there",
                vec![(CONTACT, vec![force])],
            )
        }
        _ => return None,
    };
    Some(Closed { formula, values })
}
