//! The brackets of single numbers: they hold what closed forms, fractions and beam theory say, they are narrow, and without them
//! nothing is certified.

use palkki::certificate::Certificate;
use palkki::route::{Method, Solution, Solver, Status};
use palkki::scene::{Foundation, LinearLoad, Scene, Support};
use palkki::theory::{self, Exact};
use palkki::verdict::{Demand, Number, Refusal, Verdict};
use palkki::{Settings, Witness, solve_raw};
use palkki_evidence::brackets::outside;
use palkki_evidence::draft::Draft;
use palkki_evidence::{hostile, random};

/// What is promised of the exact solution.
const SHARE: f64 = 1e-6;
/// Digits that beam theory has lost where a scene is ill-conditioned (those of `certificate::truth`), and a closed form of a few terms.
const THEORY: f64 = 1e-9;
const ROUNDING: f64 = 1e-14;

fn exact(scene: &Scene) -> (Exact, Verdict) {
    let exact = theory::solve(scene).expect("an answer");
    let verdict = Verdict::of_exact(scene, &exact, &Demand::default());
    (exact, verdict)
}

#[track_caller]
fn holds(what: &str, bracket: Option<[f64; 2]>, value: f64, slack: f64, width: f64) {
    let [least, most] = bracket.unwrap_or_else(|| panic!("{what}: there is a bracket"));
    assert!(least <= value + slack && value - slack <= most, "{what}: {value:?} is not in [{least:?}, {most:?}]");
    assert!(most - least <= width, "{what}: [{least:?}, {most:?}] is wider than {width:e}");
}

/// Greatest and least moment by closed form: on two supports, built in, overhanging, lifted by a support, on flat ground with
/// `q a²/8` where it hangs free (in fractions, `a = 2`), and lying on a parabola with `−EI u''`.
#[test]
fn moments_by_closed_form() {
    let [q, ei, l] = [3.0, 4.0, 10.0];
    let draft = || Draft { length: l, stiffness: ei, uniform: q, ..Draft::default() };
    let on = |supports: Vec<Support>| Draft { supports: Some(supports), ..draft() };
    let built_in = |at: f64| Support { slope: Some(0.0), ..Support::simple(at) };
    let ground = |ground: Foundation| Draft { ground: Some(ground), ..draft() };
    let parabola = Foundation::Polynomial { coefficients: vec![0.0, 0.0, 0.01] };
    let lying = Draft { supports: Some(Vec::new()), ..ground(parabola) };
    for (what, draft, [most, least]) in [
        ("on two supports", draft(), [q * l * l / 8.0, 0.0]),
        ("cantilever", on(vec![built_in(0.0)]), [0.0, -q * l * l / 2.0]),
        ("built in", on(vec![built_in(0.0), built_in(l)]), [q * l * l / 24.0, -q * l * l / 12.0]),
        ("propped", on(vec![built_in(0.0), Support::simple(l)]), [9.0 * q * l * l / 128.0, -q * l * l / 8.0]),
        ("overhanging", on(vec![Support::simple(2.0), Support::simple(8.0)]), [q * 36.0 / 8.0 - 6.0, -6.0]),
        ("two spans", on([0.0, 5.0, l].map(Support::simple).to_vec()), [9.0 * q * 25.0 / 128.0, -q * 25.0 / 8.0]),
        ("on flat ground", ground(Foundation::Flat { depth: 0.5 }), [q * 4.0 / 8.0, 0.0]),
    ] {
        let scene = draft.scene().expect("well posed");
        let (_, verdict) = exact(&scene);
        let size = most.max(-least);
        let certificate = verdict.certificate.expect("bounds");
        for (bracket, value) in certificate.moments.into_iter().zip([most, least]) {
            holds(what, bracket, value, ROUNDING * size, SHARE * size);
        }
    }
    // With a free end there is a moment of zero as well.
    let (found, verdict) = exact(&lying.scene().expect("well posed"));
    let [_, least] = verdict.certificate.expect("bounds").moments;
    holds("on a parabola", least, found.state.moment.min, THEORY, SHARE * found.state.moment.magnitude());
}

fn check(what: &str, certificate: &Certificate, scene: &Scene, exact: &Exact, narrow: &mut [usize; 2]) {
    let (state, size) = (&exact.state, exact.state.moment.magnitude());
    let load = scene.load().magnitude(scene.beam().length());
    let inside = |what: &str, bracket: Option<[f64; 2]>, value: f64, slack: f64| {
        let Some([least, most]) = bracket else { return false };
        assert!(least <= value + slack && value - slack <= most, "{what}: {value:?} is not in {bracket:?}");
        most - least <= SHARE * (value.abs() + slack / THEORY)
    };
    for (support, bracket) in state.supports.iter().zip(&certificate.reactions) {
        inside(what, *bracket, support.force, THEORY * load.max(support.force.abs()));
    }
    let contact = state.contact_force();
    let forces = state.supports.iter().fold(load + contact, |sum, support| sum + support.force.abs());
    inside(what, certificate.contact_force, contact, THEORY * forces);
    inside(what, certificate.deflection_max, state.deflection.max, THEORY * state.deflection.magnitude());
    for (value, bracket) in [state.moment.max, state.moment.min].into_iter().zip(certificate.moments) {
        let is_narrow = inside(what, bracket, value, THEORY * size);
        narrow[usize::from(is_narrow)] += 1;
    }
}

/// Random scenes, held in every way: whatever witness they are proven from, brackets hold what beam theory says, and those of moments
/// are mostly as narrow as is promised.
#[test]
fn brackets_hold_on_random_scenes() {
    let (mut narrow, mut wrong) = ([0; 2], [0; 2]);
    for i in 0..80 {
        for (kind, scene) in [random::scene(i), random::on_lattice(i), random::held(i)].into_iter().enumerate() {
            let Ok(exact) = theory::solve(&scene) else { continue };
            if !exact.solved {
                continue;
            }
            let certificate = palkki::verdict::certificate(&exact.state, &Witness::of(&scene)).expect("numbers");
            if certificate.contacts_proven {
                check(&format!("{kind}, {i}"), &certificate, &scene, &exact, &mut narrow);
            }
            // A witness that is wrong makes them wide, and not untrue.
            let mut moved = exact.state.clone();
            for contact in moved.contacts.iter_mut().filter(|contact| contact.from < contact.to) {
                contact.from += 1e-3 * (contact.to - contact.from);
            }
            let certificate = palkki::verdict::certificate(&moved, &Witness::of(&scene)).expect("numbers");
            check(&format!("{kind}, {i}, moved"), &certificate, &scene, &exact, &mut wrong);
        }
    }
    assert!(19 * narrow[0] < narrow[1], "{narrow:?} brackets of moments are wide and narrow");
    assert!(20 < wrong[0], "{wrong:?}: a wrong witness has wide ones");
}

/// Two supports from a tenth to a hundred-thousandth of the beam apart, at one level or nearly so, and a third one, above uneven ground
/// out of reach: what a rounded depth would do between them grows with the third power of the distance. One is built in, or none.
#[test]
fn forces_of_supports_close_together() {
    let mut random = random::Random::new(41);
    let mut seen = [0; 2];
    for k in 0..240 {
        let length = random.pick(&[8.0, 1.0, 7.3]);
        let apart = length * 10.0_f64.powf(random.between(-5.0, -1.0));
        let (first, level) = (random.between(0.1, 0.5) * length, length * random.between(0.3, 0.5));
        let rise = if k % 3 == 0 { apart * random.between(-0.01, 0.01) } else { 0.0 };
        let third = [random.between(0.7, 1.0) * length, level + length * random.between(-0.05, 0.05)];
        let places = [[first, level], [first + apart, level + rise], third];
        let mut supports = places.map(|[at, level]| Support { level, ..Support::simple(at) }).to_vec();
        if k % 2 == 0 {
            supports[random.below(2)].slope = Some(0.0);
        }
        let places = (0..=8).map(|k| 0.125 * f64::from(k) * length);
        let points = places.map(|x| [x, level + length * random.between(0.1, 0.2)]).collect();
        let ground = Some(Foundation::Polyline { points });
        let supports = Some(supports);
        let draft =
            Draft { length, stiffness: random.pick(&[1.3, 500.0 / 384.0]), supports, ground, ..Draft::default() };
        let scene = draft.with_points(&[(random.between(0.6, 1.0) * length, 1e-2)]).scene().expect("well posed");
        let (exact, verdict) = exact(&scene);
        if !exact.state.contacts.is_empty() {
            continue;
        }
        let certificate = verdict.certificate.expect("bounds");
        seen[k % 2] += certificate.reactions.iter().flatten().count();
        let outside = outside(&scene, &exact.state, &certificate);
        assert!(outside.is_empty(), "{outside:?}\n{}", Draft::from(&scene).text());
    }
    assert!(seen.iter().all(|seen| 200 < *seen), "{seen:?} brackets");
}

/// Whatever is certified lies in its brackets, as it is printed: every force of a support, that of all contacts, moments and the
/// greatest deflection.
#[test]
fn what_is_certified_lies_in_its_brackets() {
    let drawn = (0..random::sample_of(100)).flat_map(|i| {
        [random::scene(i), random::on_lattice(i), random::held(i), random::coinciding(i), random::rough(i)]
    });
    let hostile =
        hostile::seeds(300_000..300_000 + random::sample_of(600)).filter_map(|seed| hostile::draft(seed).scene().ok());
    let mut brackets = 0;
    for scene in drawn.chain(hostile) {
        let Ok(exact) = theory::solve(&scene) else { continue };
        let verdict = Verdict::of_exact(&scene, &exact, &Demand::default());
        let Some(certificate) = verdict.certificate.filter(|_| verdict.refusal.is_none()) else { continue };
        let outside = outside(&scene, &exact.state, &certificate);
        assert!(outside.is_empty(), "{outside:?}\n{}", Draft::from(&scene).text());
        brackets += certificate.reactions.iter().chain(&certificate.moments).flatten().count();
    }
    assert!(random::sample_of(3000) < brackets, "{brackets} brackets");
}

/// The refusal of an exact answer after a change; there is none before.
#[track_caller]
fn refused(scene: &Scene, exact: &Exact, change: impl FnOnce(&mut Exact)) -> Option<Refusal> {
    let mut changed = exact.clone();
    change(&mut changed);
    let verdict = Verdict::of_exact(scene, &changed, &Demand::default());
    assert_eq!(verdict.status, Status::NotCertified, "{verdict}");
    verdict.refusal
}

/// Each number of a summary alone, changed by ten times what is allowed: nothing is certified, and the number is named.
#[test]
fn each_number_is_asked_for() {
    let of = |refusal: Option<Refusal>| match refusal {
        Some(Refusal::Number { of, share, most }) if most < share => Some(of),
        _ => None,
    };
    let mut tried = 0;
    for i in 0..40 {
        let scene = random::scene(i);
        let (exact, verdict) = exact(&scene);
        let [support, moment] =
            [exact.state.supports.iter().map(|s| s.force.abs()).fold(0.0, f64::max), exact.state.moment.magnitude()];
        if verdict.status != Status::Certified || exact.state.contacts.is_empty() || support <= 0.0 {
            continue;
        }
        tried += 1;
        for k in 0..exact.state.supports.len() {
            let change = |exact: &mut Exact| exact.state.supports[k].force += 1e-5 * support;
            assert_eq!(of(refused(&scene, &exact, change)), Some(Number::Support(k)), "{i}");
        }
        let largest = support.max(exact.state.contact_force());
        let change = |exact: &mut Exact| exact.state.contacts[0].force += 1e-5 * largest;
        assert_eq!(of(refused(&scene, &exact, change)), Some(Number::ContactForce), "{i}");
        for sign in [-1.0, 1.0] {
            let change = |exact: &mut Exact| exact.state.moment.max += sign * 1e-2 * moment;
            assert_eq!(of(refused(&scene, &exact, change)), Some(Number::Moment), "{i}");
        }
        // On a grid, by what is asked there.
        let Ok(raw) = solve_raw(&scene, &Settings::new(Method::Force, Solver::ActiveSet, 200)) else { continue };
        let witness = Witness::of(&scene);
        if Verdict::of_raw(&raw, &witness, &Demand::default()).status != Status::Certified {
            continue;
        }
        let changed = |change: &dyn Fn(&mut Solution<()>)| {
            let mut changed = raw.clone();
            change(&mut changed);
            of(Verdict::of_raw(&changed, &witness, &Demand::default()).refusal)
        };
        assert_eq!(changed(&|raw| raw.state.energy *= 2.0), Some(Number::Energy), "{i}");
        let size = raw.state.deflection.magnitude();
        assert_eq!(changed(&|raw| raw.state.deflection.max += 2.0 * size), Some(Number::Deflection), "{i}");
    }
    assert!(10 < tried, "{tried} scenes");
}

/// A load on a support that holds is carried there, and the beam is the same without it: so are the brackets of the contact force and of
/// the other supports, and a force that is off by a ten-thousandth of itself is refused, however large the load is.
#[test]
fn a_load_on_a_support_hides_no_other_force() {
    for k in 1..=8_u32 {
        let (middle, depth) = (3.0 + 0.5 * f64::from(k), 0.2 * f64::from(k));
        let supports = if k % 2 == 0 { vec![0.0, 10.0] } else { vec![0.0, middle, 10.0] };
        let draft = Draft {
            length: 10.0,
            stiffness: 1.3,
            uniform: 1.0,
            ground: Some(Foundation::Flat { depth }),
            supports: Some(supports.iter().copied().map(Support::simple).collect()),
            ..Draft::default()
        };
        let alone = exact(&draft.scene().expect("well posed")).1.certificate.expect("bounds");
        for (at, load) in supports.iter().flat_map(|at| [1e6, 1e10, 1e13, -1e13].map(|load| (*at, load))) {
            let scene = draft.clone().with_points(&[(at, load)]).scene().expect("well posed");
            let (found, verdict) = exact(&scene);
            assert_eq!(verdict.refusal, None, "{k}: {load} at {at}");
            let certificate = verdict.certificate.expect("bounds");
            let others = supports.iter().enumerate().filter(|(_, x)| **x < at || at < **x).map(|(i, _)| i);
            let others: Vec<usize> = others.collect();
            let pairs = others.iter().map(|&i| (certificate.reactions[i], alone.reactions[i]));
            for (bracket, alone) in pairs.chain([(certificate.contact_force, alone.contact_force)]) {
                let ([least, most], [low, high]) = (bracket.expect("a bracket"), alone.expect("a bracket"));
                let off = (least - low).abs().max((most - high).abs());
                assert!(off <= THEORY * high.abs().max(1.0), "{k}: {load} at {at}: {bracket:?} {alone:?}");
            }
            for i in others {
                let mut forged = found.clone();
                forged.state.supports[i].force *= 1.0001;
                let refusal = Verdict::of_exact(&scene, &forged, &Demand::default()).refusal;
                let is_told =
                    matches!(refusal, Some(Refusal::Number { of: Number::Support(_) | Number::ContactForce, .. }));
                assert!(is_told, "{k}: {load} at {at}: {refusal:?}");
            }
        }
    }
}

/// A beam that is straight between two supports and carries nothing but a load on one of them has no other force, and that is certain to
/// what its levels are rounded by; a force of more than that is refused.
#[test]
fn a_straight_beam_has_no_force() {
    let levels = [[0.1, 0.25], [0.0, 0.25], [0.3, 0.3], [0.7, 0.1]];
    for (levels, stiffness) in levels.iter().flat_map(|levels| [1e-6, 1.3, 1e9].map(|stiffness| (levels, stiffness))) {
        for (at, force) in [(0.0, 3.0), (10.0, 3.0), (10.0, -1e-3)] {
            let [left, right] = *levels;
            let draft = Draft {
                length: 10.0,
                stiffness,
                ground: Some(Foundation::Flat { depth: 1.0 }),
                supports: Some(vec![Support::simple(0.0).at_level(left), Support::simple(10.0).at_level(right)]),
                ..Draft::default()
            };
            let scene = draft.with_points(&[(at, force)]).scene().expect("well posed");
            let (found, verdict) = exact(&scene);
            assert_eq!(verdict.refusal, None, "{levels:?}, {stiffness}, {force} at {at}");
            let mut forged = found;
            forged.state.supports[0].force += (1e-9 * stiffness).max(1e-12);
            let refusal = Verdict::of_exact(&scene, &forged, &Demand::default()).refusal;
            assert!(refusal.is_some(), "{levels:?}, {stiffness}, {force} at {at}");
        }
    }
}

/// The beam lies on level ground up to a support at its end, where the load that presses it vanishes: the reaction is known there, from
/// either side.
#[test]
fn a_load_that_vanishes_at_a_support_on_the_ground_leaves_a_bracket() {
    let draft = Draft {
        length: 8.0,
        stiffness: 1.0,
        linear: vec![LinearLoad { from: 0.0, to: 8.0, start: 1.0, end: 0.0 }],
        ground: Some(Foundation::Polyline { points: vec![[0.0, 0.01], [2.0, -0.01], [2.0, 0.0], [8.0, 0.0]] }),
        ..Draft::default()
    };
    for (side, draft) in [("right", draft.clone()), ("left", draft.mirrored())] {
        let (found, verdict) = exact(&draft.scene().expect("well posed"));
        assert_eq!(verdict.status, Status::Certified, "{side}: {verdict}");
        let certificate = verdict.certificate.expect("a proof");
        for (support, bracket) in found.state.supports.iter().zip(&certificate.reactions) {
            holds(side, *bracket, support.force, ROUNDING, SHARE);
        }
    }
}
