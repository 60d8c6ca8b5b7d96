//! A scene on a grid: what the three methods have in common before they choose an unknown.

use super::statics;
use crate::problem::Sizes;
use crate::scene::{Grid, Scene, SceneError};
use crate::state::Bending;

/// Nodal data of a scene on a grid. The scene is dimensionless and has a foundation.
#[derive(Debug, Clone, PartialEq)]
pub struct Discrete {
    /// The grid.
    pub grid: Grid,
    /// Number `N` of intervals.
    pub intervals: usize,
    /// Spacing `Δ`.
    pub spacing: f64,
    /// Bending stiffness `EI`.
    pub stiffness: f64,
    /// Loads on all nodes, `q_0 … q_{n+1}`, supports included: forces, not densities.
    pub loads: Vec<f64>,
    /// Depths `u_1 … u_n` at the interior nodes.
    pub depths: Vec<f64>,
}

impl Discrete {
    /// The nodal data of `scene` on `intervals` equal intervals.
    ///
    /// # Errors
    ///
    /// [`SceneError::TooFewIntervals`].
    pub fn new(scene: &Scene, intervals: usize) -> Result<Self, SceneError> {
        let grid = Grid::uniform(scene, intervals)?;
        Ok(Self {
            grid,
            intervals,
            spacing: grid.spacing(),
            stiffness: scene.beam().bending_stiffness(),
            loads: grid.nodal_loads(scene.load()),
            depths: grid.depths(scene),
        })
    }

    /// `n`, the number of interior nodes.
    #[must_use]
    pub fn interior(&self) -> usize {
        self.intervals - 1
    }

    /// Loads `q_1 … q_n` on the interior nodes.
    #[must_use]
    pub fn interior_loads(&self) -> &[f64] {
        &self.loads[1..self.intervals]
    }

    /// Deflection at the interior nodes under nodal forces `t_1 … t_n`: `v = C t`, (25), by statics and without `C`.
    #[must_use]
    pub fn deflection(&self, forces: &[f64], bending: Bending) -> Vec<f64> {
        let moments = statics::moments(forces, self.spacing);
        let mut v = statics::deflections(&moments, self.spacing, self.stiffness, bending);
        v.pop();
        v.remove(0);
        v
    }

    /// Clearances `h = u − v` at the interior nodes.
    #[must_use]
    pub fn clearances(&self, deflection: &[f64]) -> Vec<f64> {
        self.depths.iter().zip(deflection).map(|(u, v)| u - v).collect()
    }

    /// Sizes of deflection (or clearance) and of nodal force in this scene, for dimensionless residuals.
    ///
    /// The deflection is limited by the free beam and by the foundation, whichever is nearer:
    /// `max_i min(|u_i|, |v_free,i|)`. Forces are measured by the sum of the nodal loads; without loads, by the force
    /// that deflects the beam by that much, `48 EI v / l³`.
    #[must_use]
    pub fn sizes(&self) -> Sizes {
        let free = self.deflection(self.interior_loads(), Bending::Between);
        let largest = |values: &mut dyn Iterator<Item = f64>| values.fold(0.0_f64, f64::max);
        let mut deflection = largest(&mut free.iter().zip(&self.depths).map(|(v, u)| v.abs().min(u.abs())));
        if deflection <= 0.0 {
            deflection = largest(&mut self.depths.iter().map(|u| u.abs()));
        }
        if !(0.0 < deflection && deflection < f64::INFINITY) {
            deflection = 1.0;
        }
        let mut force: f64 = self.interior_loads().iter().map(|q| q.abs()).sum();
        if force <= 0.0 {
            let length = self.spacing * (1 + self.interior()) as f64;
            force = 48.0 * self.stiffness * deflection / (length * length * length);
        }
        Sizes { x: deflection, gradient: force }
    }
}
