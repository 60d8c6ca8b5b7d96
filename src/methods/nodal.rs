//! From nodal values to a [`ContactState`]: reactions and moments by statics, contacts by neighbourhood, extremes, energy.

use super::{Discrete, statics};
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

/// The state of the beam that nodal values describe.
#[must_use]
pub fn contact_state(discrete: &Discrete, nodal: Nodal) -> ContactState {
    let Discrete { intervals, spacing, stiffness, .. } = *discrete;
    let loads = discrete.interior_loads();
    let place = |i: usize| discrete.grid.place(i);
    let mut carried: Vec<f64> = loads.iter().zip(&nodal.contact_force).map(|(q, p)| q - p).collect();
    let mut moments = statics::moments(&carried, spacing);
    // The shear forces of the first and the last interval.
    let reactions = Reactions {
        left: moments[1] / spacing + discrete.loads[0],
        right: moments[intervals - 1] / spacing + discrete.loads[intervals],
    };
    let energy = energy(&carried, loads, &nodal.deflection);

    let sizes = discrete.sizes();
    // Ground so close that the beam moves less than its forces are rounded: clearances are that rounding.
    let length = discrete.grid.place(intervals);
    let rounded = AT_REST * sizes.gradient * length * length * length / (48.0 * stiffness);
    let contacts = contacts(&nodal, sizes.x.max(rounded), sizes.gradient, place);
    // Places are counted in intervals until an extreme is found.
    let at_nodes = std::iter::once(0.0).chain(nodal.deflection.iter().copied()).chain([0.0]);
    let seen = Extremes::of(numbered(at_nodes));
    let deflection = match nodal.bending {
        Bending::AtNodes => seen,
        Bending::Between => cubic_extremes(&nodal.deflection, &moments, spacing, stiffness, seen)
            .fold(seen, |found, (k, s, v)| found.beyond(k + s, v)),
    };
    let moment = Extremes::of(numbered(moments.iter().copied()));
    moments.pop();
    moments.remove(0);
    carried.iter_mut().enumerate().for_each(|(k, x)| *x = place(k + 1));
    ContactState {
        regime: Regime::of(&contacts),
        reactions,
        contacts,
        deflection: placed(deflection, &discrete.grid),
        moment: placed(moment, &discrete.grid),
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

/// `J(v) = ½ tᵀv − qᵀv`, since `v = C t`. Summed in blocks: one sum over a fine grid would lose digits that the answer has.
fn energy(carried: &[f64], loads: &[f64], deflection: &[f64]) -> f64 {
    /// About as many terms in a block as there are blocks on a fine grid.
    const BLOCK: usize = 256;
    let blocks = carried.chunks(BLOCK).zip(loads.chunks(BLOCK)).zip(deflection.chunks(BLOCK));
    let sum = |((t, q), v): ((&[f64], &[f64]), &[f64])| -> f64 {
        t.iter().zip(q).zip(v).map(|((t, q), v)| (0.5 * t - q) * v).sum()
    };
    blocks.map(sum).sum()
}

/// Values at node 0, 1, 2, … with the number of the node for their place.
#[expect(clippy::cast_precision_loss, reason = "grids stay far below 2⁵³ nodes")]
fn numbered(values: impl Iterator<Item = f64> + Clone) -> impl Iterator<Item = (f64, f64)> + Clone {
    values.enumerate().map(|(number, value)| (number as f64, value))
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
    let mut contacts: Vec<Contact> = Vec::new();
    let mut previous = false;
    for (k, (&p, &h)) in nodal.contact_force.iter().zip(&nodal.clearance).enumerate() {
        // h/X ≤ p/G without a division: most nodes of a fine grid pass here. Both are zero on ground that leaves no room at all.
        let touches = NO_FORCE * force < p && h * force <= p * depth;
        match contacts.last_mut() {
            Some(run) if touches && previous => {
                run.force += p;
            }
            Some(run) if previous => run.to = place(k),
            _ if touches => {
                let at = place(k + 1);
                contacts.push(Contact { from: at, to: at, force: p, end_forces: None });
            }
            _ => {}
        }
        previous = touches;
    }
    if let Some(run) = contacts.last_mut().filter(|_| previous) {
        run.to = place(nodal.contact_force.len());
    }
    contacts
}

/// Stationary points of the cubic deflection inside the intervals: `(interval, s, v)` with `0 < s < 1`. Intervals that
/// cannot reach beyond what is `seen` at the nodes are passed over: a beam leaves its chord by at most `Δ² max|M| / 8 EI`.
#[expect(clippy::cast_precision_loss, reason = "grids stay far below 2⁵³ nodes")]
fn cubic_extremes<'a>(
    deflection: &'a [f64],
    moments: &'a [f64],
    spacing: f64,
    stiffness: f64,
    seen: Extremes,
) -> impl Iterator<Item = (f64, f64, f64)> + 'a {
    let n = deflection.len();
    let at = move |i: usize| if i == 0 || i == n + 1 { 0.0 } else { deflection[i - 1] };
    let unit = spacing * spacing / (6.0 * stiffness);
    // A plain loop over neighbours: of a million intervals hardly any is left.
    let (most, least) = (seen.max, seen.min);
    let mut near = Vec::new();
    let mut before = 0.0;
    for (k, pair) in moments.windows(2).enumerate() {
        let behind = at(k + 1);
        let reach = 0.75 * unit * pair[0].abs().max(pair[1].abs());
        if most < f64::max(before, behind) + reach || f64::min(before, behind) - reach < least {
            near.push(k);
        }
        before = behind;
    }
    near.into_iter().flat_map(move |k| {
        // With s from 0 to 1, r = 1 − s and m = M Δ²/(6 EI):
        //   v = v₀ r + v₁ s + m₀ r (1 − r²) + m₁ s (1 − s²),   v' = v₁ − v₀ − m₀ (1 − 3 r²) + m₁ (1 − 3 s²).
        let (v0, v1, m0, m1) = (at(k), at(k + 1), unit * moments[k], unit * moments[k + 1]);
        let roots = quadratic_roots(3.0 * (m0 - m1), -6.0 * m0, v1 - v0 + 2.0 * m0 + m1);
        roots.into_iter().flatten().filter(|s| 0.0 < *s && *s < 1.0).map(move |s| {
            let r = 1.0 - s;
            (k as f64, s, v0 * r + v1 * s + m0 * r * (1.0 - r * r) + m1 * s * (1.0 - s * s))
        })
    })
}

/// Real roots of `a s² + b s + c`, without cancellation.
fn quadratic_roots(a: f64, b: f64, c: f64) -> [Option<f64>; 2] {
    let discriminant = b * b - 4.0 * a * c;
    if discriminant.is_nan() || discriminant < 0.0 {
        return [None, None];
    }
    let q = -0.5 * (b + discriminant.sqrt().copysign(b));
    let finite = |root: f64| root.is_finite().then_some(root);
    [finite(q / a), finite(c / q)]
}
