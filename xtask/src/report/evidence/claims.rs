//! The ledger: every claim of the paper, the evidence and the verdict.

mod studies;

use minijinja::{Value, context};
use palkki_evidence::paper::claims::four_step::FINEST;
use palkki_evidence::paper::claims::nsor::GRIDS;
use palkki_evidence::paper::claims::{Claim, Verdict};

pub(super) use self::studies::thousands;
use crate::report::error::Cause;
use crate::report::evidence::Evidence;
use crate::report::links::anchor;
use crate::report::study::Study;
use crate::report::table::Table;

pub(super) fn evidence(study: &Study<'_>) -> Result<Evidence, Cause> {
    let ledger = study.ledger()?;
    let claims = ledger.claims();
    let count = |verdict| claims.iter().filter(|claim| claim.verdict == verdict).count();
    let by_grid = ledger.four_step.counts.iter().flat_map(|count| &count.by_grid).map(|(n, _)| *n);
    let summary = claims.iter().map(|claim| {
        let heading = heading(claim);
        [format!("[{heading}](pages/claims.md#{})", anchor(&heading)), verdict(claim), claim.summary.clone()]
    });
    let values = context! {
        total => claims.len(),
        confirmed => count(Verdict::Confirmed),
        qualified => count(Verdict::Qualified),
        refuted => count(Verdict::Refuted),
        open => count(Verdict::Open),
        // For `README.md`.
        summary => Table::new(["claim", "verdict", "evidence"]).rows(summary),
        entries => claims.iter().map(entry).collect::<Vec<_>>(),
        four_step => context! { coarsest => by_grid.min().unwrap_or(0), finest => FINEST },
        nsor => context! { coarsest => GRIDS[0], finest => GRIDS[GRIDS.len() - 1] },
    };
    let (sweeps, sweeps_table) = studies::sweeps(&ledger.nsor)?;
    let (successes, successes_table) = studies::successes(&ledger.four_step)?;
    Ok(Evidence::new(values).figure("nsor-sweeps", sweeps, sweeps_table).figure(
        "four-step-success",
        successes,
        successes_table,
    ))
}

fn entry(claim: &Claim) -> Value {
    context! {
        name => claim.name,
        heading => heading(claim),
        statement => claim.statement,
        verdict => verdict(claim),
        evidence => claim.evidence.clone(),
    }
}

/// `usable_shape` as a heading, `Usable shape`.
fn heading(claim: &Claim) -> String {
    let words = claim.name.replace('_', " ").replace("nsor", "NSOR");
    let mut letters = words.chars();
    letters.next().map_or_else(String::new, |first| first.to_uppercase().chain(letters).collect())
}

/// The verdict, and which reading it is about.
fn verdict(claim: &Claim) -> String {
    let reading = claim.reading.map(|reading| format!(", {reading}"));
    format!("{}{}", claim.verdict.word(), reading.unwrap_or_default())
}
