//! What must be true of the answers of one run together.
//!
//! Authorities that do not know each other: beam theory, guaranteed bounds (in interval arithmetic, from a
//! witness that is only believed where it is proven), the active set on the same grid, and the laws that every answer keeps (equilibrium, units).

use palkki::certificate::{CERTIFIED_RESIDUAL, Certificate};
use palkki::route::Solution;
use palkki::scene::Scene;
use palkki::state::{ContactState, Motion};
use palkki::theory::{self, Exact};
use palkki::verdict::{Demand, Verdict, certificate};
use palkki::{Settings, Witness};

use crate::authority::number::Number;
use crate::authority::statics::resultant_and_moment;

use super::trial::Trial;
use crate::draft::Draft;

/// Share of the forces to which a certified answer is in balance: what the judge of a discretised answer asks.
const BALANCE: f64 = 1e-9;

/// Share of the forces that the list of contacts leaves out: at most 1e-9 of them at each of 60 nodes.
const LISTED: f64 = 1e-7;

/// Share of the largest numbers to which two certified answers of one discrete problem agree. The residual of both is at
/// most 1e-9; forces are worse by the condition of the problem, on grids of a few dozen intervals.
const SAME: f64 = 1e-4;

/// Share of the sizes that make up an energy, or of the largest deflection, that twelve digits of theory leave open.
pub(crate) const THEORY: f64 = 1e-9;

/// What a certified answer of theory is certain to, as a share of the forces beside.
pub(super) const CERTAIN: f64 = 1e-6;

/// Ground that is nearer than this share of the deflection to the level of a support may be level but for rounding.
const LEVEL: f64 = 1e-12;

/// Depths that are computed from a formula are rounded by so many units in the last place of their terms.
const TERMS: f64 = 16.0 * f64::EPSILON;

/// Whether the ground below `at` is level with a support there, but for rounding: it then takes part in the force of the support.
pub(super) fn grounded(scene: &Scene, at: f64, level: f64, size: f64) -> bool {
    scene.foundation().is_some_and(|ground| scene.depth(at) - level <= LEVEL * size + TERMS * ground.magnitude_at(at))
}

/// The least deflection that answers are measured by, as a share of what all forces together would cause: that of the judge,
/// sixteen units in the last place over what is certified.
const ROUNDING: f64 = 16.0 * f64::EPSILON / CERTIFIED_RESIDUAL;

/// Deflection in the middle by a force of one there, `l³/48EI`.
pub(super) fn flexibility(scene: &Scene) -> f64 {
    let length = scene.beam().length();
    length / scene.beam().bending_stiffness() * length * length / 48.0
}

/// Forces and deflections of a state, as sizes. Without loads it is what is given that sets them, the depth of the foundation first,
/// as it does for the judge; and a beam that cannot move has a deflection of rounding.
pub(super) fn sizes(scene: &Scene, state: &ContactState) -> (f64, f64) {
    let length = scene.beam().length();
    let contacts: f64 = state.contacts.iter().map(|c| c.force.abs()).sum();
    let reactions: f64 = state.supports.iter().map(|s| s.force.abs()).sum();
    let load = scene.load().magnitude(length);
    let deflection = state.deflection.magnitude();
    let profiles = scene.foundation().into_iter().chain(scene.beam().shape());
    let idle = if load == 0.0 { profiles.map(|profile| profile.magnitude(length)).fold(0.0, f64::max) } else { 0.0 };
    let force = load.max(contacts).max(reactions).max(idle / flexibility(scene));
    (force, deflection.max(idle).max(ROUNDING * flexibility(scene) * force))
}

fn forces(scene: &Scene, state: &ContactState) -> f64 {
    sizes(scene, state).0
}

/// The answer of beam theory, if it is certified.
pub(super) fn certified(scene: &Scene) -> Option<Exact> {
    let exact = theory::solve(scene).ok()?;
    Verdict::of_exact(scene, &exact, &Demand::default()).refusal.is_none().then_some(exact)
}

/// True also for what is no number.
pub(super) fn exceeds(value: f64, limit: f64) -> bool {
    value.is_nan() || limit < value
}

/// A certified state consists of numbers, and its forces are in balance.
pub(super) fn balanced(trial: &mut Trial, who: &str, scene: &Scene, state: &ContactState) {
    let ContactState { reactions, deflection, moment, energy, .. } = state;
    let numbers = [reactions.left, reactions.right, deflection.max, deflection.min, moment.max, moment.min, *energy];
    let contacts = state.contacts.iter().flat_map(|c| [c.from, c.to, c.force]);
    let supports = state.supports.iter().flat_map(|s| [s.force, s.moment.unwrap_or(0.0)]);
    if !numbers.into_iter().chain(contacts).chain(supports).all(f64::is_finite) {
        trial.wrong.push(format!("{who}: certified, but not all numbers: {numbers:?}"));
    }
    let load = scene.load().resultant(scene.beam().length());
    // The list of contacts leaves out forces that are next to nothing; at the nodes they are all there.
    let contact = state.nodes.as_ref().map_or_else(|| state.contact_force(), |nodes| nodes.contact_force.iter().sum());
    let rest = state.supports.iter().fold(load, |rest, support| rest - support.force) - contact;
    let size = forces(scene, state);
    if exceeds(rest.abs(), BALANCE * size) {
        trial.wrong.push(format!("{who}: certified, but {rest:e} of {size:e} is not in balance"));
    }
    if let Some(turn) = turning(scene, state)
        && exceeds(turn.abs(), BALANCE * size * scene.beam().length())
    {
        trial.wrong.push(format!("{who}: certified, but a moment of {turn:e} is not in balance"));
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

/// What loads, forces at the nodes, supports and the couples at built-in ends leave of the moment about the right end; [`None`] of
/// beam theory, which has contact between nodes, and where a couple inside the beam is not told.
fn turning(scene: &Scene, state: &ContactState) -> Option<f64> {
    let (nodes, length) = (state.nodes.as_ref()?, scene.beam().length());
    let [_, load] = resultant_and_moment(scene.load(), length, length)?;
    let contact = nodes.x.iter().zip(&nodes.contact_force).map(|(x, force)| force * (length - x));
    let mut turn = load.to_double() + contact.sum::<f64>();
    for support in &state.supports {
        turn += support.force * (length - support.at);
        turn += match support.moment {
            None => 0.0,
            Some(couple) if support.at <= 0.0 => couple,
            Some(couple) if length <= support.at => -couple,
            Some(_) => return None,
        };
    }
    Some(turn)
}

/// Nothing pulls at the nodes of a certified answer, nothing is inside the ground, and clearances are what deflections leave.
pub(super) fn lies_on_ground(trial: &mut Trial, who: &str, draft: &Draft, scene: &Scene, state: &ContactState) {
    let (Some(nodes), Some(ground)) = (&state.nodes, &draft.ground) else { return };
    let own = draft.shape.as_ref();
    let (force, size) = sizes(scene, state);
    for (i, x) in nodes.x.iter().enumerate() {
        let x = x.clamp(0.0, draft.length);
        let (depth, rise) = (ground.depth(x), own.map_or(0.0, |own| own.depth(x)));
        let clearance = depth - rise - nodes.deflection[i];
        let rounding = 1e3 * f64::EPSILON * (ground.magnitude_at(x) + own.map_or(0.0, |o| o.magnitude_at(x)));
        let off = (clearance - nodes.clearance[i]).abs();
        if exceeds(off, BALANCE * size + rounding) || exceeds(-clearance, BALANCE * size + rounding) {
            trial.wrong.push(format!("{who}: certified, but the clearance at {x} is {clearance:e}"));
            return;
        }
        if exceeds(-nodes.contact_force[i], BALANCE * force) {
            trial.wrong.push(format!("{who}: certified, but the ground pulls at {x}"));
            return;
        }
    }
}

/// No contact of a solved beam pulls, as a share of the load and of the shear beside it, whatever the forces are elsewhere.
pub(super) fn presses(trial: &mut Trial, who: &str, scene: &Scene, exact: &Exact) {
    let load = scene.load().magnitude(scene.beam().length());
    for contact in &exact.state.contacts {
        let [from, to] = contact.end_forces.unwrap_or([contact.force; 2]);
        for (x, force) in [(contact.from, from), (contact.to, to)] {
            let beside = exact.shear(x).into_iter().fold(load, |most, shear| most.max(shear.abs()));
            if exceeds(-force, THEORY * beside) {
                trial.wrong.push(format!("{who}: solved, but a contact pulls by {:e} of {beside:e} at {x}", -force));
            }
        }
    }
}

/// Every position that is said to be one of rest is above the ground.
pub(super) fn turns_above_ground(trial: &mut Trial, who: &str, scene: &Scene, exact: &Exact) {
    let Some(Motion { about, slope }) = exact.state.standing.and_then(|standing| standing.motion) else { return };
    let (length, (_, size)) = (scene.beam().length(), sizes(scene, &exact.state));
    for slope in slope.into_iter().flatten() {
        let turn = slope - exact.slope(about);
        let size = size.max(slope.abs() * length);
        for k in 0..=400 {
            let x = length * f64::from(k) / 400.0;
            if exceeds(turn * (x - about) - exact.clearance(x), THEORY * size) {
                trial.wrong.push(format!("{who}: turned to {slope:e} about {about} it is inside the ground at {x}"));
                return;
            }
        }
    }
}

/// Sizes of the terms that an energy is the sum of.
fn energy_size(scene: &Scene, state: &ContactState) -> f64 {
    let (force, deflection) = sizes(scene, state);
    let gap = |x: f64| if scene.foundation().is_some() { scene.gap(x).abs() } else { 0.0 };
    let depth = state.contacts.iter().map(|c| gap(c.from).max(gap(c.to))).fold(0.0, f64::max);
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
    raw: &Solution<()>,
    exact: Option<&Exact>,
) -> Option<Certificate> {
    let who = name(settings);
    if raw.solved {
        balanced(trial, &who, scene, &raw.state);
    }
    let nodes = raw.state.nodes.as_ref()?;
    let witness = exact.map_or_else(|| Witness::of(scene), |exact| Witness::known(scene, exact));
    let certificate = certificate(&raw.state, &witness)?;
    if certificate.gap < 0.0 || certificate.energy_upper < certificate.energy_lower {
        trial.wrong.push(format!("{who}: bounds are upside down: {certificate:?}"));
    }
    if let Some(exact) = exact.filter(|exact| exact.solved) {
        within(trial, &who, exact, &certificate, scene);
        let (_, size) = sizes(scene, &exact.state);
        let differences = nodes.x.iter().zip(&nodes.deflection).map(|(x, v)| {
            let slack = THEORY * size.max(v.abs());
            [*x, v - exact.deflection(*x), certificate.deflection_error + slack]
        });
        if let Some([x, difference, bound]) = farther_than(differences, certificate.up_to_a_turn) {
            trial.wrong.push(format!("{who}: off by {difference:e} at {x}, guaranteed are {bound:e}"));
        }
    }
    Some(certificate)
}

/// Of places, differences there and bounds on them, one that is farther off than its bound; of a beam that may turn about a place,
/// if there is no turn after which none is.
fn farther_than(differences: impl Iterator<Item = [f64; 3]>, about: Option<f64>) -> Option<[f64; 3]> {
    // The turns that the places seen so far leave.
    let mut turns = [f64::NEG_INFINITY, f64::INFINITY];
    for [x, difference, bound] in differences {
        let lever = about.map_or(0.0, |about| x - about);
        if lever == 0.0 && exceeds(difference.abs(), bound) {
            return Some([x, difference, bound]);
        }
        if lever != 0.0 {
            let [a, b] = [(difference - bound) / lever, (difference + bound) / lever];
            turns = [turns[0].max(a.min(b)), turns[1].min(a.max(b))];
        }
        if exceeds(turns[0], turns[1]) {
            return Some([x, difference, bound]);
        }
    }
    None
}

/// Two certified answers to one discrete problem.
pub(super) fn same(
    trial: &mut Trial,
    settings: &Settings,
    scene: &Scene,
    state: &ContactState,
    reference: &Solution<()>,
) {
    if !reference.solved {
        return;
    }
    let other = &reference.state;
    let (force, size) = sizes(scene, other);
    let pairs = state.supports.iter().zip(&other.supports);
    let off = pairs.fold(0.0_f64, |off, (a, b)| off.max((a.force - b.force).abs()));
    if exceeds(off, SAME * force) {
        trial.wrong.push(format!("{}: certified, but reactions are off by {:e}", name(settings), off / force));
    }
    let (Some(a), Some(b)) = (&state.nodes, &other.nodes) else { return };
    // A body is turned the more by the same force the nearer it is to turning over, and there it may have many positions.
    let margin =
        other.standing.map_or(1.0, |standing| if standing.motion.is_some() { 0.0 } else { standing.margin.max(0.0) });
    let off = a.deflection.iter().zip(&b.deflection).fold(0.0_f64, |off, (a, b)| off.max((a - b).abs()));
    // What a residual may be turns it over.
    if margin <= 10.0 * CERTIFIED_RESIDUAL {
        return;
    }
    if exceeds(margin * off, SAME * size) {
        trial.wrong.push(format!("{}: certified, but deflections are off by {:e}", name(settings), off / size));
    }
}

pub(super) fn name(settings: &Settings) -> String {
    format!("{}/{}, {} intervals", settings.method, settings.solver, settings.intervals)
}
