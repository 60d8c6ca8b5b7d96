//! The tasks of the repository that need the library: `cargo xtask report`, `cargo xtask judge` and `cargo xtask measure`.
#![expect(clippy::print_stderr, clippy::print_stdout, reason = "a command that talks to a person")]

#[path = "../../tests/authority/mod.rs"]
#[expect(dead_code, reason = "the acceptance suite uses the rest of it")]
mod authority;
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
        // What `measure` starts to weigh a solve.
        ["peak", rest @ ..] => measure::own_peak(&root, rest).map(|kilobytes| println!("{kilobytes}")),
        ["measure", rest @ ..] => match measure::Wish::of(rest) {
            Some(wish) => measure::run(&root, wish, &mut show),
            None => return unknown(&arguments),
        },
        _ => return unknown(&arguments),
    };
    match outcome {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::FAILURE
        }
    }
}

/// A task that does not exist.
fn unknown(arguments: &[&str]) -> ExitCode {
    eprintln!("xtask: unknown task `{}`; `cargo xtask help` lists them", arguments.join(" "));
    ExitCode::from(2)
}

/// One line per step, on stderr.
fn show(step: &str) {
    eprintln!("xtask: {step}");
}
