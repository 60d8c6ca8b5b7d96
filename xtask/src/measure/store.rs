//! The file of measurements: comments that say where they come from, a header, a line for each result.
//!
//! The file is always whole: each result writes it anew beside itself and then takes its place, which the system does at once
//! or not at all. Whatever is killed whenever, the next run finds all results but the one that was under way.

use std::fs;
use std::path::{Path, PathBuf};

use serde::{Deserialize, Serialize};

use super::errors::Errors;
use super::job::Measured;

/// Where the file is, below the root.
pub(crate) const PATH: &str = "report/data/measurements.csv";

/// The status of a job that was not run.
const LEFT_OUT: &str = "left-out";

/// A line of the file: what was solved by which route, and what came of it. Errors are relative; those of the solver are
/// against the proven optimum of the same discrete problem, the total ones against beam theory.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub(crate) struct Line {
    pub(crate) scene: String,
    pub(crate) method: String,
    pub(crate) solver: String,
    /// 0 where the route has no grid, or chooses it.
    pub(crate) intervals: usize,
    /// What was asked for; 0 where nothing is.
    pub(crate) tolerance: f64,
    /// Our check: `certified`, `not-certified`, `not-converged`; `proven` for an optimum; or why there is no result.
    pub(crate) status: String,
    /// Whether the solver says that it solved the problem.
    pub(crate) says_solved: Option<bool>,
    /// Of a library: whether it did what it was asked, in its own norm.
    pub(crate) did_as_asked: Option<bool>,
    /// Residual by our check.
    pub(crate) residual: Option<f64>,
    /// Of a library: residual in its own norm.
    pub(crate) own_residual: Option<f64>,
    pub(crate) iterations: Option<usize>,
    pub(crate) unknowns: Option<usize>,
    pub(crate) runs: Option<usize>,
    pub(crate) median_s: Option<f64>,
    pub(crate) min_s: Option<f64>,
    pub(crate) max_s: Option<f64>,
    pub(crate) reaction_solver: Option<f64>,
    pub(crate) contact_solver: Option<f64>,
    pub(crate) deflection_solver: Option<f64>,
    pub(crate) energy_solver: Option<f64>,
    pub(crate) reaction_total: Option<f64>,
    pub(crate) contact_total: Option<f64>,
    pub(crate) deflection_total: Option<f64>,
    pub(crate) energy_total: Option<f64>,
    /// Of the adaptive grid: intervals of its last grid, and the certified error of the deflection.
    pub(crate) last_intervals: Option<usize>,
    pub(crate) certified_error: Option<f64>,
    /// Median seconds of what is measured in turns with the solve.
    pub(crate) added_s: Option<f64>,
    pub(crate) tridiagonal_s: Option<f64>,
    pub(crate) certificate_s: Option<f64>,
    pub(crate) peak_kb: Option<u64>,
}

/// What identifies a line: scene, route, intervals, tolerance.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Key {
    pub(crate) scene: &'static str,
    pub(crate) route: String,
    pub(crate) intervals: usize,
    pub(crate) tolerance: f64,
}

/// As many significant digits as a measurement has, and no number for what is none.
fn rounded<const PLACES: usize>(value: f64) -> Option<f64> {
    format!("{value:.PLACES$e}").parse().ok().filter(|value: &f64| value.is_finite())
}

impl Line {
    fn new(key: &Key, status: impl Into<String>) -> Self {
        let (method, solver) = key.route.split_once('/').unwrap_or((&key.route, ""));
        let (scene, method, solver) = (key.scene.to_owned(), method.to_owned(), solver.to_owned());
        let (intervals, tolerance) = (key.intervals, key.tolerance);
        Self { scene, method, solver, intervals, tolerance, status: status.into(), ..Self::default() }
    }

    /// A result.
    pub(super) fn measured(key: &Key, m: &Measured, errors: &Errors) -> Self {
        Self {
            says_solved: Some(m.claims_success),
            did_as_asked: m.own_residual.map(|own| own.is_met()),
            residual: rounded::<2>(m.residual),
            own_residual: m.own_residual.and_then(|own| rounded::<2>(own.residual)),
            iterations: Some(m.iterations),
            unknowns: Some(m.unknowns),
            last_intervals: m.adaptive.map(|(intervals, _)| intervals),
            certified_error: m.adaptive.and_then(|(_, error)| rounded::<2>(error)),
            added_s: m.added.and_then(rounded::<3>),
            tridiagonal_s: m.yardstick.and_then(rounded::<3>),
            certificate_s: m.certificate.and_then(rounded::<3>),
            peak_kb: m.peak,
            ..Self::new(key, m.status.word())
        }
        .with(&m.seconds, errors)
    }

    /// The proven optimum of a discrete problem: its errors are those of the grid.
    pub(super) fn proven(key: &Key, exchanges: usize, seconds: f64, errors: &Errors) -> Self {
        Self { iterations: Some(exchanges + 1), ..Self::new(key, "proven") }.with(&[seconds], errors)
    }

    /// With the seconds of all runs, ascending, and the errors.
    fn with(mut self, seconds: &[f64], errors: &Errors) -> Self {
        self.runs = Some(seconds.len());
        self.median_s = rounded::<3>(seconds[seconds.len() / 2]);
        self.min_s = rounded::<3>(seconds[0]);
        self.max_s = rounded::<3>(seconds[seconds.len() - 1]);
        [self.reaction_solver, self.contact_solver, self.deflection_solver, self.energy_solver] =
            errors.solver.map(rounded::<2>);
        [self.reaction_total, self.contact_total, self.deflection_total, self.energy_total] =
            errors.total.map(rounded::<2>);
        self
    }

    /// A job that was not run, because a coarser grid took too long.
    pub(super) fn left_out(key: &Key) -> Self {
        Self::new(key, LEFT_OUT)
    }

    /// A job that ends without a result.
    pub(super) fn without_result(key: &Key, why: &str) -> Self {
        Self::new(key, why)
    }

    pub(crate) fn is_left_out(&self) -> bool {
        self.status == LEFT_OUT
    }

    pub(crate) fn is_certified(&self) -> bool {
        self.status == "certified"
    }

    pub(crate) fn is(&self, method: &str, solver: &str) -> bool {
        self.method == method && self.solver == solver
    }

    /// Errors against beam theory: end reaction, largest contact, deflection of the worst node, energy; none if one of them
    /// is no number.
    pub(crate) fn total(&self) -> Option<[f64; 4]> {
        Some([self.reaction_total?, self.contact_total?, self.deflection_total?, self.energy_total?])
    }

    /// Errors against the proven optimum, in the same order.
    pub(crate) fn of_solver(&self) -> Option<[f64; 4]> {
        Some([self.reaction_solver?, self.contact_solver?, self.deflection_solver?, self.energy_solver?])
    }

    /// The worst of the errors against beam theory.
    pub(crate) fn worst(&self) -> Option<f64> {
        self.total().map(|errors| errors.into_iter().fold(0.0, f64::max))
    }

    /// Correct decimal digits of the worst observable.
    pub(crate) fn digits(&self) -> Option<f64> {
        self.worst().filter(|worst| 0.0 < *worst).map(|worst| -worst.log10())
    }

    /// For `--only`: `scene,method/solver,intervals,tolerance`.
    pub(super) fn name(&self) -> String {
        format!("{},{}/{},{},{:e}", self.scene, self.method, self.solver, self.intervals, self.tolerance)
    }

    fn has(&self, key: &Key) -> bool {
        self.name() == key.name()
    }
}

impl Key {
    /// As [`Line::name`].
    pub(super) fn name(&self) -> String {
        format!("{},{},{},{:e}", self.scene, self.route, self.intervals, self.tolerance)
    }
}

/// All lines, on disk and in memory.
#[derive(Debug)]
pub(crate) struct Store {
    path: PathBuf,
    /// The comments at the top, `name: value`.
    pub(crate) described: Vec<String>,
    /// The results.
    pub(crate) lines: Vec<Line>,
}

impl Store {
    /// Reads the file.
    pub(crate) fn read(root: &Path) -> Result<Self, String> {
        let path = root.join(PATH);
        let text = fs::read_to_string(&path).map_err(|error| format!("{PATH}: {error}"))?;
        Self::parse(path, &text)
    }

    /// The text of a file.
    pub(crate) fn parse(path: PathBuf, text: &str) -> Result<Self, String> {
        let comments = text.lines().filter_map(|line| line.strip_prefix("# ")).map(str::to_owned);
        let mut reader = csv::ReaderBuilder::new().comment(Some(b'#')).from_reader(text.as_bytes());
        let lines = reader.deserialize().collect::<Result<_, _>>().map_err(|error| format!("{PATH}: {error}"))?;
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
        let begun = Self { path: root.join(PATH), described: described.to_vec(), lines: Vec::new() };
        if !root.join(PATH).exists() {
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
                Err(format!("{PATH} comes from elsewhere ({}): `--fresh` starts it again", store.described.join("; ")))
            }
            (Err(error), false) => Err(format!("{error}: `--fresh` starts it again")),
        }
    }

    /// The line of a key.
    pub(super) fn find(&self, key: &Key) -> Option<&Line> {
        self.lines.iter().find(|line| line.has(key))
    }

    /// Adds a line, on disk as well.
    pub(super) fn append(&mut self, line: Line) -> Result<(), String> {
        self.lines.push(line);
        self.write()
    }

    /// Beside the file, and then in its place.
    fn write(&self) -> Result<(), String> {
        let failed = |error: &dyn std::fmt::Display| format!("{PATH}: {error}");
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

#[cfg(test)]
mod tests;
