//! Seen from the other side, a beam is the same beam.

use palkki::route::{Method, Solver};
use palkki::scene::{LinearLoad, PointLoad};
use palkki::state::ContactState;

use palkki_evidence::draft::Draft;

use super::{ROUNDING, points, scene, some};
use crate::scenes::{apart, largest, nodes, report, run};

/// The scene as it is seen from the other side.
fn mirrored(draft: &Draft) -> Draft {
    let back = |x: f64| draft.length - x;
    let mut mirrored = Draft {
        linear: draft
            .linear
            .iter()
            .map(|q| LinearLoad { from: back(q.to), to: back(q.from), start: q.end, end: q.start })
            .collect(),
        point: draft.point.iter().map(|p| PointLoad { at: back(p.at), force: p.force }).collect(),
        ..draft.clone()
    };
    let points = points(&mut mirrored);
    points.reverse();
    // The end points stay exactly on the supports.
    points.iter_mut().for_each(|p| p[0] = back(p[0]).max(0.0));
    mirrored
}

#[test]
fn the_mirror_image_has_the_mirrored_answer() {
    for draft in some(20, 1) {
        let (scene, other) = (scene(&draft), scene(&mirrored(&draft)));
        let load = scene.load().magnitude(draft.length);
        for method in Method::ALL {
            let [a, b] = [&scene, &other].map(|scene| run(scene, method, Solver::ActiveSet, 33));
            let (x, mut y) = (nodes(&a).clone(), nodes(&b).clone());
            y.contact_force.reverse();
            y.deflection.reverse();
            y.moment.reverse();
            assert!(apart(&x.contact_force, &y.contact_force) <= ROUNDING * load, "{method}: {draft:?}");
            assert!(apart(&x.deflection, &y.deflection) <= ROUNDING * largest(&x.deflection), "{method}: {draft:?}");
            assert!(apart(&x.moment, &y.moment) <= ROUNDING * load * draft.length, "{method}: {draft:?}");
            assert!((a.state.reactions.left - b.state.reactions.right).abs() <= ROUNDING * load, "{method}: {draft:?}");
            assert_eq!(a.state.regime, b.state.regime, "{method}: {draft:?}");
        }
    }
}

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
