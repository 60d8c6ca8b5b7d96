//! A scene on a grid: what the three methods have in common before they choose an unknown.

use super::statics;
use crate::qp::Sizes;
use crate::scene::{Foundation, Grid, Scene, SceneError};
use crate::state::Discretisation;

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
    /// The profile that they are taken from, and its depths below the two supports of the beam.
    profile: Option<Foundation>,
    below_supports: [f64; 2],
    sizes: Sizes,
}

/// Intervals of the grid on which sizes are measured, if it is not coarser anyway: a size needs two digits.
const SIZING: usize = 4096;

/// Size of a clearance over ground that leaves no room to deflect, as a share of the free deflection.
const ON_THE_GROUND: f64 = 1e-6;

impl Discrete {
    /// The nodal data of `scene` on `intervals` equal intervals.
    ///
    /// # Errors
    ///
    /// [`SceneError::TooFewIntervals`].
    pub fn new(scene: &Scene, intervals: usize) -> Result<Self, SceneError> {
        let grid = Grid::uniform(scene, intervals)?;
        let loads = grid.nodal_loads(scene.load());
        Ok(Self {
            grid,
            intervals,
            spacing: grid.spacing(),
            stiffness: scene.beam().bending_stiffness(),
            depths: grid.gaps(scene),
            profile: scene.foundation().cloned(),
            below_supports: [0, intervals].map(|node| scene.gap(grid.place(node))),
            sizes: sizes(scene, intervals.min(SIZING))?,
            loads,
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

    /// The loads on all nodes; the memory of everything else is given back.
    pub(super) fn into_loads(self) -> Vec<f64> {
        self.loads
    }

    /// Deflection at the interior nodes under nodal forces `t_1 … t_n`: `v = C t`, (25), by statics and without `C`.
    #[must_use]
    pub fn deflection(&self, forces: &[f64], discretisation: Discretisation) -> Vec<f64> {
        deflection(forces, self.spacing, self.stiffness, discretisation)
    }

    /// Clearances `h = u − v` at the interior nodes.
    #[must_use]
    pub fn clearances(&self, deflection: &[f64]) -> Vec<f64> {
        self.depths.iter().zip(deflection).map(|(u, v)| u - v).collect()
    }

    /// Sizes of deflection (or clearance) and of nodal force in this scene, for dimensionless residuals.
    ///
    /// The deflection is limited by the free beam and by the foundation, whichever is nearer:
    /// `max_i min(|u_i|, |v_free,i|)`. Over ground at the line of the supports it cannot move at all, and a small part of the
    /// free deflection has to do. Forces are measured by the sum of the nodal loads; without loads, by the force
    /// that deflects the beam by that much, `48 EI v / l³`.
    #[must_use]
    pub fn sizes(&self) -> Sizes {
        self.sizes
    }

    /// Depth at which a node is held: zero at the supports of the beam.
    pub(super) fn support_depth(&self, node: usize) -> f64 {
        if node == 0 || node == self.intervals { 0.0 } else { self.depths[node - 1] }
    }

    /// Size of the numbers from which the depth of an interior node, or of a chord beside it, is computed.
    pub(super) fn depth_rounding(&self, node: usize) -> f64 {
        self.profile.as_ref().map_or(0.0, |profile| profile.magnitude_at(self.grid.place(node)))
    }

    /// Whether the ground falls off so far beside a support of the beam that slopes to its depth there, which the beam does not
    /// feel, would cost more digits than the plain differences of the depths at which three nodes are held.
    fn drops_off(&self, nodes: [usize; 3], [before, behind]: [f64; 2]) -> bool {
        let [u0, u1, u2] = nodes.map(|i| self.support_depth(i).abs());
        let plain = (u0 + u1) / before + (u1 + u2) / behind;
        let below = |at_support: bool, depth: f64, length: f64| if at_support { depth.abs() / length } else { 0.0 };
        let left = below(nodes[0] == 0, self.below_supports[0], before);
        let right = below(nodes[2] == self.intervals, self.below_supports[1], behind);
        plain < left.max(right)
    }

    /// By how much the slope of the polyline through three nodes, held on the foundation or by the supports of the beam,
    /// grows at the middle one.
    #[inline]
    pub(super) fn bend(&self, left: usize, node: usize, right: usize) -> f64 {
        let Some(profile) = &self.profile else { return 0.0 };
        #[expect(clippy::cast_precision_loss, reason = "grids stay far below 2⁵³ nodes")]
        let [before, behind] = [node - left, right - node].map(|steps| self.spacing * steps as f64);
        let place = |i: usize| self.grid.place(i);
        if (left == 0 || right == self.intervals) && self.drops_off([left, node, right], [before, behind]) {
            let depth = |i: usize| self.support_depth(i);
            return (depth(right) - depth(node)) / behind - (depth(node) - depth(left)) / before;
        }
        let mut bend = match profile {
            Foundation::Flat { .. } => 0.0,
            profile => profile.bend(place(node), before, behind, [place(left), place(right)]),
        };
        // The supports of the beam are not on the foundation.
        if left == 0 {
            bend -= self.below_supports[0] / before;
        }
        if right == self.intervals {
            bend -= self.below_supports[1] / behind;
        }
        bend
    }
}

/// See [`Discrete::sizes`].
fn sizes(scene: &Scene, intervals: usize) -> Result<Sizes, SceneError> {
    let grid = Grid::uniform(scene, intervals)?;
    let (loads, depths) = (grid.nodal_loads(scene.load()), grid.gaps(scene));
    let stiffness = scene.beam().bending_stiffness();
    let free = deflection(&loads[1..intervals], grid.spacing(), stiffness, Discretisation::BeamElements);
    let largest = |values: &mut dyn Iterator<Item = f64>| values.fold(0.0_f64, f64::max);
    let mut deflection = largest(&mut free.iter().zip(&depths).map(|(v, u)| v.abs().min(u.abs())));
    if deflection <= 0.0 {
        deflection = largest(&mut depths.iter().map(|u| u.abs()));
    }
    if deflection <= 0.0 {
        deflection = ON_THE_GROUND * largest(&mut free.iter().map(|v| v.abs()));
    }
    if !(0.0 < deflection && deflection < f64::INFINITY) {
        deflection = 1.0;
    }
    let mut force: f64 = loads[1..intervals].iter().map(|q| q.abs()).sum();
    if force <= 0.0 {
        let length = scene.beam().length();
        force = 48.0 * stiffness * deflection / (length * length * length);
    }
    Ok(Sizes { x: deflection, gradient: force })
}

/// Deflection at the interior nodes under nodal forces.
fn deflection(forces: &[f64], spacing: f64, stiffness: f64, discretisation: Discretisation) -> Vec<f64> {
    statics::deflections(statics::moments(forces, spacing), spacing, stiffness, discretisation)
}
