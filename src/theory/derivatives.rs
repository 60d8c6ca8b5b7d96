//! Derivatives of an exact answer with respect to the numbers of its scene, in the units of the scene.
//!
//! The derivatives of positions and forces are computed in module `sensitivity`. The energy is a minimum, so its derivative is the
//! derivative of the functional and of the constraints alone (envelope theorem), with the forces as multipliers:
//!
//! ```text
//! ∂J/∂(depth) = −Σ R     ∂J/∂EI = ½∫v''²     ∂J/∂q₀ = −∫v     ∂J/∂P = −v(a)     ∂J/∂a = −P v'(a)     ∂J/∂d_s = −R_s
//! ```

mod moved;

use super::exact::Exact;
use super::leeway::Leeway;
use super::list::Node;
use super::sensitivity::{Change, NodeChange, Sensitivity, standing};
use super::springs::Springs;
use super::variation::Variation;
use crate::scene::{Quantity, Scene};
use crate::state::Contact;

/// The variable of a derivative.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum By {
    /// The depth of the whole foundation \[length\].
    Depth,
    /// A number of the scene.
    Number(Quantity),
}

impl std::fmt::Display for By {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Depth => f.write_str("depth"),
            Self::Number(quantity) => quantity.fmt(f),
        }
    }
}

/// The derivatives of an answer with respect to one number. Each has the unit of the result over the unit of the number.
#[derive(Debug, Clone, PartialEq)]
pub struct Derivative {
    /// The number.
    pub by: By,
    /// Whether the derivatives are valid on one side only: the kind of the answer changes here, or within a negligible change of the
    /// number, and the derivatives on the other side differ. Also true if the scene on the other side is rejected.
    pub one_sided: bool,
    /// Why numbers below are missing (NaN); [`None`] if all exist.
    pub missing: Option<Missing>,
    /// Derivatives of the reactions, from left to right.
    pub supports: Vec<f64>,
    /// Derivatives of the contacts, in their order.
    pub contacts: Vec<ContactDerivative>,
    /// Derivative of the total contact force. It includes contacts that begin to press.
    pub contact_force: f64,
    /// Derivative of the energy `J`.
    pub energy: f64,
}

/// Why a derivative is missing.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Missing {
    /// On neither side of the scene are the contacts the same as in this answer.
    Ends,
    /// There is no pressure where a contact ends, so its position is not determined.
    Undetermined,
}

impl Missing {
    /// The reason in words.
    #[must_use]
    pub fn reason(self) -> &'static str {
        match self {
            Self::Ends => "none: any change of the number changes what touches, or there is no scene beside this one",
            Self::Undetermined => "in part: nothing presses where a contact ends, so that the place is not determined",
        }
    }
}

/// The derivatives of a contact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ContactDerivative {
    /// Derivative of its left end.
    pub from: f64,
    /// Derivative of its right end.
    pub to: f64,
    /// Derivative of its resultant.
    pub force: f64,
    /// Derivatives of the forces at the ends of a zone.
    pub end_forces: Option<[f64; 2]>,
}

impl ContactDerivative {
    /// A point contact or a zone without numbers.
    fn none(is_zone: bool) -> Self {
        let end_forces = is_zone.then_some([f64::NAN; 2]);
        Self { from: f64::NAN, to: f64::NAN, force: f64::NAN, end_forces }
    }
}

/// Limit of the count of all numbers together, including the unknowns of the beams from which they are computed. It corresponds to about
/// 400 MB as text, and to a few seconds on an elastic foundation, where each derivative has a beam of its own.
const MOST_NUMBERS: usize = 20_000_000;

/// Limit of the pieces of all neighbouring answers together. *Tuned*: on 1,900 point loads, each with a piece of its own, 7,600 answers
/// take seven seconds.
const MOST_PIECES: usize = 16_000_000;

/// Cost of a node, in pieces. *Tuned* on 3,001 supports, where an answer takes ten times as long as on 1,900 point loads.
const OF_A_NODE: usize = 6;

impl Exact {
    /// The derivatives of this solution of `scene` with respect to the depth of the whole foundation, the bending stiffness, the uniform
    /// load, force and position of each point load, and level and position of each support. For a beam with elastic supports, joints,
    /// steps or an axial force, also with respect to their numbers and to couples; on an elastic foundation, also to its steps.
    /// Derivatives that do not exist are omitted: all of them for a beam whose position is not determined.
    #[must_use]
    pub fn derivatives(&self, scene: &Scene) -> Vec<Derivative> {
        let (derivatives, _) = self.derivatives_and_left_out(scene);
        derivatives
    }

    /// The derivatives, and the number of omitted ones: there are too many numbers in all, or too many neighbouring answers would be
    /// needed to find the sides on which they are valid.
    #[must_use]
    pub fn derivatives_and_left_out(&self, scene: &Scene) -> (Vec<Derivative>, usize) {
        let [variations, beyond] = self.computed_and_left_out(scene);
        if !self.is_linear() {
            let (count, all) = (variations.len(), self.moved_derivatives(scene, variations));
            return (all.clone(), beyond.len() + if all.is_empty() { 0 } else { count - all.len() });
        }
        if let Some(springs) = &self.springs {
            let is_step = |variation: &Variation| matches!(variation.by, By::Number(Quantity::GroundStepStiffness(_)));
            let (steps, variations): (Vec<_>, Vec<_>) = variations.into_iter().partition(is_step);
            let (count, steps) = (steps.len(), self.moved_derivatives(scene, steps));
            let left_out = beyond.len() + if steps.is_empty() { 0 } else { count - steps.len() };
            let all = self.derivatives_on_springs(springs, scene, variations).into_iter();
            return (all.chain(steps).collect(), left_out);
        }
        // A beam that can rotate has no derivatives, so none are omitted.
        let (count, all) = (variations.len(), self.derivatives_within(scene, variations, MOST_PIECES));
        let left_out = beyond.len() + all.as_ref().map_or(0, |all| count - all.len());
        (all.unwrap_or_default(), left_out)
    }

    /// The derivatives of a general beam, up to the limit of work.
    fn moved_derivatives(&self, scene: &Scene, variations: Vec<Variation>) -> Vec<Derivative> {
        let lies = self.lies_without_load();
        if !self.solved || self.state.standing.is_some_and(|standing| standing.motion.is_some()) {
            return Vec::new();
        }
        let parts = self.springs.as_ref().map_or(self.given.cells.len(), Springs::unknowns);
        let most = MOST_PIECES / (moved::ANSWERS * (parts + OF_A_NODE * self.list.nodes.len() + 1));
        variations.into_iter().take(most).map(|variation| self.moved_derivative(scene, variation, lies)).collect()
    }

    /// The requested derivatives, as far as their neighbouring answers have no more than this number of pieces; [`None`] if the beam can
    /// rotate.
    fn derivatives_within(&self, scene: &Scene, variations: Vec<Variation>, pieces: usize) -> Option<Vec<Derivative>> {
        let linear = self.sensitivity()?;
        let leeway = Leeway::of(self, scene);
        // A contact that touches without a load may also not touch.
        let lies = self.lies_without_load();
        let mut answers = pieces / (self.given.cells.len() + OF_A_NODE * self.list.nodes.len());
        let of = |variation: Variation| {
            let changes = linear.on_both_sides(variation.change);
            let holds = match &leeway {
                _ if lies || variation.moves_at_zone(self) => [false; 2],
                Some(leeway) if variation.is_certain_to_continue(leeway, &changes) => [true; 2],
                _ => {
                    answers = answers.checked_sub(2)?;
                    variation.continues_beside(scene, self)
                }
            };
            Some(self.derivative(&linear, variation, &changes, holds))
        };
        Some(variations.into_iter().filter_map(of).collect())
    }

    /// The derivatives to be computed, within [`MOST_NUMBERS`], and the omitted ones.
    fn computed_and_left_out(&self, scene: &Scene) -> [Vec<Variation>; 2] {
        let unknowns = self.springs.as_ref().map_or(0, Springs::unknowns);
        let most = MOST_NUMBERS / (unknowns + self.state.supports.len() + 5 * self.state.contacts.len() + 1);
        let mut variations = self.variations(scene);
        if !self.is_linear() {
            variations.extend(self.variations_of_general_beam(scene));
        }
        variations.extend(Self::variations_of_foundation_steps(scene));
        let left_out = variations.split_off(most.min(variations.len()));
        [variations, left_out]
    }

    /// Whether the beam is uniform, has no axial force and no elastic supports. Derivatives of other beams are computed in another way.
    fn is_linear(&self) -> bool {
        self.given.is_undivided() && self.given.tension == 0.0 && self.given.is_firm()
    }

    pub(super) fn sensitivity(&self) -> Option<Sensitivity<'_>> {
        self.is_linear().then(|| Sensitivity::of(&self.given, &self.list, &self.spans, &self.forces))?
    }

    /// The requested derivative; `holds` contains the sides of the scene on which the contacts are the same.
    pub(super) fn derivative(
        &self,
        linear: &Sensitivity<'_>,
        variation: Variation,
        sides: &[Vec<NodeChange>; 2],
        holds: [bool; 2],
    ) -> Derivative {
        let Variation { by, unit, .. } = variation;
        let nodes = &self.list.nodes;
        let side = usize::from(holds != [true, false]);
        let (of, towards, changes) = (variation.change[side], [-1.0, 1.0][side], &sides[side]);
        // The same contacts can continue differently on both sides: a load at the end of a zone enters the zone, or leaves it.
        let one_sided = holds != [true; 2] || sides[0] != sides[1];
        let scaled = Scaled { exact: self, of, unit, towards };
        let (mut supports, mut contacts) = (Vec::new(), Vec::new());
        for i in 0..=nodes.len() {
            if self.list.in_zone_before(i) {
                contacts.push(scaled.zone(changes, i));
            }
            let Some(node) = nodes.get(i) else { continue };
            let support = linear.supports[i];
            let is_point = node.is_smooth() || !node.can_move() && !node.is_held();
            if support.is_none() && is_point {
                contacts.push(ContactDerivative {
                    from: scaled.place(changes[i].place),
                    to: scaled.place(changes[i].place),
                    force: scaled.force(|| self.forces[i], changes[i].force),
                    end_forces: None,
                });
            } else if support.is_some() {
                supports.push((node.x, scaled.force(|| self.node_force(i), changes[i].force)));
            }
        }
        // The beam stays clear of a support from which it has lifted off.
        let lifted = self.given.bearings.iter().map(|&at| self.given.breakpoints[at].x);
        let lifted = lifted.filter(|at| nodes.binary_search_by(|node| node.x.total_cmp(at)).is_err());
        supports.extend(lifted.map(|at| (at, 0.0)));
        supports.sort_by(|a, b| a.0.total_cmp(&b.0));
        let supports = supports.into_iter().map(|(_, force)| force).collect();
        let (contacts, contact_force) = self.of_pressing(&contacts);
        let energy = self.energy_by(of, changes) * self.units.energy() / unit + 0.0;
        let is_known = contacts.iter().all(|contact| contact.from.is_finite() && contact.to.is_finite());
        let there = Derivative {
            by,
            one_sided,
            missing: (!is_known).then_some(Missing::Undetermined),
            supports,
            contacts,
            contact_force,
            energy,
        };
        if holds == [false; 2] { there.without_numbers() } else { there }
    }

    /// The derivatives of the contacts that press, from the derivatives of the contacts of the list, and the derivative of the total
    /// contact force. A part of a contact has no derivatives.
    pub(super) fn of_pressing(&self, listed: &[ContactDerivative]) -> (Vec<ContactDerivative>, f64) {
        let mut next = 0;
        let of = |contact: &Contact| {
            next += self.listed[next..].iter().take_while(|listed| listed.to < contact.from).count();
            let near = self.listed[next..].iter().take_while(|listed| listed.from <= contact.from);
            let whole = near.zip(&listed[next..]).find(|(listed, _)| *listed == contact);
            whole.map_or_else(|| ContactDerivative::none(contact.end_forces.is_some()), |(_, derivative)| *derivative)
        };
        let contacts = self.state.contacts.iter().map(of).collect();
        (contacts, listed.iter().fold(0.0, |sum, derivative| sum + derivative.force))
    }

    /// The force of the support at node `i`, over `EI`; for a bilateral support including the load directly on it.
    pub(super) fn node_force(&self, i: usize) -> f64 {
        self.forces[i] + self.list.nodes[i].support(&self.given).map_or(0.0, |_| standing(&self.given, &self.list, i))
    }

    /// The derivative of `J / EI`; for the stiffness, the derivative of `J` with respect to the logarithm of `EI`, over `EI`.
    fn energy_by(&self, of: Change, changes: &[NodeChange]) -> f64 {
        let (given, units) = (&self.given, &self.units);
        let deflection = |at: f64| self.deflection(at * units.length) / units.depth;
        match of {
            // The energy of a part of the foundation is not requested here, and a rigid foundation has no stiffness.
            Change::GroundUnder(..) | Change::Stiffen => 0.0,
            Change::Ground => {
                let contact = self.state.contact_force() / units.force;
                -contact
            }
            Change::Unload => self.integral(|[_, _, v2, _]| 0.5 * v2 * v2),
            Change::Uniform(q) => -q * self.integral(|[v, ..]| v),
            Change::Force(at, p) => -p * deflection(at),
            Change::Move(at, p) => -p * self.slope(at * units.length) / units.slope(),
            Change::Level(index) | Change::Support(index, _) => {
                let is_here = |node: &Node| node.any_support(given) == Some(index);
                let Some(i) = self.list.nodes.iter().position(is_here) else { return 0.0 };
                let force = self.node_force(i);
                let held = self.list.nodes[i].held_slope(given).is_some() && matches!(of, Change::Support(..));
                let bends = self.curvatures_beside(i);
                // Where the beam is built in, the ends of its two parts move and rotate.
                let [left, right] = changes[i].slopes;
                let turned = if held {
                    bends[0] * left - bends[1] * right + 0.5 * (bends[0] * bends[0] - bends[1] * bends[1])
                } else {
                    0.0
                };
                turned - force * changes[i].value
            }
        }
    }
}

impl Derivative {
    fn without_numbers(mut self) -> Self {
        self.missing = Some(Missing::Ends);
        self.supports.fill(f64::NAN);
        for contact in &mut self.contacts {
            *contact = ContactDerivative::none(contact.end_forces.is_some());
        }
        (self.contact_force, self.energy) = (f64::NAN, f64::NAN);
        self
    }
}

/// Conversion of derivatives to the units of the scene.
struct Scaled<'a> {
    exact: &'a Exact,
    of: Change,
    unit: f64,
    /// 1 if the number increases, −1 if it decreases.
    towards: f64,
}

impl Scaled<'_> {
    fn place(&self, change: f64) -> f64 {
        change * self.exact.units.length / self.unit
    }

    /// Forces are computed here over `EI`, so a force also changes in proportion to `EI` itself.
    fn force(&self, now: impl FnOnce() -> f64, change: f64) -> f64 {
        let own = if self.of == Change::Unload { now() } else { 0.0 };
        (own + change) * self.exact.units.force / self.unit + 0.0
    }

    /// The derivatives of the zone before node `i`.
    fn zone(&self, changes: &[NodeChange], i: usize) -> ContactDerivative {
        let &Self { exact, of, towards, .. } = self;
        let given = &exact.given;
        let ends = [i - 1, i].map(|end| {
            let node = &exact.list.nodes[end];
            let place = changes[end].place;
            match node.support(given) {
                // The whole force at this position is attributed to the support.
                Some(_) => (node.x, place, 0.0, 0.0),
                None => (node.x, place, exact.forces[end], changes[end].force),
            }
        });
        let [(from, left, force_from, change_from), (to, right, force_to, change_to)] = ends;
        let (first, last) = (given.cell_from(from), given.cell_to(to));
        let pushed = |cell: usize, x: f64, place: f64| match -given.drive(given.cell_ahead(x, cell, towards * place), x)
        {
            0.0 => 0.0,
            pressure => pressure * place,
        };
        let spread = of.on_zone(given, from, to) + pushed(last, to, right) - pushed(first, from, left);
        let own = super::forces::zone_force(given, from, to) + force_from + force_to;
        ContactDerivative {
            from: self.place(left),
            to: self.place(right),
            force: self.force(|| own, spread + change_from + change_to),
            end_forces: Some([self.force(|| force_from, change_from), self.force(|| force_to, change_to)]),
        }
    }
}

#[cfg(test)]
mod tests;
