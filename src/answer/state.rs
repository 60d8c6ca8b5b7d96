//! The result of every method and of beam theory: the beam in its final position, with reactions and contact forces.

mod extremes;

pub use extremes::Extremes;

use crate::scene::{Resultant, Scale};

/// The reaction of a support.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct SupportForce {
    /// Position of the support \[length\].
    pub at: f64,
    /// Reaction, positive upwards; negative where the support holds the beam down \[force\].
    pub force: f64,
    /// Bending moment of the beam next to a built-in support, positive with the underside in tension \[force · length\]. Inside
    /// the beam, where it differs on the two sides, it is the moment with the larger magnitude. [`None`] for a simple support.
    pub moment: Option<f64>,
    /// The couple that a built-in support exerts: the moment to its right minus the moment to its left \[force · length\].
    #[cfg_attr(feature = "serde", serde(skip))]
    pub couple: f64,
    /// True for a compression-only support. Its reaction is zero where the beam has lifted off.
    #[cfg_attr(feature = "serde", serde(skip))]
    pub pushes_only: bool,
}

impl SupportForce {
    /// The reaction of a compression-only support.
    #[must_use]
    pub(crate) fn pushing(at: f64, force: f64) -> Self {
        Self { at, force, moment: None, couple: 0.0, pushes_only: true }
    }
}

/// The moment with the larger magnitude of the two sides of a position; the left one if rounding would decide.
pub(crate) fn larger_moment([left, right]: [f64; 2]) -> f64 {
    /// Magnitudes with a smaller relative difference count as equal: both are sums of forces times lever arms.
    const ALIKE: f64 = 1e-12;
    if (1.0 + ALIKE) * left.abs() < right.abs() { right } else { left }
}

/// The equilibrium of a beam that its supports alone do not hold.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Standing {
    /// The resultant of the loads.
    pub resultant: Resultant,
    /// Safety against overturning, from 0 to 0.5. It is the distance of the resultant from the nearer of the two outermost
    /// positions that carry or touch the beam, supports included, divided by the distance between these two. It is zero if there
    /// is only one such position. It is NaN if there is none, or if a support holds the beam down and the resultant is outside
    /// both positions.
    pub margin: f64,
    /// The other positions of equilibrium, if there is more than one.
    #[cfg_attr(feature = "serde", serde(skip_serializing_if = "Option::is_none"))]
    pub motion: Option<Motion>,
}

/// Positions of equilibrium that differ by a rotation of the whole beam. Forces, moments and energy are the same in all of them.
/// A state contains the deflection whose slope at the centre of rotation is nearest to zero.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Motion {
    /// Centre of rotation of the beam \[length\].
    pub about: f64,
    /// Smallest and greatest slope `v'` there, positive where the beam goes down to the right; [`None`] for an unlimited side.
    pub slope: [Option<f64>; 2],
}

/// Upward reactions at the two ends of the beam \[force\]; zero at an end without a support. [`ContactState::supports`] lists the
/// existing supports.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Reactions {
    /// At `x = 0`.
    pub left: f64,
    /// At `x = l`.
    pub right: f64,
}

impl Reactions {
    /// The reactions of the supports at the two ends.
    pub(crate) fn of(supports: &[SupportForce], length: f64) -> Self {
        let at = |x: f64| supports.iter().find(|s| s.at <= x && x <= s.at).map_or(0.0, |s| s.force);
        Self { left: at(0.0), right: at(length) }
    }
}

/// The kind of contact between beam and foundation.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize), serde(rename_all = "kebab-case"))]
pub enum Regime {
    /// No contact.
    None,
    /// Contact only at single points.
    Points,
    /// Contact over at least one interval.
    Zone,
}

impl Regime {
    /// The word used in the JSON output and the report.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::None => "none",
            Self::Points => "points",
            Self::Zone => "zone",
        }
    }

    /// The regime of a list of contacts.
    #[must_use]
    pub(crate) fn of(contacts: &[Contact]) -> Self {
        match contacts {
            [] => Self::None,
            _ if contacts.iter().any(|c| c.from < c.to) => Self::Zone,
            _ => Self::Points,
        }
    }
}

/// A stretch, or a single point (`from == to`), over which the foundation carries the beam.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Contact {
    /// Left end \[length\].
    pub from: f64,
    /// Right end \[length\].
    pub to: f64,
    /// Resultant contact force, upwards \[force\].
    pub force: f64,
    /// Concentrated forces at the left and right end of a contact zone \[force\]; only the grid-free solution computes them.
    pub end_forces: Option<[f64; 2]>,
}

impl Contact {
    /// A contact force at a single position.
    #[must_use]
    pub fn at(x: f64, force: f64) -> Self {
        Self { from: x, to: x, force, end_forces: None }
    }

    /// Converts a dimensionless contact to the units of its scene.
    pub(crate) fn in_units_of(self, scale: &Scale) -> Self {
        let force = |force: f64| force * scale.force;
        Self {
            from: self.from * scale.length,
            to: self.to * scale.length,
            force: force(self.force),
            end_forces: self.end_forces.map(|ends| ends.map(force)),
        }
    }
}

/// A stretch, or a single point (`from == to`), over which the beam touches the foundation or a compression-only support without
/// a contact force.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Touch {
    /// Left end \[length\].
    pub from: f64,
    /// Right end \[length\].
    pub to: f64,
}

/// The maximum pressure of an elastic foundation.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Pressure {
    /// Value \[force / length\].
    pub max: f64,
    /// Position \[length\].
    pub at: f64,
}

/// The shape of a discretised beam between its nodes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum Discretisation {
    /// Finite differences: the curvature is concentrated at the nodes, `M_i = −EI (v_{i−1} − 2 v_i + v_{i+1}) / Δ²`.
    FiniteDifferences,
    /// Beam elements: with forces only at the nodes, `M` is linear and `v` cubic between them, and both are exact.
    #[default]
    BeamElements,
}

/// Values at the nodes of a grid from left to right. An end of the beam with a support is omitted, because its deflection is
/// prescribed. For a beam with supports at both ends these are the interior nodes `x_1 … x_n`. A support inside the beam is a
/// node with its clearance and no contact force; [`ContactState::supports`] contains its reaction.
#[derive(Debug, Clone, PartialEq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Nodes {
    /// The shape of the beam between the nodes.
    #[cfg_attr(feature = "serde", serde(skip))]
    pub discretisation: Discretisation,
    /// Positions \[length\].
    pub x: Vec<f64>,
    /// Deflection `v`, positive downwards \[length\].
    pub deflection: Vec<f64>,
    /// Clearance `h = g − v` of (6) \[length\]; infinite without a foundation.
    pub clearance: Vec<f64>,
    /// Contact force, upwards; a force and not a density \[force\].
    pub contact_force: Vec<f64>,
    /// Bending moment `M = −EI v''`, positive with the underside in tension \[force · length\].
    pub moment: Vec<f64>,
}

/// The beam in its final position.
#[derive(Debug, Clone, PartialEq)]
pub struct ContactState {
    /// The kind of contact.
    pub regime: Regime,
    /// Reactions at the two ends. They include the load that a discretisation assigns to the support itself.
    pub reactions: Reactions,
    /// Reactions of all supports from left to right, including the same loads.
    pub supports: Vec<SupportForce>,
    /// The equilibrium of the beam, if its supports alone do not hold it.
    pub standing: Option<Standing>,
    /// Contacts with a contact force, from left to right.
    pub contacts: Vec<Contact>,
    /// Contacts without a contact force, from left to right; only beam theory computes them.
    pub touches: Vec<Touch>,
    /// Deflection, positive downwards \[length\].
    pub deflection: Extremes,
    /// Bending moment, positive with the underside in tension \[force · length\].
    pub moment: Extremes,
    /// `J(v) = ½∫EI v''² dx − ∫q v dx`, (17) \[force · length\]. For a discretised method, `q` are its nodal loads.
    pub energy: f64,
    /// The maximum pressure of an elastic foundation.
    pub pressure: Option<Pressure>,
    /// Values at the nodes, for a discretised method.
    pub nodes: Option<Nodes>,
}

impl Standing {
    /// The equilibrium of a beam in this state, with the resultant of its loads.
    #[must_use]
    pub(crate) fn of(state: &ContactState, resultant: Resultant, motion: Option<Motion>) -> Self {
        /// Relative accuracy of the position of a contact.
        const ROUNDING: f64 = 1e-12;
        let carries = state.supports.iter().filter(|s| !s.pushes_only || 0.0 < s.force);
        let places = carries.map(|s| [s.at; 2]).chain(state.contacts.iter().map(|c| [c.from, c.to]));
        let places = places.chain(state.touches.iter().map(|t| [t.from, t.to]));
        let [left, right] = places
            .fold([f64::INFINITY, f64::NEG_INFINITY], |[left, right], [from, to]| [left.min(from), right.max(to)]);
        let nearer = (resultant.at - left).min(right - resultant.at);
        // The result is NaN if the answer contains no position.
        let share = if left < right { nearer / (right - left) } else { 0.0 * (right - left) };
        // If the resultant is outside both positions by more than rounding, a support is in tension and the beam cannot rotate
        // about the other position.
        let margin = if share < -ROUNDING { f64::NAN } else { share.max(0.0 * share) };
        Self { resultant, margin, motion }
    }

    /// Converts dimensionless numbers to the units of the scene.
    fn in_units_of(self, scale: &Scale) -> Self {
        let Resultant { force, at } = self.resultant;
        let motion = self.motion.map(|motion| Motion {
            about: motion.about * scale.length,
            slope: motion.slope.map(|slope| slope.map(|slope| slope * scale.slope())),
        });
        Self { resultant: Resultant { force: force * scale.force, at: at * scale.length }, motion, ..self }
    }
}

impl ContactState {
    /// Compressive contacts from left to right: contacts with the foundation, and compression-only supports with a reaction.
    #[must_use]
    pub fn touched(&self) -> Vec<Contact> {
        let pushing = self.supports.iter().filter(|support| support.pushes_only && 0.0 < support.force);
        let mut all = self.contacts.clone();
        all.extend(pushing.map(|support| Contact::at(support.at, support.force)));
        all.sort_by(|a, b| a.from.total_cmp(&b.from));
        all
    }

    /// The range of the deflection along the beam \[length\], if it exceeds about a tenth of the length. The theory is linear and
    /// uses `v''` as the curvature. In a half wave with a height of a tenth of its length the slope reaches π/10, and the
    /// curvature there is `(1 + π²/100)^-3/2 = 0.87` times as large.
    #[must_use]
    pub fn large_deflection(&self, length: f64) -> Option<f64> {
        /// Relative to the length: the error of the curvature is then an eighth. The margin of a hundredth makes grid and beam
        /// theory warn alike.
        const LARGE: f64 = 0.101;
        let varies = self.deflection.max - self.deflection.min;
        (LARGE * length < varies).then_some(varies)
    }

    /// Total contact force of the foundation, upwards \[force\].
    #[must_use]
    pub fn contact_force(&self) -> f64 {
        self.contacts.iter().fold(0.0, |sum, c| sum + c.force)
    }

    /// Converts a dimensionless state to the units of its scene.
    #[must_use]
    pub(crate) fn in_units_of(self, scale: &Scale) -> Self {
        let Scale { length, depth, force } = *scale;
        // The factor is often one, and a million multiplications take time.
        let times = |values: Vec<f64>, unit: f64| match unit {
            1.0 => values,
            _ => values.into_iter().map(|v| v * unit).collect(),
        };
        let support = |s: SupportForce| SupportForce {
            at: s.at * length,
            force: s.force * force,
            moment: s.moment.map(|moment| moment * scale.moment()),
            couple: s.couple * scale.moment(),
            ..s
        };
        Self {
            regime: self.regime,
            reactions: Reactions { left: self.reactions.left * force, right: self.reactions.right * force },
            supports: self.supports.into_iter().map(support).collect(),
            standing: self.standing.map(|standing| standing.in_units_of(scale)),
            contacts: self.contacts.into_iter().map(|contact| contact.in_units_of(scale)).collect(),
            touches: self.touches.into_iter().map(|t| Touch { from: t.from * length, to: t.to * length }).collect(),
            deflection: self.deflection.in_units(depth, length),
            moment: self.moment.in_units(scale.moment(), length),
            energy: self.energy * scale.energy(),
            pressure: self.pressure.map(|p| Pressure { max: p.max * scale.pressure(), at: p.at * length }),
            nodes: self.nodes.map(|nodes| Nodes {
                discretisation: nodes.discretisation,
                x: times(nodes.x, length),
                deflection: times(nodes.deflection, depth),
                clearance: times(nodes.clearance, depth),
                contact_force: times(nodes.contact_force, force),
                moment: times(nodes.moment, scale.moment()),
            }),
        }
    }

    /// Whether reactions, contacts, extremes and energy are finite; they may overflow in the units of a scene.
    #[must_use]
    pub fn is_finite(&self) -> bool {
        let Self { reactions, deflection, moment, energy, .. } = self;
        let numbers =
            [reactions.left, reactions.right, deflection.max, deflection.min, moment.max, moment.min, *energy];
        let contacts = self.contacts.iter().flat_map(|c| [c.from, c.to, c.force]);
        let supports = self.supports.iter().flat_map(|s| [s.force, s.moment.unwrap_or(0.0)]);
        numbers.into_iter().chain(contacts).chain(supports).all(f64::is_finite)
    }
}

#[cfg(test)]
mod tests {
    use super::Extremes;

    fn check(values: &[(f64, f64)], expected: [f64; 4]) {
        let Extremes { max, max_at, min, min_at } = Extremes::of(values.iter().copied());
        assert_eq!([max, max_at, min, min_at].map(f64::to_bits), expected.map(f64::to_bits), "{values:?}");
    }

    #[test]
    fn of_mirror_images_the_left_one_is_named() {
        check(&[(0.0, -1.0), (1.0, 2.0), (2.0, 0.5), (3.0, 2.0 + 1e-15)], [2.0 + 1e-15, 1.0, -1.0, 0.0]);
    }

    #[test]
    fn of_a_stretch_the_middle_is_named() {
        check(&[(0.0, 0.0), (2.0, 1.0), (4.0, 1.0), (9.0, -1e-17)], [1.0, 3.0, 0.0, 0.0]);
    }

    #[test]
    fn nothing_is_zero_at_zero() {
        check(&[], [0.0; 4]);
    }
}
