//! Supports that give, and elastic stops, beside an elastic foundation.

use palkki::scene::{Foundation, Support};
use palkki::solve_exactly;
use palkki::state::ContactState;
use palkki::verdict::Status;
use palkki_evidence::random::{Random, sample_of};

use super::ground::{Given, random, wrong};

/// What is asked for beside numbers of 16 digits.
const DIGITS: f64 = 1e-11;

/// A beam of length 12 on some supports above flat ground of stiffness 5 at 0.2.
fn above(supports: Vec<Support>) -> Given {
    let ground = Foundation::Flat { depth: 0.2 };
    Given { supports, ground, ..Given::lying(12.0, &[[0.0, 30.0]], &[[0.0, 5.0]], 1.0) }
}

fn spring(at: f64, stiffness: f64) -> Support {
    Support::spring(at, stiffness)
}

/// Numbers of 16 digits from another engine: a spring, a spring against turning, steps of beam and ground, a couple.
#[test]
fn soft_ground_springs_and_steps() {
    let ground = Foundation::Flat { depth: 0.2 };
    let steps = Given::lying(12.0, &[[0.0, 30.0], [6.0, 60.0]], &[[0.0, 5.0], [6.0, 15.0]], 1.0);
    let supports = vec![spring(0.0, 10.0), Support::simple(12.0).turning(20.0, 0.0)];
    let state = Given { supports, ground, couples: vec![[3.0, 4.0]], ..steps }.solved().state;
    for (what, found, expected) in [
        ("left", state.supports[0].force, 0.990_023_700_870_439_2),
        ("right", state.supports[1].force, 2.326_779_962_044_297_7),
        ("from", state.contacts[0].from, 0.992_005_991_981_844_4),
        ("to", state.contacts[0].to, 9.496_696_929_376_245),
        ("contact", state.contacts[0].force, 8.683_196_337_085_263),
        ("deflection", state.deflection.max, 0.430_409_789_993_446_4),
        ("greatest moment", state.moment.max, 3.069_341_515_291_321_3),
        ("least moment", state.moment.min, -1.545_323_922_526_858),
        ("energy", state.energy, -2.676_594_759_916_944_6),
    ] {
        assert!((found - expected).abs() <= DIGITS * expected.abs(), "{what}: {found} for {expected}");
    }
}

/// A spring of 1e12 is a support, one of 1e12 against turning is built in, and with stiffness `J` grows.
#[test]
fn stiff_springs_are_supports() {
    const NEAR: f64 = 1e-9;
    let near = |found: &ContactState, expected: &ContactState| {
        let size = expected.deflection.magnitude();
        assert!((found.deflection.magnitude() - size).abs() <= NEAR * size, "{found:?}");
        assert!((found.energy - expected.energy).abs() <= NEAR * expected.energy.abs(), "{found:?}");
    };
    let simple = Support::simple;
    for x in [0.0, 3.0, 12.0] {
        let other = simple(if x < 6.0 { 12.0 } else { 0.0 });
        near(&above(vec![spring(x, 1e12), other]).solved().state, &above(vec![simple(x), other]).solved().state);
        let built_in = Support { slope: Some(0.0), ..simple(x) };
        let turning = simple(x).turning(1e12, 0.0);
        near(&above(vec![turning, other]).solved().state, &above(vec![built_in, other]).solved().state);
        let energies = [1e-3, 0.1, 1.0, 10.0, 1e3, 1e6].map(|k| {
            let both = spring(x, k).turning(k, 0.0);
            above(vec![both, other]).solved().state.energy
        });
        assert!(energies.is_sorted_by(|a, b| a < b), "{energies:?}");
    }
}

/// A stop that the beam does not reach changes nothing, and one that it presses is a spring.
#[test]
fn stops_push_only() {
    let ends = || vec![Support::simple(0.0), Support::simple(12.0)];
    let stop = |level: f64| Support { pushes_only: true, ..spring(5.0, 10.0).at_level(level) };
    let with = |support: Support| above([ends(), vec![support]].concat()).solved().state;
    let [idle, alone] = [with(stop(3.0)), above(ends()).solved().state];
    assert!((idle.energy - alone.energy).abs() <= DIGITS * alone.energy.abs());
    assert!(idle.supports[1].force == 0.0 && idle.supports[1].pushes_only);
    let [pressed, held] = [with(stop(0.1)), with(spring(5.0, 10.0).at_level(0.1))];
    assert!((pressed.energy - held.energy).abs() <= DIGITS * held.energy.abs());
    assert!((pressed.supports[1].force - held.supports[1].force).abs() <= DIGITS * held.supports[1].force);
}

/// The beams of `ground` with one to three supports that give.
fn sprung(seed: u64) -> Option<Given> {
    let (mut given, mut random) = (random(seed)?, Random::new(0x61_0000 + seed));
    for _ in 0..1 + random.below(3) {
        let at = given.length * random.between(0.05, 0.95);
        let stiffness = |random: &mut Random| libm::pow(10.0, random.between(-1.0, 3.0));
        let support = spring(at, stiffness(&mut random)).at_level(random.between(-0.1, 0.3));
        given.supports.push(match random.below(3) {
            0 => support,
            1 => Support { pushes_only: true, ..support },
            _ => support.turning(stiffness(&mut random), 0.0),
        });
    }
    given.scene().is_ok_and(|scene| scene.scaled().is_ok()).then_some(given)
}

/// Certified but for one in two hundred, and right beside finite elements, mirror images and other units.
#[test]
fn random_beams_on_springs_and_on_ground_are_certified() {
    let drawn: Vec<(u64, Given)> = (0..sample_of(420)).filter_map(|seed| Some((seed, sprung(seed)?))).collect();
    let (mut lost, mut errors) = (Vec::new(), Vec::new());
    for (seed, given) in &drawn {
        let solution = solve_exactly(&given.scene().expect("a scene")).expect("an answer");
        if solution.verdict.status != Status::Certified {
            lost.push(format!("{seed}: {}", solution.verdict));
        } else {
            errors.extend(wrong(given, &solution).into_iter().map(|why| format!("{seed}: {why}\n{given:?}")));
        }
    }
    assert!(errors.is_empty(), "{errors:#?}");
    assert!(200 * lost.len() <= drawn.len(), "{} of {}: {lost:#?}", lost.len(), drawn.len());
}

/// A stiffness in steps is several numbers: each of those of the beam and of the foundation has its derivative.
#[test]
fn each_step_of_a_stiffness_has_its_derivative() {
    let given = Given::lying(12.0, &[[0.0, 4.0], [5.0, 9.0]], &[[0.0, 90.0], [4.0, 50.0]], 2.0);
    let exact = given.solved().exact.expect("functions");
    let by: Vec<String> =
        exact.derivatives(&given.scene().expect("a scene")).iter().map(|d| d.by.to_string()).collect();
    let steps = [0, 1].map(|i| palkki::scene::Quantity::StepStiffness(i).to_string());
    let soil = [0, 1].map(|i| palkki::scene::Quantity::GroundStepStiffness(i).to_string());
    assert_eq!(by, ["depth", "load.uniform", &steps[0], &steps[1], &soil[0], &soil[1]]);
}
