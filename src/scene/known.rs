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

    /// Checks that the beam has a uniform bending stiffness and no joints.
    ///
    /// # Errors
    ///
    /// [`SceneError::NotKnown`] otherwise, with the name of the computation.
    pub fn is_uniform(&self, what: &'static str) -> Result<(), SceneError> {
        let feature = match (self.beam.changes().next(), self.beam.joints()) {
            (Some(_), _) => "a bending stiffness in steps",
            (None, [_, ..]) => "joints",
            (None, []) => return Ok(()),
        };
        Err(SceneError::NotKnown { what, feature })
    }

    /// Checks that all moments of the beam follow from given forces. This requires that there is no hinge, no axial force and no
    /// elastic support. On an elastic foundation the bending stiffness must also be uniform, without joints.
    ///
    /// # Errors
    ///
    /// [`SceneError::NotKnown`] otherwise, with the name of the computation.
    pub(crate) fn bends_under_forces(&self, what: &'static str) -> Result<(), SceneError> {
        if self.ground_stiffness().is_some() {
            self.is_uniform(what)?;
        } else if self.beam.is_hinged() {
            return Err(SceneError::NotKnown { what, feature: "hinges" });
        }
        self.has_no_tension(what)?;
        self.is_firm(what)
    }

    /// Checks that no axial force acts on the beam.
    ///
    /// # Errors
    ///
    /// [`SceneError::NotKnown`] otherwise, with the name of the computation.
    pub fn has_no_tension(&self, what: &'static str) -> Result<(), SceneError> {
        if self.beam.tension() == 0.0 { Ok(()) } else { Err(SceneError::NotKnown { what, feature: "an axial force" }) }
    }

    /// Checks that the beam has no elastic support.
    ///
    /// # Errors
    ///
    /// [`SceneError::NotKnown`] otherwise, with the name of the computation.
    pub fn is_firm(&self, what: &'static str) -> Result<(), SceneError> {
        let turns = self.beam.supports().iter().any(|support| support.turning_stiffness.is_some());
        if turns || !self.beam.springs().is_empty() {
            return Err(SceneError::NotKnown { what, feature: "supports that give" });
        }
        Ok(())
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
