//! Runs of the whole program on random and adversarial scenes, each from its seed: what comes out is right, or is not certified.
//! The acceptance suite makes the first few, `cargo xtask hostile` as many as it is asked for.

mod alike;
mod brought;
mod derivatives;
mod edges;
mod energies;
mod fractions;
mod general;
mod held;
pub(crate) mod laws;
mod moving;
mod near;
mod refusals;
mod scenes;
mod supports;
mod tally;
mod trial;
mod units;

use crate::draft::Draft;

pub use scenes::Family;
pub use tally::{Count, Tally};

/// The first seeds of the second to the fifth dice, see [`seeds`].
pub(crate) const SECOND: u64 = 1 << 32;
pub(crate) const THIRD: u64 = 1 << 33;
pub(crate) const FOURTH: u64 = 1 << 34;
pub(crate) const FIFTH: u64 = 1 << 35;

/// The seeds of so many runs: of every eight, two of the first dice, one of the second, one of the third, two of the fourth and two of the
/// fifth.
pub fn seeds(runs: std::ops::Range<u64>) -> impl Iterator<Item = u64> {
    runs.map(|run| match run % 8 {
        2 => SECOND + run / 8,
        3 => THIRD + run / 8,
        4 | 5 => FOURTH + 2 * (run / 8) + run % 8 - 4,
        6 | 7 => FIFTH + 2 * (run / 8) + run % 8 - 6,
        first => 2 * (run / 8) + first,
    })
}

/// What is wrong with the answers to a scene: all laws of the fourth dice.
#[must_use]
pub fn wrong(draft: &Draft) -> Vec<String> {
    trial::wrong(draft)
}

/// The scene of a run, if it is one.
#[must_use]
pub fn draft(seed: u64) -> Draft {
    trial::draft(seed).1
}

/// The scene file of a run, and what is wrong with it as comments.
#[must_use]
pub fn scene(seed: u64) -> String {
    let (family, draft, _) = trial::draft(seed);
    let (_, trial) = trial::run(seed);
    let wrong: String = trial.wrong.iter().map(|what| format!("# {what}\n")).collect();
    format!("# {}\n{wrong}{}", family.name(), draft.text())
}
