//! Contact forces under a load that is lumped at nodes: closed forms, our own answers, and what is refused.

use palkki::certificate::{
    ContactLoad, Judged, Lumped, NotLumped, ViolationKind, certify, violations, violations_at_nodes,
};
use palkki::route::{Method, Solver};
use palkki::scene::{Beam, Foundation, Load, Scene};
use palkki::state::Nodes;
use palkki::verdict::Verdict;
use palkki_evidence::faults::Truth;

use crate::scenes::{example, nodes, report, run};

/// Of sums over some hundred nodes, relative to the largest value.
const ROUNDING: f64 = 1e-12;

fn forces(nodes: &Nodes) -> Vec<(f64, f64)> {
    nodes.x.iter().copied().zip(nodes.contact_force.iter().copied()).collect()
}

#[track_caller]
fn same(what: &str, found: &[f64], expected: &[f64]) {
    assert_eq!(found.len(), expected.len(), "{what}");
    let size = expected.iter().fold(0.0_f64, |most, v| most.max(v.abs()));
    for (k, (found, expected)) in found.iter().zip(expected).enumerate() {
        assert!((found - expected).abs() <= ROUNDING * size, "{what}: {found} and not {expected}, number {k}");
    }
}

/// Without contact: `q x (l³ − 2 l x² + x³)/24 EI` at the nodes, less `q Δ² x (l − x)/24 EI`.
#[test]
fn a_lumped_load_bends_the_free_beam_less_by_a_parabola() {
    let (l, ei, q) = (7.0, 3.0, 2.0);
    let free = Scene::new(
        Beam::new(l, ei).expect("positive"),
        Load::uniform_on(&Beam::new(l, ei).expect("positive"), q).expect("finite"),
        None,
    )
    .expect("a scene");
    for intervals in [2_u32, 3, 8, 300, 1000] {
        let width = l / f64::from(intervals);
        let places: Vec<f64> = (1..intervals).map(|k| l * f64::from(k) / f64::from(intervals)).collect();
        let lumped = Lumped::new(&free, places.iter().map(|x| (*x, 0.0))).expect("nodes");
        assert_eq!(lumped.intervals(), usize::try_from(intervals).expect("small"));
        let expected: Vec<f64> = places
            .iter()
            .map(|x| q * x * (l * l * l - 2.0 * l * x * x + x * x * x - width * width * (l - x)) / (24.0 * ei))
            .collect();
        same("deflection", &lumped.nodes.deflection, &expected);
        let moments: Vec<f64> = places.iter().map(|x| 0.5 * q * x * (l - x)).collect();
        same("moment", &lumped.nodes.moment, &moments);
        assert!(lumped.nodes.clearance.iter().all(|h| h.is_infinite()) && violations_at_nodes(&lumped).is_empty());
    }
}

/// The nodal forces of the paper's example under the distributed load: `q Δ² l²/96 EI` into the ground at mid-span. Under the
/// nodal loads the mid-span lies on it.
#[test]
fn under_the_distributed_load_nodal_forces_let_the_beam_into_the_ground() {
    let scene = example();
    let (l, ei, q) = (10.0, 500.0 / 384.0, 1.0);
    for intervals in [30_u32, 60] {
        let raw = run(&scene, Method::Force, Solver::ActiveSet, usize::try_from(intervals).expect("small"));
        let forces = forces(nodes(&raw));
        let load = ContactLoad::new(l, forces.iter().copied()).expect("forces on the beam");
        let worst = violations(&scene, &load).expect("a scene")[0];
        let width = l / f64::from(intervals);
        let sag = q * width * width * l * l / (96.0 * ei);
        assert_eq!(worst.kind, ViolationKind::Penetration);
        assert!(
            (worst.amount - sag).abs() <= ROUNDING && (worst.at - 0.5 * l).abs() <= ROUNDING,
            "{worst:?}, not {sag}"
        );
        assert!((worst.relative - sag / (1.0 + sag)).abs() <= ROUNDING, "of the largest deflection");
        let lumped = Lumped::new(&scene, forces).expect("nodes");
        assert!(violations_at_nodes(&lumped).iter().all(|v| v.relative <= ROUNDING), "none at the nodes");
        let exact = palkki::theory::solve(&scene).expect("a closed form").state.contacts;
        let distributed = certify(&scene, Judged::Forces(&load), &exact).expect("a scene");
        let nodal = certify(&scene, Judged::Nodes(&lumped.nodes), &exact).expect("a scene");
        let [distributed, nodal] = [distributed, nodal].map(Verdict::of_forces);
        assert!(2.0 * nodal.error < distributed.error, "{distributed:?}, {nodal:?}");
    }
}

/// From forces alone follow the same nodes, and so the same certificate, as from the answer that they belong to.
#[test]
fn forces_of_our_own_answers_give_their_nodes_back() {
    for (name, scene) in report() {
        let truth = Truth::of(&scene).expect("theory has an answer");
        for (method, intervals) in [(Method::Force, 30), (Method::Displacement, 101)] {
            let raw = run(&scene, method, Solver::ActiveSet, intervals);
            let own = nodes(&raw);
            let lumped = Lumped::new(&scene, forces(own)).expect("nodes");
            let what = format!("{name}, {method}");
            same(&what, &lumped.nodes.deflection, &own.deflection);
            same(&what, &lumped.nodes.moment, &own.moment);
            same(&what, &lumped.nodes.x, &own.x);
            let found = truth.nodes(&lumped.nodes).expect("numbers");
            assert!(found.false_bounds.is_empty(), "{what}: {found:?}");
            let error = found.certificate.deflection_error;
            let of_answer = super::of_nodes(&scene, own).deflection_error;
            assert!((error - of_answer).abs() <= 1e-9 * truth.deflection, "{what}: {error} and {of_answer}");
        }
    }
}

#[test]
fn conditions_are_asked_at_the_nodes() {
    // A force of 1 at mid-span lifts a beam of flexibility l³/48EI = 1 by 1; the load of 3.2 there lowers it by 3.2.
    let load = Load::new(
        &Beam::new(2.0, 1.0 / 6.0).expect("positive"),
        0.0,
        Vec::new(),
        vec![palkki::scene::PointLoad { at: 1.0, force: 3.2 }],
    );
    let beam = Beam::new(2.0, 1.0 / 6.0).expect("positive");
    let at = |depth: f64, force: f64| {
        let scene =
            Scene::new(beam.clone(), load.clone().expect("finite"), Some(Foundation::Flat { depth })).expect("a scene");
        let found = violations_at_nodes(&Lumped::new(&scene, [(1.0, force)]).expect("a node"));
        found.iter().map(|v| (v.kind, v.at, v.amount, v.relative)).collect::<Vec<_>>()
    };
    let close = |found: Vec<(ViolationKind, f64, f64, f64)>, expected: &[(ViolationKind, f64, f64)]| {
        assert_eq!(found.len(), expected.len(), "{found:?}");
        for (found, expected) in found.iter().zip(expected) {
            assert_eq!((found.0, found.1.to_bits()), (expected.0, 1.0_f64.to_bits()), "{found:?}");
            assert!((found.2 - expected.1).abs() <= ROUNDING && (found.3 - expected.2).abs() <= ROUNDING, "{found:?}");
        }
    };
    close(at(2.0, 1.0), &[(ViolationKind::Penetration, 0.2, 0.2 / 2.2)]);
    close(at(2.0, 1.3), &[(ViolationKind::Complementarity, 0.1, 0.1 / 1.9)]);
    close(at(3.0, -1.0), &[(ViolationKind::Tension, 1.0, 1.0), (ViolationKind::Penetration, 0.2, 0.2 / 3.2)]);
}

#[test]
fn places_have_to_be_the_nodes_of_equal_intervals() {
    let scene = example();
    let new = |places: &[f64]| Lumped::new(&scene, places.iter().map(|x| (*x, 1.0)));
    // Any order, the supports, a place twice, and places with four digits.
    let rounded = new(&[10.0, 3.3333, 0.0, 6.6667, 6.6667]).expect("three intervals");
    let exact = Lumped::new(&scene, [(10.0 / 3.0, 1.0), (20.0 / 3.0, 2.0)]).expect("three intervals");
    assert_eq!(rounded.nodes, exact.nodes);
    assert_eq!(new(&[]), Err(NotLumped::NoNodes));
    assert_eq!(new(&[0.0, 10.0]), Err(NotLumped::NoNodes));
    let unequal = new(&[2.5, 4.0, 7.5]).expect_err("no equal intervals");
    assert_eq!(unequal, NotLumped::NotANode { index: 2, count: 3, x: 4.0, node: 5.0 });
    assert!(unequal.to_string().contains("place 2 would be x = 5 on equal intervals, but is x = 4"), "{unequal}");
    // The nodes of four intervals that touch, without those that do not.
    assert!(matches!(new(&[2.5, 5.0]), Err(NotLumped::NotANode { index: 1, count: 2, .. })));
    assert!(matches!(new(&[11.0]), Err(NotLumped::Force(_))) && matches!(new(&[f64::NAN]), Err(NotLumped::Force(_))));
}
