//! What an answer violates.

use crate::scene::Scale;

/// A condition that an answer violates, in the units of the scene; inside this room in dimensionless numbers.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum Violation {
    /// The beam lies below the foundation.
    #[error("the beam penetrates the foundation by {depth:?} at x = {at:?}")]
    Penetration {
        /// Where it is worst \[length\].
        at: f64,
        /// By how much \[length\].
        depth: f64,
    },
    /// A contact pulls.
    #[error("the contact at x = {at:?} pulls with a force of {force:?}")]
    Pull {
        /// Where \[length\].
        at: f64,
        /// How much, positive \[force\].
        force: f64,
    },
    /// At a point of contact the foundation is bent less than the beam.
    #[error("the moment at the contact at x = {at:?} is {moment:?} less than the foundation can leave room for")]
    CurvatureGap {
        /// Where \[length\].
        at: f64,
        /// `EI (v'' − u'')`, positive \[force · length\].
        moment: f64,
    },
    /// A zone has negative pressure.
    #[error("the foundation pulls between x = {from:?} and x = {to:?}")]
    PullAlong {
        /// From where \[length\].
        from: f64,
        /// To where \[length\].
        to: f64,
    },
    /// A zone goes over a kink or a step.
    #[error("a zone of contact goes over the break of the foundation at x = {at:?}, which no beam can follow")]
    Broken {
        /// Where \[length\].
        at: f64,
    },
    /// A zone ends before it starts.
    #[error("a zone of contact starts at x = {from:?} and ends at x = {to:?}, before it")]
    Inverted {
        /// Its start \[length\].
        from: f64,
        /// Its end \[length\].
        to: f64,
    },
    /// A support and the foundation beside it would have to pull at each other.
    #[error("the foundation at the support x = {at:?} holds the beam with a moment of {moment:?}, which it cannot")]
    Couple {
        /// Which support \[length\].
        at: f64,
        /// The moment, positive \[force · length\].
        moment: f64,
    },
    /// A contact is not where the piece of the foundation is that it was computed for.
    #[error("the contact at x = {at:?} was computed for a piece of the foundation that does not reach there")]
    OffPiece {
        /// Where \[length\].
        at: f64,
    },
    /// Two ends of a stretch without contact are too close together to be told apart.
    #[error(
        "the beam lifts off between x = {from:?} and x = {to:?}, too short a stretch to be resolved on a beam of this length"
    )]
    Unresolved {
        /// From where \[length\].
        from: f64,
        /// To where \[length\].
        to: f64,
    },
    /// The dimensionless answer is one, but in the units of the scene some of its numbers are not.
    #[error("a number of the answer is beyond the range of 64-bit floating point in the units of the scene")]
    Overflow,
    /// Reactions and contacts do not carry the load.
    #[error("reactions and contacts together carry the load but for a force of {force:?}")]
    Unbalanced {
        /// What they do not carry, downwards \[force\].
        force: f64,
    },
    /// The moment is not continuous.
    #[error("the moment jumps by {jump:?} at a contact")]
    Jump {
        /// By how much \[force · length\].
        jump: f64,
    },
}

impl Violation {
    /// From dimensionless numbers, with moments and forces over `EI`, to the units of the scene.
    pub(super) fn in_units(self, scale: &Scale, stiffness: f64) -> Self {
        let place = |x: f64| x * scale.length;
        let force = |f: f64| f * stiffness * scale.force;
        let moment = |m: f64| m * stiffness * scale.moment();
        match self {
            Self::Penetration { at, depth } => Self::Penetration { at: place(at), depth: depth * scale.depth },
            Self::Pull { at, force: pull } => Self::Pull { at: place(at), force: force(pull) },
            Self::CurvatureGap { at, moment: lack } => Self::CurvatureGap { at: place(at), moment: moment(lack) },
            Self::PullAlong { from, to } => Self::PullAlong { from: place(from), to: place(to) },
            Self::Broken { at } => Self::Broken { at: place(at) },
            Self::Inverted { from, to } => Self::Inverted { from: place(from), to: place(to) },
            Self::Couple { at, moment: couple } => Self::Couple { at: place(at), moment: moment(couple) },
            Self::OffPiece { at } => Self::OffPiece { at: place(at) },
            Self::Unresolved { from, to } => Self::Unresolved { from: place(from), to: place(to) },
            Self::Overflow => Self::Overflow,
            Self::Unbalanced { force: rest } => Self::Unbalanced { force: force(rest) },
            Self::Jump { jump } => Self::Jump { jump: moment(jump) },
        }
    }

    /// Where it is, if it is at one place.
    pub(super) fn place(self) -> Option<f64> {
        match self {
            Self::Penetration { at, .. }
            | Self::Pull { at, .. }
            | Self::CurvatureGap { at, .. }
            | Self::OffPiece { at } => Some(at),
            Self::PullAlong { from, .. } | Self::Inverted { from, .. } => Some(from),
            _ => None,
        }
    }
}
