//! From nodal values to a [`ContactState`]: reactions and moments by statics, contacts as runs of nodes, extremes at and between the
//! nodes, and the energy.

use std::ops::Range;

use super::contact_set::ContactSet;
use super::extremes::{BLOCK, Values, extremes, shifted};
use super::held_beam::{self, HeldNode};
use super::span::Span;
use super::supports::NodeSupport;
use super::{Discrete, program};
use crate::certificate::least_deflection;
use crate::qp::Sizes;
use crate::scene::Grid;
use crate::state::{
    Contact, ContactState, Discretisation, Extremes, Nodes, Pressure, Reactions, Regime, SupportForce, larger_moment,
};

/// Deflections, clearances and contact forces at all nodes except supported ends.
#[derive(Debug, Clone, PartialEq)]
pub struct Nodal {
    /// The shape of the beam between the nodes.
    pub discretisation: Discretisation,
    /// Deflection `v`.
    pub deflection: Vec<f64>,
    /// Clearance `h = g − v`.
    pub clearance: Vec<f64>,
    /// Contact forces, zero at supports.
    pub contact_force: Vec<f64>,
    /// Forces of elastic compression-only supports.
    pub stop_force: Vec<f64>,
}

impl Nodal {
    /// Nodal values from clearances and contact forces at all nodes except supported ends, followed by those of elastic
    /// compression-only supports. The deflection is `v = g − h`. Where the foundation lies so deep that this difference has few
    /// digits left, or none, it is `v = C t` by statics.
    #[must_use]
    pub(crate) fn new(
        discrete: &Discrete,
        discretisation: Discretisation,
        mut clearance: Vec<f64>,
        mut contact_force: Vec<f64>,
    ) -> Self {
        /// Ratio of gap to deflection above which statics is used. Up to it the difference loses at most three of sixteen digits.
        /// Statics loses fewer than three on every grid on which the difference would be the better choice.
        const DEEP: f64 = 1e3;
        let first = discrete.nodes().start;
        if discrete.has_open_nodes() {
            return Self::of_open(discrete, discretisation, &clearance, contact_force);
        }
        let by_statics = |forces: &[f64]| program::deflection(discrete, forces, discretisation);
        let size = DEEP * discrete.sizes().x;
        let by_statics =
            (discrete.is_held() && discrete.depths.iter().any(|&u| size < u)).then(|| by_statics(&contact_force));
        clearance.truncate(discrete.nodes().len());
        let stop_force = contact_force.split_off(discrete.nodes().len());
        // From the clearance of the foot of a spring to the clearance of the beam.
        for ((h, node), p) in
            clearance.iter_mut().zip(discrete.nodes()).zip(&contact_force).filter(|_| discrete.gives())
        {
            *h -= discrete.give(node) * p;
        }
        for support in discrete.supports().inner() {
            clearance[support.node - first] = discrete.gap(support.node) - support.held.deflection;
        }
        let mut deflection = discrete.clearances(&clearance);
        for support in discrete.supports().inner() {
            deflection[support.node - first] = support.held.deflection;
        }
        if let Some(by_statics) = by_statics {
            for ((v, &statics), &u) in deflection.iter_mut().zip(&by_statics).zip(&discrete.depths) {
                if size < u {
                    *v = statics;
                }
            }
        }
        Self { discretisation, deflection, clearance, contact_force, stop_force }
    }

    /// The same for a beam with nothing to touch at some nodes. At all others the beam is held at the given clearances.
    fn of_open(
        discrete: &Discrete,
        discretisation: Discretisation,
        clearance: &[f64],
        mut contact_force: Vec<f64>,
    ) -> Self {
        let first = discrete.nodes().start;
        let (at_nodes, feet) = clearance.split_at(discrete.nodes().len());
        let mut levels = vec![0.0; at_nodes.len()];
        discrete.touchable().for_each(|node| levels[node - first] = discrete.gap(node) - at_nodes[node - first]);
        let held = discrete.above(levels, feet);
        let span = |first: usize, last: usize| Span::under(&held.loads[first + 1..last]);
        let beam = ContactSet::at(&held, held.places()).beam(&held, discretisation, span);
        let mut deflection = beam.map_or_else(|_| vec![f64::NAN; at_nodes.len()], |beam| beam.deflection());
        for support in discrete.supports().inner() {
            deflection[support.node - first] = support.held.deflection;
        }
        let clearance = if discrete.gives() { discrete.clearances(&deflection) } else { at_nodes.to_vec() };
        let stop_force = contact_force.split_off(at_nodes.len());
        let mut nodal = Self { discretisation, deflection, clearance, contact_force, stop_force };
        nodal.leave_open(discrete);
        nodal
    }

    /// The state at rest, without contact forces, of a beam that balances on one contact, until its position is known.
    #[must_use]
    pub(crate) fn resting(discrete: &Discrete, discretisation: Discretisation) -> Self {
        let nothing = || vec![0.0; discrete.nodes().len()];
        let stop_force = vec![0.0; discrete.supports().stops().len()];
        Self { discretisation, deflection: nothing(), clearance: nothing(), contact_force: nothing(), stop_force }
    }

    /// Makes the clearances of nodes with nothing below them infinite.
    pub(super) fn leave_open(&mut self, discrete: &Discrete) {
        let first = discrete.nodes().start;
        for node in discrete.nodes().filter(|node| discrete.is_bottomless(*node)) {
            self.clearance[node - first] = f64::INFINITY;
        }
    }
}

/// A contact force below this fraction of the sum of all forces is rounding, not contact: a few thousand units in the last place.
const NO_FORCE: f64 = 1e-12;

/// The beam on its supports under nodal loads, without a foundation: `v = C q`, and no quadratic program to solve.
#[must_use]
pub(crate) fn free_beam(discrete: &Discrete, discretisation: Discretisation) -> Nodal {
    let nothing = vec![0.0; discrete.nodes().len()];
    let deflection = program::deflection(discrete, &nothing, discretisation);
    let clearance = discrete.clearances(&deflection);
    Nodal { discretisation, clearance, contact_force: nothing, deflection, stop_force: Vec::new() }
}

/// The state of the beam for given nodal values. Reuses the memory of the discrete problem where it can.
///
/// Support moments and reactions are those of the beam on its supports alone, under `q − p`. If the supports do not hold the beam, up
/// to two supports are added. Contact forces and loads are then in balance, and the added supports carry only the imbalance.
#[must_use]
pub(crate) fn contact_state(mut discrete: Discrete, nodal: Nodal) -> ContactState {
    let (nodes, sizes, supports) = (discrete.nodes(), discrete.sizes(), discrete.supports().all().to_vec());
    let mut loads = std::mem::take(&mut discrete.loads);
    let mut energy = take_contact_forces(&mut loads[nodes.clone()], &nodal);
    let pressure = pressure(&discrete, &nodal);
    energy += pressure.map_or(0.0, |_| pressed(&discrete, &nodal));
    discrete.supports().stops().iter().zip(&nodal.stop_force).for_each(|(stop, force)| loads[stop.node] -= force);
    let discrete = discrete.basic(loads);
    let &Discrete { grid, intervals, stiffness, .. } = &discrete;
    let carried = held_beam::on_supports(&discrete, nodal.discretisation);
    let (held, mut moments) = carried.map_or_else(
        |_| (HeldNode::unknown(&discrete), vec![f64::NAN; intervals + 1]),
        |carried| (carried.supports(), carried.moments()),
    );
    let (forces, of_supports) = support_forces(&discrete, &supports, (&nodal, &nodes), &held);
    energy += of_supports;
    let (bearings, end) = (discrete.supports().bearings(), grid.place(intervals));
    let reactions = Reactions::of(&forces, end);
    let pushes = |i: usize| bearings.binary_search_by_key(&(i + nodes.start), |bearing| bearing.node).is_ok();
    let contacts = contacts(&nodal, &sizes_of_contact(sizes, stiffness, end), pushes, |i| grid.place(i + nodes.start));
    let deflection_at = |node: usize| match supports.iter().find(|support| support.node == node) {
        Some(support) => support.held.deflection,
        None => nodal.deflection[node - nodes.start],
    };
    let [deflection, moment] = extremes_by_parts(&discrete, (&nodal, nodes.start), deflection_at, &held, &moments)
        .map(|extremes| placed(extremes, &grid));
    moments.truncate(nodes.end);
    moments.drain(..nodes.start);
    // The loads are no longer needed.
    let mut x = discrete.loads;
    x.truncate(nodes.len());
    grid.places(nodes.start, &mut x);
    ContactState {
        regime: Regime::of(&contacts),
        reactions,
        supports: forces,
        standing: None,
        contacts,
        touches: Vec::new(),
        deflection,
        moment,
        energy,
        pressure,
        nodes: Some(Nodes {
            discretisation: nodal.discretisation,
            x,
            deflection: nodal.deflection,
            clearance: nodal.clearance,
            contact_force: nodal.contact_force,
            moment: moments,
        }),
    }
}

/// The reaction of every support, from left to right, and the energy of settled and rotated supports. That energy is half of the work
/// of the reactions, less half of the work of loads at supports that are no nodes of the state. The discrete beam may have more
/// supports than the scene.
fn support_forces(
    discrete: &Discrete,
    supports: &[NodeSupport],
    (nodal, nodes): (&Nodal, &Range<usize>),
    held: &[HeldNode],
) -> (Vec<SupportForce>, f64) {
    let (bearings, stops) = (discrete.supports().bearings(), discrete.supports().stops());
    let mut energy = 0.0;
    let mut forces = Vec::with_capacity(supports.len() + bearings.len());
    let springs = discrete.supports().springs().iter();
    let all = supports.iter().map(|support| (support.node, support.held.at, support.held.deflection));
    for (node, at, deflection) in all.chain(springs.map(|spring| (spring.node, spring.at, spring.deflection))) {
        let Some(found) = held.iter().find(|held| held.node == node) else { continue };
        let (force, [left, right], slope) = (found.force, found.moments, discrete.supports().slope(node));
        let moment = slope.map(|_| larger_moment([left, right]));
        let couple = if moment.is_some() { right - left } else { 0.0 };
        forces.push((node, SupportForce { at, force, moment, couple, pushes_only: false }));
        energy += 0.5 * ((right - left) * slope.unwrap_or(0.0) - force * deflection);
        if !nodes.contains(&node) {
            energy -= 0.5 * discrete.loads[node] * deflection;
        }
    }
    forces.extend(bearings.iter().map(|bearing| {
        let force = nodal.contact_force[bearing.node - nodes.start];
        (bearing.node, SupportForce::pushing(bearing.at, force))
    }));
    for (stop, force) in stops.iter().zip(&nodal.stop_force) {
        forces.push((stop.node, SupportForce::pushing(stop.at, *force)));
        energy -= 0.5 * force * stop.deflection;
    }
    forces.sort_by_key(|(node, _)| *node);
    (forces.into_iter().map(|(_, force)| force).collect(), energy)
}

/// Extremes of deflection and moment, with positions in intervals from the left end. The moment jumps at a built-in support inside
/// the beam, so each side is searched separately. `nodal` begins with node `first` of the grid, which need not be the first node of
/// the beam on its supports.
fn extremes_by_parts(
    discrete: &Discrete,
    (nodal, first): (&Nodal, usize),
    deflection_at: impl Fn(usize) -> f64,
    held: &[HeldNode],
    moments: &[f64],
) -> [Extremes; 2] {
    let &Discrete { intervals, spacing, stiffness, .. } = discrete;
    let mut found: Option<[Extremes; 2]> = None;
    let mut from = (0, moments[0]);
    let jumps = held.iter().filter(|held| 0 < held.node && held.node < intervals);
    for (to, [before, behind]) in
        jumps.map(|held| (held.node, held.moments)).chain([(intervals, [moments[intervals]; 2])])
    {
        let inner = from.0 + 1..to;
        let v = Values {
            inner: &nodal.deflection[inner.start - first..inner.end - first],
            ends: [from.0, to].map(&deflection_at),
        };
        let m = Values { inner: &moments[inner], ends: [from.1, before] };
        let bent_by = |interval: usize| discrete.bent_by(from.0 + interval);
        let part = extremes(nodal.discretisation, v, m, spacing, (stiffness, discrete.bends_at_most(), bent_by));
        let part = part.map(|part| shifted(part, from.0));
        found = Some(found.map_or(part, |found| {
            let both = |a: Extremes, b: Extremes| a.beyond(b.max_at, b.max).beyond(b.min_at, b.min);
            [both(found[0], part[0]), both(found[1], part[1])]
        }));
        from = (to, behind);
    }
    found.unwrap_or_default()
}

/// Sizes of clearance and force that decide what counts as contact. Where the foundation is so close that the beam deflects less than
/// the rounding of its forces, clearances are only rounding.
fn sizes_of_contact(sizes: Sizes, stiffness: f64, length: f64) -> Sizes {
    Sizes { x: sizes.x.max(least_deflection(sizes.gradient, length, stiffness)), ..sizes }
}

/// Subtracts the contact forces from the loads, `t = q − p`, and returns `½ tᵀv − qᵀv`. Half the work of all forces and couples is
/// the bending energy, so this is `J(v)` without the contribution of supports. The sum is taken in blocks: one sum over a fine grid
/// would lose digits that the answer has.
fn take_contact_forces(loads: &mut [f64], nodal: &Nodal) -> f64 {
    let mut energy = 0.0;
    let answers = nodal.contact_force.chunks(BLOCK).zip(nodal.deflection.chunks(BLOCK));
    for (loads, (forces, deflection)) in loads.chunks_mut(BLOCK).zip(answers) {
        let mut sum = 0.0;
        for ((q, p), v) in loads.iter_mut().zip(forces).zip(deflection) {
            let load = *q;
            *q -= p;
            sum += (0.5 * *q - load) * v;
        }
        energy += sum;
    }
    energy
}

/// The energy stored in an elastic foundation, `½ Σ p²/kΔ`.
fn pressed(discrete: &Discrete, nodal: &Nodal) -> f64 {
    let pressing = discrete.nodes().zip(&nodal.contact_force).filter(|(_, p)| **p != 0.0);
    pressing.map(|(node, p)| 0.5 * discrete.give(node) * p * p).sum()
}

/// The largest pressure of an elastic foundation.
fn pressure(discrete: &Discrete, nodal: &Nodal) -> Option<Pressure> {
    let at = |(node, p): (usize, &f64)| {
        // Half a spring counts at an end of the beam, and none at a compression-only support. Where the stiffness changes, the
        // pressure is that on the stiffer side.
        let share = discrete.give(node) / discrete.whole_give(discrete.stiffest_beside(node));
        Pressure { max: share * p / discrete.spacing, at: discrete.grid.place(node) }
    };
    let grounded = discrete.nodes().zip(&nodal.contact_force).filter(|(node, _)| discrete.give(*node).is_finite());
    let all = grounded.map(at);
    all.filter(|_| discrete.gives()).max_by(|a, b| a.max.total_cmp(&b.max))
}

/// Extremes with positions along the beam instead of node numbers.
fn placed(extremes: Extremes, grid: &Grid) -> Extremes {
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "between 0 and the number of intervals"
    )]
    let place = |number: f64| grid.place(number as usize) + number.fract() * grid.spacing();
    Extremes { max_at: place(extremes.max_at), min_at: place(extremes.min_at), ..extremes }
}

/// Runs of neighbouring nodes in contact. Each is a zone, or a point if it is a single node.
///
/// `place` is the position of a node by its number in `nodal`. A node where a support `pushes` is no contact with the foundation.
///
/// A node is in contact if its force, relative to the sum of all forces, is larger than its clearance, relative to the deflection. In
/// the answer of an iterative method both are small positive numbers.
fn contacts(
    nodal: &Nodal,
    &Sizes { x: depth, gradient: force }: &Sizes,
    pushes: impl Fn(usize) -> bool,
    place: impl Fn(usize) -> f64,
) -> Vec<Contact> {
    let mut contacts = Vec::new();
    let contact = |first, last, force| Contact { from: place(first), to: place(last), force, end_forces: None };
    // During a run: its first node and the sum of its forces.
    let (mut first, mut sum) = (None, 0.0);
    for (k, (&p, &h)) in nodal.contact_force.iter().zip(&nodal.clearance).enumerate() {
        // h/X ≤ p/G without a division, because most nodes of a fine grid are tested here. Both sides are zero on a foundation
        // without any gap.
        if NO_FORCE * force < p && h * force <= p * depth && !pushes(k) {
            first = first.or(Some(k));
            sum += p;
        } else if let Some(first) = first.take() {
            contacts.push(contact(first, k - 1, std::mem::take(&mut sum)));
        }
    }
    contacts.extend(first.map(|first| contact(first, nodal.contact_force.len() - 1, sum)));
    contacts
}
