//! Beams that engineers have, in newtons and metres, and their answers by finite elements that share no code with the library.

mod beds;
mod elements;
mod families;
mod problem;
mod reference;
mod results;
mod wide;

use palkki::scene::{Scene, SceneError};

use crate::draft::Draft;

pub use families::Family;
pub use reference::{Found, Numbers, Reference, Shares, reference};

/// A beam as an engineer has it \[N, m\].
#[derive(Debug, Clone, Default)]
pub struct Case {
    /// Beam, load, supports and ground.
    pub draft: Draft,
    /// Stiffness of the ground, if it gives \[N/m²\].
    pub soil: Option<f64>,
}

impl Case {
    /// The scene.
    ///
    /// # Errors
    ///
    /// What the library refuses of it.
    pub fn scene(&self) -> Result<Scene, SceneError> {
        self.draft.scene_above(self.soil)
    }

    /// The scene file.
    #[must_use]
    pub fn text(&self) -> String {
        let soil = self.soil.map_or_else(String::new, |stiffness| format!("stiffness = {stiffness:?}\n"));
        // The foundation is the last table of a draft.
        self.draft.text() + &soil
    }
}
