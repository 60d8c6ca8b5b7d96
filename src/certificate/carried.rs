//! What loads and contact forces on the nodes of a grid do to the beam: the judge's own statics and elasticity.
//!
//! Moments by statics, then integration of `v'' = −M/EI` from the left with the right end brought back to zero:
//!
//! ```text
//! M_{i+1} = M_i + V_i Δ,   V_i = V_{i−1} − t_i,                  V_0 from M_N = 0
//! θ_i     = θ_{i−1} − (Δ/EI) c_i,   v_{i+1} = v_i + θ_i Δ        θ_0 from v_N = 0
//! ```
//!
//! with the curvature share `c_i = M_i` of finite differences or `(M_{i−1} + 4 M_i + M_{i+1})/6` of an exact beam. Both start
//! horizontally, and are turned about the left end afterwards.

use super::twice::Twice;
use super::worst::Worst;
use crate::scene::{Grid, Scene};
use crate::state::{Bending, Nodes};

/// The beam under `t = q − p` before it is bent.
pub(super) struct Carried {
    grid: Grid,
    /// Moments `M_0 … M_N` from a horizontal start, in `force · Δ`.
    raw: Vec<f64>,
    /// Sum of all forces, those on the supports included, and what of it the right support carries \[force\].
    pub(super) total: f64,
    pub(super) right: f64,
    /// Sums of magnitudes of loads and of contact forces, which are sizes only \[force\].
    pub(super) load: f64,
    pub(super) contact: f64,
    /// The largest deflection of the state.
    pub(super) moved: Worst,
}

impl Carried {
    /// One pass over loads, contact forces and deflections; the first two are as many as the grid has inner nodes.
    pub(super) fn new(grid: Grid, scene: &Scene, nodes: &Nodes) -> Self {
        // Moments take the place of the loads.
        let mut raw = grid.nodal_loads(scene.load());
        let ends = [raw[0], raw[grid.intervals()]];
        let (mut load, mut contact) = (ends[0].abs() + ends[1].abs(), 0.0);
        let (mut sums, mut moved) = (Twice::default(), Worst::default());
        raw[0] = sums.step(0.0);
        for ((y, p), v) in raw[1..].iter_mut().zip(&nodes.contact_force).zip(&nodes.deflection) {
            let q = *y;
            load += q.abs();
            contact += p.abs();
            moved.see(v.abs());
            *y = sums.step(q - p);
        }
        let inner = -sums.slope();
        let last = sums.step(0.0);
        raw[grid.intervals()] = last;
        // The last moment is that of all forces about the right end: what of it the left support has to balance.
        let left = -last / count(&grid);
        Self { grid, raw, total: inner + ends[0] + ends[1], right: (inner - left) + ends[1], load, contact, moved }
    }

    /// Deflections at the inner nodes. The differences of `M_i` from the moments of the state are seen by `moments` on the
    /// way.
    pub(super) fn deflection(self, stiffness: f64, nodes: &Nodes, moments: &mut Worst) -> Deflection {
        let Self { grid, raw: mut y, .. } = self;
        let spacing = grid.spacing();
        let turned = Turned::new(&grid, y[grid.intervals()]);
        let (at_nodes, between) = (spacing / stiffness, spacing / (6.0 * stiffness));
        let (mut before, mut here) = (0.0, turned.at(1.0, y[1]));
        let (mut sums, mut number) = (Twice::default(), 2.0);
        sums.step(0.0);
        for (i, moment) in nodes.moment.iter().enumerate() {
            let next = turned.at(number, y[i + 2]);
            moments.see((here - moment).abs());
            y[i + 1] = sums.step(match nodes.bending {
                Bending::AtNodes => at_nodes * here,
                Bending::Between => between * ((before + next) + 4.0 * here),
            });
            (before, here) = (here, next);
            number += 1.0;
        }
        let last = sums.step(0.0);
        Deflection { turned: Turned::new(&grid, last), raw: y }
    }
}

/// Deflections that the forces of a state cause.
pub(super) struct Deflection {
    turned: Turned,
    raw: Vec<f64>,
}

impl Deflection {
    /// At the nodes from `first` on, with their numbers.
    #[expect(clippy::cast_precision_loss, reason = "grids stay far below 2⁵³ nodes")]
    pub(super) fn from(&self, first: usize) -> impl Iterator<Item = f64> + '_ {
        let mut number = first as f64;
        self.raw[first..].iter().map(move |y| {
            let v = self.turned.at(number, *y);
            number += 1.0;
            v
        })
    }
}

/// The turn that brings the right end back to zero, and the unit of heights.
struct Turned {
    turn: f64,
    spacing: f64,
}

impl Turned {
    fn new(grid: &Grid, last: f64) -> Self {
        Self { turn: last / count(grid), spacing: grid.spacing() }
    }

    #[inline]
    fn at(&self, number: f64, height: f64) -> f64 {
        (height - self.turn * number) * self.spacing
    }
}

/// The number of intervals.
#[expect(clippy::cast_precision_loss, reason = "grids stay far below 2⁵³ nodes")]
fn count(grid: &Grid) -> f64 {
    grid.intervals() as f64
}
