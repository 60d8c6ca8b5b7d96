//! The claims ledger: every verdict, and the numbers behind it. One test for each claim, called by the claim's name.

use std::collections::BTreeSet;
use std::sync::OnceLock;

use palkki::route::Method;
use palkki_evidence::paper::claims::extensions::Springs;
use palkki_evidence::paper::claims::{Claim, Ledger, Verdict, four_step};

use crate::support::assert_table;

/// The evidence. Measuring it takes seconds: once is enough.
fn ledger() -> &'static Ledger {
    static LEDGER: OnceLock<Ledger> = OnceLock::new();
    LEDGER.get_or_init(|| Ledger::measure().expect("the scenes of the paper are well posed"))
}

/// Half a unit of the last digit that the paper prints.
const PRINTED: f64 = 0.005;

/// A few units in the last place of numbers of the size of the beam.
const ROUNDING: f64 = 1e-12;

/// Rounding where condition numbers of up to 10⁵ stand between two ways of computing the same.
const CONDITIONED: f64 = 1e-10;

/// The product of two matrices whose condition numbers are 10⁵ at most, and some digits to spare.
const INVERSE: f64 = 1e-8;

/// One per cent: what the ledger calls usable.
const USABLE: f64 = 0.01;

/// Errors of second order on 200 intervals are of the size of `Δ²/l²`, 2.5·10⁻⁵, some ten times over.
const SECOND_ORDER: f64 = 1e-3;

#[test]
fn printed_numbers() {
    let e = &ledger().printed;
    assert_eq!(e.verdict(), Verdict::Confirmed);
    assert!((e.reaction_by_theory - 1.18).abs() < PRINTED, "{e:?}");
    assert!((e.first_force - 1.14).abs() < PRINTED, "{e:?}");
    // The other two candidates for what "the reaction" may be do not round to what is printed.
    assert!(PRINTED < (e.end_reaction - 1.14).abs(), "{e:?}");
    assert!(PRINTED < (e.first_force_by_differences - 1.14).abs(), "{e:?}");
    assert!((e.first_place - 7.0 / 3.0).abs() < ROUNDING, "{e:?}");
}

#[test]
fn same_result() {
    let e = &ledger().same_result;
    assert_eq!(e.verdict(), Verdict::Confirmed);
    // The claim is about at least two hundred uneven foundations, and holds with digits to spare.
    assert!(200 < e.scenes, "{e:?}");
    assert!(e.deflection < CONDITIONED && e.contact_force < CONDITIONED, "{e:?}");
    assert!(e.inverse < INVERSE, "{e:?}");
}

#[test]
fn novelty_of_the_force_method() {
    let claims = ledger().claims();
    let open: Vec<&str> = claims.iter().filter(|c| c.verdict == Verdict::Open).map(|c| c.name).collect();
    assert_eq!(open, ["novelty_of_the_force_method", "elastic_foundation"], "everything else is decided by numbers");
}

#[test]
fn exact_for_point_forces() {
    let e = &ledger().point_forces;
    assert_eq!(e.verdict(), Verdict::Confirmed);
    // Finite differences are not exact, so that the comparison means something.
    assert!(1e6 * e.deflection.max(e.moment) < e.deflection_by_differences, "{e:?}");
}

#[test]
fn usable_shape() {
    let e = &ledger().usable;
    // Within one per cent on 30 intervals; on 20 the end reaction and the moment are not.
    assert_eq!(e.verdict(), Verdict::Qualified);
    let [paper, coarse, fine] = &e.grids;
    assert_eq!([paper, coarse].map(|g| g.intervals), [30, 20], "the grids of the paper");
    for grid in [paper, fine] {
        assert!(grid.end_reaction.abs().max(grid.moment.abs()).max(grid.deflection) < USABLE, "{grid:?}");
    }
    assert!((USABLE..3.0 * USABLE).contains(&coarse.end_reaction) && coarse.deflection < USABLE, "{coarse:?}");
}

#[test]
fn usable_pressure() {
    let e = &ledger().usable;
    // On the paper's grid nodal forces deviate by less than q₀Δ itself; but contacts have holes, and nothing converges.
    assert_eq!(e.pressure_verdict(), Verdict::Qualified);
    let [paper, coarse, _] = &e.grids;
    assert!(paper.first_force.abs() < 0.05 && 0.5 < coarse.first_force.abs(), "{paper:?} {coarse:?}");
    assert!((0.5..1.0).contains(&paper.pressure), "{paper:?}");
    let (intervals, worst) = e.worst_pressure;
    assert!(5.0 < worst, "on {intervals} intervals a nodal force is off by {worst} q₀Δ");
    assert!(e.grids_looked_at < 2 * e.grids_with_holes, "{} of {}", e.grids_with_holes, e.grids_looked_at);
}

#[test]
fn four_steps_find_the_optimum() {
    let e = &ledger().four_step;
    assert_eq!(e.verdict(), Verdict::Qualified);
    for count in &e.counts {
        assert!(count.on_the_example, "{count:?}");
        assert!(count.uneven.iter().any(|optimal| *optimal < four_step::SCENES), "{count:?}");
    }
    let by = |method| e.counts.iter().find(|c| c.method == method).expect("every method is counted");
    // The paper's own method fails on finer grids of the paper's own example.
    assert!(by(Method::Displacement).grids < e.grids, "{:?}", by(Method::Displacement));
    assert!(by(Method::Displacement).first_failure.is_some_and(|n| 30 < n), "{:?}", by(Method::Displacement));
}

#[test]
fn four_steps_reach_the_edge() {
    let e = &ledger().four_step;
    assert_eq!(e.edge_verdict(), Verdict::Confirmed);
    assert!(e.counts.iter().all(|count| count.infeasible == 0), "{e:?}");
}

#[test]
fn nsor_for_large_n() {
    let e = &ledger().nsor;
    // As *a* usable algorithm it converges on grids of the paper's size and not on fine ones; as *the* usable one it falls.
    assert_eq!([e.verdict(), e.verdict_as_the_only_one()], [Verdict::Qualified, Verdict::Refuted]);
    for count in &e.counts {
        // Sweeps grow faster than n² for every matrix, and there are no grids on which that is hidden.
        assert!(count.converged && 2.0 < count.exponent, "{count:?}");
        assert!(count.active_set_solves < 40 && 10.0 < count.cost, "{count:?}");
        assert!((40..300).contains(&count.finest), "{count:?}");
    }
    let force = e.counts.iter().find(|c| c.method == Method::Force).expect("every method is counted");
    let [race, own] = force.on_the_paper_grid();
    assert!(20_000 < own && own < race, "tens of thousands of sweeps on C: {force:?}");
    // An independent program with the same test and ω = 1.7 takes 140 sweeps for finite differences.
    let differences = e.counts.iter().find(|c| c.method == Method::Complementarity).expect("every method is counted");
    assert!((100..=200).contains(&differences.on_the_paper_grid()[1]), "{differences:?}");
}

#[test]
fn whichever_matrix_is_easier() {
    let e = &ledger().recommendation;
    assert_eq!(e.verdict(), Verdict::Qualified);
    let [paper, fine] = &e.digits;
    // cond(K) grows like n⁴: from 30 to 200 intervals by about 2000.
    let growth = fine.condition / paper.condition;
    assert!((1500.0..2500.0).contains(&growth), "{growth}");
    assert!(fine.without_matrix < fine.with_stiffness && fine.without_matrix < fine.with_flexibility, "{fine:?}");
}

#[test]
fn bounded_from_both_sides() {
    let e = &ledger().bounds;
    assert_eq!(e.verdict(), Verdict::Qualified);
    for grid in &e.grids {
        assert!(grid.difference < CONDITIONED, "both methods have the same energy: {grid:?}");
        assert!(0.0 < grid.penetration, "the beam dips between the nodes: {grid:?}");
        let [lower, upper] = grid.bracket;
        assert!(lower <= 0.0 && 0.0 <= upper && upper - lower < 1e-9, "the bracket holds beam theory: {grid:?}");
        assert!(grid.energy < 0.0, "and the energy is above the exact one, which is negative: {grid:?}");
    }
}

#[test]
fn any_elastic_body() {
    let e = ledger().any_body;
    assert_eq!(e.verdict(), Verdict::Confirmed);
    assert!(e.end_reaction.abs() < SECOND_ORDER && e.residual < ROUNDING, "{e:?}");
}

#[test]
fn elastic_foundation() {
    let e = ledger().elastic_foundation;
    // Right beside its series, and every spring is pressed: contact is not tried, and so the claim is not decided.
    assert_eq!((e.verdict(), e.lifted), (Verdict::Open, 0));
    assert!(e.deflection.abs() < SECOND_ORDER && e.residual < ROUNDING, "{e:?}");
    assert_eq!(Springs { lifted: 1, ..e }.verdict(), Verdict::Confirmed, "with contact that comes and goes");
    assert_eq!(Springs { residual: 1.0, ..e }.verdict(), Verdict::Refuted);
}

#[test]
fn unknown_rigid_motion() {
    let e = ledger().unknown_rigid_motion;
    assert_eq!(e.verdict(), Verdict::Confirmed);
    assert_eq!((e.rigid_motions, e.first_step_works), (2, false), "a translation and a rotation");
    assert!(e.solved, "from a rigid beam on two places");
}

#[test]
fn curved_beam() {
    let e = ledger().curved_beam;
    assert_eq!(e.verdict(), Verdict::Confirmed);
    assert!(e.exact < ROUNDING && e.nodal < ROUNDING && 0.0 < e.contact_force, "{e:?}");
}

/// What the report's ledger says of each claim; the tests above say why.
#[test]
fn verdicts_do_not_change_unnoticed() {
    let row = |claim: &Claim| {
        let reading = claim.reading.map_or_else(String::new, |reading| format!("  {reading}"));
        format!("{:<28} {}{reading}\n", claim.name, claim.verdict.name())
    };
    let table: String = ledger().claims().iter().map(row).collect();
    assert_table!("claims", "The claims of the paper, and what became of them", table);
}

#[test]
fn every_claim_has_its_test() {
    let claims: BTreeSet<&str> = ledger().claims().iter().map(|claim| claim.name).collect();
    let about_all = [
        "every_claim_has_its_test",
        "verdicts_do_not_change_unnoticed",
        "words_and_numbers_of_a_claim_belong_together",
    ];
    let lines: Vec<&str> = include_str!("claims.rs").lines().collect();
    let tests: BTreeSet<&str> = lines
        .windows(2)
        .filter(|pair| pair[0] == "#[test]")
        .filter_map(|pair| pair[1].strip_prefix("fn ")?.strip_suffix("() {"))
        .filter(|name| !about_all.contains(name))
        .collect();
    assert_eq!(claims, tests, "claims of the ledger (left) and tests in this file (right)");
}

#[test]
fn words_and_numbers_of_a_claim_belong_together() {
    for claim in ledger().claims() {
        assert!(claim.statement.ends_with('.') && claim.evidence.ends_with(['.', ')']), "{claim:?}");
        for words in [&claim.evidence, &claim.summary] {
            assert!(words.contains(|c: char| c.is_ascii_digit()), "evidence has numbers: {claim:?}");
        }
        // A table has it in a cell.
        assert!(claim.summary.chars().count() < 220 && !claim.summary.contains('|'), "{}", claim.summary);
    }
}
