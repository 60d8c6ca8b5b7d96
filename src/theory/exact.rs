//! The exact solution as data, in the units of the scene.

use super::given::Given;
use super::list::{AtSupport, Kind, List};
use super::piece::{Piece, derivatives};
use super::search::Found;
use super::summary;
use super::verify::Fault;
use crate::route::Status;
use crate::scene::Scale;
use crate::state::ContactState;

/// The exact solution of a scene; made by [`super::solve`].
#[derive(Debug, Clone)]
pub struct Exact {
    /// The beam in its final position; no nodes.
    pub state: ContactState,
    /// Certified if every condition holds everywhere, to 12 digits; otherwise this is the best answer that was found.
    pub status: Status,
    /// Unknowns of the exact model: lift-off positions, and slopes at edges of the profile.
    pub unknowns: usize,
    /// Newton steps, those of lists that failed their check included.
    pub iterations: usize,
    /// Lists of contacts that were tried.
    pub lists: usize,
    /// Worst violation of any condition, relative to the largest deflection, force or moment.
    pub residual: f64,
    /// What the answer violates; empty if it is certified.
    pub violations: Vec<Violation>,
    /// Moments that foundation and support exert on the beam together where the foundation starts at the level of a
    /// support and holds the slope of the beam there: the limit of a large reaction downwards and a large contact force
    /// upwards beside it. Not positive, mostly zero \[force · length\]. `state.reactions` has the net force.
    pub support_couples: [f64; 2],
    given: Given,
    pieces: Vec<Piece>,
    scale: Scale,
    stiffness: f64,
    founded: bool,
}

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

impl Exact {
    /// From the search's result.
    pub(super) fn new(given: Given, found: Found, scale: Scale, stiffness: f64, founded: bool) -> Self {
        let state = summary::state(&given, &found, &scale, stiffness);
        let overflow = (!state.is_finite()).then_some(Violation::Overflow);
        let status = if found.certified() && overflow.is_none() {
            Status::Certified
        } else if found.converged {
            Status::NotCertified
        } else {
            Status::NotConverged
        };
        let Found { list, checked, steps, lists, .. } = found;
        let faults = checked.faults.iter().map(|f| in_units(f, &given, &list, &scale, stiffness));
        let violations = faults.chain(overflow).collect();
        let support_couples = [0, 1].map(|i| {
            let span = match (list.supports[i], i) {
                (AtSupport::Clamped, 0) => checked.spans.first().map(|(_, s)| s.at_a[2]),
                (AtSupport::Clamped, _) => checked.spans.last().map(|(_, s)| s.at_b[2]),
                (AtSupport::Zone, _) => Some(0.0),
                (AtSupport::Free, _) => None,
            };
            let (cell, x) = if i == 0 { (0, 0.0) } else { (given.cells.len() - 1, given.length) };
            span.map_or(0.0, |h2| (h2 - given.derivative(cell, x, 2)) * stiffness * scale.moment())
        });
        Self {
            state,
            status,
            unknowns: list.nodes.len(),
            iterations: steps,
            lists,
            residual: checked.worst,
            violations,
            support_couples,
            pieces: checked.pieces,
            given,
            scale,
            stiffness,
            founded,
        }
    }

    /// Deflection `v(x)`, positive downwards \[length\].
    #[must_use]
    pub fn deflection(&self, x: f64) -> f64 {
        self.beam(x, true)[0] * self.scale.depth
    }

    /// Slope `v'(x)`.
    #[must_use]
    pub fn slope(&self, x: f64) -> f64 {
        self.beam(x, true)[1] * self.scale.depth / self.scale.length
    }

    /// Bending moment `M(x) = −EI v''` \[force · length\].
    #[must_use]
    pub fn moment(&self, x: f64) -> f64 {
        // Adding zero turns a −0.0 into 0.0.
        -self.beam(x, true)[2] * self.stiffness * self.scale.moment() + 0.0
    }

    /// Shear force `V(x) = M'`, just left and just right of `x` \[force\].
    #[must_use]
    pub fn shear(&self, x: f64) -> [f64; 2] {
        [false, true].map(|right| -self.beam(x, right)[3] * self.stiffness * self.scale.force + 0.0)
    }

    /// Clearance `h = u − v` \[length\]; at a step the smaller one; infinite without a foundation.
    #[must_use]
    pub fn clearance(&self, x: f64) -> f64 {
        if !self.founded {
            return f64::INFINITY;
        }
        let [left, right] = [false, true].map(|right| {
            let (piece, t) = self.piece(x, right);
            let mut taylor = vec![0.0; self.given.terms];
            piece.clearance(&self.given, &mut taylor);
            derivatives(&taylor, t)[0]
        });
        left.min(right) * self.scale.depth
    }

    /// Contact pressure `p = q − EI u''''` inside a zone, zero outside; without concentrated forces \[force / length\].
    #[must_use]
    pub fn pressure(&self, x: f64) -> f64 {
        let (piece, _) = self.piece(x, true);
        if piece.state.is_some() || !self.founded {
            return 0.0;
        }
        let at = (x / self.scale.length).max(piece.lo).min(piece.hi);
        -self.given.drive(piece.cell, at) * self.stiffness * self.scale.force / self.scale.length
    }

    /// Concentrated contact forces inside zones, at point loads: `(place, force)`, upwards \[length, force\].
    pub fn forces_inside_zones(&self) -> impl Iterator<Item = (f64, f64)> + '_ {
        let inside = |x: f64| self.state.contacts.iter().any(|c| c.from < x && x < c.to);
        self.given
            .joints
            .iter()
            .filter(|j| j.force != 0.0)
            .map(|j| (j.x * self.scale.length, j.force * self.stiffness * self.scale.force))
            .filter(move |&(x, _)| inside(x))
    }

    /// The piece at `x`, of two the left or the right one, and the distance from its anchor.
    fn piece(&self, x: f64, right: bool) -> (&Piece, f64) {
        let x = x / self.scale.length;
        let i =
            if right { self.pieces.partition_point(|p| p.hi <= x) } else { self.pieces.partition_point(|p| p.hi < x) };
        let piece = &self.pieces[i.min(self.pieces.len() - 1)];
        (piece, x.max(piece.lo).min(piece.hi) - piece.anchor)
    }

    /// `v, v', v'', v'''` at `x`, dimensionless.
    fn beam(&self, x: f64, right: bool) -> [f64; 4] {
        let (piece, t) = self.piece(x, right);
        let mut taylor = vec![0.0; self.given.terms];
        piece.deflection(&self.given, &mut taylor);
        derivatives(&taylor, t)
    }
}

/// A fault in the units of the scene.
fn in_units(fault: &Fault, given: &Given, list: &List, scale: &Scale, stiffness: f64) -> Violation {
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

/// True if a zone ends, or starts, at the node.
pub(super) fn is_zone(kind: Kind) -> bool {
    matches!(kind, Kind::ZoneStart | Kind::ZoneEnd)
}
