//! Beds: level, with steps, corrugated, and as a survey reads them.

use palkki::scene::Foundation;

use crate::random::Random;

/// What a bed is like \[m\].
#[derive(Debug, Clone, Copy)]
pub(super) enum Bed {
    /// Level with the beam.
    Level,
    /// Some parts of so many metres lie deeper, by up to so much.
    Steps {
        /// Length of a part.
        apart: f64,
        /// Greatest depth.
        high: f64,
    },
    /// A survey of waves, of 1/3 to 1/30 of the beam, and noise.
    Waves {
        /// How many points it has, besides the first.
        readings: u32,
        /// Amplitude.
        high: f64,
        /// That of the noise.
        rough: f64,
        /// Depth of the mean.
        datum: f64,
    },
    /// One cosine.
    Corrugated {
        /// Amplitude.
        high: f64,
        /// Wavelength.
        wavelength: f64,
    },
}

/// Such a bed of that length.
pub(super) fn bed(random: &mut Random, length: f64, kind: Bed) -> Foundation {
    match kind {
        Bed::Level => Foundation::Flat { depth: 0.0 },
        Bed::Steps { apart, high } => {
            let mut points = vec![[0.0, 0.0]];
            let mut level = 0.0;
            let parts = (length / apart) as u32;
            for part in 1..parts {
                let next = if random.once_in(4) { libm::round(random.between(0.0, high) * 1e4) / 1e4 } else { 0.0 };
                if (next - level).abs() > 1e-9 {
                    let x = f64::from(part) * apart;
                    points.extend([[x, level], [x, next]]);
                    level = next;
                }
            }
            points.push([length, level]);
            Foundation::Polyline { points }
        }
        Bed::Waves { readings, high, rough, datum } => {
            let waves = [3.0, 8.0, 30.0].map(|count: f64| {
                let height = high * random.between(0.3, 1.0) / libm::sqrt(count);
                (height, std::f64::consts::TAU * count * random.between(0.7, 1.3), random.between(0.0, 6.0))
            });
            let point = |k: u32| {
                let share = f64::from(k) / f64::from(readings);
                let sum: f64 = waves.iter().map(|(height, rate, phase)| height * libm::sin(rate * share + phase)).sum();
                // Surveys are read to a millimetre.
                [share * length, libm::round((datum + sum + rough * random.between(-1.0, 1.0)) * 1e3) / 1e3]
            };
            Foundation::Polyline { points: (0..=readings).map(point).collect() }
        }
        Bed::Corrugated { high, wavelength } => {
            Foundation::Cosine { mean: 0.0, amplitude: high, wavelength, phase: random.between(0.0, 6.0) }
        }
    }
}
