//! The words that command line, JSON and report share: users' scripts rely on them.

use std::collections::BTreeSet;

use palkki::route::{Method, Solver, Status};
use palkki::state::Regime;

use crate::support::assert_table;

const REGIMES: [Regime; 3] = [Regime::None, Regime::Points, Regime::Zone];

#[test]
fn words_do_not_change_unnoticed() {
    let row = |kind: &str, words: &[&str]| format!("{kind:<8} {}\n", words.join(" "));
    let table = [
        row("method", &Method::ALL.map(Method::name)),
        row("solver", &Solver::ALL.map(Solver::name)),
        row("status", &Status::ALL.map(Status::name)),
        row("regime", &REGIMES.map(Regime::name)),
    ]
    .concat();
    assert_table!("words", "What command line, JSON and report call things", table);
}

#[test]
fn no_two_things_share_a_word() {
    let mut words = Method::ALL.map(Method::name).to_vec();
    words.extend(Solver::ALL.map(Solver::name));
    words.extend(Status::ALL.map(Status::name));
    words.extend(REGIMES.map(Regime::name));
    assert_eq!(words.iter().collect::<BTreeSet<_>>().len(), words.len(), "{words:?}");
}
