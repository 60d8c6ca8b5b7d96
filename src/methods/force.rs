//! Method 3, the force method: the complementary energy is minimised, no contact may pull, (25)–(31).
//!
//! Unknown are the nodal contact forces `p`, the gradient is the clearance `h`:
//!
//! ```text
//! v = C t,  t = q − p                             (25), (27)
//! h = C p + u − C q,   so  A = C,  b = C q − u    (28)
//! ```
//!
//! `C` (26) is there for whoever wants a matrix. On a given set of contact nodes the beam is a continuous beam over
//! sinking supports, and Clapeyron's three-moment equations (1857) give the same answer in O(n) and without the condition
//! number of `C`, which grows like `n⁴`.

// Discrepancy: quadratic-programme
//
// Equations (29)–(32), among them the programme "minimise ½ xᵀA x − bᵀx, x ≥ 0", are lost. It is rebuilt from its
// gradient (33), its optimality conditions (34), (35) and from (28), which survive.

use nalgebra::DMatrix;

use super::{Discrete, statics};
use crate::problem::{Band, Matrix, NotPositiveDefinite, Programme, Sizes, Stationary};
use crate::state::Bending;

/// The programme (32) of method 3: `x = p` as nodal forces, `g = h`.
#[derive(Debug, Clone, Copy)]
pub struct Force<'a>(pub &'a Discrete);

/// Flexibility `c_ij`, (26): the deflection of node `i` under a unit force at node `j`, for `1 ≤ i, j ≤ n`.
#[must_use]
#[expect(clippy::cast_precision_loss, reason = "dense matrices end long before 2⁵³ nodes")]
pub fn flexibility(length: f64, stiffness: f64, n: usize, i: usize, j: usize) -> f64 {
    // (i, j, n, l) are those of (26), which is printed for i < j and holds for i = j as well.
    let (i, j, n, l) = (i.min(j) as f64, i.max(j) as f64, n as f64, length);
    let m = n + 1.0;
    l * l * l * (1.0 + n - j) * i * (2.0 * j * m - j * j - i * i) / (6.0 * stiffness * (m * m) * (m * m))
}

/// Part of the beam between two neighbouring supports, each a contact node or an end of the beam.
struct Span {
    /// Node at the left end, from 0 for the left support of the beam.
    first: usize,
    /// Node at the right end.
    last: usize,
    /// Bending moments of the span as a simple beam, at its nodes.
    moments: Vec<f64>,
    /// Forces of that simple beam on its two supports.
    reactions: [f64; 2],
    /// Its end rotations times `6 EI`, both positive for a sagging span.
    rotations: [f64; 2],
}

impl Span {
    /// The span as a simple beam under the nodal loads between its ends.
    fn new(first: usize, last: usize, loads: &[f64], spacing: f64) -> Self {
        let between = &loads[first + 1..last];
        let moments = statics::moments(between, spacing);
        // Mohr's analogy once more: end rotations are the reactions of the moment diagram, in steps of 6 EI/Δ.
        let angles: Vec<f64> = moments.windows(3).map(|m| spacing * (m[0] + 4.0 * m[1] + m[2])).collect();
        let steps = last - first;
        Self {
            first,
            last,
            reactions: lever(between, steps),
            rotations: end_rotations(&angles, &moments, steps, spacing),
            moments,
        }
    }
}

/// Shares of forces at the inner nodes of a span that go to its left and right end.
#[expect(clippy::cast_precision_loss, reason = "grids stay far below 2⁵³ nodes")]
fn lever(forces: &[f64], steps: usize) -> [f64; 2] {
    let right: f64 = forces.iter().enumerate().map(|(k, f)| f * ((k + 1) as f64 / steps as f64)).sum();
    let left: f64 = forces.iter().enumerate().map(|(k, f)| f * ((steps - k - 1) as f64 / steps as f64)).sum();
    [left, right]
}

/// `6 EI θ` at the two ends of a span: the shares of the inner angles, and what the first and last interval add.
fn end_rotations(angles: &[f64], moments: &[f64], steps: usize, spacing: f64) -> [f64; 2] {
    let [left, right] = lever(angles, steps);
    // Within the interval at an end, half of `Δ (2 M_0 + M_1)`; M_0 = 0 there.
    let (first, last) = (moments[1.min(steps)], moments[steps.saturating_sub(1)]);
    [left + spacing * first, right + spacing * last]
}

impl Force<'_> {
    /// Deflections inside a span from the moments at its ends and the depths of its ends.
    fn clearances(&self, span: &Span, ends: [f64; 2], at_ends: [f64; 2], clearance: &mut [f64]) {
        let steps = span.last - span.first;
        #[expect(clippy::cast_precision_loss, reason = "grids stay far below 2⁵³ nodes")]
        let blend = |from: f64, to: f64, k: usize| from + (to - from) * (k as f64 / steps as f64);
        let moments: Vec<f64> = span.moments.iter().enumerate().map(|(k, m)| m + blend(ends[0], ends[1], k)).collect();
        let sag = statics::deflections(&moments, self.0.spacing, self.0.stiffness, Bending::Between);
        for (k, sag) in sag.iter().enumerate().take(steps).skip(1) {
            let node = span.first + k;
            clearance[node - 1] = (self.0.depths[node - 1] - blend(at_ends[0], at_ends[1], k)) - sag;
        }
    }
}

impl Programme for Force<'_> {
    fn dimension(&self) -> usize {
        self.0.interior()
    }

    /// `C` (26), shape (n, n).
    fn matrix(&self) -> Matrix {
        let n = self.dimension();
        #[expect(clippy::cast_precision_loss, reason = "dense matrices end long before 2⁵³ nodes")]
        let length = self.0.spacing * (n + 1) as f64;
        Matrix::Dense(DMatrix::from_fn(n, n, |i, j| flexibility(length, self.0.stiffness, n, i + 1, j + 1)))
    }

    fn linear(&self) -> Vec<f64> {
        self.gradient(&vec![0.0; self.dimension()]).iter().map(|h| -h).collect()
    }

    fn gradient(&self, p: &[f64]) -> Vec<f64> {
        let forces: Vec<f64> = self.0.interior_loads().iter().zip(p).map(|(q, p)| q - p).collect();
        self.0.clearances(&self.0.deflection(&forces, Bending::Between))
    }

    /// A continuous beam on the free nodes: three-moment equations for the support moments,
    ///
    /// ```text
    /// L_{i−1} M_{i−1} + 2 (L_{i−1} + L_i) M_i + L_i M_{i+1}
    ///     = −6 EI (θ_right,i−1 + θ_left,i) − 6 EI ((u_{i+1} − u_i)/L_i − (u_i − u_{i−1})/L_{i−1})
    /// ```
    ///
    /// then contact forces from the jumps of the shear force, clearances from the closed cubic of each interval.
    fn stationary(&self, free: &[bool]) -> Result<Stationary, NotPositiveDefinite> {
        let Discrete { spacing, stiffness, loads, depths, intervals, .. } = self.0;
        let supports: Vec<usize> =
            std::iter::once(0).chain((1..*intervals).filter(|&i| free[i - 1])).chain([*intervals]).collect();
        let spans: Vec<Span> = supports.windows(2).map(|s| Span::new(s[0], s[1], loads, *spacing)).collect();
        let depth = |node: usize| if node == 0 || node == *intervals { 0.0 } else { depths[node - 1] };
        #[expect(clippy::cast_precision_loss, reason = "grids stay far below 2⁵³ nodes")]
        let length = |span: &Span| spacing * (span.last - span.first) as f64;
        let incline = |span: &Span| (depth(span.last) - depth(span.first)) / length(span);

        let unknown = supports.len() - 2;
        let mut band = Band::<2>::zeros(unknown);
        let mut inner = vec![0.0; unknown];
        for (row, pair) in spans.windows(2).enumerate() {
            let (left, right) = (&pair[0], &pair[1]);
            band.add(row, row, 2.0 * (length(left) + length(right)));
            if row + 1 < unknown {
                band.add(row, row + 1, length(right));
            }
            inner[row] = -(left.rotations[1] + right.rotations[0]) - 6.0 * stiffness * (incline(right) - incline(left));
        }
        band.solve(&mut [&mut inner])?;

        let mut x = vec![0.0; self.dimension()];
        let mut clearance = vec![0.0; self.dimension()];
        let moment = |support: usize| if support == 0 { 0.0 } else { inner.get(support - 1).copied().unwrap_or(0.0) };
        for (k, span) in spans.iter().enumerate() {
            let ends = [moment(k), moment(k + 1)];
            self.clearances(span, ends, [depth(span.first), depth(span.last)], &mut clearance);
            // Shear force of the end moments: it loads the left support and unloads the right one.
            let shear = (ends[1] - ends[0]) / length(span);
            if 0 < span.first {
                x[span.first - 1] += span.reactions[0] + shear;
            }
            if span.last < *intervals {
                x[span.last - 1] += span.reactions[1] - shear + loads[span.last];
            }
        }
        Ok(Stationary { x, gradient: clearance })
    }

    fn sizes(&self) -> Sizes {
        let Sizes { x, gradient } = self.0.sizes();
        Sizes { x: gradient, gradient: x }
    }
}
