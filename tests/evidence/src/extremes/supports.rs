//! A cantilever, two spans and a free body, in units and of sizes from 10⁻⁹ to 10⁹.

use super::units::{Factors, of};
use super::{Extreme, Parts, Truth, extreme};
use palkki::scene::{Foundation, SceneError, Support};

/// Units in which each of them is tried.
const ALL: [Factors; 7] = [
    of("in units of one", 1.0, 1.0, 1.0),
    of("lengths × 1e9", 1e9, 1e9, 1.0),
    of("lengths × 1e-9", 1e-9, 1e-9, 1.0),
    of("depths × 1e9", 1.0, 1e9, 1.0),
    of("depths × 1e-9", 1.0, 1e-9, 1.0),
    of("forces × 1e9", 1.0, 1.0, 1e9),
    of("forces × 1e-9", 1.0, 1.0, 1e-9),
];

const L: f64 = 10.0;
const EI: f64 = 500.0 / 384.0;
const Q: f64 = 1.0;

/// A scene in units of one: places of its supports, and whether it is built in there; coefficients of its ground; what is known.
struct Known {
    name: &'static str,
    supports: Vec<Support>,
    ground: Vec<f64>,
    truth: Truth,
}

/// All of them in all units. In all closed forms lift-off is where `v = g`, `v' = g'` and `v'' = g''`, and
/// `J = −½∫q v dx − ½∫g dp` if the supports are at level 0.
///
/// # Errors
///
/// None for these numbers; a [`SceneError`] would say which scene is not well posed.
pub fn supports() -> Result<Vec<Extreme>, SceneError> {
    let mut found = Vec::new();
    for Known { name, supports, ground, truth } in [cantilever(), two_spans(), hump()] {
        for Factors { name: units, length, depth, force } in ALL {
            let powers = std::iter::successors(Some(depth), |power| Some(power / length));
            let coefficients = ground.iter().zip(powers).map(|(c, power)| c * power).collect();
            let at = |support: &Support| Support { at: support.at * length, ..*support };
            let parts = Parts {
                length: L * length,
                stiffness: EI * (length / depth) * force * length * length,
                uniform: Q * force / length,
                supports: Some(supports.iter().map(at).collect()),
                ..Parts::over(Foundation::Polynomial { coefficients })
            };
            let truth = Truth {
                reactions: truth.reactions.map(|r| r * force),
                contact_force: truth.contact_force * force,
                energy: truth.energy.map(|j| j * force * depth),
            };
            found.push(extreme(format!("{name}, {units}"), "closed form, scaling", &parts, truth)?);
        }
    }
    Ok(found)
}

fn fourth_root(x: f64) -> f64 {
    x.sqrt().sqrt()
}

/// Built in at its left end, a zone from `a` with `EI d = q a⁴/72`: reaction `2qa/3`, `∫v = q a⁵/120EI` up to the zone.
fn cantilever() -> Known {
    let d = 0.5;
    let a = fourth_root(72.0 * EI * d / Q);
    let (reaction, contact) = (2.0 * Q * a / 3.0, Q * (L - 2.0 * a / 3.0));
    let area = Q * a * a * a * a * a / (120.0 * EI) + d * (L - a);
    let truth =
        Truth { reactions: [reaction, 0.0], contact_force: contact, energy: Some(-0.5 * (Q * area + d * contact)) };
    Known { name: "a cantilever", supports: vec![Support::built_in(0.0)], ground: vec![d], truth }
}

/// A zone in each of two spans. From the ends `EI d = q a⁴/24`, reaction `qa/2`, `∫v = 7 q a⁵/240EI`; from the support in the
/// middle, where the beam is horizontal, as from where it is built in, on both sides.
fn two_spans() -> Known {
    let d = 0.05;
    let (a, b) = (fourth_root(24.0 * EI * d / Q), fourth_root(72.0 * EI * d / Q));
    let (reaction, contact) = (0.5 * Q * a, Q * (L - a - 4.0 * b / 3.0));
    let fifth = |x: f64| Q * x * x * x * x * x / EI;
    let area = 2.0 * (7.0 * fifth(a) / 240.0 + fifth(b) / 120.0) + d * (L - 2.0 * (a + b));
    let energy = -0.5 * (Q * area + d * contact);
    let supports = [0.0, 0.5 * L, L].map(Support::simple).to_vec();
    Known { name: "two spans", supports, ground: vec![d], truth: Truth::symmetric(reaction, contact, energy) }
}

/// Nothing but a hump of curvature `κ` below it, with its top at depth 0: the beam lies on it but for ends of the length `b`, with
/// `q b²/2 = EI κ`. With `c = l/2 − b` half of its energy is `EI κ² c/2 − q κ c³/6` of the part that lies and
/// `q² b⁵/40EI − q (κ c² b/2 + κ c b²/2 + q b⁵/20EI)` of the end.
fn hump() -> Known {
    let kappa = 0.2;
    let b = (2.0 * EI * kappa / Q).sqrt();
    let (c, b5) = (0.5 * L - b, b * b * b * b * b);
    let lies = 0.5 * EI * kappa * kappa * c - Q * kappa * c * c * c / 6.0;
    let end = Q * Q * b5 / (40.0 * EI) - Q * (0.5 * kappa * c * c * b + 0.5 * kappa * c * b * b + Q * b5 / (20.0 * EI));
    let ground = vec![0.125 * kappa * L * L, -0.5 * kappa * L, 0.5 * kappa];
    let truth = Truth::symmetric(0.0, Q * L, 2.0 * (lies + end));
    Known { name: "a free beam over a hump", supports: Vec::new(), ground, truth }
}
