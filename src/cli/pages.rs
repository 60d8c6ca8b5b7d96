//! Shell completions and man pages, which a package of the program contains.

use clap::CommandFactory as _;
use clap::error::ErrorKind;
use clap_complete::Shell;

use super::CERTIFIED;
use super::arguments::Arguments;
use super::output::{self, Failure, Stream};

/// Prints a shell script that completes commands and options.
pub(super) fn completions(shell: Shell) -> Result<u8, Failure> {
    let mut text = Vec::new();
    clap_complete::generate(shell, &mut Arguments::command(), "palkki", &mut text);
    print(&text)
}

/// Prints the man page of the program, or of one of its commands.
pub(super) fn manual(name: Option<&str>) -> Result<u8, Failure> {
    let mut program = Arguments::command();
    program.build();
    let page = match name {
        None => program,
        Some(name) => {
            let Some(command) = program.find_subcommand(name) else {
                let known: Vec<&str> = program.get_subcommands().map(clap::Command::get_name).collect();
                let message = format!("there is no command {name:?}; there are {}", known.join(", "));
                return Err(Failure::Usage { command: "manual", kind: ErrorKind::InvalidValue, message });
            };
            // A man page is found by one word.
            command.clone().display_name(format!("palkki-{name}"))
        }
    };
    let mut text = Vec::new();
    clap_mangen::Man::new(page)
        .source(concat!("palkki ", env!("CARGO_PKG_VERSION")))
        .render(&mut text)
        .map_err(Failure::Print)?;
    print(&text)
}

fn print(text: &[u8]) -> Result<u8, Failure> {
    output::print(Stream::Output, &String::from_utf8_lossy(text))?;
    Ok(CERTIFIED)
}
