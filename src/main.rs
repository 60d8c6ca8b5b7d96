//! The command line of `palkki`.

#![warn(clippy::disallowed_methods)]

mod cli;

fn main() -> std::process::ExitCode {
    cli::run()
}
