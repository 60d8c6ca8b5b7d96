//! A beam on springs: ground that gives, `p = k Δ (v − g)` at a node in contact, half of it at an end of the beam.
//!
//! With the clearance `h = g − v`, negative where a spring is pressed, in units of force, `s = h EI/Δ³`, and moments in `force · Δ`,
//!
//! ```text
//! δ²s − c(M) = (EI/Δ²) bend           how the beam bends
//! δ²M + κ s  = −q                      equilibrium,   κ = k Δ⁴/EI in contact, zero elsewhere
//! ```
//!
//! a chain of [blocks] of two: no digit is lost by elimination, however soft or stiff the springs and however fine the grid.
//! Eliminating `s` would give five-moment equations, whose condition number grows like `1/κ`. At a support `κ = ∞`, and where the
//! beam ends without a support that holds its slope `c(M) = ∞ M`. A beam that is built in between its ends is two beams.

use super::Discrete;
use super::contact_set::OnContacts;
use super::sparse::shares;
use crate::memory::zeros;
use crate::qp::NotPositiveDefinite;
use crate::qp::blocks::{self, Block, SWALLOWS};
use crate::state::Discretisation;

/// Rounding of a force or a clearance, in units in the last place of the numbers that it is a difference of.
const UNITS: f64 = 16.0;

/// A node, or one side of a node in which the beam is built in: its block, `κ`, and the right-hand sides.
struct Row {
    node: usize,
    block: Block,
    spring: f64,
    right: [f64; 2],
}

impl AsMut<Block> for Row {
    fn as_mut(&mut self) -> &mut Block {
        &mut self.block
    }
}

impl Row {
    fn new(discrete: &Discrete, discretisation: Discretisation, node: usize, sides: [bool; 2], touches: bool) -> Self {
        let Discrete { spacing, stiffness, .. } = *discrete;
        let support = discrete.supports().at(node);
        let bends = sides == [true; 2] || support.is_some_and(|support| support.held.slope.is_some());
        let bend = || discrete.bend(node - usize::from(sides[0]), node, node + usize::from(sides[1]));
        let [side, beside] = shares(discretisation);
        let count = f64::from(u8::from(sides[0]) + u8::from(sides[1]));
        let [c, off] = if sides[1] { [1.0, beside] } else { [0.0; 2] };
        let spring = match support {
            Some(_) => SWALLOWS,
            None if touches => spacing * spacing * spacing / stiffness / discrete.give(node),
            None => 0.0,
        };
        Self {
            node,
            block: Block::new(c, if bends { count * side } else { SWALLOWS }, off),
            spring,
            right: [
                if support.is_some() { 0.0 } else { -discrete.loads[node] },
                if bends { stiffness / (spacing * spacing) * bend() } else { 0.0 },
            ],
        }
    }
}

/// The beam that touches at some nodes, ascending, and there only.
pub(super) fn solve(
    discrete: &Discrete,
    discretisation: Discretisation,
    contacts: &[usize],
) -> Result<OnContacts, NotPositiveDefinite> {
    let last = discrete.intervals;
    let mut rows = Vec::with_capacity(last + 1 + discrete.supports().all().len());
    let mut contacts = contacts.iter().copied().peekable();
    for node in 0..=last {
        let mut touches = false;
        while contacts.next_if_eq(&node).is_some() {
            touches = true;
        }
        let row = |sides| Row::new(discrete, discretisation, node, sides, touches);
        let inside = [0 < node, node < last];
        let built_in = discrete.supports().at(node).is_some_and(|support| support.held.slope.is_some());
        if built_in && inside == [true; 2] {
            rows.extend([[true, false], [false, true]].map(row));
        } else {
            rows.push(row(inside));
        }
    }
    blocks::factor(&mut rows, |row| row.spring);
    blocks::solve(&mut rows, |row| row.right);
    if let Some((index, pivot)) = rows.iter().enumerate().find_map(|(i, row)| Some((i, row.block.failed()?))) {
        return Err(NotPositiveDefinite { index, pivot });
    }
    let nodes = discrete.nodes();
    let mut found = OnContacts { contact_force: zeros(nodes.len()), clearance: zeros(nodes.len()) };
    let unit = discrete.spacing * discrete.spacing * discrete.spacing / discrete.stiffness;
    for (k, Row { node, block, spring, .. }) in rows.iter().enumerate() {
        let (node, [s, _]) = (*node, block.step);
        if discrete.supports().at(node).is_some() {
            continue;
        }
        let beside = [k.checked_sub(1), Some(k + 1)].map(|k| k.and_then(|k| rows.get(k)).map(|row| row.block.step));
        let small =
            |of: usize| UNITS * f64::EPSILON * beside.into_iter().flatten().map(|beside| beside[of].abs()).sum::<f64>();
        // A sign that may be rounding is none.
        let signed = |value: f64, rounding: f64| if value < 0.0 && -value <= rounding { 0.0 } else { value };
        let i = node - nodes.start;
        if 0.0 < *spring {
            let rounding = small(1) + UNITS * f64::EPSILON * discrete.loads[node].abs();
            found.contact_force[i] = signed(-s * spring, rounding);
        } else {
            let rounding = small(0) * unit + UNITS * f64::EPSILON * discrete.depth_rounding(node);
            found.clearance[i] = signed(s * unit, rounding);
        }
    }
    Ok(found)
}
