//! The claims ledger: what the paper says, what the numbers say now.
//!
//! A claim has one file: what is measured (a struct of numbers), the verdict that follows from it, and the words. Verdicts
//! are computed; `tests/acceptance/claims.rs` asserts them and the numbers behind them.

pub mod bounds;
pub mod extensions;
pub mod four_step;
pub mod nsor;
pub mod point_forces;
pub mod printed;
pub mod recommendation;
pub mod same_result;
pub mod usable;
mod words;

use crate::scene::SceneError;

/// What became of a claim.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Verdict {
    /// It holds as stated, as far as we measured.
    Confirmed,
    /// It holds under conditions that the paper does not state.
    Qualified,
    /// It does not hold.
    Refuted,
}

impl Verdict {
    /// Its word in tables.
    #[must_use]
    pub fn word(self) -> &'static str {
        match self {
            Self::Confirmed => "confirmed",
            Self::Qualified => "qualified",
            Self::Refuted => "refuted",
        }
    }
}

/// A claim of the paper with its verdict, ready for the ledger.
#[derive(Debug, Clone, PartialEq)]
pub struct Claim {
    /// Short name, also of the test that asserts the verdict.
    pub name: &'static str,
    /// What the paper says, in English.
    pub statement: &'static str,
    /// What became of it.
    pub verdict: Verdict,
    /// Why, with numbers.
    pub evidence: String,
}

/// All claims, in the order of the paper's argument.
///
/// # Errors
///
/// None for the scenes of the paper; the type is that of [`crate::solve`].
pub fn all() -> Result<Vec<Claim>, SceneError> {
    let [shape, pressure] = usable::measure()?.claims();
    let [direct, edge] = four_step::measure()?.claims();
    Ok(vec![
        printed::measure()?.claim(),
        same_result::measure()?.claim(),
        point_forces::measure()?.claim(),
        shape,
        pressure,
        direct,
        edge,
        nsor::measure()?.claim(),
        recommendation::measure()?.claim(),
        bounds::measure()?.claim(),
        extensions::any_body().claim(),
        extensions::elastic_foundation()?.claim(),
        extensions::unknown_rigid_motion()?.claim(),
        extensions::curved_beam()?.claim(),
    ])
}
