//! The claims ledger: what the paper says, what the numbers say now.
//!
//! A claim is one function: it measures, asserts what its words rest on, and returns the verdict with the numbers. The words are in
//! `report/templates/claims.md`. Claims about the literature cannot be decided by computing and stay open.

pub mod accuracy;
mod advice;
pub mod curved;
pub mod energy_methods;
mod extensions;
pub mod four_step;
pub mod nsor;

use palkki::scene::SceneError;
use palkki::text::power_of_ten;
use serde_json::{Value, json};

/// What became of a claim.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Verdict {
    /// It is true as stated, as far as we measured.
    Confirmed,
    /// It is true under conditions that the paper does not state.
    Qualified,
    /// It is not true.
    Refuted,
    /// No computation decides it: none can, or none has.
    Open,
    /// No claim, but work that the paper names for the future. It is not counted.
    Outlook,
}

impl Verdict {
    /// Of a claim that holds as stated or does not.
    fn of(holds: bool) -> Self {
        if holds { Self::Confirmed } else { Self::Refuted }
    }

    /// Its word in tables.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Confirmed => "confirmed",
            Self::Qualified => "qualified",
            Self::Refuted => "refuted",
            Self::Open => "open",
            Self::Outlook => "outlook",
        }
    }
}

/// A claim of the paper, what became of it and the numbers of its words.
#[derive(Debug, Clone, PartialEq)]
pub struct Claim {
    /// Its name in the template.
    pub name: &'static str,
    /// What became of it.
    pub verdict: Verdict,
    /// What its words quote.
    pub numbers: Value,
}

/// Everything that is measured for the ledger, with the numbers that other tables and figures quote.
#[derive(Debug, Clone, PartialEq)]
pub struct Ledger {
    /// All claims with their verdicts, in the order of the paper's argument.
    pub claims: Vec<Claim>,
    /// Errors on the paper's grid, the coarser one that it calls usable, and a fine one.
    pub grids: [accuracy::Errors; 3],
    /// The four steps by each method, on many grids and foundations.
    pub four_step: Vec<four_step::Count>,
    /// Sweeps of NSOR by each method.
    pub nsor: Vec<nsor::Count>,
    /// Digits with and without the matrices.
    pub digits: [energy_methods::Digits; 2],
}

/// A claim about what had been published by 1984.
fn of_the_literature(name: &'static str) -> Claim {
    Claim { name, verdict: Verdict::Open, numbers: json!({}) }
}

impl Ledger {
    /// Measures everything. It takes some seconds, most of them for NSOR.
    ///
    /// # Errors
    ///
    /// None for the scenes of the paper; the type is that of [`palkki::solve`].
    ///
    /// # Panics
    ///
    /// If something does not hold on which the words of a claim rest.
    pub fn measure() -> Result<Self, SceneError> {
        let grids = accuracy::grids()?;
        let (four_step, nsor, digits) = (four_step::measure()?, nsor::measure()?, energy_methods::digits_lost()?);
        let [direct, edge] = four_step::claims(&four_step);
        let claims = vec![
            accuracy::printed_numbers()?,
            energy_methods::same_result()?,
            of_the_literature("novelty_of_the_force_method"),
            of_the_literature("discretised_before"),
            advice::one_solution()?,
            advice::meaning_of_the_gradient()?,
            accuracy::exact_for_point_forces()?,
            accuracy::usable_shape(&grids),
            accuracy::usable_pressure(&grids)?,
            direct,
            edge,
            nsor::claim(&nsor),
            advice::energy_methods_preferred()?,
            energy_methods::whichever_matrix_is_easier(&digits)?,
            energy_methods::bounded_from_both_sides()?,
            advice::settled_foundations(),
            extensions::any_elastic_body()?,
            extensions::elastic_foundation()?,
            extensions::unknown_rigid_motion()?,
            curved::curved_beam()?,
        ];
        Ok(Self { claims, grids, four_step, nsor, digits })
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
