//! The bounds are worth having: small where the answer is good. How close they are to the true error on all scenes is in the report
//! (`report/data/bounds.csv`).

use palkki::route::{Method, Solver};

use super::of_nodes;
use crate::scenes::{example, nodes, run};

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
