//! Discrete solutions of uneven scenes approach the exact ones, with the order that their kind of contact allows.
//!
//! The two share no line but the scene: a wrong exact solution would stop the errors from falling.

use palkki::dial::observed_order;
use palkki::route::{Method, Solver, Status};
use palkki::theory::solve;
use palkki_evidence::paper::convergence::{Quantity, of_scene};

use crate::scenes::{run, scene};

/// Multiples of 24, so that every reading of the survey is a node: five grids an octave, six octaves.
const FIRST: [usize; 5] = [120, 144, 168, 192, 216];
const OCTAVES: u32 = 6;

/// Errors scatter with the places of contacts between two nodes. The worst of an octave scatters less; leaving out the
/// first or the last octave moves its slope by up to this much.
const SCATTER: f64 = 0.3;

/// The slope of the worst error in each octave is at least that of `expected`, for end reaction, energy, deflection.
#[track_caller]
fn check(name: &str, expected: [f64; 3]) {
    let scene = scene(name);
    let exact = solve(&scene).expect("the scene is in range");
    assert_eq!(exact.status, Status::Certified, "{name}");
    let grids: Vec<usize> = (0..OCTAVES).flat_map(|k| FIRST.map(|n| n << k)).collect();
    for method in [Method::Force, Method::Complementarity] {
        let found = of_scene(&scene, &exact, method, &grids).expect("the scene is in range");
        for (series, expected) in found.iter().zip(expected) {
            let worst: Vec<(f64, f64)> = series
                .errors
                .chunks(FIRST.len())
                .map(|octave| (1.0 / places(octave[0].0), octave.iter().fold(0.0, |most, e| e.1.max(most))))
                .collect();
            let order = observed_order(&worst);
            assert!(
                expected - SCATTER <= order,
                "{name}, {method}, {}: order {order:.2} instead of {expected}, {worst:?}",
                series.quantity.word()
            );
        }
    }
}

fn places(intervals: usize) -> f64 {
    f64::from(u32::try_from(intervals).expect("a few thousand"))
}

/// A point on a crest that is smooth lies between two nodes: first order, but for the energy, which is stationary.
#[test]
fn points_on_smooth_crests_are_of_first_order() {
    check("wave", [1.0, 2.0, 1.0]);
}

#[test]
fn the_ends_of_zones_are_of_second_order() {
    check("crest", [2.0, 2.0, 2.0]);
    check("hollows", [2.0, 2.0, 2.0]);
}

#[test]
fn kinks_at_nodes_are_of_second_order() {
    check("survey", [2.0, 2.0, 2.0]);
}

/// On a fine grid what is left is the first order of a crest between two nodes.
#[test]
fn a_hundred_thousand_intervals_come_close() {
    const INTERVALS: usize = 100_000;
    let scene = scene("wave");
    let exact = solve(&scene).expect("the scene is in range");
    let found = of_scene(&scene, &exact, Method::Force, &[INTERVALS]).expect("the scene is in range");
    for series in found {
        // A crest that is missed by half an interval is missed by 5·10⁻⁶ of the beam; reactions answer some ten times as
        // strongly, since their arms are parts of the beam. The energy has the square of it.
        let allowed = if series.quantity == Quantity::Energy { 1e-8 } else { 5e-5 };
        let error = series.errors[0].1;
        assert!(error <= allowed, "{}: {error:e}", series.quantity.word());
    }
}

/// Where the foundation starts at the level of a support and holds the slope of the beam, a grid has a couple for it: the
/// support pulls down, the first node pushes up, and both grow like `1/Δ`. Their moment is what the exact solution names.
#[test]
fn a_couple_at_a_support_is_the_limit_of_growing_forces() {
    /// Two forces `Δ` apart are no couple yet, an error of first order; halved with each halving of the grid.
    const FIRST_ORDER: f64 = 0.02;
    let scene = scene("sill");
    let exact = solve(&scene).expect("the scene is in range");
    let [left, right] = exact.support_couples;
    assert!(left < 0.0 && right < 0.0, "{left} and {right}");
    for intervals in [1024, 4096] {
        let spacing = scene.beam().length() / places(intervals);
        let reactions = run(&scene, Method::Complementarity, Solver::ActiveSet, intervals).state.reactions;
        for (couple, reaction) in [(left, reactions.left), (right, reactions.right)] {
            let error = (reaction * spacing - couple).abs() / couple.abs();
            assert!(
                error <= FIRST_ORDER * 1024.0 / places(intervals),
                "{intervals} intervals: {reaction}, off by {error:.4}"
            );
        }
    }
}
