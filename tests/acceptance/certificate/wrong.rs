//! Wrong forces are bounded truthfully: those that one scene of the report has on all others, and one beyond all numbers. Spoilt
//! forces of the scene itself are in `truth`.

use palkki::route::{Method, Solver};
use palkki::scene::Foundation;
use palkki_evidence::faults::Truth;

use super::{of_forces, places};
use crate::scenes::{nodes, report, run, uniform};

/// Forces of one scene on another of the same length, and what their places say of its own answer as a witness.
#[test]
fn forces_of_another_scene_are_bounded() {
    let scenes = report();
    let raws: Vec<_> = scenes.iter().map(|(_, s)| run(s, Method::Displacement, Solver::ActiveSet, 40)).collect();
    for ((name, scene), own) in scenes.iter().zip(&raws) {
        let truth = Truth::of(scene).expect("theory has an answer");
        for ((other, _), raw) in scenes.iter().zip(&raws) {
            let what = format!("{name} with the forces of {other}");
            let here = nodes(own).x.iter().copied();
            let forces: Vec<(f64, f64)> = here.zip(nodes(raw).contact_force.iter().copied()).collect();
            let judged = truth.nodes_from(nodes(own), &places(&forces)).expect("numbers");
            assert!(judged.false_bounds.is_empty() && judged.certificate.gap.is_finite(), "{what}: {judged:?}");
            let bounds = of_forces(scene, &forces, &truth.contacts);
            let apart = truth.contacts(&truth.contacts).expect("in range").certificate;
            assert!(bounds.energy_lower <= apart.energy_upper && apart.energy_lower <= bounds.energy_upper, "{what}");
        }
    }
}

/// A force that throws the beam beyond all numbers, from a pattern of which nothing follows: no admissible deflection is found,
/// and nothing is bounded by its distance from one.
#[test]
fn where_no_admissible_deflection_is_found_nothing_is_bounded() {
    let scene = uniform(1.0, 1e-300, 1e-100, Foundation::Polynomial { coefficients: vec![1.0, 1.0] });
    let forces = [(0.3, 1e-100), (0.5, 1e-100), (0.7, 1e300)];
    let certificate = of_forces(&scene, &forces, &places(&forces));
    let bounds = [certificate.gap, certificate.deflection_error, certificate.best_deflection_error];
    assert!(bounds.iter().all(|bound| bound.is_infinite()), "{certificate:?}");
    assert!(certificate.energy_upper.is_infinite() && certificate.energy_lower.is_infinite(), "{certificate:?}");
    assert!(!certificate.contacts_proven && certificate.reactions == [None, None], "{certificate:?}");
}
