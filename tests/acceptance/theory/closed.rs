//! The exact solution against foundations that have one in closed form.

use palkki::scene::{Beam, Foundation, Load, PointLoad, Scene};
use palkki::state::Regime;
use palkki::theory::closed::{incline, lifted, parabola};
use palkki::theory::{Exact, flat, solve};
use palkki_evidence::faults::closed;

/// What is asked for; a handful of operations leaves some digits to spare.
const DIGITS: f64 = 1e-12;

#[track_caller]
fn check(what: &str, found: f64, expected: f64) {
    let error = (found - expected).abs();
    assert!(error <= DIGITS * expected.abs(), "{what}: {found} instead of {expected}, off by {error:e}");
}

#[track_caller]
fn solved(length: f64, stiffness: f64, load: f64, point: &[PointLoad], foundation: Foundation) -> Exact {
    let beam = Beam::new(length, stiffness).expect("a beam");
    let load = Load::new(&beam, load, Vec::new(), point.to_vec()).expect("a load");
    let exact = solve(&Scene::new(beam, load, Some(foundation)).expect("a scene")).expect("an answer");
    assert!(exact.solved, "{:?}", exact.violations);
    exact
}

#[test]
fn flat_in_three_regimes_and_at_their_borders() {
    let (l, ei, q) = (10.0, 500.0 / 384.0, 1.0);
    let unit = q * l * l * l * l / (384.0 * ei);
    for share in [1e-9, 1e-3, 0.01, 0.5, 0.999_999, 1.0, 1.000_001, 3.0, 4.999, 5.0, 5.001, 50.0] {
        let (closed, exact) =
            (flat(l, ei, share * unit, q), solved(l, ei, q, &[], Foundation::Flat { depth: share * unit }));
        check("left reaction", exact.state.reactions.left, closed.reaction);
        check("right reaction", exact.state.reactions.right, closed.reaction);
        check("energy", exact.state.energy, closed.energy);
        // At the borders both neighbours are right, and the contact force may be zero up to rounding.
        let error = (exact.state.contact_force() - closed.contact_force).abs();
        assert!(error <= DIGITS * q * l, "contact force off by {error:e} for {share}");
        for i in 0..=20 {
            let x = 0.05 * l * f64::from(i);
            let deflection = (exact.deflection(x) - closed.deflection(x)).abs();
            assert!(deflection <= DIGITS * closed.deflection(0.5 * l), "deflection off by {deflection:e} at {x}");
            let moment = (exact.moment(x) - closed.moment(x)).abs();
            assert!(moment <= DIGITS * 0.1 * q * l * l, "moment off by {moment:e} at {x}");
        }
        if closed.regime == Regime::Zone && share < 1.0 {
            let contact = exact.state.contacts[0];
            check("lift-off", contact.from, closed.lift_off.expect("a zone"));
            let [left, right] = contact.end_forces.expect("a zone");
            check("left end force", left, closed.end_force);
            check("right end force", right, closed.end_force);
        }
    }
}

#[test]
fn the_example_of_the_paper_has_one_zone() {
    // T = 1.18 is printed; the other digits follow from a⁴ = 24 EI u₀/q₀.
    let exact = solved(10.0, 500.0 / 384.0, 1.0, &[], Foundation::Flat { depth: 1.0 });
    check("T", exact.state.reactions.left, 1.182_177_011_253_97);
    check("a", exact.state.contacts[0].from, 2.364_354_022_507_94);
    check("largest moment", exact.state.moment.max, exact.state.contacts[0].from.powi(2) / 8.0);
    assert_eq!(exact.state.regime, Regime::Zone);
}

#[test]
fn incline_lifts_off_differently_at_its_ends() {
    let (l, ei, q) = (7.0, 3.0, 2.0);
    for depths in [[0.1, 0.4], [1.0, 0.001], [0.0, 0.5], [0.0, 0.0]] {
        let closed = incline(l, ei, depths, q).expect("a zone");
        let slope = (depths[1] - depths[0]) / l;
        for foundation in [
            Foundation::Polynomial { coefficients: vec![depths[0], slope] },
            Foundation::Polyline { points: vec![[0.0, depths[0]], [l, depths[1]]] },
        ] {
            let state = solved(l, ei, q, &[], foundation).state;
            let found = [state.reactions.left, state.reactions.right];
            for (found, expected) in found.iter().zip(closed.reactions) {
                let error = (found - expected).abs();
                assert!(error <= DIGITS * q * l, "reaction off by {error:e} for {depths:?}");
            }
            check("contact force", state.contact_force(), closed.contact_force);
            if 0.0 < depths[0] + depths[1] {
                check("energy", state.energy, closed.energy);
            }
            assert_eq!(state.contacts.len(), 1);
            let error = (state.contacts[0].from - closed.lift_off[0]).abs();
            assert!(error <= DIGITS * l, "lift-off off by {error:e} for {depths:?}");
            check("lift-off on the right", state.contacts[0].to, l - closed.lift_off[1]);
        }
    }
}

#[test]
fn parabolic_dish_and_crest() {
    let (l, ei, q) = (10.0, 500.0 / 384.0, 1.0);
    // Dish at some depth, dish that starts at the supports, crest, crest above the supports; zone and point and free.
    let cases = [
        (1.0, 5.0, Regime::Zone),
        (0.0, 5.0, Regime::Zone),
        (0.0, 70.0, Regime::Points),
        (0.0, 120.0, Regime::None),
        (3.0, -1.0, Regime::Zone),
        (20.0, -10.0, Regime::Zone),
        (60.0, -10.0, Regime::Points),
        (1.0, -9.0, Regime::Zone),
        (200.0, -5.0, Regime::None),
    ];
    for (depth, rise, regime) in cases {
        let closed = parabola(l, ei, depth, rise, q);
        assert_eq!(closed.regime, regime, "depth {depth}, rise {rise}");
        let coefficients = vec![depth, 4.0 * rise / l, -4.0 * rise / (l * l)];
        let exact = solved(l, ei, q, &[], Foundation::Polynomial { coefficients });
        assert_eq!(exact.state.regime, regime, "depth {depth}, rise {rise}");
        check("left reaction", exact.state.reactions.left, closed.reaction);
        check("right reaction", exact.state.reactions.right, closed.reaction);
        check("energy", exact.state.energy, closed.energy);
        if regime == Regime::Zone {
            let contact = exact.state.contacts[0];
            check("lift-off", contact.from, closed.lift_off.expect("a zone"));
            check("end force", contact.end_forces.expect("a zone")[0], closed.end_force);
        }
        if regime != Regime::None {
            check("contact force", exact.state.contact_force(), closed.contact_force);
        }
    }
}

#[test]
fn lifted_beam_rests_on_two_zones() {
    let (l, ei, depth, q) = (10.0, 500.0 / 384.0, 0.01, 1.0);
    for lift in [0.01, 0.5, 3.0, 4.5] {
        let closed = lifted(l, ei, depth, q, lift).expect("two zones");
        let point = [PointLoad { at: 0.5 * l, force: -lift }];
        let exact = solved(l, ei, q, &point, Foundation::Flat { depth });
        assert_eq!((exact.state.contacts.len(), exact.unknowns), (2, 4), "{lift}: {:?}", exact.state.contacts);
        for (contact, zone) in exact.state.contacts.iter().zip(closed.zones) {
            check("from", contact.from, zone[0]);
            check("to", contact.to, zone[1]);
            check("force", contact.force, closed.zone_force);
        }
        let [outer, inner] = exact.state.contacts[0].end_forces.expect("a zone");
        check("outer force", outer, closed.reaction);
        check("inner force", inner, closed.inner_force);
        check("energy", exact.state.energy, closed.energy);
    }
}

#[test]
fn whole_beam_on_the_foundation() {
    let exact = solved(5.0, 2.0, 3.0, &[], Foundation::Flat { depth: 0.0 });
    assert_eq!(exact.unknowns, 0);
    assert_eq!((exact.state.contacts[0].from, exact.state.contacts[0].to), (0.0, 5.0));
    check("contact force", exact.state.contact_force(), 15.0);
}

#[test]
fn crest_above_the_supports_lifts_a_beam_without_load() {
    // F = 48 EI d/l³ for a beam lifted by d at mid-span.
    let (l, ei, d) = (4.0, 2.0, 0.3);
    let points = vec![[0.0, 0.5], [2.0, -d], [4.0, 0.5]];
    let exact = solved(l, ei, 0.0, &[], Foundation::Polyline { points });
    check("force", exact.state.contacts[0].force, 48.0 * ei * d / (l * l * l));
    check("energy", exact.state.energy, 24.0 * ei * d * d / (l * l * l));
}

#[test]
fn foundation_that_starts_flat_at_a_support_clamps_the_beam() {
    // u = A (1 − cos 2πx/l)/… is flat at both supports: the beam under it is clamped there, with fixed-end moments q l²/12,
    // as long as it touches nowhere else: at mid-span q l⁴/(384 EI) < 2 A.
    let (l, ei, q) = (6.0, 2.0, 1.5);
    let amplitude = q * l * l * l * l / (384.0 * ei);
    let foundation = Foundation::Cosine { mean: amplitude, amplitude: -amplitude, wavelength: l, phase: 0.0 };
    let exact = solved(l, ei, q, &[], foundation);
    check("left couple", exact.support_couples[0], -q * l * l / 12.0);
    check("right couple", exact.support_couples[1], -q * l * l / 12.0);
    check("reaction", exact.state.reactions.left, 0.5 * q * l);
    check("deflection", exact.state.deflection.max, q * l * l * l * l / (384.0 * ei));
}

/// Every beam with a closed form, on any supports or none: deflection, moment, energy, places and forces of contacts, reactions.
#[test]
fn beams_on_any_supports_are_those_of_their_closed_forms() {
    /// Of derivatives of quartics through five values.
    const DERIVED: f64 = 1e-10;
    for known in closed::all().expect("well-posed scenes") {
        let closed::Closed { name, scene, contacts, .. } = &known;
        let exact = solve(scene).expect("an answer");
        assert!(exact.solved, "{name}: {:?}", exact.violations);
        let (length, size, q) = (scene.beam().length(), known.largest(), scene.load().uniform());
        let scale = closed::EI * size / (length * length) + q * length * length;
        let close = |what: &str, found: f64, expected: f64, off: f64| {
            assert!((found - expected).abs() <= off, "{name}, {what}: {found} instead of {expected}");
        };
        for k in 0..=40_u32 {
            let x = length * f64::from(k) / 40.0;
            close(&format!("deflection at {x}"), exact.deflection(x), known.deflection(x), DIGITS * size.max(1.0));
            close(&format!("moment at {x}"), exact.moment(x), known.moment(x), DERIVED * scale);
        }
        close("energy", exact.state.energy, known.energy(), DERIVED * known.energy().abs().max(1.0));
        assert_eq!(exact.state.contacts.len(), contacts.len(), "{name}: {:?}", exact.state.contacts);
        for (found, expected) in exact.state.contacts.iter().zip(contacts) {
            close("from", found.from, expected.from, DIGITS * length);
            close("to", found.to, expected.to, DIGITS * length);
            if scene.beam().supports().iter().any(|s| expected.from <= s.at && s.at <= expected.to) {
                continue;
            }
            let ends = found.end_forces.unwrap_or([found.force; 2]);
            close("force at the start", ends[0], known.force(expected.from), DERIVED * scale / length);
            close("force at the end", ends[1], known.force(expected.to), DERIVED * scale / length);
        }
        // Lift-off points within the beam are all that is unknown, unless a support or a point is there as well.
        let inside = |x: f64| 0.0 < x && x < length;
        let held_at_ends = scene.beam().supports().iter().all(|support| !inside(support.at));
        if held_at_ends && contacts.iter().all(|c| c.from < c.to) {
            let places = contacts.iter().flat_map(|c| [c.from, c.to]);
            assert_eq!(exact.unknowns, places.filter(|x| inside(*x)).count(), "{name}");
        }
        if let Some(standing) = &exact.state.standing {
            let supports = scene.beam().supports().iter().map(|support| support.at);
            let places = || contacts.iter().flat_map(|c| [c.from, c.to]).chain(supports.clone());
            let (from, to) = (places().fold(length, f64::min), places().fold(0.0, f64::max));
            let margin = if from < to { (0.5 * length - from).min(to - 0.5 * length) / (to - from) } else { 0.0 };
            close("resultant", standing.resultant.force, q * length, DIGITS * scale / length);
            close("its place", standing.resultant.at, 0.5 * length, DIGITS * length);
            close("margin", standing.margin, margin, DIGITS);
        }
        for (found, expected) in exact.state.supports.iter().zip(known.reactions()) {
            let Some(expected) = expected else { continue };
            close("reaction", found.force, expected, DERIVED * scale / length);
            if let Some(moment) = found.moment {
                // On the side of the beam: a support that is built in is at an end.
                close("moment", moment, known.moment(found.at), DERIVED * scale);
            }
        }
    }
}
