//! Concentrated actions on the beam: each makes `e v''` and `e v'''` jump at its position, and changes nothing else there.
//!
//! Only this module converts the loads of a scene into such jumps. The other modules use the jumps without knowing the loads.

use crate::scene::Concentrated;

/// The actions at a position, over `EI₀`.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct Acts {
    couple: f64,
    force: f64,
}

impl Acts {
    /// From the jumps of `e v''` and `e v'''`.
    pub(super) fn new([couple, force]: [f64; 2]) -> Self {
        Self { couple, force }
    }

    /// Adds a load; `stiffness` is `EI₀`.
    pub(super) fn add(&mut self, load: Concentrated, stiffness: f64) {
        let Concentrated { at: _, force, couple } = load;
        self.force += force / stiffness;
        // A couple increases the moment, so `v''` decreases.
        self.couple -= couple / stiffness;
    }

    /// The actions times a factor.
    pub(super) fn times(self, share: f64) -> Self {
        Self { couple: share * self.couple, force: share * self.force }
    }

    /// True if anything acts.
    pub(super) fn is_any(self) -> bool {
        self.force != 0.0 || self.couple != 0.0
    }

    /// The jump of `e v''`.
    pub(super) fn couple(self) -> f64 {
        self.couple
    }

    /// The jump of `e v'''`: the force, downwards.
    pub(super) fn force(self) -> f64 {
        self.force
    }

    /// The jumps of `e v''` and `e v'''`.
    pub(super) fn jumps(self) -> [f64; 2] {
        [self.couple, self.force]
    }

    /// The work on a beam that has this deflection and slope at the position.
    pub(super) fn work(self, [v, v1]: [f64; 2]) -> f64 {
        self.force * v - self.couple * v1
    }

    /// The magnitude as a force, in a beam of this length. A load on a support passes directly into it, so its force does not count.
    pub(super) fn size(self, length: f64, is_on_support: bool) -> f64 {
        (if is_on_support { 0.0 } else { self.force.abs() }) + self.couple.abs() / length
    }
}
