//! The kind of a node in an explanation.

use super::places::is_same;
use crate::scene::{Scene, Support};
use crate::state::SupportForce;

/// The kind of a node.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum What {
    /// An end of the beam without support, contact or hinge.
    End,
    /// A simple support.
    Support,
    /// A support that fixes the slope.
    BuiltIn,
    /// An elastic support, against settlement or rotation.
    Spring,
    /// An end of the beam in contact.
    Tip,
    /// A point of contact at a corner of the foundation or of the initial shape, or at a joint.
    Corner,
    /// A point of contact at which the beam follows the slope of the foundation; its position is an unknown.
    Point,
    /// An end of a zone; its position is an unknown.
    ZoneEnd,
    /// A hinge of the beam, off the foundation.
    Hinge,
    /// A point load or couple, or an end of a distributed load, in a chain of links.
    Load,
    /// A joint, in a chain of links.
    Joint,
    /// A change of the bending stiffness, in a chain of links.
    Step,
    /// An intermediate node in a chain of links.
    Between,
}

impl What {
    /// The kind of a support with this reaction.
    pub(super) fn of_support(scene: &Scene, support: &SupportForce) -> Self {
        let beam = scene.beam();
        let is_here = |given: &&Support| is_same(scene, given.at, support.at);
        let turning = beam.supports().iter().find(is_here).is_some_and(|given| given.turning_stiffness.is_some());
        match support.moment {
            _ if turning || beam.springs().iter().any(|given| is_here(&given)) => Self::Spring,
            Some(_) => Self::BuiltIn,
            None => Self::Support,
        }
    }

    /// The kind in words.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::End => "end of the beam",
            Self::Support => "support",
            Self::BuiltIn => "built-in support",
            Self::Spring => "support that gives",
            Self::Tip => "end of the beam in contact",
            Self::Corner => "contact at a corner",
            Self::Point => "contact at a point",
            Self::ZoneEnd => "end of a zone",
            Self::Hinge => "hinge",
            Self::Load => "load",
            Self::Joint => "joint",
            Self::Step => "change of the bending stiffness",
            Self::Between => "place between",
        }
    }
}
