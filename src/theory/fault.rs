//! What can be wrong with a list of contacts, in the words of the list; [`super::Violation`] says it in the units of the scene.

/// A condition that does not hold.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Fault {
    /// `v > u` in the stretch before node `span`.
    Penetration {
        /// Index of the node to the right.
        span: usize,
        /// Where it is worst.
        at: f64,
        /// `v − u`.
        depth: f64,
    },
    /// A node whose concentrated force pulls.
    Tension {
        /// Index of the node.
        node: usize,
        /// The force, negative.
        force: f64,
    },
    /// A point at which the profile is bent less than the beam, `u'' < v''`: beside it the beam would lie below.
    Bulge {
        /// Index of the node.
        node: usize,
        /// `h''`, negative.
        bend: f64,
    },
    /// A zone that would have to pull at the beam.
    Pull {
        /// Index of the node to the right of the zone.
        zone: usize,
        /// From where it pulls.
        from: f64,
        /// To where.
        to: f64,
    },
    /// A zone that goes over a kink or a step, which no beam can follow.
    Broken {
        /// Index of the node to the right of the zone.
        zone: usize,
        /// The joint.
        joint: usize,
    },
    /// A zone that ends before it starts.
    Inverted {
        /// Index of the node at which it starts.
        start: usize,
    },
    /// A support (0: left, 1: right) at which foundation and support would pull at each other.
    Couple {
        /// Which.
        support: usize,
        /// The moment there, over `EI`.
        moment: f64,
    },
    /// A contact that is not on the piece of the foundation that it was computed for.
    Astray {
        /// Index of the node.
        node: usize,
    },
    /// A span that is too short for its ends to be told apart.
    Unresolved {
        /// Index of the node to its right.
        span: usize,
    },
    /// Reactions and contacts do not carry the load.
    Unbalanced {
        /// What is left over.
        force: f64,
    },
    /// The equations of the list do not hold.
    Residual {
        /// Largest jump of the curvature.
        jump: f64,
    },
}
