//! Sparse forms of the methods: moments together with clearances, or with contact forces.
//!
//! Methods 1 and 2 minimise the potential energy in clearances `h` and moments `M`, with the curvature as equation. Method 3
//! minimises the complementary energy in contact forces `p` and moments, with equilibrium as equation:
//!
//! ```text
//! ½ Σ (Δ/EI) M c(M) + Σ q h    subject to   (Δ/EI) c(M)_i − δ²h_i/Δ = −δ²u_i/Δ,   h ≥ 0
//! ½ Σ (Δ/EI) M c(M) + Σ u p    subject to   δ²M_i/Δ − p_i = −q_i,                 p ≥ 0
//!
//! δ²y_i = y_{i−1} − 2 y_i + y_{i+1};   c(M)_i = M_i, or (M_{i−1} + 4 M_i + M_{i+1})/6 for beam elements
//! ```
//!
//! On an elastic foundation `h` is the clearance of the foot of a spring. The compression `s/√kΔ` of the spring is an additional
//! variable without a sign constraint, with the energy `½ s²`. Contact forces have the energy `½ p²/kΔ`. Elastic supports are
//! variables as well, with one equation each in clearances:
//!
//! ```text
//! s/√k + h = g − d          + h_s of one that only pushes, the clearance of its foot       energy ½ s²
//! R                         a force in the equilibrium of its node                         energy ½ R²/k + d R
//! ```
//!
//! Under tension `N` clearances also have the energy of a string. The force of the string across each interval is a variable of the
//! complementary energy. Under compression neither energy is convex, and the matrix replaces the sparse form:
//!
//! ```text
//! ½ (N/Δ) Σ (h_{i+1} − h_i)² + Σ N bend_i h_i        ½ (Δ/N) Σ T²,  in equilibrium T_i − T_{i−1}
//! ```
//!
//! Moments are variables at the nodes where the beam can bend, and forces and clearances at the nodes without a support. A support
//! that holds the slope has a moment on each of its sides, each with half a cell. With a rotational spring the jump of the moment has
//! the energy `½ (ΔM)²/k`.
//!
//! Second differences replace fourth differences, so condition numbers are square roots of those of `A`.
//!
//! *Scaling.* Energy is divided by `X G`, with the sizes of [`Discrete::sizes`], and each equation by the coefficient of its second
//! difference. The units of moments and of variables with a sign constraint were tuned by measurement, with 300, 3000 and 30 000
//! intervals of the example, among powers of the number of nodes:
//!
//! - potential energy: `M₀ = √(EI X G/Δ)`, which makes the quadratic part equal to `c`, and clearances in units of `X/√n`;
//! - complementary energy: `M₀ = G Δ`, which gives equilibrium `δ²M − p = −q` coefficients of one, and forces in units of `G`.
//!
//! With other choices the solvers of the libraries do not converge on 30 000 intervals, or on 3000.

mod string;

use self::string::{PulledClearances, pulled_down, string_forces};
use super::axial::Link;
use super::supports::NodeSpring;
use super::{Discrete, Method};
use crate::qp::{Sizes, SparseForm, UpperColumns};
use crate::state::Discretisation;

/// A position where the beam can bend and whose moment is a variable: a node inside the beam with both of its sides, or one side of a
/// built-in support. The moments of other ends are zero.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Hinge {
    node: usize,
    /// Whether the position includes the interval to its left and the one to its right.
    sides: [bool; 2],
}

impl Hinge {
    /// All such positions of a beam, from left to right. Hinges of the beam itself are left out, because their moment is zero.
    fn all(discrete: &Discrete) -> Vec<Self> {
        let mut hinges = Vec::with_capacity(discrete.intervals);
        for node in (0..=discrete.intervals).filter(|node| !discrete.divisions().is_hinge(*node)) {
            let inside = [0 < node, node < discrete.intervals];
            if discrete.supports().slope(node).is_some() {
                let halves = [[true, false], [false, true]].into_iter().enumerate();
                hinges.extend(halves.filter(|(side, _)| inside[*side]).map(|(_, sides)| Self { node, sides }));
            } else if inside == [true; 2] {
                hinges.push(Self { node, sides: inside });
            }
        }
        hinges
    }

    /// Number of sides.
    fn count(&self) -> f64 {
        f64::from(u8::from(self.sides[0]) + u8::from(self.sides[1]))
    }

    /// The three nodes whose deflections bend it. For a missing side its own node is given twice.
    fn three(&self) -> [usize; 3] {
        [self.node - usize::from(self.sides[0]), self.node, self.node + usize::from(self.sides[1])]
    }

    /// Whether both this and the next one bend the interval between them.
    fn meets(&self, next: &Self) -> bool {
        self.node + 1 == next.node && self.sides[1] && next.sides[0]
    }
}

/// The variables of a sparse form without a sign constraint, in their order, each with its name and its unit. Moments come first,
/// positive with the underside in tension. In clearances they are followed by the compression of the springs of an elastic foundation
/// and of elastic supports, and by the clearances of open nodes. In contact forces they are followed by the forces of elastic
/// supports and of the string.
#[must_use]
pub fn unsigned(discrete: &Discrete, method: Method) -> Vec<(String, f64)> {
    let Units { depth, force, moment } = Units::of(discrete, method);
    let name = |hinge: &Hinge| {
        let side = match hinge.sides {
            [true, false] => "left of",
            [false, true] => "right of",
            _ => "at",
        };
        (format!("moment {side} x = {:?}", discrete.grid.place(hinge.node)), moment)
    };
    let clearances = !method.is_free_in_contact();
    let ground: Vec<usize> = if discrete.gives() && clearances { discrete.touchable().collect() } else { Vec::new() };
    let pressed = |node| {
        let unit = depth * spring_unit(discrete.give(node), depth, force);
        (format!("penetration at x = {:?}", discrete.grid.place(node)), unit)
    };
    let stands = |spring: &NodeSpring| match clearances {
        true => (
            format!("how far the support at x = {:?} is pressed", spring.at),
            depth * spring_unit(1.0 / spring.stiffness, depth, force),
        ),
        false => (format!("force of the support at x = {:?}", spring.at), force * spring_force(spring, depth, force)),
    };
    let strings = if clearances { Vec::new() } else { string_forces(discrete, [depth, force]) };
    let along = |(node, unit): (usize, &f64)| {
        let places = [node, node + 1].map(|node| discrete.grid.place(node));
        (format!("vertical part of the tension between x = {:?} and x = {:?}", places[0], places[1]), force * unit)
    };
    let [springs, stops] = [discrete.supports().springs(), discrete.supports().stops()];
    let supports = springs.iter().chain(if clearances { stops } else { &[] });
    let open = discrete.free_nodes().filter(|node| clearances && discrete.is_open_at(*node));
    let clear = |node| (format!("clearance at x = {:?}", discrete.grid.place(node)), depth);
    let pressed = ground.into_iter().map(pressed);
    let all = Hinge::all(discrete).iter().map(name).chain(pressed).chain(supports.map(stands)).collect::<Vec<_>>();
    all.into_iter().chain(strings.iter().enumerate().map(along)).chain(open.map(clear)).collect()
}

/// The units of the variables, as given above.
struct Units {
    depth: f64,
    force: f64,
    moment: f64,
}

impl Units {
    fn of(discrete: &Discrete, method: Method) -> Self {
        let Sizes { x: depth, gradient: force } = discrete.sizes();
        let Discrete { spacing, stiffness, .. } = *discrete;
        if method.is_free_in_contact() {
            return Self { depth, force, moment: force * spacing };
        }
        let fine = fineness(discrete);
        let (depth, force) = (depth / fine, force * fine);
        Self { depth, force, moment: (stiffness / spacing * depth).sqrt() * force.sqrt() }
    }
}

/// `√n`.
#[expect(clippy::cast_precision_loss, reason = "grids stay far below 2⁵³ nodes")]
fn fineness(discrete: &Discrete) -> f64 {
    (discrete.unknowns() as f64).sqrt()
}

/// The unit of the compression of a spring with the given flexibility, in which its energy is `½ s²`, relative to the unit of clearances.
fn spring_unit(give: f64, depth: f64, force: f64) -> f64 {
    (give * force / depth).sqrt()
}

/// The unit of the force of a spring relative to the unit of forces. For a soft spring it is smaller, so that the energy is `½ s²`.
fn spring_force(spring: &NodeSpring, depth: f64, force: f64) -> f64 {
    (1.0 / spring_unit(1.0 / spring.stiffness, depth, force)).min(1.0)
}

/// The equations of elastic supports, compression-only ones last: for each its node, and the coefficients of its compression and of
/// the clearance of its node. The right-hand sides are appended to `right`.
fn sprung(discrete: &Discrete, [depth, force]: [f64; 2], right: &mut Vec<f64>) -> Vec<(usize, [f64; 2])> {
    let supports = discrete.supports();
    let equation = |spring: &NodeSpring| {
        let unit = spring_unit(1.0 / spring.stiffness, depth, force);
        let share = (1.0 / unit).min(1.0);
        right.push(share * ((discrete.gap(spring.node) - spring.deflection) / depth));
        (spring.node, [share * unit, share])
    };
    supports.springs().iter().chain(supports.stops()).map(equation).collect()
}

/// The bend of each hinge by a unit clearance of a node, with `first` the first hinge that the node can bend.
fn bends(hinges: &[Hinge], first: usize, node: usize) -> impl Iterator<Item = (usize, f64)> + '_ {
    let near = hinges[first..].iter().take_while(move |hinge| hinge.node <= node + 1).enumerate();
    let share = move |hinge: &Hinge| match hinge.three() {
        [_, own, _] if own == node => hinge.count(),
        [left, _, right] if left == node || right == node => -1.0,
        _ => 0.0,
    };
    near.map(move |(k, hinge)| (first + k, share(hinge))).filter(|(_, share)| *share != 0.0)
}

/// Methods 1 and 2: moments, then compressions of springs and elastic supports, then clearances. `sizes` are those of clearance and
/// gradient in the quadratic program.
pub(super) fn potential(discrete: &Discrete, discretisation: Discretisation, sizes: Sizes) -> SparseForm {
    let hinges = Hinge::all(discrete);
    let fine = fineness(discrete);
    let Sizes { x: depth, gradient: force } = discrete.sizes();
    let (depth, force) = (depth / fine, force * fine);
    // (Δ/EI) M₀ over X/Δ. It is the same for these units as for X and G, except for the factor √n.
    let coupling = stiffness_number(discrete).sqrt() * fine;
    let curved = |j: usize| curvature(discrete, &hinges, j, discretisation, coupling);
    let mut equations: Vec<_> = (0..hinges.len()).map(curved).collect();
    let mut linear = vec![0.0; hinges.len()];
    let bend = |hinge: &Hinge| {
        let [left, node, right] = hinge.three();
        -discrete.spacing / depth * discrete.bend(left, node, right)
    };
    let mut right: Vec<f64> = hinges.iter().map(bend).collect();
    let stands = sprung(discrete, [depth, force], &mut right);
    let row = |k: usize| hinges.len() + k;
    let column = |node: usize| {
        let own =
            stands.iter().enumerate().filter(|(_, (at, _))| *at == node).map(|(k, (_, shares))| (row(k), shares[1]));
        let first = hinges.partition_point(|hinge| hinge.node + 1 < node);
        bends(&hinges, first, node).chain(own).collect::<Vec<_>>()
    };
    let columns = discrete.free_nodes().map(|node| (node, column(node)));
    let (columns, open): (Vec<_>, Vec<_>) = columns.partition(|(node, _)| !discrete.is_open_at(*node));
    let mut string = PulledClearances::of(discrete);
    let load = |node: usize| discrete.loads[node] + pulled_down(discrete, node);
    let mut quadratic = quadratic(discrete, &hinges, discretisation, 1.0);
    if discrete.gives() {
        // The clearance of the beam is the clearance of the foot of a spring less its compression, which has its own unit.
        for (node, foot) in &columns {
            let unit = spring_unit(discrete.give(*node), depth, force);
            equations.push(foot.iter().map(|(row, share)| (*row, -unit * share)).collect());
            string.moves(*node, linear.len(), -unit);
            linear.push(-unit * (load(*node) / force));
            quadratic.push(Some(1.0));
        }
    }
    for (k, (_, [pressed, _])) in stands.iter().enumerate() {
        equations.push(vec![(row(k), *pressed)]);
        linear.push(0.0);
        quadratic.push(Some(1.0));
    }
    // A clearance at a node with nothing to touch has no sign constraint.
    let signed = linear.len() + open.len();
    for (node, clearance) in open.into_iter().chain(columns) {
        equations.push(clearance);
        string.moves(node, linear.len(), 1.0);
        linear.push(load(node) / force);
        quadratic.push(None);
    }
    for (k, (_, [_, share])) in stands.iter().enumerate().skip(discrete.supports().springs().len()) {
        equations.push(vec![(row(k), -share)]);
        linear.push(0.0);
        quadratic.push(None);
    }
    let sizes = Sizes { x: sizes.x / fine, gradient: sizes.gradient * fine };
    let quadratic = string.added_to(quadratic, discrete.tension / discrete.spacing * (depth / force));
    SparseForm { quadratic, linear, equations, right, signed, sizes }
}

/// Method 3: moments, then forces of elastic supports and of the string, then contact forces. Levels and slopes of supports do work
/// with the reactions that moments cause there. A node with a rigid support has no equation, because its reaction balances it. A node
/// with nothing to touch has an equation, and no force.
pub(super) fn complementary(discrete: &Discrete, discretisation: Discretisation, sizes: Sizes) -> SparseForm {
    let hinges = Hinge::all(discrete);
    let Sizes { x: depth, gradient: force } = discrete.sizes();
    let mut rows = vec![None; discrete.intervals + 1];
    discrete.free_nodes().enumerate().for_each(|(row, node)| rows[node] = Some(row));
    let mut equations = Vec::with_capacity(hinges.len() + discrete.unknowns());
    let mut linear = Vec::with_capacity(hinges.len() + discrete.unknowns());
    for hinge in &hinges {
        let [left, node, right] = hinge.three();
        let bends = [(left, 1.0), (node, -hinge.count()), (right, 1.0)];
        // A missing side does not bend the hinge.
        let bends = bends.into_iter().enumerate().filter(|(k, (at, _))| *k == 1 || *at != node).map(|(_, bend)| bend);
        equations.push(bends.clone().filter_map(|(node, share)| rows[node].map(|row| (row, share))).collect());
        let held = bends
            .filter_map(|(node, share)| discrete.supports().at(node).map(|support| share * support.held.deflection));
        let slope = discrete.supports().slope(node).unwrap_or(0.0);
        let turned = if hinge.sides[0] { slope } else { -slope };
        linear.push((held.sum::<f64>() + turned * discrete.spacing) / depth);
    }
    // Forces of elastic supports, with their work at their own levels.
    let springs = discrete.supports().springs();
    let unit = |spring: &NodeSpring| spring_force(spring, depth, force);
    let acts = |spring: &NodeSpring| rows[spring.node].map(|row| vec![(row, -unit(spring))]);
    equations.extend(springs.iter().filter_map(acts));
    linear.extend(springs.iter().map(|spring| unit(spring) * (spring.deflection / depth)));
    let strings = string_forces(discrete, [depth, force]);
    for (node, unit) in strings.iter().enumerate() {
        let ends = [(node, *unit), (node + 1, -unit)];
        equations.push(ends.iter().filter_map(|(node, share)| Some((rows[*node]?, *share))).collect());
        let held = ends.iter().filter_map(|(node, share)| Some(share * discrete.supports().at(*node)?.held.deflection));
        linear.push(held.sum::<f64>() / depth);
    }
    equations.extend(discrete.places().filter_map(|place| rows[discrete.node_of(place)]).map(|row| vec![(row, -1.0)]));
    linear.extend(discrete.places().map(|place| discrete.depth_of(place) / depth));
    let right = discrete.free_nodes().map(|node| -discrete.loads[node] / force).collect();
    let mut quadratic = quadratic(discrete, &hinges, discretisation, stiffness_number(discrete));
    let taken = |spring: &NodeSpring| unit(spring) * unit(spring) * (force / depth / spring.stiffness);
    springs.iter().for_each(|spring| quadratic.push(Some(taken(spring))));
    let stretched = |unit: &f64| unit * unit * (force / depth * discrete.spacing / discrete.tension);
    strings.iter().for_each(|unit| quadratic.push(Some(stretched(unit))));
    let give = |place| discrete.give_of(place) * force / depth;
    discrete.places().map(give).for_each(|give| quadratic.push((discrete.gives() || 0.0 < give).then_some(give)));
    let signed = hinges.len() + springs.len() + strings.len();
    SparseForm { quadratic, linear, equations, right, signed, sizes }
}

/// `G Δ³/(EI X)`: the deflection of one interval under a force `G`, relative to `X`.
fn stiffness_number(discrete: &Discrete) -> f64 {
    let Discrete { spacing, stiffness, .. } = discrete;
    let Sizes { x: depth, gradient: force } = discrete.sizes();
    force / depth * spacing * spacing * (spacing / stiffness)
}

/// Column `j` of the symmetric tridiagonal matrix of the curvature `c`, times a factor. The moment of the hinge itself has a share
/// for each of its sides, by the softness of the beam there, and for the rotation of a joint. The moment of each neighbour has one
/// share.
fn curvature(
    discrete: &Discrete,
    hinges: &[Hinge],
    j: usize,
    discretisation: Discretisation,
    factor: f64,
) -> Vec<(usize, f64)> {
    let (side, beside) = match discretisation {
        Discretisation::FiniteDifferences => (0.5, 0.0),
        Discretisation::BeamElements => (2.0 / 6.0, 1.0 / 6.0),
    };
    let hinge = &hinges[j];
    let divisions = discrete.divisions();
    let soft = [0, 1].map(|right| match hinge.sides[right] {
        false => 0.0,
        true => divisions.softness((hinge.node + right).saturating_sub(1)),
    });
    // A rotational spring carries the jump of the moment at its node.
    let turned =
        discrete.supports().turning(hinge.node).map_or(0.0, |[k, _]| discrete.stiffness / k / discrete.spacing);
    // Under an axial force.
    let pull = discrete.pull();
    let links = (pull != 0.0).then(|| soft.map(|soft| Link::of(discretisation, pull, soft)));
    let across = [0, 1].map(|side| links.map_or(beside * soft[side], |links| links[side].far));
    let share = |other: &Hinge, far: f64| match (hinge.meets(other) || other.meets(hinge), other.node == hinge.node) {
        (true, _) => Some(far),
        (_, true) if 0.0 < turned => Some(-turned),
        _ => None,
    };
    let left = j.checked_sub(1).and_then(|i| Some((i, share(&hinges[i], across[0])?)));
    let right = hinges.get(j + 1).and_then(|next| Some((j + 1, share(next, across[1])?)));
    let both = match links {
        Some([left, right]) => left.near + right.near,
        None => (soft[0] + soft[1]) * side,
    };
    let own = both + divisions.joint(hinge.node) + turned;
    let entries = left.into_iter().chain([(j, own)]).chain(right);
    entries.filter(|(_, share)| *share != 0.0).map(|(i, share)| (i, factor * share)).collect()
}

/// The curvature of the moments as `P`, times a factor, without the variables that follow the moments.
fn quadratic(discrete: &Discrete, hinges: &[Hinge], discretisation: Discretisation, factor: f64) -> UpperColumns {
    let mut columns = UpperColumns::default();
    for j in 0..hinges.len() {
        columns.starts.push(columns.rows.len());
        let column = curvature(discrete, hinges, j, discretisation, factor);
        for (i, value) in column.into_iter().filter(|(i, _)| *i <= j) {
            columns.rows.push(i);
            columns.values.push(value);
        }
    }
    columns.starts.push(columns.rows.len());
    columns
}
