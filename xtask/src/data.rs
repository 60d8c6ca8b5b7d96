//! Files of results: comma-separated values, one type for a line, which writes and reads it.

use std::fmt::Display;
use std::fs;
use std::path::Path;

use serde::de::DeserializeOwned;
use serde::{Serialize, Serializer};

use crate::Cause;

/// The lines of a text below its header; lines that begin with `#` are comments.
pub(crate) fn parse<Line: DeserializeOwned>(text: &str) -> Result<Vec<Line>, csv::Error> {
    let mut reader = csv::ReaderBuilder::new().comment(Some(b'#')).trim(csv::Trim::All).from_reader(text.as_bytes());
    reader.deserialize().collect()
}

/// The text of some lines, below their header.
pub(crate) fn text<Line: Serialize>(lines: &[Line]) -> Result<String, Cause> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    lines.iter().try_for_each(|line| writer.serialize(line))?;
    Ok(String::from_utf8(writer.into_inner()?)?)
}

/// Reads a file below the root: its text, and its lines.
pub(crate) fn read<Line: DeserializeOwned>(root: &Path, path: &str) -> Result<(String, Vec<Line>), Cause> {
    let failed = |error: &dyn Display| format!("{path}: {error}");
    let text = fs::read_to_string(root.join(path)).map_err(|error| failed(&error))?;
    let lines = parse(&text).map_err(|error| failed(&error))?;
    Ok((text, lines))
}

/// Writes a file below the root.
pub(crate) fn write<Line: Serialize>(root: &Path, path: &str, lines: &[Line]) -> Result<(), Cause> {
    fs::write(root.join(path), text(lines)?).map_err(|error| format!("{path}: {error}").into())
}

/// Numbers to three digits: `#[serde(serialize_with = "data::three_digits")]`.
pub(crate) fn three_digits<S: Serializer>(value: &f64, serializer: S) -> Result<S::Ok, S::Error> {
    serializer.collect_str(&format_args!("{value:.2e}"))
}

/// Numbers with a power of ten and no more digits than they need.
pub(crate) fn power<S: Serializer>(value: &f64, serializer: S) -> Result<S::Ok, S::Error> {
    serializer.collect_str(&format_args!("{value:e}"))
}

/// As many significant digits as a measurement has, and no number for what is none.
pub(crate) fn rounded(value: f64, places: usize) -> Option<f64> {
    format!("{value:.places$e}").parse().ok().filter(|value: &f64| value.is_finite())
}

/// Median, least and most seconds of some runs, to four digits.
pub(crate) fn spread(mut seconds: Vec<f64>) -> [Option<f64>; 3] {
    seconds.sort_by(f64::total_cmp);
    [median(&seconds), seconds.first().copied(), seconds.last().copied()].map(|seconds| rounded(seconds?, 3))
}

/// Of sorted numbers the middle one, or the mean of the two in the middle.
pub(crate) fn median(sorted: &[f64]) -> Option<f64> {
    let below = sorted.get(sorted.len().checked_sub(1)? / 2)?;
    Some(f64::midpoint(*below, *sorted.get(sorted.len() / 2)?))
}

#[cfg(test)]
mod tests {
    use serde::Deserialize;

    use super::read;
    use crate::report::files;

    #[derive(Debug, PartialEq, Deserialize)]
    struct Line {
        route: String,
        error: Option<f64>,
    }

    #[test]
    fn broken_files_are_refused_with_their_name() {
        let scratch = tempfile::tempdir().expect("a directory for temporary files");
        let lines = |text: &str| {
            files::replace(&scratch.path().join("a.csv"), text).expect("it can be written");
            read::<Line>(scratch.path(), "a.csv").map(|(_, lines)| lines).map_err(|error| error.to_string())
        };
        let line = Line { route: "force".to_owned(), error: None };
        assert_eq!(lines("# date: x\nroute,error\nforce,\n"), Ok(vec![line]), "no number is none");
        for (broken, what) in [
            ("route,error\nforce,small\n", "no number"),
            ("route,error\nforce\n", "a short line"),
            ("error\n1e-3\n", "a column is missing"),
            ("route,error\nforce,1e-3,2\n", "a long line"),
        ] {
            let found = lines(broken);
            assert!(found.as_ref().is_err_and(|error| error.starts_with("a.csv: ")), "{what}: {found:?}");
        }
        assert!(
            read::<Line>(scratch.path(), "b.csv").is_err_and(|error| error.to_string().starts_with("b.csv: ")),
            "no file"
        );
    }
}
