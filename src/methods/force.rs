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

use std::ops::Range;

use nalgebra::DMatrix;

use super::{Discrete, continuous, native};
use crate::problem::{Matrix, Native, NotPositiveDefinite, Programme, Sizes, Stationary};
use crate::state::Bending;

/// The programme (32) of method 3: `x = p` as nodal forces, `g = h`. With [`Bending::Between`] it is the paper's and dual to
/// method 2, with [`Bending::AtNodes`] that of a chain of links, dual to method 1.
#[derive(Debug, Clone, Copy)]
pub struct Force<'a> {
    /// The scene on its grid.
    pub discrete: &'a Discrete,
    /// How the beam bends between the nodes.
    pub bending: Bending,
}

/// Flexibility `c_ij`, (26): the deflection of node `i` under a unit force at node `j`, for `1 ≤ i, j ≤ n`.
#[must_use]
#[expect(clippy::cast_precision_loss, reason = "dense matrices end long before 2⁵³ nodes")]
pub fn flexibility(length: f64, stiffness: f64, n: usize, i: usize, j: usize) -> f64 {
    // (i, j, n, l) are those of (26), which is printed for i < j and holds for i = j as well.
    let (i, j, n, l) = (i.min(j) as f64, i.max(j) as f64, n as f64, length);
    let m = n + 1.0;
    l * l * l * (1.0 + n - j) * i * (2.0 * j * m - j * j - i * i) / (6.0 * stiffness * (m * m) * (m * m))
}

impl Programme for Force<'_> {
    fn dimension(&self) -> usize {
        self.discrete.interior()
    }

    /// `C` (26), shape (n, n); of a chain by statics, unit force by unit force.
    fn matrix(&self) -> Matrix {
        let (n, Discrete { spacing, stiffness, .. }) = (self.dimension(), self.discrete);
        if self.bending == Bending::AtNodes {
            let unit = |j: usize| (0..n).map(|i| f64::from(u8::from(i == j))).collect::<Vec<_>>();
            let columns: Vec<f64> = (0..n).flat_map(|j| self.discrete.deflection(&unit(j), self.bending)).collect();
            return Matrix::Dense(DMatrix::from_vec(n, n, columns));
        }
        #[expect(clippy::cast_precision_loss, reason = "dense matrices end long before 2⁵³ nodes")]
        let length = spacing * (n + 1) as f64;
        Matrix::Dense(DMatrix::from_fn(n, n, |i, j| flexibility(length, *stiffness, n, i + 1, j + 1)))
    }

    fn native(&self) -> Option<Native> {
        Some(native::complementary(self.discrete, self.bending, self.sizes()))
    }

    fn linear(&self) -> Vec<f64> {
        self.gradient(&vec![0.0; self.dimension()]).iter().map(|h| -h).collect()
    }

    fn gradient(&self, p: &[f64]) -> Vec<f64> {
        let forces: Vec<f64> = self.discrete.interior_loads().iter().zip(p).map(|(q, p)| q - p).collect();
        self.discrete.clearances(&self.discrete.deflection(&forces, self.bending))
    }

    /// A continuous beam on the free nodes: three-moment equations (`continuous.rs`), contact forces from the jumps of the
    /// shear force, clearances from the closed cubic of each interval.
    fn stationary(&self, free: &[bool]) -> Result<Stationary, NotPositiveDefinite> {
        self.stationary_near(free, 0..self.dimension())
    }

    /// Part of that beam: what is fifty supports away is not felt.
    fn stationary_near(&self, free: &[bool], range: Range<usize>) -> Result<Stationary, NotPositiveDefinite> {
        // Variable i is node i + 1.
        let part = continuous::part(self.discrete, self.bending, free, range.start + 1..range.end + 1)?;
        Ok(Stationary { x: part.contact_force, gradient: part.clearance })
    }

    fn has_neighbourhoods(&self) -> bool {
        true
    }

    /// What could be rounding is zero already.
    fn rounding(&self) -> f64 {
        0.0
    }

    fn sizes(&self) -> Sizes {
        let Sizes { x, gradient } = self.discrete.sizes();
        Sizes { x: gradient, gradient: x }
    }
}
