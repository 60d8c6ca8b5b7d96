//! Surveys of any number of points, as a laser gives them: what time and memory over the number of points is measured on.
//!
//! No closed form knows their answers: routes are compared with each other.

use crate::random::Random;
use palkki::scene::{Beam, Foundation, Load, Scene, SceneError};

/// What the ground is like.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Ground {
    /// Each point lies a random step above or below the one before: rough on every scale.
    Walk,
    /// Each point has a random depth of its own: the beam rests on few of the highest.
    Noise,
    /// 39 waves of random heights: under a heavy load the beam lies on much of it.
    Smooth,
}

/// Waves of smooth ground; the shortest has so many half waves over the beam.
const WAVES: u32 = 39;

/// Length and bending stiffness of the beam.
const LENGTH: f64 = 10.0;
const STIFFNESS: f64 = 1.3;

/// Depth of the highest point of the ground below the supports; the lowest lies 1 deeper.
const SHALLOWEST: f64 = 0.01;

/// The seed of those that are measured: a longer survey is another one.
const SEED: u64 = 0x1a5e;

impl Ground {
    /// All of them, as tables list them.
    pub const ALL: [Self; 3] = [Self::Walk, Self::Noise, Self::Smooth];

    /// Its name in tables.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Walk => "random walk",
            Self::Noise => "white noise",
            Self::Smooth => "smooth",
        }
    }

    /// Heights at the ends of so many equal segments, of any size.
    fn heights(self, seed: u64, segments: u32) -> Vec<f64> {
        let mut random = Random::new(seed);
        match self {
            Self::Walk => {
                let mut height = 0.0;
                let step = |_| {
                    height += random.between(-1.0, 1.0);
                    height
                };
                (0..=segments).map(step).collect()
            }
            Self::Noise => (0..=segments).map(|_| random.between(-1.0, 1.0)).collect(),
            Self::Smooth => {
                let turn = std::f64::consts::TAU;
                let mut wave = |k: u32| {
                    let height = random.between(-1.0, 1.0) / f64::from(k).sqrt();
                    [height, 0.5 * turn * f64::from(k), random.between(0.0, turn)]
                };
                let waves: Vec<[f64; 3]> = (1..=WAVES).map(&mut wave).collect();
                let height = |i: u32| {
                    let s = f64::from(i) / f64::from(segments);
                    waves.iter().map(|[a, rate, phase]| a * libm::sin(rate * s + phase)).sum()
                };
                (0..=segments).map(height).collect()
            }
        }
    }
}

/// A beam of length 10 and bending stiffness 1.3 under the uniform load `load`, above a survey with this many equal segments,
/// whose depths reach from 0.01 to 1.01.
///
/// # Errors
///
/// A [`SceneError`] for a load that is no number, and for no segment at all.
pub fn survey(ground: Ground, segments: u32, load: f64) -> Result<Scene, SceneError> {
    survey_from(ground, SEED, segments, load)
}

/// One of any number of such surveys.
///
/// # Errors
///
/// Those of [`survey`].
pub fn survey_from(ground: Ground, seed: u64, segments: u32, load: f64) -> Result<Scene, SceneError> {
    let heights = ground.heights(seed, segments);
    let range = heights.iter().fold([f64::INFINITY, f64::NEG_INFINITY], |[lo, hi], h| [lo.min(*h), hi.max(*h)]);
    let depth = |height: f64| SHALLOWEST + (height - range[0]) / (range[1] - range[0]);
    let place = |i: u32| LENGTH * (f64::from(i) / f64::from(segments));
    let points = (0..=segments).zip(heights).map(|(i, height)| [place(i), depth(height)]).collect();
    let beam = Beam::new(LENGTH, STIFFNESS)?;
    Scene::new(beam.clone(), Load::uniform_on(&beam, load)?, Some(Foundation::Polyline { points }))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn surveys_have_the_height_that_they_are_said_to_have() {
        for ground in Ground::ALL {
            let scene = survey(ground, 1000, 1.0).expect("a scene");
            let Some(Foundation::Polyline { points }) = scene.foundation() else { panic!("a survey") };
            let depths = || points.iter().map(|point| point[1]);
            assert_eq!(points.len(), 1001);
            assert!((depths().fold(f64::INFINITY, f64::min) - 0.01).abs() < 1e-15);
            assert!((depths().fold(0.0, f64::max) - 1.01).abs() < 1e-15);
        }
    }

    #[test]
    fn a_survey_without_segments_is_refused() {
        assert!(survey(Ground::Noise, 0, 1.0).is_err() && survey(Ground::Walk, 10, f64::NAN).is_err());
    }
}
