//! The files of this repository as text.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

/// Hidden files and directories that belong to the repository; others are somebody's own, or git's.
const HIDDEN: [&str; 4] = [".cargo", ".ci", ".github", ".gitignore"];

/// True for what no commit contains: hidden files, and directories that cargo has marked as its products.
fn is_not_ours(path: &Path) -> bool {
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    let hidden = name.starts_with('.') && !HIDDEN.contains(&name.as_ref());
    hidden || name == "target" || path.join("CACHEDIR.TAG").exists()
}

/// The root of the repository.
pub(super) fn root() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR"))
}

/// The text files below `place` (a directory or a file, relative to the root) whose name ends with `ending`:
/// path relative to the root, with `/` → text. Empty if there is no such place.
pub(super) fn files(place: &str, ending: &str) -> BTreeMap<String, String> {
    let mut found = BTreeMap::new();
    collect(&root().join(place), ending, &mut found);
    found
}

fn collect(path: &Path, ending: &str, found: &mut BTreeMap<String, String>) {
    if path.is_dir() {
        let entries = fs::read_dir(path).unwrap_or_else(|e| panic!("cannot list {}: {e}", path.display()));
        for entry in entries {
            let entry = entry.unwrap_or_else(|e| panic!("cannot list {}: {e}", path.display())).path();
            if !is_not_ours(&entry) {
                collect(&entry, ending, found);
            }
        }
    } else if path.to_string_lossy().ends_with(ending) {
        // Files that are not text have nothing to say here.
        if let Ok(text) = fs::read_to_string(path) {
            let relative = path.strip_prefix(root()).unwrap_or(path);
            let parts: Vec<_> = relative.iter().map(|part| part.to_string_lossy()).collect();
            found.insert(parts.join("/"), text);
        }
    }
}

/// The Rust files below a directory that has to exist by now.
pub(super) fn rust_files(directory: &str) -> BTreeMap<String, String> {
    let found = files(directory, ".rs");
    assert!(!found.is_empty(), "{directory} has no Rust files: correct the list of the test that asks for it");
    found
}

/// The code of a line, without its comment. A `//` in a string literal cuts the line short, which hides nothing that
/// these tests look for.
pub(super) fn code(line: &str) -> &str {
    line.split("//").next().unwrap_or_default()
}

/// The words of a text: maximal runs of letters, digits and `_`.
pub(super) fn words(text: &str) -> impl Iterator<Item = &str> {
    text.split(|c: char| !(c.is_alphanumeric() || c == '_')).filter(|word| !word.is_empty())
}

/// Every line of `files` that `offends` names a reason for, as `path:line: reason`.
pub(super) fn offenders(files: &BTreeMap<String, String>, offends: impl Fn(&str) -> Option<String>) -> Vec<String> {
    let mut found = Vec::new();
    for (path, text) in files {
        for (index, line) in text.lines().enumerate() {
            if let Some(reason) = offends(line) {
                found.push(format!("{path}:{}: {reason}", index + 1));
            }
        }
    }
    found
}

/// Fails with the list, if there is anything in it.
#[track_caller]
pub(super) fn none(offenders: &[String], invariant: &str) {
    assert!(offenders.is_empty(), "{invariant}\n  {}", offenders.join("\n  "));
}

/// The first of `forbidden` among the words of a text.
pub(super) fn first_word_of<'a>(text: &'a str, forbidden: &[&str]) -> Option<&'a str> {
    words(text).find(|word| forbidden.iter().any(|f| f.eq_ignore_ascii_case(word)))
}
