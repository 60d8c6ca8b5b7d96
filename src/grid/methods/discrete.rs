//! A scene on a grid: the nodal data that the three methods share.
//!
//! Unknowns belong to the nodes without a support. For the paper's beam these are the interior nodes. An end without a support is one
//! of them; a node inside the beam with a support is not. Without a foundation only the nodes with a compression-only support have an
//! unknown. The other nodes are *open*: their gap counts from zero, and their clearance has no effect.

use std::ops::Range;
use std::sync::Arc;

use super::divisions::Divisions;
use super::held_beam;
use super::supports::Supports;
use super::touching::Touching;
use crate::memory::zeros;
use crate::qp::Sizes;
use crate::qp::blocks::PENALTY;
use crate::scene::{Foundation, Grid, Scene, SceneError};
use crate::state::Discretisation;

/// Nodal data of a scene on a grid. The scene is dimensionless.
#[derive(Debug, Clone, PartialEq)]
pub struct Discrete {
    /// The grid.
    pub grid: Grid,
    /// Number `N` of intervals.
    pub intervals: usize,
    /// Spacing `Δ`.
    pub spacing: f64,
    /// Bending stiffness `EI`; the smallest one if the stiffness varies in steps.
    pub stiffness: f64,
    /// Axial force `N`, tension positive.
    pub tension: f64,
    /// Loads on all nodes, `q_0 … q_{n+1}`, supports included. These are forces, not densities.
    pub loads: Vec<f64>,
    /// Gaps `g` below the undeflected beam, equal to the depths `u` for a straight one, at all
    /// nodes except supported ends.
    pub depths: Vec<f64>,
    supports: Supports,
    /// Steps of the bending stiffness and joints.
    divisions: Divisions,
    /// The nodes at which the beam may be in contact.
    pub(super) touching: Touching,
    /// The foundation profile and the initial shape, from which the gaps are computed.
    pub(super) profile: Option<Arc<Foundation>>,
    pub(super) shape: Option<Arc<Foundation>>,
    /// Whether this is the paper's beam.
    simple: bool,
    /// The parts of constant stiffness of an elastic foundation; empty for a rigid one.
    ground: Arc<[([f64; 2], f64)]>,
    sizes: Sizes,
}

/// Intervals of the grid on which sizes are measured, unless the grid is coarser. A size needs two digits.
const SIZING: usize = 4096;

/// Size of a clearance over a foundation without any gap, as a fraction of the free deflection.
const ON_THE_GROUND: f64 = 1e-6;

impl Discrete {
    /// The nodal data of `scene` on `intervals` equal intervals.
    ///
    /// # Errors
    ///
    /// [`SceneError::TooFewIntervals`] and [`SceneError::BetweenNodes`].
    pub fn new(scene: &Scene, intervals: usize) -> Result<Self, SceneError> {
        let discrete = Self::unmeasured(scene, intervals, false)?;
        // A coarser grid with the supports among its nodes, if there is one.
        let coarse = Grid::step(scene).map_or(0, |step| SIZING / step * step);
        let sizes = match coarse {
            2.. if coarse < intervals => Self::unmeasured(scene, coarse, true)?.measured(),
            _ => discrete.measured(),
        };
        Ok(Self { sizes, ..discrete })
    }

    /// The same scene on a coarser grid, with the sizes of this one. Joints and steps of the bending stiffness move to the nearest nodes.
    ///
    /// # Errors
    ///
    /// The errors of [`new`](Self::new).
    pub(crate) fn coarser(&self, scene: &Scene, intervals: usize) -> Result<Self, SceneError> {
        Ok(Self { sizes: self.sizes, ..Self::unmeasured(scene, intervals, true)? })
    }

    fn unmeasured(scene: &Scene, intervals: usize, coarse: bool) -> Result<Self, SceneError> {
        let grid = Grid::uniform(scene, intervals)?;
        let supports = Supports::on(&grid, scene)?;
        let mut depths = grid.gaps_at(scene, supports.nodes());
        let ground: Arc<[_]> = scene.ground_parts().collect();
        let touching = Touching::of(scene, &grid, &supports, &ground, &mut depths);
        Ok(Self {
            grid,
            intervals,
            spacing: grid.spacing(),
            stiffness: scene.beam().bending_stiffness(),
            tension: scene.beam().tension(),
            depths,
            touching,
            supports,
            divisions: Divisions::on(&grid, scene, coarse)?,
            profile: scene.shared_foundation(),
            shape: scene.beam().shared_shape(),
            simple: scene.beam().is_simple() && scene.ground_stiffness().is_none(),
            ground,
            sizes: Sizes { x: 1.0, gradient: 1.0 },
            loads: grid.nodal_loads(scene),
        })
    }

    /// The settlement under a unit force of whatever is below a node; zero at a rigid compression-only support.
    #[must_use]
    pub(crate) fn give(&self, node: usize) -> f64 {
        match self.supports.bearings() {
            [] => self.grid.give(&self.ground, node, |_| false),
            _ if self.supports.pushing(node).is_some() => 0.0,
            _ => self.grid.give(&self.ground, node, |node| self.supports.is_sunk(node)),
        }
    }

    /// The smallest settlement of the foundation under a unit force at an interior node; zero if it is rigid.
    pub(super) fn give_inside(&self) -> f64 {
        self.ground.iter().map(|(_, k)| *k).reduce(f64::max).map_or(0.0, |k| self.whole_give(k))
    }

    /// The settlement of a foundation of this stiffness under a unit force at an interior node.
    pub(super) fn whole_give(&self, stiffness: f64) -> f64 {
        1.0 / (stiffness * self.spacing)
    }

    /// The foundation stiffness on the stiffer side of a node.
    pub(super) fn stiffest_beside(&self, node: usize) -> f64 {
        let x = self.grid.place(node);
        let beside = self.ground.iter().filter(|(part, _)| part[0] <= x && x <= part[1]);
        beside.fold(0.0, |most, (_, k)| k.max(most))
    }

    /// Whether the foundation is elastic.
    #[must_use]
    pub(crate) fn gives(&self) -> bool {
        !self.ground.is_empty()
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

    /// All nodes except the ends of the beam that have a support.
    #[must_use]
    pub(crate) fn nodes(&self) -> Range<usize> {
        self.supports.nodes()
    }

    /// Whether the left and the right end of the beam have a support.
    pub(crate) fn held_ends(&self) -> [bool; 2] {
        [0, self.intervals].map(|node| self.supports.at(node).is_some())
    }

    /// Whether the supports prevent all rigid motions of the beam and of each part between two hinges. If not, the stiffness is
    /// singular and there is no flexibility.
    #[must_use]
    pub fn is_held(&self) -> bool {
        self.supports.lacking() == 0 && self.missing(&self.supports.held_nodes()).is_empty()
    }

    /// Nodes that must hold the beam in addition to the given ones, so that no part between two hinges can move; see
    /// [`Divisions::unheld`].
    ///
    /// Under tension none are missing: tension holds these parts together with any node that holds the beam.
    pub(super) fn missing(&self, held: &[(usize, usize)]) -> Vec<usize> {
        let may_move = self.divisions.has_hinges() && self.tension <= 0.0;
        if may_move { self.divisions.unheld(held, self.intervals) } else { Vec::new() }
    }

    /// Steps of the bending stiffness and joints.
    pub(super) fn divisions(&self) -> &Divisions {
        &self.divisions
    }

    /// The supports.
    pub(crate) fn supports(&self) -> &Supports {
        &self.supports
    }

    /// Whether this is the paper's beam: straight, on two simple supports at its ends, at level 0.
    pub(super) fn is_simple(&self) -> bool {
        self.simple
    }

    /// Clearances `h = g − v` at [`nodes`](Self::nodes).
    #[must_use]
    pub(crate) fn clearances(&self, deflection: &[f64]) -> Vec<f64> {
        self.depths.iter().zip(deflection).map(|(u, v)| u - v).collect()
    }

    /// Sizes of deflection (or clearance) and of nodal force in this scene, for dimensionless residuals.
    ///
    /// The deflection is limited by the beam without a foundation and by the foundation, whichever is less:
    /// `max_i min(|g_i|, |v_free,i|)`. Over a foundation without any gap the beam cannot move, and a small part of the free
    /// deflection is used. If the supports do not hold the beam, gaps count from where it would rest if it were rigid, and the free
    /// deflection is that of a beam held at its ends. The size of forces is the sum of the nodal loads. Without loads it is the force
    /// that gives a simple beam this deflection, `48 EI v / l³`.
    #[must_use]
    pub fn sizes(&self) -> Sizes {
        self.sizes
    }

    /// See [`sizes`](Self::sizes).
    fn measured(&self) -> Sizes {
        let supports = self.supports.slack();
        let basic = Self { supports, ..self.clone() }.basic(self.loads.clone());
        // Above a foundation at level zero, a clearance is an upward deflection.
        let free = held_beam::on_supports(&basic, Discretisation::BeamElements).map(|beam| beam.clearance());
        let free = free.unwrap_or_default();
        let offset = basic.nodes().start - self.nodes().start;
        let line = self.resting_line();
        // An elastic foundation lets the beam settle under the load.
        let settled = self.give_inside() * self.loads.iter().sum::<f64>().abs() / as_float(self.intervals);
        let (stops, weight) = (self.supports.stops(), self.loads.iter().map(|q| q.abs()).sum::<f64>());
        let room = |(node, gap): (usize, &f64)| match stops.iter().find(|stop| stop.node == node) {
            _ if !self.is_open_at(node) => (gap - line(node)).abs() + settled,
            Some(stop) => (stop.deflection - line(node)).abs() + weight / stop.stiffness,
            None => f64::INFINITY,
        };
        let room = self.nodes().zip(&self.depths).map(room).skip(offset);
        let loads = self.nodes().filter(|node| self.supports.at(*node).is_none()).map(|node| self.loads[node]);
        let length = self.grid.place(self.intervals);
        size(&free, room, loads, self.stiffness, length)
    }

    /// Gap below a node that is not a supported end.
    pub(super) fn gap(&self, node: usize) -> f64 {
        self.depths[node - self.supports.first()]
    }

    /// Level at which a node is held: the level of its support or of the foundation.
    #[inline]
    pub(super) fn level(&self, node: usize) -> f64 {
        self.supports.at(node).map_or_else(|| self.gap(node), |support| support.held.deflection)
    }

    /// Size of the numbers from which the gap below a node, or below a chord next to it, is computed.
    pub(super) fn depth_rounding(&self, node: usize) -> f64 {
        let size = |profile: &Option<Arc<Foundation>>| {
            profile.as_ref().map_or(0.0, |profile| profile.magnitude_at(self.grid.place(node)))
        };
        size(&self.profile) + size(&self.shape)
    }

    /// The same beam on other supports and under other loads, above a foundation that is known at the nodes only.
    fn changed(&self, supports: Supports, depths: Vec<f64>, loads: Vec<f64>) -> Self {
        let (ground, divisions, touching) = (Arc::clone(&self.ground), self.divisions.clone(), self.touching.clone());
        let (profile, shape) = (None, None);
        Self { depths, supports, loads, ground, divisions, touching, profile, shape, simple: false, ..*self }
    }

    /// The same beam above a foundation that is known at the nodes only, with stops raised by the given amounts.
    pub(super) fn above(&self, depths: Vec<f64>, raised: &[f64]) -> Self {
        self.changed(self.supports.raised(raised), depths, self.loads.clone())
    }

    /// The beam on its supports, with more supports if these do not hold it, above a foundation at level zero and under other loads.
    /// This is the basic structure for forces in balance.
    pub(super) fn basic(&self, loads: Vec<f64>) -> Self {
        let missing = self.missing(&self.supports.held_nodes());
        let supports = match self.divisions.has_hinges() && self.tension <= 0.0 {
            true => self.supports.and_at(&missing),
            false => self.supports.completed(),
        };
        Self { ground: Arc::new([]), ..self.on(supports, loads) }
    }

    /// The beam on other supports and under other loads, above a foundation at level zero.
    pub(super) fn on(&self, supports: Supports, loads: Vec<f64>) -> Self {
        let depths = zeros(supports.nodes().len());
        self.changed(supports, depths, loads)
    }

    /// The same without loads, and with all supports and slopes at zero. The remaining problem is linear in the contact forces.
    pub(super) fn bare(&self) -> Self {
        self.on(self.supports.at_zero(), vec![0.0; self.loads.len()])
    }
}

#[expect(clippy::cast_precision_loss, reason = "grids stay far below 2⁵³ nodes")]
pub(super) fn as_float(n: usize) -> f64 {
    n as f64
}

/// The sizes of [`Discrete::sizes`] from the free deflection, the gap available to it, and the loads.
fn size(
    free: &[f64],
    room: impl Iterator<Item = f64> + Clone,
    loads: impl Iterator<Item = f64>,
    stiffness: f64,
    length: f64,
) -> Sizes {
    let largest = |values: &mut dyn Iterator<Item = f64>| values.fold(0.0_f64, f64::max);
    let mut deflection = largest(&mut free.iter().zip(room.clone()).map(|(v, u)| v.abs().min(u.abs())));
    let mut force: f64 = loads.map(f64::abs).sum();
    // A smaller deflection is only what rounding of the elimination leaves in place of zero.
    if deflection <= force * length * length * length / stiffness / PENALTY.sqrt() {
        deflection = largest(&mut room.map(f64::abs).filter(|u| u.is_finite()));
    }
    if deflection <= 0.0 {
        deflection = ON_THE_GROUND * largest(&mut free.iter().map(|v| v.abs()));
    }
    if !(0.0 < deflection && deflection < f64::INFINITY) {
        deflection = 1.0;
    }
    if force <= 0.0 {
        force = 48.0 * stiffness * deflection / (length * length * length);
    }
    Sizes { x: deflection, gradient: force }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::{Beam, Load};

    /// A survey is in memory once, however many grids of its scene exist.
    #[test]
    fn grids_share_the_ground_of_their_scene() {
        let ground =
            |deep: f64| Foundation::Polyline { points: (0..=100).map(|i| [f64::from(i) / 100.0, deep]).collect() };
        let beam = Beam::new(1.0, 1.0).expect("positive").with_shape(ground(0.0)).expect("a shape");
        let scene = Scene::new(beam, Load::default(), Some(ground(1.0))).expect("well posed");
        for scene in [&scene, &scene.clone()] {
            let discrete = Discrete::new(scene, 10).expect("a grid");
            let same = |kept: &Option<Arc<Foundation>>, given: Option<&Foundation>| {
                kept.as_deref().zip(given).is_some_and(|(kept, given)| std::ptr::eq(kept, given))
            };
            assert!(same(&discrete.profile, scene.foundation()) && same(&discrete.shape, scene.beam().shape()));
            assert!(same(&discrete.clone().profile, scene.foundation()));
        }
    }
}
