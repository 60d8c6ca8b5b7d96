//! `cargo xtask measure --scale`: time and memory over the points of a survey, by the exact solution, the active set and an
//! interior point.
//!
//! Routes on the same survey follow each other, so that their ratio is that of one hour. Each runs in a process of its own,
//! which is this program once more, as `xtask alone …`: its memory is that of one solve, and it can be stopped.
//! `--up-to N` measures surveys of at most N points.

use std::io::Read;
use std::path::Path;
use std::process::Stdio;
use std::thread::sleep;
use std::time::{Duration, Instant};

use palkki::DEFAULT_TOLERANCE;
use palkki::methods::Method;
use palkki::scene::Scene;
use palkki::solvers::Solver;
use palkki::state::Nodes;
use palkki_evidence::extremes::{Ground, survey};
use serde::{Deserialize, Serialize};

use super::instruments::{again, high_water_mark};
use super::job::{self, Answer};
use super::plan::{self, Route};
use crate::data::{Measurements, Row, parse, rounded, spread};
use crate::{Cause, tell};

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

/// By what a survey is solved; on a grid that has a node at every point of it.
pub(crate) const ROUTES: [Route; 3] =
    [Route::Exact, Route::Solver(Method::Force, Solver::ActiveSet), Route::Solver(Method::Force, Solver::Clarabel)];

/// Seconds after which a route is stopped.
pub(crate) fn patience(route: Route) -> f64 {
    PATIENCE[usize::from(route == ROUTES[2])]
}

/// One thing to measure, and the arguments of the process that does.
#[derive(Debug, Clone, Copy, PartialEq, clap::Args)]
pub(crate) struct Job {
    #[arg(value_parser = ground)]
    ground: Ground,
    points: u32,
    load: f64,
    #[arg(value_parser = route)]
    route: Route,
}

fn ground(word: &str) -> Result<Ground, String> {
    Ground::ALL.into_iter().find(|ground| ground.name() == word).ok_or_else(|| "no such ground".to_owned())
}

fn route(word: &str) -> Result<Route, String> {
    ROUTES.into_iter().find(|route| route.name() == word).ok_or_else(|| "no such route".to_owned())
}

impl Job {
    fn arguments(self) -> [String; 4] {
        [self.ground.name().to_owned(), self.points.to_string(), format!("{:e}", self.load), self.route.name()]
    }

    /// Intervals of its grid: a multiple of the segments; 0 for the exact solution.
    fn intervals(self) -> u32 {
        if self.route == Route::Exact { 0 } else { self.points * COARSEST.div_ceil(self.points) }
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
            let surveys = POINTS.into_iter().flat_map(|points| ROUTES.map(|route| (points, route)));
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
    /// Our check: `solved`, `not solved`, `gave up`; or `left-out`, `stopped`, `refused`.
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
    const PATH: &'static str = "report/data/scale.csv";

    /// `ground,points,load,method/solver`
    fn name(&self) -> String {
        format!("{},{},{:e},{}", self.ground, self.points, self.load, self.route)
    }
}

impl Line {
    /// Nothing is known of it yet.
    fn of(job: Job) -> Self {
        let (ground, route) = (job.ground.name().to_owned(), job.route.name());
        Self { ground, points: job.points, load: job.load, route, intervals: job.intervals(), ..Self::default() }
    }

    fn without_result(self, status: &str, why: String) -> Self {
        Self { status: status.to_owned(), why, ..self }
    }

    pub(crate) fn is_solved(&self) -> bool {
        self.status == "solved"
    }

    pub(crate) fn is_refused(&self) -> bool {
        self.status == REFUSED
    }
}

/// All lines, on disk and in memory.
pub(crate) type Scale = Measurements<Line>;

/// Runs all jobs that are wanted and that the file does not have yet.
pub(super) fn run(
    root: &Path,
    described: &[String],
    fresh: bool,
    up_to: u32,
    wanted: impl Fn(&str) -> bool,
) -> Result<(), Cause> {
    let mut scale = Scale::open(root, described, fresh, &wanted)?;
    let jobs = plan();
    for (k, job) in jobs.iter().enumerate().filter(|(_, job)| job.points <= up_to) {
        let begun = Line::of(*job);
        let name = begun.name();
        if !wanted(&name) || scale.named(&name).is_some() {
            continue;
        }
        // The longest survey before this one, by the same route; what it took is what this one takes at least.
        let before = jobs.iter().filter(|other| job.continues(**other)).max_by_key(|other| other.points);
        let before = before.and_then(|other| scale.named(&Line::of(*other).name()));
        let most = PART * patience(job.route);
        let line = match before {
            Some(line) if line.median_s.is_none_or(|seconds| most < seconds) => {
                let why = line.median_s.map_or_else(
                    || format!("{} points have no result", line.points),
                    |seconds| format!("{} points took {seconds:.1} s", line.points),
                );
                begun.without_result(LEFT_OUT, why)
            }
            _ => {
                tell(&format!("{} of {}: {name}", k + 1, jobs.len()));
                job.measured_alone(begun)?
            }
        };
        scale.append(line)?;
    }
    tell("all of it is measured; `cargo xtask report` renders the page from it");
    Ok(())
}

/// Runs of what is quick, and the seconds from which on one run has to do.
const RUNS: usize = 3;
const QUICK: f64 = 3.0;

/// How often it is asked whether a process is at its end.
const PAUSE: Duration = Duration::from_millis(5);

impl Job {
    /// The line of the job, by a process of its own; `begun` is what is known before.
    fn measured_alone(self, begun: Line) -> Result<Line, Cause> {
        let mut process = again("alone", &self.arguments())?.stdout(Stdio::piped()).spawn()?;
        let start = Instant::now();
        let patience = patience(self.route);
        let ended = loop {
            match process.try_wait()? {
                Some(ended) => break ended,
                None if patience < start.elapsed().as_secs_f64() => {
                    process.kill().and_then(|()| process.wait())?;
                    return Ok(begun.without_result(STOPPED, format!("no answer after {patience} s")));
                }
                None => sleep(PAUSE),
            }
        };
        let mut told = String::new();
        if let Some(mut output) = process.stdout.take() {
            output.read_to_string(&mut told)?;
        }
        if !ended.success() {
            return Ok(begun.without_result(STOPPED, format!("the process gave up: {ended}")));
        }
        parse(&told)?.pop().ok_or_else(|| format!("{}: no line", begun.name()).into())
    }

    /// What that process does: solves, and answers with a line of the file.
    pub(crate) fn measured_here(self) -> Result<Line, Cause> {
        let scene = survey(self.ground, self.points, self.load)?;
        let mut seconds: Vec<f64> = Vec::new();
        let mut found: Option<Line> = None;
        while seconds.len() < RUNS && seconds.iter().all(|seconds| *seconds < QUICK) {
            let start = Instant::now();
            let line = once(self, &scene);
            seconds.push(start.elapsed().as_secs_f64());
            // Memory that one answer leaves is not fetched again for the next: the first run is the one that counts.
            let peak_kb = found.as_ref().map_or_else(high_water_mark, |found| found.peak_kb);
            found = Some(Line { peak_kb, ..line });
        }
        let line = found.ok_or("no run at all")?;
        if line.residual.is_none() {
            return Ok(Line { peak_kb: None, ..line });
        }
        let runs = Some(seconds.len());
        let [median_s, min_s, max_s] = spread(seconds);
        Ok(Line { runs, median_s, min_s, max_s, ..line })
    }
}

/// Nodes that carry; an interior point leaves some force at all of them.
fn carrying(nodes: &Nodes) -> usize {
    nodes.contact_force.iter().filter(|force| 0.0 < **force).count()
}

/// Solves, without a clock.
fn once(job: Job, scene: &Scene) -> Line {
    let begun = Line::of(job);
    let intervals = usize::try_from(job.intervals()).unwrap_or(usize::MAX);
    match job::once(scene, plan::Job { route: job.route, intervals, tolerance: DEFAULT_TOLERANCE }) {
        Ok(Answer { state, status, residual, iterations, unknowns, lists, .. }) => Line {
            status: status.to_owned(),
            residual: rounded(residual, 2),
            energy: rounded(state.energy, 15),
            iterations: Some(iterations),
            lists,
            unknowns: Some(unknowns),
            contacts: match &state.nodes {
                None => Some(state.contacts.len()),
                Some(nodes) => (job.route == ROUTES[1]).then(|| carrying(nodes)),
            },
            ..begun
        },
        Err(error) => begun.without_result(REFUSED, error.to_string()),
    }
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
        let job = Job { ground: Ground::Walk, points: 300, load: 1.0, route: ROUTES[1] };
        assert_eq!(job.intervals(), 1200);
        assert!(Job { points: 1000, ..job }.continues(job) && !job.continues(job));
    }

    #[test]
    fn a_process_tells_its_line() {
        #[derive(clap::Parser)]
        struct Told {
            #[command(flatten)]
            job: Job,
        }
        let told = |arguments: &[String]| {
            let program = [String::new()];
            <Told as clap::Parser>::try_parse_from(program.iter().chain(arguments)).map(|told| told.job)
        };
        for job in plan() {
            assert_eq!(told(&job.arguments()).ok(), Some(job), "it is told what it is to do");
        }
        assert!(told(&["white noise", "100", "1e0", "nobody"].map(str::to_owned)).is_err() && told(&[]).is_err());
        let job = Job { ground: Ground::ALL[0], points: 100, load: 1.0, route: Route::Exact };
        let line = job.measured_here().expect("a line");
        assert_eq!((line.name(), line.is_solved()), (Line::of(job).name(), true), "{line:?}");
    }
}
