//! Runs of the whole program on random and adversarial scenes, each from its seed: what comes out is right, or is not certified.
//! The acceptance suite makes the first few, `cargo xtask hostile` as many as it is asked for.

mod edges;
mod held;
mod laws;
mod near;
mod refusals;
mod scenes;
mod tally;
mod trial;
mod units;

pub use scenes::Family;
pub use tally::{Count, Tally};

/// The first seeds of the second and of the third dice, see [`seeds`].
pub(crate) const SECOND: u64 = 1 << 32;
pub(crate) const THIRD: u64 = 1 << 33;

/// The seeds of so many runs: of every four, two of the first dice and one of each of the others.
pub fn seeds(runs: std::ops::Range<u64>) -> impl Iterator<Item = u64> {
    runs.map(|run| match run % 4 {
        2 => SECOND + run / 4,
        3 => THIRD + run / 4,
        first => 2 * (run / 4) + first,
    })
}

/// The scene file of a run, and what is wrong with it as comments.
#[must_use]
pub fn scene(seed: u64) -> String {
    let (family, draft, _) = trial::draft(seed);
    let (_, trial) = trial::run(seed);
    let wrong: String = trial.wrong.iter().map(|what| format!("# {what}\n")).collect();
    format!("# {}\n{wrong}{}", family.name(), draft.text())
}
