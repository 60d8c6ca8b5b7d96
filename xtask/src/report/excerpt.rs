//! Code that the report shows beside its text, cut out of the sources between two markers, so that neither can drift:
//!
//! ```text
//! // Report: three-moments
//! …
//! // Report: end
//! ```

use std::collections::BTreeMap;
use std::path::Path;

use super::files;
use crate::Cause;

/// The most lines that a reader takes in beside the text; source that needs more is too long.
const MOST: usize = 20;

/// Some lines of a source file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Excerpt {
    /// The file, relative to the root.
    pub(super) path: String,
    /// The lines between the markers, without their common indentation.
    pub(super) code: String,
}

/// All excerpts of the sources, by name.
pub(super) fn all(root: &Path) -> Result<BTreeMap<String, Excerpt>, Cause> {
    let mut found = BTreeMap::new();
    for (path, text) in files::texts(root, &["src"], &[".rs"])? {
        for (name, excerpt) in of(&path, &text).map_err(|error| format!("{path}: {error}"))? {
            if found.insert(name.clone(), excerpt).is_some() {
                return Err(format!("{path}: there are two excerpts `{name}`").into());
            }
        }
    }
    Ok(found)
}

/// The excerpts of one file.
fn of(path: &str, text: &str) -> Result<Vec<(String, Excerpt)>, Cause> {
    let mut found = Vec::new();
    let mut open: Option<(String, Vec<&str>)> = None;
    for line in text.lines() {
        match (line.trim_start().strip_prefix("// Report: "), open.take()) {
            (Some("end"), Some((name, lines))) if lines.len() <= MOST => {
                found.push((name, Excerpt { path: path.to_owned(), code: unindented(&lines) }));
            }
            (Some("end"), Some((name, lines))) => {
                return Err(format!("the excerpt `{name}` has {} lines, at most {MOST} are shown", lines.len()).into());
            }
            (Some("end"), None) => return Err("an excerpt ends that has not begun".into()),
            (Some(name), None) => open = Some((name.to_owned(), Vec::new())),
            (Some(name), Some(_)) => return Err(format!("`{name}` begins inside another excerpt").into()),
            (None, Some((name, mut lines))) => {
                lines.push(line);
                open = Some((name, lines));
            }
            (None, None) => {}
        }
    }
    match open {
        Some((name, _)) => Err(format!("the excerpt `{name}` does not end").into()),
        None => Ok(found),
    }
}

/// The lines without the indentation that all of them have.
fn unindented(lines: &[&str]) -> String {
    let indented = lines.iter().filter(|line| !line.trim().is_empty());
    let common = indented.map(|line| line.len() - line.trim_start().len()).min().unwrap_or(0);
    let lines: Vec<&str> = lines.iter().map(|line| line.get(common..).unwrap_or_default()).collect();
    lines.join("\n")
}

impl Excerpt {
    /// As Markdown, with a link to the file from a document `up` (`..` or `../..`) below the root.
    pub(super) fn markdown(&self, up: &str) -> String {
        format!("```rust\n{}\n```\n\nFrom [{}]({up}/{}).", self.code, self.path, self.path)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_between_markers_are_shown() {
        let text = "fn f() {\n    // Report: a\n    if x {\n        y\n    }\n    // Report: end\n}\n";
        let found = of("src/f.rs", text).expect("it begins and ends");
        let expected = Excerpt { path: "src/f.rs".to_owned(), code: "if x {\n    y\n}".to_owned() };
        assert_eq!(found, [("a".to_owned(), expected)]);
    }

    #[test]
    fn what_cannot_be_shown_is_refused() {
        let long = format!("// Report: a\n{}// Report: end\n", "x\n".repeat(MOST + 1));
        for text in ["// Report: end\n", "// Report: a\n", "// Report: a\n// Report: b\n// Report: end\n", &long] {
            assert!(of("src/f.rs", text).is_err(), "{text}");
        }
    }
}
