//! Supports that only push, beside closed forms, and beside the same places as the tips of narrow teeth of the ground.

use palkki::certificate::{Judged, certify};
use palkki::route::Status;
use palkki::scene::{Balance, Beam, Foundation, Load, PointLoad, Scene, SceneError, Support, Unheld};
use palkki::state::{ContactState, Motion};
use palkki::{Solution, solve_exactly};
use palkki_evidence::differences::Trial;
use palkki_evidence::random::Random;

use super::{DIGITS, close};

const L: f64 = 6.0;
const EI: f64 = 70.0;

fn pushing(at: f64, level: f64) -> Support {
    Support::pushing(at).at_level(level)
}

/// A beam of length `2 L` under a uniform load and point loads.
fn scene(supports: Vec<Support>, uniform: f64, points: &[[f64; 2]], ground: Option<Foundation>) -> Scene {
    let beam = Beam::new(2.0 * L, EI).and_then(|beam| beam.with_supports(supports)).expect("a beam");
    let points = points.iter().map(|&[at, force]| PointLoad { at, force }).collect();
    let load = Load::new(&beam, uniform, Vec::new(), points).expect("a load");
    Scene::new(beam, load, ground).expect("a scene")
}

/// A witness that leaves out a support that pushes, hardly or hard, has brackets that hold: a beam on three supports of which the one in the
/// middle, with play, carries what the play leaves of `5 q L/4`.
#[test]
fn a_witness_without_a_support_that_pushes_proves_nothing_untrue() {
    let q = 0.8;
    let most = 5.0 * q * L.powi(4) / (24.0 * EI);
    let mut bracketed = 0;
    for share in [1e-12, 1e-9, 1e-6, 1e-3, 0.3] {
        let supports = vec![Support::simple(0.0), pushing(L, most * (1.0 - share)), Support::simple(2.0 * L)];
        let said = certify(&scene(supports, q, &[], None), Judged::Witness, &[]).expect("in range");
        let middle = 1.25 * q * L * share;
        let ends = q * L - 0.5 * middle;
        for (bracket, force) in said.reactions.iter().zip([ends, middle, ends]) {
            let Some([least, most]) = *bracket else { continue };
            assert!(least <= force && force <= most, "{share:e}: {force} is not in {bracket:?}");
            bracketed += 1;
        }
    }
    assert!(0 < bracketed);
}

#[track_caller]
fn certified(scene: &Scene) -> Solution {
    let solution = solve_exactly(scene).expect("an answer");
    assert_eq!(solution.verdict.status, Status::Certified, "{}", solution.verdict);
    solution
}

/// The forces of the supports, of an answer with a bracket around each of them.
#[track_caller]
fn forces(scene: &Scene) -> Vec<f64> {
    let Solution { state, verdict, .. } = certified(scene);
    let brackets = verdict.certificate.expect("bounds").reactions;
    assert_eq!(brackets.len(), state.supports.len());
    let rounding = DIGITS * state.supports.iter().map(|support| support.force.abs()).sum::<f64>();
    for (support, bracket) in state.supports.iter().zip(brackets) {
        let [least, most] = bracket.expect("a bracket");
        assert!(least - rounding <= support.force && support.force <= most + rounding, "{least} … {most}");
    }
    state.supports.iter().map(|support| support.force).collect()
}

/// Two spans under a uniform load `q` and a load `P` in the middle of the right one: the left end carries `3qL/8 − 3P/32`, and lifts
/// off for `P > 4qL`. Then `q` on the overhang and `P` turn the beam at the middle support by `θ = (P L²/16 + q L³/24 − q L³/6)/EI`.
#[test]
fn two_spans_lift_off_their_end() {
    let q = 0.8;
    let most = 4.0 * q * L;
    let of =
        |p: f64| scene(vec![pushing(0.0, 0.0), Support::simple(L), pushing(2.0 * L, 0.0)], q, &[[1.5 * L, p]], None);
    for share in [0.0, 0.5, 0.999] {
        let [left, middle, right] = forces(&of(share * most))[..] else { panic!("three supports") };
        let p = share * most;
        close("left", left, 3.0 * q * L / 8.0 - 3.0 * p / 32.0);
        close("right", right, 3.0 * q * L / 8.0 + 13.0 * p / 32.0);
        close("middle", middle, 1.25 * q * L + 22.0 * p / 32.0);
    }
    for share in [1.001, 2.0, 100.0] {
        let p = share * most;
        let scene = of(p);
        let [left, _, right] = forces(&scene)[..] else { panic!("three supports") };
        close("left", left, 0.0);
        close("right", right, 0.5 * p + 0.5 * q * L - 0.5 * q * L);
        let turned = (p * L * L / 16.0 + q * L * L * L / 24.0 - q * L * L * L / 6.0) / EI;
        let exact = certified(&scene).exact.expect("beam theory");
        let tip = q * L.powi(4) / (8.0 * EI) - turned * L;
        assert!(
            (exact.deflection(0.0) - tip).abs() <= 1e-11 * turned * L,
            "{} instead of {tip}",
            exact.deflection(0.0)
        );
        close("clearance", exact.clearance(0.0), -exact.deflection(0.0));
    }
    // Within rounding of the border the force is zero within rounding.
    assert!(forces(&of(most))[0].abs() <= 1e-12 * most);
}

/// A settled middle support carries `48 EI (δ − s)/(2L)³`, `δ = 5 q (2L)⁴/384 EI`, as long as that is positive: play closes under
/// `q = 384 EI s/5 (2L)⁴`.
#[test]
fn play_closes_under_load() {
    let l = 2.0 * L;
    let play = 0.05;
    let closes = 384.0 * EI * play / (5.0 * l.powi(4));
    let of = |q: f64| scene(vec![Support::simple(0.0), pushing(L, play), Support::simple(l)], q, &[], None);
    for share in [0.0, 0.5, 0.999, 1.001, 3.0] {
        let q = share * closes;
        let [left, middle, _] = forces(&of(q))[..] else { panic!("three supports") };
        let sag = 5.0 * q * l.powi(4) / (384.0 * EI);
        let carried = (48.0 * EI * (sag - play) / (l * l * l)).max(0.0);
        close("middle", middle, carried);
        close("left", left, 0.5 * (q * l - carried));
        let state = certified(&of(q)).state;
        assert!(state.contacts.is_empty() && state.contact_force() == 0.0, "a bearing is no ground");
    }
}

/// A seesaw: a beam on a high pivot tips onto the end on which the load stands, and statics give both forces.
#[test]
fn a_seesaw_tips_to_its_load() {
    let of =
        |at: f64, p: f64| scene(vec![pushing(0.0, 1.0), pushing(L, 0.0), pushing(2.0 * L, 1.0)], 0.0, &[[at, p]], None);
    for (at, loaded) in [(0.3 * L, 0), (1.2 * L, 2), (1.9 * L, 2)] {
        let found = forces(&of(at, 2.0));
        let lever = (at - L).abs() / L;
        close("the end under the load", found[loaded], 2.0 * lever);
        close("the pivot", found[1], 2.0 * (1.0 - lever));
        close("the other end", found[2 - loaded], 0.0);
    }
    // Just above the pivot it may turn from one end to the other.
    let solution = certified(&of(L, 2.0));
    let Motion { about, slope: [Some(from), Some(to)] } =
        solution.state.standing.and_then(|s| s.motion).expect("it turns")
    else {
        panic!("both ends stop it")
    };
    close("about", about, L);
    // The arms sag by nothing: no load is on them.
    close("from", from, -1.0 / L);
    close("to", to, 1.0 / L);
    close("the pivot", solution.state.supports[1].force, 2.0);
}

/// What nothing holds any more is refused as a free body is.
#[test]
fn what_nothing_holds_is_refused() {
    let told = |supports: Vec<Support>, points: &[[f64; 2]]| match scene(supports, 0.0, points, None).scaled() {
        Err(SceneError::Unheld(why)) => why,
        other => panic!("{other:?}"),
    };
    let ends = || vec![pushing(2.0, 0.0), pushing(10.0, 0.0)];
    assert!(matches!(told(ends(), &[[6.0, -1.0]]), Unheld::PulledUp { force } if (force - 1.0).abs() < DIGITS));
    assert!(matches!(told(ends(), &[[11.0, 1.0]]), Unheld::Overturns { ends: [2.0, 10.0], .. }));
    assert!(matches!(told(ends(), &[[3.0, 1.0], [9.0, -1.0]]), Unheld::Couple { .. }));
    assert!(matches!(told(ends(), &[]), Unheld::NothingPresses));
    assert!(matches!(told(vec![pushing(2.0, 0.0)], &[[3.0, 1.0]]), Unheld::Overturns { .. }));
    // One that holds, and one on the side from which the beam turns away.
    let one = || vec![Support::simple(2.0), pushing(10.0, 0.0)];
    assert!(matches!(told(one(), &[[1.0, 1.0]]), Unheld::Turns { .. }));
    assert!(matches!(scene(one(), 0.0, &[[3.0, 1.0]], None).scaled().map(|s| s.balance), Ok(Balance::Stands(_))));
    insta::assert_snapshot!(told(ends(), &[[11.0, 1.0]]), @"the loads have their resultant 1 at x = 11, outside the supports that push (2 … 10): the beam turns over its support at x = 10");
}

/// In the ground, level with it, or built in.
#[test]
fn a_support_that_cannot_push_is_refused() {
    let beam = |supports: Vec<Support>| Beam::new(2.0 * L, EI).and_then(|beam| beam.with_supports(supports));
    let flat = |depth: f64| Some(Foundation::Flat { depth });
    let above = |depth: f64| Scene::new(beam(vec![pushing(L, 0.5)]).expect("a beam"), Load::default(), flat(depth));
    assert!(matches!(above(0.4), Err(SceneError::BearingInGround { .. })));
    assert!(matches!(above(0.5), Err(SceneError::BearingInGround { .. })));
    assert!(above(0.6).is_ok());
    let both = Support { pushes_only: true, ..Support::built_in(L) };
    assert!(matches!(beam(vec![both]), Err(SceneError::PushesBuiltIn { .. })));
}

/// Ground, supports that only push above it, and the same ground with narrow teeth in their places instead. A beam turns far less than
/// the flanks of the teeth, so that it touches at the tips.
fn with_teeth(i: u64) -> Option<[Scene; 2]> {
    /// Half the width of a tooth.
    const HALF: f64 = 1e-4;
    let mut random = Random::new(0x70_0000 + i);
    let mut points: Vec<[f64; 2]> = (0..=4).map(|k| [3.0 * f64::from(k), random.between(0.3, 1.0)]).collect();
    if random.once_in(2) {
        points.iter_mut().for_each(|point| point[1] = 0.7);
    }
    let ground = Foundation::Polyline { points: points.clone() };
    let places: Vec<f64> = (0..1 + random.below(4)).map(|_| random.between(0.5, 11.5)).collect();
    let near = |x: f64| places.iter().filter(|y| (*y - x).abs() < 0.2).count() > 1;
    if places.iter().any(|&x| near(x) || (x / 3.0 - (x / 3.0).round()).abs() < 0.1) {
        return None;
    }
    let tips: Vec<[f64; 2]> = places.iter().map(|&x| [x, ground.depth(x) - random.between(0.05, 0.6)]).collect();
    let mut toothed = points;
    for &[x, depth] in &tips {
        toothed.extend([[x - HALF, ground.depth(x - HALF)], [x, depth], [x + HALF, ground.depth(x + HALF)]]);
    }
    toothed.sort_by(|a, b| a[0].total_cmp(&b[0]));
    let held: Vec<Support> = [0.0, 2.0 * L].into_iter().filter(|_| random.once_in(2)).map(Support::simple).collect();
    let pushed = tips.iter().map(|&[x, depth]| pushing(x, depth)).chain(held.iter().copied()).collect();
    let points = [[random.between(0.0, 12.0), random.between(0.0, 20.0)], [random.between(0.0, 12.0), 5.0]];
    let uniform = random.between(0.5, 20.0);
    let both = [
        scene(pushed, uniform, &points, Some(ground)),
        scene(held, uniform, &points, Some(Foundation::Polyline { points: toothed })),
    ];
    both.iter().all(|scene| scene.scaled().is_ok()).then_some(both)
}

#[test]
fn a_support_that_only_pushes_is_the_tip_of_a_tooth() {
    const COUNT: usize = 500;
    /// Teeth are polylines: forces beside contacts that are close together have fewer digits.
    const ALIKE: f64 = 1e-8;
    let (mut lifted, mut pressed, mut zones) = (0, 0, 0);
    for [own, toothed] in (0..).filter_map(with_teeth).take(COUNT) {
        let told = format!("{:?}", own.beam().all_supports());
        let state = certified(&own).state;
        let Ok(other) = solve_exactly(&toothed) else { panic!("{told}") };
        let expected: ContactState = other.state;
        let size = expected.contacts.iter().fold(0.0, |most: f64, contact| most.max(contact.force.abs()));
        let tip = |at: f64| expected.contacts.iter().find(|c| (c.from - at).abs() < 1e-9).map_or(0.0, |c| c.force);
        for support in state.supports.iter().filter(|support| support.pushes_only) {
            assert!(
                (support.force - tip(support.at)).abs() <= ALIKE * size,
                "{told}: {support:?}, {:?}",
                expected.contacts
            );
            *(if support.force == 0.0 { &mut lifted } else { &mut pressed }) += 1;
        }
        zones += usize::from(state.contacts.iter().any(|contact| contact.from < contact.to));
        assert!((state.energy - expected.energy).abs() <= ALIKE * expected.energy.abs(), "{told}");
    }
    assert!(50 <= lifted && 300 <= pressed && 100 <= zones, "{lifted} lifted, {pressed} press, {zones} with zones");
}

/// Levels up to 1e11 times the sag: of the deflection no digit of the sag is left, and of a beam on two of its supports the forces are
/// certain all the same, by statics.
#[test]
fn levels_far_beyond_the_sag_leave_forces_certain() {
    let (mut on_two, mut lifted) = (0, 0);
    for i in 0..150 {
        let mut random = Random::new(0x1e_0000 + i);
        let q = random.between(0.1, 10.0);
        let sag = 5.0 * q * (2.0 * L).powi(4) / (384.0 * EI);
        let ends = random.once_in(2);
        let mut supports: Vec<Support> =
            [0.0, 2.0 * L].map(|at| if ends { pushing(at, 0.0) } else { Support::simple(at) }).to_vec();
        for k in 1..2 + random.below(3) {
            let level = sag * random.between(-1.0, 1.0) * libm::pow(10.0, random.between(8.0, 11.0));
            supports.push(pushing([2.0, 5.0, 7.5, 11.0][k], level));
        }
        let scene = scene(supports, q, &[], None);
        let found = forces(&scene);
        let carried: f64 = found.iter().sum();
        let size = found.iter().fold(0.0, |most: f64, force| most.max(force.abs()));
        assert!((carried - 2.0 * L * q).abs() <= 1e-12 * size, "{i}: {found:?}");
        on_two += usize::from(found.iter().filter(|force| **force != 0.0).count() == 2);
        lifted += usize::from(found.contains(&0.0));
    }
    assert!((60..150).contains(&on_two) && 60 <= lifted, "{on_two} on two, {lifted} off one");
}

/// The levels differ by far more than the beam bends, and no list of the chain of links leads to the answer: the supports of a rigid beam
/// do. Forces by statics.
#[test]
fn a_stiff_beam_rests_on_two_of_many_supports() {
    const FREE: [[f64; 2]; 5] = [[1.9, 15e3], [4.0, 41e3], [4.2, 23e3], [4.3, -20e3], [9.7, 32e3]];
    let free = FREE.map(|[at, level]| pushing(at, level)).to_vec();
    let hinged = vec![Support::simple(0.0), pushing(4.64, 231e3), pushing(9.82, 263e3)];
    for (supports, [left, right], bending, q, [at, force]) in
        [(free, [3, 4], 4.8e8, 1.7, [5.5, 2.4]), (hinged, [0, 2], 2.43e8, 0.731, [2.73, 2.99])]
    {
        let [from, to] = [left, right].map(|i: usize| supports[i].at);
        let mut expected = vec![0.0; supports.len()];
        expected[right] = (10.0 * q * (5.0 - from) + force * (at - from)) / (to - from);
        expected[left] = 10.0 * q + force - expected[right];
        let beam = Beam::new(10.0, bending).and_then(|beam| beam.with_supports(supports)).expect("a beam");
        let load = Load::new(&beam, q, Vec::new(), vec![PointLoad { at, force }]).expect("a load");
        let found = forces(&Scene::new(beam, load, None).expect("a scene"));
        assert_eq!(found.len(), expected.len());
        for (found, expected) in found.iter().zip(expected) {
            assert!((found - expected).abs() <= DIGITS * (10.0 * q + force), "{found} instead of {expected}");
        }
    }
}

/// By places and levels of all supports, loads, stiffness and depth.
#[test]
fn derivatives_agree_with_differences() {
    const COUNT: usize = 40;
    let mut trial = Trial::default();
    for (i, [own, _]) in (0..).filter_map(with_teeth).take(COUNT).enumerate() {
        trial.compare(&format!("scene {i}"), &own);
    }
    assert!(trial.wrong.is_empty(), "{:#?}", trial.wrong);
    assert!(COUNT <= trial.scenes && 8 * COUNT <= trial.both, "{trial:?}");
}
