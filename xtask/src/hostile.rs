//! `cargo xtask hostile`: random and adversarial scenes through the whole program, with fixed seeds. The acceptance suite makes
//! the first few of the same runs.

use std::path::Path;

use palkki_evidence::hostile::{Count, Tally, seeds};
use rayon::prelude::*;
use serde::{Deserialize, Serialize};

use crate::{Cause, data, tell};

/// Where the counts are, below the root.
pub(crate) const PATH: &str = "report/data/hostile.csv";

/// Runs of one piece of work.
const PIECE: u64 = 1000;

/// Messages that are shown at the most.
const SHOWN: usize = 200;

/// What became of the runs of one family of scenes.
#[derive(Debug, Serialize, Deserialize)]
pub(crate) struct Family {
    pub(crate) family: String,
    pub(crate) runs: usize,
    pub(crate) refused: usize,
    pub(crate) theory_solved: usize,
    pub(crate) theory_not_solved: usize,
    theory_none: usize,
    pub(crate) theory_bounded: usize,
    pub(crate) theory_certified: usize,
    pub(crate) theory_all_but_turns: usize,
    pub(crate) active_set_solved: usize,
    pub(crate) active_set_not_solved: usize,
    pub(crate) route_solved: usize,
    pub(crate) route_not_solved: usize,
    pub(crate) contradicted: usize,
    pub(crate) derived: usize,
    pub(crate) swept: usize,
    most_lists: usize,
    most_iterations: usize,
    pub(crate) wrong: usize,
    pub(crate) panics: usize,
}

impl Family {
    fn new(family: &str, count: Count) -> Self {
        // How many were compared in other units is for the suite, which asks that there are some.
        let Count { runs, refused, exact, bounded, certified, all_but_turns, .. } = count;
        let Count { reference, route, contradicted, derived, swept, work, wrong, panics, .. } = count;
        Self {
            family: family.to_owned(),
            runs,
            refused,
            theory_solved: exact[0],
            theory_not_solved: exact[1],
            theory_none: exact[2],
            theory_bounded: bounded,
            theory_certified: certified,
            theory_all_but_turns: all_but_turns,
            active_set_solved: reference[0],
            active_set_not_solved: reference[1],
            route_solved: route[0],
            route_not_solved: route[1],
            contradicted,
            derived,
            swept,
            most_lists: work[0],
            most_iterations: work[1],
            wrong,
            panics,
        }
    }
}

/// Runs so many seeds, and writes the counts; an error if anything is wrong.
pub(crate) fn run(root: &Path, runs: u64) -> Result<(), Cause> {
    // Panics are counted, and their messages are in the way.
    std::panic::set_hook(Box::new(|_| ()));
    let pieces: Vec<u64> = (0..runs.div_ceil(PIECE)).collect();
    let parts = pieces.par_iter().with_max_len(1).map(|piece| {
        let mut tally = Tally::default();
        seeds(piece * PIECE..runs.min((piece + 1) * PIECE)).for_each(|seed| tally.run(seed));
        tell(&format!("piece {} of {}", piece + 1, pieces.len()));
        tally
    });
    let parts: Vec<Tally> = parts.collect();
    drop(std::panic::take_hook());
    let mut tally = Tally::default();
    parts.into_iter().for_each(|part| tally.join(part));
    tally.wrong.sort();
    for (seed, what) in tally.wrong.iter().take(SHOWN) {
        tell(&format!("seed {seed}: {what}"));
    }
    let families: Vec<Family> =
        tally.families.into_iter().map(|(family, count)| Family::new(family.name(), count)).collect();
    data::write(root, PATH, &families)?;
    match tally.wrong.len() {
        0 => tell(&format!("nothing wrong; the counts are in {PATH}")),
        wrong => return Err(format!("{wrong} things are wrong; see the seeds above").into()),
    }
    Ok(())
}
