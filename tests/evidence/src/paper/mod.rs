//! The paper, reproduced: its example, its figures, its claims, how fast its methods converge.
//!
//! The example: `u₀ = 1`, `l = 10`, `q₀ = 1`, `EI = 500/384`, so that the free beam would deflect `100 u₀`.

// Discrepancy: reaction-of-the-example
//
// The paper gives 1,14 for "the reaction" (n = 29), which is the force at the first node in contact. The end reaction is 1.0194 from
// the interior loads alone and 1.1860 with the load of half an interval at the support.

pub mod claims;
pub mod convergence;
mod figures;
pub mod uneven;

pub use figures::{Deflections, Pressures, figure_4, figure_7, figure_8};

use palkki::scene::{Beam, Foundation, Load, Scene, SceneError};

use crate::closed::{FlatSolution, flat};

/// Length `l` of the example.
pub(crate) const LENGTH: f64 = 10.0;
/// Bending stiffness `EI`.
pub(crate) const STIFFNESS: f64 = 500.0 / 384.0;
/// Depth `u₀` of the flat foundation.
const DEPTH: f64 = 1.0;
/// Uniform load `q₀`.
pub(crate) const UNIFORM: f64 = 1.0;

/// Intervals of Figures 4, 7 and 8.
pub const INTERVALS: usize = 30;
/// "Useful results were obtained when the beam was divided into 20 equal intervals."
pub const PRINTED_USEFUL_INTERVALS: usize = 20;
/// Printed for beam theory: the reaction, and the point force at lift-off, "1,18".
pub const PRINTED_REACTION: f64 = 1.18;
/// Printed for n = 29: "1,14".
pub const PRINTED_FORCE: f64 = 1.14;

/// The beam of the example.
///
/// # Errors
///
/// None: the data are constants. The type is that of [`Beam::new`].
pub fn beam() -> Result<Beam, SceneError> {
    Beam::new(LENGTH, STIFFNESS)
}

/// The example: a flat foundation.
///
/// # Errors
///
/// None, as [`beam`].
pub fn example() -> Result<Scene, SceneError> {
    scene_over(Foundation::Flat { depth: DEPTH })
}

/// Beam and load of the example over another foundation.
///
/// # Errors
///
/// What is wrong with the foundation.
pub fn scene_over(foundation: Foundation) -> Result<Scene, SceneError> {
    let beam = beam()?;
    Scene::new(beam.clone(), Load::uniform_on(&beam, UNIFORM)?, Some(foundation))
}

/// Beam theory for the example: the paper's "vertailuratkaisu".
#[must_use]
pub fn theory() -> FlatSolution {
    flat(LENGTH, STIFFNESS, DEPTH, UNIFORM)
}
