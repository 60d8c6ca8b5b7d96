//! Against beam theory on uneven ground: the scenes of the report and random ones.

use palkki::route::{Method, Solver};
use palkki::scene::Scene;
use palkki_evidence::faults::Truth;
use palkki_evidence::paper::uneven::{self, Unevenness};

use crate::scenes::{nodes, report, run};

/// Checks one scene on some grids; how many answers were compared.
#[track_caller]
fn check(name: &str, scene: &Scene, grids: &[usize], solvers: &[Solver]) -> usize {
    let truth = Truth::of(scene).expect("theory has an answer");
    if !truth.solved {
        return 0;
    }
    let mut compared = 0;
    for &intervals in grids {
        for method in Method::ALL {
            for &solver in solvers {
                let judged = truth.nodes(nodes(&run(scene, method, solver, intervals))).expect("numbers");
                assert!(judged.false_bounds.is_empty(), "{name}, {method} {solver}, {intervals} intervals: {judged:?}");
                compared += 1;
            }
        }
    }
    compared
}

#[test]
fn scenes_of_the_report() {
    for (name, scene) in report() {
        assert!(0 < check(&name, &scene, &[10, 30], &Solver::ALL), "{name}: theory is certified");
        check(&name, &scene, &[100], &[Solver::ActiveSet, Solver::FourStep]);
    }
}

#[test]
fn random_scenes() {
    for kind in Unevenness::ALL {
        let scenes = uneven::scenes(kind, 15, 1984).expect("the scenes are well posed");
        let compared: usize = scenes
            .iter()
            .map(|scene| check(kind.name(), scene, &[17, 60, 250], &[Solver::ActiveSet, Solver::FourStep]))
            .sum();
        assert!(scenes.len() * 3 * 3 < compared, "theory is certified on most scenes");
    }
}
