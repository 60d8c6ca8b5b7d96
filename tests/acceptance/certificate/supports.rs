//! Beams on any supports, with own shapes, free ends and none to hold them, against closed forms.
//!
//! With the right contacts the deflection is known to a billionth of its size. With wrong ones what is said stays true: of the
//! deflection of nodes that are off by a known amount, and of the energy, whose bounds from any two witnesses overlap.

use palkki::certificate::{Certificate, ContactLoad, Judged, Lumped, certify, violations};
use palkki::scene::{Beam, Foundation, Load, PointLoad, Scene, Support};
use palkki::state::{Contact, Nodes};
use palkki_evidence::faults::{CONTACT_FAULTS, SIZES};

/// What is known of a scene without solving it.
struct Known {
    name: String,
    scene: Scene,
    contacts: Vec<Contact>,
    deflection: Box<dyn Fn(f64) -> f64>,
}

fn at(x: f64) -> Contact {
    Contact::at(x, 1.0)
}

pub(super) fn zone(from: f64, to: f64) -> Contact {
    Contact { from, to, force: 1.0, end_forces: None }
}

fn known(
    name: &str,
    beam: &Beam,
    load: f64,
    ground: Option<Foundation>,
    contacts: &[Contact],
    deflection: impl Fn(f64) -> f64 + 'static,
) -> Known {
    let load = Load::uniform_on(beam, load).expect("finite");
    let scene = Scene::new(beam.clone(), load, ground).expect("well posed");
    Known { name: name.to_owned(), scene, contacts: contacts.to_vec(), deflection: Box::new(deflection) }
}

pub(super) fn held(length: f64, stiffness: f64, supports: Vec<Support>) -> Beam {
    Beam::new(length, stiffness).expect("positive").with_supports(supports).expect("supports on the beam")
}

pub(super) fn flat(depth: f64) -> Option<Foundation> {
    Some(Foundation::Flat { depth })
}

/// Nodes at equal distances with the deflection of a function, without moments between them: what is judged at the nodes.
pub(super) fn sampled(scene: &Scene, deflection: impl Fn(f64) -> f64) -> Nodes {
    let length = scene.beam().length();
    let held = |x: f64| scene.beam().supports().iter().any(|s| (s.at - x).abs() <= 0.0);
    let places = (0..=40_u32).map(|k| length * f64::from(k) / 40.0);
    let x: Vec<f64> = places.filter(|&x| (0.0 < x && x < length) || !held(x)).collect();
    let deflection: Vec<f64> = x.iter().map(|&x| deflection(x)).collect();
    Nodes { moment: vec![0.0; x.len()], deflection, x, ..Nodes::default() }
}

/// With the right contacts what is said is sharp, and with any others it is true.
#[track_caller]
fn check(known: &Known) -> Certificate {
    /// Of the largest deflection.
    const SHARP: f64 = 1e-9;
    /// Of closed forms.
    const ROUNDING: f64 = 1e-11;
    let Known { name, scene, contacts, deflection } = known;
    let length = scene.beam().length();
    let said = |judged: Judged<'_>, witness: &[Contact]| certify(scene, judged, witness).expect("in range");
    let right = said(Judged::Witness, contacts);
    let places = (0..=200_u32).map(|k| length * f64::from(k) / 200.0);
    let size = places.fold(0.0, |most: f64, x| most.max(deflection(x).abs()));
    assert!((right.deflection - size).abs() <= 1e-3 * size + ROUNDING, "{name}: {size} for {right:?}");
    assert!(right.deflection_error <= SHARP * size.max(1e-3), "{name}: {right:?}");
    assert!(right.energy_lower <= right.energy_upper, "{name}: {right:?}");

    // Nodes that are off, by any witness.
    for off in [0.0, 0.03 * size.max(1.0), -0.2 * size.max(1.0)] {
        let nodes = sampled(scene, |x| deflection(x) + off * (3.0 * x / length).sin());
        let differences = nodes.x.iter().zip(&nodes.deflection).map(|(x, v)| (v - deflection(*x)).abs());
        let most = differences.fold(0.0, f64::max);
        let holds = |what: &str, witness: &[Contact]| {
            let said = said(Judged::Nodes(&nodes), witness);
            assert!(most <= said.deflection_error + ROUNDING * size.max(1.0), "{name}, {what}: {most} for {said:?}");
            let slack = ROUNDING * (right.energy_upper.abs() + right.energy_lower.abs());
            let overlap =
                said.energy_lower <= right.energy_upper + slack && right.energy_lower - slack <= said.energy_upper;
            assert!(overlap, "{name}, {what}: {said:?} and {right:?}");
            for (own, other) in said.reactions.iter().zip(&right.reactions) {
                let (Some([a, b]), Some([c, d])) = (own, other) else { continue };
                let slack = ROUNDING * (1.0 + c.abs() + d.abs());
                assert!(*a <= d + slack && c - slack <= *b, "{name}, {what}: {own:?} and {other:?}");
            }
            said
        };
        let sharp = holds("right", contacts);
        assert!(sharp.deflection_error.is_finite(), "{name}: {sharp:?}");
        holds("none", &[]);
        for fault in CONTACT_FAULTS {
            let sizes = if fault.sized { &SIZES[..] } else { &SIZES[..1] };
            for &size in sizes {
                if let Some(wrong) = fault.put_into(contacts, size, length) {
                    holds(&format!("{} by {size}", fault.name), &wrong);
                }
            }
        }
    }
    right
}

const EI: f64 = 7.0;
const Q: f64 = 3.0;

/// The tip of a cantilever of length `c` at the distance `s` from where it is built in: `q s² (6 c² − 4 c s + s²)/24 EI`.
fn overhang(c: f64, s: f64) -> f64 {
    Q * s * s * (6.0 * c * c - 4.0 * c * s + s * s) / (24.0 * EI)
}

/// A simple span: `q x (l³ − 2 l x² + x³)/24 EI`.
fn simple(l: f64, x: f64) -> f64 {
    Q * x * (l * l * l - 2.0 * l * x * x + x * x * x) / (24.0 * EI)
}

/// Two supports at `a` and `b` of a beam from 0 to `l`: a simple span with the moments `−q c²/2` of the overhangs `c`.
fn between(a: f64, b: f64, l: f64, x: f64) -> f64 {
    let (w, left, right) = (b - a, -0.5 * Q * a * a, -0.5 * Q * (l - b) * (l - b));
    // M s (w² − s²)/6 EI w of a moment at the far end of s.
    let bent = |m: f64, s: f64| m * s * (w * w - s * s) / (6.0 * EI * w);
    let turned = |m: f64, other: f64| Q * w * w * w / (24.0 * EI) + (2.0 * m + other) * w / (6.0 * EI);
    if x < a {
        -turned(left, right) * (a - x) + overhang(a, a - x)
    } else if b < x {
        -turned(right, left) * (x - b) + overhang(l - b, x - b)
    } else {
        simple(w, x - a) + bent(right, x - a) + bent(left, b - x)
    }
}

#[test]
fn built_in_beams_are_known() {
    let l = 4.0;
    let cantilever = held(l, EI, vec![Support::built_in(0.0)]);
    check(&known("cantilever", &cantilever, Q, None, &[], move |x| overhang(l, x)));
    check(&known("cantilever above deep ground", &cantilever, Q, flat(100.0), &[], move |x| overhang(l, x)));
    // The tip touches with R = q l/4: h = q l⁴/8 EI − R l³/3 EI.
    let h = Q * l * l * l * l / (24.0 * EI);
    let propped = move |x: f64| overhang(l, x) - 0.25 * Q * l * x * x * (3.0 * l - x) / (6.0 * EI);
    check(&known("cantilever, its tip touches", &cantilever, Q, flat(h), &[at(l)], propped));
    // Lift-off at a⁴ = 72 EI h/q from where it is built in, v = h − q s³ (4 a − 3 s)/72 EI.
    let h = 0.1_f64;
    let a = (72.0 * EI * h / Q).sqrt().sqrt();
    let lying = move |x: f64| {
        let s = (a - x).max(0.0);
        h - Q * s * s * s * (4.0 * a - 3.0 * s) / (72.0 * EI)
    };
    check(&known("cantilever that lies on the ground", &cantilever, Q, flat(h), &[zone(a, l)], lying));
    let turned = held(l, EI, vec![Support::built_in(l)]);
    check(&known("the same from the right", &turned, Q, flat(h), &[zone(0.0, l - a)], move |x| lying(l - x)));

    let l = 10.0;
    let both = held(l, EI, vec![Support::built_in(0.0), Support::built_in(l)]);
    let fixed = move |x: f64| Q * x * x * (l - x) * (l - x) / (24.0 * EI);
    check(&known("built in at both ends", &both, Q, flat(100.0), &[], fixed));
    check(&known("built in at both ends above ground", &both, Q, flat(h), &[zone(a, l - a)], move |x| {
        lying(x.min(l - x))
    }));
    // A slope of the left support alone: v = φ x (l − x)²/l².
    let sloping = held(l, EI, vec![Support { slope: Some(0.3), ..Support::simple(0.0) }, Support::built_in(l)]);
    check(&known("turned at one end", &sloping, 0.0, None, &[], move |x| 0.3 * x * (l - x) * (l - x) / (l * l)));
    let level = held(l, EI, vec![Support::built_in(0.0).at_level(0.5), Support::simple(4.0).at_level(0.5)]);
    let on_it = known("on ground that is level with all supports", &level, Q, flat(0.5), &[zone(0.0, l)], |_| 0.5);
    check(&on_it);
}

#[test]
fn spans_and_overhangs_are_known() {
    let l = 6.0;
    // A span that is simple at x = 0 and built in at L: q x (L³ − 3 L x² + 2 x³)/48 EI.
    let half = 0.5 * l;
    let propped = move |x: f64| Q * x * (half * half * half - 3.0 * half * x * x + 2.0 * x * x * x) / (48.0 * EI);
    let two = held(l, EI, vec![Support::simple(0.0), Support::simple(half), Support::simple(l)]);
    let said = check(&known("two spans", &two, Q, None, &[], move |x| propped(x.min(l - x))));
    for (bracket, share) in said.reactions.iter().zip([0.375, 1.25, 0.375]) {
        let [least, most] = bracket.expect("there is no ground");
        let force = share * Q * half;
        assert!(least <= force && force <= most && most - least < 1e-6 * force, "{force} in {bracket:?}");
    }
    check(&known("two spans above deep ground", &two, Q, flat(10.0), &[], move |x| propped(x.min(l - x))));
    // The middle one settles: v = δ x (3 l² − 4 x²)/l³ up to it.
    let settled = held(l, EI, vec![Support::simple(0.0), Support::simple(half).at_level(0.4), Support::simple(l)]);
    let settlement = move |x: f64| 0.4 * x * (3.0 * l * l - 4.0 * x * x) / (l * l * l);
    check(&known("settlement", &settled, 0.0, flat(10.0), &[], move |x| settlement(x.min(l - x))));
    for [a, b] in [[0.0, 4.0], [1.0, 5.5], [2.0, 6.0], [0.5, 3.0]] {
        let beam = held(l, EI, vec![Support::simple(b), Support::simple(a)]);
        let name = format!("overhangs beyond {a} and {b}");
        check(&known(&name, &beam, Q, flat(50.0), &[], move |x| between(a, b, l, x)));
    }
    // Lift-off at a⁴ = 24 EI h/q from supports at both ends, and on both sides of one in the middle, a⁴ = 72 EI h/q if it
    // stands so that the beam is horizontal there.
    let (h, l) = (0.05_f64, 16.0);
    let (a, b) = (
        (24.0 * EI * h / Q).sqrt().sqrt() / 3.0_f64.sqrt().sqrt() * 3.0_f64.sqrt().sqrt(),
        (72.0 * EI * h / Q).sqrt().sqrt(),
    );
    let beam = held(l, EI, vec![Support::simple(0.0), Support::simple(0.5 * l), Support::simple(l)]);
    let from_end = move |x: f64| {
        // v = h − q s³ (4 (a/2) … − s)/24 EI with s = a − x: three derivatives vanish at s = 0 but v'''.
        let s = (a - x).max(0.0);
        h - Q * s * s * s * (2.0 * a - s) / (24.0 * EI)
    };
    let from_middle = move |x: f64| {
        let s = (b - (0.5 * l - x)).max(0.0);
        h - Q * s * s * s * (4.0 * b - 3.0 * s) / (72.0 * EI)
    };
    let lying = move |x: f64| {
        let x = x.min(l - x);
        from_end(x).min(from_middle(x))
    };
    let zones = [zone(a, 0.5 * l - b), zone(0.5 * l + b, l - a)];
    check(&known("a zone in each of two spans", &beam, Q, flat(h), &zones, lying));
}

#[test]
fn own_shapes_are_known() {
    // A parabola under a straight beam, and the same beam bent the other way above flat ground.
    let (l, h, k) = (10.0, 0.4, 0.02);
    let bent = Foundation::Polynomial { coefficients: vec![0.0, -k * l, k] };
    let ground = Foundation::Polynomial { coefficients: vec![h, k * l, -k] };
    let straight = Beam::new(l, EI).expect("positive");
    let supports = |shape: &Foundation| {
        let at = [0.0, l].map(|x| Support::simple(x).at_level(shape.depth(x)));
        straight.clone().with_shape(shape.clone()).expect("an axis").with_supports(at.to_vec()).expect("on the beam")
    };
    let load = Load::uniform_on(&straight, Q).expect("finite");
    let one = Scene::new(straight.clone(), load.clone(), Some(ground)).expect("well posed");
    let other = Scene::new(supports(&bent), load, flat(h)).expect("well posed");
    let exact = palkki::theory::solve(&one).expect("theory knows the paper's beam");
    let said = |scene: &Scene| certify(scene, Judged::Witness, &exact.state.contacts).expect("in range");
    let (one, other) = (said(&one), said(&other));
    assert!(one.contacts_proven && other.contacts_proven, "{one:?} and {other:?}");
    assert!(one.energy_lower <= other.energy_upper && other.energy_lower <= one.energy_upper, "{one:?} and {other:?}");
    assert!((one.deflection - other.deflection).abs() <= 1e-9 * one.deflection, "{one:?} and {other:?}");

    // A ski that lies on flat ground by its own weight, up to overhangs with q c²/2 = EI κ.
    let (l, kappa) = (12.0, 0.03);
    let ski = Foundation::Polynomial { coefficients: vec![-0.125 * kappa * l * l, 0.5 * kappa * l, -0.5 * kappa] };
    let beam = held(l, EI, Vec::new()).with_shape(ski).expect("an axis");
    let gap = move |x: f64| 0.5 * kappa * (x - 0.5 * l) * (x - 0.5 * l);
    let c = (2.0 * EI * kappa / Q).sqrt();
    let closed = move |x: f64| {
        let s = (c - x.min(l - x)).max(0.0);
        gap(x) - Q * s * s * s * (4.0 * c - s) / (24.0 * EI)
    };
    check(&known("a ski that its weight closes", &beam, Q, flat(0.0), &[zone(c, l - c)], closed));
    let hump =
        Foundation::Polynomial { coefficients: vec![1.0 + 0.125 * kappa * l * l, -0.5 * kappa * l, 0.5 * kappa] };
    let beam = held(l, EI, Vec::new());
    check(&known("a hump under a free beam", &beam, Q, Some(hump), &[zone(c, l - c)], move |x| 1.0 + closed(x)));
}

#[test]
fn free_bodies_are_known() {
    let l = 6.0;
    let free = held(l, EI, Vec::new());
    check(&known("flat on flat ground", &free, Q, flat(0.5), &[zone(0.0, l)], |_| 0.5));
    for [a, b] in [[1.0, 5.5], [2.0, 3.5], [0.5, 4.0]] {
        let points = vec![[0.0, 30.0], [a, 1.0], [0.5 * (a + b), 30.0], [b, 1.0], [l, 30.0]];
        let ground = Foundation::Polyline { points };
        let touched = [at(a), at(b)];
        check(&known(&format!("on peaks at {a} and {b}"), &free, Q, Some(ground.clone()), &touched, move |x| {
            1.0 + between(a, b, l, x)
        }));
        let hinged = held(l, EI, vec![Support::simple(a).at_level(1.0)]);
        let said = check(&known(
            &format!("on a support at {a} and a peak at {b}"),
            &hinged,
            Q,
            Some(ground),
            &[at(b)],
            move |x| 1.0 + between(a, b, l, x),
        ));
        assert!(said.up_to_a_turn.is_none(), "{said:?}");
    }
    let hollow = Foundation::Polynomial { coefficients: vec![1.0, 20.0 * l, -20.0] };
    check(&known("on its tips", &free, Q, Some(hollow), &[at(0.0), at(l)], move |x| 1.0 + simple(l, x)));
    // A hump that is too sharp to lie on: the beam touches it below the resultant, wherever the crest is.
    for crest in [3.0, 2.5] {
        let kappa = 4.0;
        let slope = kappa * (0.5 * l - crest);
        let height = 0.5 * kappa * (0.5 * l - crest) * (0.5 * l - crest);
        let hump = vec![1.0 + 0.5 * kappa * crest * crest, -kappa * crest, 0.5 * kappa];
        let hump = Some(Foundation::Polynomial { coefficients: hump });
        check(&known("on a sharp hump", &free, Q, hump, &[at(0.5 * l)], move |x| {
            1.0 + height + slope * (x - 0.5 * l) + overhang(0.5 * l, (x - 0.5 * l).abs())
        }));
    }
    // On ground that slopes everything is turned with it.
    let sloping = Foundation::Polynomial { coefficients: vec![1.0, 0.25] };
    check(&known("flat on a slope", &free, Q, Some(sloping), &[zone(0.0, l)], |x| 1.0 + 0.25 * x));
}

/// A beam in balance on one place: how it stands is not known, and how it is bent is.
#[test]
fn of_a_beam_that_may_turn_the_bending_is_known() {
    let l = 6.0;
    let load = |beam: &Beam| Load::uniform_on(beam, Q).expect("finite");
    let seesaw = held(l, EI, vec![Support::simple(0.5 * l)]);
    let scene = Scene::new(seesaw.clone(), load(&seesaw), None).expect("well posed");
    let said = certify(&scene, Judged::Witness, &[]).expect("in balance");
    let bent = move |x: f64| overhang(0.5 * l, (x - 0.5 * l).abs());
    assert!(said.up_to_a_turn == Some(0.5 * l) && said.deflection_error <= 1e-9 * bent(0.0), "{said:?}");
    assert!((said.deflection - bent(0.0)).abs() <= 1e-9 * bent(0.0), "{said:?}");
    // −½ ∫M²/EI with M = q s²/2 on both sides.
    let energy = -2.0 * Q * Q * (0.5_f64 * l).powi(5) / (40.0 * EI);
    assert!(
        said.energy_lower <= energy * (1.0 - 1e-12) && energy * (1.0 + 1e-12) <= said.energy_upper,
        "{energy}: {said:?}"
    );
    let on_its_end = held(l, EI, Vec::new());
    let point = Load::new(&on_its_end, 0.0, Vec::new(), vec![PointLoad { at: 0.0, force: 5.0 }]).expect("finite");
    let scene = Scene::new(on_its_end, point, flat(2.0)).expect("well posed");
    let said = certify(&scene, Judged::Witness, &[at(0.0)]).expect("in balance");
    assert!(said.up_to_a_turn == Some(0.0) && said.deflection_error <= 1e-9, "{said:?}");
    assert!(said.energy_lower <= -10.0 && -10.0 <= said.energy_upper, "−P g: {said:?}");
    // On ground that rises it stands as little inclined as the ground lets it.
    let on_its_end = held(l, EI, Vec::new());
    let point = Load::new(&on_its_end, 0.0, Vec::new(), vec![PointLoad { at: 0.0, force: 5.0 }]).expect("finite");
    let rising = Foundation::Polynomial { coefficients: vec![2.0, -0.125, -0.01] };
    let scene = Scene::new(on_its_end, point, Some(rising)).expect("well posed");
    let said = certify(&scene, Judged::Witness, &[at(0.0)]).expect("in balance");
    assert!(said.up_to_a_turn == Some(0.0) && said.deflection_error <= 1e-7, "{said:?}");
}

/// Forces from elsewhere: those of the supports follow, and what does not balance is told.
#[test]
fn forces_from_elsewhere_are_bounded_on_any_supports() {
    let l = 6.0;
    let free = held(l, EI, Vec::new());
    let ground = Foundation::Polyline { points: vec![[0.0, 30.0], [1.0, 1.0], [3.0, 30.0], [5.5, 1.0], [l, 30.0]] };
    let scene =
        Scene::new(free.clone(), Load::uniform_on(&free, Q).expect("finite"), Some(ground)).expect("well posed");
    // Σp = q l, Σ p x = q l²/2.
    let right = Q * l * (0.5 * l - 1.0) / 4.5;
    let exact = [(1.0, Q * l - right), (5.5, right)];
    let witness = [at(1.0), at(5.5)];
    let of = |forces: &[(f64, f64)]| {
        let forces = ContactLoad::new(l, forces.iter().copied()).expect("forces");
        let said = certify(&scene, Judged::Forces(&forces), &witness).expect("in range");
        (said, violations(&scene, &forces).expect("in range"))
    };
    let (said, violated) = of(&exact);
    assert!(said.deflection_error <= 1e-9 * said.deflection, "{said:?}");
    assert!(violated.iter().all(|v| v.relative < 1e-9), "{violated:?}");
    let (said, violated) = of(&[(1.0, 5.0), (5.5, 5.0)]);
    assert!(violated.iter().any(|v| v.kind.name() == "balance" && 7.9 < v.amount), "{violated:?}");
    assert!(said.deflection_error.is_finite(), "{said:?}");
    assert!(of(&[]).0.deflection_error.is_infinite(), "nothing holds the beam");

    let two = held(l, EI, vec![Support::built_in(0.0), Support::simple(3.0), Support::simple(l).at_level(0.2)]);
    let load = Load::uniform_on(&two, Q).expect("finite");
    let scene = Scene::new(two, load, flat(20.0)).expect("well posed");
    let none = ContactLoad::new(l, []).expect("none");
    let said = certify(&scene, Judged::Forces(&none), &[]).expect("in range");
    assert!(said.deflection_error <= 1e-9 * said.deflection, "three supports say all: {said:?}");
    assert!(violations(&scene, &none).expect("in range").is_empty());
    let lifted = ContactLoad::new(l, [(4.5, 0.5)]).expect("a force");
    let said = certify(&scene, Judged::Forces(&lifted), &[]).expect("in range");
    assert!(1e-3 * said.deflection < said.deflection_error, "{said:?}");
}

/// Forces at nodes, for a load that is lumped there: the exact ones of a statically determinate beam, on any supports. At the nodes
/// the beam is off by what the load bends between them, `q Δ² (…)/24 EI` at most some thousandths.
#[test]
fn lumped_forces_are_bounded_on_any_supports() {
    let l = 6.0;
    let free = held(l, EI, Vec::new());
    let ground = Foundation::Polyline { points: vec![[0.0, 30.0], [1.0, 1.0], [3.0, 30.0], [5.5, 1.0], [l, 30.0]] };
    let right = Q * l * (0.5 * l - 1.0) / 4.5;
    for (supports, contacts) in [
        (vec![], vec![(1.0, Q * l - right), (5.5, right)]),
        (vec![Support::simple(1.0).at_level(1.0)], vec![(5.5, right)]),
        (vec![Support::simple(1.0).at_level(1.0), Support::simple(5.5).at_level(1.0)], vec![]),
    ] {
        let beam = free.clone().with_supports(supports).expect("on the beam");
        let load = Load::uniform_on(&beam, Q).expect("finite");
        let scene = Scene::new(beam, load, Some(ground.clone())).expect("well posed");
        let rows = (0..=120_u32).map(|k| (l * f64::from(k) / 120.0, 0.0)).chain(contacts.iter().copied());
        let lumped = Lumped::new(&scene, rows).expect("nodes of equal intervals");
        assert_eq!(lumped.intervals(), 120);
        let witness: Vec<Contact> = contacts.iter().map(|c| at(c.0)).collect();
        let said = certify(&scene, Judged::Nodes(&lumped.nodes), &witness).expect("in range");
        let most = lumped.nodes.x.iter().zip(&lumped.nodes.deflection);
        let most = most.fold(0.0, |most: f64, (x, v)| most.max((v - 1.0 - between(1.0, 5.5, l, *x)).abs()));
        assert!(most <= said.deflection_error && said.deflection_error <= 5e-3, "{most} for {said:?}");
        let uneven = Lumped::new(&scene, [(0.0, 1.0), (2.0, 1.0), (4.1, 1.0), (l, 1.0)]);
        assert!(uneven.is_err(), "{uneven:?}");
    }
}
