//! What every file of the tree keeps to.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;
use std::process::Command;

use super::text::{code, files, first_word_of, none, offenders, root, rust_files, words};

/// What is read at one sitting.
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
fn every_file_is_read_at_one_sitting() {
    let lines = |(path, text): (String, String)| (path, text.lines().count());
    let long = all_rust_files().into_iter().map(lines).filter(|(_, lines)| LONGEST_FILE < *lines);
    let found: Vec<_> = long.map(|(path, lines)| format!("{path}: {lines} lines")).collect();
    none(&found, "a file has at most 400 lines");
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

/// Equations of the paper that a text cites, `(1)` to `(35)`; an argument of a call is none.
fn equations(text: &str) -> BTreeSet<u32> {
    let calls = |before: &str| before.ends_with(|c: char| c.is_alphanumeric() || matches!(c, '_' | ']' | ')' | '!'));
    let opening = text.match_indices('(').filter(|(at, _)| !calls(&text[..*at]));
    let number = opening.filter_map(|(at, _)| text[at + 1..].split_once(')')?.0.parse().ok());
    number.filter(|number| (1..=35).contains(number)).collect()
}

/// What the comments of a file cite.
fn cited(source: &str) -> BTreeSet<u32> {
    source.lines().filter_map(|line| line.split_once("//")).flat_map(|(_, comment)| equations(comment)).collect()
}

/// For each row of the notation table the names that the code has for a symbol of the paper, and each equation of the row must
/// be cited in a file whose code uses one of these names.
#[test]
fn every_equation_of_the_notation_is_cited_where_it_is_used() {
    let mut sources = rust_files("src");
    let lib = sources.remove("src/lib.rs").unwrap_or_default();
    let uses = |source: &str, names: &[&str]| source.lines().any(|line| first_word_of(code(line), names).is_some());
    let (mut missing, mut rows) = (Vec::new(), 0);
    for row in lib.lines().filter_map(|line| line.strip_prefix("//! | ")) {
        let cells: Vec<&str> = row.split(" | ").collect();
        let [_, names, .., last] = cells[..] else { continue };
        let names: Vec<&str> = names.split('`').skip(1).step_by(2).collect();
        for equation in equations(last) {
            rows += 1;
            if !sources.values().any(|source| cited(source).contains(&equation) && uses(source, &names)) {
                missing.push(format!("({equation}) of {names:?}"));
            }
        }
    }
    assert!(10 < rows, "the notation table was read: {rows} equations");
    none(&missing, "an equation of the notation table in src/lib.rs is cited in no file that uses its name");
}

#[test]
fn equations_are_told_from_arguments() {
    assert_eq!(cited("let x = number(6); // as in (32), f(33)\n/// (4)–(16), \\[(5)\\]"), [4, 5, 16, 32].into());
    assert_eq!(cited("let x = (6);"), [].into(), "code cites nothing");
}

/// The build of the C library takes a C compiler and nothing else: it installs nothing, and says what is missing.
#[cfg(unix)]
#[test]
fn the_build_installs_nothing() {
    const LAUNCHER: &str = "xtask/cmake/launch";
    let script = fs::read_to_string(root().join(LAUNCHER)).expect("the stand-in for cmake");
    for word in ["apt-get", "pip", "curl", "wget", "http", "sudo"] {
        assert!(!script.contains(word), "{LAUNCHER} has {word:?}");
    }
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("launcher.{}", std::process::id()));
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(folder.join("configure")).expect("a folder for sources");
    for file in ["CMakeLists.txt", "configure/osqp_configure.h.in"] {
        fs::write(folder.join(file), "").expect("a file of the sources");
    }
    for (name, set) in [("CC", "no-such-compiler"), ("AR", "no-such-archiver")] {
        let mut command = Command::new(root().join(LAUNCHER));
        command.arg(&folder).current_dir(&folder).env("CC", "true").env(name, set);
        let output = command.output().expect("it starts");
        let said = String::from_utf8_lossy(&output.stderr);
        assert!(!output.status.success() && said.contains(set) && said.contains("is not there"), "{said}");
    }
    // What is left of it harms nobody.
    let _ = fs::remove_dir_all(&folder);
}
