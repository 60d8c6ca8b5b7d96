//! Where the report comes from: departures from the paper, references, and what it takes to reproduce it.

use std::collections::{BTreeMap, BTreeSet};

use super::prelude::*;
use crate::report::files;

/// The line that opens a block.
const OPENING: &str = "// Discrepancy: ";

/// One departure, as told where the code departs: the file, the line of the opening, and the paragraphs, separated by empty lines.
type Discrepancy = (String, usize, String);

/// Where we depart from the paper: collected from the comments that begin with `// Discrepancy: <id>`.
pub(super) fn discrepancies(study: &Study<'_>) -> Result<Evidence, Cause> {
    let entries = collect(&files::texts(study.root, &["src", "tests/evidence", "xtask/src"], &[".rs"])?)?
        .into_iter()
        .map(|(id, (file, _, text))| context! { id, file, text });
    let entries: Vec<Value> = entries.collect();
    Ok(Evidence::new(context! { count => entries.len(), entries }))
}

/// All blocks by their ids, so that moving code from file to file does not reorder the chapter.
fn collect(sources: &[(String, String)]) -> Result<BTreeMap<String, Discrepancy>, Cause> {
    let mut found: BTreeMap<String, Discrepancy> = BTreeMap::new();
    for (file, text) in sources {
        let lines: Vec<&str> = text.lines().map(str::trim).collect();
        for (index, opening) in lines.iter().enumerate() {
            let Some(id) = opening.strip_prefix(OPENING) else { continue };
            let block = block(file, index + 1, id, &lines[index + 1..])?;
            if let Some((other, ..)) = found.get(id) {
                return Err(format!("{file}:{}: the discrepancy `{id}` is also told in {other}", index + 1).into());
            }
            found.insert((*id).to_owned(), block);
        }
    }
    Ok(found)
}

/// Reads the block whose opening is line `line`; `rest` is what follows.
fn block(file: &str, line: usize, id: &str, rest: &[&str]) -> Result<Discrepancy, Cause> {
    let in_id = |c: char| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '-';
    if id.is_empty() || !id.chars().all(in_id) {
        let message = format!("{file}:{line}: `{id}` must be an id of small letters, digits and hyphens");
        return Err(message.into());
    }
    // `///` and `//!` are documentation of something else.
    let comment =
        |line: &&str| line.strip_prefix("//").filter(|text| text.is_empty() || text.starts_with(' ')).is_some();
    let block: Vec<&str> = rest.iter().copied().take_while(comment).collect();
    let text: Vec<&str> = block.iter().map(|line| line.trim_start_matches("//").trim()).collect();
    let text = text.join("\n").trim().to_owned();
    if block.first() != Some(&"//") || text.is_empty() {
        let after = format!("// Discrepancy: {id}");
        return Err(format!("{file}:{line}: after `{after}` must come a line `//` and then prose").into());
    }
    Ok((file.to_owned(), line, text))
}

/// The template with the list, and its heading.
const LIST: &str = "report/templates/appendix.md";
const HEADING: &str = "## References\n";

/// Every work that is cited is in the list of references, and every reference is cited.
fn compare(texts: &[(String, String)]) -> Result<(), String> {
    let listed = texts.iter().find(|(path, _)| path == LIST).and_then(|(_, text)| text.split_once(HEADING));
    let listed = listed.map_or("", |(_, after)| after.split("\n## ").next().unwrap_or(after));
    let references: Vec<&str> = listed.lines().filter_map(|line| line.strip_prefix("- ")).collect();
    let mut cited = BTreeSet::new();
    for (file, text) in texts {
        for (name, year) in citations(&text.replace(listed, "")) {
            let Some(reference) = references.iter().find(|line| line.contains(name) && line.contains(year)) else {
                return Err(format!("{file} cites {name} {year}, which is not among the references of {LIST}"));
            };
            cited.insert(*reference);
        }
    }
    match references.iter().find(|line| !cited.contains(*line)) {
        Some(line) => Err(format!("nothing cites the reference `{line}` of {LIST}")),
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

/// How to reproduce: what the manifest and the tree say about themselves.
pub(super) fn evidence(study: &Study<'_>) -> Result<Evidence, Cause> {
    compare(&files::texts(study.root, &["src", "tests", "report/templates"], &[".rs", ".md"])?)?;
    let manifest: toml::Table = toml::from_str(&files::text(study.root, "Cargo.toml")?)?;
    let version = |table: &[&str]| {
        let [outer @ .., name] = table else { return None };
        let table = outer.iter().try_fold(&manifest, |table, name| table.get(*name)?.as_table())?;
        table.get(*name)?.as_str()
    };
    let scenes = files::list(study.root, "report/scenes")?;
    let scenes: Vec<String> =
        scenes.iter().filter_map(|path| path.strip_prefix("report/")).map(str::to_owned).collect();
    Ok(Evidence::new(context! {
        version => version(&["package", "version"]),
        rust_version => version(&["workspace", "package", "rust-version"]),
        scenes,
    }))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn collected(text: &str) -> Result<BTreeMap<String, Discrepancy>, String> {
        collect(&[("src/a.rs".to_owned(), text.to_owned())]).map_err(|error| error.to_string())
    }

    #[test]
    fn blocks_are_collected_by_id() {
        let text = "//! x\n    // Discrepancy: fig-05-load\n    //\n    // Labelled q = 10.\n    //\n    // We use\n    // 1.0.\n\
                    let q = 1.0; // Discrepancy: not at the start of a line\n// Discrepancy: eq-2\n//\n// b\n/// doc\n";
        let entry = |id: &str, line, text: &str| (id.to_owned(), ("src/a.rs".to_owned(), line, text.to_owned()));
        let expected = [entry("eq-2", 9, "b"), entry("fig-05-load", 2, "Labelled q = 10.\n\nWe use\n1.0.")];
        assert_eq!(collected(text), Ok(expected.into()));
    }

    #[test]
    fn blocks_that_cannot_be_read_are_errors() {
        let message = collected;
        let no_prose = Err("src/a.rs:1: after `// Discrepancy: a` must come a line `//` and then prose".to_owned());
        assert_eq!(message("// Discrepancy: a\nfn f() {}"), no_prose, "nothing follows");
        assert_eq!(message("// Discrepancy: a\n// prose"), no_prose, "no empty line");
        assert_eq!(message("// Discrepancy: a\n//\n//\nx"), no_prose, "no prose");
        assert!(message("// Discrepancy: A b\n//\n// c").is_err_and(|m| m.contains("must be an id")), "not an id");
        let twice = "// Discrepancy: a\n//\n// b\n\n// Discrepancy: a\n//\n// c";
        assert!(message(twice).is_err_and(|m| m.contains("also told in src/a.rs")), "two of one id");
    }

    fn compared(code: &str, list: &str) -> Result<(), String> {
        let texts = [("src/a.rs", code.to_owned()), (LIST, format!("# P\n{HEADING}\n{list}\n\n## Next\n"))];
        compare(&texts.map(|(path, text)| (path.to_owned(), text)))
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
