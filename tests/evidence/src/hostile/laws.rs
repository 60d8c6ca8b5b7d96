//! What must be true of the answers of one run together.
//!
//! Authorities that do not know each other: beam theory, guaranteed bounds (in interval arithmetic, from a
//! witness that is only believed where it is proven), the active set on the same grid, and the laws that every answer keeps (equilibrium, units).

use palkki::certificate::{CERTIFIED_RESIDUAL, Certificate};
use palkki::route::RawSolution;
use palkki::scene::Scene;
use palkki::state::ContactState;
use palkki::theory::Exact;
use palkki::verdict::certificate;
use palkki::{Settings, Witness};

use super::trial::Trial;

/// Share of the forces to which a certified answer is in balance: what the judge of a discretised answer asks.
const BALANCE: f64 = 1e-9;

/// Share of the forces that the list of contacts leaves out: at most 1e-9 of them at each of 60 nodes.
const LISTED: f64 = 1e-7;

/// Share of the largest numbers to which two certified answers of one discrete problem agree. The residual of both is at
/// most 1e-9; forces are worse by the condition of the problem, on grids of a few dozen intervals.
const SAME: f64 = 1e-4;

/// Share of the sizes that make up an energy, or of the largest deflection, that twelve digits of theory leave open.
const THEORY: f64 = 1e-9;

/// The least deflection that answers are measured by, as a share of what all forces together would cause: that of the judge,
/// sixteen units in the last place over what is certified.
const ROUNDING: f64 = 16.0 * f64::EPSILON / CERTIFIED_RESIDUAL;

/// Deflection in the middle by a force of one there, `l³/48EI`.
fn flexibility(scene: &Scene) -> f64 {
    let length = scene.beam().length();
    length / scene.beam().bending_stiffness() * length * length / 48.0
}

/// Forces and deflections of a state, as sizes. Without loads it is the depth of the foundation that sets them, as it does for
/// the judge; and a beam that cannot move has a deflection of rounding.
fn sizes(scene: &Scene, state: &ContactState) -> (f64, f64) {
    let contacts: f64 = state.contacts.iter().map(|c| c.force.abs()).sum();
    let reactions = state.reactions.left.abs() + state.reactions.right.abs();
    let load = scene.load().magnitude(scene.beam().length());
    let deflection = state.deflection.max.abs().max(state.deflection.min.abs());
    let idle = match scene.foundation() {
        Some(foundation) if load == 0.0 => foundation.magnitude(scene.beam().length()),
        _ => 0.0,
    };
    let force = load.max(contacts).max(reactions).max(idle / flexibility(scene));
    (force, deflection.max(idle).max(ROUNDING * flexibility(scene) * force))
}

fn forces(scene: &Scene, state: &ContactState) -> f64 {
    sizes(scene, state).0
}

/// True also for what is no number.
fn exceeds(value: f64, limit: f64) -> bool {
    value.is_nan() || limit < value
}

/// A certified state consists of numbers, and its forces are in balance.
pub(super) fn balanced(trial: &mut Trial, who: &str, scene: &Scene, state: &ContactState) {
    let ContactState { reactions, deflection, moment, energy, .. } = state;
    let numbers = [reactions.left, reactions.right, deflection.max, deflection.min, moment.max, moment.min, *energy];
    let contacts = state.contacts.iter().flat_map(|c| [c.from, c.to, c.force]);
    if !numbers.into_iter().chain(contacts).all(f64::is_finite) {
        trial.wrong.push(format!("{who}: certified, but not all numbers: {numbers:?}"));
    }
    let load = scene.load().resultant(scene.beam().length());
    // The list of contacts leaves out forces that are next to nothing; at the nodes they are all there.
    let contact = state.nodes.as_ref().map_or_else(|| state.contact_force(), |nodes| nodes.contact_force.iter().sum());
    let rest = load - reactions.left - reactions.right - contact;
    let size = forces(scene, state);
    if exceeds(rest.abs(), BALANCE * size) {
        trial.wrong.push(format!("{who}: certified, but {rest:e} of {size:e} is not in balance"));
    }
    let listed = (contact - state.contact_force()).abs();
    if exceeds(listed, LISTED * size) {
        trial.wrong.push(format!("{who}: certified, but contacts of {listed:e} of {size:e} are not listed"));
    }
    let outside = |c: &palkki::state::Contact| !(0.0 <= c.from && c.from <= c.to && c.to <= scene.beam().length());
    if state.contacts.iter().any(outside) {
        trial.wrong.push(format!("{who}: certified, but a contact is not on the beam"));
    }
    if state.contacts.iter().any(|c| c.force < -BALANCE * size) {
        trial.wrong.push(format!("{who}: certified, but a contact pulls"));
    }
}

/// Sizes of the terms that an energy is the sum of.
fn energy_size(scene: &Scene, state: &ContactState) -> f64 {
    let (force, deflection) = sizes(scene, state);
    let depth = scene.foundation().map_or(0.0, |f| {
        state.contacts.iter().map(|c| f.depth(c.from).abs().max(f.depth(c.to).abs())).fold(0.0, f64::max)
    });
    force * deflection.max(depth)
}

/// The energy of a certified theory lies within guaranteed bounds.
pub(super) fn within(trial: &mut Trial, who: &str, exact: &Exact, bounds: &Certificate, scene: &Scene) {
    let (energy, slack) = (exact.state.energy, THEORY * energy_size(scene, &exact.state));
    if bounds.energy_upper < energy - slack || energy + slack < bounds.energy_lower {
        let (lower, upper) = (bounds.energy_lower, bounds.energy_upper);
        trial.wrong.push(format!("{who}: J = {energy:e} of theory is not between {lower:e} and {upper:e}"));
    }
}

/// Bounds of two certificates for one scene hold for the same number.
pub(super) fn overlap(trial: &mut Trial, settings: &Settings, a: &Certificate, b: &Certificate) {
    if a.energy_upper < b.energy_lower || b.energy_upper < a.energy_lower {
        let brackets = [a.energy_lower, a.energy_upper, b.energy_lower, b.energy_upper];
        trial.wrong.push(format!("{}: bounds exclude each other: {brackets:?}", name(settings)));
    }
}

/// A discretised answer against its own certificate and theory.
pub(super) fn judge(
    trial: &mut Trial,
    scene: &Scene,
    settings: &Settings,
    outcome: &RawSolution,
    exact: Option<&Exact>,
) -> Option<Certificate> {
    let who = name(settings);
    if outcome.solved {
        balanced(trial, &who, scene, &outcome.state);
    }
    let nodes = outcome.state.nodes.as_ref()?;
    let witness = exact.map_or_else(|| Witness::of(scene), |exact| Witness::known(scene, exact));
    let certificate = certificate(&outcome.state, &witness)?;
    if certificate.gap < 0.0 || certificate.energy_upper < certificate.energy_lower {
        trial.wrong.push(format!("{who}: bounds are upside down: {certificate:?}"));
    }
    if let Some(exact) = exact.filter(|exact| exact.solved) {
        within(trial, &who, exact, &certificate, scene);
        let (_, size) = sizes(scene, &exact.state);
        for (x, v) in nodes.x.iter().zip(&nodes.deflection) {
            let difference = (v - exact.deflection(*x)).abs();
            if certificate.deflection_error + THEORY * size.max(v.abs()) < difference {
                let bound = certificate.deflection_error;
                trial.wrong.push(format!("{who}: off by {difference:e} at {x}, guaranteed are {bound:e}"));
                break;
            }
        }
    }
    Some(certificate)
}

/// Two certified answers to one discrete problem.
pub(super) fn same(
    trial: &mut Trial,
    settings: &Settings,
    scene: &Scene,
    state: &ContactState,
    reference: &RawSolution,
) {
    if !reference.solved {
        return;
    }
    let other = &reference.state;
    let (force, size) = sizes(scene, other);
    let off =
        (state.reactions.left - other.reactions.left).abs().max((state.reactions.right - other.reactions.right).abs());
    if exceeds(off, SAME * force) {
        trial.wrong.push(format!("{}: certified, but reactions are off by {:e}", name(settings), off / force));
    }
    let (Some(a), Some(b)) = (&state.nodes, &other.nodes) else { return };
    let off = a.deflection.iter().zip(&b.deflection).fold(0.0_f64, |off, (a, b)| off.max((a - b).abs()));
    if exceeds(off, SAME * size) {
        trial.wrong.push(format!("{}: certified, but deflections are off by {:e}", name(settings), off / size));
    }
}

pub(super) fn name(settings: &Settings) -> String {
    format!("{}/{}, {} intervals", settings.method, settings.solver, settings.intervals)
}
