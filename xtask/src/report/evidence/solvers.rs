//! The solvers, their settings, our check, and how far a solver's own criterion and our check agree.

mod corpus;
mod word;

use minijinja::context;
use palkki::DEFAULT_TOLERANCE;
use palkki::certificate::CERTIFIED_RESIDUAL;
use palkki::route::Solver;

use crate::report::error::Cause;
use crate::report::evidence::Evidence;
use crate::report::numbers::power;
use crate::report::study::Study;
use crate::report::table::Table;

pub(super) fn evidence(study: &Study<'_>) -> Result<Evidence, Cause> {
    let settings = Solver::ALL.map(|solver| [solver.word().to_owned(), solver.settings(DEFAULT_TOLERANCE)]);
    let (word, runs) = word::evidence(study.root)?;
    let (corpus, instances) = corpus::evidence()?;
    let values = context! {
        settings => Table::new(["solver", "settings"]).rows(settings),
        threshold => exactly_a_power(CERTIFIED_RESIDUAL),
        asked => exactly_a_power(DEFAULT_TOLERANCE),
        word,
        corpus,
    };
    Ok(Evidence::new(values).data("solver-runs", runs).data("exchanges", instances))
}

/// A tolerance that is a power of ten, in words; as it is if it is none.
fn exactly_a_power(value: f64) -> String {
    let scientific = format!("{value:e}");
    let exponent = scientific.strip_prefix("1e").and_then(|exponent| exponent.parse().ok());
    exponent.map_or(scientific.clone(), power)
}
