//! Why a derivative is not there.

/// Why a derivative is not there.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Missing {
    /// The ground parts from a support where the beam lies on it: forces change as a root of the distance, infinitely fast.
    Parts,
    /// The beam lies on the ground beside a support, or along it, without pressing on it: what touches is not determined.
    Unloaded,
    /// Beyond a support that moves off an end of the beam, the ground is level with it, and the beam touches it at once.
    Touches,
    /// The force at the end of a zone, or of a support there, jumps: a load that stands on it comes into the zone or leaves it.
    Jumps,
    /// Loads of both signs stand at one place on a zone, which lifts off under one of them as soon as they part.
    Pulls,
    /// Where a zone ends nothing presses: its place is not determined.
    Undetermined,
    /// On neither side is there a scene whose answer is of this kind: what means nothing in the number ends it.
    Ends,
    /// A contact is so near a support that of the two forces only the couple is certain.
    Unresolved,
}

impl Missing {
    /// The reason in words.
    #[must_use]
    pub fn reason(self) -> &'static str {
        match self {
            Self::Parts => {
                "infinite: the ground parts from a support beside which the beam lies on it, and forces change as a root of the distance"
            }
            Self::Unloaded => {
                "none: the beam lies on the ground without pressing on it, so that what touches is not determined"
            }
            Self::Touches => {
                "none: beyond a support that moves off the end of the beam, the beam touches the ground at once"
            }
            Self::Jumps => {
                "in part: the force at the end of a zone jumps as the load that stands there comes into the zone or leaves it"
            }
            Self::Pulls => "none: one of the loads at this place pulls, and lifts the beam off as soon as they part",
            Self::Ends => {
                "none: on either side there is no scene, or a change of the number by 1e-9 of its size ends the kind of the answer"
            }
            Self::Unresolved => {
                "in part: a contact is so near a support that only the sum and the couple of their forces are certain"
            }
            Self::Undetermined => "in part: nothing presses where a zone ends, so that the place is not determined",
        }
    }
}
