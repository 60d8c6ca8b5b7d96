//! `cargo xtask hostile`: random and adversarial scenes through the whole program, with fixed seeds. The acceptance suite makes
//! the first few of the same runs.

use std::ops::Range;
use std::path::Path;

use palkki_evidence::hostile::{Count, Tally, seeds};
use rayon::prelude::*;

use crate::report::files;
use crate::table::{Table, row};
use crate::{Cause, tell};

/// Where the counts are, below the root.
pub(crate) const PATH: &str = "report/data/hostile.csv";

/// Runs of one piece of work.
const PIECE: u64 = 1000;

/// The counts of all families, a row each. How many were compared in other units is for the suite, which asks that there are some.
fn table(tally: &Tally) -> Table {
    let header = "family runs refused theory_solved theory_not_solved theory_none theory_bounded theory_certified \
        theory_all_but_turns active_set_solved active_set_not_solved route_solved route_not_solved contradicted derived swept \
        most_lists most_iterations wrong panics";
    Table::new(header.split_whitespace()).rows(tally.families.iter().map(|(family, count)| {
        let Count { runs, refused, exact: [solved, not_solved, none], bounded, certified, all_but_turns, .. } = count;
        let Count { reference: [on_grid, not_on_grid], route: [by_route, not_by_route], contradicted, derived, .. } =
            count;
        let Count { swept, work: [lists, iterations], wrong, panics, .. } = count;
        let theory = row![runs, refused, solved, not_solved, none, bounded, certified, all_but_turns];
        let grids = row![on_grid, not_on_grid, by_route, not_by_route, contradicted, derived, swept];
        [&row![family.name()][..], &theory, &grids, &row![lists, iterations, wrong, panics]].concat()
    }))
}

/// Makes these runs, and writes the counts if they are from the first one on; an error if anything is wrong.
pub(crate) fn run(root: &Path, runs: Range<u64>) -> Result<(), Cause> {
    // Panics are counted, and their messages are in the way.
    std::panic::set_hook(Box::new(|_| ()));
    let first = runs.start;
    let pieces: Vec<u64> = (0..runs.end.saturating_sub(first).div_ceil(PIECE)).collect();
    let parts = pieces.par_iter().with_max_len(1).map(|piece| {
        let mut tally = Tally::default();
        let start = first + piece * PIECE;
        for seed in seeds(start..runs.end.min(start + PIECE)) {
            let known = tally.wrong.len();
            tally.run(seed);
            tally.wrong[known..].iter().for_each(|(seed, what)| tell(&format!("seed {seed}: {what}")));
        }
        tell(&format!("piece {} of {}", piece + 1, pieces.len()));
        tally
    });
    let parts: Vec<Tally> = parts.collect();
    drop(std::panic::take_hook());
    let mut tally = Tally::default();
    parts.into_iter().for_each(|part| tally.join(part));
    if first == 0 {
        files::replace(&root.join(PATH), &table(&tally).csv()?)?;
        tell(&format!("the counts are in {PATH}"));
    }
    match tally.wrong.len() {
        0 => tell("nothing wrong"),
        wrong => return Err(format!("{wrong} things are wrong; see the seeds above").into()),
    }
    Ok(())
}
