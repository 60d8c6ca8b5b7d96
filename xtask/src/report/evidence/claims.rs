//! The ledger: every claim of the paper, the evidence and the verdict.

mod first_screen;
mod studies;

use palkki::paper::claims::four_step::FINEST;
use palkki::paper::claims::nsor::GRIDS;
use palkki::paper::claims::{Claim, Verdict};
use serde::Serialize;

pub(super) use self::first_screen::worst;
pub(super) use self::studies::thousands;
use crate::report::error::Cause;
use crate::report::evidence::Evidence;
use crate::report::study::Study;
use crate::report::verdict::Row;

#[derive(Debug, Serialize)]
struct Values {
    entries: Vec<Entry>,
    confirmed: usize,
    qualified: usize,
    refuted: usize,
    /// What the two figures cover.
    four_step: Grids,
    nsor: Grids,
    /// Lines of the verdict table: the printed numbers, the other claims.
    numbers: Vec<Row>,
    verdicts: Vec<Row>,
}

/// A claim as it is printed.
#[derive(Debug, Serialize)]
struct Entry {
    heading: String,
    statement: &'static str,
    verdict: &'static str,
    evidence: String,
}

#[derive(Debug, Serialize)]
struct Grids {
    coarsest: usize,
    finest: usize,
}

pub(super) fn evidence(study: &Study<'_>) -> Result<Evidence, Cause> {
    let ledger = study.ledger()?;
    let claims = ledger.claims();
    let count = |verdict| claims.iter().filter(|claim| claim.verdict == verdict).count();
    let by_grid = ledger.four_step.counts.iter().flat_map(|count| &count.by_grid).map(|(n, _)| *n);
    let values = Values {
        entries: claims.iter().map(entry).collect(),
        confirmed: count(Verdict::Confirmed),
        qualified: count(Verdict::Qualified),
        refuted: count(Verdict::Refuted),
        four_step: Grids { coarsest: by_grid.min().unwrap_or(0), finest: FINEST },
        nsor: Grids { coarsest: GRIDS[0], finest: GRIDS[GRIDS.len() - 1] },
        numbers: first_screen::numbers(ledger),
        verdicts: first_screen::rows(ledger, &claims)?,
    };
    let (sweeps, sweeps_table) = studies::sweeps(&ledger.nsor)?;
    let (successes, successes_table) = studies::successes(&ledger.four_step)?;
    Ok(Evidence::new(values).figure("nsor-sweeps", sweeps, sweeps_table).figure(
        "four-step-success",
        successes,
        successes_table,
    ))
}

/// `usable_shape` as a heading, `Usable shape`.
fn heading(claim: &Claim) -> String {
    let words = claim.name.replace('_', " ").replace("nsor", "NSOR");
    let mut letters = words.chars();
    letters.next().map_or_else(String::new, |first| first.to_uppercase().chain(letters).collect())
}

fn entry(claim: &Claim) -> Entry {
    Entry {
        heading: heading(claim),
        statement: claim.statement,
        verdict: claim.verdict.word(),
        evidence: claim.evidence.clone(),
    }
}
