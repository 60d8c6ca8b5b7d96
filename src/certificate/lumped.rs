//! Contact forces at the nodes of equal intervals, computed under a load lumped at the same nodes.
//!
//! Between two nodes a distributed load bends the beam by the moment `q s (Δ − s)/2`, of mean `qΔ²/12`, which nodal loads omit. So the
//! same contact forces under the true load cause a larger deflection, at the nodes by
//!
//! ```text
//! q Δ² x (l − x) / (24 EI),      at mid-span q Δ² l² / (96 EI)
//! ```
//!
//! for uniform `q`. A program that lumped the load computed the deflection without this contribution, so this is the deflection to be
//! bounded.

use super::contact_load::{ContactLoad, NotAForce, deflection};
use super::in_intervals;
use super::judged::Curve;
use super::kernel::interval::Interval;
use crate::scene::{Balance, Grid, Load, PointLoad, Scene, SceneError};
use crate::state::{Discretisation, Nodes};

/// Contact forces at all inner nodes of equal intervals, and the beam under them and under the nodal loads (25), exact between the
/// nodes. Negative forces are cut off.
#[derive(Debug, Clone, PartialEq)]
pub struct Lumped {
    /// The forces, at the positions of the nodes.
    pub load: ContactLoad,
    /// The beam at its nodes, except the ends that a support holds, in the units of the scene.
    pub nodes: Nodes,
    intervals: usize,
    /// Clearances at the nodes of the feet of the foundation springs; on a rigid foundation the clearances of the beam.
    pub(super) feet: Vec<f64>,
}

/// The reason why contact forces do not match a load lumped at the nodes of equal intervals.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum NotLumped {
    /// A contact force is not valid.
    #[error(transparent)]
    Force(#[from] NotAForce),
    /// The scene leaves the range of `f64` when it is scaled.
    #[error(transparent)]
    Scene(#[from] SceneError),
    /// There is no position between the supports.
    #[error("no place between the supports has a force; every inner node of equal intervals needs one, which may be 0")]
    NoNodes,
    /// A support is not at a node, or the forces do not hold the beam.
    #[error("on {intervals} equal intervals a support of the beam is no node, or the forces do not hold the beam")]
    NotHeld {
        /// Number of equal intervals.
        intervals: usize,
    },
    /// A position is not at a node.
    #[error(
        "with forces at {count} places between the supports, place {index} would be x = {node} on equal intervals, but is x = {x}; \
         every inner node needs a force, which may be 0"
    )]
    NotANode {
        /// Number of the position between the supports, from 1.
        index: usize,
        /// Number of these positions.
        count: usize,
        /// The given position.
        x: f64,
        /// The position of the node.
        node: f64,
    },
}

/// Largest distance of a position from its node, as a share of an interval: printed positions have few digits.
const ROUNDED: f64 = 1e-2;

impl Lumped {
    /// Computes the beam under forces `(x, force)`, given in any order. Every node needs a force, zeros included, also at supports
    /// inside the beam, except the ends that a support holds. Forces at one position add up, and forces at supports do not bend the
    /// beam. If its supports do not hold the beam, it touches the foundation at two of the forces: the largest one and the one with the
    /// largest moment about it.
    ///
    /// # Errors
    ///
    /// [`NotLumped`]: a force is not valid, the positions are not the inner nodes of equal intervals, or statics does not determine how
    /// the beam bends; in the last case a [`Witness`](crate::Witness) can.
    pub fn new(scene: &Scene, forces: impl IntoIterator<Item = (f64, f64)>) -> Result<Self, NotLumped> {
        scene.has_to_bend_under_forces("a check under nodal loads")?;
        Self::bent_by(scene, forces, |lumped, pressing| {
            in_intervals(lumped, Balance::Held, |enclosed| deflection(pressing, enclosed, &[]))
        })
    }

    /// The same for a beam whose deflection under a dimensionless load and dimensionless forces is computed by `bend`.
    pub(crate) fn bent_by(
        scene: &Scene,
        forces: impl IntoIterator<Item = (f64, f64)>,
        bend: impl Fn(&Scene, &ContactLoad) -> Option<Vec<Curve>>,
    ) -> Result<Self, NotLumped> {
        scene.is_placed_by_forces()?;
        let length = scene.beam().length();
        let mut inner = ContactLoad::sorted(length, forces)?;
        // A force at an end that a support holds does not bend the beam.
        let supported = |end: f64| scene.beam().supports().iter().any(|s| (s.at - end).abs() <= 0.0);
        let [left, right] = [0.0, length].map(supported);
        inner.retain(|f| (0.0 < f.0 || !left) && (f.0 < length || !right));
        let (count, first) = (inner.len(), usize::from(left));
        if count == 0 {
            return Err(NotLumped::NoNodes);
        }
        let grid = Grid::uniform(scene, count + first + usize::from(right) - 1)?;
        for (k, force) in inner.iter_mut().enumerate() {
            let (x, node) = (force.0, grid.place(k + first));
            if ROUNDED * grid.spacing() < (x - node).abs() {
                return Err(NotLumped::NotANode { index: k + 1, count, x, node });
            }
            force.0 = node;
        }
        let forces = inner.iter().map(|f| f.1.max(0.0)).collect();
        let nodes = bent(scene, &grid, first, forces, bend)?;
        let foot = |(i, (h, p)): (usize, (&f64, &f64))| h + grid.give_of(scene, i + first) * p;
        let feet = nodes.clearance.iter().zip(&nodes.contact_force).enumerate().map(foot).collect();
        Ok(Self { load: ContactLoad::new(length, inner)?, nodes, intervals: grid.intervals(), feet })
    }

    /// Number of equal intervals.
    #[must_use]
    pub fn intervals(&self) -> usize {
        self.intervals
    }
}

/// The beam under nodal loads and contact forces at the nodes of a grid from the `first` one on, in the units of the scene.
fn bent(
    given: &Scene,
    places: &Grid,
    first: usize,
    forces: Vec<f64>,
    bend: impl Fn(&Scene, &ContactLoad) -> Option<Vec<Curve>>,
) -> Result<Nodes, NotLumped> {
    let scaled = given.scaled()?;
    let (scene, scale, beam) = (&scaled.scene, &scaled.scale, scaled.scene.beam());
    let intervals = places.intervals();
    let grid = Grid::uniform(scene, intervals)?;
    let supports: Vec<Option<usize>> = beam.supports().iter().map(|support| grid.node_at(support.at)).collect();
    let point = |(i, force): (usize, f64)| PointLoad { at: grid.place(i), force };
    let points = grid.nodal_loads(scene).into_iter().enumerate().map(point).collect();
    let load = Load::new(beam, 0.0, Vec::new(), points)?;
    let lumped = scene.under(load)?;
    // A force given at a support does not bend the beam, since the support can have any reaction.
    let pressing = (first..).zip(&forces).filter(|(node, _)| !supports.contains(&Some(*node)));
    let pressing =
        ContactLoad::new(beam.length(), pressing.map(|(node, force)| (grid.place(node), force / scale.force)))?;
    let bent =
        bend(&lumped, &pressing).filter(|_| !supports.contains(&None)).ok_or(NotLumped::NotHeld { intervals })?;
    let at_node = |node: usize| {
        let x = grid.place(node);
        let cell = bent.partition_point(|(cell, _)| cell[1] <= x).min(bent.len() - 1);
        let ([from, _], v) = &bent[cell];
        let s = Interval::exact(x) - Interval::exact(*from);
        let stiffness = beam.stiffness_between(bent[cell].0[0], bent[cell].0[1]);
        [v.at(s).middle(), -stiffness * v.derivative().derivative().at(s).middle()]
    };
    let (deflection, moment): (Vec<f64>, Vec<f64>) = (first..first + forces.len())
        .map(|node| {
            let [v, moment] = at_node(node);
            (v * scale.depth, moment * scale.moment())
        })
        .unzip();
    let mut x = vec![0.0; forces.len()];
    places.places(first, &mut x);
    Ok(Nodes {
        discretisation: Discretisation::BeamElements,
        clearance: x.iter().zip(&deflection).map(|(&x, v)| given.gap(x) - v).collect(),
        x,
        deflection,
        contact_force: forces,
        moment,
    })
}
