//! Random uneven foundations with a fixed seed, for claims that one example cannot decide.

use super::scene_over;
use crate::scene::{Foundation, Scene, SceneError};

/// A small generator of random numbers (SplitMix64, Steele, Lea and Flood 2014): the same numbers on every machine.
#[derive(Debug, Clone)]
pub struct Random(u64);

impl Random {
    /// A generator that starts from `seed`.
    #[must_use]
    pub fn new(seed: u64) -> Self {
        Self(seed)
    }

    /// The next 64 bits.
    pub fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// The next number, uniform between `from` and `to`.
    #[expect(clippy::cast_precision_loss, reason = "53 bits fit")]
    pub fn between(&mut self, from: f64, to: f64) -> f64 {
        from + (to - from) * ((self.bits() >> 11) as f64 / (1_u64 << 53) as f64)
    }

    /// One of `0 … count − 1`; 0 if there is none.
    pub fn below(&mut self, count: usize) -> usize {
        let count = u64::try_from(count).unwrap_or(u64::MAX).max(1);
        // A remainder is smaller than the count, and so fits as well.
        usize::try_from(self.bits() % count).unwrap_or(0)
    }
}

/// Two kinds of unevenness.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Unevenness {
    /// A cosine wave.
    Wave,
    /// A polyline through twelve random depths.
    Rough,
}

impl Unevenness {
    /// Both.
    pub const ALL: [Self; 2] = [Self::Wave, Self::Rough];

    /// Its name in tables.
    #[must_use]
    pub fn word(self) -> &'static str {
        match self {
            Self::Wave => "waves",
            Self::Rough => "rough polylines",
        }
    }
}

/// `count` foundations of one kind below the beam and load of the example: mean depth `u₀`, unevenness up to half of it, so
/// that the supports stay free.
///
/// # Errors
///
/// None: all depths are positive. The type is that of [`scene_over`].
pub fn scenes(kind: Unevenness, count: usize, seed: u64) -> Result<Vec<Scene>, SceneError> {
    let mut random = Random::new(seed);
    (0..count).map(|_| scene_over(foundation(kind, &mut random))).collect()
}

fn foundation(kind: Unevenness, random: &mut Random) -> Foundation {
    match kind {
        Unevenness::Wave => Foundation::Cosine {
            mean: 1.0,
            amplitude: random.between(0.05, 0.5),
            wavelength: random.between(1.5, 12.0),
            phase: random.between(0.0, 6.25),
        },
        Unevenness::Rough => {
            let points = (0..=11).map(|k| [10.0 * f64::from(k) / 11.0, random.between(0.5, 1.5)]).collect();
            Foundation::Polyline { points }
        }
    }
}
