//! Random uneven foundations with a fixed seed, for claims that one example cannot decide.

use super::scene_over;
use crate::random::Random;
use palkki::scene::{Foundation, Scene, SceneError};

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
    pub fn name(self) -> &'static str {
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
