//! The numbers in the summary of an answer, and the error bound of each from its bracket in the certificate.

use std::fmt;

use super::Refusal;
use crate::certificate::Certificate;
use crate::scene::Scene;
use crate::state::ContactState;

/// Rounding of the numbers of an answer, as a share of the largest of them: the last digits may be off by this much in addition to
/// the error bound.
const ROUNDING: f64 = 1e-12;

/// Rounding error of loads or levels that cancel, as a share of them: sixteen units in the last place.
const LAST_DIGITS: f64 = 16.0 * f64::EPSILON;

/// The same as [`ROUNDING`] for the energy: positions and forces with twelve digits leave nine digits of a sum whose terms may cancel.
pub(super) const ENERGY: f64 = 1e-9;

/// A number in the summary of an answer, which has a bracket in the certificate.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Number {
    /// The reaction of a support, counted from the left, from 0.
    Support(usize),
    /// The total contact force.
    ContactForce,
    /// The greatest deflection.
    Deflection,
    /// The energy.
    Energy,
    /// The greatest or the least moment of beam theory, which has to be in its bracket, however wide the bracket is.
    Moment,
}

impl Number {
    /// The quantity that the error is a share of. A load that acts directly on a support does not count towards the largest reaction.
    /// The contact force is the load minus the reactions, so it is known no better than they are.
    pub(super) fn kind(self) -> &'static str {
        match self {
            Self::Support(_) => "the largest reaction",
            Self::ContactForce => "the largest force",
            Self::Deflection => "the largest deflection",
            Self::Energy => "its value",
            Self::Moment => "the largest moment",
        }
    }
}

impl fmt::Display for Number {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Support(k) => write!(f, "the force of support {}", k + 1),
            Self::ContactForce => f.write_str("the contact force"),
            Self::Deflection => f.write_str("the greatest deflection"),
            Self::Energy => f.write_str("the energy"),
            Self::Moment => f.write_str("a moment"),
        }
    }
}

/// Whether beam and answer are both proven to be at rest, or to be straight apart from a rotation. A share of zero is undefined.
pub(super) fn is_unbent(certificate: &Certificate) -> bool {
    certificate.at_rest || certificate.deflection_error <= 0.0
}

/// Rounding of the moments of the loads. The moments of a beam at rest add up to this instead of zero.
fn moment_rounding(scene: &Scene) -> f64 {
    let length = scene.beam().length();
    LAST_DIGITS * scene.load().magnitude(length) * length
}

/// Rounding of the forces caused by support levels, `48 EI v / l³`. The forces of a beam that is straight between its supports add up
/// to this instead of zero.
fn force_rounding(scene: &Scene, state: &ContactState) -> f64 {
    let length = scene.beam().length();
    let bent = 48.0 * state.deflection.magnitude() / length * scene.beam().bending_stiffness() / length / length;
    LAST_DIGITS * bent
}

/// Rounding of the largest deflection. A beam at rest deflects by the rounding of what its loads alone would cause, `P l³ / 48 EI`.
/// The smallest positive number covers rounding outwards at zero.
pub(super) fn deflection_rounding(scene: &Scene, state: &ContactState) -> f64 {
    let (length, stiffness) = (scene.beam().length(), scene.beam().bending_stiffness());
    let free = moment_rounding(scene) / stiffness * length * length / 48.0;
    ROUNDING * state.deflection.magnitude() + free + as_built(scene, state) + f64::MIN_POSITIVE
}

/// For a beam that rests in its initial shape within rounding: the rounding of its supports, from the terms that add up to the depth of
/// the initial shape there, and from their levels. Zero for any other beam.
fn as_built(scene: &Scene, state: &ContactState) -> f64 {
    let Some(shape) = scene.beam().shape() else { return 0.0 };
    let supports = scene.beam().all_supports();
    let size = supports.iter().map(|support| shape.magnitude_at(support.at) + support.level.abs());
    let rounding = f64::EPSILON * size.fold(0.0, f64::max);
    if state.deflection.magnitude() <= rounding { rounding } else { 0.0 }
}

/// Whether an error is only this rounding.
pub(super) fn rests_as_built(scene: &Scene, state: &ContactState, error: f64) -> bool {
    let rounding = as_built(scene, state);
    0.0 < rounding && error <= rounding
}

/// The error bound of each number in the summary, over the largest value of that quantity.
pub(super) fn shares<'a>(
    certificate: &'a Certificate,
    scene: &Scene,
    state: &'a ContactState,
) -> impl Iterator<Item = (Number, f64)> + 'a {
    let share = |own: f64, bracket: Option<[f64; 2]>, rounding: f64, largest: f64| {
        let Some([least, most]) = bracket else { return f64::INFINITY };
        let off = (most - own).max(own - least);
        if off <= rounding { 0.0 } else { off / largest }
    };
    // A load directly on a support is known exactly. It hides nothing of the beam's own reaction except the last digits of the sum.
    let forces: Vec<f64> = state.supports.iter().map(|s| (s.force - scene.standing_on(s.at)).abs()).collect();
    let contact = state.contact_force();
    // The force that an error of the supports by this rounding causes: `48 EI v / l³`.
    let (length, built) = (scene.beam().length(), as_built(scene, state));
    let pushed = 48.0 * built / length * scene.beam().bending_stiffness() / length / length;
    let sum = scene.bending_load().magnitude(scene.beam().length()) + forces.iter().sum::<f64>() + contact;
    let rounding = ROUNDING * sum + force_rounding(scene, state) + pushed;
    let largest = forces.into_iter().fold(0.0, f64::max);
    let brackets = state.supports.iter().zip(&certificate.reactions).enumerate();
    let supports = brackets.map(move |(k, (support, bracket))| {
        let last_digits = 4.0 * f64::EPSILON * support.force.abs();
        (Number::Support(k), share(support.force, *bracket, rounding + last_digits, largest))
    });
    let Certificate { energy_lower, energy_upper, contact_force, deflection_max, .. } = *certificate;
    let of_energy = ENERGY * energy_size(scene, state) + pushed * built;
    let energy = share(state.energy, Some([energy_lower, energy_upper]), of_energy, state.energy.abs());
    let v = &state.deflection;
    let deflection = share(v.max, deflection_max, deflection_rounding(scene, state), v.magnitude());
    let at_rest = if is_unbent(certificate) { moment_rounding(scene) } else { 0.0 };
    let (m, of_moments) = (&state.moment, ENERGY * state.moment.magnitude() + at_rest + pushed * length);
    let [greatest, least] = certificate.moments_beside(state).unwrap_or([None; 2]);
    let outside = |own: f64, bracket: Option<[f64; 2]>| {
        let off = bracket.map_or(0.0, |[least, most]| (least - own).max(own - most));
        if off <= of_moments { 0.0 } else { off / m.magnitude() }
    };
    let others = [
        (Number::ContactForce, share(contact, contact_force, rounding, largest.max(contact))),
        (Number::Energy, energy),
        (Number::Moment, outside(m.max, greatest)),
        (Number::Moment, outside(m.min, least)),
        // If the beam can rotate, no position is the right one.
        (Number::Deflection, if certificate.up_to_a_turn.is_some() { 0.0 } else { deflection }),
    ];
    supports.chain(others)
}

/// The size of the terms that add up to the energy: loads times deflections, and contact forces times gaps.
pub(super) fn energy_size(scene: &Scene, state: &ContactState) -> f64 {
    let depth = |x: f64| scene.gap(x).abs();
    let held: f64 = state.touched().iter().map(|c| c.force.abs() * depth(c.from).max(depth(c.to))).sum();
    scene.load().magnitude(scene.beam().length()) * state.deflection.magnitude() + held
}

/// The difference between the largest deflection of an exact answer and the judged one, which its contacts imply; zero for a beam
/// that can rotate, because any rotated position is as good.
pub(super) fn apart(certificate: &Certificate, own: f64) -> f64 {
    let Certificate { deflection: judged, deflection_at_least: least, up_to_a_turn, .. } = *certificate;
    let known = up_to_a_turn.is_none() && judged.is_finite();
    if known { (least - own).max(own - judged).max(0.0) } else { 0.0 }
}

/// The flaw of a certificate itself, if it has one.
pub(super) fn flaw(certificate: &Certificate) -> Option<Refusal> {
    let Certificate { energy_lower: lower, energy_upper: upper, gap, deflection_error, .. } = *certificate;
    if ![lower, upper, gap, deflection_error].iter().all(|bound| bound.is_finite()) {
        return Some(Refusal::Unbounded);
    }
    let holds = lower <= upper && 0.0 <= gap && 0.0 <= deflection_error;
    (!holds).then_some(Refusal::Contradiction { lower, upper, gap })
}
