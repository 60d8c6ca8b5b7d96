//! `cargo xtask doctor`: what has to be on a machine and what is good to have, what this one lacks, and what to do about it.

use std::path::Path;
use std::process::ExitCode;

use crate::surroundings::{Machine, Surroundings};

/// How one check ended.
#[derive(Debug, PartialEq, Eq)]
enum Finding {
    /// It is there: what was found.
    Found(String),
    /// It is not there and nothing depends on it but what is said.
    Advice(String),
    /// It is not there and has to be: what to do.
    Missing(String),
}

/// One thing that is looked for.
#[derive(Debug)]
struct Check {
    /// Its name.
    name: &'static str,
    /// How it is looked for.
    look: fn(&dyn Surroundings) -> Finding,
}

/// Everything that is looked for, in the order in which it is needed.
const CHECKS: [Check; 5] = [
    Check { name: "Rust", look: rust },
    Check { name: "C compiler", look: c_compiler },
    Check { name: "write access", look: write_access },
    Check { name: "rustfmt and clippy", look: components },
    Check { name: "browser", look: browser },
];

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

fn rust(machine: &dyn Surroundings) -> Finding {
    let manifest = machine.text("Cargo.toml").unwrap_or_default();
    let Some(needed) = manifest.lines().find_map(|line| line.strip_prefix("rust-version = ")) else {
        return Finding::Missing("Cargo.toml with a rust-version was not found; is this the repository?".to_owned());
    };
    let needed = needed.trim().trim_matches('"');
    let Some(found) = machine.output("rustc", &["--version"]) else {
        return Finding::Missing(format!("no rustc; install Rust {needed} or newer, for example with rustup"));
    };
    match version(&found) {
        Some(version_found) if version(needed) <= Some(version_found) => Finding::Found(found),
        _ => Finding::Missing(format!("{found} is too old; Rust {needed} or newer is needed (`rustup update`)")),
    }
}

/// Major and minor number of the first word that begins with a digit, such as `rustc 1.95.0 (…)`.
fn version(text: &str) -> Option<(u32, u32)> {
    let word = text.split_whitespace().find(|word| word.starts_with(|c: char| c.is_ascii_digit()))?;
    let mut numbers = word.split('.').map(|number| number.parse().ok());
    Some((numbers.next()??, numbers.next()??))
}

fn c_compiler(machine: &dyn Surroundings) -> Finding {
    let named = machine.variable("CC");
    let candidates: Vec<&str> = named.as_deref().into_iter().chain(["cc", "gcc", "clang"]).collect();
    let starts = |program: &&&str| machine.succeeds(program, &["--version"]);
    match candidates.iter().find(starts) {
        Some(compiler) => Finding::Found((*compiler).to_owned()),
        None => Finding::Missing(
            "none of $CC, cc, gcc, clang starts; install one (Debian, Ubuntu: `apt-get install build-essential`; \
             macOS: `xcode-select --install`)"
                .to_owned(),
        ),
    }
}

fn write_access(machine: &dyn Surroundings) -> Finding {
    let refused: Vec<&str> = ["target", "report"].into_iter().filter(|place| !machine.writable(place)).collect();
    if refused.is_empty() {
        Finding::Found("target, report".to_owned())
    } else {
        Finding::Missing(format!("cannot write to {}; make it writable for this user", refused.join(" and ")))
    }
}

fn components(machine: &dyn Surroundings) -> Finding {
    let tools = [("rustfmt", "rustfmt"), ("clippy", "cargo-clippy")];
    let lacking: Vec<&str> = tools
        .into_iter()
        .filter(|(_, program)| !machine.succeeds(program, &["--version"]))
        .map(|(component, _)| component)
        .collect();
    if lacking.is_empty() {
        Finding::Found("rustfmt, clippy".to_owned())
    } else {
        let lacking = lacking.join(" ");
        Finding::Advice(format!("{lacking} not found; only `.ci/run` needs it (`rustup component add {lacking}`)"))
    }
}

/// The name under which a browser starts that can be driven without a window.
pub(crate) fn browser_of(machine: &dyn Surroundings) -> Option<String> {
    let named = machine.variable("CHROME");
    let usual = ["chromium", "chromium-browser", "google-chrome", "google-chrome-stable", MACOS_CHROME];
    let mut candidates = named.into_iter().chain(usual.map(str::to_owned));
    candidates.find(|program| machine.succeeds(program, &["--version"]))
}

/// Where Chrome is on a Mac, which has no command for it.
const MACOS_CHROME: &str = "/Applications/Google Chrome.app/Contents/MacOS/Google Chrome";

fn browser(machine: &dyn Surroundings) -> Finding {
    browser_of(machine).map_or_else(
        || {
            Finding::Advice(
                "none of $CHROME, chromium, google-chrome starts; only `cargo xtask browser` needs one \
                 (Debian: `apt-get install chromium`; Ubuntu: `snap install chromium`; macOS: \
                 `brew install --cask google-chrome`)"
                    .to_owned(),
            )
        },
        Finding::Found,
    )
}

#[cfg(test)]
mod tests;
