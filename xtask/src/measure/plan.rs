//! What is measured: every route over grids and tolerances.

use std::path::Path;

use palkki::DEFAULT_TOLERANCE;
use palkki::methods::Method;
use palkki::scene::Scene;
use palkki::solvers::Solver;
use palkki_evidence::extremes::{Ground, survey};

use super::line::Line;
use crate::{Cause, scenes};

/// Seconds after which a series is not continued on finer grids.
pub(crate) const LIMIT: f64 = 3.0;

/// The scene of the requirements: the paper's example, with all tolerances and the finest grids.
pub(crate) const EXAMPLE: &str = "heinisuo-1984";

/// Others, on which the trade is another one: contact at single points, kinks between the nodes, a beam bent over a hump.
pub(crate) const OTHERS: [&str; 3] = ["wave", "survey", "hump"];

/// Tolerances that iterative solvers are asked for, on the example and on the others.
const TOLERANCES: [f64; 6] = [1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-13];
const FEWER: [f64; 3] = [1e-4, 1e-7, 1e-10];

/// Errors that are demanded of the adaptive grid.
const DEMANDED: [f64; 4] = [1e-2, 1e-3, 1e-4, 1e-6];

/// Intervals of the grids, up to the finest of each series.
pub(crate) const GRIDS: [usize; 11] = [10, 30, 100, 300, 1000, 3000, 10_000, 30_000, 100_000, 300_000, 1_000_000];

/// Seconds after which a process that solves a survey is stopped, and the part of them after which a series of surveys is not
/// continued: ten times the points take some ten times as long.
pub(crate) const PATIENCE: f64 = 180.0;
pub(super) const PART: f64 = 1.0 / 12.0;

/// Points of the surveys: segments, to be exact.
const POINTS: [u32; 4] = [1000, 10_000, 100_000, 1_000_000];

/// More than the exact solution takes, so that the file has its words for that; of one survey.
pub(crate) const TOO_MANY: u32 = 20_000_000;

/// Uniform loads on surveys: under the light one the beam rests on a few points, under the heavy one it lies on all that is
/// smooth.
const LOADS: [f64; 2] = [1.0, 1e4];

/// No grid of a survey is coarser.
const COARSEST: u32 = 1000;

/// By what a survey is solved; on a grid that has a node at every point of it.
pub(crate) const ROUTES: [Route; 3] =
    [Route::Exact, Route::Solver(Method::Force, Solver::ActiveSet), Route::Solver(Method::Force, Solver::Clarabel)];

/// What is solved.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Subject {
    /// A scene of the gallery.
    Gallery(&'static str),
    Survey(Survey),
}

/// A survey as a laser gives it, see [`survey`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Survey {
    pub(crate) ground: Ground,
    pub(crate) points: u32,
    pub(crate) load: f64,
}

/// What the names of surveys have, and those of the gallery have not.
const OF_A_SURVEY: &str = " points of ";

/// Whether the name is that of a survey.
pub(crate) fn is_survey(name: &str) -> bool {
    name.contains(OF_A_SURVEY)
}

/// The surveys, ground by ground and load by load, and of each the shorter ones first.
pub(crate) fn surveys() -> impl Iterator<Item = Survey> {
    let loaded = Ground::ALL.into_iter().flat_map(|ground| LOADS.map(|load| (ground, load)));
    loaded.flat_map(|(ground, load)| POINTS.map(|points| Survey { ground, points, load }))
}

impl Subject {
    /// As the files have it.
    pub(crate) fn name(self) -> String {
        match self {
            Self::Gallery(name) => name.to_owned(),
            Self::Survey(Survey { ground, points, load }) => {
                format!("{points}{OF_A_SURVEY}{} under {load:e}", ground.name())
            }
        }
    }

    pub(crate) fn scene(self, root: &Path) -> Result<Scene, Cause> {
        match self {
            Self::Gallery(name) => scenes::read(root, name),
            Self::Survey(Survey { ground, points, load }) => Ok(survey(ground, points, load)?),
        }
    }

    /// Whether the other one is the same, or a survey of the same ground under the same load.
    fn continues(self, other: Self) -> bool {
        let any_points = |subject| match subject {
            Self::Survey(survey) => Self::Survey(Survey { points: 0, ..survey }),
            gallery => gallery,
        };
        any_points(self) == any_points(other)
    }
}

/// How an answer is found.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Route {
    /// Beam theory with free lift-off points; no grid.
    Exact,
    /// The same with the bounds of all its numbers, as `palkki solve` prints them.
    Certified,
    /// The proven optimum of the discrete problem of a method, in integers of hundreds of bits.
    Optimum(Method),
    /// A method with a solver.
    Solver(Method, Solver),
    /// A method with a solver on the grid that the demanded error takes.
    Adaptive(Method, Solver),
}

/// One thing to measure.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Job {
    pub(crate) subject: Subject,
    pub(crate) route: Route,
    /// Intervals; 0 for beam theory and for the adaptive grid.
    pub(crate) intervals: usize,
    /// What an iterative solver is asked for, or the error that is demanded of the adaptive grid; 0 for the others.
    pub(crate) tolerance: f64,
}

impl Route {
    /// `method/solver` as the files have it.
    pub(crate) fn name(self) -> String {
        match self {
            Self::Exact => "exact/free-boundary".to_owned(),
            Self::Certified => "exact/free-boundary-certified".to_owned(),
            Self::Optimum(method) => format!("{method}/optimum"),
            Self::Solver(method, solver) => format!("{method}/{solver}"),
            Self::Adaptive(method, solver) => format!("{method}/{solver}-adaptive"),
        }
    }
}

impl Job {
    /// What identifies the line of the file.
    pub(crate) fn name(self) -> String {
        Line::of(self).name()
    }

    /// Whether the other job is the same on another grid, or on a survey of other points.
    pub(crate) fn same_series(&self, other: &Self) -> bool {
        self.route == other.route
            && self.tolerance.total_cmp(&other.tolerance).is_eq()
            && self.subject.continues(other.subject)
    }
}

/// All jobs, those on the same scene together; a series runs from coarse to fine grids, and from short to long surveys. Routes on
/// the same survey follow each other, so that their ratio is that of one hour.
pub(crate) fn all() -> Vec<Vec<Job>> {
    let mut jobs = vec![jobs(EXAMPLE, &TOLERANCES, true)];
    jobs.extend(OTHERS.map(|scene| self::jobs(scene, &FEWER, false)));
    jobs.extend(surveys().map(|survey| ROUTES.map(|route| on_survey(survey, route)).to_vec()));
    let too_many = Survey { ground: Ground::Walk, points: TOO_MANY, load: LOADS[0] };
    jobs.push(vec![on_survey(too_many, Route::Exact)]);
    jobs
}

/// A survey by one of [`ROUTES`].
pub(crate) fn on_survey(survey: Survey, route: Route) -> Job {
    let subject = Subject::Survey(survey);
    if route == Route::Exact {
        return Job { subject, route, intervals: 0, tolerance: 0.0 };
    }
    // A multiple of the segments.
    let intervals = survey.points * COARSEST.div_ceil(survey.points);
    let tolerance = if route == ROUTES[1] { 0.0 } else { DEFAULT_TOLERANCE };
    Job { subject, route, intervals: usize::try_from(intervals).unwrap_or(usize::MAX), tolerance }
}

fn up_to(finest: usize) -> impl Iterator<Item = usize> {
    GRIDS.into_iter().take_while(move |intervals| *intervals <= finest)
}

/// The jobs of a scene, with `tolerances`; `all` of the grids, or not those on which the example has said enough.
fn jobs(scene: &'static str, tolerances: &[f64], all: bool) -> Vec<Job> {
    let job = |route, intervals, tolerance| Job { subject: Subject::Gallery(scene), route, intervals, tolerance };
    let mut jobs = vec![job(Route::Exact, 0, 0.0), job(Route::Certified, 0, 0.0)];
    let adaptive = Route::Adaptive(Method::Force, Solver::ActiveSet);
    jobs.extend(DEMANDED.map(|tolerance| job(adaptive, 0, tolerance)));
    let mut series = |route, tolerance, finest: usize| {
        jobs.extend(up_to(finest).map(|intervals| job(route, intervals, tolerance)));
    };
    for method in [Method::Complementarity, Method::Force] {
        series(Route::Optimum(method), 0.0, if all { 100_000 } else { 30_000 });
    }
    for method in Method::ALL {
        series(Route::Solver(method, Solver::ActiveSet), 0.0, 1_000_000);
        series(Route::Solver(method, Solver::FourStep), 0.0, if all { 10_000 } else { 1000 });
        for &tolerance in tolerances {
            series(Route::Solver(method, Solver::Nsor), tolerance, 300);
            // Interior-point iterations are as many on fine grids: two tolerances are enough to know the price of the finest.
            let finest = if all && matches!(tolerance, 1e-8 | 1e-10) { 100_000 } else { 30_000 };
            series(Route::Solver(method, Solver::Clarabel), tolerance, finest);
            series(Route::Solver(method, Solver::Osqp), tolerance, if all { 30_000 } else { 3000 });
        }
    }
    jobs
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::*;

    #[test]
    fn every_job_has_a_key_of_its_own() {
        let keys: Vec<String> = all().concat().into_iter().map(Job::name).collect();
        assert_eq!(keys.iter().collect::<BTreeSet<_>>().len(), keys.len(), "a key is a line of the file");
    }

    #[test]
    fn every_point_of_a_survey_is_a_node() {
        let job = |points| on_survey(Survey { ground: Ground::Walk, points, load: 1.0 }, ROUTES[1]);
        assert_eq!(job(300).intervals, 1200);
        assert!(job(1000).same_series(&job(300)) && is_survey(&job(300).subject.name()));
    }
}
