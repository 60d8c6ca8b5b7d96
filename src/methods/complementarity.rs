//! Method 1: the complementarity problem by finite differences, (4)–(16).
//!
//! Unknown is the clearance `h = u − v` at the interior nodes, the gradient is the contact pressure `p`:
//!
//! ```text
//! p = q − EI v''''         EI v_i'''' ≈ (EI/Δ⁴) (v_{i−2} − 4 v_{i−1} + 6 v_i − 4 v_{i+1} + v_{i+2})        (5)
//! A = (EI/Δ⁴) pentadiag(1, −4, 6, −4, 1),   b = A u − q,   p = A h − b
//! ```
//!
//! At the supports `v_0 = 0` and `v_0'' = 0`, that is `v_{−1} = −v_1` (8), which leaves 5 in the two corners of `A`.
//! At a built-in end half a cell has curvature, `v_0'' ≈ 2 (v_1 − v_0 − φ Δ)/Δ²`, which leaves 7 in the corner; at a free end none
//! has, which leaves 1 and 5 there. So `A` is a sum over the nodes where the beam can bend.
//! Pressures are forces per length here; a load `q_i` is the nodal load divided by `Δ`.

// Discrepancy: finite-difference-equations
//
// Equations (6)–(16), among them the difference scheme itself, are lost from the surviving copy of the paper.
// The scheme is rebuilt from (5), (7), (8) with central differences, the only second-order scheme on five nodes.
// It gives 1.191071 for the first contact force of the example with 30 intervals; the paper prints no number for this method.

use super::contact_set::{ContactSet, OnContacts};
use super::{Discrete, general, sparse};
use crate::qp::{FreeSet, Matrix, NotPositiveDefinite, Qp, Sizes, SparseForm, Stationary};
use crate::state::Discretisation;

/// Curvature sits at the nodes.
const FINITE: Discretisation = Discretisation::FiniteDifferences;

/// The quadratic program (32) of method 1: `x = h`, `g = p`.
#[derive(Debug, Clone, Copy)]
pub struct Complementarity<'a>(pub &'a Discrete);

impl Complementarity<'_> {
    /// `EI/Δ⁴`.
    fn factor(&self) -> f64 {
        let square = self.0.spacing * self.0.spacing;
        self.0.stiffness / square / square
    }

    /// `(Δ⁴ v'''')_i` with `v_0 = v_{n+1} = 0` and `v_0'' = v_{n+1}'' = 0`; indices from 0 at the first interior node.
    fn fourth_difference(v: &[f64], i: usize) -> f64 {
        let at = |k: usize| v.get(k).copied().unwrap_or(0.0);
        let left = |back: usize| i.checked_sub(back).map_or(0.0, at);
        let corners = usize::from(i == 0) + usize::from(i + 1 == v.len());
        // Pairs first: of a flat deflection nothing must remain.
        #[expect(clippy::cast_precision_loss, reason = "0, 1 or 2")]
        let corners = corners as f64;
        (left(2) - 4.0 * left(1)) + (6.0 - corners) * at(i) + (at(i + 2) - 4.0 * at(i + 1))
    }

    /// `p = q − EI v''''` (5), the contact pressure that belongs to a deflection.
    fn pressure(&self, v: &[f64]) -> Vec<f64> {
        let (factor, spacing) = (self.factor(), self.0.spacing);
        let loads = self.0.interior_loads();
        (0..v.len()).map(|i| loads[i] / spacing - factor * Self::fourth_difference(v, i)).collect()
    }
}

impl Qp for Complementarity<'_> {
    fn dimension(&self) -> usize {
        self.0.unknowns()
    }

    fn matrix(&self) -> Matrix {
        if !self.0.is_simple() {
            return general::pentadiagonal(
                &(general::matrix(self.0, general::contact_forces, FINITE) / self.0.spacing),
            );
        }
        let (n, factor) = (self.dimension(), self.factor());
        let mut rows = vec![[6.0 * factor, -4.0 * factor, factor]; n];
        rows[0][0] -= factor;
        rows[n - 1][0] -= factor;
        for (i, row) in rows.iter_mut().enumerate() {
            for (k, entry) in row.iter_mut().enumerate().skip(1) {
                if n <= i + k {
                    *entry = 0.0;
                }
            }
        }
        Matrix::Pentadiagonal(rows)
    }

    fn sparse(&self) -> Option<SparseForm> {
        Some(sparse::potential(self.0, FINITE, self.sizes()))
    }

    fn linear(&self) -> Vec<f64> {
        if !self.0.is_simple() {
            return self.gradient(&vec![0.0; self.dimension()]).iter().map(|p| -p).collect();
        }
        self.pressure(&self.0.depths).iter().map(|p| -p).collect()
    }

    fn gradient(&self, h: &[f64]) -> Vec<f64> {
        if !self.0.is_simple() {
            return general::contact_forces(self.0, h, FINITE).iter().map(|p| p / self.0.spacing).collect();
        }
        let v: Vec<f64> = self.0.depths.iter().zip(h).map(|(u, h)| u - h).collect();
        self.pressure(&v)
    }

    /// `EI v'''' = q` at the free nodes, with `v = u` at the others: a chain of links that touches there.
    fn stationary(&self, free: &FreeSet) -> Result<Stationary, NotPositiveDefinite> {
        let OnContacts { contact_force, clearance } = ContactSet::where_held(self.0, free).solve(self.0, FINITE)?;
        let [clearance, contact_force] = [clearance, contact_force].map(|values| self.0.without_supports(values));
        Ok(Stationary { x: clearance, gradient: contact_force.iter().map(|p| p / self.0.spacing).collect() })
    }

    fn make_definite(&self, free: &mut FreeSet) {
        self.0.hold(free, false, |i| self.0.node(i));
    }

    /// What could be rounding is zero already.
    fn rounding(&self) -> f64 {
        0.0
    }

    fn sizes(&self) -> Sizes {
        let Sizes { x, gradient } = self.0.sizes();
        Sizes { x, gradient: gradient / self.0.spacing }
    }
}
