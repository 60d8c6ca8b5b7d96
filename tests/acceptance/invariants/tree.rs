//! What every file of the tree keeps to.

use std::collections::{BTreeMap, BTreeSet};

use super::text::{files, none, offenders, root, rust_files, words};

/// Past this many lines a file holds two ideas. The guide says 150 for most; the longest match or test list needs more.
const LONGEST_FILE: usize = 400;

fn all_rust_files() -> BTreeMap<String, String> {
    let mut all = rust_files("src");
    all.extend(rust_files("tests"));
    all.extend(rust_files("xtask"));
    all
}

#[test]
fn every_file_says_what_it_is() {
    let found: Vec<_> = all_rust_files()
        .into_iter()
        .filter(|(_, text)| !text.lines().next().is_some_and(|first| first.starts_with("//! ") && 10 < first.len()))
        .map(|(path, _)| path)
        .collect();
    none(&found, "every Rust file begins with a line that starts with `//!` and says what the file is");
}

#[test]
fn every_file_names_its_idea() {
    let nameless = ["utils", "util", "helpers", "helper", "common", "misc"];
    let found: Vec<_> =
        all_rust_files().into_keys().filter(|path| words(path).any(|word| nameless.contains(&word))).collect();
    none(&found, "a file is named after its idea");
}

#[test]
fn no_file_holds_two_ideas() {
    let found: Vec<_> = all_rust_files()
        .into_iter()
        .map(|(path, text)| (path, text.lines().count()))
        .filter(|(_, lines)| LONGEST_FILE < *lines)
        .map(|(path, lines)| format!("{path}: {lines} lines"))
        .collect();
    none(&found, "a file has one idea");
}

#[test]
fn nothing_in_the_tree_belongs_to_one_machine() {
    // Put together here, so that this file does not contain what it looks for.
    let mut foreign: Vec<String> =
        ["/work", "/root", "/tmp", "/home", "shared"].iter().map(|directory| format!("{directory}/")).collect();
    foreign.push(root().to_string_lossy().into_owned());
    foreign.extend(["pypi", "files.pythonhosted"].iter().map(|host| format!("{host}.{}", "org")));
    foreign.extend(["index.crates", "static.crates"].iter().map(|host| format!("{host}.{}", "io")));

    let mut tree = files("", "");
    assert!(tree.contains_key("Cargo.toml") && tree.contains_key(".ci/run"), "the tree was read");
    tree.remove("Cargo.lock");
    let found = offenders(&tree, |line| {
        foreign.iter().find(|foreign| line.contains(foreign.as_str())).map(|foreign| format!("`{foreign}`"))
    });
    none(&found, "no path of a machine and no host of a package registry");
}

#[test]
fn every_dependency_comes_from_the_public_registry() {
    let lock = &files("Cargo.lock", "")["Cargo.lock"];
    let sources: BTreeSet<_> = lock.lines().filter_map(|line| line.strip_prefix("source = ")).collect();
    assert_eq!(
        sources.into_iter().collect::<Vec<_>>(),
        ["\"registry+https://github.com/rust-lang/crates.io-index\""],
        "Cargo.lock names one source"
    );
}

/// Equation numbers `(1)` … `(35)` of a text; `(4)–(16)` names its two ends.
fn equations(text: &str) -> BTreeSet<u32> {
    text.split('(')
        .skip(1)
        .filter_map(|rest| rest.split_once(')')?.0.parse().ok())
        .filter(|number| (1..=35).contains(number))
        .collect()
}

#[test]
fn every_equation_of_the_notation_is_cited_where_it_is_used() {
    let mut sources = rust_files("src");
    let lib = sources.remove("src/lib.rs").unwrap_or_default();
    let table: Vec<_> = lib.lines().filter(|line| line.starts_with("//! |")).collect();
    let listed = equations(&table.join("\n"));
    assert_eq!(listed.is_empty(), table.is_empty(), "a notation table lists equations");

    let cited: BTreeSet<u32> = sources.values().flat_map(|text| equations(text)).collect();
    assert!(!cited.is_empty(), "the sources cite the paper");
    let missing: Vec<_> = listed.difference(&cited).map(|number| format!("({number})")).collect();
    none(&missing, "an equation of the notation table in src/lib.rs is cited in no other file");
}
