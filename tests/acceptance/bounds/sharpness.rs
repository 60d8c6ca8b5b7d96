//! The bounds are worth having: close to the true error, and small where the answer is good.

use palkki::certificate::{ContactLoad, Judged, certify, certify_contacts};
use palkki::route::{Method, Solver, Status};
use palkki::theory;

use super::{of_nodes, true_error};
use crate::scenes::{example, nodes, report, run, scene};

/// Asked for on the paper's example, depth 1: intervals and certified error of the deflection.
const ASKED: [(usize, f64); 2] = [(300, 1e-3), (10_000, 1e-6)];

#[test]
fn the_example_is_certified_to_the_accuracy_asked_for() {
    for (intervals, most) in ASKED {
        let outcome = run(&example(), Method::Force, Solver::ActiveSet, intervals);
        let certificate = of_nodes(&example(), nodes(&outcome));
        assert!(certificate.deflection_error <= most, "{intervals} intervals: {certificate:?}");
    }
}

/// Where the pattern of contact is proven, what remains is the answer's own error and how its range between nodes is bounded.
#[test]
fn certified_errors_are_close_to_true_ones() {
    /// Between four places in each interval the true error may be a little larger than at them.
    const LOOSE: f64 = 1.1;
    for (name, scene) in report() {
        let truth = theory::solve(&scene).expect("theory has an answer");
        for intervals in [30, 100, 300] {
            let outcome = run(&scene, Method::Force, Solver::ActiveSet, intervals);
            let certificate = of_nodes(&scene, nodes(&outcome));
            let error = true_error(&scene, nodes(&outcome), |x| truth.deflection(x));
            assert!(certificate.pattern_proven, "{name}, {intervals} intervals");
            assert!(certificate.deflection_error <= LOOSE * error, "{name}, {intervals}: {error}, {certificate:?}");
        }
    }
}

/// A beam that hangs free, and an answer with forces of the size of rounding all along it, as an interior point leaves them:
/// they show no pattern of contact, and it takes the forces themselves to see how little they do.
#[test]
fn forces_of_the_size_of_rounding_cost_what_they_do() {
    /// As above.
    const LOOSE: f64 = 1.1;
    let scene = scene("free");
    let truth = theory::solve(&scene).expect("theory has an answer");
    for intervals in [20_u32, 50, 100, 300] {
        let outcome = run(&scene, Method::Force, Solver::ActiveSet, intervals as usize);
        let nodes = nodes(&outcome);
        let error = true_error(&scene, nodes, |x| truth.deflection(x));
        let total = truth.state.reactions.left + truth.state.reactions.right;
        for share in [1e-18, 1e-15, 1e-12] {
            let forces: Vec<(f64, f64)> =
                nodes.x.iter().map(|&x| (x, share * total * (1.0 + (7.0 * x).sin()) / f64::from(intervals))).collect();
            let load = ContactLoad::new(scene.beam().length(), forces.iter().copied()).expect("finite forces");
            let certificate = certify(&scene, &load, Judged::Nodes(nodes)).expect("the scene can be scaled");
            // √(2 gap l³/(48 EI)), with a gap of at most the work of the forces on the way from the line of the supports.
            let gap: f64 = forces.iter().map(|&(x, p)| p * scene.depth(x)).sum();
            let beam = scene.beam();
            let added = (gap * beam.length().powi(3) / (24.0 * beam.bending_stiffness())).sqrt();
            assert!(
                certificate.deflection_error <= LOOSE * error + added,
                "{intervals} intervals, {share:e} of all forces: {error:e}, {certificate:?}"
            );
        }
    }
}

/// Answers of beam theory, by the places of their contacts alone.
#[test]
fn exact_answers_are_certified() {
    /// Of the largest deflection.
    const ERROR: f64 = 1e-10;
    for (name, scene) in report() {
        let exact = theory::solve(&scene).expect("theory has an answer");
        assert_eq!(exact.status, Status::Certified, "{name}");
        let certificate = certify_contacts(&scene, &exact.state.contacts).expect("the scene can be scaled");
        let size = exact.state.deflection.max.abs().max(exact.state.deflection.min.abs());
        assert!(certificate.deflection_error <= ERROR * size, "{name}: {certificate:?}");
        let slack = ERROR * exact.state.energy.abs();
        assert!(
            certificate.energy_lower <= exact.state.energy + slack
                && exact.state.energy - slack <= certificate.energy_upper,
            "{name}: {} in {certificate:?}",
            exact.state.energy
        );
    }
}
