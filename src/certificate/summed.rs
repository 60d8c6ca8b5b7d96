//! What forces at the nodes of a grid do to a beam: moments are summed up from forces, and deflections from moments.
//!
//! ```text
//! M_i = M_{i−1} + V_{i−1} Δ,   V_i = V_{i−1} − t_i              M_0 = 0,  V_0 = −t_0
//! v_i = v_{i−1} + θ_{i−1} Δ,   θ_i = θ_{i−1} − (Δ/EI) c_i
//! ```
//!
//! with the forces `t` downwards, those of the supports among them, and the curvature share `c_i = M_i` of finite differences or
//! `(M_{i−1} + 4 M_i + M_{i+1})/6` of an exact beam. Both are the same [`DoubleSum`]. Where the beam is built in, `M` jumps by the
//! couple that the support exerts. Where its stiffness changes, each side of the node has a half of `c` with its own `EI`; in a joint `θ`
//! jumps by `−M/k`, and in a hinge by what is given. No system is solved: the force and the moment behind the right end are left over, and deflections
//! start at a given level and slope.
//!
//! Under an axial force `N` the sums of forces are `M + N v`, of which `N` times a deflection that is given is taken; an exact beam then has
//! `c_i = s₂ M_{i−1} + 2 s₁ M_i + s₂ M_{i+1}` with `z = N Δ²/EI` (`scene::axial`).

use super::double_sum::DoubleSum;
use crate::scene::Beam;
use crate::scene::axial::turns_of_any;
use crate::state::Discretisation;

/// Nodes of a step of a walk: few enough for the nearest cache.
pub(super) const BATCH: usize = 256;

/// A node at which the beam changes, or is held against turning.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Change {
    pub(super) node: usize,
    /// By how much the moment is larger behind it, where a support holds the slope \[force · length\].
    pub(super) couple: Option<f64>,
    /// The least bending stiffness over that of the beam behind it, where that changes.
    pub(super) soft: Option<f64>,
    /// How far a joint turns for each unit of its moment, [`f64::INFINITY`] of a hinge.
    pub(super) joint: f64,
}

impl Change {
    /// Whether it is a hinge.
    pub(super) fn is_hinge(&self) -> bool {
        self.joint.is_infinite()
    }
}

/// Neighbouring nodes of a walk.
#[derive(Debug, Clone, Copy)]
pub(super) struct Walked<'a> {
    /// The first of them.
    pub(super) first: usize,
    /// `M_i/Δ` to their left \[force\].
    pub(super) moments: &'a [f64],
    /// By how much that is larger to their right: not zero at a single node only.
    pub(super) jump: f64,
    /// `v_i`.
    pub(super) deflections: &'a [f64],
}

/// The moments of a beam with forces at the nodes of a grid.
#[derive(Debug, Clone)]
pub(super) struct Summed {
    step: f64,
    /// Shares of the moments `M/Δ` at a node and at one beside it in what the slope changes by on one side of the node.
    shares: [f64; 2],
    /// `N Δ²/EI` of a beam between the nodes of which that counts.
    pull: f64,
    /// `M_i/Δ` to the left of all nodes \[force\].
    moments: Vec<f64>,
    changes: Vec<Change>,
    /// The shear force and the moment behind the right end, which are zero in equilibrium.
    pub(super) left_over: [f64; 2],
}

impl Summed {
    /// From forces at all nodes, at a distance of `step`, and what changes, from left to right, of a beam of a least bending stiffness.
    pub(super) fn of(
        mut forces: Vec<f64>,
        changes: Vec<Change>,
        step: f64,
        stiffness: f64,
        discretisation: Discretisation,
    ) -> Self {
        let share = step * step / stiffness;
        let shares = match discretisation {
            Discretisation::FiniteDifferences => [share / 2.0, 0.0],
            Discretisation::BeamElements => [share / 3.0, share / 6.0],
        };
        let mut sums = DoubleSum::from(0.0, -forces[0]);
        forces[0] = 0.0;
        let mut next = 1;
        for (node, couple) in changes.iter().filter_map(|change| Some((change.node, change.couple?))) {
            sums.along(&mut forces[next..=node.max(next - 1)]);
            sums.raise(couple / step);
            next = next.max(node + 1);
        }
        sums.along(&mut forces[next..]);
        let left_over = [sums.slope(), sums.height() * step];
        Self { step, shares, pull: 0.0, moments: forces, changes, left_over }
    }

    /// The same under an axial force, with the deflections at all nodes.
    pub(super) fn pulled(self, beam: &Beam, deflections: &[f64], discretisation: Discretisation) -> Self {
        let (tension, stiffness) = (beam.tension(), beam.bending_stiffness());
        let Self { step, mut moments, left_over: [shear, remaining], .. } = self;
        let lowered = |v: f64| tension * (v - deflections[0]);
        moments.iter_mut().zip(deflections).for_each(|(moment, v)| *moment -= lowered(*v) / step);
        let left_over = [shear, remaining - deflections.last().map_or(0.0, |v| lowered(*v))];
        let pull = match discretisation {
            Discretisation::FiniteDifferences => 0.0,
            Discretisation::BeamElements => tension * step * step / stiffness,
        };
        Self { moments, left_over, pull, ..self }
    }

    /// The shares on a part of the beam that is so soft.
    fn shares_of(&self, soft: f64) -> [f64; 2] {
        if self.pull == 0.0 {
            return self.shares;
        }
        let [near, far, _] = turns_of_any(self.pull * soft);
        [3.0 * self.shares[0] * near, 6.0 * self.shares[1] * far]
    }

    /// By how much the slope changes between a node and the interval beside it.
    fn turn([near, far]: [f64; 2], own: f64, beside: f64) -> f64 {
        near * own + far * beside
    }

    /// Along the whole beam, some nodes at a time, with a given deflection at the left end, a slope in the first interval, and what the slope
    /// grows by in each hinge, nothing where none is given. Returns the slopes of the tangents where a support holds the slope.
    pub(super) fn walk(
        &self,
        deflection: f64,
        slope: f64,
        kinks: &[f64],
        mut visit: impl FnMut(Walked<'_>),
    ) -> Vec<f64> {
        let Self { step, moments, changes, .. } = self;
        let last = moments.len() - 1;
        let at = |node: usize| changes.iter().find(|change| change.node == node).copied().unwrap_or_default();
        let jump = |change: &Change| change.couple.map_or(0.0, |couple| couple / step);
        let mut sums = DoubleSum::from(deflection, slope * step);
        let (mut tangents, mut kinks) = (Vec::with_capacity(changes.len()), kinks.iter());
        let first = at(0);
        let (mut right, mut soft) = (moments[0] + jump(&first), first.soft.unwrap_or(1.0));
        let mut shares = self.shares_of(soft);
        if first.couple.is_some() {
            tangents.push(slope + soft * Self::turn(shares, right, moments[1]));
        }
        visit(Walked { first: 0, moments: &moments[..1], jump: jump(&first), deflections: &[deflection] });
        let (mut from, mut falls) = (0, [0.0; BATCH]);
        for to in changes.iter().map(|change| change.node).filter(|node| (1..last).contains(node)).chain([last]) {
            let mut before = right;
            let mut first = from + 1;
            let [own, beside] = [2.0 * shares[0] * step, shares[1] * step];
            for batch in moments[first..to].chunks(BATCH) {
                let after = moments[first + 1..].iter();
                let falls = &mut falls[..batch.len()];
                for ((fall, m), after) in falls.iter_mut().zip(batch).zip(after) {
                    *fall = soft * (own * m + beside * (before + after));
                    before = *m;
                }
                sums.along(falls);
                visit(Walked { first, moments: batch, jump: 0.0, deflections: falls });
                first += batch.len();
            }
            // A change or the end: one side at a time.
            let (left, change) = (moments[to], at(to));
            let before = soft * Self::turn(shares, left, before);
            soft = change.soft.unwrap_or(soft);
            shares = self.shares_of(soft);
            let behind = if to < last { soft * Self::turn(shares, left + jump(&change), moments[to + 1]) } else { 0.0 };
            if change.couple.is_some() {
                tangents.push(sums.slope() / step - before);
            }
            let turned = match change.is_hinge() {
                true => -kinks.next().copied().unwrap_or(0.0),
                false => change.joint * left * step,
            };
            let mut fall = [(before + behind + turned) * step];
            sums.along(&mut fall);
            visit(Walked { first: to, moments: &moments[to..=to], jump: jump(&change), deflections: &fall });
            (from, right) = (to, left + jump(&change));
        }
        tangents
    }
}

#[cfg(test)]
mod tests;
