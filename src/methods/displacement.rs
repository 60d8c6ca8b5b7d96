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
// Equations (19)–(24) are lost. The text says that cubic shape functions are used, that they are exact when loads and
// contact pressure are point forces, and that the author is content with that: `K` of (20) is therefore the stiffness of
// cubic elements with the rotations condensed, and the loads are nodal forces `q₀Δ`, not work-equivalent forces and moments.
// The inverse of this `K` is the `C` of (26), which survives.

use nalgebra::DMatrix;

use super::contact_set::{ContactSet, OnContacts};
use super::{Discrete, general, sparse};
use crate::qp::{Band, FreeSet, Matrix, NotPositiveDefinite, Qp, Row, Sizes, SparseForm, Stationary};
use crate::state::Discretisation;

/// The quadratic program (32) of method 2: `x = h`, `g = p` as nodal forces.
#[derive(Debug, Clone, Copy)]
pub struct Displacement<'a>(pub &'a Discrete);

impl Displacement<'_> {
    /// Nodal forces `K v` that hold the deflections `v` with the rotations `φ_0 … φ_{n+1}`, `φ = Δ θ`.
    fn forces(&self, v: &[f64], rotations: &[f64]) -> Vec<f64> {
        let n = v.len();
        let factor = self.factor();
        let at = |i: usize| if i == 0 || i == n + 1 { 0.0 } else { v[i - 1] };
        // Shear force in the element behind node i, from the first row of its stiffness: differences first.
        let shear = |i: usize| factor * (12.0 * (at(i) - at(i + 1)) + 6.0 * (rotations[i] + rotations[i + 1]));
        let shears: Vec<f64> = (0..=n).map(shear).collect();
        shears.windows(2).map(|s| s[1] - s[0]).collect()
    }

    /// Rotations `φ = Δ θ` at all nodes for given deflections: no node carries a moment,
    /// `φ_{i−1} + 4 φ_i + φ_{i+1} = 3 (v_{i+1} − v_{i−1})`, and half of that at the supports.
    fn rotations(v: &[f64]) -> Result<Vec<f64>, NotPositiveDefinite> {
        let n = v.len();
        let at = |i: usize| if i == 0 || i == n + 1 { 0.0 } else { v[i - 1] };
        let mut equations = Band::with_capacity(n + 2);
        for i in 0..n + 2 {
            let diagonal = if i == 0 || i == n + 1 { 2.0 } else { 4.0 };
            let above = [if i == n + 1 { 0.0 } else { 1.0 }];
            let right = 3.0 * (at((i + 1).min(n + 1)) - at(i.saturating_sub(1)));
            equations.push(Row { diagonal, above, right })?;
        }
        Ok(equations.solve())
    }

    /// `EI/Δ³`.
    fn factor(&self) -> f64 {
        let Discrete { spacing, stiffness, .. } = self.0;
        stiffness / spacing / spacing / spacing
    }

    /// `p = q − K v`, the nodal contact forces that belong to a deflection.
    fn contact_forces(&self, v: &[f64], rotations: &[f64]) -> Vec<f64> {
        self.0.interior_loads().iter().zip(self.forces(v, rotations)).map(|(q, f)| q - f).collect()
    }
}

impl Qp for Displacement<'_> {
    fn dimension(&self) -> usize {
        self.0.unknowns()
    }

    /// `K` (20), shape (n, n): column `j` holds the nodal forces of a unit deflection of node `j`.
    fn matrix(&self) -> Matrix {
        if !self.0.is_simple() {
            return Matrix::Dense(general::matrix(self.0, general::contact_forces, Discretisation::BeamElements));
        }
        let n = self.dimension();
        let mut k = DMatrix::zeros(n, n);
        let mut unit = vec![0.0; n];
        for j in 0..n {
            unit[j] = 1.0;
            // K_θθ is diagonally dominant whatever the deflection: there is no pivot to fail.
            let rotations = Self::rotations(&unit).unwrap_or_else(|_| vec![f64::NAN; n + 2]);
            k.set_column(j, &nalgebra::DVector::from_vec(self.forces(&unit, &rotations)));
            unit[j] = 0.0;
        }
        // Symmetric up to rounding; whoever takes the matrix may rely on it.
        Matrix::Dense((&k + k.transpose()) * 0.5)
    }

    fn sparse(&self) -> Option<SparseForm> {
        Some(sparse::potential(self.0, Discretisation::BeamElements, self.sizes()))
    }

    fn linear(&self) -> Vec<f64> {
        self.gradient(&vec![0.0; self.dimension()]).iter().map(|p| -p).collect()
    }

    fn gradient(&self, h: &[f64]) -> Vec<f64> {
        if !self.0.is_simple() {
            return general::contact_forces(self.0, h, Discretisation::BeamElements);
        }
        let v: Vec<f64> = self.0.depths.iter().zip(h).map(|(u, h)| u - h).collect();
        Self::rotations(&v).map_or_else(|_| vec![f64::NAN; v.len()], |rotations| self.contact_forces(&v, &rotations))
    }

    /// `K v = q` at the free nodes, with `v = u` at the others: a beam that touches there.
    fn stationary(&self, free: &FreeSet) -> Result<Stationary, NotPositiveDefinite> {
        let OnContacts { contact_force, clearance } =
            ContactSet::where_held(self.0, free).solve(self.0, Discretisation::BeamElements)?;
        let [x, gradient] = [clearance, contact_force].map(|values| self.0.without_supports(values));
        Ok(Stationary { x, gradient })
    }

    fn make_definite(&self, free: &mut FreeSet) {
        self.0.hold(free, false, |i| self.0.node(i));
    }

    /// What could be rounding is zero already.
    fn rounding(&self) -> f64 {
        0.0
    }

    fn sizes(&self) -> Sizes {
        self.0.sizes()
    }
}
