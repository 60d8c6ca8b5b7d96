//! A file of results: comments that say where they come from, a header, a line for each result.
//!
//! The file is always whole: each result writes it anew beside itself and then takes its place, which the system does at once
//! or not at all. Whatever is killed whenever, the next run finds all results but the one that was under way.

use std::fs;
use std::path::{Path, PathBuf};

use serde::Serialize;
use serde::de::DeserializeOwned;

/// A line of a file of results.
pub(crate) trait Row: Serialize + DeserializeOwned {
    /// Where the file is, below the root.
    const PATH: &'static str;

    /// What tells it from the others, and what `--only` looks at.
    fn name(&self) -> String;
}

/// As many significant digits as a measurement has, and no number for what is none.
pub(super) fn rounded<const PLACES: usize>(value: f64) -> Option<f64> {
    format!("{value:.PLACES$e}").parse().ok().filter(|value: &f64| value.is_finite())
}

/// All lines, on disk and in memory.
#[derive(Debug)]
pub(crate) struct Rows<R> {
    path: PathBuf,
    /// The comments at the top, `name: value`.
    pub(crate) described: Vec<String>,
    /// The results.
    pub(crate) lines: Vec<R>,
}

impl<R: Row> Rows<R> {
    /// Reads the file.
    pub(crate) fn read(root: &Path) -> Result<Self, String> {
        let path = root.join(R::PATH);
        let text = fs::read_to_string(&path).map_err(|error| format!("{}: {error}", R::PATH))?;
        Self::parse(path, &text)
    }

    /// The text of a file.
    pub(crate) fn parse(path: PathBuf, text: &str) -> Result<Self, String> {
        let comments = text.lines().filter_map(|line| line.strip_prefix("# ")).map(str::to_owned);
        let mut reader = csv::ReaderBuilder::new().comment(Some(b'#')).from_reader(text.as_bytes());
        let lines = reader.deserialize().collect::<Result<_, _>>().map_err(|error| format!("{}: {error}", R::PATH))?;
        Ok(Self { path, described: comments.collect(), lines })
    }

    /// What a comment says.
    pub(crate) fn description(&self, name: &str) -> &str {
        let value = |line: &'_ String| line.strip_prefix(name)?.strip_prefix(": ").map(str::len);
        let found = self.described.iter().find_map(|line| value(line).map(|length| &line[line.len() - length..]));
        found.unwrap_or("unknown")
    }

    /// Opens the file to go on with it. With `fresh` what is `wanted` is forgotten, and everything if the file comes from
    /// elsewhere.
    pub(super) fn open(
        root: &Path,
        described: &[String],
        fresh: bool,
        wanted: impl Fn(&str) -> bool,
    ) -> Result<Self, String> {
        let begun = Self { path: root.join(R::PATH), described: described.to_vec(), lines: Vec::new() };
        if !root.join(R::PATH).exists() {
            begun.write()?;
            return Ok(begun);
        }
        let read = Self::read(root);
        match (read, fresh) {
            (Ok(mut store), fresh) if store.described == described => {
                store.lines.retain(|line| !fresh || !wanted(&line.name()));
                store.write()?;
                Ok(store)
            }
            (_, true) => {
                begun.write()?;
                Ok(begun)
            }
            (Ok(store), false) => {
                let elsewhere = store.described.join("; ");
                Err(format!("{} comes from elsewhere ({elsewhere}): `--fresh` starts it again", R::PATH))
            }
            (Err(error), false) => Err(format!("{error}: `--fresh` starts it again")),
        }
    }

    /// The line of this name.
    pub(super) fn named(&self, name: &str) -> Option<&R> {
        self.lines.iter().find(|line| line.name() == name)
    }

    /// Adds a line, on disk as well.
    pub(super) fn append(&mut self, line: R) -> Result<(), String> {
        self.lines.push(line);
        self.write()
    }

    /// Beside the file, and then in its place.
    fn write(&self) -> Result<(), String> {
        let failed = |error: &dyn std::fmt::Display| format!("{}: {error}", R::PATH);
        let mut writer = csv::Writer::from_writer(Vec::new());
        for line in &self.lines {
            writer.serialize(line).map_err(|error| failed(&error))?;
        }
        let rows = writer.into_inner().map_err(|error| failed(&error))?;
        let mut text: Vec<u8> = self.described.iter().flat_map(|line| format!("# {line}\n").into_bytes()).collect();
        text.extend(rows);
        let beside = self.path.with_extension("csv.new");
        fs::write(&beside, text).and_then(|()| fs::rename(&beside, &self.path)).map_err(|error| failed(&error))
    }
}
