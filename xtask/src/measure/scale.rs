//! `cargo xtask measure --scale`: time and memory over the points of a survey, by the exact solution, the active set and an
//! interior point.
//!
//! Routes on the same survey follow each other, so that their ratio is that of one hour. Each runs in a process of its own,
//! which has a memory of its own and can be stopped. `--up-to N` measures surveys of at most N points.

pub(crate) mod alone;

use std::path::Path;

use palkki::methods::Method;
use palkki::solvers::Solver;
use palkki_evidence::extremes::Ground;
use serde::{Deserialize, Serialize};

use super::rows::{Row, Rows};
use super::{Wish, machine};

/// Where the file is, below the root.
pub(crate) const PATH: &str = "report/data/scale.csv";

/// Points of the surveys: segments, to be exact.
const POINTS: [u32; 4] = [1000, 10_000, 100_000, 1_000_000];

/// More than the exact solution takes, so that the file has its words for that; of one survey.
const TOO_MANY: u32 = 5_000_000;

/// Uniform loads: under the light one the beam rests on a few points, under the heavy one it lies on all that is smooth.
pub(crate) const LOADS: [f64; 2] = [1.0, 1e4];

/// No grid is coarser.
const COARSEST: u32 = 1000;

/// Seconds after which a process is stopped: one of ours, and one of a library.
const PATIENCE: [f64; 2] = [180.0, 60.0];

/// A series goes on to ten times as many points while it took at most this part of what is waited for.
const PART: f64 = 1.0 / 12.0;

/// The status of what is not run or ends without a result.
const LEFT_OUT: &str = "left-out";
const STOPPED: &str = "stopped";
const REFUSED: &str = "refused";

/// By what a survey is solved.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Route {
    /// The exact solution.
    Exact,
    /// The force method with a solver, on a grid that has a node at every point of the survey.
    Force(Solver),
}

impl Route {
    pub(crate) const ALL: [Self; 3] = [Self::Exact, Self::Force(Solver::ActiveSet), Self::Force(Solver::Clarabel)];

    /// `method/solver`
    pub(crate) fn word(self) -> String {
        match self {
            Self::Exact => "exact/free-boundary".to_owned(),
            Self::Force(solver) => format!("{}/{solver}", Method::Force),
        }
    }

    /// Seconds after which it is stopped.
    pub(crate) fn patience(self) -> f64 {
        PATIENCE[usize::from(self == Self::Force(Solver::Clarabel))]
    }
}

/// One thing to measure.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Job {
    ground: Ground,
    points: u32,
    load: f64,
    route: Route,
}

impl Job {
    /// Intervals of its grid: a multiple of the segments; 0 for the exact solution.
    fn intervals(self) -> u32 {
        match self.route {
            Route::Exact => 0,
            Route::Force(_) => self.points * COARSEST.div_ceil(self.points),
        }
    }

    /// Whether the other job is the same on a survey of fewer points.
    fn continues(self, other: Self) -> bool {
        (self.ground, self.route) == (other.ground, other.route)
            && self.load.total_cmp(&other.load).is_eq()
            && other.points < self.points
    }
}

/// Routes on the same survey side by side.
fn plan() -> Vec<Job> {
    let mut jobs = Vec::new();
    for ground in Ground::ALL {
        for load in LOADS {
            let surveys = POINTS.into_iter().flat_map(|points| Route::ALL.map(|route| (points, route)));
            jobs.extend(surveys.map(|(points, route)| Job { ground, points, load, route }));
        }
    }
    jobs.push(Job { ground: Ground::Walk, points: TOO_MANY, load: LOADS[0], route: Route::Exact });
    jobs
}

/// A line of the file.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub(crate) struct Line {
    pub(crate) ground: String,
    pub(crate) points: u32,
    pub(crate) load: f64,
    /// `method/solver`
    pub(crate) route: String,
    pub(crate) intervals: u32,
    /// Our check: `certified`, `not-certified`, `not-converged`; or `left-out`, `stopped`, `refused`.
    pub(crate) status: String,
    /// Why there is no result.
    pub(crate) why: String,
    pub(crate) residual: Option<f64>,
    pub(crate) energy: Option<f64>,
    pub(crate) iterations: Option<usize>,
    /// Lists of contacts that were tried; of the exact solution.
    pub(crate) lists: Option<usize>,
    pub(crate) unknowns: Option<usize>,
    /// Contacts of the exact solution, points and zones; nodes in contact on a grid.
    pub(crate) contacts: Option<usize>,
    /// Runs of which the seconds are the median: 3, or 1 of what takes long.
    pub(crate) runs: Option<usize>,
    pub(crate) median_s: Option<f64>,
    pub(crate) min_s: Option<f64>,
    pub(crate) max_s: Option<f64>,
    /// Kilobytes at the most, of a process that makes the survey and solves it once.
    pub(crate) peak_kb: Option<u64>,
}

impl Row for Line {
    const PATH: &'static str = PATH;

    /// `ground,points,load,method/solver`
    fn name(&self) -> String {
        format!("{},{},{:e},{}", self.ground, self.points, self.load, self.route)
    }
}

impl Line {
    /// Nothing is known of it yet.
    fn of(job: Job) -> Self {
        let (ground, route) = (job.ground.word().to_owned(), job.route.word());
        Self { ground, points: job.points, load: job.load, route, intervals: job.intervals(), ..Self::default() }
    }

    fn without_result(self, status: &str, why: String) -> Self {
        Self { status: status.to_owned(), why, ..self }
    }

    pub(crate) fn is_certified(&self) -> bool {
        self.status == "certified"
    }

    pub(crate) fn is_refused(&self) -> bool {
        self.status == REFUSED
    }
}

/// All lines, on disk and in memory.
pub(crate) type Scale = Rows<Line>;

/// Runs all jobs that are wanted and that the file does not have yet.
pub(super) fn run(root: &Path, wish: Wish<'_>, progress: &mut dyn FnMut(&str)) -> Result<(), String> {
    let wanted = |name: &str| name.contains(wish.only);
    let mut scale = Scale::open(root, &machine::describe(root), wish.fresh, wanted)?;
    let jobs = plan();
    for (k, job) in jobs.iter().enumerate().filter(|(_, job)| job.points <= wish.up_to) {
        let begun = Line::of(*job);
        let name = begun.name();
        if !wanted(&name) || scale.named(&name).is_some() {
            continue;
        }
        // The longest survey before this one, by the same route; what it took is what this one takes at least.
        let before = jobs.iter().filter(|other| job.continues(**other)).max_by_key(|other| other.points);
        let before = before.and_then(|other| scale.named(&Line::of(*other).name()));
        let most = PART * job.route.patience();
        let line = match before {
            Some(line) if line.median_s.is_none_or(|seconds| most < seconds) => {
                let why = line.median_s.map_or_else(
                    || format!("{} points have no result", line.points),
                    |seconds| format!("{} points took {seconds:.1} s", line.points),
                );
                begun.without_result(LEFT_OUT, why)
            }
            _ => {
                progress(&format!("{} of {}: {name}", k + 1, jobs.len()));
                alone::measured(*job, begun)?
            }
        };
        scale.append(line)?;
    }
    progress("all of it is measured; `cargo xtask report` renders the page from it");
    Ok(())
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::*;

    #[test]
    fn every_job_has_a_line_of_its_own() {
        let names: BTreeSet<String> = plan().into_iter().map(|job| Line::of(job).name()).collect();
        assert_eq!(names.len(), plan().len());
    }

    #[test]
    fn every_point_of_a_survey_is_a_node() {
        let job = Job { ground: Ground::Walk, points: 300, load: 1.0, route: Route::Force(Solver::ActiveSet) };
        assert_eq!(job.intervals(), 1200);
        assert!(Job { points: 1000, ..job }.continues(job) && !job.continues(job));
    }
}
