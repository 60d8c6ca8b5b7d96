//! Equilibrium and complementarity.

use palkki::route::{Method, Solver};
use palkki::state::ContactState;

use palkki_evidence::draft::Draft;

use super::{ROUNDING, scene, some};
use crate::scenes::{nodes, report, run};

/// Force and moment of everything that acts on the beam, over the load: zero.
fn imbalance(draft: &Draft, state: &ContactState, x: &[f64], p: &[f64]) -> (f64, f64) {
    let l = draft.length;
    let mut load = draft.uniform * l;
    let mut moment = 0.5 * draft.uniform * l * l;
    for q in &draft.linear {
        let span = q.to - q.from;
        load += 0.5 * (q.start + q.end) * span;
        moment += 0.5 * (q.start + q.end) * span * q.from + (q.start + 2.0 * q.end) * span * span / 6.0;
    }
    for p in &draft.point {
        load += p.force;
        moment += p.force * p.at;
    }
    let contact: f64 = p.iter().sum();
    let contact_moment: f64 = p.iter().zip(x).map(|(p, x)| p * x).sum();
    let force = load - contact - state.reactions.left - state.reactions.right;
    let moment = moment - contact_moment - state.reactions.right * l;
    (force / load, moment / (load * l))
}

/// With the loads of the scene itself and not those that a grid makes of them.
#[test]
fn loads_contact_forces_and_reactions_are_in_equilibrium() {
    for draft in some(20, 2) {
        for method in Method::ALL {
            for intervals in [2, 9, 60] {
                let raw = run(&scene(&draft), method, Solver::ActiveSet, intervals);
                let nodes = nodes(&raw);
                let (force, moment) = imbalance(&draft, &raw.state, &nodes.x, &nodes.contact_force);
                assert!(force.abs().max(moment.abs()) <= ROUNDING, "{method} {intervals}: {force:e}, {moment:e}");
                let sum: f64 = nodes.contact_force.iter().sum();
                let listed = raw.state.contact_force();
                assert!((sum - listed).abs() <= ROUNDING * sum.max(1.0), "contacts list all forces: {sum}, {listed}");
            }
        }
    }
}

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
