//! Statics of a simple beam under nodal forces: the "basic structure" to which the force method goes back.

use crate::state::Bending;

/// Intervals of a block of [`funicular`]: sums of so many numbers lose next to nothing, and a block stays in the nearest
/// cache.
const BLOCK: usize = 64;

/// Solves `−(y_{i−1} − 2 y_i + y_{i+1}) = f_i`, `i = 1 … n`, for given `y_0` and `y_{n+1}`: the polygon of a string under
/// forces. `f` has length n, `y` length n + 2 with its two ends set.
///
/// Summing forces to slopes and slopes to heights from one end to the other would round n times, and double summation turns
/// that into `n ε` of the largest height. So forces go to the ends of blocks by the law of the lever; the block ends are a
/// polygon with fewer nodes, found the same way; and within a block everything is small against its ends. Rounding is then
/// that of some hundred operations for any n, and near an end it is relative to the distance from that end.
pub(super) fn funicular(f: &[f64], y: &mut [f64]) {
    polygon(f, 1.0, y);
}

/// The same with a last interval of length `tail`, `0 < tail ≤ 1`; all others have length 1.
#[expect(clippy::cast_precision_loss, reason = "grids stay far below 2⁵³ nodes")]
fn polygon(f: &[f64], tail: f64, y: &mut [f64]) {
    let n = f.len();
    if n < BLOCK {
        return string(f, n as f64 + tail, y);
    }
    // Node b of the polygon of block ends is node b · BLOCK of this one.
    let unit = BLOCK as f64;
    let blocks = (n + 1).div_ceil(BLOCK);
    let last = (n - (blocks - 1) * BLOCK) as f64 + tail;
    let length = |b: usize| if b + 1 < blocks { unit } else { last };
    let inner = |b: usize| &f[b * BLOCK..n.min((b + 1) * BLOCK - 1)];
    let mut ends = vec![0.0; blocks - 1];
    for b in 0..blocks {
        let [left, right] = lever(inner(b), length(b));
        if 0 < b {
            ends[b - 1] += f[b * BLOCK - 1] + left;
        }
        if b + 1 < blocks {
            ends[b] += right;
        }
    }
    // Heights in the unit of the coarser polygon, so that its intervals have length 1 again.
    let mut heights = vec![0.0; blocks + 1];
    heights[0] = y[0] / unit;
    heights[blocks] = y[n + 1] / unit;
    polygon(&ends, last / unit, &mut heights);
    for b in 0..blocks {
        let (from, to) = (b * BLOCK, (n + 1).min((b + 1) * BLOCK));
        y[from] = heights[b] * unit;
        y[to] = heights[b + 1] * unit;
        string(inner(b), length(b), &mut y[from..=to]);
    }
}

/// A short polygon of the given length: forces to slopes, slopes to heights above the chord.
#[expect(clippy::cast_precision_loss, reason = "a block is short")]
fn string(f: &[f64], length: f64, y: &mut [f64]) {
    let (from, to) = (y[0], y[f.len() + 1]);
    let [mut slope, _] = lever(f, length);
    // A whole block has a power of two for its length, and loses nothing by a product instead of a quotient.
    let share = 1.0 / length;
    let mut height = 0.0;
    for (k, f) in f.iter().enumerate() {
        height += slope;
        slope -= f;
        let place = (k + 1) as f64;
        y[k + 1] = (from * ((length - place) * share) + to * (place * share)) + height;
    }
}

/// Shares of forces at 1, 2, 3 … that go to the ends of a simple beam of the given length.
#[expect(clippy::cast_precision_loss, reason = "a block is short")]
fn lever(f: &[f64], length: f64) -> [f64; 2] {
    let (mut left, mut right) = (0.0, 0.0);
    for (k, f) in f.iter().enumerate() {
        let place = (k + 1) as f64;
        left += f * (length - place);
        right += f * place;
    }
    [left / length, right / length]
}

/// Bending moments `M_0 … M_{n+1}` of a simple beam under the nodal forces `t_1 … t_n` \[force · length\].
pub(super) fn moments(forces: &[f64], spacing: f64) -> Vec<f64> {
    let mut moments = vec![0.0; forces.len() + 2];
    funicular(forces, &mut moments);
    moments.iter_mut().for_each(|m| *m *= spacing);
    moments
}

/// Deflections `v_0 … v_{n+1}` from bending moments at all nodes, with `v = 0` at both ends \[length\].
///
/// Mohr's analogy: `−(v_{i−1} − 2 v_i + v_{i+1})/Δ = Δ M_i / EI` for finite differences, and
/// `Δ (M_{i−1} + 4 M_i + M_{i+1}) / (6 EI)` for moments that are linear between the nodes.
pub(super) fn deflections(moments: &[f64], spacing: f64, stiffness: f64, bending: Bending) -> Vec<f64> {
    let unit = spacing * spacing / stiffness;
    let angle = |m: &[f64]| match bending {
        Bending::AtNodes => unit * m[1],
        Bending::Between => unit / 6.0 * (m[0] + 4.0 * m[1] + m[2]),
    };
    let angles: Vec<f64> = moments.windows(3).map(angle).collect();
    let mut deflections = vec![0.0; moments.len()];
    funicular(&angles, &mut deflections);
    deflections
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Uniform forces hang as a parabola `y_i = i (N − i) / 2`, whatever the number of blocks and the length of the last one.
    #[test]
    fn uniform_forces_hang_as_a_parabola() {
        for n in [1, 2, 62, 63, 64, 65, 127, 128, 4095, 4096, 5000, 300_000_u32] {
            let mut y = vec![0.0; n as usize + 2];
            funicular(&vec![1.0; n as usize], &mut y);
            for (i, y) in (0..).zip(&y) {
                let exact = 0.5 * f64::from(i) * f64::from(n + 1 - i);
                // Four units in the last place: the height of a block end, two shares of it, and the sum.
                assert!((y - exact).abs() <= 4.0 * f64::EPSILON * exact, "{y} instead of {exact} at {i} of {n}");
            }
        }
    }
}
