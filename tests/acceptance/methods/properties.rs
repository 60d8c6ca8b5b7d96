//! Properties that hold for any scene: complementarity, superposition, monotonicity.
//!
//! Random scenes come from a generator with a fixed seed, so that a failure is the same on every machine.

mod complementarity;
mod superposition;
mod uneven;

use palkki::scene::{Foundation, LinearLoad, PointLoad, Scene};
use palkki_evidence::draft::Draft;
use palkki_evidence::random::Random;

/// A random scene: twelve depths between nothing and a fifth of what the free beam would deflect, all three kinds of load.
fn draft(random: &mut Random) -> Draft {
    let length = random.between(3.0, 20.0);
    let stiffness = random.between(0.5, 50.0);
    let uniform = random.between(0.2, 2.0);
    let deflection = 5.0 * uniform * length * length * length * length / (384.0 * stiffness);
    let (from, to) = (random.between(0.0, 0.4), random.between(0.5, 1.0));
    let (start, end) = (random.between(0.0, uniform), random.between(0.0, uniform));
    let linear = LinearLoad { from: from * length, to: to * length, start, end };
    let point = PointLoad { at: random.between(0.0, length), force: random.between(0.0, 0.3 * uniform * length) };
    // The last point lies on the support, not beside it by rounding.
    let places = (0..=11).map(|k| if k < 11 { length * f64::from(k) / 11.0 } else { length });
    let points = places.map(|x| [x, random.between(0.02, 0.2) * deflection]).collect();
    let ground = Some(Foundation::Polyline { points });
    Draft { length, stiffness, uniform, linear: vec![linear], point: vec![point], ground, ..Draft::default() }
}

/// The points of its ground.
fn points(draft: &mut Draft) -> &mut Vec<[f64; 2]> {
    match &mut draft.ground {
        Some(Foundation::Polyline { points }) => points,
        other => panic!("{other:?} is no polyline"),
    }
}

fn scene(draft: &Draft) -> Scene {
    draft.scene().expect("a scene")
}

/// A few random scenes.
fn some(count: usize, seed: u64) -> Vec<Draft> {
    let mut random = Random::new(seed);
    (0..count).map(|_| draft(&mut random)).collect()
}

/// Rounding of the structured solves, whose condition numbers are n² at most, relative to load and deflection.
const ROUNDING: f64 = 1e-10;
