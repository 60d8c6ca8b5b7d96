//! Reference values in closed form, for the scenes that have one.

use palkki::scene::{Foundation, Scene};
use palkki::theory::closed::{incline, lifted, parabola};
use palkki::theory::flat;

/// A formula in words of the report, and what follows from it: the name of a quantity and its values.
pub(super) struct Closed {
    pub(super) formula: &'static str,
    pub(super) values: Vec<(&'static str, Vec<f64>)>,
}

/// The closed form of a scene of the gallery, if it has one. Derivations: `src/theory/flat.rs` and `src/theory/closed`.
pub(super) fn closed(name: &str, scene: &Scene) -> Option<Closed> {
    let (l, ei, q) = (scene.beam().length(), scene.beam().bending_stiffness(), scene.load().uniform());
    let point = scene.load().point().first();
    let values = match (name, scene.foundation()?) {
        ("heinisuo-1984", &Foundation::Flat { depth }) => {
            let exact = flat(l, ei, depth, q);
            let a = exact.lift_off?;
            vec![
                ("reactions, left and right", vec![exact.reaction; 2]),
                ("zone 1, from and to", vec![a, l - a]),
                ("forces at the ends of zone 1", vec![exact.end_force; 2]),
                ("contact force, total", vec![exact.contact_force]),
                ("energy", vec![exact.energy]),
            ]
        }
        ("mid-span" | "verge", &Foundation::Flat { depth }) => {
            let exact = flat(l, ei, depth, q);
            vec![
                ("reactions, left and right", vec![exact.reaction; 2]),
                ("contact force, total", vec![exact.contact_force]),
                ("energy", vec![exact.energy]),
            ]
        }
        ("gap", &Foundation::Flat { depth }) => {
            let exact = lifted(l, ei, depth, q, -point?.force)?;
            let ends = [exact.reaction, exact.inner_force];
            vec![
                ("reactions, left and right", vec![exact.reaction; 2]),
                ("zone 1, from and to", exact.zones[0].to_vec()),
                ("forces at the ends of zone 1", ends.to_vec()),
                ("zone 2, from and to", exact.zones[1].to_vec()),
                ("forces at the ends of zone 2", vec![ends[1], ends[0]]),
                ("contact force, total", vec![2.0 * exact.zone_force]),
                ("energy", vec![exact.energy]),
            ]
        }
        ("incline", Foundation::Polynomial { coefficients }) => {
            let exact = incline(l, ei, [coefficients[0], scene.depth(l)], q)?;
            vec![
                ("reactions, left and right", exact.reactions.to_vec()),
                ("zone 1, from and to", vec![exact.lift_off[0], l - exact.lift_off[1]]),
                ("forces at the ends of zone 1", exact.reactions.to_vec()),
                ("contact force, total", vec![exact.contact_force]),
                ("energy", vec![exact.energy]),
            ]
        }
        ("dish", Foundation::Polynomial { coefficients }) => {
            let load = point?;
            let exact = parabola(l, ei, coefficients[0], scene.depth(0.5 * l) - coefficients[0], q);
            let a = exact.lift_off?;
            vec![
                ("reactions, left and right", vec![exact.reaction; 2]),
                ("zone 1, from and to", vec![a, l - a]),
                ("forces at the ends of zone 1", vec![exact.end_force; 2]),
                ("contact force, total", vec![exact.contact_force + load.force]),
                ("energy", vec![exact.energy - load.force * scene.depth(load.at)]),
            ]
        }
        ("kink", Foundation::Polyline { points }) => {
            let [a, depth] = *points.get(1)?;
            let b = l - a;
            let of_load = q * a * (l * l * l - 2.0 * l * a * a + a * a * a) / (24.0 * ei);
            // For a ≤ the place of the load.
            let c = l - point?.at;
            let of_point = point?.force * c * a * (l * l - c * c - a * a) / (6.0 * ei * l);
            vec![("contact force, total", vec![(of_load + of_point - depth) * 3.0 * ei * l / (a * a * b * b)])]
        }
        _ => return None,
    };
    let formula = match name {
        "heinisuo-1984" => {
            "a⁴ = 24 EI u₀/q, T = q a/2, zone from a to l − a, force T at each end of it, J = −q u₀ (l − 4a/5)"
        }
        "mid-span" | "verge" => {
            "F = 5 q l/8 − 48 EI u₀/l³ at mid-span, T = (q l − F)/2, J = −q² l⁵/(240 EI) + F² l³/(96 EI)"
        }
        "gap" => "a⁴ = 24 EI u₀/q, T = q a/2, gap g = 3P/(2q) below the lift P, force P/4 at each end of the gap",
        "incline" => {
            "at each end a⁴ = 24 EI u/q with the depth u below that support, T = q a/2, force T at the end of the zone"
        }
        "dish" => {
            "with w = u″: q a⁴/(24 EI) + w a²/6 = u(0), T = q a/2 − EI w/a, force q a/2 + EI w/a at each end of the zone, and the \
             point load goes into the ground where it stands"
        }
        _ => {
            "F = (v₀ − u) 3 EI l/(a² b²) at the kink, a and b from the supports, with the deflection v₀ of the simple beam there"
        }
    };
    Some(Closed { formula, values })
}
