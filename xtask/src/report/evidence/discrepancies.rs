//! Where we depart from the paper: collected from the comments that begin with `// Discrepancy: <id>`.

use std::collections::BTreeMap;
use std::fs;

use minijinja::{Value, context};

use crate::report::error::Cause;
use crate::report::evidence::Evidence;
use crate::report::files;
use crate::report::study::Study;

/// The line that opens a block.
const OPENING: &str = "// Discrepancy: ";

/// One departure, as told where the code departs.
#[derive(Debug, PartialEq, Eq)]
struct Discrepancy {
    id: String,
    /// Path relative to the root.
    file: String,
    /// Line of the opening, from 1.
    line: usize,
    /// Paragraphs of the block, separated by empty lines.
    text: String,
}

/// Why a block cannot be read.
#[derive(Debug, thiserror::Error, PartialEq, Eq)]
enum BlockError {
    #[error("{file}:{line}: `{id}` must be an id of small letters, digits and hyphens")]
    Id { file: String, line: usize, id: String },
    #[error("{file}:{line}: after `// Discrepancy: {id}` must come a line `//` and then prose")]
    NoProse { file: String, line: usize, id: String },
    #[error("{file}:{line}: the discrepancy `{id}` is also told in {other}")]
    Twice { file: String, line: usize, id: String, other: String },
}

pub(super) fn evidence(study: &Study<'_>) -> Result<Evidence, Cause> {
    let mut sources = BTreeMap::new();
    let places = [files::list(study.root, "src")?, files::list(study.root, "tests/evidence")?];
    for path in places.into_iter().flatten().filter(|path| path.ends_with(".rs")) {
        let text = fs::read_to_string(study.root.join(&path))?;
        sources.insert(path, text);
    }
    let entries = collect(&sources)?.into_iter().map(|d| context! { id => d.id, file => d.file, text => d.text });
    let entries: Vec<Value> = entries.collect();
    Ok(Evidence::new(context! { count => entries.len(), entries }))
}

/// All blocks, ordered by id, so that moving code from file to file does not reorder the chapter.
fn collect(sources: &BTreeMap<String, String>) -> Result<Vec<Discrepancy>, BlockError> {
    let mut found: BTreeMap<String, Discrepancy> = BTreeMap::new();
    for (file, text) in sources {
        let lines: Vec<&str> = text.lines().map(str::trim).collect();
        for (index, opening) in lines.iter().enumerate() {
            let Some(id) = opening.strip_prefix(OPENING) else { continue };
            let block = read(file, index + 1, id, &lines[index + 1..])?;
            if let Some(other) = found.get(id) {
                let (line, id, other) = (block.line, block.id, other.file.clone());
                return Err(BlockError::Twice { file: block.file, line, id, other });
            }
            found.insert(block.id.clone(), block);
        }
    }
    Ok(found.into_values().collect())
}

/// Reads the block whose opening is line `line`; `rest` is what follows.
fn read(file: &str, line: usize, id: &str, rest: &[&str]) -> Result<Discrepancy, BlockError> {
    let (file, id) = (file.to_owned(), id.to_owned());
    let in_id = |c: char| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '-';
    if id.is_empty() || !id.chars().all(in_id) {
        return Err(BlockError::Id { file, line, id });
    }
    // `///` and `//!` are documentation of something else.
    let comment =
        |line: &&str| line.strip_prefix("//").filter(|text| text.is_empty() || text.starts_with(' ')).is_some();
    let block: Vec<&str> = rest.iter().copied().take_while(comment).collect();
    let [separator, prose @ ..] = block.as_slice() else {
        return Err(BlockError::NoProse { file, line, id });
    };
    let text: Vec<&str> = prose.iter().map(|line| line.trim_start_matches("//").trim()).collect();
    let text = text.join("\n").trim().to_owned();
    if *separator != "//" || text.is_empty() {
        return Err(BlockError::NoProse { file, line, id });
    }
    Ok(Discrepancy { id, file, line, text })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn collected(text: &str) -> Result<Vec<Discrepancy>, BlockError> {
        collect(&BTreeMap::from([("src/a.rs".to_owned(), text.to_owned())]))
    }

    #[test]
    fn blocks_are_collected_by_id() {
        let text = "//! x\n    // Discrepancy: fig-05-load\n    //\n    // Labelled q = 10.\n    //\n    // We use\n    // 1.0.\n\
                    let q = 1.0; // Discrepancy: not at the start of a line\n// Discrepancy: eq-2\n//\n// b\n/// doc\n";
        let entry = |id: &str, line, text: &str| Discrepancy {
            id: id.to_owned(),
            file: "src/a.rs".to_owned(),
            line,
            text: text.to_owned(),
        };
        assert_eq!(
            collected(text),
            Ok(vec![entry("eq-2", 9, "b"), entry("fig-05-load", 2, "Labelled q = 10.\n\nWe use\n1.0.")])
        );
    }

    #[test]
    fn blocks_that_cannot_be_read_are_errors() {
        let message = |text| collected(text).map_err(|error| error.to_string());
        let no_prose = Err("src/a.rs:1: after `// Discrepancy: a` must come a line `//` and then prose".to_owned());
        assert_eq!(message("// Discrepancy: a\nfn f() {}"), no_prose, "nothing follows");
        assert_eq!(message("// Discrepancy: a\n// prose"), no_prose, "no empty line");
        assert_eq!(message("// Discrepancy: a\n//\n//\nx"), no_prose, "no prose");
        assert!(message("// Discrepancy: A b\n//\n// c").is_err_and(|m| m.contains("must be an id")), "not an id");
        let twice = "// Discrepancy: a\n//\n// b\n\n// Discrepancy: a\n//\n// c";
        assert!(message(twice).is_err_and(|m| m.contains("also told in src/a.rs")), "two of one id");
    }
}
