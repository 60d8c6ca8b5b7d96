//! Extension (b): an elastic foundation. The force method gets a flexibility of the foundation on its diagonal.

use nalgebra::{DMatrix, DVector};

use crate::paper::beam;
use crate::paper::claims::{Claim, Verdict, words::bound};
use palkki::methods::flexibility;
use palkki::problem::{Dense, Sizes, residual};
use palkki::scene::SceneError;
use palkki::solvers::Solver;

/// The beam of the example on elastic springs that it touches from the start, `u = 0`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Springs {
    /// Scaled residual of the optimality conditions.
    pub residual: f64,
    /// Deflection at mid-span over that of the series solution, minus one.
    pub deflection: f64,
}

/// Foundation modulus `k` \[force / length²\].
const MODULUS: f64 = 0.5;
const INTERVALS: usize = 60;

/// Solves `min ½ pᵀ (C + I/(kΔ)) p − (C q)ᵀ p, p ≥ 0`: the clearance of a spring that carries `p` is `p/(kΔ)` larger.
///
/// Authority: `v(l/2) = Σ (4 q₀ / m π) sin(m π/2) / (EI (m π/l)⁴ + k)`, `m` odd (Hetényi 1946), while all springs are pressed.
///
/// # Errors
///
/// None; the type is that of [`beam`].
#[expect(clippy::cast_precision_loss, reason = "60 intervals")]
pub fn elastic_foundation() -> Result<Springs, SceneError> {
    let beam = beam()?;
    let (l, ei) = (beam.length(), beam.bending_stiffness());
    let n = INTERVALS - 1;
    let spacing = l / INTERVALS as f64;
    let c = DMatrix::from_fn(n, n, |i, j| flexibility(l, ei, n, i + 1, j + 1));
    let loads = DVector::from_element(n, spacing);
    let linear = &c * &loads;
    let matrix = &c + DMatrix::identity(n, n) / (MODULUS * spacing);
    let programme = Dense { matrix, linear, sizes: Sizes { x: l, gradient: 1.0 / MODULUS } };
    let answer = Solver::ActiveSet.run(&programme, 0.0);
    let deflection = answer.x[n / 2] / (MODULUS * spacing);

    let term = |m: usize| {
        let wave = m as f64 * std::f64::consts::PI;
        let sign = if m % 4 == 1 { 1.0 } else { -1.0 };
        let ratio = wave / l;
        4.0 / wave * sign / (ei * ratio * ratio * ratio * ratio + MODULUS)
    };
    let series: f64 = (0..500).rev().map(|k| term(2 * k + 1)).sum();
    Ok(Springs {
        residual: residual(programme.sizes, &answer.x, &answer.gradient),
        deflection: deflection / series - 1.0,
    })
}

impl Springs {
    /// Whether the method works as it is: optimal, and within one per cent of the series.
    #[must_use]
    pub fn verdict(&self) -> Verdict {
        if self.residual <= 1e-9 && self.deflection.abs() <= 0.01 { Verdict::Confirmed } else { Verdict::Refuted }
    }

    pub(in crate::paper::claims) fn claim(&self) -> Claim {
        Claim {
            name: "elastic_foundation",
            statement: "The methods extend to an elastic foundation.",
            verdict: self.verdict(),
            reading: None,
            summary: format!(
                "springs: deflection at mid-span within {} of the series solution",
                bound(self.deflection)
            ),
            evidence: format!(
                "The force method with the flexibility of springs added to the diagonal of C, {INTERVALS} intervals: scaled residual \
                 below {}, deflection at mid-span within {} of the series solution of a beam on an elastic foundation (Hetényi 1946).",
                bound(self.residual.max(f64::EPSILON)),
                bound(self.deflection)
            ),
        }
    }
}
