//! Condition numbers of the matrices `A` of the three methods, for any number of intervals.
//!
//! All of them are functions of one matrix, `T = tridiag(−1, 2, −1)` of shape (n, n), whose eigenvalues are known:
//!
//! ```text
//! λ_k = 4 sin²(k π / 2N),   k = 1 … n
//! finite differences   A = (EI/Δ⁴) T²                         λ²
//! stiffness            K = (EI/Δ³) T (1 − T/6)⁻¹ T            λ² / (1 − λ/6)
//! flexibility          C = K⁻¹                                the inverse
//! ```
//!
//! All grow with `λ`, so that condition numbers are quotients of the first and the last.

use std::f64::consts::PI;

use super::Method;

impl Method {
    /// `cond A = ‖A‖ ‖A⁻¹‖` of its matrix in the Euclidean norm, on `intervals` equal intervals of any beam.
    #[must_use]
    #[expect(clippy::cast_precision_loss, reason = "grids stay far below 2⁵³ intervals")]
    pub fn condition(self, intervals: usize) -> f64 {
        let angle = 0.5 * PI / intervals as f64;
        let (sine, cosine) = (libm::sin(angle), libm::cos(angle));
        // sin(n π/2N) = cos(π/2N).
        let (least, largest) = (4.0 * sine * sine, 4.0 * cosine * cosine);
        let root = largest / least;
        match self {
            Self::Complementarity => root * root,
            Self::Displacement | Self::Force => root * root * (1.0 - least / 6.0) / (1.0 - largest / 6.0),
        }
    }
}
