//! A continuous beam over sinking supports: Clapeyron's three-moment equations (1857).
//!
//! ```text
//! a M_{i−1} + 2 (a + b) M_i + b M_{i+1} = −(ϑ_right + ϑ_left) − (6 EI/Δ²) (slope of the chord behind i − slope before i)
//! ```
//!
//! for neighbouring spans of `a` and `b` intervals, with the end rotations `ϑ` of a [`Segment`](super::segment::Segment); moments count in `force · Δ`.
//! Then contact forces from the jumps of the shear force, deflections from the closed cubic of each interval.
//!
//! The matrix is strictly diagonally dominant, condition number at most 3 once scaled by its diagonal: no digits are lost to
//! it, whatever the number of supports. What it is applied to is the bend of the profile, and the profile is asked for that
//! bend itself ([`crate::scene::Foundation::bend`]): differences of rounded depths, divided by `Δ³`, would leave nothing of
//! the contact forces on a fine grid.
//!
//! A chain of links (`hencky.rs`) has the same equations with `a − 1/a` for `a`, `b − 1/b` for `b` and `1/a + 1/b` more in the
//! middle, and with curvatures at the nodes instead of the cubic.
//!
//! **A part is enough.** Of a moment at one support at most half arrives at the next (0.268 of it between equal spans), so
//! that what happens [`FAR`] supports away is less than a unit in the last place here. A part of the beam is solved as a
//! beam of its own, that begins and ends, free of moment, that many supports outside.

use std::ops::Range;

use super::segment::links;
use super::{Discrete, statics};
use crate::problem::NotPositiveDefinite;
use crate::state::Bending;

/// `2^−FAR` is less than half a unit in the last place.
const FAR: usize = 54;

/// Rounding of a clearance, in units in the last place of the numbers that it is a difference of: a profile is evaluated, a
/// chord drawn, sums of loads are taken in blocks.
const UNITS: f64 = 16.0;

/// Negative clearances below this share of their size are looked at twice.
const NEAR_ZERO: f64 = 1e-12;

/// Moments at the supports of a part of the beam.
pub(super) struct Continuous<'a> {
    discrete: &'a Discrete,
    bending: Bending,
    /// Nodes, the two ends of the part included.
    supports: Vec<usize>,
    /// Moments there \[force · Δ\]; zero at the two ends.
    moments: Vec<f64>,
}

/// Contact forces and clearances at the nodes of a range.
pub(super) struct Part {
    pub(super) contact_force: Vec<f64>,
    pub(super) clearance: Vec<f64>,
}

/// Contact forces and clearances at the nodes `nodes.start … nodes.end − 1`, interior nodes, of the beam that is held where
/// `touches` says so for node 1, 2, …
pub(super) fn part(
    discrete: &Discrete,
    bending: Bending,
    touches: &[bool],
    nodes: Range<usize>,
) -> Result<Part, NotPositiveDefinite> {
    let (beam, mut room) = Continuous::solve(discrete, bending, supports(touches, &nodes), nodes.len())?;
    room.clear();
    room.resize(nodes.len(), 0.0);
    let mut part = Part { contact_force: room, clearance: vec![0.0; nodes.len()] };
    beam.contact_forces(&nodes, &mut part.contact_force);
    beam.clearances(&nodes, &mut part.clearance);
    Ok(part)
}

/// The supports that decide what happens at some nodes: those between them, and [`FAR`] on both sides.
fn supports(touches: &[bool], nodes: &Range<usize>) -> Vec<usize> {
    let intervals = touches.len() + 1;
    // Node i is at index i − 1.
    let mut supports: Vec<usize> = before(&touches[..nodes.start - 1]).take(FAR).collect();
    if supports.len() < FAR {
        supports.push(0);
    }
    supports.reverse();
    supports.reserve_exact(touches[nodes.start - 1..nodes.end - 1].iter().filter(|touches| **touches).count() + FAR);
    supports.extend((nodes.start..nodes.end).filter(|&node| touches[node - 1]));
    let inside = supports.len();
    supports.extend(behind(&touches[nodes.end - 1..]).map(|k| nodes.end + k).take(FAR));
    if supports.len() < inside + FAR {
        supports.push(intervals);
    }
    supports
}

/// Flags that are looked at together where a long span has none.
const STRIDE: usize = 256;

/// Indices from 1 of the flags that are set, from the last to the first. Long stretches without any are skipped at once.
fn before(flags: &[bool]) -> impl Iterator<Item = usize> + '_ {
    let chunks = flags.rchunks(STRIDE).scan(flags.len(), |end, chunk| {
        *end -= chunk.len();
        Some((*end, chunk))
    });
    chunks
        .filter(|(_, chunk)| any(chunk))
        .flat_map(|(start, chunk)| (0..chunk.len()).rev().filter(|&k| chunk[k]).map(move |k| start + k + 1))
}

/// Indices from 0 of the flags that are set, from the first to the last.
fn behind(flags: &[bool]) -> impl Iterator<Item = usize> + '_ {
    let chunks = flags.chunks(STRIDE).enumerate().filter(|(_, chunk)| any(chunk));
    chunks.flat_map(|(c, chunk)| (0..chunk.len()).filter(|&k| chunk[k]).map(move |k| c * STRIDE + k))
}

/// Whether any of at most [`STRIDE`] flags is set: a comparison of blocks of memory, which processors are good at.
fn any(flags: &[bool]) -> bool {
    flags != &[false; STRIDE][..flags.len()]
}

impl<'a> Continuous<'a> {
    /// Elimination from left to right, substitution back. Memory that was used on the way comes back, with room for so many
    /// numbers.
    fn solve(
        discrete: &'a Discrete,
        bending: Bending,
        supports: Vec<usize>,
        room: usize,
    ) -> Result<(Self, Vec<f64>), NotPositiveDefinite> {
        let last = supports.len() - 1;
        let mut moments = vec![0.0; supports.len()];
        let mut passed = Vec::with_capacity(supports.len().max(room));
        passed.push(0.0);
        // Report: three-moments
        let unit = 6.0 * discrete.stiffness / (discrete.spacing * discrete.spacing);
        // From left to right: without M_{i−1}, row i says M_i = moments[i] − passed[i] M_{i+1}.
        let mut left = discrete.span(supports[0], supports[1]);
        for i in 1..last {
            let right = discrete.span(supports[i], supports[i + 1]);
            let (a, b) = (left.steps, right.steps);
            let [at_left, at_right] = [a, b].map(|steps| links(bending, steps));
            let bend = discrete.bend(supports[i - 1], supports[i], supports[i + 1]);
            let rest = -(left.rotations[1] + right.rotations[0]) - unit * bend - (a - at_left) * moments[i - 1];
            let pivot = 2.0 * (a + b) + (at_left + at_right) - (a - at_left) * passed[i - 1];
            if !(0.0 < pivot && rest.is_finite()) {
                return Err(NotPositiveDefinite { index: i - 1, pivot });
            }
            let inverse = 1.0 / pivot;
            moments[i] = rest * inverse;
            passed.push((b - at_right) * inverse);
            left = right;
        }
        // Back from right to left: the ends of the beam are free of moment.
        (1..last).rev().for_each(|i| moments[i] -= passed[i] * moments[i + 1]);
        // Report: end
        Ok((Self { discrete, bending, supports, moments }, passed))
    }

    /// Contact forces at the supports among `nodes`: the loads that go there, and the jump of the shear force.
    fn contact_forces(&self, nodes: &Range<usize>, forces: &mut [f64]) {
        let mut before = Left::default();
        for (pair, moments) in self.supports.windows(2).zip(self.moments.windows(2)) {
            let span = self.discrete.span(pair[0], pair[1]);
            let shear = moments[1] - moments[0];
            let shear = if pair[0] + 1 == pair[1] { shear } else { shear / span.steps };
            let left = Left { share: span.shares[1], shear, moments: [moments[0], moments[1]], steps: span.steps };
            if nodes.contains(&pair[0]) {
                forces[pair[0] - nodes.start] = before.force(&left, span.shares[0] + self.discrete.loads[pair[0]]);
            }
            before = left;
        }
        // The last support of a part is an end of the beam or far outside.
    }

    /// Clearances at those of `nodes` that are not supports; zero where they are negative by less than the rounding of what
    /// they are differences of.
    ///
    /// That is a local measure. Near a support of the beam, over ground that begins at its depth, all numbers are small, and
    /// by the measure of the whole beam the beam could hang free, or pass through the ground, over thousands of nodes.
    fn clearances(&self, nodes: &Range<usize>, clearance: &mut [f64]) {
        let mut curve = Curve::default();
        let Discrete { spacing, stiffness, .. } = *self.discrete;
        let unit = spacing * spacing * spacing / stiffness;
        // Hardly any clearance is negative by so little; for those it is worth to know how far they can be trusted.
        let small = NEAR_ZERO * self.discrete.sizes().x;
        for (i, pair) in self.supports.windows(2).enumerate() {
            let (first, last) = (pair[0], pair[1]);
            let wanted = nodes.start.max(first + 1)..nodes.end.min(last);
            if wanted.is_empty() {
                continue;
            }
            let ends = [self.moments[i], self.moments[i + 1]];
            let sags = &mut clearance[wanted.start - nodes.start..wanted.end - nodes.start];
            curve.of(self, first..last, ends, &wanted, sags);
            let [from, to] = [first, last].map(|node| self.discrete.support_depth(node));
            #[expect(clippy::cast_precision_loss, reason = "grids stay far below 2⁵³ nodes")]
            let steps = (last - first) as f64;
            // What the end moments bend: `M L²/EI`.
            let bent = unit * ends[0].abs().max(ends[1].abs()) * (steps * steps);
            // Clearances take the place of the sags.
            let depths = &self.discrete.depths[wanted.start - 1..];
            for ((node, h), depth) in wanted.zip(sags).zip(depths) {
                #[expect(clippy::cast_precision_loss, reason = "grids stay far below 2⁵³ nodes")]
                let chord = from + (to - from) * ((node - first) as f64 / steps);
                let open = (depth - chord) - *h;
                let doubtful = open < 0.0 && -small < open && is_rounding(self.discrete, node, open, bent);
                *h = if doubtful { 0.0 } else { open };
            }
        }
    }
}

/// What a span leaves at its right end.
#[derive(Default)]
pub(super) struct Left {
    /// A share of its loads, and a shear force.
    pub(super) share: f64,
    pub(super) shear: f64,
    /// Moments at its ends, and its length.
    pub(super) moments: [f64; 2],
    pub(super) steps: f64,
}

impl Left {
    /// The contact force between this span and the next one, for the load on the node with the share of the next span; zero
    /// where it is negative by less than the rounding of what it is a difference of.
    ///
    /// The jump of the shear force comes first. In dense contact it is a small difference of numbers with the same exponent,
    /// and exact; a load, or a share of the loads of a span, that is added to a shear force before would be rounded in the same
    /// way at each of a million nodes.
    #[inline]
    pub(super) fn force(&self, next: &Self, load: f64) -> f64 {
        let carried = self.share + load;
        let force = (next.shear - self.shear) + carried;
        let bent = |span: &Self| (span.moments[0].abs() + span.moments[1].abs()) / span.steps.max(1.0);
        let doubtful = force < 0.0 && -force <= UNITS * f64::EPSILON * (carried.abs() + bent(self) + bent(next));
        if doubtful { 0.0 } else { force }
    }
}

/// Whether a clearance can be the rounding of a depth, and of what the end moments of its span bend.
pub(super) fn is_rounding(discrete: &Discrete, node: usize, clearance: f64, bent: f64) -> bool {
    clearance.abs() <= UNITS * f64::EPSILON * (discrete.depth_rounding(node) + bent)
}

/// Deflections below the chord of a span, one span after the other in the same memory.
#[derive(Default)]
struct Curve {
    moments: Vec<f64>,
}

impl Curve {
    /// Sags at the `wanted` inner nodes of a span with the given end moments.
    fn of(
        &mut self,
        beam: &Continuous<'_>,
        span: Range<usize>,
        ends: [f64; 2],
        wanted: &Range<usize>,
        sags: &mut [f64],
    ) {
        let Continuous { discrete, bending, .. } = *beam;
        // The stretch around the wanted nodes, with the moments and sags at its two ends.
        let from = wanted.start - 1;
        let to = wanted.end;
        let cut = |node: usize| {
            let parts = [discrete.span(span.start, node), discrete.span(node, span.end)];
            parts[0].between(parts[1], discrete.loads[node], ends, bending)
        };
        let [from_moment, from_sag] = if from == span.start { [ends[0], 0.0] } else { cut(from) };
        let [to_moment, to_sag] = if to == span.end { [ends[1], 0.0] } else { cut(to) };

        let moments = [from_moment, to_moment];
        self.moments.resize(wanted.len(), 0.0);
        statics::funicular(&discrete.loads[wanted.clone()], moments, 1.0, &mut self.moments);
        // Mohr's analogy, in 6 EI / Δ³.
        statics::curvatures(&mut self.moments, moments, |m| match bending {
            Bending::AtNodes => 6.0 * m[1],
            Bending::Between => m[0] + 4.0 * m[1] + m[2],
        });
        let unit = discrete.spacing * discrete.spacing * discrete.spacing / (6.0 * discrete.stiffness);
        statics::funicular(&self.moments, [from_sag, to_sag], unit, sags);
    }
}
