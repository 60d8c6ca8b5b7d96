//! "Force and displacement method lead to entirely the same result here."

use nalgebra::DMatrix;

use super::{Claim, Verdict, words::bound};
use crate::methods::{Discrete, Method};
use crate::paper::uneven::{Unevenness, scenes};
use crate::paper::{INTERVALS, example};
use crate::problem::{Dense, Matrix, Programme};
use crate::scene::{Scene, SceneError};
use crate::solvers::{Answer, Solver};

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

/// Compares the methods, each with the matrix that the paper gives it, on the example and on random scenes, 30 intervals each.
///
/// # Errors
///
/// None for these scenes; the type is that of [`Discrete::new`].
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
    let scaled = scene.scaled()?;
    let discrete = Discrete::new(&scaled.scene, INTERVALS)?;
    let nodal = |method: Method| {
        let programme = method.programme(&discrete);
        let (linear, sizes) = (programme.linear().into(), programme.sizes());
        let Answer { x, gradient, .. } =
            Solver::ActiveSet.run(&Dense { matrix: dense(programme.as_ref()), linear, sizes }, 0.0);
        method.nodal(&discrete, x, gradient)
    };
    let (a, b) = (nodal(Method::Displacement), nodal(Method::Force));
    // Not `max`, which would overlook what is no number.
    let worst = |most: f64, d: f64| if d <= most { most } else { d };
    let most = |x: &[f64], y: &[f64]| x.iter().zip(y).map(|(x, y)| (x - y).abs()).fold(0.0, worst);
    let largest = b.deflection.iter().fold(0.0_f64, |most, v| most.max(v.abs()));
    let total = scaled.scene.load().magnitude(scaled.scene.beam().length());
    Ok((most(&a.deflection, &b.deflection) / largest, most(&a.contact_force, &b.contact_force) / total))
}

/// A matrix as numbers in rows and columns.
fn dense(programme: &dyn Programme) -> DMatrix<f64> {
    match programme.matrix() {
        Matrix::Dense(a) => a,
        banded @ Matrix::Pentadiagonal(_) => {
            let n = banded.dimension();
            DMatrix::from_fn(n, n, |i, j| banded.entry(i, j))
        }
    }
}

/// The largest entry of `K C − I` on a grid of the example.
///
/// # Errors
///
/// None for the example; the type is that of [`Discrete::new`].
pub fn inverse_defect(intervals: usize) -> Result<f64, SceneError> {
    let scene = example()?;
    let discrete = Discrete::new(&scene, intervals)?;
    let matrix = |method: Method| dense(method.programme(&discrete).as_ref());
    let product = matrix(Method::Displacement) * matrix(Method::Force);
    Ok((&product - DMatrix::identity(product.nrows(), product.ncols())).amax())
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
