//! Closed forms: beam theory against the conditions that it was derived from, the discrete methods against formulas that can
//! be written down for nodal loads.

use palkki::route::{Method, Solver};
use palkki::scene::Foundation;
use palkki::state::Regime;
use palkki::theory::{FlatSolution, flat};

use crate::scenes::{nodes, run, uniform};

/// Length, bending stiffness and load of a beam without round numbers.
const BEAM: (f64, f64, f64) = (7.0, 3.0, 2.5);

/// The depth at which the beam begins to touch along a zone, `q₀ l⁴ / (384 EI)`: where one regime ends.
fn unit_depth() -> f64 {
    let (l, ei, q) = BEAM;
    q * l * l * l * l / (384.0 * ei)
}

/// Beam theory at `share` of the unit depth.
fn at(share: f64) -> FlatSolution {
    let (l, ei, q) = BEAM;
    flat(l, ei, share * unit_depth(), q)
}

#[track_caller]
fn close(found: f64, expected: f64, tolerance: f64, what: &str) {
    let error = (found - expected).abs() / expected.abs().max(1.0);
    assert!(error <= tolerance, "{what}: {found} instead of {expected}, off by {error:.1e}");
}

/// Twelve digits are asked for; a handful of operations leaves fifteen.
const TWELVE_DIGITS: f64 = 1e-12;

/// A difference of order `k` over steps of a tenth of the span multiplies rounding, 1e-16, by up to 2⁴ 10⁴.
const DIFFERENCES: f64 = 1e-9;

#[test]
fn the_numbers_of_the_example() {
    let exact = palkki_evidence::paper::theory();
    assert_eq!(exact.regime, Regime::Zone);
    close(exact.reaction, 1.182_177_011_253_97, TWELVE_DIGITS, "T");
    close(exact.end_force, 1.182_177_011_253_97, TWELVE_DIGITS, "point force");
    close(exact.lift_off.unwrap_or(f64::NAN), 2.364_354_022_507_94, TWELVE_DIGITS, "a");
    // J = −q₀ u₀ (l − 4a/5) with that a.
    close(exact.energy, -8.108_516_781_993_65, TWELVE_DIGITS, "J");
}

#[test]
fn regimes_and_their_borders() {
    for (share, regime) in [
        (0.0, Regime::Zone),
        (0.5, Regime::Zone),
        (1.0 - 1e-14, Regime::Zone),
        (1.0 + 1e-14, Regime::Points),
        (5.0 - 1e-13, Regime::Points),
        (5.0 + 1e-13, Regime::None),
        (9.0, Regime::None),
    ] {
        assert_eq!(at(share).regime, regime, "at {share} of the unit depth");
    }
    let (l, ei, _) = BEAM;
    for load in [0.0, -1.0] {
        assert_eq!(flat(l, ei, 1.0, load).regime, Regime::None, "a beam that is not pressed down touches nothing");
    }
}

#[test]
fn no_length_is_lifted_off_over_ground_at_the_level_of_the_supports() {
    let (l, _, q) = BEAM;
    let exact = at(0.0);
    close(exact.lift_off.unwrap_or(f64::NAN), 0.0, 0.0, "a");
    close(exact.reaction, 0.0, 0.0, "T");
    close(exact.contact_force, q * l, TWELVE_DIGITS, "the ground carries everything");
}

/// Differences of a polynomial of degree 4 are its derivatives, exactly: `EI δ⁴v = q Δ⁴` wherever the beam is lifted off.
#[test]
fn the_beam_is_in_equilibrium_where_it_is_lifted_off() {
    let (l, ei, q) = BEAM;
    for share in [0.3, 1.0, 2.5, 7.0] {
        let exact = at(share);
        let lifted = exact.lift_off.unwrap_or(0.5 * l);
        let step = lifted / 4.0;
        let v: Vec<f64> = (0..5_u8).map(|k| exact.deflection(step * f64::from(k))).collect();
        let fourth = v[0] - 4.0 * v[1] + 6.0 * v[2] - 4.0 * v[3] + v[4];
        let size = q * step * step * step * step;
        close(ei * fourth / size, 1.0, DIFFERENCES, "EI v''''/q");
    }
}

#[test]
fn supports_hold_no_deflection_and_no_moment() {
    let (l, ei, q) = BEAM;
    for share in [0.3, 1.0, 2.5, 7.0] {
        let exact = at(share);
        for end in [0.0, l] {
            close(exact.deflection(end), 0.0, TWELVE_DIGITS, "v at a support");
            close(exact.moment(end), 0.0, 0.0, "M at a support");
        }
        // −EI v'' by the second difference of the formula for v, corrected for its fourth derivative q/EI.
        let (x, step) = (0.1 * l, 0.05 * l);
        let second = exact.deflection(x - step) - 2.0 * exact.deflection(x) + exact.deflection(x + step);
        let moment = -ei * second / (step * step) + q * step * step / 12.0;
        close(moment, exact.moment(x), DIFFERENCES, "M = −EI v''");
    }
}

/// At lift-off `h = h' = h'' = 0` and the shear force jumps by `T`: `h(s) → T s³/(6 EI)`.
#[test]
fn the_beam_leaves_the_ground_smoothly() {
    let (_, ei, _) = BEAM;
    let exact = at(0.3);
    let a = exact.lift_off.unwrap_or(f64::NAN);
    for s in [1e-2, 1e-3] {
        let ratio = exact.clearance(a - s) / (exact.end_force * s * s * s / (6.0 * ei));
        // The next terms, s/(2a) and s/a of the first.
        close(ratio, 1.0 - s / (2.0 * a), DIFFERENCES, "h over T s³/(6 EI)");
        close(exact.moment(a - s) / (exact.end_force * s), 1.0 - s / a, DIFFERENCES, "M over T s");
    }
    for x in [a, 0.5 * BEAM.0] {
        close(exact.clearance(x), 0.0, 0.0, "clearance in the zone");
        close(exact.moment(x), 0.0, 0.0, "moment in the zone");
        close(exact.pressure(x), BEAM.2, 0.0, "pressure in the zone");
    }
}

/// `dJ*/du₀ = −` resultant of the contact: the force with which the ground would resist being raised. Checked by a
/// central difference, and independent of how either was derived.
#[test]
fn energy_and_contact_force_belong_together() {
    /// The error of a central difference with steps of 1e-4, whose square is 1e-8, and a factor for the third derivative.
    const CENTRAL: f64 = 1e-6;
    for share in [0.3, 0.9, 2.5, 4.5, 7.0] {
        let step = 1e-4 * share;
        let slope = (at(share + step).energy - at(share - step).energy) / (2.0 * step * unit_depth());
        close(-slope, at(share).contact_force, CENTRAL, "−dJ/du₀");
    }
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
