//! The claims ledger: what the paper says, what the numbers say now.
//!
//! A claim has what is measured (a struct of numbers), the verdict that follows from it, and the words. Verdicts are
//! computed; the acceptance tests assert them and the numbers behind them. The one claim about the literature, that the force
//! method was new, cannot be decided by computing and stays open; another is open because what was computed does not decide it.

pub mod accuracy;
pub mod curved;
pub mod energy_methods;
pub mod extensions;
pub mod four_step;
pub mod nsor;

use palkki::scene::SceneError;
use palkki::text::power_of_ten;

/// What became of a claim.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Verdict {
    /// It holds as stated, as far as we measured.
    Confirmed,
    /// It holds under conditions that the paper does not state.
    Qualified,
    /// It does not hold.
    Refuted,
    /// No computation decides it: none can, or none has.
    Open,
}

impl Verdict {
    /// Its word in tables.
    #[must_use]
    pub fn name(self) -> &'static str {
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
    pub printed: accuracy::Printed,
    /// Force and displacement method against each other.
    pub same_result: energy_methods::SameResult,
    /// Cubic elements under point forces.
    pub point_forces: accuracy::PointForces,
    /// Shape and pressure on coarse grids.
    pub usable: accuracy::Usable,
    /// The four steps, on many grids and foundations.
    pub four_step: four_step::Evidence,
    /// Sweeps of NSOR.
    pub nsor: nsor::Evidence,
    /// Digits with and without the matrices.
    pub recommendation: energy_methods::Recommendation,
    /// Energies and penetration.
    pub bounds: energy_methods::BothSides,
    /// A body that is no beam.
    pub any_body: extensions::Taut,
    /// Springs for a foundation.
    pub elastic_foundation: extensions::Springs,
    /// No supports.
    pub unknown_rigid_motion: extensions::Unsupported,
    /// A ski.
    pub curved_beam: curved::Curved,
}

impl Ledger {
    /// Measures everything. It takes some seconds, most of them for NSOR.
    ///
    /// # Errors
    ///
    /// None for the scenes of the paper; the type is that of [`palkki::solve`].
    pub fn measure() -> Result<Self, SceneError> {
        Ok(Self {
            printed: accuracy::printed()?,
            same_result: energy_methods::same_result()?,
            point_forces: accuracy::point_forces()?,
            usable: accuracy::usable()?,
            four_step: four_step::measure()?,
            nsor: nsor::measure()?,
            recommendation: energy_methods::recommendation()?,
            bounds: energy_methods::both_sides()?,
            any_body: extensions::any_body(),
            elastic_foundation: extensions::elastic_foundation()?,
            unknown_rigid_motion: extensions::unknown_rigid_motion()?,
            curved_beam: curved::curved_beam()?,
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
            energy_methods::novelty(),
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

/// What a number of rounding size stays below: the power of ten that is at least three times as large, so that another
/// machine says the same; `0` for zero. A power of ten that was chosen and not computed is itself.
#[must_use]
pub fn bound(value: f64) -> String {
    if value == 0.0 {
        return "0".to_owned();
    }
    let printed = format!("{:e}", value.abs());
    let (mantissa, exponent) = printed.split_once('e').unwrap_or((&printed, "0"));
    let mantissa: f64 = mantissa.parse().unwrap_or(1.0);
    let margin = [1.0, 10.0 / 3.0].iter().filter(|limit| **limit < mantissa).count();
    power_of_ten(exponent.parse().unwrap_or(0) + i32::try_from(margin).unwrap_or(0))
}

#[cfg(test)]
mod tests {
    use super::bound;

    #[test]
    fn bounds_are_above() {
        assert_eq!([2e-12, 0.9e-9, 0.3, 20.0, 0.0].map(bound), ["10⁻¹¹", "10⁻⁸", "10⁰", "10²", "0"]);
        assert_eq!([4e-12, 1e-4].map(bound), ["10⁻¹⁰", "10⁻⁴"]);
    }
}
