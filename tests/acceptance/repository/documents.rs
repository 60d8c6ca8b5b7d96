//! What the documents say about the code is so.

use std::process::Command;

use palkki::scene::file::ReadProblem;
use palkki_evidence::numdiff::numdiff;

use super::text::{files, root, rust_files, words};

/// The text of a document at the root.
fn document(name: &str) -> String {
    files(name, "").remove(name).unwrap_or_else(|| panic!("{name} is missing"))
}

/// What stands between single backticks, outside of fenced blocks.
fn code_spans(markdown: &str) -> Vec<&str> {
    let prose = markdown.split("```").step_by(2);
    prose.flat_map(|text| text.split('`').skip(1).step_by(2)).collect()
}

#[test]
fn the_map_is_the_territory() {
    let map = document("ARCHITECTURE.md");
    let spans = code_spans(&map);

    let tops = ["src/", "tests/", "xtask/", "report/"];
    let paths: Vec<_> = spans.iter().filter(|span| tops.iter().any(|top| span.starts_with(top))).collect();
    assert!(!paths.is_empty(), "the map names places");
    for path in paths {
        assert!(root().join(path).exists(), "ARCHITECTURE.md names {path}, which does not exist");
    }

    for path in rust_files("src").keys().chain(rust_files("tests").keys()) {
        // `src/scene/beam.rs` is in the part `src/scene`, `src/solve.rs` is a part of its own.
        let part: Vec<&str> = path.split('/').take(2).collect();
        let part = part.join("/");
        assert!(spans.contains(&part.as_str()), "ARCHITECTURE.md does not name {part}");
    }

    let tests = rust_files("tests/acceptance").into_values().collect::<String>();
    let named: Vec<_> = map
        .lines()
        .filter(|line| line.starts_with("| "))
        .filter_map(|line| line.trim_end_matches([' ', '|']).rsplit_once(" | "))
        .flat_map(|(_, last)| code_spans(last))
        .filter(|span| span.matches('_').count() >= 3 && words(span).count() == 1)
        .collect();
    assert!(named.len() > 10, "the table of invariants names tests: {named:?}");
    for name in named {
        assert!(tests.contains(&format!("fn {name}()")), "ARCHITECTURE.md names the test {name}, which does not exist");
    }
}

/// The lines of `excerpt` that are not found, in order, among those of `printed`; `…` stands for any lines.
fn not_printed<'a>(excerpt: &'a str, printed: &str) -> Vec<&'a str> {
    let mut rest = printed.lines();
    let shown = excerpt.lines().filter(|line| *line != "…");
    shown.filter(|line| !rest.by_ref().any(|other| numdiff(line, other).is_ok())).collect()
}

#[test]
fn the_readme_shows_what_is_printed() {
    let readme = document("README.md");
    let blocks = readme.split("```console\n").skip(1).filter_map(|rest| rest.split_once("```"));
    let mut shown = 0;
    for (block, _) in blocks {
        let Some((command, excerpt)) = block.split_once('\n') else { continue };
        let Some(arguments) = command.strip_prefix("$ cargo run -- ") else { continue };
        let output = Command::new(env!("CARGO_BIN_EXE_palkki"))
            .args(arguments.split_whitespace())
            .current_dir(root())
            .output()
            .unwrap_or_else(|e| panic!("palkki does not start: {e}"));
        let printed = String::from_utf8_lossy(&output.stdout);
        let missing = not_printed(excerpt, &printed);
        assert!(missing.is_empty(), "`{command}` does not print, in this order: {missing:#?}\n{printed}");
        shown += 1;
    }
    assert!(0 < shown, "the README shows the command line");
}

#[test]
fn the_scene_of_the_readme_is_one() {
    let readme = document("README.md");
    let scene = readme.split("```toml\n").nth(1).and_then(|rest| rest.split("```").next()).unwrap_or_default();
    let parsed = palkki::scene::file::parse("README.md", scene, |_| Err(ReadProblem::Missing));
    assert!(parsed.is_ok(), "{parsed:?}\n{scene}");
}

#[test]
fn what_is_not_printed_is_found() {
    let printed = "a\nb 1.00\nc\n";
    assert!(not_printed("…\nb 1.01\n…\nc", printed).is_empty(), "an excerpt, one unit off");
    assert_eq!(not_printed("b 1.02", printed), ["b 1.02"], "another number");
    assert_eq!(not_printed("c\na", printed), ["a"], "another order");
}

/// Who cites a version cites the one of the package.
#[test]
fn the_citation_names_the_version_of_the_package() {
    let citation = document("CITATION.cff");
    let version = citation.lines().find_map(|line| line.strip_prefix("version: "));
    assert_eq!(version, Some(env!("CARGO_PKG_VERSION")));
}
