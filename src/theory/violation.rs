//! What an answer violates, in the units of the scene.

use super::fault::Fault;
use super::given::Given;
use super::list::List;
use crate::scene::Scale;

/// A condition that an answer violates, in the units of the scene.
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
    Tension {
        /// Where \[length\].
        at: f64,
        /// How much, positive \[force\].
        force: f64,
    },
    /// At a point of contact the foundation is bent less than the beam.
    #[error("the moment at the contact at x = {at:?} is {moment:?} less than the foundation can leave room for")]
    Bulge {
        /// Where \[length\].
        at: f64,
        /// `EI (v'' − u'')`, positive \[force · length\].
        moment: f64,
    },
    /// A zone has negative pressure.
    #[error("the foundation pulls between x = {from:?} and x = {to:?}")]
    Pull {
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
    Astray {
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

/// A fault in the units of the scene.
pub(super) fn in_units(fault: &Fault, given: &Given, list: &List, scale: &Scale, stiffness: f64) -> Violation {
    let place = |x: f64| x * scale.length;
    match *fault {
        Fault::Penetration { at, depth, .. } => Violation::Penetration { at: place(at), depth: depth * scale.depth },
        Fault::Tension { node, force } => {
            Violation::Tension { at: place(list.nodes[node].x), force: -force * stiffness * scale.force }
        }
        Fault::Bulge { node, bend } => {
            Violation::Bulge { at: place(list.nodes[node].x), moment: -bend * stiffness * scale.moment() }
        }
        Fault::Pull { from, to, .. } => Violation::Pull { from: place(from), to: place(to) },
        Fault::Broken { joint, .. } => Violation::Broken { at: place(given.joints[joint].x) },
        Fault::Inverted { start } => {
            Violation::Inverted { from: place(list.nodes[start].x), to: place(list.nodes[start + 1].x) }
        }
        Fault::Couple { support, moment } => Violation::Couple {
            at: if support == 0 { 0.0 } else { place(given.length) },
            moment: moment * stiffness * scale.moment(),
        },
        Fault::Astray { node } => Violation::Astray { at: place(list.nodes[node].x) },
        Fault::Unresolved { span } => Violation::Unresolved {
            from: span.checked_sub(1).map_or(0.0, |i| place(list.nodes[i].x)),
            to: place(list.nodes.get(span).map_or(given.length, |n| n.x)),
        },
        Fault::Unbalanced { force } => Violation::Unbalanced { force: force * stiffness * scale.force },
        Fault::Residual { jump } => Violation::Jump { jump: jump * stiffness * scale.moment() },
    }
}
