//! The discrete methods against formulas that can be written down for nodal loads.

use palkki::route::{Method, Solver};
use palkki::scene::Foundation;
use palkki::state::Regime;

use crate::scenes::{nodes, run, uniform};

/// Length, bending stiffness and load of a beam without round numbers.
const BEAM: (f64, f64, f64) = (7.0, 3.0, 2.5);

/// The depth at which the beam begins to touch along a zone, `q₀ l⁴ / (384 EI)`: where one regime ends.
fn unit_depth() -> f64 {
    let (l, ei, q) = BEAM;
    q * l * l * l * l / (384.0 * ei)
}

#[track_caller]
fn close(found: f64, expected: f64, tolerance: f64, what: &str) {
    let error = (found - expected).abs() / expected.abs().max(1.0);
    assert!(error <= tolerance, "{what}: {found} instead of {expected}, off by {error:.1e}");
}

/// What nodal loads `q₀Δ` make of a beam that touches nothing: moments at the nodes are exact, and the deflection is that of
/// the uniform load with a constant moment `∓q₀Δ²/12` added, `+` for finite differences.
fn free_deflection(method: Method, intervals: f64, x: f64) -> f64 {
    let (l, ei, q) = BEAM;
    let spacing = l / intervals;
    let uniform = q * x * (l - x) * (l * l + l * x - x * x) / (24.0 * ei);
    let sign = if method == Method::Complementarity { 1.0 } else { -1.0 };
    uniform + sign * q * spacing * spacing / 12.0 * x * (l - x) / (2.0 * ei)
}

/// Rounding of sums over a hundred nodes, each added twice.
const SUMS: f64 = 1e-12;

#[test]
fn a_free_beam_bends_by_the_formula() {
    let (l, ei, q) = BEAM;
    for method in Method::ALL {
        for intervals in [2_u8, 3, 10, 75] {
            let scene = uniform(l, ei, q, Foundation::Flat { depth: 6.0 * unit_depth() });
            let raw = run(&scene, method, Solver::ActiveSet, intervals.into());
            assert!(raw.solved, "{method} {intervals}");
            assert_eq!(raw.state.regime, Regime::None, "{method} {intervals}");
            let nodes = nodes(&raw);
            for ((&x, &v), &m) in nodes.x.iter().zip(&nodes.deflection).zip(&nodes.moment) {
                close(v, free_deflection(method, intervals.into(), x), SUMS, "v");
                close(m, 0.5 * q * x * (l - x), SUMS, "M");
            }
            close(raw.state.reactions.left, 0.5 * q * l, SUMS, "reaction");
        }
    }
}

/// A force at mid-span deflects a beam by `l³/(48 EI)`; finite differences add `Δ² l/(24 EI)`.
#[test]
fn contact_at_mid_span_has_the_force_of_the_formula() {
    let (l, ei, q) = BEAM;
    let depth = 2.5 * unit_depth();
    for method in Method::ALL {
        for intervals in [2_u8, 4, 10, 76] {
            let count = f64::from(intervals);
            let added = if method == Method::Complementarity { 2.0 / (count * count) } else { 0.0 };
            let compliance = l * l * l / (48.0 * ei) * (1.0 + added);
            let force = (free_deflection(method, count, 0.5 * l) - depth) / compliance;

            let raw = run(&uniform(l, ei, q, Foundation::Flat { depth }), method, Solver::ActiveSet, intervals.into());
            assert!(raw.solved, "{method} {intervals}");
            assert_eq!(raw.state.regime, Regime::Points, "{method} {intervals}");
            let [contact] = raw.state.contacts[..] else { panic!("one contact: {:?}", raw.state.contacts) };
            close(contact.from, 0.5 * l, SUMS, "place");
            close(contact.force, force, SUMS, "force");
            close(raw.state.reactions.right, 0.5 * (q * l - force), SUMS, "reaction");
        }
    }
}

#[test]
fn the_scene_with_one_kink_has_the_force_of_the_formula() {
    // u(4) = 0.5 under the kink; a uniform load q = 1 and a force 2 at x = 7, l = 10, EI = 100.
    let (l, ei, kink) = (10.0, 100.0, 4.0);
    let by_force = |p: f64, a: f64, x: f64| {
        let (x, b) = if x <= a { (x, l - a) } else { (l - x, a) };
        p * b * x * (l * l - b * b - x * x) / (6.0 * ei * l)
    };
    let scene = crate::scenes::scene("kink");
    for intervals in [10_u8, 50] {
        let spacing = l / f64::from(intervals);
        let by_nodes = kink * (l - kink) * (l * l + l * kink - kink * kink) / (24.0 * ei)
            - spacing * spacing / 12.0 * kink * (l - kink) / (2.0 * ei);
        let force = (by_nodes + by_force(2.0, 7.0, kink) - 0.5) / by_force(1.0, kink, kink);
        for method in [Method::Displacement, Method::Force] {
            let raw = run(&scene, method, Solver::ActiveSet, intervals.into());
            assert!(raw.solved, "{method} {intervals}");
            close(raw.state.contact_force(), force, SUMS, "force at the kink");
        }
    }
}
