//! The tasks of the repository that need the library: `cargo xtask report`, `certificates`, `measure`, `fuzz` and `hostile`.
#![expect(clippy::print_stderr, clippy::print_stdout, reason = "a command that talks to a person")]

mod certificates;
mod fuzz;
mod hostile;
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
        ["report", "--page", page] => report::preview(&root, page, &mut show).map_err(|error| error.to_string()),
        ["certificates"] => certificates::run(&root, &mut show),
        // What `measure` starts to weigh a solve.
        ["peak", rest @ ..] => measure::own_peak(&root, rest).map(|kilobytes| println!("{kilobytes}")),
        // What `measure --scale` starts for each line of its file.
        ["alone", rest @ ..] => measure::scale::alone::line(rest).map(|line| println!("{line}")),
        ["measure", rest @ ..] => match measure::Wish::of(rest) {
            Some(wish) => measure::run(&root, wish, &mut show),
            None => return unknown(&arguments),
        },
        ["fuzz"] => fuzz::run(&root, fuzz::RUNS, &mut show),
        ["fuzz", "--runs", runs] => count(runs).and_then(|runs| fuzz::run(&root, runs, &mut show)),
        ["hostile"] => hostile::run(&root, hostile::RUNS, &mut show),
        ["hostile", "--seed", seed] => count(seed).map(|seed| println!("{}", palkki_evidence::hostile::scene(seed))),
        ["hostile", "--runs", runs] => count(runs).and_then(|runs| hostile::run(&root, runs, &mut show)),
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

/// A number of runs.
fn count(text: &str) -> Result<u64, String> {
    text.parse().map_err(|_| format!("the number of runs must be a whole number, but is {text}"))
}

/// One line per step, on stderr.
fn show(step: &str) {
    eprintln!("xtask: {step}");
}
