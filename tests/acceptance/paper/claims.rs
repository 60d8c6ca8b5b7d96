//! The claims ledger: every claim asserts what its words rest on, and its verdict is pinned.

use palkki_evidence::paper::claims::{Claim, Ledger};

use crate::support::assert_table;

/// What the report's ledger says of each claim; [`Ledger::measure`] says why.
#[test]
fn claims_hold_and_verdicts_do_not_change_unnoticed() {
    let ledger = Ledger::measure().expect("the scenes of the paper are well posed");
    let row = |claim: &Claim| format!("{:<28} {}\n", claim.name, claim.verdict.name());
    let table: String = ledger.claims.iter().map(row).collect();
    assert_table!("claims", "The claims of the paper, and what became of them", table);
}
