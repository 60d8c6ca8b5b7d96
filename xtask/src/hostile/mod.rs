//! `cargo xtask hostile`: random and adversarial scenes through the whole program, with fixed seeds. The acceptance suite makes
//! the first few of the same runs.
#![expect(clippy::print_stderr, reason = "progress of runs that take minutes")]

use std::fmt::Write as _;
use std::path::Path;
use std::sync::atomic::{AtomicU64, Ordering};

use palkki_evidence::hostile::{Count, Tally};

/// Runs if nothing else is asked for.
pub(crate) const RUNS: u64 = 100_000;

/// Where the counts are, below the root.
pub(crate) const PATH: &str = "report/data/hostile.csv";

const HEADER: &str = "family,runs,refused,theory_certified,theory_not_certified,theory_none,theory_bounded,\
    active_set_certified,active_set_not_certified,route_certified,route_not_certified,contradicted,most_lists,most_iterations,\
    wrong,panics";

/// Threads; each takes the next seed, and counts do not depend on who took it.
const THREADS: u64 = 2;

/// Runs `0 … runs − 1`, and writes the counts; an error if anything is wrong.
pub(crate) fn run(root: &Path, runs: u64, progress: &mut dyn FnMut(&str)) -> Result<(), String> {
    // Panics are counted, and their messages are in the way.
    std::panic::set_hook(Box::new(|_| ()));
    let next = AtomicU64::new(0);
    let work = || {
        let mut tally = Tally::default();
        loop {
            let seed = next.fetch_add(1, Ordering::Relaxed);
            if runs <= seed {
                return tally;
            }
            tally.run(seed);
            if (seed + 1).is_multiple_of(10_000) {
                eprintln!("xtask: {} of {runs} runs", seed + 1);
            }
        }
    };
    let mut tally = Tally::default();
    std::thread::scope(|scope| {
        let workers: Vec<_> = (0..THREADS).map(|_| scope.spawn(work)).collect();
        progress(&format!("{runs} runs with {THREADS} threads"));
        for worker in workers {
            if let Ok(part) = worker.join() {
                tally.join(part);
            }
        }
    });
    drop(std::panic::take_hook());
    tally.wrong.sort();
    for (seed, what) in tally.wrong.iter().take(200) {
        progress(&format!("seed {seed}: {what}"));
    }
    let mut csv = format!("{HEADER}\n");
    for (family, count) in &tally.families {
        // How many were compared in other units is for the suite, which asks that there are some.
        let Count { runs, refused, exact, bounded, reference, route, contradicted, rescaled: _, work, wrong, panics } =
            count;
        let numbers =
            [*runs, *refused, exact[0], exact[1], exact[2], *bounded, reference[0], reference[1], route[0], route[1]];
        let numbers = numbers.into_iter().chain([*contradicted, work[0], work[1], *wrong, *panics]);
        let numbers: Vec<String> = numbers.map(|n| n.to_string()).collect();
        // Writing to a string does not fail.
        let _ = writeln!(csv, "{},{}", family.word(), numbers.join(","));
    }
    let path = root.join(PATH);
    std::fs::write(&path, csv).map_err(|error| format!("{}: {error}", path.display()))?;
    if tally.wrong.is_empty() {
        progress("nothing wrong; the counts are in report/data/hostile.csv");
        Ok(())
    } else {
        Err(format!("{} things are wrong; see the seeds above", tally.wrong.len()))
    }
}
