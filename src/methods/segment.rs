//! Parts of the beam as simple beams under the loads on them, for spans of any length at the price of a short one.
//!
//! What the three-moment equations want to know of a span are four numbers: the shares of its loads that go to its ends, and
//! its end rotations. Two neighbours, of `a` and `b` intervals, that share a node with the load `q` make one span:
//!
//! ```text
//! F = right₁ + left₂ + q,    M = F a b/(a + b),    κ = (ϑ_right₁ + 2a M) + (ϑ_left₂ + 2b M)
//! left = left₁ + F b/(a + b),   ϑ_left = ϑ_left₁ + a M + κ b/(a + b),    and the mirror image on the right
//! ```
//!
//! with the moment `M` and the kink `κ` at the node between them. Under loads of one sign all terms have one sign: no
//! digits are lost, however many spans are joined. Lengths are counted in intervals, so moments have the unit `force · Δ`
//! and `ϑ = 6 EI θ / Δ²` has that of a force times an interval squared.

use crate::state::Bending;

/// Loads of a stretch of the beam, as its two ends feel them when it is a simple beam. Positive rotations sag.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct Segment {
    /// Number of intervals.
    pub(super) steps: f64,
    /// Shares of the loads between the ends that go to the left and to the right end \[force\].
    pub(super) shares: [f64; 2],
    /// End rotations `ϑ`.
    pub(super) rotations: [f64; 2],
}

impl Segment {
    /// One simple beam under the loads at its inner nodes.
    ///
    /// A force `f` with `a` intervals to its left and `b` to its right rotates the left end by `f b (L² − b²)/L`.
    #[expect(clippy::cast_precision_loss, reason = "grids stay far below 2⁵³ nodes")]
    fn of(inner: &[f64]) -> Self {
        let steps = (inner.len() + 1) as f64;
        let (mut shares, mut rotations) = ([0.0; 2], [0.0; 2]);
        for (k, f) in inner.iter().enumerate() {
            let a = (k + 1) as f64;
            let b = steps - a;
            let (to_left, to_right) = (f * b, f * a);
            shares[0] += to_left;
            shares[1] += to_right;
            // L² − b² = (L − b)(L + b) = a (L + b).
            rotations[0] += to_left * (a * (steps + b));
            rotations[1] += to_right * (b * (steps + a));
        }
        Self { steps, shares: shares.map(|s| s / steps), rotations: rotations.map(|r| r / steps) }
    }

    /// Two neighbours as one, with the load on the node between them.
    fn joined(self, next: Self, load: f64) -> Self {
        let (a, b) = (self.steps, next.steps);
        let steps = a + b;
        let (before, behind) = (a / steps, b / steps);
        let force = self.shares[1] + next.shares[0] + load;
        let moment = force * a * behind;
        let kink = (self.rotations[1] + 2.0 * a * moment) + (next.rotations[0] + 2.0 * b * moment);
        Self {
            steps,
            shares: [self.shares[0] + force * behind, next.shares[1] + force * before],
            rotations: [self.rotations[0] + a * moment + kink * behind, next.rotations[1] + b * moment + kink * before],
        }
    }

    /// Moment and deflection (in `6 EI / Δ³`, below the chord) between this part of a span and the next one, for given moments
    /// at the ends of both together.
    pub(super) fn between(self, next: Self, load: f64, ends: [f64; 2], bending: Bending) -> [f64; 2] {
        let (a, b) = (self.steps, next.steps);
        let (before, behind) = (a / (a + b), b / (a + b));
        let moment = (self.shares[1] + next.shares[0] + load) * a * behind + (ends[0] * behind + ends[1] * before);
        let kink = (self.rotations[1] + (a * (ends[0] + 2.0 * moment) + links(bending, a) * (moment - ends[0])))
            + (next.rotations[0] + (b * (ends[1] + 2.0 * moment) + links(bending, b) * (moment - ends[1])));
        [moment, kink * a * behind]
    }
}

/// `1/L` for a chain of links, zero for a beam: how sums over the nodes of a span of `L` intervals differ from integrals,
///
/// ```text
/// 6 Σ φ² + 3 = 2L + 1/L,   6 Σ φ (1 − φ) = L − 1/L        (beam: 2L and L)
/// ```
///
/// with the linear `φ` that falls from 1 to 0, over inner nodes; the held node at the end adds 3 on both sides.
pub(super) fn links(bending: Bending, steps: f64) -> f64 {
    if bending == Bending::AtNodes { 1.0 / steps } else { 0.0 }
}

/// Intervals of the shortest stored segment: a query adds at most twice as many loads one by one.
const LEAF: usize = 32;

/// Segments of `LEAF · 2^k` intervals, `k = 0, 1, …`, from which every span is put together: O(log n) for each.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Segments {
    levels: Vec<Vec<Segment>>,
}

impl Segments {
    /// The segments between the nodes that carry `loads`, the two ends of the beam included.
    pub(super) fn new(loads: &[f64]) -> Self {
        let leaves = (loads.len() - 1) / LEAF;
        let leaf = |k: usize| Segment::of(&loads[k * LEAF + 1..(k + 1) * LEAF]);
        let mut levels = vec![(0..leaves).map(leaf).collect::<Vec<_>>()];
        let mut reach = LEAF;
        while let Some(finer) = levels.last().filter(|finer| 2 <= finer.len()) {
            let pair = |(k, p): (usize, &[Segment])| p[0].joined(p[1], loads[(2 * k + 1) * reach]);
            levels.push(finer.chunks_exact(2).enumerate().map(pair).collect());
            reach *= 2;
        }
        Self { levels }
    }

    /// The beam between two nodes, `first < last`, as a simple beam.
    #[inline]
    pub(super) fn between(&self, loads: &[f64], first: usize, last: usize) -> Segment {
        // A single interval, which in dense contact most spans are.
        if last == first + 1 { Segment { steps: 1.0, ..Segment::default() } } else { self.long(loads, first, last) }
    }

    /// The same for spans with loads between their ends.
    fn long(&self, loads: &[f64], first: usize, last: usize) -> Segment {
        if last <= first + LEAF {
            return Segment::of(&loads[first + 1..last]);
        }
        let mut node = first.next_multiple_of(LEAF);
        let mut whole = (first < node).then(|| Segment::of(&loads[first + 1..node]));
        let mut join = |next: Segment, node: usize| {
            whole = Some(whole.map_or(next, |whole| whole.joined(next, loads[node])));
        };
        while node + LEAF <= last {
            let mut level = 0;
            while node.is_multiple_of(LEAF << (level + 1)) && node + (LEAF << (level + 1)) <= last {
                level += 1;
            }
            join(self.levels[level][node / (LEAF << level)], node);
            node += LEAF << level;
        }
        if node < last {
            join(Segment::of(&loads[node + 1..last]), node);
        }
        whole.unwrap_or_default()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A force of one on every node, and the end rotation `Σ b (L² − b²)/L` summed as whole numbers.
    #[test]
    fn joined_segments_are_one_span() {
        let loads = vec![1.0; 1001];
        let segments = Segments::new(&loads);
        for (first, last) in [(0, 1000), (0, 1), (31, 33), (5, 37), (5, 38), (32, 64), (1, 999), (500, 900), (63, 513)]
        {
            let found = segments.between(&loads, first, last);
            let steps = i64::try_from(last - first).expect("small");
            let rotation: i64 = (1..steps).map(|b| b * (steps * steps - b * b)).sum();
            #[expect(clippy::cast_precision_loss, reason = "whole numbers below 2⁵³")]
            let (share, rotation) = (0.5 * (steps - 1) as f64, rotation as f64 / steps as f64);
            for side in 0..2 {
                // A dozen joins, each with a few roundings of terms of one sign.
                let close = |x: f64, y: f64| (x - y).abs() <= 32.0 * f64::EPSILON * y;
                assert!(close(found.shares[side], share), "{found:?}: {share} from {first} to {last}");
                assert!(close(found.rotations[side], rotation), "{found:?}: {rotation} from {first} to {last}");
            }
        }
    }
}
