//! The places at which a beam may be in contact, and the unknowns that belong to them.
//!
//! A *place* is the number of a node or, beyond the last node of the grid, of a stop. A stop is an elastic compression-only support.
//! If there is a foundation below a stop, it is another place at the same node. Values at *slots* are values at all nodes except
//! supported ends, followed by those of the stops. Values of unknowns leave out the nodes with nothing to touch and those that a
//! support holds.

use std::sync::Arc;

use super::discrete::Discrete;
use super::supports::Supports;
use crate::scene::{Grid, Scene};

/// The nodes at which the beam may be in contact.
#[derive(Debug, Clone, PartialEq, Default)]
pub(super) struct Touching {
    /// These nodes, ascending; [`None`] if they are all nodes without a support.
    nodes: Option<Arc<[usize]>>,
}

impl Touching {
    /// The contact nodes of a scene on a grid, with the parts of an elastic foundation. Without a foundation the gap at a stop is set
    /// to its level.
    pub(super) fn of(
        scene: &Scene,
        grid: &Grid,
        supports: &Supports,
        ground: &[([f64; 2], f64)],
        gaps: &mut [f64],
    ) -> Self {
        let (bearings, stops) = (supports.bearings(), supports.stops());
        if scene.foundation().is_none() {
            for stop in stops {
                gaps[stop.node - supports.first()] = stop.deflection;
            }
            let places = !(bearings.is_empty() && stops.is_empty());
            let nodes = places.then(|| bearings.iter().map(|bearing| bearing.node).collect());
            return Self { nodes };
        }
        if ground.iter().all(|(_, k)| 0.0 < *k) {
            return Self::default();
        }
        let carries = |node: &usize| {
            supports.pushing(*node).is_some() || grid.give(ground, *node, |node| supports.is_sunk(node)).is_finite()
        };
        let free = supports.nodes().filter(|node| supports.at(*node).is_none());
        Self { nodes: Some(free.filter(carries).collect()) }
    }
}

impl Discrete {
    /// Whether there may be nodes with nothing to touch.
    pub(crate) fn has_open_nodes(&self) -> bool {
        self.touching.nodes.is_some()
    }

    /// The nodes at which the beam may touch the foundation or a rigid compression-only support, ascending.
    pub(super) fn touchable(&self) -> impl Iterator<Item = usize> + Clone + '_ {
        (0..self.touchable_count()).map(|unknown| self.place(unknown))
    }

    fn touchable_count(&self) -> usize {
        let all = || self.nodes().len() - self.supports().inner().len();
        self.touching.nodes.as_ref().map_or_else(all, |nodes| nodes.len())
    }

    /// The same as places, followed by the stops.
    pub(super) fn places(&self) -> impl Iterator<Item = usize> + Clone + '_ {
        (0..self.unknowns()).map(|unknown| self.place(unknown))
    }

    /// The nodes without a rigid support that holds the beam, ascending.
    pub(super) fn free_nodes(&self) -> impl Iterator<Item = usize> + '_ {
        self.nodes().filter(|node| self.supports().at(*node).is_none())
    }

    /// Whether a node has nothing to touch and no rigid support.
    pub(super) fn is_open_at(&self, node: usize) -> bool {
        let is_missing = |nodes: &Arc<[usize]>| nodes.binary_search(&node).is_err();
        self.touching.nodes.as_ref().is_some_and(is_missing) && self.supports().at(node).is_none()
    }

    /// Whether a node has nothing below it, so that its clearance has no meaning.
    pub(super) fn is_bottomless(&self, node: usize) -> bool {
        let is_touched = |nodes: &Arc<[usize]>| nodes.binary_search(&node).is_ok();
        let open = self.touching.nodes.as_ref().is_some_and(|nodes| !is_touched(nodes));
        open && !(self.gives() && self.give(node).is_finite())
    }

    /// Number of places at which the beam may be in contact and no support holds it.
    #[must_use]
    pub(crate) fn unknowns(&self) -> usize {
        self.touchable_count() + self.supports().stops().len()
    }

    /// The place of an unknown.
    pub(super) fn place(&self, unknown: usize) -> usize {
        if let Some(stop) = unknown.checked_sub(self.touchable_count()) {
            return self.intervals + 1 + stop;
        }
        if let Some(nodes) = &self.touching.nodes {
            return nodes[unknown];
        }
        let first = self.nodes().start + unknown;
        self.supports().inner().iter().fold(first, |node, support| node + usize::from(support.node <= node))
    }

    /// The number of the stop at a place, if the place is a stop.
    #[inline]
    pub(crate) fn stop(&self, place: usize) -> Option<usize> {
        place.checked_sub(self.intervals + 1)
    }

    /// The node of a place.
    pub(super) fn node_of(&self, place: usize) -> usize {
        self.stop(place).map_or(place, |stop| self.supports().stops()[stop].node)
    }

    /// The depth of whatever the beam may touch at a place.
    pub(super) fn depth_of(&self, place: usize) -> f64 {
        self.stop(place).map_or_else(|| self.gap(place), |stop| self.supports().stops()[stop].deflection)
    }

    /// The settlement under a unit force of whatever is below a place.
    pub(super) fn give_of(&self, place: usize) -> f64 {
        self.stop(place).map_or_else(|| self.give(place), |stop| 1.0 / self.supports().stops()[stop].stiffness)
    }

    /// The node of an unknown, whether it belongs to a stop, and its settlement under a unit force.
    #[must_use]
    pub fn unknown(&self, unknown: usize) -> (usize, bool, f64) {
        let place = self.place(unknown);
        (self.node_of(place), self.stop(place).is_some(), self.give_of(place))
    }

    /// Converts values at slots to values of unknowns.
    pub(super) fn without_supports(&self, mut values: Vec<f64>) -> Vec<f64> {
        let first = self.nodes().start;
        if let Some(nodes) = &self.touching.nodes {
            let stops = values.split_off(self.nodes().len());
            return nodes.iter().map(|node| values[node - first]).chain(stops).collect();
        }
        for support in self.supports().inner().iter().rev() {
            values.remove(support.node - first);
        }
        values
    }

    /// Converts values of unknowns to values at slots, zero at inner supports and where there is nothing to touch.
    pub(super) fn with_supports(&self, mut values: Vec<f64>) -> Vec<f64> {
        let first = self.nodes().start;
        if let Some(nodes) = &self.touching.nodes {
            let stops = values.split_off(nodes.len());
            let mut all = vec![0.0; self.nodes().len()];
            nodes.iter().zip(values).for_each(|(node, value)| all[node - first] = value);
            all.extend(stops);
            return all;
        }
        for support in self.supports().inner() {
            values.insert(support.node - first, 0.0);
        }
        values
    }
}
