//! The beam under forces at the nodes of a grid: moments are summed from forces, and deflections from moments.
//!
//! ```text
//! M_i = M_{i−1} + V_{i−1} Δ,   V_i = V_{i−1} − t_i              M_0 = 0,  V_0 = −t_0
//! v_i = v_{i−1} + θ_{i−1} Δ,   θ_i = θ_{i−1} − (Δ/EI) c_i
//! ```
//!
//! with the downward forces `t`, including reactions, and the curvature share `c_i = M_i` for finite differences or
//! `(M_{i−1} + 4 M_i + M_{i+1})/6` for an exact beam. Both use the same [`DoubleSum`]. Where the beam is built in, `M` jumps by the
//! couple of the support. Where its stiffness changes, each side of the node has a half of `c` with its own `EI`. In a joint `θ` jumps
//! by `−M/k`, and in a hinge by a given value. No system of equations is solved: the force and the moment beyond the right end remain as
//! residuals, and deflections start at a given level and slope.
//!
//! Under an axial force `N` the sums of forces are `M + N v`, from which `N` times a given deflection is subtracted. An exact beam then
//! has `c_i = s₂ M_{i−1} + 2 s₁ M_i + s₂ M_{i+1}` with `z = N Δ²/EI` (`scene::axial`).

use super::double_sum::DoubleSum;
use crate::scene::Beam;
use crate::scene::axial::end_rotations_of_any;
use crate::state::Discretisation;

/// Nodes per step of a walk: few enough for the fastest cache.
pub(super) const BATCH: usize = 256;

/// A node at which the beam changes, or at which a support restrains its rotation.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Change {
    pub(super) node: usize,
    /// The increase of the moment there, where a support holds the slope \[force · length\].
    pub(super) couple: Option<f64>,
    /// The least bending stiffness over the bending stiffness to the right, where it changes.
    pub(super) soft: Option<f64>,
    /// The rotation of a joint per unit of its moment, [`f64::INFINITY`] for a hinge.
    pub(super) joint: f64,
}

impl Change {
    /// Whether the node is a hinge.
    pub(super) fn is_hinge(&self) -> bool {
        self.joint.is_infinite()
    }
}

/// Neighbouring nodes of a walk.
#[derive(Debug, Clone, Copy)]
pub(super) struct Walked<'a> {
    /// The first of these nodes.
    pub(super) first: usize,
    /// `M_i/Δ` to their left \[force\].
    pub(super) moments: &'a [f64],
    /// The increase of `M_i/Δ` at the node; nonzero only if there is a single node.
    pub(super) jump: f64,
    /// `v_i`.
    pub(super) deflections: &'a [f64],
}

/// The moments of a beam with forces at the nodes of a grid.
#[derive(Debug, Clone)]
pub(super) struct Summed {
    step: f64,
    /// Factors of the moments `M/Δ` at a node and at its neighbour in the change of slope on one side of the node.
    shares: [f64; 2],
    /// `N Δ²/EI`, if the beam between the nodes takes the axial force into account; otherwise zero.
    pull: f64,
    /// `M_i/Δ` to the left of all nodes \[force\].
    moments: Vec<f64>,
    changes: Vec<Change>,
    /// The shear force and the moment beyond the right end, which are zero in equilibrium.
    pub(super) left_over: [f64; 2],
}

impl Summed {
    /// Sums forces at all nodes, with the spacing `step`. `changes` are sorted from left to right, and `stiffness` is the least bending
    /// stiffness.
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

    /// The factors on a part of the beam with this relative flexibility.
    fn shares_of(&self, soft: f64) -> [f64; 2] {
        if self.pull == 0.0 {
            return self.shares;
        }
        let [near, far, _] = end_rotations_of_any(self.pull * soft);
        [3.0 * self.shares[0] * near, 6.0 * self.shares[1] * far]
    }

    /// The change of slope between a node and the adjacent interval.
    fn turn([near, far]: [f64; 2], own: f64, beside: f64) -> f64 {
        near * own + far * beside
    }

    /// Walks along the whole beam, some nodes at a time, with a given deflection at the left end and a given slope in the first
    /// interval. `kinks` are the increases of the slope in the hinges, zero if none are given. Returns the slopes of the tangents where
    /// a support holds the slope.
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
