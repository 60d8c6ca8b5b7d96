//! Complementarity: no force across a clearance. Forces and moments in balance are a law of the hostile runs.

use palkki::route::{Method, Solver};

use crate::scenes::{nodes, report, run};

#[test]
fn no_force_acts_across_a_clearance_and_none_pulls() {
    for (name, scene) in report() {
        for method in Method::ALL {
            let raw = run(&scene, method, Solver::ActiveSet, 30);
            assert!(raw.solved, "{name} {method}");
            let nodes = nodes(&raw);
            for (p, h) in nodes.contact_force.iter().zip(&nodes.clearance) {
                // Exactly: the active set sets the one or the other to zero.
                assert!(0.0 <= *p && 0.0 <= *h && (*p <= 0.0 || *h <= 0.0), "{name} {method}: p = {p}, h = {h}");
            }
        }
    }
}
