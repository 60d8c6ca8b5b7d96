//! A beam on nodes that hold it, with known moments there: the forces at these nodes and the clearances between them.
//!
//! Contact forces and clearances follow from the moments:
//!
//! ```text
//! p_i = q_i + (M_{i+1} − M_i)/b − (M_i − M_{i−1})/a + what the spans on both sides leave at their ends
//! h = (g − chord) − sag,    −δ²sag_k = (Δ³/EI) c(M)_k   between two contacts                        (Mohr's analogy)
//! c(M)_k = M_k   by finite differences,   (M_{k−1} + 4 M_k + M_{k+1})/6   with beam elements
//! ```

use std::ops::Range;

use super::contact_set::ContactSet;
use super::discrete::as_float;
use super::overhang::Overhang;
use super::span::Span;
use super::supports::NodeSpring;
use super::{Discrete, statics};
use crate::memory::zeros;
use crate::qp::NotPositiveDefinite;
use crate::state::{Discretisation, larger_moment};

/// Rounding of a contact force or a clearance, in units in the last place of the numbers of which it is a difference. It comes from
/// evaluating a profile and a chord, and from summing loads in blocks.
pub(super) const UNITS: f64 = 16.0;

/// A negative clearance below this fraction of the deflection may be rounding. Only then is its rounding computed.
pub(super) const NEAR_ZERO: f64 = 1e-12;

/// Nodes of a stretch that needs no memory of its own.
const SHORT: usize = 32;

/// A beam on its contacts and supports, with the moments there \[force · Δ\].
pub(super) struct Beam<'a, S> {
    pub(super) discrete: &'a Discrete,
    pub(super) discretisation: Discretisation,
    /// The span between two nodes.
    pub(super) span: S,
    pub(super) nodes: Vec<usize>,
    /// The nodes among them that nothing holds, where the beam changes.
    pub(super) free: Vec<usize>,
    /// Elastic supports that act on the beam, and the nodes that only an elastic support holds.
    pub(super) springs: Vec<NodeSpring>,
    pub(super) sprung: Vec<usize>,
    pub(super) moments: Vec<f64>,
    /// Settlement of the foundation below each node; at nodes that nothing holds, the deflection. Empty if the foundation is rigid
    /// and all nodes are held.
    pub(super) sunk: Vec<f64>,
    /// For each node that holds the beam, the force by which an axial force presses it down, and the size of the terms of which this
    /// force is a difference. Empty without an axial force.
    pub(super) pulled: Vec<[f64; 2]>,
    pub(super) overhangs: [Option<Overhang>; 2],
    /// The nodes of the overhangs at which the beam changes, from the root to the tip.
    pub(super) beyond: [Vec<usize>; 2],
}

/// A stretch of the beam between two held nodes, or from a held node to a tip.
#[derive(Clone, Copy)]
pub(super) struct Stretch {
    pub(super) nodes: [usize; 2],
    /// Moments and levels at its ends.
    pub(super) moments: [f64; 2],
    pub(super) levels: [f64; 2],
    /// How far the tip of an overhang moves by the rotation of its root.
    pub(super) lever: f64,
}

impl<S: Fn(usize, usize) -> Span> Beam<'_, S> {
    /// The force that holds the beam at each node: the share of the loads there, and the jump of the shear force.
    pub(super) fn forces(&self, mut visit: impl FnMut(usize, f64)) {
        if !self.pulled.is_empty() {
            return self.forces_under_tension(visit);
        }
        let [before, behind] = self.overhangs.map(|overhang| overhang.map_or(0.0, |overhang| overhang.force));
        let mut left = SpanEnd { share: before, ..SpanEnd::default() };
        for (pair, moments) in self.nodes.windows(2).zip(self.moments.windows(2)) {
            if pair[0] == pair[1] {
                continue;
            }
            let span = (self.span)(pair[0], pair[1]);
            let shear = moments[1] - moments[0];
            let shear = if pair[0] + 1 == pair[1] { shear } else { shear / span.steps };
            let right = SpanEnd { share: span.shares[1], shear, moments: [moments[0], moments[1]], steps: span.steps };
            let load = span.shares[0] + self.discrete.loads[pair[0]];
            if !self.is_free(pair[0]) {
                visit(pair[0], left.contact_force(&right, load));
            }
            left = right;
        }
        let last = self.nodes[self.nodes.len() - 1];
        visit(last, left.contact_force(&SpanEnd::default(), behind + self.discrete.loads[last]));
    }

    /// Whether nothing holds a node of the list.
    #[inline]
    pub(super) fn is_free(&self, node: usize) -> bool {
        !self.free.is_empty() && self.free.binary_search(&node).is_ok()
    }

    /// The level at which node `i` of the list is.
    pub(super) fn level(&self, i: usize) -> f64 {
        let sunk = self.sunk.get(i).copied().unwrap_or(0.0);
        let node = self.nodes[i];
        if self.is_free(node) {
            return sunk;
        }
        let spring = || self.springs.iter().find(|spring| spring.node == node);
        let level = if self.is_sprung(node) { spring().map(|spring| spring.deflection) } else { None };
        level.unwrap_or_else(|| self.discrete.level(node)) + sunk
    }

    /// Whether only an elastic support holds a node.
    pub(super) fn is_sprung(&self, node: usize) -> bool {
        !self.sprung.is_empty() && self.sprung.binary_search(&node).is_ok()
    }

    /// The contact force at a node with an active elastic support: the total force less the force of the spring.
    pub(super) fn beside_spring(&self, spring: &NodeSpring, all: f64) -> f64 {
        match self.nodes.binary_search(&spring.node) {
            Ok(i) if !self.is_sprung(spring.node) => all - spring.stiffness * (self.level(i) - spring.deflection),
            _ => 0.0,
        }
    }

    /// The force of an active elastic support from its compression, without cancellation.
    pub(super) fn spring_force(&self, spring: &NodeSpring) -> f64 {
        let Ok(i) = self.nodes.binary_search(&spring.node) else { return f64::NAN };
        let alone = self.is_sprung(spring.node);
        let pressed = if alone { self.sunk[i] } else { self.level(i) - spring.deflection };
        spring.stiffness * pressed
    }

    /// Forces of all stops, and the distance of the beam from the foot of each, which is zero where the stop is pressed. Negative
    /// values that may be rounding are set to zero.
    pub(super) fn stops(&self, range: &Range<usize>, clearance: &[f64]) -> [Vec<f64>; 2] {
        let stops = self.discrete.supports().stops();
        let largest = || self.moments.iter().fold(0.0, |most: f64, moment| most.max(moment.abs()));
        let of = |stop: &NodeSpring| {
            if self.springs.iter().any(|spring| spring.node == stop.node) {
                let force = self.spring_force(stop);
                let rounding = UNITS * f64::EPSILON * (self.discrete.loads[stop.node].abs() + largest());
                return [if force < 0.0 && -force <= rounding { 0.0 } else { force }, 0.0];
            }
            let Some(i) = stop.node.checked_sub(range.start).filter(|i| *i < clearance.len()) else { return [0.0; 2] };
            let v = match self.nodes.binary_search(&stop.node) {
                Ok(k) => self.level(k),
                Err(_) => self.discrete.gap(stop.node) - clearance[i],
            };
            let open = stop.deflection - v;
            let rounding =
                (NEAR_ZERO * self.discrete.sizes().x).min(UNITS * f64::EPSILON * (stop.deflection.abs() + v.abs()));
            [0.0, if open < 0.0 && -open <= rounding { 0.0 } else { open }]
        };
        let all: Vec<[f64; 2]> = stops.iter().map(of).collect();
        [0, 1].map(|k| all.iter().map(|both| both[k]).collect())
    }

    /// The stretch from node `i` of the list to the next one.
    fn stretch(&self, i: usize) -> Stretch {
        let nodes = [self.nodes[i], self.nodes[i + 1]];
        let levels = [i, i + 1].map(|i| self.level(i));
        Stretch { nodes, moments: [self.moments[i], self.moments[i + 1]], levels, lever: 0.0 }
    }

    /// Clearances at the nodes of a range that nothing holds. A clearance that is negative by less than the rounding of its terms is
    /// set to zero.
    ///
    /// The rounding is measured locally. Near a support, over a foundation that begins at the level of the support, all numbers are
    /// small. Measured by the whole beam, the beam could hang free or penetrate the foundation over thousands of nodes.
    pub(super) fn clearances(&self, range: &Range<usize>, clearance: &mut [f64]) {
        let mut buffer = Vec::new();
        for (i, pair) in self.nodes.windows(2).enumerate() {
            // In dense contact there are no nodes between.
            if pair[0] + 1 < pair[1] && range.start.max(pair[0] + 1) < range.end.min(pair[1]) {
                self.clearances_in(&self.stretch(i), range, clearance, &mut buffer);
            }
        }
        let moves = |node: &usize| range.contains(node) && (self.is_free(*node) || self.is_sprung(*node));
        let between = self.bent_between();
        for (i, node) in self.nodes.iter().enumerate().filter(|(_, node)| moves(node)) {
            let bent = between.get(i).copied();
            let bent = bent.unwrap_or_else(|| self.bent(&self.stretch(i.min(self.nodes.len() - 2))));
            clearance[node - range.start] = self.clearance_of(*node, self.level(i), 0.0, bent);
        }
        for side in 0..2 {
            for stretch in self.overhang(side) {
                self.clearances_in(&stretch, range, clearance, &mut buffer);
                let far = stretch.nodes[side];
                if range.contains(&far) {
                    let bent = self.bent(&stretch);
                    clearance[far - range.start] = self.clearance_of(far, stretch.levels[side], 0.0, bent);
                }
            }
        }
    }

    /// How far the end moments bend a stretch, `M L²/EI`, plus the movement of an overhang with its root.
    fn bent(&self, stretch: &Stretch) -> f64 {
        let Discrete { spacing, stiffness, .. } = self.discrete;
        let [first, last] = stretch.nodes;
        let steps = as_float(last - first);
        let unit = spacing * spacing * spacing / stiffness;
        unit * stretch.moments[0].abs().max(stretch.moments[1].abs()) * (steps * steps) + stretch.lever
    }

    /// The clearance of a node that sags by `sag` below its chord.
    #[inline]
    fn clearance_of(&self, node: usize, chord: f64, sag: f64, bent: f64) -> f64 {
        let discrete = self.discrete;
        let open = (discrete.gap(node) - chord) - sag;
        // Few clearances are negative by so little; the rounding is computed for these only.
        let small = NEAR_ZERO * discrete.sizes().x;
        let is_rounding =
            open < 0.0 && -small < open && -open <= UNITS * f64::EPSILON * (discrete.depth_rounding(node) + bent);
        if is_rounding { 0.0 } else { open }
    }

    /// The same at the nodes strictly between the ends of a stretch.
    #[expect(clippy::cast_precision_loss, reason = "grids stay far below 2⁵³ nodes")]
    fn clearances_in(&self, stretch: &Stretch, range: &Range<usize>, clearance: &mut [f64], buffer: &mut Vec<f64>) {
        let discrete = self.discrete;
        let &Stretch { nodes: [first, last], moments: ends, levels: [from, to], .. } = stretch;
        let inner = range.start.max(first + 1)..range.end.min(last);
        if inner.is_empty() {
            return;
        }
        let cube = discrete.spacing * discrete.spacing * discrete.spacing;
        let sixth = cube / (6.0 * discrete.stiffness) * discrete.divisions().softness(first);
        // Moments and sags at the ends of the part of the stretch within the range, which is usually the whole stretch.
        let at = |node: usize| match node {
            _ if node == first => [ends[0], 0.0],
            _ if node == last => [ends[1], 0.0],
            _ => {
                let parts = [first..node, node..last].map(|part| (self.span)(part.start, part.end));
                parts[0].between(parts[1], discrete.loads[node], ends, self.discretisation)
            }
        };
        let [[m0, sag0], [m1, sag1]] = [inner.start - 1, inner.end].map(at);
        let mut short = [0.0; SHORT];
        let curvature = if let Some(short) = short.get_mut(..inner.len()) {
            short
        } else {
            buffer.resize(inner.len(), 0.0);
            &mut buffer[..]
        };
        statics::funicular(&discrete.loads[inner.clone()], [m0, m1], 1.0, curvature);
        // Mohr's analogy, in 6 EI / Δ³.
        statics::curvatures(curvature, [m0, m1], |m| match self.discretisation {
            Discretisation::FiniteDifferences => 6.0 * m[1],
            Discretisation::BeamElements => m[0] + 4.0 * m[1] + m[2],
        });
        let sags = &mut clearance[inner.start - range.start..inner.end - range.start];
        statics::funicular(curvature, [sag0, sag1], sixth, sags);

        let (steps, bent) = ((last - first) as f64, self.bent(stretch));
        // The clearances overwrite the sags.
        for (node, h) in inner.zip(sags) {
            let chord = from + (to - from) * ((node - first) as f64 / steps);
            *h = self.clearance_of(node, chord, *h, bent);
        }
    }

    /// The force of each support of a beam that only supports hold, with the moments next to it \[force · length\].
    pub(super) fn supports(&self) -> Vec<HeldNode> {
        let mut held: Vec<HeldNode> = Vec::new();
        self.forces(|node, force| held.push(HeldNode { node, force, moments: [0.0; 2] }));
        for spring in &self.springs {
            if let Some(held) = held.iter_mut().find(|held| held.node == spring.node && self.is_sprung(held.node)) {
                held.force = self.spring_force(spring);
            }
        }
        let mut i = 0;
        for held in &mut held {
            // Skips nodes at which the beam changes.
            while self.nodes[i] != held.node {
                i += 1;
            }
            let left = self.moments[i];
            i += 1;
            let twice = self.nodes.get(i) == Some(&held.node);
            held.moments =
                [left, if twice { self.moments[i] } else { left }].map(|moment| moment * self.discrete.spacing);
            i += usize::from(twice);
        }
        held
    }

    /// Moments at all nodes \[force · length\]; at a built-in support the larger of the moments on its two sides.
    pub(super) fn moments(&self) -> Vec<f64> {
        let spacing = self.discrete.spacing;
        let mut moments = zeros(self.discrete.intervals + 1);
        let stretches = (0..self.nodes.len() - 1).map(|i| (self.stretch(i), None));
        let overhangs =
            (0..2).flat_map(|side| self.overhang(side).into_iter().map(move |stretch| (stretch, Some(side))));
        for (Stretch { nodes: [first, last], moments: ends, .. }, tip) in stretches.chain(overhangs) {
            if first < last {
                let (loads, inner) = (&self.discrete.loads[first + 1..last], &mut moments[first + 1..last]);
                statics::funicular(loads, ends, spacing, inner);
            }
            if let Some(side) = tip {
                moments[[first, last][side]] = ends[side] * spacing;
            }
        }
        for (&node, &moment) in self.nodes.iter().zip(&self.moments) {
            moments[node] = larger_moment([moments[node], moment * spacing]);
        }
        moments
    }

    /// Clearances at all nodes except supported ends, zero at held nodes.
    pub(super) fn clearance(&self) -> Vec<f64> {
        let nodes = self.discrete.nodes();
        let mut clearance = zeros(nodes.len());
        self.clearances(&nodes, &mut clearance);
        clearance
    }

    /// Deflections at all nodes except supported ends.
    pub(super) fn deflection(&self) -> Vec<f64> {
        let nodes = self.discrete.nodes();
        let mut deflection = self.clearance();
        deflection.iter_mut().zip(&self.discrete.depths).for_each(|(value, gap)| *value = gap - *value);
        let held = |node: &usize| nodes.contains(node) && !self.is_free(*node);
        for (i, node) in self.nodes.iter().enumerate().filter(|(_, node)| held(node)) {
            deflection[node - nodes.start] = self.level(i);
        }
        deflection
    }
}

/// A support of the beam: its node, its upward force, and the moments next to it.
#[derive(Debug, Clone, Copy)]
pub(super) struct HeldNode {
    pub(super) node: usize,
    pub(super) force: f64,
    pub(super) moments: [f64; 2],
}

impl HeldNode {
    /// The supports with NaN for all values, for a beam in which a number is not finite.
    pub(super) fn unknown(discrete: &Discrete) -> Vec<Self> {
        let supports = discrete.supports().all().iter();
        supports.map(|support| Self { node: support.node, force: f64::NAN, moments: [f64::NAN; 2] }).collect()
    }
}

/// The beam on its supports alone, above a foundation at level zero.
pub(super) fn on_supports(
    discrete: &Discrete,
    discretisation: Discretisation,
) -> Result<Beam<'_, impl Fn(usize, usize) -> Span>, NotPositiveDefinite> {
    let span = |first: usize, last: usize| Span::under(&discrete.loads[first + 1..last]);
    ContactSet::at(discrete, std::iter::empty()).beam(discrete, discretisation, span)
}

/// Force and moment of a span at one of its ends.
#[derive(Default)]
pub(super) struct SpanEnd {
    /// Its share of the loads of the span, and the shear force.
    pub(super) share: f64,
    pub(super) shear: f64,
    /// Moments at both ends of the span, and its length.
    pub(super) moments: [f64; 2],
    pub(super) steps: f64,
}

impl SpanEnd {
    /// The contact force between this span and the next one, for the load on the node plus the share of the next span. A force that
    /// is negative by less than the rounding of its terms is set to zero.
    ///
    /// The jump of the shear force is computed first. In dense contact it is a small difference of numbers with the same exponent,
    /// and exact. If a load, or a share of the loads of a span, were added to a shear force before, it would be rounded in the same
    /// way at each of a million nodes.
    #[inline]
    fn contact_force(&self, next: &Self, load: f64) -> f64 {
        self.pulled_force(next, load, [0.0; 2])
    }

    /// The same with the force by which an axial force presses the node down, and the size of the terms of which that force is a
    /// difference.
    #[inline]
    pub(super) fn pulled_force(&self, next: &Self, load: f64, [pulled, size]: [f64; 2]) -> f64 {
        let carried = self.share + load;
        let force = ((next.shear - self.shear) + pulled) + carried;
        let bent = |span: &Self| (span.moments[0].abs() + span.moments[1].abs()) / span.steps.max(1.0);
        let is_rounding =
            force < 0.0 && -force <= UNITS * f64::EPSILON * (carried.abs() + size + bent(self) + bent(next));
        if is_rounding { 0.0 } else { force }
    }
}
