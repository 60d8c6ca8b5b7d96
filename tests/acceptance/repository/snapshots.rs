//! Snapshots on disk and tables in the tests are the same set.

use std::collections::BTreeSet;

use super::text::{code, files, none, offenders, rust_files};

/// The literal names that `source` hands to the macro, with its opening parenthesis as `call`.
fn names(source: &str, call: &str) -> Vec<String> {
    let code: String = source.lines().map(|line| format!("{}\n", code(line))).collect();
    code.split(call)
        .skip(1)
        .filter_map(|rest| Some(rest.trim_start().strip_prefix('"')?.split_once('"')?.0.to_owned()))
        .collect()
}

#[test]
fn every_table_has_its_snapshot_and_every_snapshot_its_table() {
    // In two parts, so that this file does not call what it looks for.
    let calls = [["assert_table", "!("].concat(), ["assert_text", "!("].concat()];
    let mut asserted = Vec::new();
    for source in rust_files("tests/acceptance").values() {
        asserted.extend(calls.iter().flat_map(|call| names(source, call)));
    }
    let named: BTreeSet<_> = asserted.iter().cloned().collect();
    assert_eq!(named.len(), asserted.len(), "each table has a name of its own");

    let stored: BTreeSet<_> = files("snapshots", ".snap")
        .into_keys()
        .map(|path| path.trim_start_matches("snapshots/").trim_end_matches(".snap").to_owned())
        .collect();
    // A scene in a folder has the folder in the name of its page.
    let scenes = files("report/scenes", ".toml")
        .into_keys()
        .filter(|path| !path.contains("/bodies/") && !path.contains("/trains/"));
    let pages = scenes.map(|path| format!("page@{}", path.trim_start_matches("report/scenes/").replace('/', "__")));
    let expected: BTreeSet<_> = named.into_iter().chain(pages).collect();
    assert_eq!(expected, stored, "tables in tests/acceptance and scenes (left) and files in snapshots/ (right)");
}

#[test]
fn only_the_macro_configures_insta() {
    let mut tests = rust_files("tests/acceptance");
    tests.remove("tests/acceptance/support.rs");
    let settings = ["with", "_settings!"].concat();
    let found = offenders(&tests, |line| code(line).contains(&settings).then(|| "configures insta".to_owned()));
    none(&found, "insta is configured in tests/acceptance/support.rs alone");
}

#[test]
fn names_are_found_across_lines_and_not_in_comments() {
    let source = "table!(\"a\", x);\n  // table!(\"b\")\n table!(\n    \"c\",\n x)";
    assert_eq!(names(source, "table!("), ["a", "c"], "two calls and a comment");
}
