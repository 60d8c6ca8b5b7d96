//! What forces at the nodes of a grid do to a beam: moments are summed up from forces, and deflections from moments.
//!
//! ```text
//! M_i = M_{i−1} + V_{i−1} Δ,   V_i = V_{i−1} − t_i              M_0 = 0,  V_0 = −t_0
//! v_i = v_{i−1} + θ_{i−1} Δ,   θ_i = θ_{i−1} − (Δ/EI) c_i
//! ```
//!
//! with the forces `t` downwards, those of the supports among them, and the curvature share `c_i = M_i` of finite differences or
//! `(M_{i−1} + 4 M_i + M_{i+1})/6` of an exact beam. Both are the same [`DoubleSum`]. Where the beam is built in, `M` jumps by the
//! couple that the support exerts. No system is solved: the force and the moment behind the right end are left over, and deflections
//! start at a given level and slope.

use super::double_sum::DoubleSum;
use crate::state::Discretisation;

/// Nodes of a step of a walk: few enough for the nearest cache.
pub(super) const BATCH: usize = 256;

/// A place at which the beam is built in.
#[derive(Debug, Clone, Copy)]
pub(super) struct Couple {
    pub(super) node: usize,
    /// By how much the moment is larger behind it \[force · length\].
    pub(super) jump: f64,
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
    /// `M_i/Δ` to the left of all nodes \[force\].
    moments: Vec<f64>,
    couples: Vec<Couple>,
    /// The shear force and the moment behind the right end, which are zero in equilibrium.
    pub(super) left_over: [f64; 2],
}

impl Summed {
    /// From forces at all nodes, at a distance of `step`, and couples from left to right.
    pub(super) fn of(
        mut forces: Vec<f64>,
        couples: Vec<Couple>,
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
        for couple in &couples {
            sums.along(&mut forces[next..=couple.node.max(next - 1)]);
            sums.raise(couple.jump / step);
            next = next.max(couple.node + 1);
        }
        sums.along(&mut forces[next..]);
        let left_over = [sums.slope(), sums.height() * step];
        Self { step, shares, moments: forces, couples, left_over }
    }

    /// By how much the slope changes between a node and the interval beside it.
    fn turn(&self, own: f64, beside: f64) -> f64 {
        self.shares[0] * own + self.shares[1] * beside
    }

    /// Along the whole beam, some nodes at a time, with a given deflection at the left end and a slope in the first interval. Returns
    /// the slopes of the tangents where the beam is built in.
    pub(super) fn walk(&self, deflection: f64, slope: f64, mut visit: impl FnMut(Walked<'_>)) -> Vec<f64> {
        let Self { step, moments, couples, .. } = self;
        let last = moments.len() - 1;
        let [own, beside] = [2.0 * self.shares[0] * step, self.shares[1] * step];
        let jump_at =
            |node: usize| couples.iter().find(|couple| couple.node == node).map_or(0.0, |couple| couple.jump / step);
        let mut sums = DoubleSum::from(deflection, slope * step);
        let mut tangents = Vec::with_capacity(couples.len());
        let mut right = moments[0] + jump_at(0);
        if couples.first().is_some_and(|couple| couple.node == 0) {
            tangents.push(slope + self.turn(right, moments[1]));
        }
        visit(Walked { first: 0, moments: &moments[..1], jump: jump_at(0), deflections: &[deflection] });
        let (mut from, mut falls) = (0, [0.0; BATCH]);
        for to in couples.iter().map(|couple| couple.node).filter(|node| (1..last).contains(node)).chain([last]) {
            let mut before = right;
            let mut first = from + 1;
            for batch in moments[first..to].chunks(BATCH) {
                let after = moments[first + 1..].iter();
                let falls = &mut falls[..batch.len()];
                for ((fall, m), after) in falls.iter_mut().zip(batch).zip(after) {
                    *fall = own * m + beside * (before + after);
                    before = *m;
                }
                sums.along(falls);
                visit(Walked { first, moments: batch, jump: 0.0, deflections: falls });
                first += batch.len();
            }
            // A couple or the end: one side at a time.
            let [left, jump] = [moments[to], jump_at(to)];
            let before = self.turn(left, before);
            let behind = if to < last { self.turn(left + jump, moments[to + 1]) } else { 0.0 };
            if couples.iter().any(|couple| couple.node == to) {
                tangents.push(sums.slope() / step - before);
            }
            let mut fall = [(before + behind) * step];
            sums.along(&mut fall);
            visit(Walked { first: to, moments: &moments[to..=to], jump, deflections: &fall });
            (from, right) = (to, left + jump);
        }
        tangents
    }
}

#[cfg(test)]
mod tests;
