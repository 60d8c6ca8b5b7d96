//! A cantilever, two spans and a free body, in units and of sizes from 10⁻⁹ to 10⁹.

use super::units::of;
use super::{Extreme, Known, in_units};
use crate::draft::{Draft, Units};
use crate::paper::{LENGTH as L, STIFFNESS as EI, UNIFORM as Q};
use palkki::scene::{Foundation, SceneError, Support};

/// Units in which each of them is tried.
const ALL: [(&str, Units); 7] = [
    of("in units of one", 1.0, 1.0, 1.0),
    of("lengths × 1e9", 1e9, 1e9, 1.0),
    of("lengths × 1e-9", 1e-9, 1e-9, 1.0),
    of("depths × 1e9", 1.0, 1e9, 1.0),
    of("depths × 1e-9", 1.0, 1e-9, 1.0),
    of("forces × 1e9", 1.0, 1.0, 1e9),
    of("forces × 1e-9", 1.0, 1.0, 1e-9),
];

/// All of them in all units. In all closed forms lift-off is where `v = g`, `v' = g'` and `v'' = g''`, and
/// `J = −½∫q v dx − ½∫g dp` if the supports are at level 0.
///
/// # Errors
///
/// None for these numbers; a [`SceneError`] would say which scene is not well posed.
pub fn supports() -> Result<Vec<Extreme>, SceneError> {
    let mut found = Vec::new();
    for (what, draft, known) in [cantilever(), two_spans(), hump()] {
        for (name, units) in ALL {
            found.push(in_units(format!("{what}, {name}"), "closed form, scaling", &draft, known, units)?);
        }
    }
    Ok(found)
}

/// What it is, the scene in units of one, and what is known of it.
type Case = (&'static str, Draft, Known);

fn on(supports: Vec<Support>, coefficients: Vec<f64>) -> Draft {
    Draft { supports: Some(supports), ..Draft::over(Foundation::Polynomial { coefficients }) }
}

fn fourth_root(x: f64) -> f64 {
    x.sqrt().sqrt()
}

/// Built in at its left end, a zone from `a` with `EI d = q a⁴/72`: reaction `2qa/3`, `∫v = q a⁵/120EI` up to the zone.
fn cantilever() -> Case {
    let d = 0.5;
    let a = fourth_root(72.0 * EI * d / Q);
    let (reaction, contact) = (2.0 * Q * a / 3.0, Q * (L - 2.0 * a / 3.0));
    let area = Q * a * a * a * a * a / (120.0 * EI) + d * (L - a);
    let energy = Some(-0.5 * (Q * area + d * contact));
    let known = Known { reactions: [reaction, 0.0], contact_force: contact, energy };
    ("a cantilever", on(vec![Support::built_in(0.0)], vec![d]), known)
}

/// A zone in each of two spans. From the ends `EI d = q a⁴/24`, reaction `qa/2`, `∫v = 7 q a⁵/240EI`; from the support in the
/// middle, where the beam is horizontal, as from where it is built in, on both sides.
fn two_spans() -> Case {
    let d = 0.05;
    let (a, b) = (fourth_root(24.0 * EI * d / Q), fourth_root(72.0 * EI * d / Q));
    let (reaction, contact) = (0.5 * Q * a, Q * (L - a - 4.0 * b / 3.0));
    let fifth = |x: f64| Q * x * x * x * x * x / EI;
    let area = 2.0 * (7.0 * fifth(a) / 240.0 + fifth(b) / 120.0) + d * (L - 2.0 * (a + b));
    let energy = -0.5 * (Q * area + d * contact);
    let supports = [0.0, 0.5 * L, L].map(Support::simple).to_vec();
    ("two spans", on(supports, vec![d]), Known::symmetric(reaction, contact, energy))
}

/// Nothing but a hump of curvature `κ` below it, with its top at depth 0: the beam lies on it but for ends of the length `b`, with
/// `q b²/2 = EI κ`. With `c = l/2 − b` half of its energy is `EI κ² c/2 − q κ c³/6` of the part that lies and
/// `q² b⁵/40EI − q (κ c² b/2 + κ c b²/2 + q b⁵/20EI)` of the end.
fn hump() -> Case {
    let kappa = 0.2;
    let b = (2.0 * EI * kappa / Q).sqrt();
    let (c, b5) = (0.5 * L - b, b * b * b * b * b);
    let lies = 0.5 * EI * kappa * kappa * c - Q * kappa * c * c * c / 6.0;
    let end = Q * Q * b5 / (40.0 * EI) - Q * (0.5 * kappa * c * c * b + 0.5 * kappa * c * b * b + Q * b5 / (20.0 * EI));
    let ground = vec![0.125 * kappa * L * L, -0.5 * kappa * L, 0.5 * kappa];
    ("a free beam over a hump", on(Vec::new(), ground), Known::symmetric(0.0, Q * L, 2.0 * (lies + end)))
}
