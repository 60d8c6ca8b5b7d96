//! Beam theory with free lift-off points: closed forms first, then its own conditions on scenes without one.

mod balance;
mod bearings;
mod beside;
mod borders;
mod clearance;
mod closed;
mod coupled;
mod crests;
mod elastic;
mod explain;
mod general;
mod giving;
mod ground;
mod hinges;
mod level;
mod near;
mod opened;
mod pushing;
mod random;
pub(crate) mod settled;
mod springs;
mod sprung;
mod supports;
mod surveys;
mod tension;
mod touching;

use palkki::scene::Scene;
use palkki::theory::{Exact, solve};

/// The answer of beam theory, with all of its conditions met.
#[track_caller]
fn solved(scene: &Scene) -> Exact {
    let exact = solve(scene).expect("an answer");
    assert!(exact.solved, "{:?}, {scene:?}", exact.violations);
    exact
}

/// What an answer may be off by the definition: ten times what the check of beam theory allows.
const OFF: f64 = 1e-11;

/// Of a closed form a handful of operations leaves some digits to spare.
const DIGITS: f64 = 1e-12;

#[track_caller]
fn close(what: &str, found: f64, expected: f64) {
    assert!((found - expected).abs() <= DIGITS * expected.abs().max(1.0), "{what}: {found} instead of {expected}");
}
