//! A beam on springs: on an elastic foundation, with `p = k Δ (v − g)` at a node in contact and half of it at an end of the beam.
//! Also a beam that changes at some nodes, which have no spring.
//!
//! The clearance `h = g − v` is negative where a spring is compressed. With `s = h EI/Δ³`, in units of force, and moments in
//! `force · Δ`, the three-moment equations of `contact_set.rs` and equilibrium are
//!
//! ```text
//! (s_{i+1} − s_i)/b − (s_i − s_{i−1})/a − c(M)_i = (ϑ_right + ϑ_left)/6 + (EI/Δ²) bend_i
//! (M_{i+1} − M_i)/b − (M_i − M_{i−1})/a + κ s_i  = −q_i − what the spans on both sides leave there,    κ = k Δ⁴/EI
//! 6 c(M)_i = a M_{i−1} + 2 (a + b) M_i + b M_{i+1}
//! ```
//!
//! Where the beam is stiffer than its softest interval, `a`, `b` and `ϑ` are multiplied by `e = EI₀/EI`. A joint changes `c(M)_i` to
//! `c(M)_i + κ_j M_i`, `κ_j = EI₀/k_jΔ`. Where nothing holds the beam, `s` counts from the line through the nearest holding nodes on
//! both sides. The equations are a chain of 2 × 2 [blocks]. Elimination loses no digits, however soft or stiff the springs and
//! however fine the grid. Eliminating `s` would give five-moment equations, whose condition number grows like `1/κ`. At a support,
//! compression-only ones included, `κ = ∞`; at the outermost nodes the moment is known.

use super::Discrete;
use super::contact_set::ContactSet;
use super::discrete::as_float;
use super::held_beam::{Beam, NEAR_ZERO, UNITS};
use super::span::{Span, links};
use super::turns::{SOFT, turn};
use crate::qp::NotPositiveDefinite;
use crate::qp::blocks::{self, Block, PENALTY};
use crate::state::Discretisation;

/// A node: its block, `κ`, and its right-hand sides.
#[derive(Default)]
pub(super) struct Row {
    pub(super) block: Block,
    pub(super) spring: f64,
    /// Under an axial force, `1 − ν ω` of the link to its right.
    pub(super) fall: f64,
    pub(super) right: [f64; 2],
}

impl AsMut<Block> for Row {
    fn as_mut(&mut self) -> &mut Block {
        &mut self.block
    }
}

impl<S: Fn(usize, usize) -> Span> Beam<'_, S> {
    /// Contact forces on a very soft foundation, where rounding of the jump of the shear force would change the settlement. They are
    /// computed from the settlement instead.
    pub(super) fn pressed(&self, mut visit: impl FnMut(usize, f64)) {
        if self.sunk.is_empty() {
            return;
        }
        let largest = self.moments.iter().fold(0.0, |most: f64, moment| most.max(moment.abs()));
        if f64::EPSILON * largest * self.discrete.give_inside() <= NEAR_ZERO * self.discrete.sizes().x {
            return;
        }
        for (i, (&node, sunk)) in self.nodes.iter().zip(&self.sunk).enumerate() {
            let give = self.discrete.give(node);
            if give <= 0.0 || self.is_free(node) || self.is_sprung(node) {
                continue;
            }
            let (force, near) = (sunk / give, i.saturating_sub(1)..self.moments.len().min(i + 2));
            let bent: f64 = self.moments[near].iter().map(|moment| moment.abs()).sum();
            let is_rounding = -force <= UNITS * f64::EPSILON * (self.discrete.loads[node].abs() + bent);
            visit(node, if force < 0.0 && is_rounding { 0.0 } else { force });
        }
    }
}

/// Moments at the nodes of a [list](ContactSet) \[force · Δ\], and the settlement of the foundation there, or the deflection where
/// nothing holds the beam. `outermost` are the moments and forces of overhangs at the two ends.
pub(super) fn solve(
    discrete: &Discrete,
    discretisation: Discretisation,
    list: &ContactSet,
    span: &impl Fn(usize, usize) -> Span,
    outermost: [[f64; 2]; 2],
) -> Result<[Vec<f64>; 2], NotPositiveDefinite> {
    let Discrete { spacing, stiffness, .. } = *discrete;
    let (unit, curved) = (spacing * spacing * spacing / stiffness, stiffness / (spacing * spacing));
    let nodes = list.nodes();
    let (mut rows, mut soft) = (Vec::with_capacity(nodes.len()), Vec::new());
    let (mut left, end, mut before) = (Span::default(), nodes.len() - 1, nodes[0]);
    for (i, &node) in nodes.iter().enumerate() {
        let right = nodes.get(i + 1).map_or_else(Span::default, |next| span(node, *next));
        let [a, b] = [left, right].map(|span| span.soft * span.steps);
        let [at_left, at_right] = [left, right].map(|span| span.soft * links(discretisation, span.steps));
        let is_free = list.is_free(node);
        // A node with a rotational spring is in the list twice. Its left row belongs to that spring.
        let turning = discrete.supports().turning(node).filter(|_| nodes.get(i + 1) == Some(&node));
        let load = if turning.is_some() { 0.0 } else { discrete.loads[node] } + (left.shares[1] + right.shares[0]);
        let [w, bent, hangs] = if 0 < i && i < end {
            let w = (2.0 * (a + b) + (at_left + at_right)) / 6.0;
            let turned = (left.rotations[1] + right.rotations[0]) / 6.0;
            // The bend of the line through the nodes that hold the beam, from which the deflection of the others counts.
            let bend = if is_free { 0.0 } else { list.bend(discrete, [before, node, next_held(list, i)]) };
            let joint = discrete.divisions().joint(node);
            if SOFT < joint {
                soft.push((i, 1.0 / joint));
            }
            [if SOFT < joint { w } else { w + joint }, turned + curved * bend, 0.0]
        } else {
            let [moment, force] = outermost[usize::from(0 < i)];
            [PENALTY, -PENALTY * moment, force]
        };
        let [spring, preload] = if turning.is_some() { [0.0; 2] } else { held(discrete, list, node, unit) };
        let block = Block::new(if 0.0 < right.steps { 1.0 / right.steps } else { 0.0 }, w, (b - at_right) / 6.0);
        let block = turning.map_or(block, |[k, _]| block.turning(k / curved / spacing));
        rows.push(Row { block, spring, fall: 0.0, right: [-(load - preload + hangs), bent] });
        left = right;
        before = if is_free { before } else { node };
    }
    blocks::factor(&mut rows, |row| row.spring);
    blocks::solve(&mut rows, |row| row.right);
    turn(&mut rows, &soft, end)?;
    if let Some((index, pivot)) = rows.iter().enumerate().find_map(|(i, row)| Some((i, row.block.failed()?))) {
        return Err(NotPositiveDefinite { index, pivot });
    }
    let sunk = |row: &Row| if row.spring < PENALTY { -row.block.step[0] * unit } else { 0.0 };
    let mut sunk: Vec<f64> = rows.iter().map(sunk).collect();
    above_chords(discrete, list, &mut sunk);
    // Adding zero removes the sign of a negative zero.
    let moment = |(row, node): (&Row, &usize)| {
        if discrete.divisions().is_hinge(*node) { 0.0 } else { row.block.step[1] + 0.0 }
    };
    Ok([rows.iter().zip(nodes).map(moment).collect(), sunk])
}

/// `κ` of whatever holds a node of a list, and its force at the level from which the deflection there counts.
pub(super) fn held(discrete: &Discrete, list: &ContactSet, node: usize, unit: f64) -> [f64; 2] {
    if list.is_free(node) {
        return [0.0; 2];
    }
    // The force of an elastic support counts from its own level.
    let [own, preload] = list.spring(node).map_or([0.0; 2], |spring| {
        [unit * spring.stiffness, spring.stiffness * (list.level(discrete, node) - spring.deflection)]
    });
    match discrete.give(node) {
        _ if list.is_sprung(node) => [own, 0.0],
        give if give <= 0.0 || discrete.supports().at(node).is_some() => [PENALTY, 0.0],
        give => [unit / give + own, preload],
    }
}

/// The next node of a list that holds the beam.
fn next_held(list: &ContactSet, i: usize) -> usize {
    let mut behind = list.nodes()[i + 1..].iter().copied().filter(|node| !list.is_free(*node));
    behind.next().unwrap_or(list.nodes()[i])
}

/// Adds to the sag of each node that nothing holds the level of the line through the nearest holding nodes on both sides.
fn above_chords(discrete: &Discrete, list: &ContactSet, sunk: &mut [f64]) {
    let nodes = list.nodes();
    let mut held = nodes[0];
    for i in 1..nodes.len() {
        let node = nodes[i];
        if !list.is_free(node) {
            held = node;
            continue;
        }
        let next = next_held(list, i);
        let [from, to] = [held, next].map(|node| list.level(discrete, node));
        sunk[i] += from + (to - from) * (as_float(node - held) / as_float(next - held));
    }
}
