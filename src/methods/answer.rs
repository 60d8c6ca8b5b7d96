//! From nodal values to a [`ContactState`]: reactions and moments by statics, contacts by neighbourhood, extremes at and between the nodes,
//! energy.

use super::extremes::{BLOCK, Values, extremes, shifted};
use super::held_beam::{self, Carried, HeldNode};
use super::{Discrete, general, statics};
use crate::qp::Sizes;
use crate::scene::Grid;
use crate::state::{Contact, ContactState, Discretisation, Extremes, Nodes, Reactions, Regime, SupportForce};

/// What an answer means for the nodes: all but supported ends.
#[derive(Debug, Clone, PartialEq)]
pub struct Nodal {
    /// How the beam bends between the nodes.
    pub discretisation: Discretisation,
    /// Deflection `v`.
    pub deflection: Vec<f64>,
    /// Clearance `h = g − v`.
    pub clearance: Vec<f64>,
    /// Contact forces, zero at supports.
    pub contact_force: Vec<f64>,
}

impl Nodal {
    /// With the deflection `v = g − h`; where the ground lies so deep that this difference has few digits left, or none,
    /// `v = C t` by statics.
    #[must_use]
    pub fn new(
        discrete: &Discrete,
        discretisation: Discretisation,
        mut clearance: Vec<f64>,
        contact_force: Vec<f64>,
    ) -> Self {
        /// Ground this many times as deep as the beam deflects: three of sixteen digits are what the difference may lose, and
        /// more than statics lose on any grid on which the difference would be the better one.
        const DEEP: f64 = 1e3;
        let first = discrete.nodes().start;
        for support in discrete.supports().inner() {
            clearance[support.node - first] = discrete.gap(support.node) - support.held.deflection;
        }
        let mut deflection = discrete.clearances(&clearance);
        let size = DEEP * discrete.sizes().x;
        if discrete.supports().lacking() == 0 && discrete.depths.iter().any(|&u| size < u) {
            let by_statics = by_statics(discrete, &contact_force, discretisation);
            for ((v, &statics), &u) in deflection.iter_mut().zip(&by_statics).zip(&discrete.depths) {
                if size < u {
                    *v = statics;
                }
            }
        }
        Self { discretisation, deflection, clearance, contact_force }
    }
}

/// The deflection that loads and contact forces cause.
fn by_statics(discrete: &Discrete, contact_force: &[f64], discretisation: Discretisation) -> Vec<f64> {
    if !discrete.is_simple() {
        return general::deflection(discrete, contact_force, discretisation);
    }
    let carried: Vec<f64> = discrete.interior_loads().iter().zip(contact_force).map(|(q, p)| q - p).collect();
    discrete.deflection(&carried, discretisation)
}

/// A contact force below this share of all forces is rounding, not contact: a few thousand units in the last place.
const NO_FORCE: f64 = 1e-12;

/// Clearances count from this share of the deflection `P l³/48 EI` that all forces together would cause: what the judge
/// takes for the least that can be measured, sixteen units in the last place over the residual that it certifies.
const AT_REST: f64 = 16.0 * f64::EPSILON / 1e-9;

/// The beam that its supports hold under nodal loads with no foundation: `v = C q`, and no quadratic program to solve.
#[must_use]
pub fn free_beam(discrete: &Discrete, discretisation: Discretisation) -> Nodal {
    let deflection = by_statics(discrete, &vec![0.0; discrete.nodes().len()], discretisation);
    Nodal {
        discretisation,
        clearance: discrete.clearances(&deflection),
        contact_force: vec![0.0; deflection.len()],
        deflection,
    }
}

/// The state of the beam that nodal values describe. Its memory is that of the discrete problem, as far as it goes.
#[must_use]
pub fn contact_state(discrete: Discrete, nodal: Nodal) -> ContactState {
    if !discrete.is_simple() {
        return any_state(&discrete, nodal);
    }
    let sizes = discrete.sizes();
    let Discrete { grid, intervals, spacing, stiffness, .. } = discrete;
    let loads = discrete.into_loads();
    let ends = [loads[0], loads[intervals]];
    let (mut carried, energy) = carried(loads, &nodal);
    let moments = statics::moments(&carried, spacing);
    // The shear forces of the first and the last interval.
    let reactions =
        Reactions { left: moments[0] / spacing + ends[0], right: moments[moments.len() - 1] / spacing + ends[1] };

    let length = grid.place(intervals);
    let contacts = contacts(&nodal, &sizes_of_contact(sizes, stiffness, length), |i| grid.place(i + 1));
    let [deflection, moment] =
        extremes(nodal.discretisation, Values::inside(&nodal.deflection), Values::inside(&moments), spacing, stiffness);
    // The forces are not needed any more.
    grid.places(1, &mut carried);
    ContactState {
        regime: Regime::of(&contacts),
        reactions,
        supports: SupportForce::at_ends(length, reactions),
        standing: None,
        contacts,
        deflection: placed(deflection, &grid),
        moment: placed(moment, &grid),
        energy,
        nodes: Some(Nodes {
            discretisation: nodal.discretisation,
            x: carried,
            deflection: nodal.deflection,
            clearance: nodal.clearance,
            contact_force: nodal.contact_force,
            moment: moments,
        }),
    }
}

/// Sizes of clearance and force by which contact is told. Where the ground is so close that the beam moves less than its forces are
/// rounded, clearances are that rounding.
fn sizes_of_contact(sizes: Sizes, stiffness: f64, length: f64) -> Sizes {
    let rounded = AT_REST * sizes.gradient * length * length * length / (48.0 * stiffness);
    Sizes { x: sizes.x.max(rounded), ..sizes }
}

/// The state of a beam on any supports.
///
/// Their forces are those of the beam on its supports alone, under `q − p`. Of a beam that they do not hold, contact forces are
/// in balance with the loads, and what two more supports carry is what they lack of it.
fn any_state(discrete: &Discrete, nodal: Nodal) -> ContactState {
    let &Discrete { grid, intervals, spacing, stiffness, .. } = discrete;
    let basic = discrete.basic(general::remaining(discrete, &nodal.contact_force));
    let Carried { supports: held, moments, .. } =
        held_beam::on_supports(&basic, nodal.discretisation).unwrap_or_else(|_| Carried::unknown(&basic));
    let mut supports = Vec::new();
    let nodes = discrete.nodes();
    let mut deflection: Vec<f64> = (0..=intervals)
        .map(|node| if nodes.contains(&node) { nodal.deflection[node - nodes.start] } else { discrete.level(node) })
        .collect();
    // J = ½ ∫ M²/EI − ∫ q v, and the first term is half the work of all forces and couples.
    let mut energy = 0.0;
    for support in discrete.supports().all() {
        let Some(HeldNode { force, moments: [left, right], .. }) = held.iter().find(|held| held.node == support.node)
        else {
            continue;
        };
        let moment = support.held.slope.map(|_| held_beam::larger(*left, *right));
        supports.push(SupportForce { at: support.held.at, force: *force, moment });
        energy += 0.5 * ((right - left) * support.held.slope.unwrap_or(0.0) - force * support.held.deflection);
        deflection[support.node] = support.held.deflection;
    }
    for ((q, t), v) in discrete.loads.chunks(BLOCK).zip(basic.loads.chunks(BLOCK)).zip(deflection.chunks(BLOCK)) {
        energy += q.iter().zip(t).zip(v).map(|((q, t), v)| (0.5 * t - q) * v).sum::<f64>();
    }
    let reaction = |node: usize| {
        discrete
            .supports()
            .at(node)
            .and_then(|_| held.iter().find(|held| held.node == node))
            .map_or(0.0, |held| held.force)
    };

    let sizes = sizes_of_contact(discrete.sizes(), stiffness, grid.place(intervals));
    let contacts = contacts(&nodal, &sizes, |i| grid.place(i + nodes.start));
    // Inside a built-in support moments jump: extremes are looked for on each side.
    let jumps = held.iter().filter(|held| 0 < held.node && held.node < intervals);
    let mut found: Option<[Extremes; 2]> = None;
    let mut from = (0, moments[0]);
    for (to, [before, behind]) in
        jumps.map(|held| (held.node, held.moments)).chain([(intervals, [moments[intervals]; 2])])
    {
        let inside = from.0 + 1..to;
        let of =
            |values: &'_ [f64], ends: [f64; 2]| -> (Vec<f64>, [f64; 2]) { (values[inside.clone()].to_vec(), ends) };
        let (v, m) = (of(&deflection, [deflection[from.0], deflection[to]]), of(&moments, [from.1, before]));
        let [v, m] = [&v, &m].map(|(inner, ends)| Values { inner, ends: *ends });
        let part = extremes(nodal.discretisation, v, m, spacing, stiffness).map(|part| shifted(part, from.0));
        found = Some(found.map_or(part, |found| {
            let both = |a: Extremes, b: Extremes| a.beyond(b.max_at, b.max).beyond(b.min_at, b.min);
            [both(found[0], part[0]), both(found[1], part[1])]
        }));
        from = (to, behind);
    }
    let [deflection, moment] = found.unwrap_or_default().map(|extremes| placed(extremes, &grid));
    let mut x = vec![0.0; nodes.len()];
    grid.places(nodes.start, &mut x);
    ContactState {
        regime: Regime::of(&contacts),
        reactions: Reactions { left: reaction(0), right: reaction(intervals) },
        supports,
        standing: None,
        contacts,
        deflection,
        moment,
        energy,
        nodes: Some(Nodes {
            discretisation: nodal.discretisation,
            x,
            deflection: nodal.deflection,
            clearance: nodal.clearance,
            contact_force: nodal.contact_force,
            moment: moments[nodes].to_vec(),
        }),
    }
}

/// `t = q − p` in place of the loads, and `J(v) = ½ tᵀv − qᵀv`, since `v = C t`. Summed in blocks: one sum over a fine grid
/// would lose digits that the answer has.
fn carried(mut loads: Vec<f64>, nodal: &Nodal) -> (Vec<f64>, f64) {
    let mut energy = 0.0;
    let blocks = nodal.contact_force.chunks(BLOCK).zip(nodal.deflection.chunks(BLOCK)).enumerate();
    for (b, (forces, deflection)) in blocks {
        // The load on the left support has no force below it: all move up by one.
        let loads = &mut loads[b * BLOCK..b * BLOCK + forces.len() + 1];
        let mut sum = 0.0;
        for (k, (p, v)) in forces.iter().zip(deflection).enumerate() {
            let q = loads[k + 1];
            loads[k] = q - p;
            sum += (0.5 * loads[k] - q) * v;
        }
        energy += sum;
    }
    loads.truncate(nodal.contact_force.len());
    (loads, energy)
}

/// Extremes with places along the beam instead of numbers of nodes.
fn placed(extremes: Extremes, grid: &Grid) -> Extremes {
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "between 0 and the number of intervals"
    )]
    let place = |number: f64| grid.place(number as usize) + number.fract() * grid.spacing();
    Extremes { max_at: place(extremes.max_at), min_at: place(extremes.min_at), ..extremes }
}

/// Runs of neighbouring nodes in contact, each a zone, or a point if it is a single node.
///
/// `place` is that of a node by its number among those of `nodal`.
///
/// A node is in contact if its force, measured by all forces, is larger than its clearance, measured by the deflection:
/// the natural reading of an answer in which both are small positive numbers.
fn contacts(nodal: &Nodal, &Sizes { x: depth, gradient: force }: &Sizes, place: impl Fn(usize) -> f64) -> Vec<Contact> {
    let mut contacts = Vec::new();
    let contact = |first, last, force| Contact { from: place(first), to: place(last), force, end_forces: None };
    // While a run goes on: its first node, and the sum of its forces.
    let (mut first, mut sum) = (None, 0.0);
    for (k, (&p, &h)) in nodal.contact_force.iter().zip(&nodal.clearance).enumerate() {
        // h/X ≤ p/G without a division: most nodes of a fine grid pass here. Both are zero on ground that leaves no room at all.
        if NO_FORCE * force < p && h * force <= p * depth {
            first = first.or(Some(k));
            sum += p;
        } else if let Some(first) = first.take() {
            contacts.push(contact(first, k - 1, std::mem::take(&mut sum)));
        }
    }
    contacts.extend(first.map(|first| contact(first, nodal.contact_force.len() - 1, sum)));
    contacts
}
