//! Method 2, the displacement method: the potential energy is minimised, no node may penetrate, (17)–(24).
//!
//! Cubic (Hermite) elements between the nodes. The stiffness of one element of length `Δ` for the end deflections `v`
//! and rotations `θ = v'` in the order `(v_1, θ_1, v_2, θ_2)` is
//!
//! ```text
//!            ⎡ 12    6Δ   −12    6Δ  ⎤
//! EI/Δ³      ⎢ 6Δ    4Δ²  −6Δ    2Δ² ⎥
//!            ⎢−12   −6Δ    12   −6Δ  ⎥
//!            ⎣ 6Δ    2Δ²  −6Δ    4Δ² ⎦
//! ```
//!
//! Rotations carry no load and are eliminated: `K = K_vv − K_vθ K_θθ⁻¹ K_θv`, the condensed stiffness (20). Unknown is
//! the clearance `h = u − v`, `b = K u − q`, the gradient is the nodal contact force `p = q − K v`.

// Discrepancy: condensed-stiffness
//
// Equations (19)–(24) are lost. The text states that cubic shape functions are used, and that they are exact for loads and contact
// pressures that are point forces. So `K` of (20) is the stiffness of cubic elements with the rotations condensed, and the loads are
// nodal forces `q₀Δ`. The inverse of this `K` is the `C` of (26).

use nalgebra::{DMatrix, DVector};

use super::Discrete;
use crate::qp::{Band, Matrix, NotPositiveDefinite, Row};

/// `K` (20) of the paper's beam, shape (n, n): column `j` holds the nodal forces of a unit deflection of node `j`.
pub(super) fn matrix(discrete: &Discrete) -> Matrix {
    let (n, Discrete { spacing, stiffness, .. }) = (discrete.unknowns(), discrete);
    let factor = stiffness / spacing / spacing / spacing;
    let mut k = DMatrix::zeros(n, n);
    // Deflections of all nodes, the supports among them.
    let mut unit = vec![0.0; n + 2];
    for j in 0..n {
        unit[j + 1] = 1.0;
        // K_θθ is diagonally dominant whatever the deflection: there is no pivot to fail.
        let rotations = rotations(&unit).unwrap_or_else(|_| vec![f64::NAN; n + 2]);
        k.set_column(j, &DVector::from_vec(forces(factor, &unit, &rotations)));
        unit[j + 1] = 0.0;
    }
    // Symmetric up to rounding; whoever takes the matrix may rely on it.
    Matrix::Dense((&k + k.transpose()) * 0.5)
}

/// Nodal forces `K v` that hold the deflections `v_0 … v_{n+1}` with the rotations `φ_0 … φ_{n+1}`, `φ = Δ θ`, for `EI/Δ³`.
fn forces(factor: f64, v: &[f64], rotations: &[f64]) -> Vec<f64> {
    // Shear force in the element right of node i, from the first row of its stiffness: differences first.
    let elements = v.windows(2).zip(rotations.windows(2));
    let shears: Vec<f64> = elements.map(|(v, r)| factor * (12.0 * (v[0] - v[1]) + 6.0 * (r[0] + r[1]))).collect();
    shears.windows(2).map(|s| s[1] - s[0]).collect()
}

/// Rotations `φ = Δ θ` at all nodes for given deflections: no node carries a moment,
/// `φ_{i−1} + 4 φ_i + φ_{i+1} = 3 (v_{i+1} − v_{i−1})`, and half of that at the supports.
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
