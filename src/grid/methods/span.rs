//! A stretch of the beam between two contacts, treated as a simple beam under its loads.
//!
//! Four numbers of a span enter the three-moment equations: the shares of its loads at its two ends, and its two end rotations. Two
//! neighbours of `a` and `b` intervals that share a node with the load `q` form one span:
//!
//! ```text
//! F = right₁ + left₂ + q,    M = F a b/(a + b),    κ = (ϑ_right₁ + 2a M) + (ϑ_left₂ + 2b M)
//! left = left₁ + F b/(a + b),   ϑ_left = ϑ_left₁ + a M + κ b/(a + b),    and the mirror image on the right
//! ```
//!
//! with the moment `M` and the kink `κ` at the node between them. Under loads of one sign all terms have one sign, so no digits are
//! lost, however many spans are joined. Lengths count in intervals. Moments therefore have the unit `force · Δ`, and
//! `ϑ = 6 EI θ / Δ²` is a force times an interval squared.

use crate::state::Discretisation;

/// The effect of the loads of a span on its ends, as of a simple beam. Positive rotations sag.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct Span {
    /// Number of intervals, and the softness of each of them, `e = EI₀/EI`.
    pub(crate) steps: f64,
    pub(crate) soft: f64,
    /// Shares of the loads between the ends that the left and the right end carry \[force\].
    pub(crate) shares: [f64; 2],
    /// End rotations `ϑ`, in a unit based on the least bending stiffness.
    pub(crate) rotations: [f64; 2],
}

impl Span {
    /// A single interval, which carries no load between its ends.
    pub(crate) const INTERVAL: Self = Self { steps: 1.0, soft: 1.0, shares: [0.0; 2], rotations: [0.0; 2] };

    /// Number of loads up to which they are summed one by one. Longer spans are joined from halves, so that rounding grows with the
    /// logarithm of the length.
    const SHORT: usize = 32;

    /// One simple beam under the loads at its inner nodes.
    pub(crate) fn under(inner: &[f64]) -> Self {
        if inner.len() < Self::SHORT {
            return Self::summed(inner);
        }
        let middle = inner.len() / 2;
        Self::under(&inner[..middle]).joined(Self::under(&inner[middle + 1..]), inner[middle])
    }

    /// A force `f` with `a` intervals to its left and `b` to its right rotates the left end by `f b (L² − b²)/L`.
    #[expect(clippy::cast_precision_loss, reason = "grids stay far below 2⁵³ nodes")]
    pub(crate) fn summed(inner: &[f64]) -> Self {
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
        Self { steps, soft: 1.0, shares: shares.map(|s| s / steps), rotations: rotations.map(|r| r / steps) }
    }

    /// Two neighbours as one span, with the load on the node between them.
    pub(crate) fn joined(self, next: Self, load: f64) -> Self {
        let (a, b) = (self.steps, next.steps);
        let steps = a + b;
        let (left, right) = (a / steps, b / steps);
        let force = self.shares[1] + next.shares[0] + load;
        let moment = force * a * right;
        let kink = (self.rotations[1] + 2.0 * a * moment) + (next.rotations[0] + 2.0 * b * moment);
        Self {
            steps,
            soft: self.soft,
            shares: [self.shares[0] + force * right, next.shares[1] + force * left],
            rotations: [self.rotations[0] + a * moment + kink * right, next.rotations[1] + b * moment + kink * left],
        }
    }

    /// Moment and sag (in `6 EI / Δ³`, below the chord) between this part of a span and the next one, for given moments at the ends
    /// of the whole.
    pub(super) fn between(self, next: Self, load: f64, ends: [f64; 2], discretisation: Discretisation) -> [f64; 2] {
        let (a, b) = (self.steps, next.steps);
        let (left, right) = (a / (a + b), b / (a + b));
        let moment = (self.shares[1] + next.shares[0] + load) * a * right + (ends[0] * right + ends[1] * left);
        let bent = |steps: f64, end: f64| {
            self.soft * (steps * (end + 2.0 * moment) + links(discretisation, steps) * (moment - end))
        };
        let kink = (self.rotations[1] + bent(a, ends[0])) + (next.rotations[0] + bent(b, ends[1]));
        [moment, kink * a * right]
    }

    /// The same span with intervals of relative softness `e`.
    #[inline]
    pub(super) fn softened(self, e: f64) -> Self {
        Self { soft: e, rotations: self.rotations.map(|rotation| e * rotation), ..self }
    }

    /// The rotations of an end by a unit moment there and by one at the other end: `2L` and `L` of a beam, and those of a chain of
    /// [`links`].
    pub(super) fn end_rotations(&self, discretisation: Discretisation) -> [f64; 2] {
        let links = links(discretisation, self.steps);
        [self.soft * (2.0 * self.steps + links), self.soft * (self.steps - links)]
    }
}

/// `1/L` for a chain of links, zero for a beam: the difference between sums over the nodes of a span of `L` intervals and integrals,
///
/// ```text
/// 6 Σ φ² + 3 = 2L + 1/L,   6 Σ φ (1 − φ) = L − 1/L        (beam: 2L and L)
/// ```
///
/// with the linear `φ` that falls from 1 to 0, summed over inner nodes. The held node at the end adds 3 on both sides. Also zero if
/// the span has length zero.
pub(super) fn links(discretisation: Discretisation, steps: f64) -> f64 {
    match discretisation {
        _ if steps == 0.0 => 0.0,
        Discretisation::FiniteDifferences => 1.0 / steps,
        Discretisation::BeamElements => 0.0,
    }
}

#[cfg(test)]
mod tests {
    use super::Span;

    /// A unit force on every node, and the end rotation `Σ b (L² − b²)/L` summed in integers.
    #[test]
    fn joined_spans_are_one_span() {
        for steps in [1, 2, 32, 33, 34, 67, 100, 1000_u32] {
            let span = Span::under(&vec![1.0; steps as usize - 1]);
            let length = i64::from(steps);
            let rotation: i64 = (1..length).map(|b| b * (length * length - b * b)).sum();
            #[expect(clippy::cast_precision_loss, reason = "whole numbers below 2⁵³")]
            let (share, rotation) = (0.5 * f64::from(steps - 1), rotation as f64 / f64::from(steps));
            for side in 0..2 {
                // A dozen joins, each with a few roundings of terms of one sign.
                let close = |x: f64, y: f64| (x - y).abs() <= 32.0 * f64::EPSILON * y;
                assert!(close(span.shares[side], share), "{span:?}: {share} on {steps} intervals");
                assert!(close(span.rotations[side], rotation), "{span:?}: {rotation} on {steps} intervals");
            }
        }
    }
}
