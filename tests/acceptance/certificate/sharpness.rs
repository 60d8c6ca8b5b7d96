//! The bounds are worth having: close to the true error, and small where the answer is good.

use palkki::route::{Method, Solver};
use palkki::theory;

use super::{of_nodes, true_error};
use crate::scenes::{example, nodes, report, run};

/// Asked for on the paper's example, depth 1: intervals and certified error of the deflection.
const ASKED: [(usize, f64); 2] = [(300, 1e-3), (10_000, 1e-6)];

#[test]
fn the_example_is_certified_to_the_accuracy_asked_for() {
    for (intervals, most) in ASKED {
        let raw = run(&example(), Method::Force, Solver::ActiveSet, intervals);
        let certificate = of_nodes(&example(), nodes(&raw));
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
            let raw = run(&scene, Method::Force, Solver::ActiveSet, intervals);
            let certificate = of_nodes(&scene, nodes(&raw));
            let error = true_error(&scene, nodes(&raw), |x| truth.deflection(x));
            assert!(certificate.contacts_proven, "{name}, {intervals} intervals");
            assert!(certificate.deflection_error <= LOOSE * error, "{name}, {intervals}: {error}, {certificate:?}");
        }
    }
}
