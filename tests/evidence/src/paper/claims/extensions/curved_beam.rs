//! "A curved beam (a ski) on a straight base is almost the same problem."
//!
//! With the unloaded shape `w₀`, `w₀(0) = w₀(l) = 0`, the beam bends by `v`, `EI v'''' = q − p`, and touches where
//! `w₀ + v = u`. Only `u − w₀` enters: a straight beam over the foundation `u − w₀`.

use nalgebra::{DMatrix, DVector};

use crate::paper::claims::{Claim, Verdict, words::bound};
use crate::paper::{INTERVALS, beam, scene_over};
use palkki::methods::{Method, flexibility};
use palkki::problem::{Dense, Sizes};
use palkki::scene::{Foundation, SceneError};
use palkki::solvers::Solver;
use palkki::{Settings, solve};

/// A ski over a flat base, and the straight beam that is said to be the same problem.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Curved {
    /// Largest difference of a contact force, over the load.
    pub difference: f64,
    /// Resultant of the contact.
    pub contact_force: f64,
}

/// Camber of the ski at mid-span, upwards: `w₀ = −4 · CAMBER x (l − x)/l²`.
const CAMBER: f64 = 0.75;
const DEPTH: f64 = 1.0;

/// Solves the ski from `h = u − (w₀ + C (q − p)) ≥ 0` directly, and the straight beam over `u − w₀` as a scene.
///
/// # Errors
///
/// None; the type is that of [`solve`].
#[expect(clippy::cast_precision_loss, reason = "30 intervals")]
pub fn curved_beam() -> Result<Curved, SceneError> {
    let beam = beam()?;
    let l = beam.length();
    let rise = 4.0 * CAMBER / l;
    let foundation = Foundation::Polynomial { coefficients: vec![DEPTH, rise, -rise / l] };
    let scene = scene_over(foundation)?;
    let state = solve(&scene, &Settings::new(Method::Force, Solver::ActiveSet, INTERVALS))?.state;
    let contact_force = state.contact_force();
    let straight = state.nodes.unwrap_or_default();

    let n = INTERVALS - 1;
    let c = DMatrix::from_fn(n, n, |i, j| flexibility(l, beam.bending_stiffness(), n, i + 1, j + 1));
    let loads = DVector::from_element(n, l / INTERVALS as f64);
    let shape = DVector::from_fn(n, |i, _| {
        let x = l * (i + 1) as f64 / INTERVALS as f64;
        -4.0 * CAMBER * x * (l - x) / (l * l)
    });
    let unloaded_gap = DVector::from_element(n, DEPTH) - shape;
    let ski = Dense { linear: &c * &loads - unloaded_gap, matrix: c, sizes: Sizes { x: l, gradient: DEPTH } };
    let answer = Solver::ActiveSet.run(&ski, 0.0);
    let pairs = answer.x.iter().zip(&straight.contact_force);
    Ok(Curved { difference: pairs.fold(0.0, |worst: f64, (a, b)| worst.max((a - b).abs())) / l, contact_force })
}

impl Curved {
    /// Confirmed if the contact forces are the same up to rounding.
    #[must_use]
    pub fn verdict(&self) -> Verdict {
        if self.difference <= 1e-8 { Verdict::Confirmed } else { Verdict::Refuted }
    }

    pub(in crate::paper::claims) fn claim(&self) -> Claim {
        Claim {
            name: "curved_beam",
            statement: "A curved beam (a ski) on a straight base is almost the same problem.",
            verdict: self.verdict(),
            reading: None,
            summary: format!(
                "contact forces differ by less than {} of the load: only u − w₀ enters",
                bound(self.difference)
            ),
            evidence: format!(
                "It is the same problem if its ends are supported, since only u − w₀ enters, w₀ being the unloaded shape. A ski with a camber of {CAMBER} u₀ over a flat base \
                 and a straight beam over the equivalent foundation, {INTERVALS} intervals: contact forces differ by less than {} \
                 of the load (resultant {:.4}).",
                bound(self.difference),
                self.contact_force
            ),
        }
    }
}
