//! Extension (c): a body whose rigid motion is not known beforehand. Without supports the stiffness is singular.

use nalgebra::{DMatrix, DVector};

use crate::methods::flexibility;
use crate::paper::beam;
use crate::paper::claims::{Claim, Verdict};
use crate::problem::{Dense, FreeSet, Programme, Sizes};
use crate::scene::SceneError;

/// The beam of the example with its supports taken away.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Unsupported {
    /// Eigenvalues of the stiffness that vanish beside the largest one: rigid motions.
    pub rigid_motions: usize,
    /// Whether step 1° of the paper's algorithm can be carried out.
    pub first_step_works: bool,
}

/// The condensed stiffness of an unsupported beam with 29 inner nodes and two ends, and what step 1° makes of it.
///
/// Deflections of the ends are added to those of the supported beam: `K_free = Bᵀ K B` with `B v = v − chord of the ends`.
///
/// # Errors
///
/// None; the type is that of [`beam`].
#[expect(clippy::cast_precision_loss, reason = "30 intervals")]
pub fn unknown_rigid_motion() -> Result<Unsupported, SceneError> {
    let beam = beam()?;
    let n = 29;
    let c = DMatrix::from_fn(n, n, |i, j| flexibility(beam.length(), beam.bending_stiffness(), n, i + 1, j + 1));
    let chord = |i: usize, end: usize| {
        let share = (i + 1) as f64 / (n + 1) as f64;
        if end == 0 { 1.0 - share } else { share }
    };
    let relative = DMatrix::from_fn(n, n + 2, |i, j| match j {
        0 => -chord(i, 0),
        j if j == n + 1 => -chord(i, 1),
        j => f64::from(u8::from(j == i + 1)),
    });
    let stiffness = c.try_inverse().unwrap_or_else(|| DMatrix::zeros(n, n));
    let free = relative.transpose() * stiffness * &relative;
    let eigenvalues = free.clone().symmetric_eigenvalues();
    let largest = eigenvalues.max();
    let programme = Dense {
        linear: DVector::from_element(n + 2, 1.0),
        sizes: Sizes { x: 1.0, gradient: 1.0 },
        // Symmetric up to rounding, shifted by less than rounding of the largest entry: semidefinite, not definite.
        matrix: (&free + free.transpose()) * 0.5 - DMatrix::identity(n + 2, n + 2) * (1e-12 * largest),
    };
    Ok(Unsupported {
        rigid_motions: eigenvalues.iter().filter(|e| e.abs() <= 1e-9 * largest).count(),
        first_step_works: programme.stationary(&FreeSet::all(n + 2)).is_ok(),
    })
}

impl Unsupported {
    /// Confirmed if there are rigid motions and the algorithm does not even start.
    #[must_use]
    pub fn verdict(&self) -> Verdict {
        if self.rigid_motions == 2 && !self.first_step_works { Verdict::Confirmed } else { Verdict::Refuted }
    }

    pub(in crate::paper::claims) fn claim(&self) -> Claim {
        Claim {
            name: "unknown_rigid_motion",
            statement: "Where the rigid motion of the body is not known beforehand, further study is needed.",
            verdict: self.verdict(),
            reading: None,
            summary: format!(
                "without supports there are {} rigid motions, and step 1° {}",
                self.rigid_motions,
                if self.first_step_works { "has a solution" } else { "has no solution" },
            ),
            evidence: format!(
                "Without supports the condensed stiffness has {} vanishing eigenvalues, the rigid motions, and C does not exist: \
                 step 1° of the algorithm {}. The quadratic program is still convex; it needs other solvers.",
                self.rigid_motions,
                if self.first_step_works { "can be carried out" } else { "cannot be carried out" }
            ),
        }
    }
}
