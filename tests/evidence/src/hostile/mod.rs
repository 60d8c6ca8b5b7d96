//! Runs of the whole program on random and adversarial scenes, each from its seed: what comes out is right, or is not certified.
//! The acceptance suite makes the first few, `cargo xtask hostile` as many as it is asked for.

mod draft;
mod edges;
mod laws;
mod scenes;
mod tally;
mod trial;
mod units;

pub use scenes::Family;
pub use tally::{Count, Tally};

/// The scene file of a run, and what is wrong with it as comments.
#[must_use]
pub fn scene(seed: u64) -> String {
    let (family, draft, _) = trial::draft(seed);
    let (_, trial) = trial::run(seed);
    let wrong: String = trial.wrong.iter().map(|what| format!("# {what}\n")).collect();
    format!("# {}\n{wrong}{}", family.name(), draft.text())
}
