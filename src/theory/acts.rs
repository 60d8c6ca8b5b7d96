//! What acts at a place of the beam: it makes `e v''` and `e v'''` jump, and changes nothing else there.
//!
//! Here alone loads of a scene become such jumps. Who carries them on need not know of which loads they are.

use crate::scene::Concentrated;

/// What acts at a place, over `EI₀`.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct Acts {
    couple: f64,
    force: f64,
}

impl Acts {
    /// By how much `e v''` and `e v'''` jump.
    pub(super) fn new([couple, force]: [f64; 2]) -> Self {
        Self { couple, force }
    }

    /// Adds a load; `stiffness` is `EI₀`.
    pub(super) fn add(&mut self, load: Concentrated, stiffness: f64) {
        let Concentrated { at: _, force, couple } = load;
        self.force += force / stiffness;
        // The moment grows by it, and `v''` falls.
        self.couple -= couple / stiffness;
    }

    /// So many times what acts here.
    pub(super) fn times(self, share: f64) -> Self {
        Self { couple: share * self.couple, force: share * self.force }
    }

    /// True if anything acts.
    pub(super) fn is_any(self) -> bool {
        self.force != 0.0 || self.couple != 0.0
    }

    /// By how much `e v''` jumps.
    pub(super) fn couple(self) -> f64 {
        self.couple
    }

    /// By how much `e v'''` jumps: the force, downwards.
    pub(super) fn force(self) -> f64 {
        self.force
    }

    /// By how much `e v''` and `e v'''` jump.
    pub(super) fn jumps(self) -> [f64; 2] {
        [self.couple, self.force]
    }

    /// The work done by it where the beam has this deflection and slope.
    pub(super) fn work(self, [v, v1]: [f64; 2]) -> f64 {
        self.force * v - self.couple * v1
    }

    /// How large it is as a force, in a beam of this length; what stands on a support goes through it, however large it is.
    pub(super) fn size(self, length: f64, is_on_support: bool) -> f64 {
        (if is_on_support { 0.0 } else { self.force.abs() }) + self.couple.abs() / length
    }
}
