//! `cargo xtask doctor`: what this machine lacks, and what to do about it.

use std::path::Path;
use std::process::ExitCode;

use crate::checks::{CHECKS, Finding};
use crate::surroundings::Machine;

/// Prints one line per check; code 1 if something is missing without which the repository does not build.
pub(crate) fn run() -> ExitCode {
    let machine = Machine { root: Path::new(env!("CARGO_MANIFEST_DIR")).join("../..") };
    let mut missing = 0;
    for check in &CHECKS {
        let (verdict, text) = match (check.look)(&machine) {
            Finding::Found(text) => ("ok", text),
            Finding::Advice(text) => ("note", text),
            Finding::Missing(text) => {
                missing += 1;
                ("MISSING", text)
            }
        };
        println!("{verdict:<8} {:<19} {text}", check.name);
    }
    if missing == 0 {
        println!("\nThis machine has what `cargo test` and `cargo xtask report` need.");
        ExitCode::SUCCESS
    } else {
        println!("\n{missing} of {} needed things are missing: see above what to do.", CHECKS.len());
        ExitCode::FAILURE
    }
}
