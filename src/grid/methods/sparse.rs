//! The methods in the variables in which they are sparse: moments beside clearances, or beside contact forces.
//!
//! Methods 1 and 2 minimise the potential energy in clearances `h` and moments `M`, with the curvature as equation; method 3
//! the complementary energy in contact forces `p` and moments, with equilibrium as equation:
//!
//! ```text
//! ½ Σ (Δ/EI) M c(M) + Σ q h    subject to   (Δ/EI) c(M)_i − δ²h_i/Δ = −δ²u_i/Δ,   h ≥ 0
//! ½ Σ (Δ/EI) M c(M) + Σ u p    subject to   δ²M_i/Δ − p_i = −q_i,                 p ≥ 0
//!
//! δ²y_i = y_{i−1} − 2 y_i + y_{i+1};   c(M)_i = M_i, or (M_{i−1} + 4 M_i + M_{i+1})/6 for beam elements
//! ```
//!
//! On ground that gives `h` is the clearance of the foot of a spring, whose compression `s/√kΔ` is one more variable without a sign,
//! with the energy `½ s²`; contact forces have the energy `½ p²/kΔ`.
//!
//! Moments are variables at the nodes where the beam can bend, forces and clearances at those without a support. A built-in
//! support has a moment on each of its sides, each with half a cell.
//!
//! Second differences appear instead of fourth ones: condition numbers are roots of those of `A`.
//!
//! *Scaling.* Energy is measured by `X G`, with the sizes of [`Discrete::sizes`], and each equation is divided by what stands
//! before its second difference. Units of moment and of the variables with a sign were found by measurement, with 300, 3000
//! and 30 000 intervals of the example, among powers of the number of nodes:
//!
//! - potential energy: `M₀ = √(EI X G/Δ)`, which makes the quadratic part `c` itself, and clearances in units of `X/√n`;
//! - complementary energy: `M₀ = G Δ`, which makes equilibrium `δ²M − p = −q` in plain numbers, and forces in units of `G`.
//!
//! With other choices the libraries do not converge on 30 000 intervals, or on 3000.

use super::{Discrete, Method};
use crate::qp::{Sizes, SparseForm, UpperColumns};
use crate::state::Discretisation;

/// A place where the beam can bend and whose moment is a variable: a node inside, on both of its sides, or one side of a built-in
/// support. The moments of other ends are zero.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Hinge {
    node: usize,
    /// Whether it bends towards the interval to its left, and to its right.
    sides: [bool; 2],
}

impl Hinge {
    /// Those of a beam, from left to right; not a hinge of the beam, which has no moment.
    fn all(discrete: &Discrete) -> Vec<Self> {
        let mut hinges = Vec::with_capacity(discrete.intervals);
        for node in (0..=discrete.intervals).filter(|node| !discrete.divisions().is_hinge(*node)) {
            let inside = [0 < node, node < discrete.intervals];
            let built_in = discrete.supports().at(node).is_some_and(|support| support.held.slope.is_some());
            if built_in {
                let halves = [[true, false], [false, true]].into_iter().enumerate();
                hinges.extend(halves.filter(|(side, _)| inside[*side]).map(|(_, sides)| Self { node, sides }));
            } else if inside == [true; 2] {
                hinges.push(Self { node, sides: inside });
            }
        }
        hinges
    }

    /// How many sides it has.
    fn count(&self) -> f64 {
        f64::from(u8::from(self.sides[0]) + u8::from(self.sides[1]))
    }

    /// The three nodes whose deflections bend it; on a side that it does not have its own.
    fn three(&self) -> [usize; 3] {
        [self.node - usize::from(self.sides[0]), self.node, self.node + usize::from(self.sides[1])]
    }

    /// Whether it bends the interval between it and the next one.
    fn meets(&self, next: &Self) -> bool {
        self.node + 1 == next.node && self.sides[1] && next.sides[0]
    }
}

/// What the variables without a sign of a sparse form are, in their order, each with the unit in which it counts: moments, positive where
/// the underside is in tension, and of clearances on ground that gives what the springs are pressed by.
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
    let springs = if discrete.gives() && !method.is_free_in_contact() { discrete.unknowns() } else { 0 };
    let spring = |k| {
        let node = discrete.node(k);
        (
            format!("penetration at x = {:?}", discrete.grid.place(node)),
            depth * spring_unit(discrete, node, depth, force),
        )
    };
    Hinge::all(discrete).iter().map(name).chain((0..springs).map(spring)).collect()
}

/// The units of the variables, as found above.
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

/// What the spring below a node is pressed by in its own unit, in which its energy is `½ s²`, over the unit of clearances.
fn spring_unit(discrete: &Discrete, node: usize, depth: f64, force: f64) -> f64 {
    (discrete.give(node) * force / depth).sqrt()
}

/// Methods 1 and 2: moments, then clearances. `sizes` are those of clearance and gradient in the quadratic program.
pub(super) fn potential(discrete: &Discrete, discretisation: Discretisation, sizes: Sizes) -> SparseForm {
    let (n, hinges) = (discrete.unknowns(), Hinge::all(discrete));
    let fine = fineness(discrete);
    let Sizes { x: depth, gradient: force } = discrete.sizes();
    let (depth, force) = (depth / fine, force * fine);
    // (Δ/EI) M₀ over X/Δ; the same for these units as for X and G, but for the factor √n.
    let coupling = stiffness_number(discrete).sqrt() * fine;
    let curved = |j: usize| curvature(discrete, &hinges, j, discretisation, coupling);
    let mut equations: Vec<_> = (0..hinges.len()).map(curved).collect();
    let mut linear = vec![0.0; hinges.len()];
    // The first hinge that may be bent by an unknown.
    let mut first = 0;
    for node in (0..n).map(|unknown| discrete.node(unknown)) {
        while hinges.get(first).is_some_and(|hinge| hinge.node + 1 < node) {
            first += 1;
        }
        let near = hinges[first..].iter().take_while(|hinge| hinge.node <= node + 1).enumerate();
        let share = |hinge: &Hinge| match hinge.three() {
            [_, own, _] if own == node => hinge.count(),
            [left, _, right] if left == node || right == node => -1.0,
            _ => 0.0,
        };
        let column = near.map(|(k, hinge)| (first + k, share(hinge)));
        equations.push(column.filter(|(_, share)| *share != 0.0).collect());
        linear.push(discrete.loads[node] / force);
    }
    let bend = |hinge: &Hinge| {
        let [left, node, right] = hinge.three();
        -discrete.spacing / depth * discrete.bend(left, node, right)
    };
    let right = hinges.iter().map(bend).collect();
    let sizes = Sizes { x: sizes.x / fine, gradient: sizes.gradient * fine };
    let mut quadratic = quadratic(discrete, &hinges, discretisation, 1.0);
    let mut signed = hinges.len();
    if discrete.gives() {
        // The clearance of the beam is that of the foot of a spring less what that is pressed by, in units of its own.
        let feet = equations.split_off(signed);
        let loads = linear.split_off(signed);
        for (i, (foot, load)) in feet.iter().zip(&loads).enumerate() {
            let unit = spring_unit(discrete, discrete.node(i), depth, force);
            equations.push(foot.iter().map(|(hinge, share)| (*hinge, -unit * share)).collect());
            linear.push(-unit * load);
            quadratic.push(Some(1.0));
        }
        equations.extend(feet);
        linear.extend(loads);
        signed += n;
    }
    (0..n).for_each(|_| quadratic.push(None));
    SparseForm { quadratic, linear, equations, right, signed, sizes }
}

/// Method 3: moments, then contact forces. Levels and slopes of supports do work with the forces and couples that moments put on
/// them. There is no equation for a node with a support that holds it, whose force is what is missing to equilibrium; a node with
/// nothing to touch has one, and no force.
pub(super) fn complementary(discrete: &Discrete, discretisation: Discretisation, sizes: Sizes) -> SparseForm {
    let (n, hinges) = (discrete.unknowns(), Hinge::all(discrete));
    let Sizes { x: depth, gradient: force } = discrete.sizes();
    let mut rows = vec![None; discrete.intervals + 1];
    discrete.free_nodes().enumerate().for_each(|(row, node)| rows[node] = Some(row));
    let mut equations = Vec::with_capacity(hinges.len() + n);
    let mut linear = Vec::with_capacity(hinges.len() + n);
    for hinge in &hinges {
        let [left, node, right] = hinge.three();
        let bends = [(left, 1.0), (node, -hinge.count()), (right, 1.0)];
        // On a side that it does not have, the hinge is not bent.
        let bends = bends.into_iter().enumerate().filter(|(k, (at, _))| *k == 1 || *at != node).map(|(_, bend)| bend);
        equations.push(bends.clone().filter_map(|(node, share)| rows[node].map(|row| (row, share))).collect());
        let held = bends
            .filter_map(|(node, share)| discrete.supports().at(node).map(|support| share * support.held.deflection));
        let slope = discrete.supports().at(node).and_then(|support| support.held.slope).unwrap_or(0.0);
        let turned = if hinge.sides[0] { slope } else { -slope };
        linear.push((held.sum::<f64>() + turned * discrete.spacing) / depth);
    }
    equations.extend(discrete.touchable().filter_map(|node| rows[node]).map(|row| vec![(row, -1.0)]));
    linear.extend((0..n).map(|unknown| discrete.gap(discrete.node(unknown)) / depth));
    let right = discrete.free_nodes().map(|node| -discrete.loads[node] / force).collect();
    let mut quadratic = quadratic(discrete, &hinges, discretisation, stiffness_number(discrete));
    let give = |unknown| discrete.give(discrete.node(unknown)) * force / depth;
    (0..n).for_each(|unknown| quadratic.push(discrete.gives().then(|| give(unknown))));
    SparseForm { quadratic, linear, equations, right, signed: hinges.len(), sizes }
}

/// `G Δ³/(EI X)`: how far a force `G` bends one interval, measured by `X`.
fn stiffness_number(discrete: &Discrete) -> f64 {
    let Discrete { spacing, stiffness, .. } = discrete;
    let Sizes { x: depth, gradient: force } = discrete.sizes();
    force / depth * spacing * spacing * (spacing / stiffness)
}

/// The curvature `c` in column `j` of a symmetric tridiagonal matrix, times a factor: a share of the moment of the hinge itself for
/// each side that it has, as soft as the beam is there, of what a joint turns, and of that of each neighbour.
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
    let left = j.checked_sub(1).filter(|&i| hinges[i].meets(hinge)).map(|i| (i, beside * soft[0]));
    let right = hinges.get(j + 1).filter(|next| hinge.meets(next)).map(|_| (j + 1, beside * soft[1]));
    let own = (soft[0] + soft[1]) * side + divisions.joint(hinge.node);
    let entries = left.into_iter().chain([(j, own)]).chain(right);
    entries.filter(|(_, share)| *share != 0.0).map(|(i, share)| (i, factor * share)).collect()
}

/// The curvature of the moments in `P`, times a factor; nothing of what follows them.
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
