//! Surveys of many points, as a laser gives them: certified at a hundred thousand points, and in agreement with a fine grid where a
//! grid can be fine enough.

use palkki::route::{Method, Solver};
use palkki::theory::{self, Exact};
use palkki_evidence::extremes::{Ground, survey};

use crate::scenes::run;

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
