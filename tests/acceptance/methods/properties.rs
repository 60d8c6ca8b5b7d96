//! Properties that hold for any scene: symmetry, units, superposition, equilibrium, monotonicity.
//!
//! Random scenes come from a generator with a fixed seed, so that a failure is the same on every machine.

mod superposition;
mod symmetry;
mod uneven;
mod units;

use palkki::scene::{Beam, Foundation, LinearLoad, Load, PointLoad, Scene};
use palkki_evidence::random::Random;

/// A random scene, made of numbers that a test can change one at a time.
#[derive(Debug, Clone)]
struct Parts {
    length: f64,
    stiffness: f64,
    uniform: f64,
    linear: Vec<LinearLoad>,
    point: Vec<PointLoad>,
    /// `[x, depth]`
    points: Vec<[f64; 2]>,
}

impl Parts {
    /// Twelve depths between nothing and a fifth of what the free beam would deflect, all three kinds of load.
    fn random(random: &mut Random) -> Self {
        let length = random.between(3.0, 20.0);
        let stiffness = random.between(0.5, 50.0);
        let uniform = random.between(0.2, 2.0);
        let deflection = 5.0 * uniform * length * length * length * length / (384.0 * stiffness);
        let (from, to) = (random.between(0.0, 0.4), random.between(0.5, 1.0));
        Self {
            length,
            stiffness,
            uniform,
            linear: vec![LinearLoad {
                from: from * length,
                to: to * length,
                start: random.between(0.0, uniform),
                end: random.between(0.0, uniform),
            }],
            point: vec![PointLoad {
                at: random.between(0.0, length),
                force: random.between(0.0, 0.3 * uniform * length),
            }],
            points: (0..=11)
                // The last point lies on the support, not beside it by rounding.
                .map(|k| if k < 11 { length * f64::from(k) / 11.0 } else { length })
                .map(|x| [x, random.between(0.02, 0.2) * deflection])
                .collect(),
        }
    }

    fn beam(&self) -> Beam {
        Beam::new(self.length, self.stiffness).expect("positive numbers")
    }

    fn scene(&self) -> Scene {
        let load = Load::new(&self.beam(), self.uniform, self.linear.clone(), self.point.clone());
        let foundation = Foundation::Polyline { points: self.points.clone() };
        Scene::new(self.beam(), load.expect("loads on the beam"), Some(foundation)).expect("a scene")
    }
}

/// A few random scenes.
fn some(count: usize, seed: u64) -> Vec<Parts> {
    let mut random = Random::new(seed);
    (0..count).map(|_| Parts::random(&mut random)).collect()
}

/// Rounding of the structured solves, whose condition numbers are n² at most, relative to load and deflection.
const ROUNDING: f64 = 1e-10;
