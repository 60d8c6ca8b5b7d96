//! What the library stands on: with all features, and without any.

use std::collections::BTreeSet;
use std::process::Command;

use super::text::{files, none, root};

/// Crates by others that may be below the library without features. `nalgebra` brings 12, `toml` 4, `thiserror` 5.
const MOST_OF_CORE: usize = 40;

/// What the core is free of: other languages, and what only features need.
const FOREIGN: [&str; 12] = [
    "annotate-snippets",
    "bindgen",
    "cc",
    "clap",
    "clarabel",
    "cmake",
    "dashu-ratio",
    "osqp",
    "osqp-sys",
    "plotters",
    "serde_json",
    "pkg-config",
];

/// The crates by others that are compiled into, or run for, the library.
fn crates(edges: &str, features: &[&str]) -> BTreeSet<String> {
    let output = Command::new(env!("CARGO"))
        // One platform, whichever this is.
        .args(["tree", "--locked", "--package", "palkki", "--target", "x86_64-unknown-linux-gnu", "--prefix", "none"])
        .args(["--format", "{p}", "--edges", edges])
        .args(features)
        .current_dir(root())
        .output()
        .unwrap_or_else(|e| panic!("cargo does not start: {e}"));
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    // `name v1.2.3 (*)`; crates of this workspace have a path behind.
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    let crates = text.lines().filter_map(|line| line.split_once(" v"));
    crates.filter(|(name, _)| *name != "palkki").map(|(name, rest)| format!("{name} {}", version(rest))).collect()
}

fn version(rest: &str) -> &str {
    rest.split(' ').next().unwrap_or_default()
}

fn architecture() -> String {
    files("ARCHITECTURE.md", "").remove("ARCHITECTURE.md").unwrap_or_default()
}

#[test]
fn the_core_is_pure_rust() {
    let core = crates("normal,build", &["--no-default-features"]);
    assert!(core.iter().any(|name| name.starts_with("nalgebra ")), "cargo has listed something else: {core:?}");
    assert!(core.len() <= MOST_OF_CORE, "{} crates: {core:?}", core.len());
    let all = crates("normal,build", &["--all-features"]);
    let is = |name: &str, foreign: &str| name.split(' ').next() == Some(foreign);
    let found: Vec<String> = core.iter().filter(|name| FOREIGN.iter().any(|f| is(name, f))).cloned().collect();
    none(&found, "the core needs no C compiler, no cmake, and nothing that only a feature needs");
    for known in ["cc", "cmake", "osqp-sys", "plotters", "clap"] {
        assert!(all.iter().any(|name| is(name, known)), "with all features there is {known}: {all:?}");
    }
}

#[test]
fn the_numbers_of_dependencies_are_right() {
    let text = architecture();
    let (all, core) = (crates("normal", &["--all-features"]).len(), crates("normal", &["--no-default-features"]).len());
    for sentence in [
        format!("With all features the library and the program need {all} crates by others."),
        format!("Without any (`--no-default-features`) the library needs {core} crates, all of them Rust"),
    ] {
        assert!(text.contains(&sentence), "ARCHITECTURE.md does not say: {sentence}");
    }
}

#[test]
fn every_direct_dependency_says_what_it_is_for() {
    let manifest = files("Cargo.toml", "").remove("Cargo.toml").unwrap_or_default();
    let section = manifest.split("\n[dependencies]\n").nth(1).and_then(|rest| rest.split("\n[").next());
    let lines: Vec<&str> = section.unwrap_or_default().lines().collect();
    let direct = || (0..lines.len()).filter(|&i| lines[i].contains(" = ") && !lines[i].starts_with('#'));
    assert!(5 < direct().count(), "Cargo.toml was read: {lines:?}");
    let is_explained = |i: usize| i.checked_sub(1).is_some_and(|above| lines[above].starts_with("# "));
    let found: Vec<String> = direct().filter(|&i| !is_explained(i)).map(|i| lines[i].to_owned()).collect();
    none(&found, "a dependency has a comment that says what it is for");
}
