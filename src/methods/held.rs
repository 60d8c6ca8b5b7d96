//! A beam that is held at the depth of the foundation at some nodes: from the moments there to contact forces and clearances.
//!
//! ```text
//! contact force     p_i = q_i + (M_{i+1} − M_i)/b − (M_i − M_{i−1})/a + what the spans on both sides leave at their ends
//! clearance         h = (u − chord) − sag,     −δ²sag_k = (Δ³/EI) c(M)_k   between two held nodes        (Mohr's analogy)
//! curvature         c(M)_k = M_k   by finite differences,   (M_{k−1} + 4 M_k + M_{k+1})/6   with beam elements
//! ```
//!
//! for spans of `a` and `b` intervals, moments in `force · Δ`. Deflections are never differenced: contact forces come from
//! moments at held nodes, and deflections from moments by summation, whatever method has found the moments.

use super::{Discrete, continuous, segment::Segment, statics};
use crate::state::Bending;

/// The held nodes, the two supports of the beam among them.
pub(super) struct Held<'a> {
    discrete: &'a Discrete,
    bending: Bending,
    /// Numbers of the nodes, ascending from 0 to `N`.
    nodes: Vec<usize>,
}

impl<'a> Held<'a> {
    /// The beam that is held wherever `free` is false, for interior node 1, 2, …
    pub(super) fn new(discrete: &'a Discrete, bending: Bending, free: &[bool]) -> Self {
        let between = (1..=free.len()).filter(|&node| !free[node - 1]);
        Self { discrete, bending, nodes: std::iter::once(0).chain(between).chain([free.len() + 1]).collect() }
    }

    /// How many.
    pub(super) fn count(&self) -> usize {
        self.nodes.len()
    }

    /// The spans between them under the loads there, from left to right.
    pub(super) fn spans(&self) -> impl Iterator<Item = Segment> + '_ {
        self.nodes.windows(2).map(|pair| self.discrete.span(pair[0], pair[1]))
    }

    /// `(6 EI/Δ²) bend`: by how much the chord bends at each held node, zero at the two ends \[force · interval²\].
    pub(super) fn bends(&self) -> Vec<f64> {
        let unit = 6.0 * self.discrete.stiffness / (self.discrete.spacing * self.discrete.spacing);
        let mut bends = vec![0.0; self.nodes.len()];
        for (bend, three) in bends[1..].iter_mut().zip(self.nodes.windows(3)) {
            *bend = unit * self.discrete.bend(three[0], three[1], three[2]);
        }
        bends
    }

    /// Contact forces at all interior nodes, for moments at the held ones.
    pub(super) fn contact_forces(&self, moments: &[f64]) -> Vec<f64> {
        let mut forces = vec![0.0; self.discrete.interior()];
        let mut before = continuous::Left::default();
        for ((span, nodes), ends) in self.spans().zip(self.nodes.windows(2)).zip(moments.windows(2)) {
            let moments = [ends[0], ends[1]];
            let shear = (moments[1] - moments[0]) / span.steps;
            let left = continuous::Left { share: span.shares[1], shear, moments, steps: span.steps };
            if 0 < nodes[0] {
                forces[nodes[0] - 1] = before.force(&left, span.shares[0] + self.discrete.loads[nodes[0]]);
            }
            before = left;
        }
        forces
    }

    /// Clearances at all interior nodes, for moments at the held ones; zero where they are negative by less than their own
    /// rounding.
    pub(super) fn clearances(&self, moments: &[f64]) -> Vec<f64> {
        let Discrete { spacing, stiffness, depths, loads, .. } = self.discrete;
        let unit = spacing * spacing * (spacing / stiffness);
        let mut clearance = vec![0.0; depths.len()];
        for (nodes, ends) in self.nodes.windows(2).zip(moments.windows(2)) {
            let (first, last) = (nodes[0], nodes[1]);
            if first + 1 == last {
                continue;
            }
            let steps = last - first;
            let mut curvature = vec![0.0; steps - 1];
            statics::funicular(&loads[first + 1..last], [ends[0], ends[1]], 1.0, &mut curvature);
            statics::curvatures(&mut curvature, [ends[0], ends[1]], |m| match self.bending {
                Bending::AtNodes => m[1],
                Bending::Between => (m[0] + 4.0 * m[1] + m[2]) / 6.0,
            });
            let sags = &mut clearance[first..last - 1];
            statics::funicular(&curvature, [0.0; 2], unit, sags);
            // What the end moments bend: `M L²/EI`.
            #[expect(clippy::cast_precision_loss, reason = "grids stay far below 2⁵³ nodes")]
            let bent = unit * ends[0].abs().max(ends[1].abs()) * (steps as f64 * steps as f64);
            let [from, to] = [first, last].map(|node| self.discrete.support_depth(node));
            for (k, (h, depth)) in sags.iter_mut().zip(&depths[first..]).enumerate() {
                #[expect(clippy::cast_precision_loss, reason = "grids stay far below 2⁵³ nodes")]
                let chord = from + (to - from) * ((k + 1) as f64 / steps as f64);
                let open = (depth - chord) - *h;
                let doubtful = open < 0.0 && continuous::is_rounding(self.discrete, first + k + 1, open, bent);
                *h = if doubtful { 0.0 } else { open };
            }
        }
        clearance
    }
}
