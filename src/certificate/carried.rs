//! What loads and contact forces on the nodes of a grid do to the beam: the judge's own statics and elasticity.
//!
//! Moments by statics, deflections by integration of `v'' = −M/EI`, both from left to right:
//!
//! ```text
//! M_i = M_{i−1} + V_{i−1} Δ,   V_i = V_{i−1} − t_i,   t = q − p          V_0 from M_N = 0
//! v_i = v_{i−1} + θ_{i−1} Δ,   θ_i = θ_{i−1} − (Δ/EI) c_i                θ_0 from v_N = 0
//! ```
//!
//! both over `Δ` as they are summed, with the curvature share `c_i = M_i` of finite differences or `(M_{i−1} + 4 M_i + M_{i+1})/6` of an exact beam. `V_0` and
//! `θ_0` are found by a shot from a horizontal start, which misses the right end by `N` times what is looked for. Nothing is
//! stored: to go along the beam once more costs less than to keep a million numbers.

use super::twice::Twice;
use super::worst::Worst;
use crate::scene::{Grid, Scene};
use crate::state::{Bending, Nodes};

/// Nodes that are taken from the scene together.
pub(super) const BATCH: usize = 256;

/// The beam under the loads of a scene and the contact forces of a state.
pub(super) struct Carried<'a> {
    scene: &'a Scene,
    grid: Grid,
    nodes: &'a Nodes,
    /// Sum of all forces, those on the supports included, and what of it the right support carries \[force\].
    pub(super) total: f64,
    pub(super) right: f64,
    /// `V_0`, the left reaction without the load that acts on the support itself.
    shear: f64,
    /// Sums of magnitudes of loads and of contact forces, which are sizes only \[force\].
    pub(super) load: f64,
    pub(super) contact: f64,
    /// The largest deflection of the state.
    pub(super) moved: Worst,
}

impl<'a> Carried<'a> {
    /// The first shot. Contact forces and deflections are as many as the grid has inner nodes.
    pub(super) fn new(scene: &'a Scene, grid: Grid, nodes: &'a Nodes) -> Self {
        let ends = [0, grid.intervals()].map(|node| {
            let mut load = [0.0];
            grid.loads(scene.load(), node, &mut load);
            load[0]
        });
        let (mut load, mut contact) = (ends[0].abs() + ends[1].abs(), 0.0);
        let (mut sums, mut moved) = (Twice::rising(0.0), Worst::default());
        let mut room = [0.0; BATCH];
        let forces = nodes.contact_force.chunks(BATCH).zip(nodes.deflection.chunks(BATCH)).enumerate();
        for (batch, (forces, deflection)) in forces {
            let falls = &mut room[..forces.len()];
            grid.loads(scene.load(), batch * BATCH + 1, falls);
            for ((q, p), v) in falls.iter_mut().zip(forces).zip(deflection) {
                load += q.abs();
                contact += p.abs();
                moved.see(v.abs());
                *q -= p;
            }
            sums.along(falls);
        }
        let inner = -sums.slope();
        let shear = -sums.next() / count(&grid);
        let right = (inner - shear) + ends[1];
        Self { scene, grid, nodes, total: inner + ends[0] + ends[1], right, shear, load, contact, moved }
    }

    /// The second shot, and the beam as it bends.
    pub(super) fn bent(&self, stiffness: f64) -> Bent<'_> {
        let mut shot = Bent::new(self, stiffness, 0.0);
        let intervals = self.grid.intervals();
        for first in (1..intervals).step_by(BATCH) {
            shot.along(first, BATCH.min(intervals - first));
        }
        Bent::new(self, stiffness, -shot.sums[1].next() / count(&self.grid))
    }

    /// `t_i` for `i = first, …`; nothing at the right support.
    fn falls(&self, first: usize, falls: &mut [f64]) {
        self.grid.loads(self.scene.load(), first, falls);
        let forces = &self.nodes.contact_force[first - 1..];
        falls.iter_mut().zip(forces).for_each(|(q, p)| *q -= p);
        falls.iter_mut().skip(forces.len()).for_each(|q| *q = 0.0);
    }
}

/// The beam from left to right: some nodes, and both sums behind them.
pub(super) struct Bent<'a> {
    carried: &'a Carried<'a>,
    /// Of forces and of curvatures.
    sums: [Twice; 2],
    /// Moments over `Δ` at the node before, at those of the last call, and at the next one.
    moments: [f64; BATCH + 2],
    deflections: [f64; BATCH],
    /// How many of them there are.
    count: usize,
    /// What a moment, at the node itself and at both its neighbours, makes of the slope.
    shares: [f64; 2],
}

impl<'a> Bent<'a> {
    /// At the left support, with the slope `θ_0`.
    fn new(carried: &'a Carried<'a>, stiffness: f64, slope: f64) -> Self {
        let unit = carried.grid.spacing() * carried.grid.spacing() / stiffness;
        let shares = match carried.nodes.bending {
            Bending::AtNodes => [unit, 0.0],
            Bending::Between => [4.0 * (unit / 6.0), unit / 6.0],
        };
        let sums = [Twice::rising(carried.shear), Twice::rising(slope)];
        let mut bent = Self { carried, sums, moments: [0.0; BATCH + 2], deflections: [0.0; BATCH], count: 0, shares };
        carried.falls(1, &mut bent.moments[1..2]);
        bent.sums[0].along(&mut bent.moments[1..2]);
        bent
    }

    /// Moments over `Δ`, and deflections over `Δ`, at `count` inner nodes from `first` on: those behind the ones of the call
    /// before.
    pub(super) fn along(&mut self, first: usize, count: usize) -> (&[f64], &[f64]) {
        self.moments.copy_within(self.count..self.count + 2, 0);
        self.count = count;
        let next = &mut self.moments[2..count + 2];
        self.carried.falls(first + 1, next);
        self.sums[0].along(next);
        let deflections = &mut self.deflections[..count];
        for (v, m) in deflections.iter_mut().zip(self.moments.windows(3)) {
            *v = self.shares[0] * m[1] + self.shares[1] * (m[0] + m[2]);
        }
        self.sums[1].along(deflections);
        (&self.moments[1..=count], deflections)
    }
}

/// The number of intervals.
#[expect(clippy::cast_precision_loss, reason = "grids stay far below 2⁵³ nodes")]
fn count(grid: &Grid) -> f64 {
    grid.intervals() as f64
}
