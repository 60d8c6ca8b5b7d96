//! Statics of a simple beam under nodal forces: the "basic structure" to which the force method goes back.

use crate::state::Bending;

/// Solves `−(y_{i−1} − 2 y_i + y_{i+1}) / Δ = f_i` with `y = 0` at both ends.
///
/// `forces` holds `f_1 … f_n` at interior nodes, the result `y_0 … y_{n+1}`. With forces it gives bending moments, with
/// angles (Mohr's analogy) deflections.
#[expect(clippy::cast_precision_loss, reason = "grids stay far below 2⁵³ nodes")]
pub(super) fn funicular(forces: impl ExactSizeIterator<Item = f64> + Clone, spacing: f64) -> Vec<f64> {
    let n = forces.len();
    let intervals = (n + 1) as f64;
    // The slope of the first interval is the reaction at the left end: Σ f_i (N − i) / N.
    let mut slope: f64 = forces.clone().enumerate().map(|(i, f)| f * ((n - i) as f64 / intervals)).sum();
    let mut y = Vec::with_capacity(n + 2);
    let mut height = 0.0;
    y.push(height);
    for f in forces {
        height += slope * spacing;
        y.push(height);
        slope -= f;
    }
    y.push(0.0);
    y
}

/// Bending moments `M_0 … M_{n+1}` of a simple beam under the nodal forces `t_1 … t_n` \[force · length\].
pub(super) fn moments(forces: &[f64], spacing: f64) -> Vec<f64> {
    funicular(forces.iter().copied(), spacing)
}

/// Deflections `v_0 … v_{n+1}` from bending moments at all nodes, with `v = 0` at both ends \[length\].
///
/// Mohr's analogy: `−(v_{i−1} − 2 v_i + v_{i+1})/Δ = Δ M_i / EI` for finite differences, and
/// `Δ (M_{i−1} + 4 M_i + M_{i+1}) / (6 EI)` for moments that are linear between the nodes.
pub(super) fn deflections(moments: &[f64], spacing: f64, stiffness: f64, bending: Bending) -> Vec<f64> {
    let angles = moments.windows(3).map(|m| match bending {
        Bending::AtNodes => spacing / stiffness * m[1],
        Bending::Between => spacing / (6.0 * stiffness) * (m[0] + 4.0 * m[1] + m[2]),
    });
    funicular(angles, spacing)
}
