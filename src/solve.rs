//! One way through: scene → method and grid → programme (32) → solver → state → verdict.

use crate::route::{Method, Outcome, Solver};
use crate::scene::{Scene, SceneError};

/// What a discretised solution is asked to be.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Settings {
    /// Which of the paper's methods sets up the programme.
    pub method: Method,
    /// Which solver solves it.
    pub solver: Solver,
    /// Number `N` of equal intervals, at least 2.
    pub intervals: usize,
    /// Scaled KKT residual at which an iterative solver may stop. It does not loosen the verdict.
    pub tolerance: f64,
}

/// Solves `scene` by one route.
///
/// # Errors
///
/// A [`SceneError`] if the grid is too coarse or the scene leaves the range of `f64`. A solver that fails is no error:
/// its answer comes back with a [`crate::route::Status`] that says so.
pub fn solve(scene: &Scene, settings: &Settings) -> Result<Outcome, SceneError> {
    let _ = settings;
    scene.scaled().map(|_| unimplemented!("in progress"))
}
