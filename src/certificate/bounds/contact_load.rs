//! Contact forces that somebody computed.

use crate::scene::Scale;

/// Forces of the foundation on the beam, at places, upwards; those that pull are cut off.
#[derive(Debug, Clone, PartialEq)]
pub struct ContactLoad {
    /// Places and forces, from left to right, one at a place, all positive.
    pub(super) pressing: Vec<(f64, f64)>,
    /// Places and forces that were cut off, all negative.
    pub(super) pulling: Vec<(f64, f64)>,
}

/// A force that is none.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum NotAForce {
    /// A number that is `nan` or infinite.
    #[error("force {index} must be finite, but is {force} at x = {x}")]
    NotFinite {
        /// Which, from 0.
        index: usize,
        /// Where.
        x: f64,
        /// Its value.
        force: f64,
    },
    /// A place that is not on the beam.
    #[error("force {index} must act on the beam, between 0 and {length}, but acts at x = {x}")]
    OutsideBeam {
        /// Which, from 0.
        index: usize,
        /// Where.
        x: f64,
        /// Length of the beam.
        length: f64,
    },
}

impl NotAForce {
    /// Which force, from 0.
    #[must_use]
    pub fn index(&self) -> usize {
        match *self {
            Self::NotFinite { index, .. } | Self::OutsideBeam { index, .. } => index,
        }
    }
}

impl ContactLoad {
    /// Contact forces `(x, force)` on a beam of some length, in any order; forces at one place add up.
    ///
    /// # Errors
    ///
    /// A force or a place that is not finite, or a place that is not on the beam.
    pub fn new(length: f64, forces: impl IntoIterator<Item = (f64, f64)>) -> Result<Self, NotAForce> {
        let all = Self::sorted(length, forces)?;
        let pressing = all.iter().copied().filter(|f| 0.0 < f.1).collect();
        let pulling = all.into_iter().filter(|f| f.1 < 0.0).collect();
        Ok(Self { pressing, pulling })
    }

    /// Finite forces on the beam from left to right, one at a place.
    pub(super) fn sorted(
        length: f64,
        forces: impl IntoIterator<Item = (f64, f64)>,
    ) -> Result<Vec<(f64, f64)>, NotAForce> {
        let mut all: Vec<(f64, f64)> = Vec::new();
        for (index, (x, force)) in forces.into_iter().enumerate() {
            if !force.is_finite() || !x.is_finite() {
                return Err(NotAForce::NotFinite { index, x, force });
            }
            if !(0.0..=length).contains(&x) {
                return Err(NotAForce::OutsideBeam { index, x, length });
            }
            all.push((x, force));
        }
        all.sort_by(|a, b| a.0.total_cmp(&b.0));
        all.dedup_by(|next, kept| {
            let same = next.0 <= kept.0;
            if same {
                kept.1 += next.1;
            }
            same
        });
        Ok(all)
    }

    /// The forces that pulled and were cut off: places and forces, all negative.
    #[must_use]
    pub fn pulling(&self) -> &[(f64, f64)] {
        &self.pulling
    }

    /// The same in other units, all powers of two.
    pub(super) fn scaled(&self, scale: &Scale) -> Self {
        let scaled = |forces: &[(f64, f64)]| forces.iter().map(|f| (f.0 / scale.length, f.1 / scale.force)).collect();
        Self { pressing: scaled(&self.pressing), pulling: scaled(&self.pulling) }
    }
}
