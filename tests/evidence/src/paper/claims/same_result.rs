//! "Force and displacement method lead to entirely the same result here."

use super::{Claim, Verdict, words::bound};
use crate::paper::uneven::{Unevenness, scenes};
use crate::paper::{INTERVALS, example};
use palkki::methods::{Discrete, Method};
use palkki::problem::Matrix;
use palkki::scene::{Scene, SceneError};
use palkki::solvers::Solver;
use palkki::{Settings, solve};

/// Random scenes of each kind.
const SCENES: usize = 100;
/// Seed of the random scenes.
const SEED: u64 = 1984;
/// The difference that rounding may make: condition numbers here stay below 10⁷, so 16 digits leave nine.
const ROUNDING: f64 = 1e-9;

/// The largest differences between the two methods.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Evidence {
    /// Scenes that were compared.
    pub scenes: usize,
    /// Largest difference of a nodal deflection, over the largest deflection.
    pub deflection: f64,
    /// Largest difference of a nodal contact force, over the total load.
    pub contact_force: f64,
    /// Largest entry of `K C − I` with 29 interior nodes.
    pub inverse: f64,
}

/// Compares the methods on the example and on random scenes, 30 intervals each.
///
/// # Errors
///
/// None for these scenes; the type is that of [`solve`].
pub fn measure() -> Result<Evidence, SceneError> {
    let mut all = vec![example()?];
    for kind in Unevenness::ALL {
        all.extend(scenes(kind, SCENES, SEED)?);
    }
    let (mut deflection, mut contact_force) = (0.0_f64, 0.0_f64);
    for scene in &all {
        let (v, p) = differences(scene)?;
        (deflection, contact_force) = (deflection.max(v), contact_force.max(p));
    }
    Ok(Evidence { scenes: all.len(), deflection, contact_force, inverse: inverse_defect(INTERVALS)? })
}

fn differences(scene: &Scene) -> Result<(f64, f64), SceneError> {
    let nodes = |method| -> Result<_, SceneError> {
        let outcome = solve(scene, &Settings::new(method, Solver::ActiveSet, INTERVALS))?;
        Ok(outcome.state.nodes.unwrap_or_default())
    };
    let (a, b) = (nodes(Method::Displacement)?, nodes(Method::Force)?);
    let most = |x: &[f64], y: &[f64]| x.iter().zip(y).fold(0.0_f64, |most, (x, y)| most.max((x - y).abs()));
    let largest = b.deflection.iter().fold(0.0_f64, |most, v| most.max(v.abs()));
    let total = scene.load().magnitude(scene.beam().length());
    Ok((most(&a.deflection, &b.deflection) / largest, most(&a.contact_force, &b.contact_force) / total))
}

/// The largest entry of `K C − I` on a grid of the example.
///
/// # Errors
///
/// None for the example; the type is that of [`Discrete::new`].
pub fn inverse_defect(intervals: usize) -> Result<f64, SceneError> {
    let scene = example()?;
    let discrete = Discrete::new(&scene, intervals)?;
    let dense = |method: Method| match method.programme(&discrete).matrix() {
        Matrix::Dense(a) => a,
        banded @ Matrix::Pentadiagonal(_) => {
            let n = banded.dimension();
            nalgebra::DMatrix::from_fn(n, n, |i, j| banded.entry(i, j))
        }
    };
    let product = dense(Method::Displacement) * dense(Method::Force);
    Ok((&product - nalgebra::DMatrix::identity(product.nrows(), product.ncols())).amax())
}

impl Evidence {
    /// Whether the results are the same up to rounding.
    #[must_use]
    pub fn verdict(&self) -> Verdict {
        if self.deflection.max(self.contact_force) <= ROUNDING { Verdict::Confirmed } else { Verdict::Refuted }
    }

    pub(super) fn claim(&self) -> Claim {
        Claim {
            name: "same_result",
            statement: "Force and displacement method lead to entirely the same result.",
            verdict: self.verdict(),
            reading: None,
            summary: format!("the same up to rounding on {} scenes", self.scenes),
            evidence: format!(
                "The two quadratic programs are dual, and K C = I (largest entry of K C − I with n = 29: below {}). On the example and {} \
                 random uneven foundations, on 30 intervals, nodal deflections differ by less than {} of the largest one, \
                 contact forces by less than {} of the load.",
                bound(self.inverse),
                self.scenes - 1,
                bound(self.deflection),
                bound(self.contact_force),
            ),
        }
    }
}
