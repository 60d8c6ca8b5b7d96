//! The methods against closed forms: every beam that has one, the paper's and on any supports or none.

use palkki::route::{Method, Solver};
use palkki::state::ContactState;
use palkki_evidence::closed::{self, Closed, Q};

use crate::scenes::run;

/// Errors of second order on grids of 100, 1000 and 10 000 intervals: a hundred times smaller each time, or half of that where
/// lift-off is between nodes.
const FASTER: f64 = 50.0;
/// What is left of digits, of the energy and of the energy that the load and the forces of supports could have.
const ROUNDING: f64 = 1e-10;

#[test]
fn energies_go_to_closed_forms_with_the_square_of_the_spacing() {
    for known in closed::all().expect("well-posed scenes") {
        let Closed { name, scene, contacts, .. } = &known;
        let (length, stiffness) = (scene.beam().length(), scene.beam().bending_stiffness());
        // Of a settlement there are forces without a load.
        let load = (Q * length).max(stiffness * known.largest() / (length * length * length));
        let free = load * load * length * length * length / stiffness;
        let size = known.energy().abs().max(known.largest() * load).max(1e-6 * free);
        for method in Method::ALL {
            let states = [100, 1000, 10_000].map(|n| run(scene, method, Solver::ActiveSet, n));
            assert!(states.iter().all(|raw| raw.solved), "{name}, {method}");
            let errors = states.each_ref().map(|raw| (raw.state.energy - known.energy()).abs() / size);
            let second = errors.windows(2).all(|pair| FASTER * pair[1] <= pair[0] + FASTER * ROUNDING);
            assert!(errors[0] <= 0.01 && second, "{name}, {method}: {errors:?}");
            let ContactState { supports, contacts: found, .. } = &states[2].state;
            for (support, expected) in supports.iter().zip(known.reactions()) {
                let Some(expected) = expected else { continue };
                let off = (support.force - expected).abs();
                assert!(off <= 1e-3 * expected.abs().max(load), "{name}, {method}: {off} at {support:?}");
                let couple = support.moment.map_or(0.0, |moment| moment - known.moment(support.at));
                assert!(couple.abs() <= 1e-3 * load * length, "{name}, {method}: off by {couple} at {support:?}");
            }
            for contact in contacts.iter().filter(|_| !found.is_empty()) {
                let ends =
                    |x: f64| found.iter().map(|c| (c.from - x).abs().min((c.to - x).abs())).fold(length, f64::min);
                let off = ends(contact.from).max(ends(contact.to));
                assert!(off <= 1e-3 * length, "{name}, {method}: the ends of {contact:?} are missed by {off}");
            }
        }
    }
}
