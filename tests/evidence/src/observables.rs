//! The observables, defined once: what of an answer is compared with the exact solution, each a share of the largest of its kind,
//! as in the summary of an answer.

use palkki::state::ContactState;
use palkki::theory::Exact;

use crate::compare::{apart_if_any, largest};

/// Their names: every support force over the largest, the contact force in total over the largest force, the deflection (worst node)
/// over the largest, the moment (worst node, and at built-in ends) over the largest, the energy over its value.
pub const NAMES: [&str; 5] = ["reactions", "total contact force", "deflection", "moment", "energy"];

/// The errors of a discretised answer, in the order of [`NAMES`]; infinite where there is nothing to compare.
#[must_use]
pub fn errors(exact: &Exact, state: &ContactState) -> [f64; 5] {
    let truth = &exact.state;
    let forces = |state: &ContactState| state.supports.iter().map(|support| support.force).collect::<Vec<_>>();
    let force = largest(forces(truth));
    let contact = truth.contact_force();
    let supports = apart_if_any(&forces(state), &forces(truth)) / force;
    let Some(nodes) = &state.nodes else { return [f64::INFINITY; 5] };
    let at_nodes =
        |of: &[f64], exact: &dyn Fn(f64) -> f64| largest(nodes.x.iter().zip(of).map(|(&x, own)| own - exact(x)));
    let deflection = at_nodes(&nodes.deflection, &|x| exact.deflection(x));
    let built_in =
        state.supports.iter().zip(&truth.supports).filter_map(|(own, exact)| Some(own.moment? - exact.moment?));
    let moment = at_nodes(&nodes.moment, &|x| exact.moment(x)).max(largest(built_in));
    [
        supports,
        (state.contact_force() - contact).abs() / force.max(contact),
        deflection / truth.deflection.magnitude(),
        moment / truth.moment.magnitude(),
        (state.energy - truth.energy).abs() / truth.energy.abs(),
    ]
}
