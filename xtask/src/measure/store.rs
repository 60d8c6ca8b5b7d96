//! The file of measurements: comments that say where they come from, a header, a line for each result.

use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};

use super::errors::Errors;
use super::job::Measured;

/// Where the file is, below the root.
pub(crate) const PATH: &str = "report/data/measurements.csv";

const HEADER: &str = "scene,route,intervals,tolerance,status,claims,residual,iterations,unknowns,runs,median_s,min_s,max_s,\
    reaction_solver,contact_solver,deflection_solver,energy_solver,reaction_total,contact_total,deflection_total,energy_total";

/// Number of fields that identify a line.
const KEY: usize = 4;

/// A line of the file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Line(Vec<String>);

impl Line {
    /// A result.
    pub(super) fn measured(key: String, m: &Measured, errors: &Errors) -> Self {
        let mut fields: Vec<String> = key.split(',').map(str::to_owned).collect();
        fields.push(m.status.word().to_owned());
        fields.push(if m.claims_success { "success" } else { "failure" }.to_owned());
        fields.push(format!("{:.2e}", m.residual));
        fields.extend([m.iterations, m.unknowns, m.seconds.len()].map(|n| n.to_string()));
        let seconds = [m.median(), m.seconds[0], m.seconds[m.seconds.len() - 1]];
        fields.extend(seconds.map(|s| format!("{s:.3e}")));
        fields.extend(errors.solver.iter().chain(&errors.total).map(|e| format!("{e:.2e}")));
        Self(fields)
    }

    /// A job that was not run, because a coarser grid took this long.
    pub(super) fn left_out(key: String, seconds: f64) -> Self {
        let mut fields: Vec<String> = key.split(',').map(str::to_owned).collect();
        let why = if seconds.is_finite() { format!("left-out: {seconds:.1} s before") } else { "left-out".to_owned() };
        fields.push(why);
        Self(fields)
    }

    /// A job that the solver refuses.
    pub(super) fn refused(key: String) -> Self {
        let mut fields: Vec<String> = key.split(',').map(str::to_owned).collect();
        fields.push("refused".to_owned());
        Self(fields)
    }

    /// A field by the name of its column.
    pub(crate) fn field(&self, column: &str) -> Option<&str> {
        let index = HEADER.split(',').position(|name| name == column)?;
        self.0.get(index).map(String::as_str)
    }

    /// A number by the name of its column.
    pub(crate) fn number(&self, column: &str) -> Option<f64> {
        self.field(column)?.parse().ok()
    }

    /// Median seconds, if the job was run.
    pub(crate) fn seconds(&self) -> Option<f64> {
        self.number("median_s")
    }

    fn key(&self) -> String {
        self.0[..KEY.min(self.0.len())].join(",")
    }
}

/// All lines, on disk and in memory.
#[derive(Debug)]
pub(crate) struct Store {
    path: PathBuf,
    /// The comments at the top.
    pub(crate) described: Vec<String>,
    /// The results.
    pub(crate) lines: Vec<Line>,
}

impl Store {
    /// Reads the file.
    pub(crate) fn read(root: &Path) -> Result<Self, String> {
        let path = root.join(PATH);
        let text = fs::read_to_string(&path).map_err(|error| format!("{PATH}: {error}"))?;
        let comments = text.lines().filter_map(|line| line.strip_prefix("# ")).map(str::to_owned);
        let rows = text.lines().filter(|line| !line.starts_with('#') && *line != HEADER);
        let lines = rows.map(|line| Line(line.split(',').map(str::to_owned).collect())).collect();
        Ok(Self { path, described: comments.collect(), lines })
    }

    /// Opens the file to go on with it, or begins it.
    pub(super) fn open(root: &Path, described: &[String], fresh: bool) -> Result<Self, String> {
        if !fresh && root.join(PATH).exists() {
            let store = Self::read(root)?;
            if store.described != described {
                return Err(format!(
                    "{PATH} comes from elsewhere ({}): `--fresh` starts it again",
                    store.described.join("; ")
                ));
            }
            return Ok(store);
        }
        let store = Self { path: root.join(PATH), described: described.to_vec(), lines: Vec::new() };
        let comments: String = described.iter().map(|line| format!("# {line}\n")).collect();
        fs::write(&store.path, format!("{comments}{HEADER}\n")).map_err(|error| format!("{PATH}: {error}"))?;
        Ok(store)
    }

    /// The line of a key.
    pub(super) fn find(&self, key: &str) -> Option<&Line> {
        self.lines.iter().find(|line| line.key() == key)
    }

    /// Adds a line, on disk as well.
    pub(super) fn append(&mut self, line: &Line) -> Result<(), String> {
        let mut file =
            fs::OpenOptions::new().append(true).open(&self.path).map_err(|error| format!("{PATH}: {error}"))?;
        writeln!(file, "{}", line.0.join(",")).map_err(|error| format!("{PATH}: {error}"))?;
        self.lines.push(line.clone());
        Ok(())
    }
}
