//! The file of measurements: comments that say where they come from, a header, a line for each result.
//!
//! The file is always whole: each result writes it anew beside itself and then takes its place, which the system does at once
//! or not at all. Whatever is killed whenever, the next run finds all results but the one that was under way.

use std::fs;
use std::path::{Path, PathBuf};

use super::errors::Errors;
use super::job::Measured;

/// Where the file is, below the root.
pub(crate) const PATH: &str = "report/data/measurements.csv";

const HEADER: &str = "scene,route,intervals,tolerance,status,claims,residual,own_residual,own_asked,iterations,unknowns,runs,median_s,min_s,max_s,\
    reaction_solver,contact_solver,deflection_solver,energy_solver,reaction_total,contact_total,deflection_total,energy_total,\
    added_s,tridiagonal_s,peak_kb,certificate_s";

/// Number of fields that identify a line.
const KEY: usize = 4;

/// A line of the file, fields in the order of [`HEADER`].
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Line(Vec<String>);

impl Line {
    /// A result.
    pub(super) fn measured(key: String, m: &Measured, errors: &Errors) -> Self {
        let mut fields = fields_of(&key);
        fields.push(m.status.word().to_owned());
        fields.push(if m.claims_success { "success" } else { "failure" }.to_owned());
        fields.push(format!("{:.2e}", m.residual));
        let own = m.own_residual.map(|own| [own.residual, own.asked].map(|r| format!("{r:.2e}")));
        fields.extend(own.unwrap_or_default());
        fields.extend([m.iterations, m.unknowns, m.seconds.len()].map(|n| n.to_string()));
        let seconds = [m.median(), m.seconds[0], m.seconds[m.seconds.len() - 1]];
        fields.extend(seconds.map(|s| format!("{s:.3e}")));
        fields.extend(errors.solver.iter().chain(&errors.total).map(|e| format!("{e:.2e}")));
        fields.extend([m.added, m.yardstick].map(|s| s.map_or_else(String::new, |s| format!("{s:.3e}"))));
        fields.push(m.peak.map_or_else(String::new, |kilobytes| kilobytes.to_string()));
        fields.push(m.certificate.map_or_else(String::new, |s| format!("{s:.3e}")));
        Self(fields)
    }

    /// The proven optimum of a discrete problem: its errors are those of the grid.
    pub(super) fn proven(key: String, exchanges: usize, seconds: f64, errors: &Errors) -> Self {
        let mut fields = fields_of(&key);
        fields.extend(["proven", "success", "0", "", ""].map(str::to_owned));
        fields.extend([exchanges + 1, 0, 1].map(|n| n.to_string()));
        fields.extend([seconds; 3].map(|s| format!("{s:.3e}")));
        fields.extend(errors.solver.iter().chain(&errors.total).map(|e| format!("{e:.2e}")));
        Self(fields)
    }

    /// A job that was not run, because a coarser grid took this long.
    pub(super) fn left_out(key: String, seconds: f64) -> Self {
        let why = if seconds.is_finite() { format!("left-out: {seconds:.1} s before") } else { "left-out".to_owned() };
        Self::without_result(key, why)
    }

    /// A job that ends without a result.
    pub(super) fn without_result(key: String, why: String) -> Self {
        let mut fields = fields_of(&key);
        fields.push(why);
        Self(fields)
    }

    /// A field by the name of its column; none if it is empty.
    pub(crate) fn field(&self, column: &str) -> Option<&str> {
        let index = HEADER.split(',').position(|name| name == column)?;
        self.0.get(index).map(String::as_str).filter(|field| !field.is_empty())
    }

    /// A number by the name of its column.
    pub(crate) fn number(&self, column: &str) -> Option<f64> {
        self.field(column)?.parse().ok()
    }

    /// Median seconds, if the job was run.
    pub(crate) fn seconds(&self) -> Option<f64> {
        self.number("median_s")
    }

    pub(super) fn key(&self) -> String {
        self.0[..KEY.min(self.0.len())].join(",")
    }

    /// A line of a file with the columns `header`; none for what is no line of it.
    fn read(text: &str, header: &[&str]) -> Option<Self> {
        let fields: Vec<&str> = text.split(',').collect();
        if fields.len() <= KEY || header.len() < fields.len() {
            return None;
        }
        let field = |column: &str| {
            let index = header.iter().position(|name| *name == column)?;
            fields.get(index).map(|field| (*field).to_owned())
        };
        let mut known: Vec<String> = HEADER.split(',').map(|column| field(column).unwrap_or_default()).collect();
        let used = known.iter().rposition(|field| !field.is_empty()).map_or(0, |last| last + 1);
        known.truncate(used);
        Some(Self(known))
    }
}

fn fields_of(key: &str) -> Vec<String> {
    key.split(',').map(str::to_owned).collect()
}

/// All lines, on disk and in memory.
#[derive(Debug)]
pub(crate) struct Store {
    path: PathBuf,
    /// The comments at the top.
    pub(crate) described: Vec<String>,
    /// The results.
    pub(crate) lines: Vec<Line>,
    /// Whether the file has the columns that are written today.
    current: bool,
}

impl Store {
    /// Reads the file; one with fewer columns is read as far as it goes.
    pub(crate) fn read(root: &Path) -> Result<Self, String> {
        let path = root.join(PATH);
        let text = fs::read_to_string(&path).map_err(|error| format!("{PATH}: {error}"))?;
        Ok(Self::parse(path, &text))
    }

    /// The text of a file.
    pub(crate) fn parse(path: PathBuf, text: &str) -> Self {
        let comments = text.lines().filter_map(|line| line.strip_prefix("# ")).map(str::to_owned);
        let mut rows = text.lines().filter(|line| !line.starts_with('#'));
        let header = rows.next().unwrap_or_default();
        let columns: Vec<&str> = header.split(',').collect();
        let lines = rows.filter_map(|line| Line::read(line, &columns)).collect();
        Self { path, described: comments.collect(), lines, current: header == HEADER }
    }

    /// Opens the file to go on with it. With `fresh` what is `wanted` is forgotten, and everything if the file comes from
    /// elsewhere.
    pub(super) fn open(
        root: &Path,
        described: &[String],
        fresh: bool,
        wanted: impl Fn(&str) -> bool,
    ) -> Result<Self, String> {
        let begun = Self { path: root.join(PATH), described: described.to_vec(), lines: Vec::new(), current: true };
        if !root.join(PATH).exists() {
            begun.write()?;
            return Ok(begun);
        }
        let mut store = Self::read(root)?;
        match (store.current && store.described == described, fresh) {
            (true, false) => {}
            (true, true) => {
                store.lines.retain(|line| !wanted(&line.key()));
                store.write()?;
            }
            (false, true) => {
                begun.write()?;
                return Ok(begun);
            }
            (false, false) => {
                return Err(format!(
                    "{PATH} comes from elsewhere ({}): `--fresh` starts it again",
                    if store.current { store.described.join("; ") } else { "it has other columns".to_owned() }
                ));
            }
        }
        Ok(store)
    }

    /// The line of a key.
    pub(super) fn find(&self, key: &str) -> Option<&Line> {
        self.lines.iter().find(|line| line.key() == key)
    }

    /// Adds a line, on disk as well.
    pub(super) fn append(&mut self, line: &Line) -> Result<(), String> {
        self.lines.push(line.clone());
        self.write()
    }

    /// Beside the file, and then in its place.
    fn write(&self) -> Result<(), String> {
        let comments = self.described.iter().map(|line| format!("# {line}\n"));
        let lines = self.lines.iter().map(|line| line.0.join(",") + "\n");
        let text: String = comments.chain([format!("{HEADER}\n")]).chain(lines).collect();
        let beside = self.path.with_extension("csv.new");
        let failed = |error: std::io::Error| format!("{PATH}: {error}");
        fs::write(&beside, text).map_err(failed)?;
        fs::rename(&beside, &self.path).map_err(failed)
    }
}

#[cfg(test)]
mod tests;
