//! The ledger: every claim of the paper, the evidence and the verdict.

mod first_screen;
mod studies;

use palkki::paper::claims::four_step::SCENES;
use palkki::paper::claims::nsor::{FINE, GRIDS};
use palkki::paper::claims::{Claim, Ledger, Verdict};
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
    four_step: FourStep,
    nsor: Nsor,
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
struct FourStep {
    grids: usize,
    finest: usize,
    scenes: usize,
    methods: Vec<Successes>,
}

#[derive(Debug, Serialize)]
struct Successes {
    method: &'static str,
    grids: usize,
    waves: usize,
    rough: usize,
}

#[derive(Debug, Serialize)]
struct Nsor {
    coarsest: usize,
    finest: usize,
    fine: usize,
    /// Methods for which it does not converge on the fine grid.
    fails: usize,
    methods: Vec<Growth>,
}

#[derive(Debug, Serialize)]
struct Growth {
    method: &'static str,
    exponent: f64,
    /// Thousands of sweeps on the paper's grid.
    thousands: f64,
}

pub(super) fn evidence(study: &Study<'_>) -> Result<Evidence, Cause> {
    let ledger = study.ledger()?;
    let claims = ledger.claims();
    let count = |verdict| claims.iter().filter(|claim| claim.verdict == verdict).count();
    let (four_step, nsor) = (four_step(ledger), nsor(ledger));
    let values = Values {
        entries: claims.iter().map(entry).collect(),
        confirmed: count(Verdict::Confirmed),
        qualified: count(Verdict::Qualified),
        refuted: count(Verdict::Refuted),
        four_step,
        nsor,
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

/// `usable_shape` as a heading.
fn heading(claim: &Claim) -> String {
    claim.name.replace('_', " ")
}

fn entry(claim: &Claim) -> Entry {
    Entry {
        heading: heading(claim),
        statement: claim.statement,
        verdict: claim.verdict.word(),
        evidence: claim.evidence.clone(),
    }
}

fn four_step(ledger: &Ledger) -> FourStep {
    let found = &ledger.four_step;
    let methods = found.counts.iter().map(|c| Successes {
        method: c.method.word(),
        grids: c.grids,
        waves: c.uneven[0],
        rough: c.uneven[1],
    });
    FourStep {
        grids: found.grids,
        finest: palkki::paper::claims::four_step::FINEST,
        scenes: SCENES,
        methods: methods.collect(),
    }
}

fn nsor(ledger: &Ledger) -> Nsor {
    let counts = &ledger.nsor.counts;
    let methods = counts.iter().map(|c| Growth {
        method: c.method.word(),
        exponent: c.exponent,
        thousands: studies::thousands(c.on_the_paper_grid()),
    });
    Nsor {
        coarsest: GRIDS[0],
        finest: GRIDS[GRIDS.len() - 1],
        fine: FINE,
        fails: counts.iter().filter(|c| !c.converged_at_300).count(),
        methods: methods.collect(),
    }
}
