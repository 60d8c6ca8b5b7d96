//! The displacement method on a contact set: rotations of the held nodes (slope–deflection equations, Bendixen 1914).
//!
//! Where a node is held its deflection is known, and only its rotation is not. What lies between two held nodes, free nodes
//! under their loads, is condensed as (20) condenses rotations; exactly, since the beam between them is a simple beam with
//! end moments. With the end rotations `A`, `B` of a span of `L` intervals against its chord, in `6 EI/Δ²` and positive
//! where it sags, and `ϑ` those of the simple beam under the loads:
//!
//! ```text
//! M_left = (2 (A − ϑ_left) − (B − ϑ_right))/3L,     M_right = (2 (B − ϑ_right) − (A − ϑ_left))/3L
//! M_right of the span before = M_left of the span behind        at each held node; both zero at the ends of the beam
//! ```
//!
//! Unknown is by how much a node turns against the tangent `φ = 0` of a parabola through it and its two neighbours:
//!
//! ```text
//! A = φ_i − β_i b/(a + b),   B = −φ_i − β_i a/(a + b)       behind and before node i, with β = (6 EI/Δ²) bend
//! φ_{i−1}/a + 2 (1/a + 1/b) φ_i + φ_{i+1}/b = known
//! ```
//!
//! In dense contact all of these are as small as the moments are: slopes, which are much larger, do not appear. The matrix
//! is diagonally dominant by a factor of two, where the condition number of `K` grows like `n⁴`.

use super::held::Held;
use crate::problem::{Band, NotPositiveDefinite};

/// Moments at the held nodes, zero at the two ends \[force · Δ\].
pub(super) fn moments(held: &Held<'_>) -> Result<Vec<f64>, NotPositiveDefinite> {
    let count = held.count();
    let bends = held.bends();
    let mut rotations = vec![0.0; count];
    let mut band = Band::<2>::zeros(count);
    // 3 M at the ends of each span while no node turns, and what a moment is divided by.
    let mut fixed: Vec<([f64; 2], f64)> = Vec::with_capacity(count - 1);
    let mut lengths = held.spans().map(|span| span.steps).chain([0.0]);
    let (mut before, mut here) = (0.0, lengths.next().unwrap_or_default());
    for (i, (span, behind)) in held.spans().zip(lengths).enumerate() {
        let left = -bends[i] * (here / (before + here)) - span.rotations[0];
        let right = -bends[i + 1] * (here / (here + behind)) - span.rotations[1];
        let moments = [2.0 * left - right, 2.0 * right - left];
        let inverse = 1.0 / here;
        band.add(i, i, 2.0 * inverse);
        band.add(i + 1, i + 1, 2.0 * inverse);
        band.add(i, i + 1, inverse);
        rotations[i] -= moments[0] * inverse;
        rotations[i + 1] += moments[1] * inverse;
        fixed.push((moments, here));
        (before, here) = (here, behind);
    }
    band.solve(&mut [&mut rotations])?;
    // Both spans at a node have its moment; the shorter one has it with fewer lost digits.
    let mut moments = vec![0.0; count];
    for i in 1..count - 1 {
        let ((_, a), (_, b)) = (fixed[i - 1], fixed[i]);
        moments[i] = if a < b {
            (fixed[i - 1].0[1] - rotations[i - 1] - 2.0 * rotations[i]) / (3.0 * a)
        } else {
            (fixed[i].0[0] + 2.0 * rotations[i] + rotations[i + 1]) / (3.0 * b)
        };
    }
    Ok(moments)
}
