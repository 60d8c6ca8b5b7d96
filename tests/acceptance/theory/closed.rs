//! The exact solution against closed forms. To twelve digits of forces and energy it stands beside them in `robustness::extremes`.

use palkki::scene::{Beam, Foundation, Load, PointLoad, Scene};
use palkki::theory::Exact;
use palkki_evidence::closed::{self, Closed, lifted};

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
    super::solved(&Scene::new(beam, load, Some(foundation)).expect("a scene"))
}

/// Of the numbers two are printed, `T = 1.18`; the other digits follow from `a⁴ = 24 EI u₀/q₀` and `J = −q₀ u₀ (l − 4a/5)`.
#[test]
fn the_example_of_the_paper_has_one_zone() {
    let exact = solved(10.0, 500.0 / 384.0, 1.0, &[], Foundation::Flat { depth: 1.0 });
    let closed = palkki_evidence::paper::theory();
    for (what, found, also, expected) in [
        ("T", exact.state.reactions.left, closed.reaction, 1.182_177_011_253_97),
        (
            "force at lift-off",
            exact.state.contacts[0].end_forces.expect("a zone")[0],
            closed.end_force,
            1.182_177_011_253_97,
        ),
        ("a", exact.state.contacts[0].from, closed.lift_off.expect("a zone"), 2.364_354_022_507_94),
        ("J", exact.state.energy, closed.energy, -8.108_516_781_993_65),
        (
            "largest moment",
            exact.state.moment.max,
            closed.end_force.powi(2) / 2.0,
            2.364_354_022_507_94_f64.powi(2) / 8.0,
        ),
    ] {
        check(what, found, expected);
        check(what, also, expected);
    }
    for x in (0..=20).map(|k| 0.5 * f64::from(k)) {
        for (what, found, also) in [
            ("deflection", exact.deflection(x), closed.deflection(x)),
            ("clearance", exact.clearance(x), closed.clearance(x)),
            ("moment", exact.moment(x), closed.moment(x)),
            ("pressure", exact.pressure(x), closed.pressure(x)),
        ] {
            assert!((found - also).abs() <= DIGITS, "{what} at {x}: {found} and {also}");
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

/// Every beam with a closed form, the paper's and on any supports or none: deflection, moment, energy, places and forces of contacts, reactions.
#[test]
fn beams_on_any_supports_are_those_of_their_closed_forms() {
    /// Of derivatives of quartics through five values.
    const DERIVED: f64 = 1e-10;
    for known in closed::all().expect("well-posed scenes") {
        let Closed { name, scene, contacts, .. } = &known;
        let exact = super::solved(scene);
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
