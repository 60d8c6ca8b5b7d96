//! What a reader has to hold: named numbers have a reason, and the list of types in ARCHITECTURE.md is right.

use super::text::{code, files, none, rust_files};

/// The room whose numbers are not all explained yet: the measures of a drawing.
const NOT_YET: [&str; 1] = ["src/plot/"];

/// Whether a line gives a name to a number, or to some of them.
fn names_a_number(line: &str) -> bool {
    let Some((_, kind)) = code(line).split_once("const ").and_then(|(_, rest)| rest.split_once(": ")) else {
        return false;
    };
    let kind = kind.trim_start_matches(['&', '[']);
    ["f64", "usize", "u128", "u64", "u32", "u16", "u8", "i64", "i32"]
        .iter()
        .any(|number| kind.strip_prefix(number).is_some_and(|rest| rest.starts_with([' ', ';', ']'])))
}

/// Line numbers of named numbers without a comment of their own.
fn unexplained(text: &str) -> Vec<usize> {
    let lines: Vec<&str> = text.lines().take_while(|line| *line != "#[cfg(test)]").collect();
    let is_explained = |i: usize| {
        let above = lines[..i].iter().rev().find(|line| !line.trim_start().starts_with("#["));
        above.is_some_and(|line| line.trim_start().starts_with("//"))
    };
    (0..lines.len()).filter(|&i| names_a_number(lines[i]) && !is_explained(i)).map(|i| i + 1).collect()
}

#[test]
fn every_named_number_has_its_reason() {
    let ours = rust_files("src").into_iter().filter(|(path, _)| !NOT_YET.iter().any(|room| path.starts_with(room)));
    let ours = ours.filter(|(path, _)| !path.contains("/tests"));
    let found: Vec<String> = ours
        .flat_map(|(path, text)| unexplained(&text).into_iter().map(move |line| format!("{path}:{line}")))
        .collect();
    none(&found, "a named number has a comment with its reason, or the word *tuned* and on what");
}

#[test]
fn named_numbers_are_recognised() {
    let text = "/// Why.\nconst A: f64 = 1.0;\nconst B: [usize; 2] = [1, 2];\n// Why.\n#[expect(dead_code)]\npub const C: u8 = 1;\n\n\
        const D: &str = \"\";\n    const E: i32 = 1;\n#[cfg(test)]\nconst F: f64 = 1.0;\n";
    assert_eq!(unexplained(text), [3, 9]);
}

/// The types that a source defines.
fn types(text: &str) -> impl Iterator<Item = &str> {
    text.lines().take_while(|line| *line != "#[cfg(test)]").filter_map(|line| {
        let line = code(line).trim_start();
        let line = ["pub ", "pub(crate) ", "pub(super) "].iter().find_map(|p| line.strip_prefix(p)).unwrap_or(line);
        let name = ["struct ", "enum ", "trait "].iter().find_map(|p| line.strip_prefix(p))?;
        name.split(|c: char| !c.is_alphanumeric()).next()
    })
}

#[test]
fn the_names_of_types_are_right() {
    let text = files("ARCHITECTURE.md", ".md").remove("ARCHITECTURE.md").expect("it is there");
    let section = text.split("\n## ").find(|section| section.starts_with("Names")).expect("a section of names");
    let sources = rust_files("src");
    let named: Vec<[&str; 2]> = section
        .split('`')
        .skip(1)
        .step_by(2)
        .filter_map(|name| name.rsplit_once("::").map(|(file, name)| [file, name]))
        .collect();
    assert!(20 < named.len(), "{named:?}");
    let source = |file: &str| {
        let place = format!("src/{}", file.replace("::", "/"));
        sources.get(&format!("{place}.rs")).or_else(|| sources.get(&format!("{place}/mod.rs")))
    };
    let is_there = |[file, name]: &[&str; 2]| source(file).is_some_and(|text| types(text).any(|found| found == *name));
    let wrong: Vec<String> = named.iter().filter(|name| !is_there(name)).map(|name| name.join("::")).collect();
    none(&wrong, "a type that ARCHITECTURE.md names is where it says");
    let nodes = |text: &str| types(text).filter(|name| name.ends_with("Node")).map(str::to_owned).collect::<Vec<_>>();
    let found = sources.iter().filter(|(path, _)| !path.contains("/tests")).flat_map(|(_, text)| nodes(text)).count();
    assert_eq!(found, named.iter().filter(|[_, name]| name.ends_with("Node")).count(), "types that are called a node");
}
