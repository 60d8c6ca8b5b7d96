//! Surveys of many points, as a laser gives them: certified at a hundred thousand points, and in agreement with a fine grid where a
//! grid can be fine enough.

use palkki::route::{Method, Solver, Status};
use palkki::scene::Foundation;
use palkki::solve_exactly;
use palkki::theory::{self, Exact};
use palkki_evidence::extremes::{Ground, survey, survey_from};

use palkki_evidence::random::{Random, sample_of};

use crate::scenes::{run, uniform};

/// Under the light load the beam rests on a few points; smooth ground under the heavy one carries it nearly everywhere.
const LOADS: [f64; 2] = [1.0, 1e4];

#[track_caller]
fn certified(ground: Ground, segments: u32, load: f64) -> Exact {
    let exact = theory::solve(&survey(ground, segments, load).expect("a scene")).expect("an answer");
    let told = format!("{}, {segments}, {load}: {:e}, {:?}", ground.name(), exact.residual, exact.violations);
    assert!(exact.solved, "{told}");
    exact
}

#[test]
fn rough_surveys_of_a_hundred_thousand_points_are_certified() {
    for ground in [Ground::Walk, Ground::Noise] {
        for load in LOADS {
            let exact = certified(ground, 100_000, load);
            assert!(exact.unknowns < 1000, "{}: few of its points carry, but {}", ground.name(), exact.unknowns);
        }
    }
}

/// Surveys in which a contact beside another one was missing that costs nothing but the proof: two segments that the beam touches beside
/// the hollow between them, two points of which one is nearly clear.
const TWO_BESIDE_EACH_OTHER: [u64; 3] = [36, 51, 68];

/// Waves that a light load presses the beam onto at a few crests, of which two neighbouring points are the top: where the beam sags
/// between these, it touches the segment between them and none of the two.
#[test]
fn surveys_of_smooth_waves_are_certified_under_a_light_load() {
    const SEGMENTS: u32 = 100_000;
    for seed in (15..25).chain(TWO_BESIDE_EACH_OTHER) {
        let mut random = Random::new(seed);
        let waves: Vec<[f64; 3]> = (1..40)
            .map(|k: u32| {
                let k = f64::from(k);
                let height = 0.15 / (k * k.sqrt()) * random.between(-1.0, 1.0);
                [height, k * std::f64::consts::PI, random.between(0.0, std::f64::consts::TAU)]
            })
            .collect();
        let depth = |s: f64| 1.5 + waves.iter().map(|[a, rate, phase]| a * libm::sin(rate * s + phase)).sum::<f64>();
        let shares = (0..=SEGMENTS).map(|i| f64::from(i) / f64::from(SEGMENTS));
        let points = shares.map(|s| [10.0 * s, depth(s)]).collect();
        let scene = uniform(10.0, 1.3, 1.0, Foundation::Polyline { points });
        let solution = solve_exactly(&scene).expect("an answer");
        assert_eq!(solution.verdict.status, Status::Certified, "{seed}: {}", solution.verdict);
    }
}

/// The grid has a hundred intervals in each segment of the survey, and its load acts at the nodes: in the energy an error of second
/// order, 6e-5 of it with one interval in each segment, and 6e-9 with a hundred.
const OFF: f64 = 1e-8;

#[test]
fn surveys_of_a_thousand_points_agree_with_a_fine_grid_in_energy() {
    for ground in Ground::ALL {
        for load in LOADS {
            let exact = certified(ground, 1000, load);
            let scene = survey(ground, 1000, load).expect("a scene");
            let raw = run(&scene, Method::Force, Solver::ActiveSet, 100_000);
            assert!(raw.solved, "{}, {load}", ground.name());
            let off = ((raw.state.energy - exact.state.energy) / exact.state.energy).abs();
            assert!(off <= OFF, "{}, {load}: energies differ by {off:e}", ground.name());
        }
    }
}

/// A bound on the deflection may be this share of the largest at most: a tenth of the millionth that is asked for.
const SHARE: f64 = 1e-7;

/// Where the beam lies on most of the points of a survey, each of them that is missing, or rounded, is one that its deflection has to
/// be lifted over.
#[test]
fn smooth_surveys_are_certified_with_a_margin_of_ten() {
    for (segments, seeds) in [(1000, 4), (3000, 4), (20_000, 2), (sample_of(100_000), 1)] {
        for load in LOADS {
            for seed in 0..seeds {
                let scene = survey_from(Ground::Smooth, seed, segments, load).expect("a scene");
                let answer = solve_exactly(&scene).expect("an answer");
                let told = format!("{segments} points, load {load}, seed {seed}");
                let exact = answer.exact.as_ref().expect("the exact solution");
                assert!(exact.solved, "{told}: {:?}", exact.violations);
                let share = answer.verdict.error;
                assert!(share <= SHARE, "{told}: certain to {share:e}");
            }
        }
    }
}

/// However many points the ground has: between two contacts the beam is one polynomial, and its energy is a sum over contacts.
#[test]
fn the_energy_above_a_million_points_is_within_its_bounds() {
    for ground in [Ground::Walk, Ground::Noise] {
        let scene = survey_from(ground, 0x1a63, 1_000_000, 1.0).expect("a scene");
        let answer = solve_exactly(&scene).expect("an answer");
        let energy = answer.state.energy;
        let bounds = answer.verdict.certificate.expect("bounds");
        let told = format!("{}: {energy:?} beside {:?}", ground.name(), [bounds.energy_lower, bounds.energy_upper]);
        assert!(bounds.energy_lower <= energy && energy <= bounds.energy_upper, "{told}");
    }
}

/// On a long profile a list is guessed before the beam without contact is looked at; where it touches nothing, that is the guess.
#[test]
fn above_many_points_the_first_list_is_the_answer() {
    for ground in [Ground::Walk, Ground::Noise] {
        for load in LOADS {
            assert_eq!(certified(ground, 10_000, load).lists, 1, "{}, load {load}", ground.name());
        }
        let exact = certified(ground, 10_000, 1e-4);
        assert!(exact.lists == 1 && exact.state.contacts.is_empty(), "{}: {:?}", ground.name(), exact.state.contacts);
    }
}
