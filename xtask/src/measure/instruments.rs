//! What is measured with: the machine, peak memory, and the yardstick of time.
//!
//! Peak memory is that of a process which does nothing else: this program once more, as `xtask peak …`. At its end it reads from
//! the system how much memory it had in use at the most, program and all. Where the system does not say (no `/proc`), there is
//! no number.
//!
//! The yardstick is one solve of a tridiagonal system of n equations, by elimination and substitution without pivoting:
//!
//! ```text
//! M_{i−1} + 4 M_i + M_{i+1} = r_i         the three-moment equations of a beam that rests on every node
//! ```
//!
//! Coefficients and right-hand side stand in memory before the clock starts, and so does the memory for the answer: what is
//! timed is the bare solve. The coefficients are read and divided by, as if they were not all the same.

use std::fs;
use std::hint::black_box;
use std::io;
use std::path::Path;
use std::process::Command;
use std::time::Instant;

use palkki::methods::Method;
use palkki::solvers::Solver;
use palkki::{Settings, solve_raw};

use super::plan::{Job, Route};
use crate::{Cause, scenes};

/// What a program prints, without the end of the line; nothing if it cannot be run.
fn told(root: &Path, program: &str, arguments: &[&str]) -> Option<String> {
    let output = Command::new(program).args(arguments).current_dir(root).output().ok()?;
    output.status.success().then(|| String::from_utf8_lossy(&output.stdout).trim().to_owned())
}

/// The commit that is measured; with a word if the code that is measured is not as it was committed.
fn commit(root: &Path) -> String {
    let Some(hash) = told(root, "git", &["rev-parse", "--short=10", "HEAD"]) else { return "unknown".to_owned() };
    let changed = told(root, "git", &["status", "--porcelain", "--", "src", "tests/evidence", "xtask", "Cargo.lock"]);
    if changed.is_none_or(|changed| !changed.is_empty()) { format!("{hash} with changes") } else { hash }
}

/// One line for each thing that can move a time.
pub(super) fn describe(root: &Path) -> Vec<String> {
    let cpu = fs::read_to_string("/proc/cpuinfo").ok().and_then(|text| {
        let line = text.lines().find(|line| line.starts_with("model name"))?;
        line.split_once(':').map(|(_, name)| name.trim().to_owned())
    });
    let cores = std::thread::available_parallelism().map_or(1, std::num::NonZero::get);
    let rustc = told(root, "rustc", &["--version"]);
    let lock = fs::read_to_string(root.join("Cargo.lock")).unwrap_or_default();
    let version = |name: &str| {
        let start = lock.find(&format!("name = \"{name}\"\n"))?;
        lock[start..].lines().nth(1)?.split('"').nth(1).map(str::to_owned)
    };
    let versions = ["clarabel", "osqp", "nalgebra"].map(|name| format!("{name} {}", version(name).unwrap_or_default()));
    vec![
        format!("commit: {}", commit(root)),
        format!("date: {}", told(root, "date", &["-u", "+%F"]).unwrap_or_else(|| "unknown".to_owned())),
        format!(
            "machine: {}, {cores} cores, {}",
            cpu.unwrap_or_else(|| "unknown processor".to_owned()),
            std::env::consts::ARCH
        ),
        format!("compiler: {}", rustc.unwrap_or_else(|| "unknown".to_owned())),
        format!("libraries: {}", versions.join(", ")),
    ]
}

/// This program once more, for a task in a process of its own.
pub(super) fn again(task: &str, arguments: &[String]) -> io::Result<Command> {
    let mut command = Command::new(std::env::current_exe()?);
    command.arg(task).args(arguments);
    Ok(command)
}

/// Kilobytes at the most of a solve in a process of its own.
pub(super) fn peak(scene: &str, job: Job) -> Option<u64> {
    let Route::Solver(method, solver) = job.route else { return None };
    let words = [scene, method.name(), solver.name()].map(str::to_owned);
    let numbers = [job.intervals.to_string(), format!("{:e}", job.tolerance)];
    let output = again("peak", &[&words[..], &numbers].concat()).ok()?.output().ok()?;
    String::from_utf8(output.stdout).ok()?.trim().parse().ok()
}

/// What that process solves.
#[derive(Debug, Clone, clap::Args)]
pub(crate) struct Weighed {
    scene: String,
    #[arg(value_parser = method)]
    method: Method,
    #[arg(value_parser = solver)]
    solver: Solver,
    intervals: usize,
    tolerance: f64,
}

fn method(word: &str) -> Result<Method, String> {
    Method::ALL.into_iter().find(|method| method.name() == word).ok_or_else(|| "no such method".to_owned())
}

fn solver(word: &str) -> Result<Solver, String> {
    Solver::ALL.into_iter().find(|solver| solver.name() == word).ok_or_else(|| "no such solver".to_owned())
}

impl Weighed {
    /// Solves, and answers with the peak of this process in kilobytes.
    pub(crate) fn own_peak(&self, root: &Path) -> Result<u64, Cause> {
        let Self { method, solver, intervals, tolerance, .. } = *self;
        let outcome = solve_raw(&scenes::read(root, &self.scene)?, &Settings { method, solver, intervals, tolerance })?;
        let peak = high_water_mark();
        // The answer is in memory until here.
        drop(outcome);
        peak.ok_or_else(|| "the system does not say".into())
    }
}

/// Kilobytes that this process has had in use at the most, if the system says.
pub(super) fn high_water_mark() -> Option<u64> {
    high_water(&fs::read_to_string("/proc/self/status").ok()?)
}

/// The line `VmHWM:   123456 kB`, the high-water mark of the resident set.
fn high_water(status: &str) -> Option<u64> {
    let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:"))?;
    line.trim().strip_suffix("kB")?.trim().parse().ok()
}

/// A system of n equations: below the diagonal, on it, above it, right-hand side.
#[derive(Debug)]
pub(super) struct Tridiagonal {
    rows: Vec<[f64; 4]>,
    /// What an eliminated unknown keeps of its right neighbour.
    passed: Vec<f64>,
    x: Vec<f64>,
}

impl Tridiagonal {
    /// With a right-hand side of ones.
    pub(super) fn new(n: usize) -> Self {
        Self { rows: vec![[1.0, 4.0, 1.0, 1.0]; n], passed: vec![0.0; n], x: vec![0.0; n] }
    }

    /// Seconds of one solve.
    pub(super) fn seconds(&mut self) -> f64 {
        let rows = black_box(std::mem::take(&mut self.rows));
        let start = Instant::now();
        self.solve(&rows);
        let seconds = start.elapsed().as_secs_f64();
        self.rows = rows;
        black_box(&self.x);
        seconds
    }

    fn solve(&mut self, rows: &[[f64; 4]]) {
        let (mut passed, mut left) = (0.0, 0.0);
        for ((&[below, diagonal, above, load], keep), x) in rows.iter().zip(&mut self.passed).zip(&mut self.x) {
            let pivot = diagonal - below * passed;
            left = (load - below * left) / pivot;
            passed = above / pivot;
            (*keep, *x) = (passed, left);
        }
        let mut right = 0.0;
        for (keep, x) in self.passed.iter().zip(&mut self.x).rev() {
            right = *x - keep * right;
            *x = right;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{Tridiagonal, high_water};

    #[test]
    fn the_high_water_mark_is_read() {
        assert_eq!(high_water("Name:\tx\nVmHWM:\t   10548 kB\nVmRSS:\t 1 kB\n"), Some(10_548));
        assert_eq!(high_water("Name:\tx\n"), None, "another system");
    }

    #[test]
    fn it_solves_the_system() {
        /// A few roundings of numbers below one.
        const ROUNDING: f64 = 1e-15;
        let mut system = Tridiagonal::new(1000);
        system.seconds();
        let x = |i: usize| if (1..=1000).contains(&i) { system.x[i - 1] } else { 0.0 };
        for i in 1..=1000 {
            assert!((x(i - 1) + 4.0 * x(i) + x(i + 1) - 1.0).abs() < ROUNDING, "row {i}");
        }
    }
}
