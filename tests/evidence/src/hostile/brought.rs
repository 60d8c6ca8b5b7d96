//! Contact forces that are brought for a general beam: those of a grid and of beam theory, and forged ones. Whatever they are, the bounds are
//! those of the true beam.

use palkki::Witness;
use palkki::certificate::{Certificate, ContactLoad};
use palkki::scene::Scene;
use palkki::state::ContactState;
use palkki::theory::Exact;

use crate::random::Random;

use super::trial::Trial;

/// Places and forces.
type Rows = Vec<(f64, f64)>;

/// Forces of nodes if there are any, and otherwise those of the contacts.
fn of(state: &ContactState) -> Rows {
    let nodes = state.nodes.as_ref();
    let rows: Rows = match nodes {
        Some(nodes) => nodes.x.iter().copied().zip(nodes.contact_force.iter().copied()).collect(),
        None => state.touched().iter().map(|contact| (0.5 * (contact.from + contact.to), contact.force)).collect(),
    };
    rows.into_iter().filter(|(_, force)| 0.0 <= *force && force.is_finite()).collect()
}

/// Another set of forces: all of them changed, or one, or all moved by one.
fn forged(rows: &Rows, random: &mut Random) -> Rows {
    let (kind, one, factor) = (random.below(3), random.below(rows.len()), random.between(0.0, 2.0));
    let change = |(i, (x, force)): (usize, &(f64, f64))| match kind {
        0 => (*x, factor * force),
        1 if i == one => (*x, factor * force),
        2 => (*x, rows[(i + 1) % rows.len()].1),
        _ => (*x, *force),
    };
    rows.iter().enumerate().map(change).collect()
}

/// The law of forces: a certificate of a beam that they bend does not exclude what the certified answer says of the true one.
pub(super) fn forces(
    trial: &mut Trial,
    scene: &Scene,
    (exact, own): (&Exact, &Certificate),
    on_grid: Option<&ContactState>,
    random: &mut Random,
) {
    let witness = Witness::known(scene, exact);
    for right in [of(&exact.state)].into_iter().chain(on_grid.map(of)).filter(|rows| !rows.is_empty()) {
        for rows in [forged(&right, random), right] {
            let Ok(load) = ContactLoad::new(scene.beam().length(), rows.iter().copied()) else { continue };
            let said = match witness.judge_forces(&load, &[]) {
                Ok((said, _)) => said,
                Err(why) => {
                    trial.wrong.push(format!("forces are refused: {why}; {rows:?}"));
                    continue;
                }
            };
            trial.brought += 1;
            let within = 1e-12 * own.energy_lower.abs().max(own.energy_upper.abs());
            if own.energy_upper + within < said.energy_lower || said.energy_upper + within < own.energy_lower {
                trial.wrong.push(format!("an energy of {own:?} for forces {rows:?} with {said:?}"));
            }
            let off = (said.deflection - exact.state.deflection.magnitude()).abs();
            let allowed = said.deflection_error + own.deflection_error;
            if allowed * (1.0 + 1e-9) + 1e-12 * said.deflection < off {
                trial
                    .wrong
                    .push(format!("a deflection that is off by {off:e}, not by {allowed:e}, under forces {rows:?}"));
            }
        }
    }
}
