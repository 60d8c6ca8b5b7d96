//! Finite differences on a contact set: a chain of rigid links with springs in its joints (Hencky 1920), as a continuous beam.
//!
//! Central differences put all curvature at the nodes. The three-moment equations of that chain follow from those of the
//! beam, term by term, for spans of `a` and `b` intervals with moments in `force · Δ`:
//!
//! ```text
//! (a − 1/a) M_{i−1} + (2 (a + b) + 1/a + 1/b) M_i + (b − 1/b) M_{i+1} = −(ϑ_right + ϑ_left) − (6 EI/Δ²) bend_i
//! ```
//!
//! with the end rotations `ϑ` under the loads that the beam has: `6 Σ M_k φ_k` over inner nodes, with a polygon `M` that begins
//! and ends at zero and the linear `φ` that falls from 1 to 0, is `∫ 6 M φ` as well. For the end moments, which are not zero
//! there, sum and integral differ: `6 Σ φ² = 2a − 3 + 1/a` and `6 Σ φ (1 − φ) = a − 1/a`, and the curvature of the held
//! node itself adds 3 on both sides. In dense contact, `a = b = 1`, neighbours drop out, and what is left is the difference
//! equation itself, `M_i = −(EI/Δ²) bend_i`.
//!
//! The matrix is strictly diagonally dominant: with `A` the condition number grows like `n⁴`, here it is at most 3 once
//! scaled by its diagonal. Eliminating the moments would give back `A h = b` on the free nodes, (33).

use super::held::Held;
use crate::problem::{Band, NotPositiveDefinite};

/// Moments at the held nodes, zero at the two ends \[force · Δ\].
pub(super) fn moments(held: &Held<'_>) -> Result<Vec<f64>, NotPositiveDefinite> {
    let last = held.count() - 1;
    let mut moments: Vec<f64> = held.bends().iter().map(|bend| -bend).collect();
    let mut band = Band::<2>::zeros(held.count());
    for (i, span) in held.spans().enumerate() {
        let (steps, inverse) = (span.steps, 1.0 / span.steps);
        for end in 0..2 {
            band.add(i + end, i + end, 2.0 * steps + inverse);
            moments[i + end] -= span.rotations[end];
        }
        // The ends of the beam are free of moment.
        if 0 < i && i + 1 < last {
            band.add(i, i + 1, steps - inverse);
        }
    }
    (moments[0], moments[last]) = (0.0, 0.0);
    band.solve(&mut [&mut moments])?;
    Ok(moments)
}
