//! Method 3, the force method: the complementary energy is minimised, no contact may pull, (25)–(31).
//!
//! Unknown are the nodal contact forces `p`, the gradient is the clearance `h`:
//!
//! ```text
//! v = C t,  t = q − p                             (25), (27)
//! h = C p + u − C q,   so  A = C,  b = C q − u    (28)
//! ```
//!
//! A beam that its supports do not hold has no `C`; its contact forces are in balance with the loads besides,
//!
//! ```text
//! minimise ½ pᵀC₀p − (C₀q − g)ᵀp,   p ≥ 0,   Σ p = W,   Σ x p = W x_W
//! ```
//!
//! with the flexibility `C₀` of the beam on any two more supports, and the two multipliers are its rigid motion.
//!
//! `C` (26) is there for whoever wants a matrix. On a given set of contacts the three-moment equations of `contact_set.rs`
//! give the same answer in O(n) and without the condition number of `C`, which grows like `n⁴`.

// Discrepancy: quadratic-program
//
// Equations (29)–(32), among them the quadratic program "minimise ½ xᵀA x − bᵀx, x ≥ 0", are lost. It is rebuilt from its
// gradient (33), its optimality conditions (34), (35) and from (28), which survive.

use nalgebra::DMatrix;

use super::contact_set::{ContactSet, OnContacts};
use super::{Discrete, general, sparse};
use crate::qp::{FreeSet, Matrix, NotPositiveDefinite, Qp, Sizes, SparseForm, Stationary};
use crate::state::Discretisation;

/// The quadratic program (32) of method 3: `x = p` as nodal forces, `g = h`.
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

impl Qp for Force<'_> {
    fn dimension(&self) -> usize {
        self.0.unknowns()
    }

    /// `C` (26), shape (n, n).
    fn matrix(&self) -> Matrix {
        if !self.0.is_simple() {
            return Matrix::Dense(general::matrix(self.0, general::clearances, Discretisation::BeamElements));
        }
        let (n, Discrete { spacing, stiffness, .. }) = (self.dimension(), self.0);
        #[expect(clippy::cast_precision_loss, reason = "dense matrices end long before 2⁵³ nodes")]
        let length = spacing * (n + 1) as f64;
        Matrix::Dense(DMatrix::from_fn(n, n, |i, j| flexibility(length, *stiffness, n, i + 1, j + 1)))
    }

    fn sparse(&self) -> Option<SparseForm> {
        Some(sparse::complementary(self.0, Discretisation::BeamElements, self.sizes()))
    }

    fn linear(&self) -> Vec<f64> {
        self.gradient(&vec![0.0; self.dimension()]).iter().map(|h| -h).collect()
    }

    fn gradient(&self, p: &[f64]) -> Vec<f64> {
        if !self.0.is_simple() {
            return general::clearances(self.0, p, Discretisation::BeamElements);
        }
        let forces: Vec<f64> = self.0.interior_loads().iter().zip(p).map(|(q, p)| q - p).collect();
        self.0.clearances(&self.0.deflection(&forces, Discretisation::BeamElements))
    }

    /// `h = 0` at the free nodes, with `p = 0` at the others: a beam that touches at the free nodes.
    fn stationary(&self, free: &FreeSet) -> Result<Stationary, NotPositiveDefinite> {
        let OnContacts { contact_force, clearance } =
            ContactSet::where_free(self.0, free).solve(self.0, Discretisation::BeamElements)?;
        let [x, gradient] = [contact_force, clearance].map(|values| self.0.without_supports(values));
        Ok(Stationary { x, gradient })
    }

    fn make_definite(&self, free: &mut FreeSet) {
        self.0.hold(free, true, |i| self.0.node(i));
    }

    fn without_matrix(&self) -> Option<&'static str> {
        (0 < self.0.supports().lacking()).then_some(general::NO_FLEXIBILITY)
    }

    /// What could be rounding is zero already.
    fn rounding(&self) -> f64 {
        0.0
    }

    fn sizes(&self) -> Sizes {
        let Sizes { x, gradient } = self.0.sizes();
        Sizes { x: gradient, gradient: x }
    }
}
