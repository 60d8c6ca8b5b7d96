//! Extremes of deflections and moments, at the nodes of a grid and between them.

use crate::state::{Discretisation, Extremes};

/// Nodes in a block. Most blocks of a fine grid are far from any extreme. A sum over one block has about as many terms as there are
/// blocks.
pub(super) const BLOCK: usize = 256;

/// Values at neighbouring nodes: at the inner ones and at the two ends.
#[derive(Debug, Clone, Copy)]
pub(super) struct Values<'a> {
    pub(super) inner: &'a [f64],
    pub(super) ends: [f64; 2],
}

impl Values<'_> {
    /// The value at node `i`, counted from the left end.
    fn at(&self, i: usize) -> f64 {
        if i == 0 { self.ends[0] } else { self.inner.get(i - 1).copied().unwrap_or(self.ends[1]) }
    }
}

/// Extremes of deflection and moment from nodal values. Positions count in intervals from the left end of the values. `stiffness` is
/// the smallest one. `bent_by` gives how moments at its near and far end bend an interval, relative to one with the smallest
/// stiffness; `most` is the largest such value.
pub(super) fn extremes(
    discretisation: Discretisation,
    deflection: Values<'_>,
    moments: Values<'_>,
    spacing: f64,
    (stiffness, most, bent_by): (f64, f64, impl Fn(usize) -> [f64; 2]),
) -> [Extremes; 2] {
    let seen = nodal_extremes(deflection);
    let found = match discretisation {
        Discretisation::FiniteDifferences => seen,
        Discretisation::BeamElements => {
            cubic_extremes(deflection, moments, (spacing * spacing / (6.0 * stiffness), most, bent_by), seen)
        }
    };
    [found, nodal_extremes(moments)]
}

/// Extremes of nodal values, with positions in intervals.
fn nodal_extremes(values: Values<'_>) -> Extremes {
    let [max, min] = values.ends.into_iter().fold(range(values.inner), |seen, end| wider(seen, [end; 2]));
    Extremes::at_known_values(max, min, |extreme, equal| near(values, extreme, equal))
}

/// Pairs of node and value. They include all values of each block with a value within `equal` of the extreme, and one value of every
/// other block.
fn near(values: Values<'_>, extreme: f64, equal: f64) -> impl Iterator<Item = (f64, f64)> + '_ {
    let blocks = values.inner.chunks(BLOCK).enumerate().flat_map(move |(b, block)| {
        let is_near = block.iter().fold(false, |near, value| near | ((value - extreme).abs() <= equal));
        numbered(b * BLOCK + 1, if is_near { block } else { &block[..1] })
    });
    let [left, right] = values.ends;
    std::iter::once((0.0, left)).chain(blocks).chain(std::iter::once((number(values.inner.len() + 1), right)))
}

/// Values from node `first` to the right, each with its node number as position.
fn numbered(first: usize, values: &[f64]) -> impl Iterator<Item = (f64, f64)> + '_ {
    values.iter().enumerate().map(move |(k, value)| (number(first + k), *value))
}

#[expect(clippy::cast_precision_loss, reason = "grids stay far below 2⁵³ nodes")]
fn number(node: usize) -> f64 {
    node as f64
}

/// The largest and the smallest of some values, which may be NaN. Each of the four lanes depends only on itself.
fn range(values: &[f64]) -> [f64; 2] {
    /// The number of 64-bit numbers that common processors add at once.
    const LANES: usize = 4;
    let (mut max, mut min) = ([f64::NEG_INFINITY; LANES], [f64::INFINITY; LANES]);
    let (all, rest) = values.as_chunks::<LANES>();
    for four in all {
        for k in 0..LANES {
            [max[k], min[k]] = wider([max[k], min[k]], [four[k]; 2]);
        }
    }
    let lanes = max.into_iter().zip(min).map(|(max, min)| [max, min]);
    lanes.chain(rest.iter().map(|value| [*value; 2])).reduce(wider).unwrap_or_default()
}

/// Unlike `f64::max` and `f64::min` this does not check for NaN, which is faster.
fn wider([max, min]: [f64; 2], [above, below]: [f64; 2]) -> [f64; 2] {
    [if max < above { above } else { max }, if below < min { below } else { min }]
}

/// Extremes of the deflection including the inside of intervals; `seen` are the extremes at the nodes, `unit` is `Δ²/6EI` of the
/// softest interval.
///
/// Intervals that cannot exceed the extremes at the nodes are skipped: a beam departs from its chord by at most `Δ² max|M| / 8 EI`.
fn cubic_extremes(
    deflection: Values<'_>,
    moments: Values<'_>,
    (unit, most, bent_by): (f64, f64, impl Fn(usize) -> [f64; 2]),
    seen: Extremes,
) -> Extremes {
    let reach = 0.75 * (unit * most);
    let beyond = |[highest, lowest]: [f64; 2], [most, least]: [f64; 2]| {
        let reach = reach * most.abs().max(least.abs());
        seen.max < highest + reach || lowest - reach < seen.min
    };
    let intervals = deflection.inner.len() + 1;
    let mut found = seen;
    for first in (0..intervals).step_by(BLOCK) {
        let end = intervals.min(first + BLOCK);
        let inner = first.max(1) - 1..end.min(intervals - 1);
        // `seen` also includes the ends of the beam.
        let of_block = |values: Values<'_>| {
            let ends = [values.at(first), values.at(end)].map(|value| [value; 2]);
            ends.into_iter().fold(range(&values.inner[inner.clone()]), wider)
        };
        if !beyond(of_block(deflection), of_block(moments)) {
            continue;
        }
        let mut left = [deflection, moments].map(|values| values.at(first));
        for k in first..end {
            let right = [deflection, moments].map(|values| values.at(k + 1));
            let [v, m] = [[left[0], right[0]], [left[1], right[1]]];
            if beyond([v[0].max(v[1]), v[0].min(v[1])], m) {
                let [own, other] = bent_by(k).map(|share| unit * share);
                let m = [own * m[0] + other * m[1], own * m[1] + other * m[0]];
                found = stationary(v, m).fold(found, |found, [s, v]| found.beyond(number(k) + s, v));
            }
            left = right;
        }
    }
    found
}

/// Stationary points inside an interval, `[s, v]` with `0 < s < 1`, for the deflections and `m = M Δ²/6EI` at its ends.
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

/// Extremes with positions counted from another node.
#[expect(clippy::cast_precision_loss, reason = "grids stay far below 2⁵³ nodes")]
pub(super) fn shifted(extremes: Extremes, by: usize) -> Extremes {
    Extremes { max_at: extremes.max_at + by as f64, min_at: extremes.min_at + by as f64, ..extremes }
}

#[cfg(test)]
mod tests {
    use super::{BLOCK, Values, nodal_extremes};
    use crate::state::Extremes;

    /// Plateaus within, across and at the ends of blocks, and equal peaks far apart.
    #[test]
    fn extremes_are_those_of_all_values_one_by_one() {
        let hill = |from: usize, to: usize, top: f64| {
            (1..=1000_usize).map(|i| if (from..=to).contains(&i) { top } else { 1e-3 * (i % 7) as f64 }).collect()
        };
        let mut cases: Vec<Vec<f64>> = vec![Vec::new(), vec![0.0; 3], vec![-1.0], vec![2.0; 2 * BLOCK]];
        for (from, to) in [(10, 10), (10, 20), (BLOCK, BLOCK), (BLOCK, BLOCK + 1), (200, 900), (1, 1000), (900, 1000)] {
            cases.extend([1.0, -1.0].map(|top| hill(from, to, top)));
        }
        let mut peaks: Vec<f64> = hill(3, 3, 1.0);
        peaks[700] = 1.0 + 1e-15;
        peaks[701] = 1.0;
        cases.push(peaks);
        for values in cases {
            let zero = std::iter::once(0.0);
            let all = zero.clone().chain(values.iter().copied()).chain(zero);
            let expected = Extremes::of((0_i32..).map(f64::from).zip(all).collect::<Vec<_>>());
            assert_eq!(nodal_extremes(Values { inner: &values, ends: [0.0; 2] }), expected, "{} values", values.len());
        }
    }
}
