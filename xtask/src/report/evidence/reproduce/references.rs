//! Every work that is cited is in the list of references, and every reference is cited.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

use crate::report::error::Cause;
use crate::report::files;

/// The template with the list, and its heading.
const LIST: &str = "report/templates/provenance.md";
const HEADING: &str = "## References\n";

#[derive(Debug, thiserror::Error, PartialEq, Eq)]
enum ReferenceError {
    #[error("{file} cites {name} {year}, which is not among the references of {LIST}")]
    NotListed { file: String, name: String, year: String },
    #[error("nothing cites the reference `{0}` of {LIST}")]
    NotCited(String),
}

/// Compares the citations in code, tests and templates with the list.
pub(super) fn check(root: &Path) -> Result<(), Cause> {
    let mut texts = Vec::new();
    for directory in ["src", "tests", "report/templates"] {
        for path in files::list(root, directory)? {
            if path.ends_with(".rs") || path.ends_with(".md") {
                let text = fs::read_to_string(root.join(&path))?;
                texts.push((path, text));
            }
        }
    }
    Ok(compare(&texts)?)
}

fn compare(texts: &[(String, String)]) -> Result<(), ReferenceError> {
    let listed = texts.iter().find(|(path, _)| path == LIST).and_then(|(_, text)| text.split_once(HEADING));
    let listed = listed.map_or("", |(_, after)| after.split("\n## ").next().unwrap_or(after));
    let references: Vec<&str> = listed.lines().filter_map(|line| line.strip_prefix("- ")).collect();
    let mut cited = BTreeSet::new();
    for (file, text) in texts {
        for (name, year) in citations(&text.replace(listed, "")) {
            let Some(reference) = references.iter().find(|line| line.contains(name) && line.contains(year)) else {
                let (file, name, year) = (file.clone(), name.to_owned(), year.to_owned());
                return Err(ReferenceError::NotListed { file, name, year });
            };
            cited.insert(*reference);
        }
    }
    match references.iter().find(|line| !cited.contains(*line)) {
        Some(line) => Err(ReferenceError::NotCited((*line).to_owned())),
        None => Ok(()),
    }
}

/// Names with the year behind them: `Hencky 1920)`, `Clapeyron (1857)`.
fn citations(text: &str) -> Vec<(&str, &str)> {
    let words: Vec<&str> = text.split_whitespace().collect();
    let trimmed = |word| str::trim_matches(word, |c: char| !c.is_alphanumeric());
    let pairs = words.windows(2).filter(|w| w[1].ends_with([')', ',', ';', ':', '.']) || w[1].starts_with('('));
    let pairs = pairs.map(|w| (trimmed(w[0]), trimmed(w[1])));
    let is_name = |word: &str| word.chars().all(char::is_alphabetic) && word.starts_with(char::is_uppercase);
    let is_year = |word: &str| word.len() == 4 && ["18", "19", "20"].iter().any(|century| word.starts_with(century));
    pairs
        .filter(|(name, year)| 2 < name.len() && is_name(name) && is_year(year) && year.parse::<u16>().is_ok())
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn compared(code: &str, list: &str) -> Result<(), String> {
        let texts = [("src/a.rs", code.to_owned()), (LIST, format!("# P\n{HEADING}\n{list}\n\n## Next\n"))];
        compare(&texts.map(|(path, text)| (path.to_owned(), text))).map_err(|error| error.to_string())
    }

    #[test]
    fn citations_and_references_are_the_same_set() {
        let code = "// Links (Hencky 1920), three moments of Clapeyron (1857); on 2000 intervals, seed 1984.";
        let list = "- Clapeyron, E., *Poutre*, 1857.\n- Hencky, H., *Gelenkkette*, 1920.";
        assert_eq!(compared(code, list), Ok(()));
        assert!(compared(code, "- Hencky, H., 1920.").is_err_and(|m| m.starts_with("src/a.rs cites Clapeyron 1857")));
        assert!(compared("", list).is_err_and(|m| m.starts_with("nothing cites the reference `Clapeyron")));
    }
}
