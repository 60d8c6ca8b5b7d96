//! A beam on springs: ground that gives, `p = k Δ (v − g)` at a node in contact, half of it at an end of the beam.
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
//! a chain of [blocks] of two: no digit is lost by elimination, however soft or stiff the springs and however fine the grid.
//! Eliminating `s` would give five-moment equations, whose condition number grows like `1/κ`. At a support, one that only pushes among them, `κ = ∞`; at the outermost
//! nodes the moment is known.

use super::Discrete;
use super::span::{Span, links};
use crate::qp::NotPositiveDefinite;
use crate::qp::blocks::{self, Block, PENALTY};
use crate::state::Discretisation;

/// A node: its block, `κ`, and the right-hand sides.
struct Row {
    block: Block,
    spring: f64,
    right: [f64; 2],
}

impl AsMut<Block> for Row {
    fn as_mut(&mut self) -> &mut Block {
        &mut self.block
    }
}

/// Moments at the nodes of a [list](super::contact_set::ContactSet) \[force · Δ\], and how far the ground sinks there; `outermost` are
/// moments and forces that overhangs leave at its ends.
pub(super) fn solve(
    discrete: &Discrete,
    discretisation: Discretisation,
    nodes: &[usize],
    span: &impl Fn(usize, usize) -> Span,
    outermost: [[f64; 2]; 2],
) -> Result<[Vec<f64>; 2], NotPositiveDefinite> {
    let Discrete { spacing, stiffness, .. } = *discrete;
    let (unit, curved) = (spacing * spacing * spacing / stiffness, stiffness / (spacing * spacing));
    let mut rows = Vec::with_capacity(nodes.len());
    let (mut left, end) = (Span::default(), nodes.len() - 1);
    for (i, &node) in nodes.iter().enumerate() {
        let right = nodes.get(i + 1).map_or_else(Span::default, |next| span(node, *next));
        let (a, b) = (left.steps, right.steps);
        let [at_left, at_right] = [a, b].map(|steps| links(discretisation, steps));
        let load = discrete.loads[node] + (left.shares[1] + right.shares[0]);
        let [w, bent, hangs] = if 0 < i && i < end {
            let w = (2.0 * (a + b) + (at_left + at_right)) / 6.0;
            let turned = (left.rotations[1] + right.rotations[0]) / 6.0;
            [w, turned + curved * discrete.bend(nodes[i - 1], node, nodes[i + 1]), 0.0]
        } else {
            let [moment, force] = outermost[usize::from(0 < i)];
            [PENALTY, -PENALTY * moment, force]
        };
        let is_held = discrete.supports().below(node).is_some();
        let spring = if is_held { PENALTY } else { unit / discrete.give(node) };
        let block = Block::new(if 0.0 < b { 1.0 / b } else { 0.0 }, w, (b - at_right) / 6.0);
        rows.push(Row { block, spring, right: [-(load + hangs), bent] });
        left = right;
    }
    blocks::factor(&mut rows, |row| row.spring);
    blocks::solve(&mut rows, |row| row.right);
    if let Some((index, pivot)) = rows.iter().enumerate().find_map(|(i, row)| Some((i, row.block.failed()?))) {
        return Err(NotPositiveDefinite { index, pivot });
    }
    let sunk = |row: &Row| if row.spring < PENALTY { -row.block.step[0] * unit } else { 0.0 };
    // No zero has a sign.
    Ok([rows.iter().map(|row| row.block.step[1] + 0.0).collect(), rows.iter().map(sunk).collect()])
}
