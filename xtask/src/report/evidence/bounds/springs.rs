//! Contact by penalty: tensionless springs at the nodes instead of a rigid foundation, as programs for structures do it.
//!
//! A spring of stiffness `k` gives way by `f/k`, so that the clearance of the force method, (28), becomes
//!
//! ```text
//! f ≥ 0,  (C + I/k) f + u − C q ≥ 0,  fᵀ((C + I/k) f + u − C q) = 0
//! ```
//!
//! the same programme (32) with a matrix that is stiffer on its diagonal.

use nalgebra::{DMatrix, DVector};
use palkki::methods::{Discrete, Method};
use palkki::problem::Dense;
use palkki::scene::Scene;
use palkki::solvers::Solver;

use crate::report::error::Cause;

/// Contact forces `(x, force)` of springs at the nodes; `ratio` is the stiffness of one of them over that of the free beam
/// in its middle, `48 EI / l³`.
pub(super) fn forces(scene: &Scene, intervals: usize, ratio: f64) -> Result<Vec<(f64, f64)>, Cause> {
    let scaled = scene.scaled()?;
    let beam = scaled.scene.beam();
    let length = beam.length();
    let spring = ratio * 48.0 * beam.bending_stiffness() / (length * length * length);
    let discrete = Discrete::new(&scaled.scene, intervals)?;
    let rigid = Method::Force.programme(&discrete);
    let (n, flexibility) = (rigid.dimension(), rigid.matrix());
    let softness = |i: usize, j: usize| if i == j { 1.0 / spring } else { 0.0 };
    let programme = Dense {
        matrix: DMatrix::from_fn(n, n, |i, j| flexibility.entry(i, j) + softness(i, j)),
        linear: DVector::from_vec(rigid.linear()),
        sizes: rigid.sizes(),
    };
    let answer = Solver::ActiveSet.run(&programme, 0.0);
    if !answer.claims_success {
        return Err(format!("springs of ratio {ratio}: {}", answer.words).into());
    }
    let scale = &scaled.scale;
    let place = |i: usize| discrete.grid.place(i + 1) * scale.length;
    Ok(answer.x.iter().enumerate().map(|(i, force)| (place(i), force * scale.force)).collect())
}
