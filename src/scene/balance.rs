//! Rigid-body motions that the supports leave free, and whether loads and foundation balance them.
//!
//! One built-in support or any two bilateral supports hold the beam. With fewer, only compressive contact can balance the loads:
//! a foundation, which reaches from `a = 0` to `b = l` if it is rigid, and compression-only supports. `a` and `b` are the
//! outermost positions of contact.
//!
//! | bilateral supports | a solution exists if and only if |
//! |---|---|
//! | none | `W > 0` and `a ≤ x_W ≤ b`: the moments `∫q (x − a)` and `∫q (b − x)` are not negative |
//! | one simple, at `x_s` | `∫q (x − x_s) > 0` with contact possible to the right of it, `< 0` with contact to the left, or `= 0` |
//!
//! With hinges, the loads must not move any part upwards or into an opening without end (`hinged`).
//! Under tension, `∫ N v'²/2` prevents rotation. One bilateral support is then enough, and without any `W > 0` is enough.
//!
//! `W = ∫q` is the resultant of the loads and `x_W = ∫q x / W` its position (Fichera 1964: a semi-coercive variational
//! inequality). Each of these sums is an interval, because loads and positions are decimal numbers, known to half a unit in their
//! last place. The sums themselves are computed in twice the precision. If the interval contains zero, the loads are balanced
//! within rounding, and the direction in which the beam would rotate remains open. Where an elastic foundation or support would
//! carry the loads alone in such a limiting case, the scene is rejected ([`Unheld::OnBorder`]) unless other contacts prevent
//! rotation.

mod hinged;
mod sum;

use std::cmp::Ordering;

use sum::Sum;

use super::written::{as_written, beside, carriers, fulcrum, rounded};
use super::{Foundation, Scale, Scene, Support};

/// The resultant of all loads.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Resultant {
    /// `W`, positive downwards \[force\].
    pub force: f64,
    /// Its position `x_W` \[length\]; not finite if `W` is zero.
    pub at: f64,
}

/// The motions that the supports leave free.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Balance {
    /// None: the supports hold the beam.
    Held,
    /// The beam can rotate or lift off, and compressive contact balances the loads.
    Stands(Resultant),
    /// Within rounding, the resultant is exactly above a position about which the beam could rotate: an end of the foundation,
    /// the only support, or a corner of the foundation on which the beam may rest alone. If the beam rests there alone, the
    /// forces are determined. The position of the beam is determined only if other contacts hold it too.
    Neutral {
        /// The resultant of the loads.
        resultant: Resultant,
        /// The position about which the beam could rotate \[length\].
        about: f64,
    },
}

/// The reason why the loads are not balanced.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum Unheld {
    /// The resultant is outside the foundation.
    #[error(
        "the loads have their resultant {} at x = {}, outside {}: the beam turns over {}",
        rounded(*force),
        beside(*at, *ends),
        carriers(*grounded, *ends),
        fulcrum(*grounded, *ends, *at)
    )]
    Overturns {
        /// The resultant, positive downwards \[force\].
        force: f64,
        /// Its position \[length\].
        at: f64,
        /// Whether there is a foundation.
        grounded: bool,
        /// The outermost positions that can carry the beam \[length\].
        ends: [f64; 2],
    },
    /// The resultant of the loads acts upwards.
    #[error("the loads pull upwards by {}: nothing holds the beam down", rounded(*force))]
    PulledUp {
        /// The resultant, positive upwards \[force\].
        force: f64,
    },
    /// The loads rotate the beam without pressing it down.
    #[error("the loads have no resultant, but a couple of {}: nothing keeps the beam from turning", rounded(*moment))]
    Couple {
        /// Its magnitude \[force · length\].
        moment: f64,
    },
    /// The resultant is above the only position about which the beam can rotate, and the foundation or support there is elastic.
    #[error(
        "the loads have their resultant {} at x = {}, above the one place that could carry them alone: on what gives no position is \
         known to be one of rest",
        rounded(*force),
        as_written(*at)
    )]
    OnBorder {
        /// The resultant, positive downwards \[force\].
        force: f64,
        /// Its position \[length\].
        at: f64,
    },
    /// There is no load, or the loads balance each other.
    #[error("no load presses on the beam: any position is one of rest")]
    NothingPresses,
    /// Hinges make the beam a mechanism, and there is no foundation below it.
    #[error("the beam is a mechanism: its hinges let it move without bending, and there is no foundation to stop it")]
    Mechanism,
    /// The loads turn the part beyond a hinge about it.
    #[error(
        "the loads turn the part of the beam to the {} of its hinge at x = {} {} about it, with a moment of {}: nothing {}",
        if *right { "right" } else { "left" },
        as_written(*hinge),
        if *up { "up" } else { "down" },
        rounded(*moment),
        if *up { "holds it down" } else { "is below it" }
    )]
    Turned {
        /// The hinge \[length\].
        hinge: f64,
        /// The moment of the loads about it \[force · length\].
        moment: f64,
        /// Whether the part is on the right of the hinge.
        right: bool,
        /// Whether it turns up; down is possible where there is no foundation.
        up: bool,
    },
    /// The loads move one or more parts between hinges.
    #[error(
        "the loads move the beam between x = {} and x = {} {}: its hinges let it, and nothing {}",
        as_written(*from),
        as_written(*to),
        if *up { "up" } else { "down" },
        if *up { "holds it down there" } else { "is below it there" }
    )]
    Moved {
        /// Start of the part \[length\].
        from: f64,
        /// End of the part \[length\].
        to: f64,
        /// Whether it moves up; down is possible where there is no foundation.
        up: bool,
    },
    /// There are neither supports nor a foundation.
    #[error("there is neither a support nor a foundation: nothing carries the beam")]
    NothingCarries,
    /// There is one simple support, and no contact on the side to which the beam rotates.
    #[error(
        "there is no {}: nothing keeps the beam from turning about its support at x = {}, with a moment of {}",
        match (grounded, 0.0 < *moment) {
            (false, _) => "foundation",
            (true, true) => "ground to the right of the support",
            (true, false) => "ground to the left of the support",
        },
        as_written(*at),
        rounded(*moment)
    )]
    Turns {
        /// True if there is any other compressive contact.
        grounded: bool,
        /// Position of the support \[length\].
        at: f64,
        /// The moment of the loads about the support, positive clockwise \[force · length\].
        moment: f64,
    },
}

impl Balance {
    /// Determines the free motions of a dimensionless scene.
    ///
    /// # Errors
    ///
    /// [`Unheld`] if nothing balances the loads.
    pub(super) fn of(scene: &Scene) -> Result<Self, Unheld> {
        if 0.0 < scene.beam().tension() {
            return Self::in_tension(scene);
        }
        // Checks for a mechanism without a foundation, with compression-only supports counted as bilateral ones.
        let beam = scene.beam();
        let moves = || beam.is_mechanism(beam.holding().chain(pushing(scene)));
        match scene.foundation() {
            None if beam.is_hinged() && moves() => Self::of_supports(scene).and(Err(Unheld::Mechanism)),
            _ if beam.is_hinged() => {
                Self::of_supports(scene).and_then(|balance| hinged::check_parts(scene).map(|()| balance))
            }
            _ => Self::of_supports(scene),
        }
    }

    /// The balance under tension. Tension prevents rotation for every position of the resultant, and it holds all parts between
    /// hinges.
    fn in_tension(scene: &Scene) -> Result<Self, Unheld> {
        if scene.beam().holding().next().is_some() {
            return Ok(Self::Held);
        }
        let force = Sum::of_forces(scene);
        match force.sign() {
            _ if ends(scene).is_none() => Err(Unheld::NothingCarries),
            Ordering::Greater => Ok(Self::Stands(resultant(scene))),
            Ordering::Equal => Err(Unheld::NothingPresses),
            Ordering::Less => Err(Unheld::PulledUp { force: -force.value() }),
        }
    }

    /// The balance without regard to hinges and axial force.
    fn of_supports(scene: &Scene) -> Result<Self, Unheld> {
        let beam = scene.beam();
        match beam.holding().next() {
            None => Self::of_free(scene),
            Some(support) if !beam.is_held() => Self::about(scene, support),
            Some(_) => Ok(Self::Held),
        }
    }

    /// The balance without bilateral supports.
    fn of_free(scene: &Scene) -> Result<Self, Unheld> {
        let springs = scene.ground_stiffness().is_some();
        let Some(ends) = ends(scene) else { return Err(Unheld::NothingCarries) };
        // Positive if the resultant is on the inner side of the left and of the right end.
        let [left, right] = [Sum::of_moments(scene, ends[0]), Sum::of_moments(scene, ends[1]).negated()];
        let overturns = |force, at| Unheld::Overturns { force, at, grounded: scene.foundation().is_some(), ends };
        let (force, Resultant { force: weight, at }) = (Sum::of_forces(scene), resultant(scene));
        match (left.sign(), right.sign()) {
            // If only one position carries the beam, both have opposite signs or both are zero.
            (Ordering::Equal, Ordering::Equal) if force.sign() == Ordering::Greater => {
                if gives(scene, ends[0]) {
                    return Err(Unheld::OnBorder { force: weight, at });
                }
                Ok(Self::Neutral { resultant: resultant(scene), about: ends[0] })
            }
            (Ordering::Equal, Ordering::Equal) if force.sign() == Ordering::Less => {
                Err(Unheld::PulledUp { force: -weight })
            }
            (Ordering::Equal, Ordering::Equal) => Err(Unheld::NothingPresses),
            (Ordering::Less, Ordering::Less) => Err(Unheld::PulledUp { force: -weight }),
            _ if force.sign() == Ordering::Less => Err(Unheld::PulledUp { force: -weight }),
            (Ordering::Less, _) | (_, Ordering::Less) if force.sign() == Ordering::Equal => {
                Err(Unheld::Couple { moment: left.value().abs() })
            }
            (Ordering::Less, _) | (_, Ordering::Less) => Err(overturns(weight, at)),
            (Ordering::Equal, _) if gives(scene, ends[0]) => Err(Unheld::OnBorder { force: weight, at }),
            (_, Ordering::Equal) if gives(scene, ends[1]) => Err(Unheld::OnBorder { force: weight, at }),
            (Ordering::Equal, _) => Ok(Self::Neutral { resultant: resultant(scene), about: ends[0] }),
            (_, Ordering::Equal) => Ok(Self::Neutral { resultant: resultant(scene), about: ends[1] }),
            (Ordering::Greater, Ordering::Greater) => {
                let is_border = |bearing: &&Support| Sum::of_moments(scene, bearing.at).sign() == Ordering::Equal;
                let turns = |bearing: &Support| gives(scene, bearing.at) && !braced(scene, bearing);
                if pushing(scene).filter(is_border).any(turns) {
                    return Err(Unheld::OnBorder { force: weight, at });
                }
                // An elastic foundation carries no force at a single position.
                let there = |x: f64| !springs && Sum::of_moments(scene, x).sign() == Ordering::Equal;
                let (resultant, about) = (resultant(scene), corner(scene, at, there));
                Ok(about.map_or(Self::Stands(resultant), |about| Self::Neutral { resultant, about }))
            }
        }
    }

    /// The balance on one simple support.
    fn about(scene: &Scene, support: &Support) -> Result<Self, Unheld> {
        let (gives, ends) = (gives(scene, support.at), ends(scene));
        let turn = Sum::of_moments(scene, support.at);
        match turn.sign() {
            Ordering::Equal if gives && braced(scene, support) => Ok(Self::Stands(resultant(scene))),
            Ordering::Equal if gives => Err(Unheld::OnBorder { force: Sum::of_forces(scene).value(), at: support.at }),
            Ordering::Equal => Ok(Self::Neutral { resultant: resultant(scene), about: support.at }),
            Ordering::Greater if ends.is_some_and(|ends| support.at < ends[1]) => Ok(Self::Stands(resultant(scene))),
            Ordering::Less if ends.is_some_and(|ends| ends[0] < support.at) => Ok(Self::Stands(resultant(scene))),
            _ => Err(Unheld::Turns { grounded: ends.is_some(), at: support.at, moment: turn.value() }),
        }
    }

    /// The resultant of the loads if the supports do not hold the beam.
    #[must_use]
    pub fn resultant(&self) -> Option<Resultant> {
        match *self {
            Self::Held => None,
            Self::Stands(resultant) | Self::Neutral { resultant, .. } => Some(resultant),
        }
    }

    /// Converts dimensionless numbers to the units of the scene.
    #[must_use]
    pub fn in_units_of(self, scale: &Scale) -> Self {
        let units = |r: Resultant| Resultant { force: r.force * scale.force, at: r.at * scale.length };
        match self {
            Self::Held => Self::Held,
            Self::Stands(resultant) => Self::Stands(units(resultant)),
            Self::Neutral { resultant, about } => {
                Self::Neutral { resultant: units(resultant), about: about * scale.length }
            }
        }
    }
}

/// The outermost positions that can carry a beam without bilateral supports: ends of the foundation and compression-only
/// supports.
fn ends(scene: &Scene) -> Option<[f64; 2]> {
    let places = || pushing(scene).map(|support| support.at);
    let outermost = places().reduce(f64::min).zip(places().reduce(f64::max)).map(|(first, last)| [first, last]);
    match (scene.ground_ends(), outermost) {
        (Some(ground), Some(pushing)) => Some([ground[0].min(pushing[0]), ground[1].max(pushing[1])]),
        (ground, pushing) => ground.or(pushing),
    }
}

/// All compression-only supports, rigid and elastic.
fn pushing(scene: &Scene) -> impl Iterator<Item = &Support> {
    scene.beam().bearings().iter().chain(scene.beam().springs().iter().filter(|support| support.pushes_only))
}

/// Whether the contact at a position is elastic: the foundation, or the support there.
fn gives(scene: &Scene, at: f64) -> bool {
    scene.ground_stiffness().is_some() || scene.beam().springs().iter().any(|spring| spring.at.total_cmp(&at).is_eq())
}

/// Whether other contacts may prevent rotation about a support: compression-only supports on both sides, a rigid foundation, or
/// an elastic foundation on both sides that begins at the level of the support or above it.
fn braced(scene: &Scene, about: &Support) -> bool {
    let any = |beside: &dyn Fn(&Support) -> bool| pushing(scene).any(beside);
    let is_between = any(&|bearing| bearing.at < about.at) && any(&|bearing| about.at < bearing.at);
    let beside = || scene.is_grounded_beside(about.at) == [true; 2] && scene.depth(about.at) <= about.level;
    is_between
        || scene.foundation().is_some() && scene.ground_stiffness().is_none()
        || scene.ground_stiffness().is_some() && beside()
}

/// The resultant of the loads; its position is not a finite number if the loads have no resultant force.
fn resultant(scene: &Scene) -> Resultant {
    let force = Sum::of_forces(scene).value();
    Resultant { force, at: Sum::of_moments(scene, 0.0).value() / force }
}

impl Unheld {
    /// Converts dimensionless numbers to the units of the scene.
    pub(super) fn in_units_of(self, scale: &Scale) -> Self {
        match self {
            Self::Overturns { force, at, grounded, ends } => {
                let ends = ends.map(|end| end * scale.length);
                Self::Overturns { force: force * scale.force, at: at * scale.length, grounded, ends }
            }
            Self::OnBorder { force, at } => Self::OnBorder { force: force * scale.force, at: at * scale.length },
            Self::PulledUp { force } => Self::PulledUp { force: force * scale.force },
            Self::Couple { moment } => Self::Couple { moment: moment * scale.moment() },
            Self::Turns { grounded, at, moment } => {
                Self::Turns { grounded, at: at * scale.length, moment: moment * scale.moment() }
            }
            Self::Turned { hinge, moment, right, up } => {
                Self::Turned { hinge: hinge * scale.length, moment: moment * scale.moment(), right, up }
            }
            Self::Moved { from, to, up } => Self::Moved { from: from * scale.length, to: to * scale.length, up },
            Self::NothingPresses | Self::NothingCarries | Self::Mechanism => self,
        }
    }
}

/// A position near `at` where a corner or step of the gap, or a compression-only support, can carry the whole beam. `there`
/// decides whether a position coincides with the resultant. Of the corners only the two next to `at` are checked.
fn corner(scene: &Scene, at: f64, there: impl Fn(f64) -> bool) -> Option<f64> {
    let profiles = [scene.foundation(), scene.beam().shape()];
    let beside = |profile: Option<&Foundation>| {
        let Some(Foundation::Polyline { points }) = profile else { return [None; 2] };
        let next = points.partition_point(|p| p[0] < at);
        [next.checked_sub(1), Some(next)].map(|i| points.get(i?).map(|p| p[0]))
    };
    let carries = |x: f64| {
        let [ground, own] = profiles.map(|profile| profile.map_or([[0.0; 2]; 2], |profile| profile.sides(x)));
        let [left, right] = [0, 1].map(|side| [0, 1].map(|k| ground[side][k] - own[side][k]));
        left[0] < right[0] || right[0] < left[0] || left[1] < right[1]
    };
    let inside = |x: f64| 0.0 < x && x < scene.beam().length();
    if let Some(bearing) = scene.beam().bearings().iter().find(|bearing| inside(bearing.at) && there(bearing.at)) {
        return Some(bearing.at);
    }
    profiles.into_iter().flat_map(beside).flatten().find(|&x| inside(x) && there(x) && carries(x))
}
