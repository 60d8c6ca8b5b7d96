//! The file of measurements: what a line of it is.

use std::fmt::Display;
use std::path::{Path, PathBuf};

use serde::{Deserialize, Serialize};

use super::instruments;
use super::plan::Job;
use super::references::Errors;
use crate::data::{rounded, spread};
use crate::report::files;
use crate::{Cause, data};

/// Where the file is, below the root.
pub(super) const PATH: &str = "report/data/measurements.csv";

/// The status of a job that was not run, and of one that took too long.
const LEFT_OUT: &str = "left-out";
pub(super) const STOPPED: &str = "stopped";
/// What the status of a job begins with that has no answer.
const REFUSED: &str = "refused";

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
    /// Our check: `solved`, `not solved`, `gave up`; of the adaptive grid its verdict; `proven` for an optimum; or why there is no result.
    pub(crate) status: String,
    /// Whether the solver says that it solved the problem; almost is not.
    pub(crate) says_solved: Option<bool>,
    /// Of a library: whether it did what it was asked, in its own norm.
    pub(crate) did_as_asked: Option<bool>,
    /// Residual by our check.
    pub(crate) residual: Option<f64>,
    /// Of a library: residual in its own norm.
    pub(crate) own_residual: Option<f64>,
    pub(crate) iterations: Option<usize>,
    /// Of NSOR: the sweeps of the factor that won the race.
    pub(crate) own_sweeps: Option<usize>,
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
    /// Lists of contacts that were tried; of the exact solution.
    pub(crate) lists: Option<usize>,
    /// Contacts of the exact solution, points and zones.
    pub(crate) contacts: Option<usize>,
    /// Of a survey: seconds of the whole process `palkki solve`, the median, and the kilobytes that it has in use at the most.
    pub(crate) process_s: Option<f64>,
    pub(crate) peak_kb: Option<u64>,
}

impl Line {
    /// Nothing is known of it yet.
    pub(crate) fn of(job: Job) -> Self {
        let (scene, route) = (job.subject.name(), job.route.name());
        let (method, solver) = route.split_once('/').unwrap_or((&route, ""));
        let [method, solver] = [method, solver].map(str::to_owned);
        Self { scene, method, solver, intervals: job.intervals, tolerance: job.tolerance, ..Self::default() }
    }

    /// How it ended.
    pub(super) fn ended(self, status: &str) -> Self {
        Self { status: status.to_owned(), ..self }
    }

    /// It was not run, because a coarser grid or a shorter survey took too long.
    pub(super) fn left_out(self) -> Self {
        self.ended(LEFT_OUT)
    }

    /// There is no answer, and why.
    pub(super) fn refused(self, why: impl Display) -> Self {
        self.ended(&format!("{REFUSED}: {why}"))
    }

    pub(crate) fn is_refused(&self) -> bool {
        self.status.starts_with(REFUSED)
    }

    /// With the seconds of all runs, and the errors.
    pub(super) fn with(mut self, seconds: Vec<f64>, errors: &Errors) -> Self {
        self.runs = Some(seconds.len());
        [self.median_s, self.min_s, self.max_s] = spread(seconds);
        [self.reaction_solver, self.contact_solver, self.deflection_solver, self.energy_solver] =
            errors.solver.map(|error| rounded(error, 2));
        [self.reaction_total, self.contact_total, self.deflection_total, self.energy_total] =
            errors.total.map(|error| rounded(error, 2));
        self
    }

    pub(crate) fn is_left_out(&self) -> bool {
        self.status == LEFT_OUT
    }

    /// True if its problem is solved, and of an adaptive search if its answer is certified.
    pub(crate) fn succeeded(&self) -> bool {
        self.status == "solved" || self.status == "certified"
    }

    /// Whether the solver says that it almost solved its problem, which our check found not to be so: it did not give up, and claims
    /// no success.
    pub(crate) fn says_almost_solved(&self) -> bool {
        self.status == "not solved" && self.says_solved == Some(false)
    }

    /// Whether it asks for a tolerance, or has none.
    pub(crate) fn asks(&self, tolerance: f64) -> bool {
        self.tolerance.total_cmp(&tolerance).is_eq()
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

    /// What tells it from the others, and what `--only` looks at: `scene,method/solver,intervals,tolerance`.
    pub(crate) fn name(&self) -> String {
        format!("{},{}/{},{},{:e}", self.scene, self.method, self.solver, self.intervals, self.tolerance)
    }
}

/// Measurements: comments that say where they come from, and a line for each result; on disk and in memory.
///
/// The file is always whole, see [`files::replace`]: whatever is killed whenever, the next run finds all results but the one
/// that was under way.
#[derive(Debug)]
pub(crate) struct Store {
    path: PathBuf,
    /// The comments at the top, `name: value`.
    described: Vec<String>,
    /// The results.
    pub(crate) lines: Vec<Line>,
}

impl Store {
    /// Reads the file: its text, and what it says.
    pub(crate) fn read(root: &Path) -> Result<(String, Self), Cause> {
        let (text, lines) = data::read(root, PATH)?;
        let (path, described) = (root.join(PATH), instruments::described(&text));
        Ok((text, Self { path, described, lines }))
    }

    /// Where they come from, for templates.
    pub(crate) fn provenance(&self) -> minijinja::Value {
        instruments::provenance(&self.described)
    }

    /// Opens the file to go on with it. With `fresh` what is `wanted` is forgotten, and everything if the file comes from
    /// elsewhere.
    pub(crate) fn open(
        root: &Path,
        described: &[String],
        fresh: bool,
        wanted: impl Fn(&str) -> bool,
    ) -> Result<Self, Cause> {
        let path = root.join(PATH);
        let mut opened = match Self::read(root) {
            Ok((_, found)) if found.described == described => found,
            Ok((_, found)) if !fresh => {
                let elsewhere = found.described.join("; ");
                return Err(format!("{} comes from elsewhere ({elsewhere}): `--fresh` starts it again", PATH).into());
            }
            Err(error) if !fresh && path.exists() => return Err(format!("{error}: `--fresh` starts it again").into()),
            _ => Self { path, described: described.to_vec(), lines: Vec::new() },
        };
        opened.lines.retain(|line| !fresh || !wanted(&line.name()));
        opened.write()?;
        Ok(opened)
    }

    /// The line of this name.
    pub(crate) fn named(&self, name: &str) -> Option<&Line> {
        self.lines.iter().find(|line| line.name() == name)
    }

    /// Adds a line, on disk as well.
    pub(crate) fn append(&mut self, line: Line) -> Result<(), Cause> {
        self.lines.push(line);
        self.write()
    }

    fn write(&self) -> Result<(), Cause> {
        let text = instruments::heading(&self.described) + &data::text(&self.lines)?;
        files::replace(&self.path, &text).map_err(|error| format!("{}: {error}", PATH).into())
    }
}
