//! A beam on springs: ground that gives, `p = k Δ (v − g)` at a node in contact, half of it at an end of the beam. And a beam that changes
//! at some nodes, which has no spring there.
//!
//! With the clearance `h = g − v`, negative where a spring is pressed, in units of force, `s = h EI/Δ³`, and moments in `force · Δ`, the
//! three-moment equations of `contact_set.rs` and equilibrium are
//!
//! ```text
//! (s_{i+1} − s_i)/b − (s_i − s_{i−1})/a − c(M)_i = (ϑ_right + ϑ_left)/6 + (EI/Δ²) bend_i
//! (M_{i+1} − M_i)/b − (M_i − M_{i−1})/a + κ s_i  = −q_i − what the spans on both sides leave there,    κ = k Δ⁴/EI
//! 6 c(M)_i = a M_{i−1} + 2 (a + b) M_i + b M_{i+1}
//! ```
//!
//! `a`, `b` and `ϑ` times `e = EI₀/EI` where the beam is stiffer than elsewhere, and with a joint `c(M)_i + κ_j M_i`, `κ_j = EI₀/k_jΔ`.
//! Where nothing holds the beam, `s` counts from the line through the places on both sides that do. That is
//! a chain of [blocks] of two: no digit is lost by elimination, however soft or stiff the springs and however fine the grid.
//! Eliminating `s` would give five-moment equations, whose condition number grows like `1/κ`. At a support, one that only pushes among them, `κ = ∞`; at the outermost
//! nodes the moment is known.

use super::Discrete;
use super::contact_set::ContactSet;
use super::discrete::as_float;
use super::held_beam::{Beam, NEAR_ZERO, UNITS};
use super::span::{Span, links};
use super::turns::{SOFT, turn};
use crate::qp::NotPositiveDefinite;
use crate::qp::blocks::{self, Block, PENALTY};
use crate::state::Discretisation;

/// A node: its block, `κ`, and the right-hand sides.
#[derive(Default)]
pub(super) struct Row {
    pub(super) block: Block,
    pub(super) spring: f64,
    /// Under an axial force `1 − ν ω` of the link behind it.
    pub(super) fall: f64,
    pub(super) right: [f64; 2],
}

impl AsMut<Block> for Row {
    fn as_mut(&mut self) -> &mut Block {
        &mut self.block
    }
}

impl<S: Fn(usize, usize) -> Span> Beam<'_, S> {
    /// Contact forces on ground so soft that the rounding of the jump of the shear force would change how far it sinks: computed from
    /// that instead.
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

/// Moments at the nodes of a [list](ContactSet) \[force · Δ\], and how far the ground sinks there; where nothing holds the beam its
/// deflection. `outermost` are moments and forces that overhangs leave at its ends.
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
        // Of the two sides of a place that a spring holds against turning the left one is a row of that spring.
        let turning = discrete.supports().turning(node).filter(|_| nodes.get(i + 1) == Some(&node));
        let load = if turning.is_some() { 0.0 } else { discrete.loads[node] } + (left.shares[1] + right.shares[0]);
        let [w, bent, hangs] = if 0 < i && i < end {
            let w = (2.0 * (a + b) + (at_left + at_right)) / 6.0;
            let turned = (left.rotations[1] + right.rotations[0]) / 6.0;
            // Of the line through the places that hold the beam, from which the others count.
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
    // No zero has a sign.
    let moment = |(row, node): (&Row, &usize)| {
        if discrete.divisions().is_hinge(*node) { 0.0 } else { row.block.step[1] + 0.0 }
    };
    Ok([rows.iter().zip(nodes).map(moment).collect(), sunk])
}

/// `κ` of what holds a node of a list, and its force at the level from which the deflection there counts.
pub(super) fn held(discrete: &Discrete, list: &ContactSet, node: usize, unit: f64) -> [f64; 2] {
    if list.is_free(node) {
        return [0.0; 2];
    }
    // A support that gives: its force counts from its own level.
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

/// Adds to the sag of each node that nothing holds the level of the line through the nodes on both sides that do.
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
