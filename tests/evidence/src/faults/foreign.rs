//! Answers that are put into the place of another's: of the same beam above other ground, under another load, on a finer
//! grid.

use palkki::scene::{Foundation, LinearLoad, Load, PointLoad, Scene, SceneError};
use palkki::state::{ContactState, Nodes};

/// The scene with all depths multiplied by `1 + share`: what an answer belongs to that was not computed again.
///
/// # Errors
///
/// A [`SceneError`] if the depths overflow.
pub fn scaled_ground(scene: &Scene, share: f64) -> Result<Scene, SceneError> {
    let factor = 1.0 + share;
    let foundation = scene.foundation().map(|foundation| match foundation {
        Foundation::Flat { depth } => Foundation::Flat { depth: depth * factor },
        Foundation::Polynomial { coefficients } => {
            Foundation::Polynomial { coefficients: coefficients.iter().map(|c| c * factor).collect() }
        }
        &Foundation::Cosine { mean, amplitude, wavelength, phase } => {
            Foundation::Cosine { mean: mean * factor, amplitude: amplitude * factor, wavelength, phase }
        }
        Foundation::Polyline { points } => {
            Foundation::Polyline { points: points.iter().map(|p| [p[0], p[1] * factor]).collect() }
        }
    });
    Scene::new(*scene.beam(), scene.load().clone(), foundation)
}

/// The scene with all loads multiplied by `1 + share`.
///
/// # Errors
///
/// A [`SceneError`] if the loads overflow.
pub fn scaled_load(scene: &Scene, share: f64) -> Result<Scene, SceneError> {
    let factor = 1.0 + share;
    let load = scene.load();
    let linear = load.linear().iter().map(|q| LinearLoad { start: q.start * factor, end: q.end * factor, ..*q });
    let point = load.point().iter().map(|p| PointLoad { force: p.force * factor, ..*p });
    let load = Load::new(scene.beam(), load.uniform() * factor, linear.collect(), point.collect())?;
    Scene::new(*scene.beam(), load, scene.foundation().cloned())
}

/// Every second interior node of a state on twice as many intervals, as if it were the answer on the coarser grid.
#[must_use]
pub fn every_second(state: &ContactState) -> ContactState {
    let every_second = |list: &Vec<f64>| list.iter().skip(1).step_by(2).copied().collect();
    let nodes = state.nodes.as_ref().map(|nodes| Nodes {
        bending: nodes.bending,
        x: every_second(&nodes.x),
        deflection: every_second(&nodes.deflection),
        clearance: every_second(&nodes.clearance),
        contact_force: every_second(&nodes.contact_force),
        moment: every_second(&nodes.moment),
    });
    ContactState { nodes, ..state.clone() }
}
