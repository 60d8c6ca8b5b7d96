//! Two-sided bounds: what is guaranteed holds, whoever computed the forces, and it is worth having.

mod bent;
mod brackets;
mod closed;
mod conditions;
mod faults;
mod fractions;
mod given;
mod interval;
mod judge;
mod lumped;
mod random_lists;
mod right;
mod scale;
mod sharpness;
mod sprung;
mod supports;
mod truth;
mod verdict;
mod witness;

use palkki::certificate::{Certificate, ContactLoad, Judged, Kkt, certify};
use palkki::scene::Scene;
use palkki::state::{Contact, ContactState, Nodes};
use palkki::theory;

/// Sizes of faults in a witness: of the twelve that the report tries in exact contacts, from rounding to a tenth of the beam.
const SOME: [f64; 4] = [1e-12, 1e-8, 1e-4, 1e-1];

/// The certificate of the deflection that an answer prints, from the contacts of beam theory.
#[track_caller]
fn of_nodes(scene: &Scene, nodes: &Nodes) -> Certificate {
    let exact = theory::solve(scene).expect("theory has an answer");
    certify(scene, Judged::Nodes(nodes), &exact.state.contacts).expect("the scene can be scaled")
}

/// The certificate of the deflection that forces cause.
#[track_caller]
fn of_forces(scene: &Scene, forces: &[(f64, f64)], witness: &[Contact]) -> Certificate {
    let load = ContactLoad::new(scene.beam().length(), forces.iter().copied()).expect("finite forces on the beam");
    certify(scene, Judged::Forces(&load), witness).expect("the scene can be scaled")
}

/// Single contacts at the places of the forces that press: what somebody who has nothing else takes for a witness.
fn places(forces: &[(f64, f64)]) -> Vec<Contact> {
    forces.iter().filter(|f| 0.0 < f.1).map(|&(x, force)| Contact::at(x, force)).collect()
}

/// Whether a state solves its discrete problem, by our check.
fn passes(scene: &Scene, state: &ContactState) -> bool {
    Kkt::of(scene, state).is_some_and(|kkt| kkt.holds())
}
