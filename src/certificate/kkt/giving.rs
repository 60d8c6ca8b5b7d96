//! The deviation of elastic supports from their laws, and the slopes that supports hold: part of the residual of a discrete problem.

use std::collections::BTreeMap;

use super::{Recorded, RecordedSupport, largest, largest_each};
use crate::certificate::summed::Change;
use crate::scene::{Grid, Scene, Spring};
use crate::state::{Nodes, SupportForce};

/// The slope that a support holds, rigidly or by a rotational spring, with the couple that it exerts in the state.
#[derive(Debug, Clone, Copy)]
pub(super) struct Slope {
    node: usize,
    held: f64,
    stiffness: f64,
    couple: f64,
}

impl Slope {
    /// The slope of the beam there.
    pub(super) fn turned(&self) -> f64 {
        self.held - self.couple / self.stiffness
    }
}

impl Recorded<'_> {
    /// The largest deviations of springs. For compression-only springs: penetration below the foot, tension, and force across a
    /// clearance from the foot. For all springs: the deviation from the law, as a force or as a deflection, whichever share is smaller.
    pub(super) fn of_springs(&self, [force, depth]: [f64; 2]) -> [f64; 4] {
        let of = |(node, spring, recorded): &(usize, Spring, SupportForce)| {
            let v =
                node.checked_sub(self.first).and_then(|i| self.nodes.deflection.get(i)).copied().unwrap_or(f64::NAN);
            let (pressed, r) = (v - spring.deflection, recorded.force);
            let misfit = |pressed: f64| {
                let off = spring.stiffness * pressed - r;
                smaller_share(off / spring.stiffness / depth, off / force)
            };
            if spring.pushes_only {
                let foot = r / spring.stiffness - pressed;
                return [-foot / depth, -r / force, (foot / depth).min(r / force), misfit(pressed.max(0.0))];
            }
            [0.0, 0.0, 0.0, misfit(pressed)]
        };
        largest_each([0.0; 4], self.springs.iter().map(of))
    }

    /// The deviation of the slopes that supports hold, as a slope or as a couple, whichever share is smaller.
    pub(super) fn turned(&self, tangents: &[f64], [force, depth]: [f64; 2], length: f64) -> f64 {
        let of = |(slope, tangent): (&Slope, &f64)| {
            let off = tangent - slope.turned();
            let as_couple = if slope.stiffness.is_finite() { slope.stiffness * off } else { f64::INFINITY };
            smaller_share(off * length / depth, as_couple / (force * length))
        };
        largest(self.slopes.iter().zip(tangents).map(of))
    }
}

/// The slopes that supports hold, from left to right.
pub(super) fn slopes(supports: &[RecordedSupport], springs: &[(usize, Spring, SupportForce)]) -> Vec<Slope> {
    let slope = |node: usize, held: Option<f64>, turning: Option<[f64; 2]>, couple: f64| {
        let stiff = || held.map(|held| [f64::INFINITY, held]);
        turning.or_else(stiff).map(|[stiffness, held]| Slope { node, held, stiffness, couple })
    };
    let held = supports.iter().filter_map(|s| slope(s.node, s.held.slope, s.held.turning, s.recorded.couple));
    let sprung = springs.iter().filter_map(|(node, s, recorded)| slope(*node, None, s.turning, recorded.couple));
    let mut all: Vec<Slope> = held.chain(sprung).collect();
    all.sort_by_key(|slope| slope.node);
    all
}

/// The nodes where the beam changes or a support holds its slope, from left to right; [`None`] if such a position is between two nodes.
pub(super) fn changes(scene: &Scene, grid: &Grid, slopes: &[Slope]) -> Option<Vec<Change>> {
    let beam = scene.beam();
    let mut all: BTreeMap<usize, Change> = BTreeMap::new();
    for slope in slopes {
        all.entry(slope.node).or_default().couple = Some(slope.couple);
    }
    for [x, stiffness] in beam.steps().iter().filter(|_| beam.changes().next().is_some()) {
        all.entry(grid.node_at(*x)?).or_default().soft = Some(beam.bending_stiffness() / stiffness);
    }
    for joint in beam.joints() {
        all.entry(grid.node_at(joint.at)?).or_default().joint = joint.stiffness.map_or(f64::INFINITY, |k| 1.0 / k);
    }
    Some(all.into_iter().map(|(node, change)| Change { node, ..change }).collect())
}

/// The smaller of two shares that express the same misfit in different units; NaN is kept.
fn smaller_share(as_length: f64, as_force: f64) -> f64 {
    let [length, force] = [as_length, as_force].map(f64::abs);
    if length.is_nan() || length < force { length } else { force }
}

/// The deflections of a state at all nodes of its grid.
pub(super) fn deflections(nodes: &Nodes, grid: &Grid, supports: &[RecordedSupport]) -> Vec<f64> {
    let end = |node: usize| {
        let support = supports.iter().find(|support| support.node == node);
        support.map(|support| support.held.deflection)
    };
    let inner = nodes.deflection.iter().copied();
    end(0).into_iter().chain(inner).chain(end(grid.intervals())).collect()
}
