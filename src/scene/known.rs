//! What not everybody can compute yet: who cannot asks first, and refuses.

use super::{Scene, SceneError};

impl Scene {
    /// Whether the ground of a scene is rigid, or there is none.
    ///
    /// # Errors
    ///
    /// [`SceneError::NeedsRigidGround`] if not, naming what asked for it.
    pub fn on_rigid_ground(&self, what: &'static str) -> Result<(), SceneError> {
        self.ground_stiffness().map_or(Ok(()), |_| Err(SceneError::NeedsRigidGround { what }))
    }

    /// Whether the beam has one bending stiffness and no joints.
    ///
    /// # Errors
    ///
    /// [`SceneError::NotKnown`] if not, naming what asked for it.
    pub fn is_uniform(&self, what: &'static str) -> Result<(), SceneError> {
        let feature = match (self.beam.changes().next(), self.beam.joints()) {
            (Some(_), _) => "a bending stiffness in steps",
            (None, [_, ..]) => "joints",
            (None, []) => return Ok(()),
        };
        Err(SceneError::NotKnown { what, feature })
    }

    /// Whether all moments of the beam follow from forces that are given: there is no hinge, no axial force and no support that gives, and on
    /// ground that gives there are neither steps of the bending stiffness nor joints.
    ///
    /// # Errors
    ///
    /// [`SceneError::NotKnown`] if not, naming what asked for it.
    pub(crate) fn bends_under_forces(&self, what: &'static str) -> Result<(), SceneError> {
        if self.ground_stiffness().is_some() {
            self.is_uniform(what)?;
        } else if self.beam.is_hinged() {
            return Err(SceneError::NotKnown { what, feature: "hinges" });
        }
        self.has_no_tension(what)?;
        self.is_firm(what)
    }

    /// Whether no axial force acts on the beam.
    ///
    /// # Errors
    ///
    /// [`SceneError::NotKnown`] if one does, naming what asked for it.
    pub fn has_no_tension(&self, what: &'static str) -> Result<(), SceneError> {
        if self.beam.tension() == 0.0 { Ok(()) } else { Err(SceneError::NotKnown { what, feature: "an axial force" }) }
    }

    /// Whether no support of the beam gives.
    ///
    /// # Errors
    ///
    /// [`SceneError::NotKnown`] if one does, naming what asked for it.
    pub fn is_firm(&self, what: &'static str) -> Result<(), SceneError> {
        let turns = self.beam.supports().iter().any(|support| support.turning_stiffness.is_some());
        if turns || !self.beam.springs().is_empty() {
            return Err(SceneError::NotKnown { what, feature: "supports that give" });
        }
        Ok(())
    }

    /// Whether contact forces at nodes, without the lengths over which they act, determine the position of the beam: not if supports do
    /// not hold it, on ground that gives way below each force by an amount that depends on that length.
    ///
    /// # Errors
    ///
    /// [`SceneError::NeedsRigidGround`] if not.
    pub(crate) fn is_placed_by_forces(&self) -> Result<(), SceneError> {
        if self.beam.is_held() {
            Ok(())
        } else {
            self.on_rigid_ground("a check of nodal loads and forces that alone hold a beam")
        }
    }
}
