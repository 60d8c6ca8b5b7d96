//! Where the beam itself changes on a grid: its bending stiffness, and joints.
//!
//! ```text
//! e = EI₀/EI      of each interval: how much softer than it the softest one is       EI₀: the least bending stiffness
//! κ = EI₀/k_jΔ    of a joint: it turns by κ M in the unit in which an interval turns by e M
//! ```
//!
//! Both are nodes. Between two of them all intervals are alike, and a beam on contacts is a chain of such stretches (`springs.rs`). The
//! parts of the beam between two hinges move by themselves: whether the contacts of a set hold all of them is decided here as well.

use crate::qp::blocks::PENALTY;
use crate::scene::{Grid, Quantity, Scene, SceneError};

/// A hinge in a part of the beam that nothing holds is a joint so many times as soft as an interval: few digits of the rest are left then,
/// but where it goes can be seen.
pub(super) const LOOSE: f64 = 1e12;

/// Bending stiffness and joints at the nodes of a grid.
#[derive(Debug, Clone, PartialEq, Default)]
pub(super) struct Divisions {
    /// `e` from each node on, where it changes; empty of a beam of one stiffness.
    steps: Vec<(usize, f64)>,
    /// The nodes of joints with `κ`, [`PENALTY`] of a hinge.
    joints: Vec<(usize, f64)>,
    /// The nodes of all these, ascending.
    nodes: Vec<usize>,
}

impl Divisions {
    /// Those of a scene on a grid. On a `coarse` one they are at the nearest nodes: it serves for guesses.
    ///
    /// # Errors
    ///
    /// [`SceneError::BetweenNodes`] if there is no node at one of them.
    pub(super) fn on(grid: &Grid, scene: &Scene, coarse: bool) -> Result<Self, SceneError> {
        let beam = scene.beam();
        let node = |quantity: Quantity, at: f64| match grid.node_at(at) {
            Some(node) => Ok(node),
            None if coarse => Ok(grid.nearest(at / beam.length())),
            None => Err(SceneError::BetweenNodes {
                quantity,
                at,
                intervals: grid.intervals(),
                fits: Grid::least_fitting(scene),
            }),
        };
        let mut divisions = Self::default();
        if beam.changes().next().is_some() {
            for (i, [at, stiffness]) in beam.steps().iter().enumerate() {
                let node = node(Quantity::StepAt(i), *at)?;
                divisions.steps.retain(|step| step.0 < node);
                divisions.steps.push((node, beam.bending_stiffness() / stiffness));
            }
        }
        for (i, joint) in beam.joints().iter().enumerate() {
            let soft = |k: f64| beam.bending_stiffness() / (k * grid.spacing());
            let at = node(Quantity::JointAt(i), joint.at)?.clamp(1, grid.intervals() - 1);
            divisions.joints.push((at, joint.stiffness.map_or(PENALTY, soft)));
        }
        divisions.joints.sort_by_key(|joint| joint.0);
        divisions.joints.dedup_by(|next, kept| {
            let same = next.0 == kept.0;
            kept.1 = if same { (kept.1 + next.1).min(PENALTY) } else { kept.1 };
            same
        });
        let steps = divisions.steps.iter().skip(1).map(|step| step.0).filter(|node| *node < grid.intervals());
        divisions.nodes = steps.chain(divisions.joints.iter().map(|joint| joint.0)).collect();
        divisions.nodes.sort_unstable();
        divisions.nodes.dedup();
        Ok(divisions)
    }

    /// All nodes at which the beam changes, ascending.
    pub(super) fn nodes(&self) -> &[usize] {
        &self.nodes
    }

    /// `e` of the interval behind a node.
    #[inline]
    pub(super) fn softness(&self, node: usize) -> f64 {
        match self.steps.as_slice() {
            [] => 1.0,
            steps => steps[steps.partition_point(|step| step.0 <= node).max(1) - 1].1,
        }
    }

    /// `κ` of the joint at a node, zero without one.
    #[inline]
    pub(super) fn joint(&self, node: usize) -> f64 {
        match self.joints.as_slice() {
            [] => 0.0,
            joints => joints.binary_search_by_key(&node, |joint| joint.0).map_or(0.0, |i| joints[i].1),
        }
    }

    /// Whether a hinge is at a node.
    pub(super) fn is_hinge(&self, node: usize) -> bool {
        PENALTY <= self.joint(node)
    }

    /// Whether hinges divide the beam.
    pub(super) fn has_hinges(&self) -> bool {
        self.joints.iter().any(|joint| PENALTY <= joint.1)
    }

    /// Hinges and ends of the beam that have to be held besides some nodes, so that none of the parts between two hinges can move as a rigid
    /// one. Of the nodes that hold it, ascending, each comes with how many motions it prevents: two where it is built in.
    ///
    /// From left to right: up to a hinge a motion may be left that moves the hinge, which the next part may prevent. Any other goes on.
    pub(super) fn unheld(&self, held: &[(usize, usize)], intervals: usize) -> Vec<usize> {
        let hinges = self.joints.iter().filter(|joint| PENALTY <= joint.1).map(|joint| joint.0);
        let (mut missing, mut from, mut moves, mut ahead) = (Vec::new(), 0, 1, held);
        for to in hinges.chain([intervals]) {
            let here;
            (here, ahead) = ahead.split_at(ahead.partition_point(|(node, _)| *node <= to));
            let holds: usize = here.iter().map(|(_, holds)| holds).sum();
            let is_held = here.last().is_some_and(|(node, _)| *node == to);
            let left = (1_usize + moves).saturating_sub(holds);
            let ends: &[usize] = match (to == intervals, left) {
                (_, 0) => &[],
                (true, 2) => &[from, to],
                (true, _) if !is_held => &[to],
                (false, 1) if !is_held => &[],
                _ => &[from],
            };
            missing.extend(ends);
            (from, moves) = (to, left - ends.len());
        }
        missing
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::methods::discrete::as_float;

    /// Of the lines that a beam of rigid parts can be, with a corner in each hinge, how many are zero at all nodes that hold it.
    fn motions(hinges: &[usize], held: &[(usize, usize)]) -> usize {
        let unknowns = hinges.len() + 2;
        let rows: Vec<Vec<f64>> = held
            .iter()
            .flat_map(|&(node, holds)| {
                let corner = |hinge: &usize| as_float(node.saturating_sub(*hinge));
                let line = [1.0, as_float(node)].into_iter().chain(hinges.iter().map(corner)).collect();
                let turn = |hinge: &usize| f64::from(u8::from(hinge < &node));
                let slope = [0.0, 1.0].into_iter().chain(hinges.iter().map(turn)).collect();
                [line, slope].into_iter().take(holds)
            })
            .collect();
        unknowns - rank(rows, unknowns)
    }

    /// How many of some rows of small whole numbers are independent.
    fn rank(mut rows: Vec<Vec<f64>>, columns: usize) -> usize {
        let mut rank = 0;
        for column in 0..columns {
            let size = |i: &usize| rows[*i][column].abs();
            let pivot = (rank..rows.len()).max_by(|i, j| size(i).total_cmp(&size(j))).filter(|i| 1e-9 < size(i));
            let Some(pivot) = pivot else { continue };
            rows.swap(rank, pivot);
            let (done, others) = rows.split_at_mut(rank + 1);
            for row in others {
                let factor = row[column] / done[rank][column];
                row.iter_mut().zip(&done[rank]).for_each(|(value, above)| *value -= factor * above);
            }
            rank += 1;
        }
        rank
    }

    /// Whatever hinges a beam of eight intervals has and whichever nodes hold it: what is missing is enough, and nothing is where nothing
    /// moves.
    #[test]
    fn what_is_missing_holds_every_part() {
        const INTERVALS: usize = 8;
        for pattern in 0..1_usize << 12 {
            let is_in = |bits: usize, node: usize| bits >> node & 1 == 1;
            // Hinges at 2, 3 and 6, not where the beam is built in, and six nodes that may hold it.
            let hinges: Vec<usize> =
                [2, 3, 6].into_iter().enumerate().filter(|(k, _)| is_in(pattern, *k)).map(|(_, node)| node).collect();
            let nodes = [0, 2, 3, 4, 6, 8].into_iter().enumerate().filter(|(k, _)| is_in(pattern, k + 3));
            let wall = [(9, 1), (10, 5), (11, 7)]
                .into_iter()
                .filter(|(bit, _)| is_in(pattern, *bit))
                .map(|(_, node)| (node, 2));
            let mut held: Vec<(usize, usize)> = nodes.map(|(_, node)| (node, 1)).chain(wall).collect();
            held.sort_unstable();
            let divisions =
                Divisions { joints: hinges.iter().map(|node| (*node, PENALTY)).collect(), ..Divisions::default() };
            let missing = divisions.unheld(&held, INTERVALS);
            assert_eq!(missing.is_empty(), motions(&hinges, &held) == 0, "{hinges:?} {held:?}: {missing:?}");
            held.extend(missing.iter().map(|node| (*node, 1)));
            assert_eq!(motions(&hinges, &held), 0, "{hinges:?} {held:?}: {missing:?}");
        }
    }
}
