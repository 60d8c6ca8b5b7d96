//! A grid of equal intervals from end to end of the beam, with the gaps and loads at its nodes.

use std::ops::Range;

use super::{Concentrated, Foundation, Scene, SceneError};
use crate::memory::can_be_had;

/// `N = n + 1` equal intervals with `n` interior nodes. Node `i` is at `x_i = l i / N`, `i = 0 … N`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Grid {
    length: f64,
    intervals: usize,
}

/// Whether two positions on a beam are equal within rounding: nearer than some units in the last place of its length.
pub(crate) fn is_same_place(x: f64, other: f64, length: f64) -> bool {
    /// 45 units in the last place: enough for a position that was divided, multiplied back and converted to another unit of
    /// length.
    const ROUNDING: f64 = 1e-14;
    (x - other).abs() <= ROUNDING * length
}

/// The greatest number of intervals that is tried to find a grid with nodes at given positions.
pub(super) const MOST_FITTING: usize = 10_000;

/// Number of nodes whose positions and depths are computed together: few enough for the fastest cache.
const BATCH: usize = 256;

/// Memory per interval while our own solvers run. About 64 bytes were measured on 10⁷ intervals with every method.
const BYTES_PER_INTERVAL: usize = 100;

/// Memory per interval on an elastic foundation. About 130 bytes were measured on 10⁶ intervals.
const BYTES_ON_SPRINGS: usize = 200;

impl Grid {
    /// A grid with this number of intervals on the beam of `scene`.
    ///
    /// # Errors
    ///
    /// [`SceneError::TooFewIntervals`] for fewer than 2, which would leave no interior node. [`SceneError::NoMemory`] if a solve
    /// on the grid would exceed the available memory.
    pub fn uniform(scene: &Scene, intervals: usize) -> Result<Self, SceneError> {
        if intervals < 2 {
            return Err(SceneError::TooFewIntervals { intervals });
        }
        let bytes = if scene.ground_stiffness().is_some() { BYTES_ON_SPRINGS } else { BYTES_PER_INTERVAL };
        if !can_be_had(intervals, bytes) {
            return Err(SceneError::NoMemory { intervals, bytes: intervals.saturating_mul(bytes) });
        }
        Ok(Self { length: scene.beam().length(), intervals })
    }

    /// `N`, the number of intervals.
    #[must_use]
    pub(crate) fn intervals(&self) -> usize {
        self.intervals
    }

    /// `Δ = l / N`.
    #[must_use]
    #[expect(clippy::cast_precision_loss, reason = "grids stay far below 2⁵³ intervals")]
    pub fn spacing(&self) -> f64 {
        self.length / self.intervals as f64
    }

    /// `1/∫k`, the flexibility of the foundation at a node: its settlement under a unit force. The integral covers half an
    /// interval on each side of the node, so that an end of the beam has half a spring. `ground` lists the
    /// [parts](Scene::ground_parts) of uniform stiffness; it is empty for a rigid foundation, which has no flexibility.
    ///
    /// A node with a compression-only support below the surface of the foundation (`is_sunk`) has no spring of its own. Each of
    /// its neighbours receives half of that spring.
    pub(crate) fn give(&self, ground: &[([f64; 2], f64)], node: usize, is_sunk: impl Fn(usize) -> bool) -> f64 {
        let side = |inside: bool, beside: usize| match inside {
            true if is_sunk(beside) => 1.0,
            true => 0.5,
            false => 0.0,
        };
        let [left, right] = [side(0 < node, node.wrapping_sub(1)), side(node < self.intervals, node + 1)];
        let spring = match *ground {
            [] => return 0.0,
            [(_, k)] => k * ((left + right) * self.spacing()),
            _ => {
                let [from, to] = [-left, right].map(|way| self.place(node) + way * self.spacing());
                let over = |(part, k): &([f64; 2], f64)| k * (part[1].min(to) - part[0].max(from)).max(0.0);
                ground.iter().map(over).sum()
            }
        };
        1.0 / spring
    }

    /// The flexibility of the foundation or support below a node of a scene. A rigid compression-only support has none.
    pub(crate) fn give_of(&self, scene: &Scene, node: usize) -> f64 {
        let bearings = scene.beam().bearings();
        let at = |node: usize| bearings.iter().find(|bearing| self.nearest(bearing.at / self.length) == node);
        if at(node).is_some() {
            return 0.0;
        }
        let is_sunk = |node: usize| at(node).is_some_and(|bearing| scene.stands_in_ground(bearing));
        match scene.ground_stiffness() {
            None => 0.0,
            Some(k) if scene.ground_steps().is_empty() => self.give(&[([0.0, self.length], k)], node, is_sunk),
            Some(_) => self.give(&scene.ground_parts().collect::<Vec<_>>(), node, is_sunk),
        }
    }

    /// `x_i`, rounded once after the product `l i`, so that a node at a round position is exact. The last node is the end of the
    /// beam.
    #[must_use]
    #[expect(clippy::cast_precision_loss, reason = "grids stay far below 2⁵³ intervals")]
    pub fn place(&self, i: usize) -> f64 {
        if i == self.intervals { self.length } else { self.length * i as f64 / self.intervals as f64 }
    }

    /// The node at a position, within rounding; [`None`] if there is none.
    #[must_use]
    pub fn node_at(&self, x: f64) -> Option<usize> {
        let node = self.nearest(x / self.length);
        is_same_place(x, self.place(node), self.length).then_some(node)
    }

    /// The node nearest to a position given as a fraction of the length.
    #[must_use]
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        clippy::cast_precision_loss,
        reason = "a share of the beam lies between 0 and 1, so that this is between 0 and the number of intervals"
    )]
    pub(crate) fn nearest(&self, share: f64) -> usize {
        ((share * self.intervals as f64).round() as usize).min(self.intervals)
    }

    /// The smallest number of equal intervals, at most 10 000, with a node at every support, joint and change of the bending
    /// stiffness of `scene`.
    #[must_use]
    pub fn least_fitting(scene: &Scene) -> Option<usize> {
        let beam = scene.beam();
        let mut places: Vec<f64> = beam.all_supports().iter().map(|support| support.at).collect();
        places.extend(beam.joints().iter().map(|joint| joint.at).chain(beam.changes()));
        places.sort_by(f64::total_cmp);
        places.dedup_by(|next, kept| is_same_place(*next, *kept, beam.length()));
        Self::least_with(beam.length(), &places)
    }

    /// The smallest number of equal intervals with a separate node at each of the given positions, which are in ascending order.
    fn least_with(length: f64, places: &[f64]) -> Option<usize> {
        let fits = |intervals: usize| {
            let grid = Self { length, intervals };
            let nodes: Vec<_> = places.iter().map(|at| grid.node_at(*at)).collect();
            !nodes.contains(&None) && nodes.windows(2).all(|pair| pair[0] < pair[1])
        };
        (2..=MOST_FITTING).find(|&intervals| fits(intervals))
    }

    /// Every grid with a node at each support of `scene` has a multiple of this number of intervals; 1 if there are supports only
    /// at the ends. Joints and changes of the bending stiffness are not considered, because grids coarser than the requested one
    /// have no node there.
    pub(crate) fn step(scene: &Scene) -> Option<usize> {
        let beam = scene.beam();
        let supports: Vec<f64> = beam.all_supports().iter().map(|support| support.at).collect();
        let inside = supports.iter().any(|at| 0.0 < *at && *at < beam.length());
        if inside { Self::least_with(beam.length(), &supports) } else { Some(1) }
    }

    /// Writes `x_i` for `i = first, first + 1, …` until `places` is full.
    #[expect(clippy::cast_precision_loss, reason = "grids stay far below 2⁵³ intervals")]
    pub(crate) fn places(&self, first: usize, places: &mut [f64]) {
        for (k, batch) in places.chunks_mut(BATCH).enumerate() {
            let begin = (first + k * BATCH) as f64;
            // Within a batch the index is a small integer, which converts to a floating-point number at no cost.
            for (x, i) in batch.iter_mut().zip(0_i32..) {
                *x = self.length * (begin + f64::from(i)) / self.intervals as f64;
            }
        }
        if let Some(last) = self.intervals.checked_sub(first).and_then(|last| places.get_mut(last)) {
            *last = self.length;
        }
    }

    /// The gaps `g_i` below the undeflected beam at consecutive nodes, infinite without a foundation. For a straight beam they
    /// are the depths `u_i`.
    #[must_use]
    pub(crate) fn gaps_at(&self, scene: &Scene, nodes: Range<usize>) -> Vec<f64> {
        if let (Some(Foundation::Flat { depth }), None, []) =
            (scene.foundation(), scene.beam().shape(), scene.beam().bearings())
        {
            return vec![*depth; nodes.len()];
        }
        let mut gaps = vec![0.0; nodes.len()];
        self.places(nodes.start, &mut gaps);
        let mut places = [0.0; BATCH];
        for batch in gaps.chunks_mut(BATCH) {
            let places = &mut places[..batch.len()];
            places.copy_from_slice(batch);
            scene.gaps(places, batch);
        }
        gaps
    }

    /// The loads as forces at all `N + 1` nodes, both ends included \[force\].
    ///
    /// The load between two nodes is distributed to them by the lever rule, `∫ q φ_i dx` with the hat function `φ_i`, so that its
    /// resultant and moment are preserved. For a uniform load the forces are `q_i = q₀Δ`, as in (27), and `q₀Δ/2` at each end.
    #[must_use]
    pub fn nodal_loads(&self, scene: &Scene) -> Vec<f64> {
        let load = scene.load();
        let half = 0.5 * load.uniform() * self.spacing();
        let mut forces = vec![2.0 * half; self.intervals + 1];
        forces[0] -= half;
        forces[self.intervals] -= half;
        for part in load.linear() {
            for i in self.interval_of(part.from)..=self.interval_of(part.to) {
                let (left, right) = (self.place(i), self.place(i + 1));
                let (a, b) = (part.from.max(left), part.to.min(right));
                if a < b {
                    let (start, end) = (part.intensity(a), part.intensity(b));
                    let force = 0.5 * (start + end) * (b - a);
                    // First moment of a trapezoid about `a`.
                    let moment = (start + 2.0 * end) * (b - a) * (b - a) / 6.0;
                    let to_right = (force * (a - left) + moment) / (right - left);
                    forces[i] += force - to_right;
                    forces[i + 1] += to_right;
                }
            }
        }
        for Concentrated { at, force, couple } in load.concentrated() {
            let i = self.interval_of(at);
            let (left, right) = (self.place(i), self.place(i + 1));
            let share = (at - left) / (right - left);
            let to_right = force * share;
            forces[i] += force - to_right;
            forces[i + 1] += to_right;
            if couple != 0.0 {
                self.add_couple(scene, i, couple * (1.0 - share), &mut forces);
                self.add_couple(scene, i + 1, couple * share, &mut forces);
            }
        }
        forces
    }

    /// Adds a couple at a node as forces that do the same work. The slope is `(−3 v₀ + 4 v₁ − v₂)/2Δ` at an end of the beam, and
    /// inside
    ///
    /// ```text
    /// (2 e₋ (v_{i+1} − v_i) + 2 e₊ (v_i − v_{i−1})) / (e₋ + e₊) / 2Δ        e = 1/EI on both sides
    /// ```
    ///
    /// which is `(v_{i+1} − v_{i−1})/2Δ` where the stiffness does not change. Both formulas are exact except for terms of the
    /// order `Δ²`: the same bending moment acts on both sides, so that the errors of the two chords cancel.
    fn add_couple(&self, scene: &Scene, node: usize, couple: f64, forces: &mut [f64]) {
        let unit = couple / (2.0 * self.spacing());
        if node == 0 || node == self.intervals {
            let [one, two] = if node == 0 { [1, 2] } else { [node - 1, node - 2] };
            let unit = if node == 0 { unit } else { -unit };
            [(node, -3.0), (one, 4.0), (two, -1.0)].iter().for_each(|&(i, share)| forces[i] += share * unit);
            return;
        }
        let stiffness = |i: usize| scene.beam().stiffness_between(self.place(i), self.place(i + 1));
        let [left, right] = [node - 1, node].map(stiffness);
        let before = 2.0 * left / (left + right);
        let behind = 2.0 - before;
        forces[node - 1] -= before * unit;
        forces[node] += (before - behind) * unit;
        forces[node + 1] += behind * unit;
    }

    /// Writes the loads at the nodes `first, first + 1, …` until `forces` is full; zero beyond the last node.
    pub fn loads(&self, scene: &Scene, first: usize, forces: &mut [f64]) {
        let all = self.nodal_loads(scene);
        forces.iter_mut().enumerate().for_each(|(k, force)| *force = all.get(first + k).copied().unwrap_or(0.0));
    }

    /// The interval `i`, from node `i` to node `i + 1`, that contains `x`.
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        clippy::cast_precision_loss,
        reason = "x lies on the beam, so the quotient lies between 0 and the number of intervals"
    )]
    fn interval_of(&self, x: f64) -> usize {
        let guess = ((x / self.length * self.intervals as f64) as usize).min(self.intervals - 1);
        // The quotient may be rounded beyond a node.
        if x < self.place(guess) {
            guess - 1
        } else if self.place(guess + 1) < x && guess + 1 < self.intervals {
            guess + 1
        } else {
            guess
        }
    }
}
