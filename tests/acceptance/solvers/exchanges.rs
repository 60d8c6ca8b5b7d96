//! What each algorithm does where full exchanges without a fallback go round in circles, and where contact is hard to find.

use palkki::methods::Discrete;
use palkki::route::{Method, Solver};
use palkki::scene::Foundation;
use palkki_evidence::paper::scene_over;

use super::ends;
use crate::scenes::run;
use palkki_evidence::exchanges::{self, End, Instance, full_exchange};

fn corpus() -> Vec<Instance> {
    exchanges::corpus().expect("every line is an instance")
}

#[test]
fn full_exchanges_without_a_fallback_go_round_in_circles() {
    for instance in corpus() {
        let scaled = instance.scene.scaled().expect("in range");
        let discrete = Discrete::new(&scaled.scene, instance.intervals).expect("enough intervals");
        let qp = instance.method.qp(&discrete);
        let end = full_exchange(qp.as_ref()).expect("definite");
        assert!(matches!(end, End::Circle { period, .. } if period == instance.period), "{}: {end:?}", instance.line);
    }
}

#[test]
fn the_four_steps_end_there_at_the_optimum_or_not() {
    for instance in corpus() {
        let raw = run(&instance.scene, instance.method, Solver::FourStep, instance.intervals);
        assert_eq!(raw.ended(), instance.four_step, "{}", instance.line);
    }
}

#[test]
fn the_active_set_ends_there_at_the_optimum() {
    for instance in corpus() {
        ends(&instance.scene, instance.method, instance.intervals, 100);
    }
}

/// Where ground is touched at hundreds of points, exchanges of one variable of each run go round in a few circles at a time, the
/// common period of which is long, or find the optimum late.
#[test]
fn exchanges_go_round_in_circles_or_wander_in_dense_contact() {
    for instance in exchanges::dense().expect("every line is an instance") {
        let scaled = instance.scene.scaled().expect("in range");
        let discrete = Discrete::new(&scaled.scene, instance.intervals).expect("enough intervals");
        let qp = Method::Force.qp(&discrete);
        let end = exchanges::exchange_of_runs(qp.as_ref()).expect("definite");
        assert_eq!(end, instance.end, "{}", instance.line);
    }
}

/// By every method, for the price of some dozen solves of the whole on whatever grid.
#[test]
fn the_active_set_ends_in_dense_contact() {
    /// Solves of the whole, those on coarser grids and in windows counted by their variables; half as many are needed.
    const WORTH: usize = 100;
    for instance in exchanges::dense().expect("every line is an instance") {
        for method in Method::ALL {
            let raw = ends(&instance.scene, method, instance.intervals, 500);
            assert!(raw.run.work <= WORTH * raw.unknowns, "{method}, {}: {}", instance.line, raw.run.work);
        }
    }
}

/// A hump of three straight lines: thousands of exchanges, since its flanks are lost and won again.
#[test]
fn the_triangular_hump_on_ten_thousand_intervals() {
    for (rise, half) in [(0.5, 1.0), (0.1, 2.0), (0.9, 0.1), (0.5, 4.9)] {
        let points = vec![[0.0, 1.0], [5.0 - half, 1.0], [5.0, 1.0 - rise], [5.0 + half, 1.0], [10.0, 1.0]];
        let scene = scene_over(Foundation::Polyline { points }).expect("a hump");
        ends(&scene, Method::Force, 10_000, 60_000);
    }
}

/// Flat foundations at the two borders between the regimes, on them and a hair beside them.
#[test]
fn borders_between_regimes() {
    let border = 1e4 / 500.0;
    for share in [1.0, 1.0 - 1e-12, 1.0 + 1e-9, 5.0, 5.0 - 1e-12, 5.0 - 1e-6, 5.0 + 1e-12] {
        let scene = scene_over(Foundation::Flat { depth: share * border }).expect("flat");
        for intervals in [10, 30, 99, 1000] {
            for method in Method::ALL {
                ends(&scene, method, intervals, 500);
            }
        }
    }
}
