//! What stands at a node of an explanation.

use super::SAME;
use crate::scene::{Scene, Support};
use crate::state::SupportForce;

/// What stands at a node.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum What {
    /// An end of the beam at which nothing is.
    End,
    /// A simple support.
    Support,
    /// A support that holds the slope.
    BuiltIn,
    /// A support that gives, against sinking or turning.
    Spring,
    /// An end of the beam that touches.
    Tip,
    /// A point of contact whose place is a corner of the ground, or a joint.
    Corner,
    /// A point of contact at which the beam follows the slope of the ground: its place is an unknown.
    Point,
    /// An end of a zone: its place is an unknown.
    ZoneEnd,
    /// A hinge of the beam, off the ground.
    Hinge,
    /// A point load, or an end of a distributed one, on an elastic foundation.
    Load,
    /// A joint, on an elastic foundation.
    Joint,
    /// A change of the bending stiffness, on an elastic foundation.
    Step,
    /// No more than a place of the beam on an elastic foundation.
    Between,
}

impl What {
    /// A support that exerts this.
    pub(super) fn of_support(scene: &Scene, support: &SupportForce) -> Self {
        let beam = scene.beam();
        let is_here = |given: &&Support| (given.at - support.at).abs() <= SAME * beam.length();
        let turning = beam.supports().iter().find(is_here).is_some_and(|given| given.turning_stiffness.is_some());
        match support.moment {
            _ if turning || beam.springs().iter().any(|given| is_here(&given)) => Self::Spring,
            Some(_) => Self::BuiltIn,
            None => Self::Support,
        }
    }

    /// In words.
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
