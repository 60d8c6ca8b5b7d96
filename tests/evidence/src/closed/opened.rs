//! The gap that a couple or a change of EI opens in a zone, of a beam that is rigid in shear.
//!
//! ```text
//! m = M + EI g''   zero in contact, m'' = −p̄ over the gap, rises by D at the discontinuity;  h'' = m/EI for the clearance h
//! t = x/ℓ          m = p̄ ℓ² ((t − t²)/2 − δ (t − [β < t])),   δ = D/(p̄ ℓ²),   zero at both ends
//! h = h' = 0 at both ends:   ∫ w m dt = 0,   ∫ w m t dt = 0,   w = 1 before β and r behind it,   r = EI₁/EI₂
//! ```
//!
//! For `r = 1`, which a couple has: `β = (3 + √3)/6 = 0.7887` and `ℓ = √(2√3 D/p̄)`.

use super::bisected;

/// The gap at a discontinuity `D` under a pressure `p̄`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Opened {
    /// `β`, the part of the gap before the discontinuity.
    pub before: f64,
    /// `p̄ ℓ²/D`.
    pub square: f64,
}

/// For the bending stiffness before the discontinuity over that behind it; positive `D`, as of a positive couple.
#[must_use]
pub fn opened(ratio: f64) -> Opened {
    let integrals = |b: f64| {
        let (b2, b3, rest) = (b * b, b * b * b, 1.0 - ratio);
        let bending = [rest * (b2 / 4.0 - b3 / 6.0) + ratio / 12.0, rest * (b3 / 6.0 - b3 * b / 8.0) + ratio / 24.0];
        let jump = [0.5 * (b2 - ratio * (1.0 - b) * (1.0 - b)), b3 / 3.0 - ratio * (1.0 / 6.0 + b3 / 3.0 - b2 / 2.0)];
        (bending, jump)
    };
    // Between the root of `∫ w (t − [β < t]) dt`, below which the discontinuity would have the other sign, and 1.
    let least = ratio.sqrt() / (1.0 + ratio.sqrt());
    let before = bisected(least, 1.0, |b| {
        let (bending, jump) = integrals(b);
        jump[1] * bending[0] - jump[0] * bending[1]
    });
    let (bending, jump) = integrals(before);
    Opened { before, square: jump[0] / bending[0] }
}

impl Opened {
    /// The length of the gap \[length\].
    #[must_use]
    pub fn length(&self, discontinuity: f64, pressure: f64) -> f64 {
        (self.square * discontinuity / pressure).sqrt()
    }
}
