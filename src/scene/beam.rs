//! The beam: straight, elastic, of constant bending stiffness, simply supported at both ends.

use super::error::{SceneError, positive};
use super::quantity::Quantity;

/// A straight elastic beam on two simple supports, at `x = 0` and `x = l`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Beam {
    length: f64,
    bending_stiffness: f64,
}

impl Beam {
    /// A beam of length `l` \[length\] and bending stiffness `EI` \[force · length²\].
    ///
    /// # Errors
    ///
    /// [`SceneError::NotPositive`] unless both are positive and finite.
    pub fn new(length: f64, bending_stiffness: f64) -> Result<Self, SceneError> {
        Ok(Self {
            length: positive(Quantity::Length, length)?,
            bending_stiffness: positive(Quantity::BendingStiffness, bending_stiffness)?,
        })
    }

    /// `l` \[length\].
    #[must_use]
    pub fn length(&self) -> f64 {
        self.length
    }

    /// `EI` \[force · length²\].
    #[must_use]
    pub fn bending_stiffness(&self) -> f64 {
        self.bending_stiffness
    }
}
