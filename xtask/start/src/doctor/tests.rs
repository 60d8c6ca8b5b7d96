//! The checks on machines that lack something.

use super::*;

/// A machine that has the programs of a list and nothing else.
#[derive(Debug, Clone, Copy)]
struct Imagined {
    rustc: &'static str,
    programs: &'static [&'static str],
    writable: bool,
}

const COMPLETE: Imagined = Imagined {
    rustc: "rustc 1.90.0 (abc 2025-01-01)",
    programs: &["cc", "rustfmt", "cargo-clippy", "google-chrome"],
    writable: true,
};

impl Surroundings for Imagined {
    fn succeeds(&self, program: &str, _: &[&str]) -> bool {
        self.programs.contains(&program)
    }
    fn output(&self, program: &str, arguments: &[&str]) -> Option<String> {
        let printed = if (program, arguments) == ("rustc", &["--version"]) { self.rustc } else { "" };
        (!printed.is_empty()).then(|| printed.to_owned())
    }
    fn variable(&self, _: &str) -> Option<String> {
        None
    }
    fn writable(&self, _: &str) -> bool {
        self.writable
    }
    fn text(&self, file: &str) -> Option<String> {
        (file == "Cargo.toml").then(|| "[workspace.package]\nrust-version = \"1.88\"\n".to_owned())
    }
}

/// The names of what is missing on a machine.
fn missing(machine: &Imagined) -> Vec<&'static str> {
    let is_missing = |check: &&Check| matches!((check.look)(machine), Finding::Missing(_));
    CHECKS.iter().filter(is_missing).map(|check| check.name).collect()
}

#[test]
fn a_complete_machine_lacks_nothing() {
    for check in &CHECKS {
        assert!(matches!((check.look)(&COMPLETE), Finding::Found(_)), "{}", check.name);
    }
}

#[test]
fn one_thing_that_is_not_there_is_one_thing_missing() {
    assert_eq!(missing(&Imagined { rustc: "rustc 1.87.0", ..COMPLETE }), ["Rust"], "too old");
    assert_eq!(missing(&Imagined { rustc: "rustc 2.0.0-nightly", ..COMPLETE }), [""; 0], "a later major version");
    assert_eq!(missing(&Imagined { rustc: "", ..COMPLETE }), ["Rust"], "no rustc");
    assert_eq!(missing(&Imagined { programs: &["make"], ..COMPLETE }), ["C compiler"], "no compiler");
    assert_eq!(missing(&Imagined { programs: &["clang"], ..COMPLETE }), [""; 0], "neither make nor cmake is needed");
    assert_eq!(missing(&Imagined { writable: false, ..COMPLETE }), ["write access"], "read-only");
}

#[test]
fn rustfmt_and_clippy_are_advice() {
    let machine = Imagined { programs: &["cc", "rustfmt"], ..COMPLETE };
    assert_eq!(
        components(&machine),
        Finding::Advice("clippy not found; only `.ci/run` needs it (`rustup component add clippy`)".to_owned()),
        "no clippy"
    );
}

#[test]
fn a_browser_is_advice() {
    assert_eq!(browser(&COMPLETE), Finding::Found("google-chrome".to_owned()));
    let said = browser(&Imagined { programs: &[], ..COMPLETE });
    assert!(matches!(said, Finding::Advice(text) if text.contains("apt-get install chromium")), "no browser");
}
