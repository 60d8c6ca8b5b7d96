//! The change of slope of the polyline through three nodes on the foundation or on supports: the effect of contact on a beam.

use super::discrete::{Discrete, as_float};
use crate::scene::Foundation;

impl Discrete {
    /// The change of slope, at the middle one of three nodes, of the polyline through them; the nodes lie on the foundation or on
    /// supports. If the middle node is built in, it is given twice on one side, where the slope is that of the support.
    #[inline]
    pub(super) fn bend(&self, left: usize, node: usize, right: usize) -> f64 {
        if !self.supports().are_outside(left, right) {
            return self.bend_at_supports(left, node, right);
        }
        match self.profile.as_deref() {
            Some(profile) => self.bend_of_ground(profile, [left, node, right]),
            None => self.bend_at_supports(left, node, right),
        }
    }

    /// Lengths of the chords from the middle one of three nodes to the other two.
    fn chords(&self, [left, node, right]: [usize; 3]) -> [f64; 2] {
        [self.spacing * as_float(node - left), self.spacing * as_float(right - node)]
    }

    /// The change of slope of the gap between a foundation profile and an initial shape.
    #[inline]
    fn bend_of_ground(&self, profile: &Foundation, nodes: [usize; 3]) -> f64 {
        let shape = self.shape.as_deref();
        if matches!((profile, shape), (Foundation::Flat { .. }, None)) {
            return 0.0;
        }
        let [before, behind] = self.chords(nodes);
        let [left, place, right] = nodes.map(|i| self.grid.place(i));
        let bend = |profile: &Foundation| match profile {
            Foundation::Flat { .. } => 0.0,
            profile => profile.bend(place, before, behind, [left, right]),
        };
        shape.map_or_else(|| bend(profile), |shape| bend(profile) - bend(shape))
    }

    /// The same if supports may hold some of the nodes, or if the foundation is known at the nodes only.
    fn bend_at_supports(&self, left: usize, node: usize, right: usize) -> f64 {
        let nodes = [left, node, right];
        let [before, behind] = self.chords(nodes);
        let levels = nodes.map(|i| self.level(i));
        // A chord of length zero, next to a node that is given twice, is not used.
        let [to_left, to_right] = [(levels[1] - levels[0]) / before, (levels[2] - levels[1]) / behind];
        if left == node || node == right {
            let held = self.supports().slope(node).unwrap_or(0.0);
            return if left == node { to_right - held } else { held - to_left };
        }
        let Some(profile) = self.profile.as_deref() else { return to_right - to_left };
        let below = nodes.map(|i| self.supports().below(i));
        if below != [None; 3] && drops_off(levels, below, [before, behind]) {
            return to_right - to_left;
        }
        let mut bend = self.bend_of_ground(profile, nodes);
        // Supports are not on the foundation.
        if let Some(below) = below[0] {
            bend -= below / before;
        }
        if let Some(below) = below[2] {
            bend -= below / behind;
        }
        below[1].map_or(bend, |below| bend + (below / before + below / behind))
    }
}

/// Whether plain differences of the levels lose fewer digits than the foundation profile. The foundation may lie far below a node
/// with a support. Slopes down to it then have no effect on the beam, but would cost digits.
fn drops_off(levels: [f64; 3], below: [Option<f64>; 3], [before, behind]: [f64; 2]) -> bool {
    let [u0, u1, u2] = levels.map(f64::abs);
    let plain = (u0 + u1) / before + (u1 + u2) / behind;
    let [left, middle, right] = below.map(|below| below.unwrap_or(0.0).abs());
    plain < (left.max(middle) / before).max(right.max(middle) / behind)
}
