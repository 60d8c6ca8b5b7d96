//! Changes of the beam on a grid: steps of the bending stiffness, and joints.
//!
//! ```text
//! e = EI₀/EI      of each interval: how much softer than it the softest one is       EI₀: the least bending stiffness
//! κ = EI₀/k_jΔ    of a joint: it turns by κ M in the unit in which an interval turns by e M
//! ```
//!
//! Both are at nodes. Between two such nodes all intervals are equal, and a beam on contacts is a chain of such stretches
//! (`springs.rs`). A part of the beam between two hinges can move on its own. This file also decides whether a set of contacts holds
//! all parts.

use crate::qp::blocks::PENALTY;
use crate::scene::{Grid, Quantity, Scene, SceneError};

/// Ratio of the softness of a joint to that of an interval, for a hinge in a part of the beam that nothing holds. Few digits of the
/// rest are then left, but the direction in which the part moves is visible.
pub(super) const LOOSE: f64 = 1e12;

/// Bending stiffness and joints at the nodes of a grid.
#[derive(Debug, Clone, PartialEq, Default)]
pub(super) struct Divisions {
    /// `e` from each node on at which it changes; empty for constant bending stiffness.
    steps: Vec<(usize, f64)>,
    /// The nodes of the joints with `κ`, which is [`PENALTY`] for a hinge.
    joints: Vec<(usize, f64)>,
    /// All nodes at which the beam changes, ascending.
    nodes: Vec<usize>,
}

impl Divisions {
    /// The divisions of a scene on a grid. On a `coarse` grid they are at the nearest nodes, because it serves for guesses only.
    ///
    /// # Errors
    ///
    /// [`SceneError::BetweenNodes`] if one of them is not at a node.
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

    /// `e` of the interval to the right of a node.
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

    /// Whether a node is a hinge.
    pub(super) fn is_hinge(&self, node: usize) -> bool {
        PENALTY <= self.joint(node)
    }

    /// Whether the beam has hinges.
    pub(super) fn has_hinges(&self) -> bool {
        self.joints.iter().any(|joint| PENALTY <= joint.1)
    }

    /// Hinges and ends of the beam that must be held in addition to the given nodes, so that no part between two hinges can move as a
    /// rigid body. `held` lists the nodes that hold the beam, ascending, each with the number of motions that it prevents: two where
    /// the beam is built in.
    ///
    /// The parts are treated from left to right. A part may keep one motion if it moves the hinge at its right end, because the next
    /// part may prevent it. Any other motion has to be prevented here.
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

    /// The number of rigid motions that are left. A beam of rigid parts can take the form of any line with a corner in each hinge;
    /// counted are the independent lines that are zero at all holding nodes.
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

    /// The rank of a matrix of small integers.
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

    /// For all hinges and holding nodes of a beam of eight intervals: the missing nodes are sufficient, and there are none if nothing
    /// can move.
    #[test]
    fn what_is_missing_holds_every_part() {
        const INTERVALS: usize = 8;
        for pattern in 0..1_usize << 12 {
            let is_in = |bits: usize, node: usize| bits >> node & 1 == 1;
            // Hinges at 2, 3 and 6, where the beam is not built in, and six nodes that may hold it.
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
