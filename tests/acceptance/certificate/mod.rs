//! Two-sided bounds: what is guaranteed holds, whoever computed the forces, and it is worth having.

mod anything;
mod closed;
mod faults;
mod flat;
mod given;
mod interval;
mod judge;
mod lumped;
mod random_lists;
mod scale;
mod sharpness;
mod supports;
mod truth;
mod uneven;
mod verdict;
mod witness;
mod wrong;

use palkki::certificate::{Certificate, ContactLoad, Judged, certify};
use palkki::scene::Scene;
use palkki::state::{Contact, Nodes};
use palkki::theory;

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

/// The deflection that an answer has at `x`: the cubic between the nodes around it.
fn deflection(scene: &Scene, nodes: &Nodes, x: f64) -> f64 {
    let (l, ei) = (scene.beam().length(), scene.beam().bending_stiffness());
    let after = nodes.x.partition_point(|node| *node <= x);
    let at = |i: usize| {
        if i == 0 || i == nodes.x.len() + 1 {
            return [if i == 0 { 0.0 } else { l }, 0.0, 0.0];
        }
        [nodes.x[i - 1], nodes.deflection[i - 1], nodes.moment[i - 1]]
    };
    let ([a, v0, m0], [b, v1, m1]) = (at(after), at(after + 1));
    let (s, w) = ((x - a) / (b - a), b - a);
    let r = 1.0 - s;
    v0 * r + v1 * s + w * w / (6.0 * ei) * (m0 * r * (1.0 - r * r) + m1 * s * (1.0 - s * s))
}

/// The largest difference of an answer from a true deflection, at its nodes and at three places between each two.
fn true_error(scene: &Scene, nodes: &Nodes, truth: impl Fn(f64) -> f64) -> f64 {
    let l = scene.beam().length();
    let intervals = nodes.x.len() + 1;
    let parts = 4 * intervals;
    #[expect(clippy::cast_precision_loss, reason = "thousands of places")]
    let places = (1..parts).map(|k| l * (k as f64 / parts as f64));
    places.map(|x| (deflection(scene, nodes, x) - truth(x)).abs()).fold(0.0, f64::max)
}
