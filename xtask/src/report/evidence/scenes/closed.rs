//! Reference values in closed form, for the scenes that have one.

use palkki::scene::{Foundation, Scene};
use palkki::theory::closed::{incline, lifted, parabola};
use palkki::theory::flat;

/// Names of quantities, as the cards have them, with their values.
pub(super) type Values = Vec<(&'static str, Vec<f64>)>;

const REACTIONS: &str = "reactions, left and right";
const ZONES: [&str; 2] = ["zone 1, from and to", "zone 2, from and to"];
const ENDS: [&str; 2] = ["forces at the ends of zone 1", "forces at the ends of zone 2"];
const CONTACT: &str = "contact force, total";
const ENERGY: &str = "energy";

/// The closed form of a scene of the gallery, if it has one, and what follows from it. Derivations: `src/theory/closed`.
pub(super) fn closed(name: &str, scene: &Scene) -> Option<(&'static str, Values)> {
    let (l, ei, q) = (scene.beam().length(), scene.beam().bending_stiffness(), scene.load().uniform());
    let depth = |x: f64| scene.depth(x);
    let zone = |t: f64, a: f64, end: f64, contact: f64, energy: f64| {
        vec![
            (REACTIONS, vec![t; 2]),
            (ZONES[0], vec![a, l - a]),
            (ENDS[0], vec![end; 2]),
            (CONTACT, vec![contact]),
            (ENERGY, vec![energy]),
        ]
    };
    let point = scene.load().point().first();
    Some(match (name, scene.foundation()?) {
        ("heinisuo-1984", _) => {
            let e = flat(l, ei, depth(0.0), q);
            let formula =
                "a⁴ = 24 EI u₀/q, T = q a/2, zone from a to l − a, force T at each end of it, J = −q u₀ (l − 4a/5)";
            (formula, zone(e.reaction, e.lift_off?, e.end_force, e.contact_force, e.energy))
        }
        ("mid-span" | "verge", _) => {
            let e = flat(l, ei, depth(0.0), q);
            let values =
                vec![(REACTIONS, vec![e.reaction; 2]), (CONTACT, vec![e.contact_force]), (ENERGY, vec![e.energy])];
            ("F = 5 q l/8 − 48 EI u₀/l³ at mid-span, T = (q l − F)/2, J = −q² l⁵/(240 EI) + F² l³/(96 EI)", values)
        }
        ("gap", _) => {
            let e = lifted(l, ei, depth(0.0), q, -point?.force)?;
            let mut values = zone(e.reaction, 0.0, e.inner_force, 2.0 * e.zone_force, e.energy);
            values[1].1 = e.zones[0].to_vec();
            values[2].1 = vec![e.reaction, e.inner_force];
            values.extend([(ZONES[1], e.zones[1].to_vec()), (ENDS[1], vec![e.inner_force, e.reaction])]);
            ("a⁴ = 24 EI u₀/q, T = q a/2, gap g = 3P/(2q) below the lift P, force P/4 at each end of the gap", values)
        }
        ("incline", _) => {
            let e = incline(l, ei, [depth(0.0), depth(l)], q)?;
            let mut values = zone(0.0, e.lift_off[0], 0.0, e.contact_force, e.energy);
            values[1].1[1] = l - e.lift_off[1];
            (values[0].1, values[2].1) = (e.reactions.to_vec(), e.reactions.to_vec());
            (
                "at each end a⁴ = 24 EI u/q with the depth u below that support, T = q a/2, force T at the end of the zone",
                values,
            )
        }
        ("dish", _) => {
            let (e, load) = (parabola(l, ei, depth(0.0), depth(0.5 * l) - depth(0.0), q), point?);
            let formula = "with w = u″: q a⁴/(24 EI) + w a²/6 = u(0), T = q a/2 − EI w/a, force q a/2 + EI w/a at each end of the \
                           zone, and the point load goes into the ground where it stands";
            let (contact, energy) = (e.contact_force + load.force, e.energy - load.force * depth(load.at));
            (formula, zone(e.reaction, e.lift_off?, e.end_force, contact, energy))
        }
        ("kink", Foundation::Polyline { points }) => {
            let (a, p) = (points.get(1)?[0], point?);
            // The deflection of the simple beam at the kink, which is left of the point load.
            let (b, c) = (l - a, l - p.at);
            let load = q * a * (l * l * l - 2.0 * l * a * a + a * a * a) / (24.0 * ei);
            let free = load + p.force * c * a * (l * l - c * c - a * a) / (6.0 * ei * l);
            let force = (free - depth(a)) * 3.0 * ei * l / (a * a * b * b);
            let formula = "F = (v₀ − u) 3 EI l/(a² b²) at the kink, at a and b from the supports, with the deflection v₀ of the simple \
                           beam there";
            (formula, vec![(CONTACT, vec![force])])
        }
        _ => return None,
    })
}
