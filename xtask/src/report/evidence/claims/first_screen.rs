//! The ledger in the words of the verdict table: one line for each claim.

use palkki::paper::claims::usable::Errors;
use palkki::paper::claims::{Claim, Ledger};
use palkki::paper::{PRINTED_FORCE, PRINTED_REACTION};

use super::heading;
use crate::report::error::Cause;
use crate::report::numbers;
use crate::report::verdict::{Row, of_printed};

#[derive(Debug, thiserror::Error)]
#[error("the claim `{0}` has no line in the verdict table")]
struct NoLine(&'static str);

/// The two printed numbers.
pub(super) fn numbers(ledger: &Ledger) -> Vec<Row> {
    let printed = &ledger.printed;
    let number = |what: &str, value: f64, paper: f64| Row {
        what: what.to_owned(),
        paper: format!("{paper:.2}"),
        now: format!("{value:.5}"),
        verdict: of_printed(value, paper),
        section: "printed-numbers",
    };
    vec![
        number("Point force at lift-off by beam theory", printed.reaction_by_theory, PRINTED_REACTION),
        number("Its estimate on 30 intervals, n = 29", printed.first_force, PRINTED_FORCE),
    ]
}

/// The other claims.
pub(super) fn rows(ledger: &Ledger, claims: &[Claim]) -> Result<Vec<Row>, Cause> {
    let mut rows = Vec::new();
    for claim in claims {
        let Some((section, now)) = line(ledger, claim.name)? else { continue };
        rows.push(Row {
            what: heading(claim),
            paper: claim.statement.trim_end_matches('.').to_owned(),
            now,
            verdict: claim.verdict.word(),
            section,
        });
    }
    Ok(rows)
}

/// The worst of the errors that a designer looks at.
pub(in crate::report::evidence) fn worst(errors: &Errors) -> f64 {
    errors.end_reaction.abs().max(errors.moment.abs()).max(errors.deflection)
}

/// Anchor and evidence in a few words; none for the printed numbers, which have lines of their own.
fn line(ledger: &Ledger, name: &'static str) -> Result<Option<(&'static str, String)>, NoLine> {
    let percent = |e: f64| format!("{:.2} %", 100.0 * e.abs());
    let [paper, coarse, _] = &ledger.usable.grids;
    let four = &ledger.four_step;
    let fewest = |of: &dyn Fn(usize) -> usize| (0..four.counts.len()).map(of).min().unwrap_or(0);
    let most_sweeps = ledger.nsor.counts.iter().max_by_key(|c| c.on_the_paper_grid());
    let found = match name {
        "printed_numbers" => return Ok(None),
        "same_result" => ("same-result", format!("the same up to rounding on {} scenes", ledger.same_result.scenes)),
        "exact_for_point_forces" => (
            "exact-for-point-forces",
            format!(
                "exact up to rounding; finite differences off by {:.0} %",
                100.0 * ledger.point_forces.deflection_by_differences
            ),
        ),
        "usable_shape" => (
            "usable-shape",
            format!(
                "worst of deflection, end reaction and moment: {} on {}, {} on {} intervals",
                percent(worst(paper)),
                paper.intervals,
                percent(worst(coarse)),
                coarse.intervals
            ),
        ),
        "usable_pressure" => (
            "usable-pressure",
            format!(
                "nodal forces off by up to {:.0} % on {} intervals and {:.0} % on {}: resultants converge, they do not",
                100.0 * paper.pressure,
                paper.intervals,
                100.0 * ledger.usable.worst_pressure.1,
                ledger.usable.worst_pressure.0
            ),
        ),
        "four_steps_find_the_optimum" => (
            "four-steps-find-the-optimum",
            format!(
                "true there; the weakest method succeeds on {} of {} grids, and on {} of {} uneven foundations",
                fewest(&|i| four.counts[i].grids),
                four.grids,
                fewest(&|i| four.counts[i].uneven.iter().sum()),
                2 * palkki::paper::claims::four_step::SCENES
            ),
        ),
        "four_steps_reach_the_edge" => (
            "four-steps-reach-the-edge",
            format!("runs that end elsewhere: {}", four.counts.iter().map(|c| c.infeasible).sum::<usize>()),
        ),
        "nsor_for_large_n" => (
            "nsor-for-large-n",
            most_sweeps.map_or_else(String::new, |c| {
                format!(
                    "{} method: {:.1} thousand sweeps on 30 intervals, growing like n^{:.1}",
                    c.method,
                    super::studies::thousands(c.on_the_paper_grid()),
                    c.exponent
                )
            }),
        ),
        "whichever_matrix_is_easier" => (
            "whichever-matrix-is-easier",
            "K C = I holds; three-moment equations need neither and keep more digits".to_owned(),
        ),
        "bounded_from_both_sides" => (
            "bounded-from-both-sides",
            "both methods have the same energy and the beam dips between the nodes; made admissible there, the bracket is computed".to_owned(),
        ),
        "any_elastic_body" => (
            "any-elastic-body",
            format!(
                "a taut string: end reaction within {} of its closed form",
                numbers::bound(ledger.any_body.end_reaction)
            ),
        ),
        "elastic_foundation" => (
            "elastic-foundation",
            format!(
                "springs: mid-span deflection within {} of the series",
                percent(ledger.elastic_foundation.deflection)
            ),
        ),
        "unknown_rigid_motion" => (
            "unknown-rigid-motion",
            format!(
                "{} rigid motions without supports; step 1° has no solution",
                ledger.unknown_rigid_motion.rigid_motions
            ),
        ),
        "curved_beam" => ("curved-beam", "the same problem up to rounding: only u − w₀ enters".to_owned()),
        other => return Err(NoLine(other)),
    };
    Ok(Some(found))
}
