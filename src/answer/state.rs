//! The result of every method, and of theory: the beam in its final position, and the forces that hold it there.

mod extremes;

pub use extremes::Extremes;

use crate::scene::{Resultant, Scale};

/// The force with which a support holds the beam.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct SupportForce {
    /// Where the support is \[length\].
    pub at: f64,
    /// Upwards; negative where the support holds the beam down \[force\].
    pub force: f64,
    /// Bending moment of the beam beside a built-in support, positive with the underside in tension; inside the beam, where the
    /// two sides differ, the one that is larger in magnitude. [`None`] for a simple support \[force · length\].
    pub moment: Option<f64>,
    /// The couple that a built-in support exerts: the moment to its right less that to its left \[force · length\].
    #[cfg_attr(feature = "serde", serde(skip))]
    pub couple: f64,
    /// True if it only pushes: its force is zero where the beam has lifted off.
    #[cfg_attr(feature = "serde", serde(skip))]
    pub pushes_only: bool,
}

impl SupportForce {
    /// That of a support that only pushes.
    #[must_use]
    pub(crate) fn pushing(at: f64, force: f64) -> Self {
        Self { at, force, moment: None, couple: 0.0, pushes_only: true }
    }
}

/// Of the moments on both sides of a place the one that is larger in magnitude, and the left one where rounding would decide.
pub(crate) fn larger_moment([left, right]: [f64; 2]) -> f64 {
    /// Magnitudes that differ by this share of themselves are one: both are sums of forces times levers.
    const ALIKE: f64 = 1e-12;
    if (1.0 + ALIKE) * left.abs() < right.abs() { right } else { left }
}

/// How a beam stands on the ground that its supports do not hold against turning or moving.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Standing {
    /// The resultant of its loads.
    pub resultant: Resultant,
    /// Safety against overturning: the distance of the resultant from the nearer one of the two outermost places that carry or touch
    /// the beam, supports included, as a share of the distance of these two: from 0 to 0.5. Zero if there is only one place, not a number
    /// if there is none, or if a support holds the beam down and the resultant lies beyond both.
    pub margin: f64,
    /// The positions that are left, if there is more than one.
    #[cfg_attr(feature = "serde", serde(skip_serializing_if = "Option::is_none"))]
    pub motion: Option<Motion>,
}

/// Positions of rest that differ by a rotation of the whole beam. Forces, moments and energy are the same in all of them; a state
/// has the deflection whose slope at the place of rotation is nearest to zero.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Motion {
    /// The place about which the beam turns \[length\].
    pub about: f64,
    /// Least and greatest slope `v'` there, positive where the beam goes down to the right; [`None`] for a side without end.
    pub slope: [Option<f64>; 2],
}

/// Upward forces of the supports at the two ends of the beam \[force\]. Zero where an end has none: [`ContactState::supports`] says
/// which supports there are.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Reactions {
    /// At `x = 0`.
    pub left: f64,
    /// At `x = l`.
    pub right: f64,
}

impl Reactions {
    /// Of those supports of a beam that stand at its ends.
    pub(crate) fn of(supports: &[SupportForce], length: f64) -> Self {
        let at = |x: f64| supports.iter().find(|s| s.at <= x && x <= s.at).map_or(0.0, |s| s.force);
        Self { left: at(0.0), right: at(length) }
    }
}

/// How much of the foundation the beam touches.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize), serde(rename_all = "kebab-case"))]
pub enum Regime {
    /// Nowhere.
    None,
    /// At single points only.
    Points,
    /// Over at least one interval.
    Zone,
}

impl Regime {
    /// The word that the JSON and the report use.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::None => "none",
            Self::Points => "points",
            Self::Zone => "zone",
        }
    }

    /// The regime that a list of contacts makes.
    #[must_use]
    pub(crate) fn of(contacts: &[Contact]) -> Self {
        match contacts {
            [] => Self::None,
            _ if contacts.iter().any(|c| c.from < c.to) => Self::Zone,
            _ => Self::Points,
        }
    }
}

/// A stretch, or a single point (`from == to`), at which the foundation carries the beam.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Contact {
    /// Left end \[length\].
    pub from: f64,
    /// Right end \[length\].
    pub to: f64,
    /// Resultant, upwards \[force\].
    pub force: f64,
    /// Concentrated forces at the left and right end of a zone \[force\]; only the exact method has them.
    pub end_forces: Option<[f64; 2]>,
}

impl Contact {
    /// A force at a single place.
    #[must_use]
    pub fn at(x: f64, force: f64) -> Self {
        Self { from: x, to: x, force, end_forces: None }
    }

    /// A dimensionless contact in the units of its scene, forces being so many times what they are here.
    pub(crate) fn in_units(self, scale: &Scale, times: f64) -> Self {
        let force = |force: f64| force * times * scale.force;
        Self {
            from: self.from * scale.length,
            to: self.to * scale.length,
            force: force(self.force),
            end_forces: self.end_forces.map(|ends| ends.map(force)),
        }
    }
}

/// A stretch, or a single point (`from == to`), over which the beam lies on the foundation, or on a support that only pushes, without a
/// force between them.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Touch {
    /// Left end \[length\].
    pub from: f64,
    /// Right end \[length\].
    pub to: f64,
}

/// The largest pressure of ground that gives.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Pressure {
    /// How large \[force / length\].
    pub max: f64,
    /// Where it is \[length\].
    pub at: f64,
}

/// How a discretised beam bends between its nodes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum Discretisation {
    /// Finite differences: curvature sits at the nodes, `M_i = −EI (v_{i−1} − 2 v_i + v_{i+1}) / Δ²`.
    FiniteDifferences,
    /// Beam elements: with forces at the nodes only, `M` is linear and `v` cubic between them, and both are exact.
    #[default]
    BeamElements,
}

/// Values at the nodes of a grid from left to right: at all of them but an end of the beam that a support holds, where the
/// deflection is that of the support. Of a beam with supports at both ends these are the interior nodes `x_1 … x_n`. A support
/// inside the beam is a node with its clearance and no contact force; what it carries is in [`ContactState::supports`].
#[derive(Debug, Clone, PartialEq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Nodes {
    /// How the beam bends between them.
    #[cfg_attr(feature = "serde", serde(skip))]
    pub discretisation: Discretisation,
    /// Places \[length\].
    pub x: Vec<f64>,
    /// Deflection `v`, positive downwards \[length\].
    pub deflection: Vec<f64>,
    /// Clearance `h = g − v` of (6) \[length\]; infinite where there is no foundation.
    pub clearance: Vec<f64>,
    /// Contact force, upwards, a force and not a density \[force\].
    pub contact_force: Vec<f64>,
    /// Bending moment `M = −EI v''`, positive with the underside in tension \[force · length\].
    pub moment: Vec<f64>,
}

/// The beam in its final position.
#[derive(Debug, Clone, PartialEq)]
pub struct ContactState {
    /// How much it touches.
    pub regime: Regime,
    /// Forces of the supports at the two ends, with the load that a discretisation puts on the support itself counted in.
    pub reactions: Reactions,
    /// Forces of all supports from left to right, counted in the same way.
    pub supports: Vec<SupportForce>,
    /// How the beam stands, if its supports do not hold it.
    pub standing: Option<Standing>,
    /// Where the foundation presses against it, from left to right.
    pub contacts: Vec<Contact>,
    /// Where it lies on the rigid foundation without pressing, from left to right; beam theory alone knows.
    pub touches: Vec<Touch>,
    /// Deflection, positive downwards \[length\].
    pub deflection: Extremes,
    /// Bending moment, positive with the underside in tension \[force · length\].
    pub moment: Extremes,
    /// `J(v) = ½∫EI v''² dx − ∫q v dx`, (17) \[force · length\]. A discretised method has its nodal loads for `q`.
    pub energy: f64,
    /// The largest pressure, on ground that gives.
    pub pressure: Option<Pressure>,
    /// Values at the nodes, for a discretised method.
    pub nodes: Option<Nodes>,
}

impl Standing {
    /// How a beam in this state stands, with the resultant of its loads.
    #[must_use]
    pub(crate) fn of(state: &ContactState, resultant: Resultant, motion: Option<Motion>) -> Self {
        /// The digits that the place of a contact has.
        const ROUNDING: f64 = 1e-12;
        let carries = state.supports.iter().filter(|s| !s.pushes_only || 0.0 < s.force);
        let places = carries.map(|s| [s.at; 2]).chain(state.contacts.iter().map(|c| [c.from, c.to]));
        let places = places.chain(state.touches.iter().map(|t| [t.from, t.to]));
        let [left, right] = places
            .fold([f64::INFINITY, f64::NEG_INFINITY], |[left, right], [from, to]| [left.min(from), right.max(to)]);
        let nearer = (resultant.at - left).min(right - resultant.at);
        // Of an answer without numbers no place is known.
        let share = if left < right { nearer / (right - left) } else { 0.0 * (right - left) };
        // Beyond both by more than rounding, a support pulls, and the beam cannot turn about the other place.
        let margin = if share < -ROUNDING { f64::NAN } else { share.max(0.0 * share) };
        Self { resultant, margin, motion }
    }

    /// From dimensionless numbers to the units of the scene.
    fn in_units_of(self, scale: &Scale) -> Self {
        let Resultant { force, at } = self.resultant;
        let motion = self.motion.map(|motion| Motion {
            about: motion.about * scale.length,
            slope: motion.slope.map(|slope| slope.map(|slope| slope * (scale.depth / scale.length))),
        });
        Self { resultant: Resultant { force: force * scale.force, at: at * scale.length }, motion, ..self }
    }
}

impl ContactState {
    /// Where the beam rests without being held, from left to right: its contacts with the ground, and the supports that only push and
    /// have a force.
    #[must_use]
    pub fn touched(&self) -> Vec<Contact> {
        let pushing = self.supports.iter().filter(|support| support.pushes_only && 0.0 < support.force);
        let mut all = self.contacts.clone();
        all.extend(pushing.map(|support| Contact::at(support.at, support.force)));
        all.sort_by(|a, b| a.from.total_cmp(&b.from));
        all
    }

    /// By how much the deflection varies along the beam, if that is more than a tenth of its length: the theory is linear, and takes
    /// `v''` for the curvature. Along half a wave as high as a tenth of its length the slope reaches π/10, and the curvature there is
    /// `(1 + π²/100)^-3/2 = 0.87` times as large \[length\].
    #[must_use]
    pub fn large_deflection(&self, length: f64) -> Option<f64> {
        /// Of the length: the curvature is then off by an eighth. A hundredth more, so that a grid warns of what the beam does.
        const LARGE: f64 = 0.101;
        let varies = self.deflection.max - self.deflection.min;
        (LARGE * length < varies).then_some(varies)
    }

    /// Resultant of all contacts with the ground, upwards \[force\].
    #[must_use]
    pub fn contact_force(&self) -> f64 {
        self.contacts.iter().fold(0.0, |sum, c| sum + c.force)
    }

    /// A dimensionless state in the units of its scene. All factors are powers of two: only exponents change.
    #[must_use]
    pub(crate) fn in_units_of(self, scale: &Scale) -> Self {
        let Scale { length, depth, force } = *scale;
        // A unit of one is frequent, and a million products are not free.
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
            contacts: self.contacts.into_iter().map(|contact| contact.in_units(scale, 1.0)).collect(),
            touches: self.touches.into_iter().map(|t| Touch { from: t.from * length, to: t.to * length }).collect(),
            deflection: self.deflection.in_units(depth, length),
            moment: self.moment.in_units(scale.moment(), length),
            energy: self.energy * scale.energy(),
            pressure: self.pressure.map(|p| Pressure { max: p.max * (force / length), at: p.at * length }),
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

    /// Whether reactions, contacts, extremes and energy are numbers: in the units of a scene they may overflow.
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
