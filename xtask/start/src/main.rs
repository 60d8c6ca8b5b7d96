//! The front door of `cargo xtask`: answers `doctor` and `browser` itself and passes everything else on to package `xtask`.
//!
//! Package `xtask` needs the library and with it a C compiler. This one needs nothing, so that `doctor` can say
//! what is missing on a machine on which nothing else builds.
#![expect(clippy::print_stdout, clippy::print_stderr, reason = "a command that talks to a person")]

mod browser;
mod devtools;
mod doctor;
mod touch;

use std::process::{Command, ExitCode};

const USAGE: &str = "\
usage: cargo xtask <task>

  report           compute the paper again and write report/
  report --check   compute it and compare with report/: names stale, missing and left-over files
  report --page NAME       one document of report/templates alone, while its text is written; `index`: index.html alone
  browser          tries report/index.html in an installed Chromium or Chrome: widths, themes, the beam to play with, printing
  certificates     every answer beside the truth, and faults put into answers: minutes, into report/data
  measure          what accuracy costs, route by route: times go to report/data/measurements.csv; goes on where it stopped
  measure --fresh  begins that file again
  measure --only TEXT      what has TEXT in its line scene,route,intervals,tolerance; with --fresh: that again
  measure --only soil      surveys on soil, beside finite elements: into report/data/soil-surveys.csv
  measure --only 'points of'   the surveys: time over their points, and time and memory of the whole program
  mutants          small changes of the code, which some test ought to notice: into target/mutants; --sample N, --seed N, --only PATH, --again, --test NAME
  fuzz             look for texts that break the parsers, guided by coverage; --runs N
  hostile          random and adversarial scenes through the whole program: counts go to report/data/hostile.csv; --runs N, --from N for others
  doctor           what this machine lacks to build and to test, and what to do about it
";

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    match arguments.first().map(String::as_str) {
        None | Some("help" | "--help" | "-h") => {
            print!("{USAGE}");
            ExitCode::SUCCESS
        }
        Some("doctor") if arguments.len() == 1 => doctor::run(),
        Some("browser") if arguments.len() == 1 => browser::run(),
        Some(_) => pass_on(&arguments),
    }
}

/// Builds package `xtask`, showing that it does, and runs it with the same arguments.
fn pass_on(arguments: &[String]) -> ExitCode {
    let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    // Times of an unoptimised build would mislead, and very many runs should not take longer than they must.
    let task = arguments.first().map(String::as_str);
    let profile = if matches!(task, Some("measure" | "hostile")) { "release" } else { "dev" };
    // What is measured is the program, too.
    let packages = if task == Some("measure") { &["--package", "palkki"][..] } else { &[] };
    let build = Command::new(&cargo)
        .args(["build", "--package", "xtask", "--locked", "--profile", profile])
        .args(packages)
        .status();
    if !build.is_ok_and(|status| status.success()) {
        eprintln!("\nxtask: the build failed. What `cargo xtask doctor` says of this machine:\n");
        doctor::run();
        return ExitCode::FAILURE;
    }
    let run = Command::new(&cargo)
        .args(["run", "--quiet", "--package", "xtask", "--locked", "--profile", profile, "--"])
        .args(arguments)
        .status();
    let code = run.ok().and_then(|status| status.code()).and_then(|code| u8::try_from(code).ok());
    code.map_or(ExitCode::FAILURE, ExitCode::from)
}
