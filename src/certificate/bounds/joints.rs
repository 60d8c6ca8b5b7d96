//! The contacts of a witness as a list of joints.
//!
//! Between two neighbouring joints the beam either hangs free or lies on the foundation.
//!
//! | joint | `v` | `v'` | holds for the true places |
//! |---|---|---|---|
//! | support | 0 | free | `v'' = 0` |
//! | clamp: a support that the foundation is level with and holds the slope at | 0 | `u'` | |
//! | corner | `u` | free | `v''` continuous |
//! | touch | `u` | `u'` | `v''` continuous |
//! | start, end of a zone | `u` | `u'` | `v'' = u''` |
//!
//! What the last column says is not asked of a witness: the gap grows with the square of what is missing.

use super::ground::Ground;
use super::load::Pieces;
use super::span::Span;
use crate::certificate::interval::Interval;

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Kind {
    Support,
    Clamp,
    Corner,
    Touch,
    Start,
    End,
}

impl Kind {
    /// True where the slope of the beam is not that of the foundation.
    pub(super) fn is_hinge(self) -> bool {
        matches!(self, Self::Support | Self::Corner)
    }
}

#[derive(Debug, Clone, Copy)]
pub(super) struct Joint {
    pub(super) kind: Kind,
    pub(super) x: f64,
    /// Of the beam, at a support or a corner.
    pub(super) slope: f64,
}

impl Joint {
    pub(super) fn new(kind: Kind, x: f64) -> Self {
        Self { kind, x, slope: 0.0 }
    }
}

/// What the joints are asked in.
#[derive(Debug, Clone, Copy)]
pub(super) struct Setting<'a> {
    pub(super) ground: Ground<'a>,
    pub(super) load: &'a Pieces,
    pub(super) stiffness: f64,
    pub(super) length: f64,
}

impl Setting<'_> {
    /// `v` and `v'` of the beam at a joint.
    pub(super) fn end(&self, joint: &Joint) -> [Interval; 2] {
        match joint.kind {
            Kind::Support => [Interval::ZERO, Interval::exact(joint.slope)],
            Kind::Corner => [self.ground.depth(joint.x), Interval::exact(joint.slope)],
            Kind::Clamp => [Interval::ZERO, self.jet(joint)[1]],
            Kind::Touch | Kind::Start | Kind::End => {
                let [u, slope, ..] = self.jet(joint);
                [u, slope]
            }
        }
    }

    /// The depth and its first three derivatives at a joint, at a point of a polyline on the side on which the beam follows it.
    pub(super) fn jet(&self, joint: &Joint) -> [Interval; 4] {
        let from_the_left = joint.kind == Kind::End || (joint.kind == Kind::Clamp && 0.0 < joint.x);
        self.ground.jet(joint.x, from_the_left)
    }

    /// The part between two joints; [`None`] where the beam lies on the foundation.
    pub(super) fn span(&self, left: &Joint, right: &Joint) -> Option<Span> {
        (left.kind != Kind::Start)
            .then(|| Span::new([left.x, right.x], [self.end(left), self.end(right)], self.load, self.stiffness))
    }
}
