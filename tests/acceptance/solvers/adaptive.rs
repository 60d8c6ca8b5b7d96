//! Adaptive grids: what is demanded is reached, truly and without waste, or it is said that it is not.

use palkki::adaptive::{Adapted, End, Request, adapt};
use palkki::route::{Method, Solver, Status};
use palkki::scene::Scene;
use palkki::theory;
use palkki_evidence::compare::largest;

use crate::scenes;

/// The largest difference of the nodes from beam theory, over the largest deflection.
fn true_error(scene: &Scene, adapted: &Adapted) -> f64 {
    let exact = theory::solve(scene).expect("the scenes of the report have exact solutions");
    let nodes = adapted.solution.state.nodes.as_ref().expect("a discretised state has nodes");
    let apart = nodes.x.iter().zip(&nodes.deflection).map(|(&x, v)| v - exact.deflection(x));
    largest(apart) / adapted.solution.state.deflection.magnitude()
}

/// Solves a scene of the report to an error that has to be reached.
#[track_caller]
fn reached(name: &str, request: &Request) -> Adapted {
    let scene = scenes::scene(name);
    let adapted = adapt(&scene, request).expect("the scene can be scaled");
    let told = || format!("{name}, {request:?}: {:?}", adapted.trials);
    assert_eq!((adapted.end, adapted.solution.verdict.status), (End::Reached, Status::Certified), "{}", told());
    assert!(adapted.solution.verdict.error <= request.error, "{}", told());
    assert!(true_error(&scene, &adapted) <= adapted.solution.verdict.error, "{}", told());
    adapted
}

#[test]
fn what_is_demanded_is_reached_by_the_active_set() {
    // The report has the other scenes, and smaller errors.
    for name in ["heinisuo-1984", "ridge", "step", "wave", "survey", "kink", "free"] {
        for method in Method::ALL {
            for error in [1e-1, 1e-3, 1e-5] {
                reached(name, &Request::new(method, Solver::ActiveSet, error));
            }
        }
    }
}

#[test]
fn what_is_demanded_is_reached_by_the_other_solvers() {
    for solver in [Solver::Clarabel, Solver::Osqp, Solver::Nsor] {
        for name in ["heinisuo-1984", "ridge"] {
            reached(name, &Request::new(Method::Displacement, solver, 1e-2));
        }
    }
}

/// The first tolerance follows from the demand where a solver stops at one.
#[test]
fn solvers_that_iterate_are_asked_for_what_is_demanded() {
    let first = |solver, error| {
        let scene = scenes::scene("heinisuo-1984");
        adapt(&scene, &Request::new(Method::Displacement, solver, error)).expect("in range").trials[0].tolerance
    };
    for solver in Solver::ALL {
        let iterates = matches!(solver, Solver::Clarabel | Solver::Osqp | Solver::Nsor);
        let [loose, tight] = [1e-1, 1e-2].map(|error| first(solver, error));
        assert_eq!(tight < loose, iterates, "{solver}: {loose:e} and {tight:e}");
    }
}

/// An iterative solver is asked for no more than is of use.
#[test]
fn a_loose_demand_is_cheaper() {
    let work = |error| {
        let adapted = reached("heinisuo-1984", &Request::new(Method::Displacement, Solver::Osqp, error));
        adapted.trials.iter().map(|t| t.iterations).max().unwrap_or(0)
    };
    assert!(work(1e-1) < work(1e-3), "osqp iterates longer for more digits");
}

/// On half as many intervals the error would be too large, and all grids before the last one together cost no more than it.
#[test]
fn no_more_than_necessary() {
    for error in [1e-2, 1e-4, 1e-6] {
        let request = Request::new(Method::Force, Solver::ActiveSet, error);
        let adapted = reached("heinisuo-1984", &request);
        let intervals = adapted.settings.intervals;
        let all: usize = adapted.trials.iter().map(|t| t.intervals).sum();
        assert!(all <= 2 * intervals, "{error}: {:?}", adapted.trials);
        let half = Request { most_intervals: intervals / 2, ..request };
        let scene = scenes::scene("heinisuo-1984");
        let best = adapt(&scene, &half).expect("the scene can be scaled");
        assert_ne!(best.end, End::Reached, "{error} is reached with {} intervals", best.settings.intervals);
    }
}

#[test]
fn what_cannot_be_reached_is_not_certified() {
    let scene = scenes::scene("ridge");
    let request = Request { most_intervals: 100, ..Request::new(Method::Force, Solver::ActiveSet, 1e-6) };
    let adapted = adapt(&scene, &request).expect("the scene can be scaled");
    assert_eq!(adapted.end, End::Limit { intervals: 100 });
    assert_eq!(adapted.solution.verdict.status, Status::NotCertified);
    let least = adapted.trials.iter().map(|t| t.error).fold(f64::INFINITY, f64::min);
    assert_eq!(adapted.solution.verdict.largest_error().to_bits(), least.to_bits(), "the best answer comes back");

    let request = Request::new(Method::Force, Solver::FourStep, 1e-6);
    let adapted = adapt(&scene, &request).expect("the scene can be scaled");
    assert!(matches!(adapted.end, End::Failed { .. }), "{:?}", adapted.end);

    // Less than rounding: a beam that lifts off nowhere, so that finer grids cost little.
    let scene = scenes::scene("kink");
    let adapted =
        adapt(&scene, &Request::new(Method::Force, Solver::ActiveSet, 1e-15)).expect("the scene can be scaled");
    assert_ne!((adapted.end, adapted.solution.verdict.status), (End::Reached, Status::Certified));
}
