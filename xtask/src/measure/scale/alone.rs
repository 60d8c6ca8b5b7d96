//! One measurement in a process of its own, which is this program once more, as `xtask alone …`: its memory is that of one
//! solve, and it can be stopped.

use std::io::Read;
use std::process::{Command, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

use palkki::methods::Method;
use palkki::scene::Scene;
use palkki::solvers::Solver;
use palkki::state::Nodes;
use palkki::{Settings, solve, theory};
use palkki_evidence::extremes::{Ground, survey};

use super::{Job, Line, REFUSED, Route, STOPPED};
use crate::measure::memory;
use crate::measure::rows::rounded;

/// Runs of what is quick, and the seconds from which on one run has to do.
const RUNS: usize = 3;
const QUICK: f64 = 3.0;

/// How often it is asked whether a process is at its end.
const PAUSE: Duration = Duration::from_millis(5);

/// The line of a job that `begun` has the name of.
pub(super) fn measured(job: Job, begun: Line) -> Result<Line, String> {
    let failed = |error: &dyn std::fmt::Display| format!("{}: {error}", job.route.word());
    let program = std::env::current_exe().map_err(|error| failed(&error))?;
    let arguments = [job.ground.word().to_owned(), job.points.to_string(), format!("{:e}", job.load), job.route.word()];
    let start = Instant::now();
    let mut process = Command::new(program)
        .arg("alone")
        .args(arguments)
        .stdout(Stdio::piped())
        .spawn()
        .map_err(|error| failed(&error))?;
    let patience = job.route.patience();
    let ended = loop {
        match process.try_wait().map_err(|error| failed(&error))? {
            Some(ended) => break ended,
            None if patience < start.elapsed().as_secs_f64() => {
                process.kill().and_then(|()| process.wait()).map_err(|error| failed(&error))?;
                return Ok(begun.without_result(STOPPED, format!("no answer after {patience} s")));
            }
            None => sleep(PAUSE),
        }
    };
    let mut told = String::new();
    if let Some(mut output) = process.stdout.take() {
        output.read_to_string(&mut told).map_err(|error| failed(&error))?;
    }
    if !ended.success() {
        return Ok(begun.without_result(STOPPED, format!("the process gave up: {ended}")));
    }
    let mut lines = csv::ReaderBuilder::new().has_headers(false).from_reader(told.as_bytes()).into_deserialize();
    lines.next().ok_or_else(|| failed(&"no line"))?.map_err(|error| failed(&error))
}

/// What that process does: solves, and answers with a line of the file.
pub(crate) fn line(arguments: &[&str]) -> Result<String, String> {
    let [ground, points, load, route] = arguments else {
        return Err("alone takes ground, points, a load and a route".to_owned());
    };
    let job = Job {
        ground: Ground::ALL.into_iter().find(|g| g.word() == *ground).ok_or("no such ground")?,
        points: points.parse().map_err(|_| "no number of points")?,
        load: load.parse().map_err(|_| "no load")?,
        route: Route::ALL.into_iter().find(|r| r.word() == *route).ok_or("no such route")?,
    };
    let scene = survey(job.ground, job.points, job.load).map_err(|error| error.to_string())?;
    let mut seconds: Vec<f64> = Vec::new();
    let mut found: Option<Line> = None;
    while seconds.len() < RUNS && seconds.iter().all(|seconds| *seconds < QUICK) {
        let start = Instant::now();
        let line = once(job, &scene);
        seconds.push(start.elapsed().as_secs_f64());
        // Memory that one answer leaves is not fetched again for the next: the first run is the one that counts.
        let peak_kb = found.as_ref().map_or_else(memory::high_water_mark, |found| found.peak_kb);
        found = Some(Line { peak_kb, ..line });
    }
    seconds.sort_by(f64::total_cmp);
    let line = found.ok_or("no run at all")?;
    let has_result = line.residual.is_some();
    let of_runs = |k: usize| if has_result { rounded::<3>(seconds[k]) } else { None };
    let line = Line {
        runs: has_result.then_some(seconds.len()),
        median_s: of_runs(seconds.len() / 2),
        min_s: of_runs(0),
        max_s: of_runs(seconds.len() - 1),
        peak_kb: line.peak_kb.filter(|_| has_result),
        ..line
    };
    let mut writer = csv::WriterBuilder::new().has_headers(false).from_writer(Vec::new());
    writer.serialize(line).map_err(|error| error.to_string())?;
    let text = writer.into_inner().map_err(|error| error.to_string())?;
    Ok(String::from_utf8_lossy(&text).trim_end().to_owned())
}

/// Nodes that carry; an interior point leaves some force at all of them.
fn carrying(nodes: &Nodes) -> usize {
    nodes.contact_force.iter().filter(|force| 0.0 < **force).count()
}

/// Solves, without a clock.
fn once(job: Job, scene: &Scene) -> Line {
    let begun = Line::of(job);
    match job.route {
        Route::Exact => match theory::solve(scene) {
            Ok(exact) => Line {
                status: exact.status.word().to_owned(),
                residual: rounded::<2>(exact.residual),
                energy: rounded::<15>(exact.state.energy),
                iterations: Some(exact.iterations),
                lists: Some(exact.lists),
                unknowns: Some(exact.unknowns),
                contacts: Some(exact.state.contacts.len()),
                ..begun
            },
            Err(error) => begun.without_result(REFUSED, error.to_string()),
        },
        Route::Force(solver) => {
            let intervals = usize::try_from(job.intervals()).unwrap_or(usize::MAX);
            match solve(scene, &Settings::new(Method::Force, solver, intervals)) {
                Ok(outcome) => Line {
                    status: outcome.status.word().to_owned(),
                    residual: rounded::<2>(outcome.residual),
                    energy: rounded::<15>(outcome.state.energy),
                    iterations: Some(outcome.iterations),
                    unknowns: Some(outcome.unknowns),
                    contacts: outcome.state.nodes.as_ref().filter(|_| solver == Solver::ActiveSet).map(carrying),
                    ..begun
                },
                Err(error) => begun.without_result(REFUSED, error.to_string()),
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_process_tells_its_line() {
        let told = line(&["white noise", "100", "1e0", "exact/free-boundary"]).expect("a line");
        let fields: Vec<&str> = told.split(',').collect();
        assert_eq!(fields[..5], ["white noise", "100", "1.0", "exact/free-boundary", "0"], "{told}");
        assert_eq!(fields[5], "certified", "{told}");
        assert!(line(&["white noise", "100", "1e0", "nobody"]).is_err() && line(&[]).is_err());
    }
}
