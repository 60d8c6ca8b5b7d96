//! "As is well known, cubic shape functions lead to the exact solution of a beam if load and contact pressure are point-like."

use super::{Claim, Verdict, words::bound};
use crate::paper::beam;
use palkki::methods::Method;
use palkki::scene::{Foundation, Load, PointLoad, Scene, SceneError};
use palkki::solvers::Solver;
use palkki::{Settings, solve};

/// Errors of the displacement method under a single point load on a node, against the textbook formula.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Evidence {
    /// Largest relative error of a nodal deflection over all grids and places.
    pub deflection: f64,
    /// Largest relative error of the moment under the load.
    pub moment: f64,
    /// The same error of the deflection by finite differences, for comparison.
    pub deflection_by_differences: f64,
}

/// What rounding may make of it on these grids.
const ROUNDING: f64 = 1e-10;

/// Measures on grids of 2 to 40 intervals with the load on every fourth node; the foundation is out of reach.
///
/// # Errors
///
/// None for these scenes; the type is that of [`solve`].
#[expect(clippy::cast_precision_loss, reason = "40 intervals")]
pub fn measure() -> Result<Evidence, SceneError> {
    let beam = beam()?;
    let (l, ei) = (beam.length(), beam.bending_stiffness());
    let mut evidence = Evidence { deflection: 0.0, moment: 0.0, deflection_by_differences: 0.0 };
    for intervals in [2_usize, 5, 10, 20, 40] {
        for node in (1..intervals).step_by(4) {
            let at = l * node as f64 / intervals as f64;
            let load = Load::new(&beam, 0.0, Vec::new(), vec![PointLoad { at, force: 1.0 }])?;
            let scene = Scene::new(beam, load, Some(Foundation::Flat { depth: 1e3 }))?;
            // v = b x (l² − b² − x²) / (6 EI l) for x ≤ a, with b = l − a; M = a b / l under the load.
            let exact = |x: f64| {
                let (x, b) = if x <= at { (x, l - at) } else { (l - x, at) };
                b * x * (l * l - b * b - x * x) / (6.0 * ei * l)
            };
            for method in [Method::Displacement, Method::Complementarity] {
                let state = solve(&scene, &Settings::new(method, Solver::ActiveSet, intervals))?.state;
                let nodes = state.nodes.unwrap_or_default();
                let errors = nodes.x.iter().zip(&nodes.deflection).map(|(&x, v)| (v / exact(x) - 1.0).abs());
                let error = errors.fold(0.0, f64::max);
                if method == Method::Displacement {
                    evidence.deflection = evidence.deflection.max(error);
                    let moment = (state.moment.max / (at * (l - at) / l) - 1.0).abs();
                    evidence.moment = evidence.moment.max(moment);
                } else {
                    evidence.deflection_by_differences = evidence.deflection_by_differences.max(error);
                }
            }
        }
    }
    Ok(evidence)
}

impl Evidence {
    /// Whether only rounding is left.
    #[must_use]
    pub fn verdict(&self) -> Verdict {
        if self.deflection.max(self.moment) <= ROUNDING { Verdict::Confirmed } else { Verdict::Refuted }
    }

    pub(super) fn claim(&self) -> Claim {
        Claim {
            name: "exact_for_point_forces",
            statement: "Cubic shape functions give the exact deflection of a beam whose load and contact pressure are point forces.",
            verdict: self.verdict(),
            reading: None,
            summary: format!(
                "true up to rounding; finite differences are off by up to {:.0} % on the same grids",
                100.0 * self.deflection_by_differences
            ),
            evidence: format!(
                "Against the textbook formula for a point load on a node, with 2 to 40 intervals: deflections at the nodes are off \
                 by less than {}, the moment under the load by less than {}. Finite differences on the same grids are off by up to {:.0} %.",
                bound(self.deflection),
                bound(self.moment),
                100.0 * self.deflection_by_differences,
            ),
        }
    }
}
