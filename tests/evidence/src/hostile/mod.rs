//! Runs of the whole program on random and adversarial scenes, each from its seed: what comes out is right, or is not certified.
//! The acceptance suite makes the first few, `cargo xtask hostile` as many as it is asked for.

mod alike;
mod derivatives;
mod edges;
mod energies;
mod fractions;
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

/// The first seeds of the second, the third and the fourth dice, see [`seeds`].
pub(crate) const SECOND: u64 = 1 << 32;
pub(crate) const THIRD: u64 = 1 << 33;
pub(crate) const FOURTH: u64 = 1 << 34;

/// The seeds of so many runs: of every six, two of the first dice, one of the second, one of the third and two of the fourth.
pub fn seeds(runs: std::ops::Range<u64>) -> impl Iterator<Item = u64> {
    runs.map(|run| match run % 6 {
        2 => SECOND + run / 6,
        3 => THIRD + run / 6,
        4 | 5 => FOURTH + 2 * (run / 6) + run % 6 - 4,
        first => 2 * (run / 6) + first,
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
