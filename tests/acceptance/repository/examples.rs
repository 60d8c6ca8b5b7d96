//! The examples of the package, one for each thing that a user does: short, and what they print.

use std::path::Path;
use std::process::Command;

use super::text::files;
use crate::support::assert_table;

/// An example is read at a glance.
const MOST_LINES: usize = 30;

/// Each is run as `cargo test` has built it.
#[test]
fn examples_are_short_and_print_what_they_say() {
    let built = Path::new(env!("CARGO_BIN_EXE_palkki")).with_file_name("examples");
    let mut printed = String::new();
    for (path, text) in files("report/examples", ".rs") {
        let lines = text.lines().count();
        assert!(lines <= MOST_LINES, "{path} has {lines} lines, more than {MOST_LINES}");
        let name = Path::new(&path).file_stem().expect("a file has a name");
        let run = Command::new(built.join(name)).output();
        let output = run.unwrap_or_else(|error| panic!("{path}: {error}; `cargo build --examples` makes it"));
        assert!(output.status.success(), "{path}: {}", String::from_utf8_lossy(&output.stderr));
        printed += &format!("== {path}\n{}\n", String::from_utf8_lossy(&output.stdout));
    }
    assert_table!("examples", "What the examples of the package print", printed);
}
