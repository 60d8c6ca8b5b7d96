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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::methods::Method;
    use crate::paper::uneven::{Unevenness, scenes};
    use crate::verification::Random;

    /// Of the sizes: systems of condition number 3, and the end of what is felt from far away.
    const ROUNDED: f64 = 1e-11;

    /// Methods 1 and 2 on the same contact set by equations of their own, and parts of them.
    #[test]
    fn the_dual_has_the_same_points() {
        let mut random = Random::new(4);
        for scene in Unevenness::ALL.into_iter().flat_map(|kind| scenes(kind, 3, 7).expect("scenes")) {
            let scaled = scene.scaled().expect("in range");
            let discrete = Discrete::new(&scaled.scene, 400).expect("a grid");
            for method in [Method::Complementarity, Method::Displacement] {
                let own = method.programme(&discrete);
                let dual = own.dual().expect("method 3");
                let unit = if method == Method::Complementarity { discrete.spacing } else { 1.0 };
                for share in [2, 5, 40] {
                    let touching: Vec<bool> = (0..own.dimension()).map(|_| random.once_in(share)).collect();
                    let free: Vec<bool> = touching.iter().map(|touches| !touches).collect();
                    let point = own.stationary(&free).expect("definite");
                    let Sizes { x: depth, gradient: force } = discrete.sizes();
                    for range in [0..own.dimension(), 120..190, 300..301] {
                        let near = dual.stationary_near(&touching, range.clone()).expect("definite");
                        for (k, i) in range.enumerate() {
                            // Held at random places the beam carries more than its load.
                            let scale = 1.0 + point.gradient[i].abs() * unit / force + point.x[i].abs() / depth;
                            let apart = ((near.x[k] - point.gradient[i] * unit) / force)
                                .abs()
                                .max(((near.gradient[k] - point.x[i]) / depth).abs());
                            assert!(apart <= ROUNDED * scale, "{method}, node {}: {apart:.1e} of {scale:.1e}", i + 1);
                        }
                    }
                }
            }
        }
    }

    /// `A⁻¹` of method 1, up to the unit of its pressures.
    #[test]
    fn the_chain_has_the_inverse_matrix() {
        let scene = crate::paper::example().expect("well posed");
        let discrete = Discrete::new(&scene, 12).expect("a grid");
        let own = Method::Complementarity.programme(&discrete);
        let (a, c) = (own.matrix(), own.dual().expect("method 3").matrix());
        for i in 0..own.dimension() {
            for j in 0..own.dimension() {
                let column: Vec<f64> = (0..own.dimension()).map(|k| a.entry(k, j) * discrete.spacing).collect();
                let expected = f64::from(u8::from(i == j));
                assert!((c.row_times(i, &column) - expected).abs() < ROUNDED, "row {i}, column {j}");
            }
        }
    }
}
