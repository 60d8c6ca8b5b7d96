//! Against beam theory on uneven ground: the scenes of the report and random ones.

use palkki::route::{Method, Solver, Status};
use palkki::scene::Scene;
use palkki::theory;
use palkki_evidence::paper::uneven::{self, Unevenness};

use super::{of_nodes, true_error};
use crate::scenes::{nodes, report, run};

/// Theory is right to twelve digits of the largest deflection and of the energy where it is certified.
const THEORY: f64 = 1e-11;

/// Checks one scene on some grids; how many answers were compared.
#[track_caller]
fn check(name: &str, scene: &Scene, grids: &[usize], solvers: &[Solver]) -> usize {
    let truth = theory::solve(scene).expect("theory has an answer");
    if truth.status != Status::Certified {
        return 0;
    }
    let size = truth.state.deflection.max.abs().max(truth.state.deflection.min.abs());
    let energy = truth.state.energy;
    let mut compared = 0;
    for &intervals in grids {
        for method in Method::ALL {
            for &solver in solvers {
                let outcome = run(scene, method, solver, intervals);
                let certificate = of_nodes(scene, nodes(&outcome));
                let what = format!("{name}, {method} {solver}, {intervals} intervals: {certificate:?}");
                let error = true_error(scene, nodes(&outcome), |x| truth.deflection(x));
                assert!(error <= certificate.deflection_error + THEORY * size, "{error} in {what}");
                let slack = THEORY * energy.abs();
                assert!(certificate.energy_lower <= energy + slack, "{energy} in {what}");
                assert!(energy - slack <= certificate.energy_upper, "{energy} in {what}");
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
        check(&name, &scene, &[100, 300], &[Solver::ActiveSet, Solver::FourStep]);
    }
}

#[test]
fn random_scenes() {
    for kind in Unevenness::ALL {
        let scenes = uneven::scenes(kind, 40, 1984).expect("the scenes are well posed");
        let compared: usize = scenes
            .iter()
            .map(|scene| check(kind.word(), scene, &[17, 60, 250], &[Solver::ActiveSet, Solver::FourStep]))
            .sum();
        assert!(scenes.len() * 3 * 3 < compared, "theory is certified on most scenes");
    }
}
