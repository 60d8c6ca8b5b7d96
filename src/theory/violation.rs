//! The conditions that an answer violates.

use crate::scene::Scale;

/// A condition that an answer violates, in the units of the scene; in dimensionless numbers inside this module.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum Violation {
    /// The beam penetrates the foundation.
    #[error("the beam penetrates the foundation by {depth:?} at x = {at:?}")]
    Penetration {
        /// Position of the maximum \[length\].
        at: f64,
        /// Penetration \[length\].
        depth: f64,
    },
    /// A contact is in tension.
    #[error("the contact at x = {at:?} pulls with a force of {force:?}")]
    Pull {
        /// Position \[length\].
        at: f64,
        /// Tensile force, positive \[force\].
        force: f64,
    },
    /// At a point contact the foundation is curved less than the beam.
    #[error("the moment at the contact at x = {at:?} is {moment:?} less than the foundation can leave room for")]
    CurvatureGap {
        /// Position \[length\].
        at: f64,
        /// `EI (v'' − u'')`, positive \[force · length\].
        moment: f64,
    },
    /// A zone is in tension.
    #[error("the foundation pulls between x = {from:?} and x = {to:?}")]
    PullAlong {
        /// Start \[length\].
        from: f64,
        /// End \[length\].
        to: f64,
    },
    /// A zone extends over a kink or a step.
    #[error("a zone of contact goes over the break of the foundation at x = {at:?}, which no beam can follow")]
    Broken {
        /// Position \[length\].
        at: f64,
    },
    /// A zone ends before it starts.
    #[error("a zone of contact starts at x = {from:?} and ends at x = {to:?}, before it")]
    Inverted {
        /// Start \[length\].
        from: f64,
        /// End \[length\].
        to: f64,
    },
    /// A support and the foundation next to it would require tension between them.
    #[error("the foundation at the support x = {at:?} holds the beam with a moment of {moment:?}, which it cannot")]
    Couple {
        /// Position of the support \[length\].
        at: f64,
        /// The moment, positive \[force · length\].
        moment: f64,
    },
    /// A contact is outside the piece of the foundation for which it was computed.
    #[error("the contact at x = {at:?} was computed for a piece of the foundation that does not reach there")]
    OffPiece {
        /// Position \[length\].
        at: f64,
    },
    /// The two ends of a stretch without contact are too close together to be resolved.
    #[error(
        "the beam lifts off between x = {from:?} and x = {to:?}, too short a stretch to be resolved on a beam of this length"
    )]
    Unresolved {
        /// Start \[length\].
        from: f64,
        /// End \[length\].
        to: f64,
    },
    /// The dimensionless answer is finite, but in the units of the scene some of its numbers are not.
    #[error("a number of the answer is beyond the range of 64-bit floating point in the units of the scene")]
    Overflow,
    /// Reactions and contacts do not carry the load.
    #[error("reactions and contacts together carry the load but for a force of {force:?}")]
    Unbalanced {
        /// The rest of the load, downwards \[force\].
        force: f64,
    },
    /// The moment is not continuous.
    #[error("the moment jumps by {jump:?} at a contact")]
    Jump {
        /// The jump \[force · length\].
        jump: f64,
    },
}

impl Violation {
    /// Converts dimensionless numbers to the units of the scene.
    pub(super) fn in_units_of(self, units: &Scale) -> Self {
        let place = |x: f64| x * units.length;
        let force = |f: f64| f * units.force;
        let moment = |m: f64| m * units.moment();
        match self {
            Self::Penetration { at, depth } => Self::Penetration { at: place(at), depth: depth * units.depth },
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

    /// The position of the violation, if it has a single one.
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
