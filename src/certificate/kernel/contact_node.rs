//! Contact nodes: the contacts of a witness as places in an enclosed scene.
//!
//! Between two neighbouring nodes the beam either hangs free or lies on the foundation.
//!
//! | node | `v` | `v'` | holds for the true places |
//! |---|---|---|---|
//! | support | 0 | free | `v'' = 0` |
//! | clamp: a support that the foundation is level with and holds the slope at | 0 | `u'` | |
//! | corner | `u` | free | `v''` continuous |
//! | touch | `u` | `u'` | `v''` continuous |
//! | start, end of a zone | `u` | `u'` | `v'' = u''` |
//!
//! What the last column says is not asked of a witness: the gap grows with the square of what is missing.

use super::foundation::EnclosedFoundation;
use super::interval::Interval;
use super::load::EnclosedLoad;
use super::span::Span;

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Kind {
    Support,
    Clamp,
    Corner,
    Touch,
    Start,
    End,
}

#[derive(Debug, Clone, Copy)]
pub(crate) struct ContactNode {
    pub(crate) kind: Kind,
    pub(crate) x: f64,
    /// Of the beam, at a support or a corner.
    pub(crate) slope: f64,
}

/// A dimensionless scene, taken apart: all that is known of it in intervals.
#[derive(Debug, Clone, Copy)]
pub(crate) struct EnclosedScene<'a> {
    pub(crate) foundation: EnclosedFoundation<'a>,
    pub(crate) load: &'a EnclosedLoad,
    pub(crate) stiffness: f64,
    pub(crate) length: f64,
}

impl EnclosedScene<'_> {
    /// `v` and `v'` of the beam at a node.
    pub(crate) fn end(&self, node: &ContactNode) -> [Interval; 2] {
        match node.kind {
            Kind::Support => [Interval::ZERO, Interval::exact(node.slope)],
            Kind::Corner => [self.foundation.depth(node.x), Interval::exact(node.slope)],
            Kind::Clamp => [Interval::ZERO, self.jet(node)[1]],
            Kind::Touch | Kind::Start | Kind::End => {
                let [u, slope, ..] = self.jet(node);
                [u, slope]
            }
        }
    }

    /// The depth and its first three derivatives at a node, at a point of a polyline on the side on which the beam follows it.
    pub(crate) fn jet(&self, node: &ContactNode) -> [Interval; 4] {
        let from_the_left = node.kind == Kind::End || (node.kind == Kind::Clamp && 0.0 < node.x);
        self.foundation.jet(node.x, from_the_left)
    }

    /// The part between two nodes; [`None`] where the beam lies on the foundation.
    pub(crate) fn span(&self, left: &ContactNode, right: &ContactNode) -> Option<Span> {
        (left.kind != Kind::Start)
            .then(|| Span::new([left.x, right.x], [self.end(left), self.end(right)], self.load, self.stiffness))
    }
}
