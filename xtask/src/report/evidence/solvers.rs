//! The solvers, their settings, the judge, and where a solver's own word and the judge disagree.

mod corpus;
mod word;

use palkki::DEFAULT_TOLERANCE;
use palkki::certificate::CERTIFIED_RESIDUAL;
use palkki::route::Solver;
use serde::Serialize;

use crate::report::error::Cause;
use crate::report::evidence::Evidence;
use crate::report::numbers::power;
use crate::report::study::Study;

#[derive(Debug, Serialize)]
struct Values {
    settings: Vec<Setting>,
    /// Threshold of the judge, and what the solvers are asked for, as powers of ten.
    threshold: String,
    asked: String,
    word: word::Values,
    corpus: corpus::Values,
}

#[derive(Debug, Serialize)]
struct Setting {
    solver: &'static str,
    words: String,
}

pub(super) fn evidence(study: &Study<'_>) -> Result<Evidence, Cause> {
    let settings =
        Solver::ALL.map(|solver| Setting { solver: solver.word(), words: solver.settings(DEFAULT_TOLERANCE) });
    let (word, table) = word::against_the_judge(study.root)?;
    let values = Values {
        settings: settings.into(),
        threshold: exactly_a_power(CERTIFIED_RESIDUAL),
        asked: exactly_a_power(DEFAULT_TOLERANCE),
        word,
        corpus: corpus::evidence()?,
    };
    Ok(Evidence::new(values).data("own-word", table))
}

/// A tolerance that is a power of ten, in words; as it is if it is none.
fn exactly_a_power(value: f64) -> String {
    let scientific = format!("{value:e}");
    let exponent = scientific.strip_prefix("1e").and_then(|exponent| exponent.parse().ok());
    exponent.map_or(scientific.clone(), power)
}
