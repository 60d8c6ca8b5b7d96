//! What is not a key, and how the guide says it: each of its scenes has the answer of its formula.

use palkki::route::{Solution, Status};
use palkki::scene::Scene;
use palkki::scene::file::{ReadProblem, parse};
use palkki::solve_exactly;
use palkki_evidence::closed::flat;

/// Where the scenes are.
const GUIDE: &str = include_str!("../../../report/templates/guide.md");
const HEADING: &str = "## What is not a key, and how to say it\n";

/// Formulas and answers round some dozen operations.
const ROUNDING: f64 = 1e-12;

/// The scenes of the section, each with the name that is printed in bold above it.
fn scenes() -> Vec<(String, Scene)> {
    let section = GUIDE.split_once(HEADING).expect("the guide has the section").1;
    let section = section.split("\n## ").next().unwrap_or_default();
    let entries = section.split("\n**").skip(1).map(|entry| {
        let name = entry.split(',').next().unwrap_or_default().split("**").next().unwrap_or_default().to_owned();
        let text = entry.split_once("```toml\n").and_then(|(_, rest)| rest.split_once("```"));
        let (text, _) = text.unwrap_or_else(|| panic!("{name} has no scene"));
        let scene = parse(&name, text, |_| Err(ReadProblem::Missing)).unwrap_or_else(|error| panic!("{error}"));
        (name, scene)
    });
    entries.collect()
}

fn check(name: &str, found: f64, formula: f64, tolerance: f64) {
    assert!((found - formula).abs() <= tolerance * formula.abs(), "{name}: {found}, by its formula {formula}");
}

#[test]
fn each_scene_of_the_guide_has_its_formula() {
    let formulas: [fn(&str, &Solution); 8] =
        [temperature, two_beams, ceiling, guided_end, probe, hanging_sleepers, taper, wheel];
    let scenes = scenes();
    assert_eq!(
        scenes.len(),
        formulas.len(),
        "each entry has a formula: {:?}",
        scenes.iter().map(|s| &s.0).collect::<Vec<_>>()
    );
    for ((name, scene), formula) in scenes.iter().zip(formulas) {
        let solution = solve_exactly(scene).unwrap_or_else(|error| panic!("{name}: {error}"));
        assert_eq!(solution.verdict.status, Status::Certified, "{name}: {}", solution.verdict);
        formula(name, &solution);
    }
}

/// Between built-in ends `−EI κ` adds to the moments of the load, `−q l²/12` at the ends and `q l²/24` in the middle.
fn temperature(name: &str, solution: &Solution) {
    let (l, stiffness, curvature, load) = (10.0, 1.3, 0.01, 0.1);
    check(name, solution.state.moment.min, -load * l * l / 12.0 - stiffness * curvature, ROUNDING);
    check(name, solution.state.moment.max, load * l * l / 24.0 - stiffness * curvature, ROUNDING);
}

/// The forces of the contact let the upper beam deflect by the gap more than the lower one, at mid-span: a simple beam deflects there by
/// `x (3l² − 4x²)/(48 EI)` under a unit force at `x ≤ l/2`.
fn two_beams(name: &str, solution: &Solution) {
    let (l, upper, lower, load, gap) = (10.0, 1.0, 3.0, 1.0, 0.5);
    let contact = solution.state.contacts.first().expect("the beams touch");
    let (a, force) = (contact.from, contact.end_forces.expect("a zone")[0]);
    // Of both forces at the ends of the zone, and of the pressure between.
    let unit = |x: f64| x * (3.0 * l * l - 4.0 * x * x) / 48.0;
    let integral = |x: f64| x * x * (1.5 * l * l - x * x) / 48.0;
    let pressure = (contact.force - 2.0 * force) / (contact.to - contact.from);
    let by_contact = 2.0 * (force * unit(a) + pressure * (integral(0.5 * l) - integral(a)));
    let by_load = 5.0 * load * l.powi(4) / 384.0;
    check(name, (by_load - by_contact) / upper - by_contact / lower, gap, 1e3 * ROUNDING);
    // Where they lie on each other, each carries the share of its stiffness.
    check(name, pressure, load * lower / (upper + lower), ROUNDING);
}

fn ceiling(name: &str, solution: &Solution) {
    let formula = flat(10.0, 1.3, 0.5, 1.0);
    check(name, solution.state.reactions.left, formula.reaction, ROUNDING);
    check(name, solution.state.contact_force(), formula.contact_force, ROUNDING);
}

/// Of a beam of length `l` with a guided end: `5 q l⁴/(24 EI)` and `q l²/2` there.
fn guided_end(name: &str, solution: &Solution) {
    let (l, stiffness, load) = (5.0_f64, 1.3, 0.01);
    check(name, solution.state.deflection.max, 5.0 * load * l.powi(4) / (24.0 * stiffness), ROUNDING);
    check(name, solution.state.moment.max, 0.5 * load * l * l, ROUNDING);
}

/// The probe takes back what the free beam deflects more than its level, `F l³/(48 EI)`.
fn probe(name: &str, solution: &Solution) {
    let (l, stiffness, load, level) = (10.0_f64, 1.3, 0.05, 0.2);
    let free = 5.0 * load * l.powi(4) / (384.0 * stiffness);
    check(name, solution.state.supports[1].force, (free - level) * 48.0 * stiffness / l.powi(3), ROUNDING);
}

/// A free span of half length `c` between two half-infinite beams on springs, `w = q/k + e^{−λs}(A cos λs + B sin λs)`: with equal `w'`, `w''`
/// and `w'''` at its end, the curvature `C` below the force at its middle is
///
/// ```text
/// C = −(t + m/λ + s/(2λ²))/(c + 1/λ),   s = (P/2 + q c)/EI,   m = (P c/2 + q c²/2)/EI,   t = (P c²/4 + q c³/6)/EI
/// ```
fn hanging_sleepers(name: &str, solution: &Solution) {
    /// What is left of the waves at the ends of the beam, `e^{−18λ}`.
    const WAVES: f64 = 1e-7;
    let (ei, k, q, p, c) = (6.0_f64, 20.0, 0.1, 0.2, 2.0_f64);
    let decay = (k / (4.0 * ei)).sqrt().sqrt();
    let [s, m, t] =
        [(0.5 * p + q * c) / ei, (0.5 * p * c + 0.5 * q * c * c) / ei, (0.25 * p * c * c + q * c * c * c / 6.0) / ei];
    let curvature = -(t + m / decay + 0.5 * s / (decay * decay)) / (c + 1.0 / decay);
    check(name, solution.state.moment.max, -ei * curvature, WAVES);
    assert_eq!(solution.state.contacts.len(), 2, "{name}: nothing touches over the hollow");
}

/// `∫ P y²/(EI) dy` from the tip, step by step; the gradual taper `EI = 1 + y/8` is within a part of it that is four times as small with
/// half the steps.
fn taper(name: &str, solution: &Solution) {
    let (l, force) = (8.0_f64, 0.01);
    let stepped = |steps: u32| -> f64 {
        let width = l / f64::from(steps);
        let of = |i: u32| {
            let [near, far] = [i, i + 1].map(|i| width * f64::from(i));
            force * (far.powi(3) - near.powi(3)) / 3.0 / (1.0 + 0.5 * (near + far) / l)
        };
        (0..steps).map(of).sum()
    };
    check(name, solution.state.deflection.max, stepped(8), ROUNDING);
    let gradual = force * l.powi(3) * (2.0_f64.ln() - 0.5);
    let quotient = (stepped(8) - gradual) / (stepped(16) - gradual);
    assert!((quotient - 4.0).abs() < 0.1, "{name}: halved steps have an error {quotient} times as small");
}

/// The line load goes straight into the foundation.
fn wheel(name: &str, solution: &Solution) {
    let formula = flat(10.0, 1.3, 1.0, 1.0);
    check(name, solution.state.reactions.left, formula.reaction, ROUNDING);
    check(name, solution.state.contact_force(), formula.contact_force + 2.0, ROUNDING);
}
