//! From nodal values to a [`ContactState`]: reactions and moments by statics, contacts by neighbourhood, extremes at and between the nodes,
//! energy.

use super::{Discrete, statics};
use crate::scene::Grid;
use crate::state::{Contact, ContactState, Discretisation, Extremes, Nodes, Reactions, Regime, SupportForce};

/// What an answer means for the interior nodes.
#[derive(Debug, Clone, PartialEq)]
pub struct Nodal {
    /// How the beam bends between the nodes.
    pub discretisation: Discretisation,
    /// Deflection `v_1 … v_n`.
    pub deflection: Vec<f64>,
    /// Clearance `h = u − v`.
    pub clearance: Vec<f64>,
    /// Contact forces.
    pub contact_force: Vec<f64>,
}

impl Nodal {
    /// With the deflection `v = u − h`; where the ground lies so deep that this difference has few digits left, or none,
    /// `v = C t` by statics.
    #[must_use]
    pub fn new(
        discrete: &Discrete,
        discretisation: Discretisation,
        clearance: Vec<f64>,
        contact_force: Vec<f64>,
    ) -> Self {
        /// Ground this many times as deep as the beam deflects: three of sixteen digits are what the difference may lose, and
        /// more than statics lose on any grid on which the difference would be the better one.
        const DEEP: f64 = 1e3;
        let mut deflection = discrete.clearances(&clearance);
        let size = DEEP * discrete.sizes().x;
        if discrete.depths.iter().any(|&u| size < u) {
            let carried: Vec<f64> = discrete.interior_loads().iter().zip(&contact_force).map(|(q, p)| q - p).collect();
            let by_statics = discrete.deflection(&carried, discretisation);
            for ((v, &statics), &u) in deflection.iter_mut().zip(&by_statics).zip(&discrete.depths) {
                if size < u {
                    *v = statics;
                }
            }
        }
        Self { discretisation, deflection, clearance, contact_force }
    }
}

/// A contact force below this share of all forces is rounding, not contact: a few thousand units in the last place.
const NO_FORCE: f64 = 1e-12;

/// Clearances count from this share of the deflection `P l³/48 EI` that all forces together would cause: what the judge
/// takes for the least that can be measured, sixteen units in the last place over the residual that it certifies.
const AT_REST: f64 = 16.0 * f64::EPSILON / 1e-9;

/// The beam under nodal loads with no foundation: `v = C q`, and no quadratic program to solve.
#[must_use]
pub fn free_beam(discrete: &Discrete, discretisation: Discretisation) -> Nodal {
    let deflection = discrete.deflection(discrete.interior_loads(), discretisation);
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
    let seen = nodal_extremes(&nodal.deflection);
    let deflection = match nodal.discretisation {
        Discretisation::FiniteDifferences => seen,
        Discretisation::BeamElements => {
            cubic_extremes(&nodal.deflection, &moments, spacing * spacing / (6.0 * stiffness), seen)
        }
    };
    let moment = nodal_extremes(&moments);
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

/// Nodes that are looked at together for extremes: most blocks of a fine grid are far from any.
const BLOCK: usize = 256;

/// Extremes of values at the inner nodes of a beam that has zero at both ends; places are counted in intervals.
pub(super) fn nodal_extremes(values: &[f64]) -> Extremes {
    let [max, min] = wider(range(values), [0.0; 2]);
    Extremes::known(max, min, |extreme, equal| near(values, extreme, equal))
}

/// Pairs of node and value that show all values within `equal` of an extreme, and one of each block that has none.
fn near(values: &[f64], extreme: f64, equal: f64) -> impl Iterator<Item = (f64, f64)> + '_ {
    let blocks = values.chunks(BLOCK).enumerate().flat_map(move |(b, block)| {
        let is_near = block.iter().fold(false, |near, value| near | ((value - extreme).abs() <= equal));
        numbered(b * BLOCK + 1, if is_near { block } else { &block[..1] })
    });
    numbered(0, &[0.0]).chain(blocks).chain(numbered(values.len() + 1, &[0.0]))
}

/// Values at node `first` and those right of it, with the number of the node for their place.
fn numbered(first: usize, values: &[f64]) -> impl Iterator<Item = (f64, f64)> + '_ {
    values.iter().enumerate().map(move |(k, value)| (number(first + k), *value))
}

#[expect(clippy::cast_precision_loss, reason = "grids stay far below 2⁵³ nodes")]
fn number(node: usize) -> f64 {
    node as f64
}

/// Greatest and least of some values, which may be no numbers. Each of four lanes depends on itself only.
fn range(values: &[f64]) -> [f64; 2] {
    const LANES: usize = 4;
    let (mut max, mut min) = ([f64::NEG_INFINITY; LANES], [f64::INFINITY; LANES]);
    let (all, rest) = values.as_chunks::<LANES>();
    for four in all {
        for k in 0..LANES {
            [max[k], min[k]] = wider([max[k], min[k]], [four[k]; 2]);
        }
    }
    let lanes = max.into_iter().zip(min).map(|(max, min)| [max, min]);
    lanes.chain(rest.iter().map(|value| [*value; 2])).reduce(wider).unwrap_or_default()
}

/// Not `max` and `min`: a comparison is all that a number needs.
fn wider([max, min]: [f64; 2], [above, below]: [f64; 2]) -> [f64; 2] {
    [if max < above { above } else { max }, if below < min { below } else { min }]
}

/// Extremes of the deflection, `seen` at the nodes already, with those inside the intervals; `unit` is `Δ²/6EI`.
///
/// Intervals that cannot reach beyond what is seen at the nodes are passed over: a beam leaves its chord by at most
/// `Δ² max|M| / 8 EI`.
pub(super) fn cubic_extremes(deflection: &[f64], moments: &[f64], unit: f64, seen: Extremes) -> Extremes {
    let beyond = |[highest, lowest]: [f64; 2], [most, least]: [f64; 2]| {
        let reach = 0.75 * unit * most.abs().max(least.abs());
        seen.max < highest + reach || lowest - reach < seen.min
    };
    let at = |values: &[f64], node: usize| if node == 0 { 0.0 } else { values.get(node - 1).copied().unwrap_or(0.0) };
    let intervals = deflection.len() + 1;
    let mut found = seen;
    for first in (0..intervals).step_by(BLOCK) {
        let end = intervals.min(first + BLOCK);
        let inner = first.max(1) - 1..end.min(deflection.len());
        // The ends of the beam are seen as well.
        let of_block = |values: &[f64]| {
            let ends = [at(values, first), at(values, end)].map(|value| [value; 2]);
            ends.into_iter().fold(range(&values[inner.clone()]), wider)
        };
        if !beyond(of_block(deflection), of_block(moments)) {
            continue;
        }
        for k in first..end {
            let [v, m] = [deflection, moments].map(|values| [at(values, k), at(values, k + 1)]);
            if beyond([v[0].max(v[1]), v[0].min(v[1])], m) {
                found = stationary(v, m.map(|m| unit * m)).fold(found, |found, [s, v]| found.beyond(number(k) + s, v));
            }
        }
    }
    found
}

/// Stationary points inside an interval, `[s, v]` with `0 < s < 1`, for deflections and `m = M Δ²/6EI` at its ends.
///
/// ```text
/// v = v₀ r + v₁ s + m₀ r (1 − r²) + m₁ s (1 − s²),   v' = v₁ − v₀ − m₀ (1 − 3 r²) + m₁ (1 − 3 s²),    r = 1 − s
/// ```
fn stationary([v0, v1]: [f64; 2], [m0, m1]: [f64; 2]) -> impl Iterator<Item = [f64; 2]> {
    let roots = quadratic_roots(3.0 * (m0 - m1), -6.0 * m0, v1 - v0 + 2.0 * m0 + m1);
    roots.into_iter().flatten().filter(|s| 0.0 < *s && *s < 1.0).map(move |s| {
        let r = 1.0 - s;
        [s, v0 * r + v1 * s + m0 * r * (1.0 - r * r) + m1 * s * (1.0 - s * s)]
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

#[cfg(test)]
mod tests {
    use super::{BLOCK, nodal_extremes};
    use crate::state::Extremes;

    /// Plateaus within, across and at the ends of blocks, and equal peaks far apart.
    #[test]
    fn extremes_are_those_of_all_values_one_by_one() {
        let hill = |from: usize, to: usize, top: f64| {
            (1..=1000_usize).map(|i| if (from..=to).contains(&i) { top } else { 1e-3 * (i % 7) as f64 }).collect()
        };
        let mut cases: Vec<Vec<f64>> = vec![Vec::new(), vec![0.0; 3], vec![-1.0], vec![2.0; 2 * BLOCK]];
        for (from, to) in [(10, 10), (10, 20), (BLOCK, BLOCK), (BLOCK, BLOCK + 1), (200, 900), (1, 1000), (900, 1000)] {
            cases.extend([1.0, -1.0].map(|top| hill(from, to, top)));
        }
        let mut peaks: Vec<f64> = hill(3, 3, 1.0);
        peaks[700] = 1.0 + 1e-15;
        peaks[701] = 1.0;
        cases.push(peaks);
        for values in cases {
            let zero = std::iter::once(0.0);
            let all = zero.clone().chain(values.iter().copied()).chain(zero);
            let expected = Extremes::of((0_i32..).map(f64::from).zip(all).collect::<Vec<_>>());
            assert_eq!(nodal_extremes(&values), expected, "{} values", values.len());
        }
    }
}
