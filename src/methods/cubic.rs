//! Extremes of a deflection that is cubic between the nodes.

use super::ranges::{BLOCK, Ranges};
use crate::state::Extremes;

/// Extremes of the deflection, `seen` at the nodes already, with those inside the intervals; places are counted in intervals,
/// `unit` is `Δ²/6EI`.
///
/// Intervals that cannot reach beyond what is seen at the nodes are passed over: a beam leaves its chord by at most
/// `Δ² max|M| / 8 EI`.
pub(super) fn extremes(deflection: &Ranges<'_>, moments: &Ranges<'_>, unit: f64, seen: Extremes) -> Extremes {
    let beyond = |heights: [f64; 2], moment: f64| {
        let reach = 0.75 * unit * moment;
        seen.max < heights[0] + reach || heights[1] - reach < seen.min
    };
    let intervals = deflection.values().len() + 1;
    let mut found = seen;
    for first in (0..intervals).step_by(BLOCK) {
        // The intervals from node `first` on have their right ends in one block, but for the last one of the beam.
        let end = intervals.min(first + BLOCK);
        let (mut heights, mut moment) = ([deflection.at(first), deflection.at(first)], moments.at(first).abs());
        if let (Some([max, min]), Some([most, least])) = (deflection.block(first / BLOCK), moments.block(first / BLOCK))
        {
            heights = [heights[0].max(max), heights[1].min(min)];
            moment = moment.max(most.abs()).max(least.abs());
        }
        if end == intervals {
            heights = [heights[0].max(0.0), heights[1].min(0.0)];
        }
        if !beyond(heights, moment) {
            continue;
        }
        for k in first..end {
            let (v, m) = ([deflection.at(k), deflection.at(k + 1)], [moments.at(k), moments.at(k + 1)]);
            if beyond([v[0].max(v[1]), v[0].min(v[1])], m[0].abs().max(m[1].abs())) {
                found = stationary(v, m.map(|m| unit * m)).fold(found, |found, [s, v]| found.beyond(number(k) + s, v));
            }
        }
    }
    found
}

#[expect(clippy::cast_precision_loss, reason = "grids stay far below 2⁵³ nodes")]
fn number(k: usize) -> f64 {
    k as f64
}

/// Stationary points inside an interval, `[s, v]` with `0 < s < 1`, for deflections and `m = M Δ²/6EI` at its ends.
///
/// ```text
/// v = v₀ r + v₁ s + m₀ r (1 − r²) + m₁ s (1 − s²),   v' = v₁ − v₀ − m₀ (1 − 3 r²) + m₁ (1 − 3 s²),    r = 1 − s
/// ```
fn stationary([v0, v1]: [f64; 2], [m0, m1]: [f64; 2]) -> impl Iterator<Item = [f64; 2]> {
    let roots = quadratic_roots(3.0 * (m0 - m1), -6.0 * m0, v1 - v0 + 2.0 * m0 + m1);
    roots.into_iter().flatten().filter(|s| 0.0 < *s && *s < 1.0).map(move |s| {
        let r = 1.0 - s;
        [s, v0 * r + v1 * s + m0 * r * (1.0 - r * r) + m1 * s * (1.0 - s * s)]
    })
}

/// Real roots of `a s² + b s + c`, without cancellation.
fn quadratic_roots(a: f64, b: f64, c: f64) -> [Option<f64>; 2] {
    let discriminant = b * b - 4.0 * a * c;
    if discriminant.is_nan() || discriminant < 0.0 {
        return [None, None];
    }
    let q = -0.5 * (b + discriminant.sqrt().copysign(b));
    let finite = |root: f64| root.is_finite().then_some(root);
    [finite(q / a), finite(c / q)]
}
