//! The command line of `palkki`.

mod cli;

fn main() -> std::process::ExitCode {
    cli::run()
}
