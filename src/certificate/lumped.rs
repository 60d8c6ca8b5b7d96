//! Contact forces at the nodes of equal intervals, computed under a load that was lumped at the same nodes.
//!
//! Between two nodes a distributed load bends the beam by the moment `q s (Δ − s)/2`, of mean `qΔ²/12`, which nodal loads leave
//! out. So the same contact forces under the true load let the beam sag more, at the nodes by
//!
//! ```text
//! q Δ² x (l − x) / (24 EI),      at mid-span q Δ² l² / (96 EI)
//! ```
//!
//! where `q` is uniform. Whoever lumped the load means the deflection without that: it is the one to be bounded then.

use super::contact_load::{ContactLoad, NotAForce};
use super::kkt::Equilibrium;
use crate::scene::{Grid, Scene, SceneError};
use crate::state::{Discretisation, Nodes};

/// Contact forces at all inner nodes of equal intervals, and the beam that bends under them and under the nodal loads (25),
/// exact between the nodes. Forces that pull are cut off.
#[derive(Debug, Clone, PartialEq)]
pub struct Lumped {
    /// The forces, at the places of the nodes.
    pub load: ContactLoad,
    /// The beam at its inner nodes, in the units of the scene.
    pub nodes: Nodes,
}

/// Why contact forces do not belong to a load that is lumped at the nodes of equal intervals.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum NotLumped {
    /// A force that is none.
    #[error(transparent)]
    Force(#[from] NotAForce),
    /// The scene leaves the range of `f64` when it is scaled.
    #[error(transparent)]
    Scene(#[from] SceneError),
    /// No place between the supports.
    #[error("no place between the supports has a force; every inner node of equal intervals needs one, which may be 0")]
    NoNodes,
    /// A place that is no node.
    #[error(
        "with forces at {count} places between the supports, place {index} would be x = {node} on equal intervals, but is x = {x}; \
         every inner node needs a force, which may be 0"
    )]
    NotANode {
        /// Which place between the supports, from 1.
        index: usize,
        /// How many there are.
        count: usize,
        /// Where it is.
        x: f64,
        /// Where it should be.
        node: f64,
    },
}

/// How far a place may be from its node, as a share of an interval: places are printed with few digits.
const ROUNDED: f64 = 1e-2;

impl Lumped {
    /// Forces `(x, force)` in any order, one at every inner node, zeros included; forces at one place add up, and those on the
    /// supports do not bend the beam.
    ///
    /// # Errors
    ///
    /// [`NotLumped`]: a force that is none, or places that are not the inner nodes of equal intervals.
    pub fn new(scene: &Scene, forces: impl IntoIterator<Item = (f64, f64)>) -> Result<Self, NotLumped> {
        let length = scene.beam().length();
        let mut inner = ContactLoad::sorted(length, forces)?;
        inner.retain(|f| 0.0 < f.0 && f.0 < length);
        let count = inner.len();
        if count == 0 {
            return Err(NotLumped::NoNodes);
        }
        let grid = Grid::uniform(scene, count + 1)?;
        for (k, force) in inner.iter_mut().enumerate() {
            let (x, node) = (force.0, grid.place(k + 1));
            if ROUNDED * grid.spacing() < (x - node).abs() {
                return Err(NotLumped::NotANode { index: k + 1, count, x, node });
            }
            force.0 = node;
        }
        let nodes = bent(scene, inner.iter().map(|f| f.1.max(0.0)).collect())?;
        Ok(Self { load: ContactLoad::new(length, inner)?, nodes })
    }

    /// Number of equal intervals.
    #[must_use]
    pub fn intervals(&self) -> usize {
        self.nodes.x.len() + 1
    }
}

/// The beam under nodal loads and contact forces at all inner nodes: statics and integration, in the units of the scene.
fn bent(given: &Scene, mut forces: Vec<f64>) -> Result<Nodes, SceneError> {
    given.only_simple_beam("nodal contact forces")?;
    let scaled = given.scaled()?;
    let (scene, scale) = (&scaled.scene, &scaled.scale);
    let count = forces.len();
    let grid = Grid::uniform(scene, count + 1)?;
    forces.iter_mut().for_each(|p| *p /= scale.force);
    let discretisation = Discretisation::BeamElements;
    let (mut moment, mut deflection) = (Vec::with_capacity(count), Vec::with_capacity(count));
    Equilibrium::of(scene, grid, &forces, discretisation).walk(|_, moments, deflections| {
        moment.extend_from_slice(moments);
        deflection.extend_from_slice(deflections);
    });
    let times = |values: Vec<f64>, unit: f64| values.into_iter().map(|value| value * unit).collect::<Vec<_>>();
    let x = Grid::uniform(given, count + 1)?.interior_places();
    let deflection = times(deflection, scale.depth);
    Ok(Nodes {
        discretisation,
        clearance: x.iter().zip(&deflection).map(|(&x, v)| given.gap(x) - v).collect(),
        x,
        deflection,
        contact_force: times(forces, scale.force),
        moment: times(moment, scale.moment()),
    })
}
