//! The claims ledger: what the paper says, what the numbers say now.
//!
//! A claim has one file: what is measured (a struct of numbers), the verdict that follows from it, and the words. Verdicts
//! are computed; `tests/acceptance/claims.rs` asserts them and the numbers behind them. The one claim about the literature,
//! [`novelty`], cannot be decided by computing and stays open.

pub mod bounds;
pub mod extensions;
pub mod four_step;
pub mod novelty;
pub mod nsor;
pub mod point_forces;
pub mod printed;
pub mod recommendation;
pub mod same_result;
pub mod usable;
mod words;

use palkki::scene::SceneError;

/// What became of a claim.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Verdict {
    /// It holds as stated, as far as we measured.
    Confirmed,
    /// It holds under conditions that the paper does not state.
    Qualified,
    /// It does not hold.
    Refuted,
    /// No computation can decide it.
    Open,
}

impl Verdict {
    /// Its word in tables.
    #[must_use]
    pub fn word(self) -> &'static str {
        match self {
            Self::Confirmed => "confirmed",
            Self::Qualified => "qualified",
            Self::Refuted => "refuted",
            Self::Open => "open",
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
    /// Which of two readings the verdict is about, where the words of the paper allow two.
    pub reading: Option<&'static str>,
    /// Why, in a few words with a number.
    pub summary: String,
    /// Why, with numbers.
    pub evidence: String,
}

/// Everything that is measured for the ledger, so that tables and figures can quote the numbers behind the words.
#[derive(Debug, Clone, PartialEq)]
pub struct Ledger {
    /// The two printed numbers.
    pub printed: printed::Evidence,
    /// Force and displacement method against each other.
    pub same_result: same_result::Evidence,
    /// Cubic elements under point forces.
    pub point_forces: point_forces::Evidence,
    /// Shape and pressure on coarse grids.
    pub usable: usable::Evidence,
    /// The four steps, on many grids and foundations.
    pub four_step: four_step::Evidence,
    /// Sweeps of NSOR.
    pub nsor: nsor::Evidence,
    /// Digits with and without the matrices.
    pub recommendation: recommendation::Evidence,
    /// Energies and penetration.
    pub bounds: bounds::Evidence,
    /// A body that is no beam.
    pub any_body: extensions::Taut,
    /// Springs for a foundation.
    pub elastic_foundation: extensions::Springs,
    /// No supports.
    pub unknown_rigid_motion: extensions::Unsupported,
    /// A ski.
    pub curved_beam: extensions::Curved,
}

impl Ledger {
    /// Measures everything. It takes some seconds, most of them for NSOR.
    ///
    /// # Errors
    ///
    /// None for the scenes of the paper; the type is that of [`palkki::solve`].
    pub fn measure() -> Result<Self, SceneError> {
        Ok(Self {
            printed: printed::measure()?,
            same_result: same_result::measure()?,
            point_forces: point_forces::measure()?,
            usable: usable::measure()?,
            four_step: four_step::measure()?,
            nsor: nsor::measure()?,
            recommendation: recommendation::measure()?,
            bounds: bounds::measure()?,
            any_body: extensions::any_body(),
            elastic_foundation: extensions::elastic_foundation()?,
            unknown_rigid_motion: extensions::unknown_rigid_motion()?,
            curved_beam: extensions::curved_beam()?,
        })
    }

    /// All claims with their verdicts, in the order of the paper's argument.
    #[must_use]
    pub fn claims(&self) -> Vec<Claim> {
        let [shape, pressure] = self.usable.claims();
        let [direct, edge] = self.four_step.claims();
        vec![
            self.printed.claim(),
            self.same_result.claim(),
            novelty::claim(),
            self.point_forces.claim(),
            shape,
            pressure,
            direct,
            edge,
            self.nsor.claim(),
            self.recommendation.claim(),
            self.bounds.claim(),
            self.any_body.claim(),
            self.elastic_foundation.claim(),
            self.unknown_rigid_motion.claim(),
            self.curved_beam.claim(),
        ]
    }
}

/// All claims, in the order of the paper's argument.
///
/// # Errors
///
/// As [`Ledger::measure`].
pub fn all() -> Result<Vec<Claim>, SceneError> {
    Ok(Ledger::measure()?.claims())
}
