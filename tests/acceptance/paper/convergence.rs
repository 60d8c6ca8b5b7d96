//! Order of convergence: what converges on the example, how fast, and what does not; and how discrete solutions of uneven scenes
//! approach the exact ones, with the order that their kind of contact allows.
//!
//! An exact solution and a discrete one share no line but the scene: a wrong exact solution would stop the errors from falling.

use palkki::adaptive::observed_order;
use palkki::route::{Method, Solver};
use palkki::theory::solve;
use palkki_evidence::paper::claims::accuracy;
use palkki_evidence::paper::convergence::{Quantity, Series, of_scene, of_the_example};

use crate::scenes::{run, scene};

/// Grids of 24 to 400 intervals: many, because errors scatter with the place of the lift-off point between two nodes.
#[track_caller]
fn measured(method: Method, quantity: Quantity) -> Series {
    let grids: Vec<usize> = (3..=50).map(|k| 8 * k).collect();
    let found = of_the_example(method, &grids).expect("grids of multiples of 8");
    found.into_iter().find(|series| series.quantity == quantity).expect("a quantity of the example")
}

/// Reactions and deflections scatter: leaving out every second grid moves the slope by this much.
const SCATTER: f64 = 0.3;

/// The energy hardly does: leaving out every second grid moves the slope by 0.02 at most.
const SMOOTH: f64 = 0.05;

/// The energy methods take their loads to the nodes, an error of second order. Of the energy finite differences are better than their
/// scheme by one order: it is stationary, and for nodal loads on a flat foundation second-order terms cancel.
#[test]
fn what_converges_is_of_second_order() {
    for method in Method::ALL {
        let of_energy = if method == Method::Complementarity { 3.0 } else { 2.0 };
        for (quantity, expected, slack) in [
            (Quantity::EndReaction, 2.0, SCATTER),
            (Quantity::PointForce, 2.0, SCATTER),
            (Quantity::Deflection, 2.0, SCATTER),
            (Quantity::Energy, of_energy, SMOOTH),
        ] {
            let order = measured(method, quantity).order;
            assert!((order - expected).abs() < slack, "{method}, {}: observed order {order:.2}", quantity.name());
        }
    }
}

/// No grid knows where between two nodes the beam lifts off, and none is further from it than that.
#[test]
fn the_lift_off_point_is_found_within_one_interval() {
    let theory = palkki_evidence::paper::theory();
    let lift_off = theory.lift_off.expect("the example lifts off");
    let length = palkki_evidence::paper::beam().expect("the example has a beam").length();
    for method in Method::ALL {
        for (intervals, error) in measured(method, Quantity::LiftOff).errors {
            let spacing = length / f64::from(u32::try_from(intervals).expect("a few hundred"));
            assert!(error * lift_off <= spacing, "{method}, {intervals} intervals: off by {}", error * lift_off);
        }
    }
}

/// What must not be believed: the first contact force does not approach `T`, and nodal forces do not approach `q₀Δ`.
#[test]
fn nodal_contact_forces_do_not_converge() {
    /// What is off by this much on fine grids does not converge.
    const OFF: f64 = 0.1;
    /// `Δ²/l²` on these grids is 6·10⁻⁶ at most, some ten times over.
    const RIGHT: f64 = 1e-4;
    let fine: Vec<_> = (1..=10).map(|k| accuracy::errors(400 + 10 * k).expect("grids of the example")).collect();
    let off = fine.iter().filter(|e| OFF < e.first_force.abs()).count();
    assert!(fine.len() < 2 * off, "on {off} of {} fine grids the first force is off by ten per cent", fine.len());
    assert!(fine.iter().all(|e| OFF < e.pressure), "a nodal force is off by ten per cent on every fine grid");
    // Beside them, on the same grids, the end reaction is right to four digits.
    assert!(fine.iter().all(|e| e.end_reaction.abs() < RIGHT), "{fine:?}");
}

/// Multiples of 24, so that every reading of the survey is a node: five grids an octave, six octaves.
const FIRST: [usize; 5] = [120, 144, 168, 192, 216];
const OCTAVES: u32 = 6;

/// Errors scatter with the places of contacts between two nodes. The worst of an octave scatters less; leaving out the
/// first or the last octave moves its slope by up to this much.
const SCATTER_OF_OCTAVES: f64 = 0.3;

/// A first order ends half way to the second. The reactions of the wave fall with 1.19.
const FIRST_ORDER_AT_MOST: f64 = 1.5;

/// The slope of the worst error in each octave is at least that of `expected`, for end reaction, energy, deflection; and if it is one
/// for the end reaction, no more.
#[track_caller]
fn check_scene(name: &str, expected: [f64; 3]) {
    let scene = scene(name);
    let exact = solve(&scene).expect("the scene is in range");
    assert!(exact.solved, "{name}");
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
            let first = expected < 2.0 && series.quantity == Quantity::EndReaction;
            assert!(
                expected - SCATTER_OF_OCTAVES <= order && (!first || order <= FIRST_ORDER_AT_MOST),
                "{name}, {method}, {}: order {order:.2} instead of {expected}, {worst:?}",
                series.quantity.name()
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
    check_scene("wave", [1.0, 2.0, 1.0]);
}

#[test]
fn the_ends_of_zones_are_of_second_order() {
    check_scene("crest", [2.0, 2.0, 2.0]);
    check_scene("hollows", [2.0, 2.0, 2.0]);
}

#[test]
fn kinks_at_nodes_are_of_second_order() {
    check_scene("survey", [2.0, 2.0, 2.0]);
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
        assert!(error <= allowed, "{}: {error:e}", series.quantity.name());
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
