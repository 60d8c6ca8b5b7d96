//! Statics of a simple beam under nodal forces, the basic structure of the force method.

/// Intervals in a block of [`funicular`]. Sums of this many numbers lose almost nothing, and a block stays in the fastest cache.
const BLOCK: usize = 64;

/// Positions of the nodes in a block, as floating-point numbers.
static PLACES: [f64; BLOCK] = {
    let mut places = [1.0; BLOCK];
    let mut k = 1;
    while k < BLOCK {
        places[k] = places[k - 1] + 1.0;
        k += 1;
    }
    places
};

/// Solves `−(y_{i−1} − 2 y_i + y_{i+1}) = f_i`, `i = 1 … n`, for given `y_0` and `y_{n+1}`: the polygon of a string under forces.
/// Writes `y_i` times `unit` to `y`, which has length n like `f`, without the two ends.
///
/// Summing forces to slopes and slopes to heights from one end to the other would round n times, which double summation turns into
/// `n ε` of the largest height. Here forces go to the ends of blocks by the lever rule. The block ends form a polygon with fewer
/// nodes, which is solved in the same way. Within a block all heights are small compared with those of its ends. The rounding is then
/// that of some hundred operations for any n, and near an end it is relative to the distance from that end.
#[inline]
#[expect(clippy::cast_precision_loss, reason = "a short polygon")]
pub(super) fn funicular(f: &[f64], ends: [f64; 2], unit: f64, y: &mut [f64]) {
    if f.len() < BLOCK {
        let length = f.len() as f64 + 1.0;
        return string(f, length, lever(f, length)[0], ends, unit, y);
    }
    polygon(f, 1.0, ends, unit, y);
}

/// The same with a last interval of length `tail`, `0 < tail ≤ 1`. All others have length 1.
#[expect(clippy::cast_precision_loss, reason = "grids stay far below 2⁵³ nodes")]
fn polygon(f: &[f64], tail: f64, ends: [f64; 2], unit: f64, y: &mut [f64]) {
    let n = f.len();
    if n < BLOCK {
        let length = n as f64 + tail;
        return string(f, length, lever(f, length)[0], ends, unit, y);
    }
    // Node b of the polygon of block ends is node b · BLOCK of this one. Its height is the last one of block b − 1.
    let size = BLOCK as f64;
    let blocks = (n + 1).div_ceil(BLOCK);
    let last = (n - (blocks - 1) * BLOCK) as f64 + tail;
    let length = |b: usize| if b + 1 < blocks { size } else { last };
    let inner = |b: usize| b * BLOCK..n.min((b + 1) * BLOCK - 1);
    let mut slopes = Vec::with_capacity(blocks);
    let mut forces = vec![0.0; blocks - 1];
    for b in 0..blocks {
        let [left, right] = lever(&f[inner(b)], length(b));
        slopes.push(left);
        if 0 < b {
            forces[b - 1] += f[b * BLOCK - 1] + left;
        }
        if b + 1 < blocks {
            forces[b] += right;
        }
    }
    // In units of the coarser polygon, so that its intervals have length 1 again.
    let mut heights = vec![0.0; blocks - 1];
    polygon(&forces, last / size, ends.map(|end| end / size), size, &mut heights);
    let mut from = ends[0];
    for (b, slope) in slopes.into_iter().enumerate() {
        let to = heights.get(b).copied().unwrap_or(ends[1]);
        string(&f[inner(b)], length(b), slope, [from, to], unit, &mut y[inner(b)]);
        if b + 1 < blocks {
            y[(b + 1) * BLOCK - 1] = to * unit;
        }
        from = to;
    }
}

/// A short polygon of the given length, which starts with the given slope above its chord: forces to slopes, slopes to heights.
#[inline]
fn string(f: &[f64], length: f64, mut slope: f64, ends: [f64; 2], unit: f64, y: &mut [f64]) {
    // The length of a whole block is a power of two, so that multiplying by its reciprocal is as exact as dividing.
    let share = 1.0 / length;
    // A separate loop for what depends on the node before. In the next loop no node depends on another, so that it vectorises.
    let mut height = 0.0;
    for (f, y) in f.iter().zip(y.iter_mut()) {
        height += slope;
        slope -= f;
        *y = height;
    }
    for (y, place) in y.iter_mut().zip(&PLACES) {
        *y = ((ends[0] * ((length - place) * share) + ends[1] * (place * share)) + *y) * unit;
    }
}

/// The shares of forces at 1, 2, 3 … at the ends of a simple beam of the given length, summed in independent lanes.
#[inline]
fn lever(f: &[f64], length: f64) -> [f64; 2] {
    /// The number of 64-bit numbers that common processors add at once.
    const LANES: usize = 4;
    let (mut left, mut right) = ([0.0; LANES], [0.0; LANES]);
    let (fours, rest) = f.as_chunks::<LANES>();
    let (places, last) = PLACES.as_chunks::<LANES>();
    for (f, places) in fours.iter().zip(places) {
        for k in 0..LANES {
            left[k] += f[k] * (length - places[k]);
            right[k] += f[k] * places[k];
        }
    }
    let tail = places.get(fours.len()).map_or(last, |places| places);
    for (k, (f, place)) in rest.iter().zip(tail).enumerate() {
        left[k] += f * (length - place);
        right[k] += f * place;
    }
    [left, right].map(|lanes| lanes.iter().sum::<f64>() / length)
}

/// Replaces moments by their contribution to curvature: `share` of each with its two neighbours. `ends` are the neighbours of the
/// first and the last moment.
pub(super) fn curvatures(moments: &mut [f64], ends: [f64; 2], share: impl Fn([f64; 3]) -> f64) {
    let mut before = ends[0];
    let mut rest = moments.iter_mut().peekable();
    while let Some(here) = rest.next() {
        let behind = rest.peek().map_or(ends[1], |behind| **behind);
        let moment = std::mem::replace(here, share([before, *here, behind]));
        before = moment;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Under uniform forces the string is a parabola, `y_i = i (N − i) / 2`, whatever the number of blocks and the length of the last
    /// one.
    #[test]
    fn uniform_forces_hang_as_a_parabola() {
        for n in [1, 2, 62, 63, 64, 65, 127, 128, 4095, 4096, 5000, 300_000_u32] {
            let mut y = vec![f64::NAN; n as usize];
            funicular(&vec![1.0; n as usize], [0.0; 2], 1.0, &mut y);
            for (i, y) in (1..).zip(&y) {
                let exact = 0.5 * f64::from(i) * f64::from(n + 1 - i);
                // Four units in the last place: the height of a block end, two shares of it, and the sum.
                assert!((y - exact).abs() <= 4.0 * f64::EPSILON * exact, "{y} instead of {exact} at {i} of {n}");
            }
        }
    }
}
