//! How the polyline through three nodes bends, which are held on the ground or by supports: what contact does to a beam.

use super::discrete::{Discrete, as_float};
use crate::scene::Foundation;

impl Discrete {
    /// By how much the slope of the polyline through three nodes, held on the foundation or by supports, grows at the middle one.
    /// Where a built-in support holds that one, it is on one side of it twice, and the slope there is that of the support.
    #[inline]
    pub(super) fn bend(&self, left: usize, node: usize, right: usize) -> f64 {
        if !self.supports().are_outside(left, right) {
            return self.bend_at_supports(left, node, right);
        }
        match (self.profile.as_deref(), &self.shape) {
            (Some(Foundation::Flat { .. }), None) => 0.0,
            (Some(profile), shape) => self.bend_of_ground(profile, shape.as_deref(), [left, node, right]),
            (None, _) => self.bend_at_supports(left, node, right),
        }
    }

    /// Lengths of the chords from the middle one of three nodes to the others.
    fn chords(&self, [left, node, right]: [usize; 3]) -> [f64; 2] {
        [self.spacing * as_float(node - left), self.spacing * as_float(right - node)]
    }

    /// The bend of the gap between a profile and an own shape.
    fn bend_of_ground(&self, profile: &Foundation, shape: Option<&Foundation>, nodes: [usize; 3]) -> f64 {
        let [before, behind] = self.chords(nodes);
        let [left, place, right] = nodes.map(|i| self.grid.place(i));
        let bend = |profile: &Foundation| match profile {
            Foundation::Flat { .. } => 0.0,
            profile => profile.bend(place, before, behind, [left, right]),
        };
        shape.map_or_else(|| bend(profile), |shape| bend(profile) - bend(shape))
    }

    /// The same where supports may hold some of the nodes, or where the ground is known at the nodes only.
    fn bend_at_supports(&self, left: usize, node: usize, right: usize) -> f64 {
        let [before, behind] = self.chords([left, node, right]);
        let chord = |from: usize, to: usize, length: f64| (self.level(to) - self.level(from)) / length;
        if left == node || node == right {
            let held = self.supports().at(node).and_then(|support| support.held.slope).unwrap_or(0.0);
            return if left == node { chord(node, right, behind) - held } else { held - chord(left, node, before) };
        }
        let Some(profile) = self.profile.as_deref() else {
            return chord(node, right, behind) - chord(left, node, before);
        };
        let below = [left, node, right].map(|i| self.supports().below(i));
        if below != [None; 3] && self.drops_off([left, node, right], below, [before, behind]) {
            return chord(node, right, behind) - chord(left, node, before);
        }
        let mut bend = self.bend_of_ground(profile, self.shape.as_deref(), [left, node, right]);
        // Supports are not on the foundation.
        if let Some(below) = below[0] {
            bend -= below / before;
        }
        if let Some(below) = below[2] {
            bend -= below / behind;
        }
        below[1].map_or(bend, |below| bend + (below / before + below / behind))
    }

    /// Whether the ground lies so far below one of three nodes with a support that slopes to its depth there, which have no effect
    /// on the beam, would cost more digits than the plain differences of the levels at which the nodes are held.
    fn drops_off(&self, nodes: [usize; 3], below: [Option<f64>; 3], [before, behind]: [f64; 2]) -> bool {
        let [u0, u1, u2] = nodes.map(|i| self.level(i).abs());
        let plain = (u0 + u1) / before + (u1 + u2) / behind;
        let [left, middle, right] = below.map(|below| below.unwrap_or(0.0).abs());
        plain < (left.max(middle) / before).max(right.max(middle) / behind)
    }
}
