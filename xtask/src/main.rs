//! The tasks of the repository that need the library: `cargo xtask report`, `cargo xtask judge` and `cargo xtask measure`.
#![expect(clippy::print_stderr, reason = "a command that talks to a person")]

mod judge;
mod measure;
mod report;

use std::path::Path;
use std::process::ExitCode;

fn main() -> ExitCode {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let arguments: Vec<&str> = arguments.iter().map(String::as_str).collect();
    let outcome = match arguments.as_slice() {
        ["report"] => report::write(&root, &mut show).map_err(|error| error.to_string()),
        ["report", "--check"] => report::check(&root, &mut show).map_err(|error| error.to_string()),
        ["judge"] => judge::run(&root, &mut show),
        ["measure"] => measure::run(&root, false, &mut show),
        ["measure", "--fresh"] => measure::run(&root, true, &mut show),
        _ => {
            eprintln!("xtask: unknown task `{}`; `cargo xtask help` lists them", arguments.join(" "));
            return ExitCode::from(2);
        }
    };
    match outcome {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::FAILURE
        }
    }
}

/// One line per step, on stderr.
fn show(step: &str) {
    eprintln!("xtask: {step}");
}
