//! Checks for features that not every computation supports; a computation calls them before it starts.

use super::{Scene, SceneError};

impl Scene {
    /// Checks that the foundation is rigid or absent.
    ///
    /// # Errors
    ///
    /// [`SceneError::NeedsRigidGround`] otherwise, with the name of the computation.
    pub fn on_rigid_ground(&self, what: &'static str) -> Result<(), SceneError> {
        self.ground_stiffness().map_or(Ok(()), |_| Err(SceneError::NeedsRigidGround { what }))
    }

    /// True if the beam has one bending stiffness and no joints.
    #[must_use]
    pub fn is_uniform(&self) -> bool {
        self.beam.changes().next().is_none() && self.beam.joints().is_empty()
    }

    /// True if no axial force acts on the beam.
    #[must_use]
    pub fn has_no_tension(&self) -> bool {
        self.beam.tension() == 0.0
    }

    /// True if no support of the beam gives.
    #[must_use]
    pub fn is_firm(&self) -> bool {
        let turns = self.beam.supports().iter().any(|support| support.turning_stiffness.is_some());
        !turns && self.beam.springs().is_empty()
    }

    /// True if all moments of the beam follow from forces that are given: there is no hinge, no axial force and no support that gives, and
    /// on ground that gives there are neither steps of the bending stiffness nor joints.
    pub(crate) fn bends_under_forces(&self) -> bool {
        self.bends_otherwise().is_none()
    }

    /// Refuses a beam of which moments do not follow from forces that are given.
    ///
    /// # Errors
    ///
    /// [`SceneError::NotKnown`], naming what asked for it.
    pub(crate) fn has_to_bend_under_forces(&self, what: &'static str) -> Result<(), SceneError> {
        self.bends_otherwise().map_or(Ok(()), |feature| Err(SceneError::NotKnown { what, feature }))
    }

    /// Because of what moments do not follow from forces that are given.
    fn bends_otherwise(&self) -> Option<&'static str> {
        let gives = self.ground_stiffness().is_some();
        let feature = if gives && self.beam.changes().next().is_some() {
            "a bending stiffness in steps"
        } else if gives && !self.beam.joints().is_empty() {
            "joints"
        } else if !gives && self.beam.is_hinged() {
            "hinges"
        } else if !self.has_no_tension() {
            "an axial force"
        } else if !self.is_firm() {
            "supports that give"
        } else {
            return None;
        };
        Some(feature)
    }

    /// Checks that contact forces at nodes determine the position of the beam although the lengths over which they act are
    /// unknown. They do not if the supports do not hold the beam and the foundation is elastic: its settlement below each force
    /// depends on that length.
    ///
    /// # Errors
    ///
    /// [`SceneError::NeedsRigidGround`] otherwise.
    pub(crate) fn is_placed_by_forces(&self) -> Result<(), SceneError> {
        if self.beam.is_held() {
            Ok(())
        } else {
            self.on_rigid_ground("a check of nodal loads and forces that alone hold a beam")
        }
    }
}
