//! Random beams on random supports, beside the definition of the problem and beside beams that are the same but for how they are
//! described.

use palkki::scene::{Beam, Foundation, Load, PointLoad, Scene, Support};
use palkki::theory::{Exact, TheoryError, solve};
use palkki_evidence::definition::violated;
use palkki_evidence::random::{Random, held};

use super::OFF;

#[test]
fn random_beams_meet_the_definition() {
    let (mut certified, mut refused) = (0, 0);
    let mut open = Vec::new();
    for i in 0..2000 {
        let scene = held(i);
        match solve(&scene) {
            Ok(exact) if exact.solved => {
                certified += 1;
                let wrong = violated(&scene, &exact, OFF);
                assert!(wrong.is_empty(), "{i}: {wrong:#?}\n{scene:#?}\n{:#?}", exact.state);
            }
            Ok(exact) => open.push((i, exact.violations)),
            Err(TheoryError::Scene(_)) => refused += 1,
            Err(error) => panic!("{i}: {error}"),
        }
    }
    assert!(refused < 200, "{refused} are not held");
    assert!(2000 <= certified + refused + 10, "{certified} certified, open: {open:#?}");
}

fn forces(exact: &Exact) -> Vec<f64> {
    let contacts = exact.state.contacts.iter().flat_map(|c| [c.from, c.to, c.force]);
    contacts.chain(exact.state.supports.iter().map(|s| s.force)).collect()
}

#[track_caller]
fn same(what: &str, found: &[f64], expected: &[f64], scale: f64) {
    let close = found.len() == expected.len()
        && found.iter().zip(expected).all(|(a, b)| (a - b).abs() <= 1e-9 * scale.max(b.abs()));
    assert!(close, "{what}: {found:?} instead of {expected:?}");
}

fn certified(scene: &Scene) -> Option<Exact> {
    solve(scene).ok().filter(|exact| exact.solved)
}

/// Ground + a + bx has the same forces under a free body, and its mirror image the mirrored ones.
#[test]
fn a_free_body_feels_no_plane() {
    let mut random = Random::new(11);
    let mut compared = 0;
    for _ in 0..60 {
        let length = random.between(2.0, 12.0);
        let beam =
            Beam::new(length, random.between(1.0, 100.0)).and_then(|b| b.with_supports(Vec::new())).expect("a beam");
        let load =
            Load::new(&beam, random.between(0.5, 2.0), Vec::new(), vec![PointLoad { at: 0.6 * length, force: 1.0 }]);
        let load = load.expect("a load");
        let c = [random.between(-0.1, 0.1), random.between(-0.1, 0.1), random.between(-0.02, 0.02)];
        let ground = |a: f64, b: f64| Foundation::Polynomial {
            coefficients: vec![a, b, c[0], c[1] / length, c[2] / (length * length)],
        };
        let plain = Scene::new(beam.clone(), load.clone(), Some(ground(0.0, 0.0))).expect("a scene");
        let tilted = Scene::new(beam.clone(), load.clone(), Some(ground(3.0, 0.2))).expect("a scene");
        let (Some(plain), Some(tilted)) = (certified(&plain), certified(&tilted)) else { continue };
        same("tilted", &forces(&tilted), &forces(&plain), length);
        compared += 1;
    }
    assert!(55 <= compared, "{compared}");
}

/// A hump under a straight beam is straight ground under a curled one.
#[test]
fn only_the_gap_counts() {
    let coefficients = [0.4, -0.3, 0.02, 0.003];
    let polynomial = |sign: f64, from: f64| {
        let signed: Vec<f64> = coefficients.iter().map(|c| sign * c).collect();
        Foundation::Polynomial { coefficients: [vec![from + signed[0]], signed[1..].to_vec()].concat() }
    };
    for supports in [vec![], vec![Support::built_in(0.0)], vec![Support::simple(2.0)]] {
        let straight = Beam::new(9.0, 5.0).and_then(|b| b.with_supports(supports.clone())).expect("a beam");
        // The supports of the curled beam hold what those of the straight one do.
        let own = |x: f64| polynomial(-1.0, 0.0).sides(x)[1];
        let lowered = supports.iter().map(|s| {
            let [level, slope] = own(s.at);
            Support { at: s.at, level: s.level + level, slope: s.slope.map(|held| held + slope) }
        });
        let curled = Beam::new(9.0, 5.0).and_then(|b| b.with_supports(lowered.collect()));
        let curled = curled.and_then(|b| b.with_shape(polynomial(-1.0, 0.0))).expect("a beam");
        let load = Load::uniform_on(&straight, 1.1).expect("a load");
        let hump = Scene::new(straight, load.clone(), Some(polynomial(1.0, 2.0))).expect("a scene");
        let flat = Scene::new(curled, load, Some(Foundation::Flat { depth: 2.0 })).expect("a scene");
        let (hump, flat) = (certified(&hump).expect("certified"), certified(&flat).expect("certified"));
        same("curled", &forces(&flat), &forces(&hump), 9.0);
        same("energy", &[flat.state.energy], &[hump.state.energy], 9.0);
    }
}

/// A support that presses may be replaced by a spike of the ground.
#[test]
fn a_pressing_support_is_a_spike() {
    let load = |beam: &Beam| Load::uniform_on(beam, 1.0).expect("a load");
    let ends = [Support::simple(0.0), Support::simple(10.0)];
    let beam = |supports: Vec<Support>| Beam::new(10.0, 3.0).and_then(|b| b.with_supports(supports)).expect("a beam");
    let held = beam(vec![ends[0], Support::simple(4.0).at_level(0.5), ends[1]]);
    let spike = vec![[0.0, 90.0], [4.0, 90.0], [4.0, 0.5], [4.0, 90.0], [10.0, 90.0]];
    let plain = beam(ends.to_vec());
    for points in [vec![[0.0, 90.0], [3.99, 90.0], [4.0, 0.5], [4.01, 90.0], [10.0, 90.0]], spike] {
        let Ok(scene) = Scene::new(plain.clone(), load(&plain), Some(Foundation::Polyline { points })) else {
            continue;
        };
        let pressed = certified(&scene).expect("certified");
        let supported = certified(&Scene::new(held.clone(), load(&held), None).expect("a scene")).expect("certified");
        same("force", &[pressed.state.contacts[0].force], &[supported.state.supports[1].force], 10.0);
        same("energy", &[pressed.state.energy], &[supported.state.energy], 10.0);
    }
}
