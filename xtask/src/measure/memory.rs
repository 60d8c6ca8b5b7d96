//! Peak memory of a solve: that of a process which does nothing else.
//!
//! The process is this program once more, as `xtask peak …`. At its end it reads from the system how much memory it had in use
//! at the most, program and all. Where the system does not say (no `/proc`), there is no number.

use std::fs;
use std::path::Path;
use std::process::Command;

use palkki::methods::Method;
use palkki::solvers::Solver;
use palkki::{Settings, solve};

use super::plan::{Job, Route};
use crate::report::scenes;

/// Kilobytes at the most of a solve in a process of its own.
pub(super) fn peak(scene: &str, job: Job) -> Option<u64> {
    let Route::Solver(method, solver) = job.route else { return None };
    let arguments = ["peak", scene, method.word(), solver.word()];
    let [intervals, tolerance] = [job.intervals.to_string(), format!("{:e}", job.tolerance)];
    let program = std::env::current_exe().ok()?;
    let output = Command::new(program).args(arguments).args([intervals, tolerance]).output().ok()?;
    String::from_utf8(output.stdout).ok()?.trim().parse().ok()
}

/// What that process does: solves, and answers with its peak in kilobytes.
pub(crate) fn own_peak(root: &Path, arguments: &[&str]) -> Result<u64, String> {
    let [scene, method, solver, intervals, tolerance] = arguments else {
        return Err("peak takes a scene, a method, a solver, intervals and a tolerance".to_owned());
    };
    let scene = scenes::read(root, scene).map_err(|error| error.to_string())?;
    let settings = Settings {
        method: Method::ALL.into_iter().find(|m| m.word() == *method).ok_or("no such method")?,
        solver: Solver::ALL.into_iter().find(|s| s.word() == *solver).ok_or("no such solver")?,
        intervals: intervals.parse().map_err(|_| "no number of intervals")?,
        tolerance: tolerance.parse().map_err(|_| "no tolerance")?,
    };
    let outcome = solve(&scene, &settings).map_err(|error| error.to_string())?;
    let peak = high_water_mark();
    // The answer is in memory until here.
    drop(outcome);
    peak.ok_or_else(|| "the system does not say".to_owned())
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

#[cfg(test)]
mod tests {
    use super::high_water;

    #[test]
    fn the_high_water_mark_is_read() {
        assert_eq!(high_water("Name:\tx\nVmHWM:\t   10548 kB\nVmRSS:\t 1 kB\n"), Some(10_548));
        assert_eq!(high_water("Name:\tx\n"), None, "another system");
    }
}
