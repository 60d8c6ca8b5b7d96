//! Method 2, the displacement method: the potential energy is minimised and no node may penetrate the foundation, (17)–(24).
//!
//! The elements between the nodes are cubic (Hermite). The stiffness of an element of length `Δ` for the end deflections `v` and
//! rotations `θ = v'` in the order `(v_1, θ_1, v_2, θ_2)` is
//!
//! ```text
//!            ⎡ 12    6Δ   −12    6Δ  ⎤
//! EI/Δ³      ⎢ 6Δ    4Δ²  −6Δ    2Δ² ⎥
//!            ⎢−12   −6Δ    12   −6Δ  ⎥
//!            ⎣ 6Δ    2Δ²  −6Δ    4Δ² ⎦
//! ```
//!
//! Rotations carry no load and are eliminated: `K = K_vv − K_vθ K_θθ⁻¹ K_θv`, the condensed stiffness (20). The unknown is the
//! clearance `h = u − v`, `b = K u − q`, and the gradient is the nodal contact force `p = q − K v`.

// Discrepancy: condensed-stiffness
//
// By the text shape functions are cubic, and exact for point forces. So `K` of (20) is the stiffness of cubic elements with the
// rotations condensed, and the loads are nodal forces `q₀Δ`. The inverse of this `K` is the `C` of (26).

use nalgebra::{DMatrix, DVector};

use super::Discrete;
use crate::qp::{Band, Matrix, NotPositiveDefinite, Row};

/// `K` (20) of the paper's beam, shape (n, n). Column `j` contains the nodal forces for a unit deflection of node `j`.
pub(super) fn matrix(discrete: &Discrete) -> Matrix {
    let (n, Discrete { spacing, stiffness, .. }) = (discrete.unknowns(), discrete);
    let factor = stiffness / spacing / spacing / spacing;
    let mut k = DMatrix::zeros(n, n);
    // Deflections of all nodes, including the supports.
    let mut unit = vec![0.0; n + 2];
    for j in 0..n {
        unit[j + 1] = 1.0;
        // K_θθ is diagonally dominant for every deflection, so no pivot can fail.
        let rotations = rotations(&unit).unwrap_or_else(|_| vec![f64::NAN; n + 2]);
        k.set_column(j, &DVector::from_vec(forces(factor, &unit, &rotations)));
        unit[j + 1] = 0.0;
    }
    // Symmetric up to rounding; callers may rely on exact symmetry.
    Matrix::Dense((&k + k.transpose()) * 0.5)
}

/// Nodal forces `K v` for the deflections `v_0 … v_{n+1}` and the rotations `φ_0 … φ_{n+1}`, `φ = Δ θ`. The factor is `EI/Δ³`.
fn forces(factor: f64, v: &[f64], rotations: &[f64]) -> Vec<f64> {
    // Shear force in the element to the right of node i, from the first row of its stiffness. Differences are taken first.
    let elements = v.windows(2).zip(rotations.windows(2));
    let shears: Vec<f64> = elements.map(|(v, r)| factor * (12.0 * (v[0] - v[1]) + 6.0 * (r[0] + r[1]))).collect();
    shears.windows(2).map(|s| s[1] - s[0]).collect()
}

/// Rotations `φ = Δ θ` at all nodes for given deflections. No node carries a moment:
/// `φ_{i−1} + 4 φ_i + φ_{i+1} = 3 (v_{i+1} − v_{i−1})`, and half of this at the supports.
fn rotations(v: &[f64]) -> Result<Vec<f64>, NotPositiveDefinite> {
    let last = v.len() - 1;
    let mut equations = Band::with_capacity(v.len());
    for i in 0..=last {
        let diagonal = if i == 0 || i == last { 2.0 } else { 4.0 };
        let above = [if i == last { 0.0 } else { 1.0 }];
        let right = 3.0 * (v[(i + 1).min(last)] - v[i.saturating_sub(1)]);
        equations.push(Row { diagonal, above, right })?;
    }
    Ok(equations.solve())
}
