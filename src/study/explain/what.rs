//! What stands at a node of an explanation.

/// What stands at a node.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum What {
    /// An end of the beam at which nothing is.
    End,
    /// A simple support.
    Support,
    /// A support that holds the slope.
    BuiltIn,
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
    /// No more than a place of the beam on an elastic foundation.
    Between,
}

impl What {
    /// In words.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::End => "end of the beam",
            Self::Support => "support",
            Self::BuiltIn => "built-in support",
            Self::Tip => "end of the beam in contact",
            Self::Corner => "contact at a corner",
            Self::Point => "contact at a point",
            Self::ZoneEnd => "end of a zone",
            Self::Hinge => "hinge",
            Self::Load => "load",
            Self::Between => "place between",
        }
    }
}
