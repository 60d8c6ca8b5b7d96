//! How closely a route has to agree with the exact answer, and why.

use palkki::certificate::CERTIFIED_RESIDUAL;
use palkki::methods::{Discrete, Method};
use palkki::route::Solver;
use palkki::scene::SceneError;
use palkki_evidence::paper::{INTERVALS, example};

use crate::report::numbers::power;

/// Digits of a direct solve: sixteen, of which sums and differences of moments take a few. The rest is margin.
const DIRECT: i8 = -10;

/// Tolerances of contact forces and reactions \[force\].
#[derive(Debug)]
pub(super) struct Tolerances {
    /// Largest row sum of the stiffness \[force / length\]: how much force a clearance is worth.
    pub(super) norm: f64,
    /// Power of ten of an answer that stopped on a residual: that of our check's threshold, at depth 1, times the norm.
    iterative: i8,
}

impl Tolerances {
    /// For the example on the paper's grid.
    pub(super) fn new() -> Result<Self, SceneError> {
        let discrete = Discrete::new(&example()?, INTERVALS)?;
        let matrix = Method::Displacement.programme(&discrete).matrix();
        let n = matrix.dimension();
        let row = |i: usize| (0..n).map(|j| matrix.entry(i, j).abs()).sum::<f64>();
        let norm = (0..n).map(row).fold(0.0, f64::max);
        // The next power of ten.
        let iterative = (-15..0).find(|&k| CERTIFIED_RESIDUAL * norm <= ten_to(k)).unwrap_or(0);
        Ok(Self { norm, iterative })
    }

    fn exponent(&self, solver: Solver) -> i8 {
        match solver {
            Solver::FourStep | Solver::ActiveSet => DIRECT,
            Solver::Nsor | Solver::Clarabel | Solver::Osqp => self.iterative,
        }
    }

    /// The tolerance.
    pub(super) fn of(&self, solver: Solver) -> f64 {
        ten_to(self.exponent(solver))
    }

    /// Digits behind the point that the tolerance promises.
    pub(super) fn places(&self, solver: Solver) -> usize {
        usize::try_from(-self.exponent(solver)).unwrap_or(0).saturating_sub(1)
    }

    /// `10⁻⁵`
    pub(super) fn printed(&self, solver: Solver) -> String {
        power(i32::from(self.exponent(solver)))
    }
}

/// `10ᵏ` for a negative `k`.
fn ten_to(exponent: i8) -> f64 {
    (exponent..0).fold(1.0, |value, _| value / 10.0)
}
