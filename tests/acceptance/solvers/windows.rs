//! The force method, and dense contact by every method, on fine grids: what it costs where contact is hard to find, and which digits are left.

use palkki::route::{Method, Solver};
use palkki::scene::Foundation;

use super::ends;
use crate::scenes::{run, scene, uniform};
use palkki_evidence::random;

/// Scenes of the random series on which exchanges of all wrong variables took thousands of solves of the whole beam: kinks
/// between the nodes, point contacts that move, two neighbouring contacts that disturb each other.
#[test]
fn kinks_between_the_nodes_are_settled_in_windows() {
    for i in [96, 130, 260, 575, 1104, 1402, 1797] {
        ends(&random::scene(i), Method::Force, 16_000, 1500);
    }
}

#[test]
fn random_scenes_on_fine_grids_are_certified() {
    for i in (0..2000).step_by(40) {
        ends(&random::scene(i), Method::Force, 16_000, 1500);
        ends(&random::rough(i), Method::Force, 1000, 500);
    }
}

/// A kink, a hump and a survey on a million nodes would take too long here unoptimised; a tenth of that shows the same.
#[test]
fn scenes_of_the_report_on_a_hundred_thousand_intervals() {
    for (name, solves) in [("step", 800), ("survey", 300), ("hump", 100)] {
        ends(&scene(name), Method::Force, 100_000, solves);
    }
}

/// A step between two nodes: the point that carries there moves to another node with the grid, and until it is found whatever
/// lies beside it is wrong by half the beam. No window may grow that far before the others have had their turn.
#[test]
fn a_step_between_the_nodes_does_not_lead_a_window_astray() {
    ends(&scene("step"), Method::Force, 200_004, 800);
    let raw = run(&scene("step"), Method::Displacement, Solver::ActiveSet, 200_004);
    assert!(raw.solved);
    assert!(raw.run.work <= 10 * raw.unknowns, "{} for {} unknowns", raw.run.work, raw.unknowns);
}

/// Thousands of points of a survey carry: windows around all of them are more than the beam. Exchanges of the whole settle most,
/// windows the rest.
#[test]
fn dense_contact_costs_some_dozen_solves_of_the_whole() {
    /// Measured: 3 to 30.
    const WORTH: usize = 50;
    for (intervals, segments, load) in
        [(100_000, 1000, 1e2), (100_000, 1000, 1e4), (100_000, 30_000, 1e4), (199_999, 1000, 1e4)]
    {
        let scene = random::smooth(segments, load, 1);
        for method in Method::ALL {
            let raw = run(&scene, method, Solver::ActiveSet, intervals);
            let told = format!("{method}, {intervals}, {segments}: {} for {}", raw.run.work, raw.unknowns);
            assert!(raw.solved, "{told}");
            assert!(raw.run.work <= WORTH * raw.unknowns, "{told}");
        }
    }
}

/// All nodes lie on the ground, and nothing is left for the supports but the load of half an interval.
#[test]
fn ground_at_the_level_of_the_supports_leaves_them_half_an_interval() {
    for intervals in [30, 1000, 100_000] {
        let raw =
            ends(&uniform(10.0, 500.0 / 384.0, 1.0, Foundation::Flat { depth: 0.0 }), Method::Force, intervals, 200);
        let half = 0.5 * 10.0 / f64::from(u32::try_from(intervals).expect("small"));
        for reaction in [raw.state.reactions.left, raw.state.reactions.right] {
            // A product and a quotient.
            assert!((reaction - half).abs() <= 4.0 * f64::EPSILON * half, "{reaction} instead of {half}");
        }
    }
}

/// A plane that starts at the support: by the measure of the whole beam, the first thousandth of it seemed free.
#[test]
fn an_incline_carries_the_beam_from_its_support_on() {
    /// Some ten nodes beside the support may be taken for free: their clearance is `(10Δ)⁴ q/384 EI`.
    const NODES: f64 = 10.0;
    for intervals in [1000, 100_000] {
        let raw = ends(&scene("incline"), Method::Force, intervals, 300);
        let interval = 10.0 / f64::from(u32::try_from(intervals).expect("small"));
        let left = raw.state.reactions.left;
        assert!(0.0 < left && left < 0.5 * NODES * interval, "{left}");
    }
}

/// Of a step the depths at the nodes themselves count: a place a hair beside it has another depth.
#[test]
fn a_step_at_a_node_is_no_hair_beside_it() {
    let points = vec![[0.0, 0.0], [1.0, -0.04], [1.0, 0.0], [3.0, -0.04], [7.0, 0.08], [8.0, 0.08]];
    let step = uniform(8.0, 500.0 / 384.0, 1.0, Foundation::Polyline { points });
    for intervals in [50, 1000, 16_000] {
        ends(&step, Method::Force, intervals, 1500);
    }
    for i in [93, 260, 316, 424, 1902] {
        ends(&random::on_lattice(i), Method::Force, 1000, 500);
    }
}

/// A load that was added to a shear force before the jump of that was taken was rounded in the same way at each node.
#[test]
fn long_contact_with_a_wave_loses_no_digits() {
    /// Less than a tenth of what it was: sums of 10⁵ forces, each rounded to 10⁻¹⁶ of the largest.
    const RESIDUAL: f64 = 2e-13;
    let raw = ends(&random::scene(760), Method::Force, 100_000, 1000);
    assert!(raw.residual <= RESIDUAL, "{:.1e}", raw.residual);
}
