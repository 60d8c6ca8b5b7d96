//! The program on a survey, in a process of its own: seconds from its start to its end, reading and printing included, and the
//! most memory that it has in use.

use std::fmt::Write as _;
use std::fs;
use std::path::Path;
use std::process::{Command, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

use palkki::scene::{Foundation, Scene};

use super::instruments::high_water_mark;
use super::job::timed;
use super::plan::{Job, PATIENCE, Route};
use crate::Cause;
use crate::report::files;

/// Where the scene file of the survey under way is, and its points.
const PLACE: &str = "target/measure";

/// How often the process is looked at: times are longer by this at the most.
const PAUSE: Duration = Duration::from_millis(1);

/// A process that came to its end.
pub(super) struct Process {
    pub(super) seconds: Vec<f64>,
    /// Kilobytes, if the system says.
    pub(super) peak_kb: Option<u64>,
}

/// Writes a survey as a scene file with its points.
pub(super) fn written(root: &Path, scene: &Scene) -> Result<(), Cause> {
    let Some(Foundation::Polyline { points }) = scene.foundation() else { return Err("a survey is a polyline".into()) };
    let mut survey = "x,depth\n".to_owned();
    points.iter().try_for_each(|[x, depth]| writeln!(survey, "{x:?},{depth:?}"))?;
    let (beam, load) = (scene.beam(), scene.load().uniform());
    let (length, stiffness) = (beam.length(), beam.bending_stiffness());
    let text = format!(
        "[beam]\nlength = {length:?}\nbending_stiffness = {stiffness:?}\n[load]\nuniform = {load:?}\n\
         [foundation]\nsurvey = \"survey.csv\"\n"
    );
    files::replace(&root.join(PLACE).join("survey.csv"), &survey)?;
    Ok(files::replace(&root.join(PLACE).join("survey.toml"), &text)?)
}

/// Solves the survey that was written by the route of a job; nothing if that takes longer than [`PATIENCE`].
pub(super) fn run(root: &Path, job: Job) -> Result<Option<Process>, Cause> {
    let mut peak_kb = None;
    let (seconds, ended) = timed(|| once(root, job, &mut peak_kb))?;
    Ok(ended.then_some(Process { seconds, peak_kb }))
}

/// One process; whether it came to its end.
fn once(root: &Path, job: Job, peak_kb: &mut Option<u64>) -> Result<bool, Cause> {
    // `cargo xtask measure` builds the program beside this one.
    let mut command = Command::new(std::env::current_exe()?.with_file_name("palkki"));
    command.arg("solve").arg(root.join(PLACE).join("survey.toml"));
    if let Route::Solver(method, solver) = job.route {
        command.args(["--method", method.name(), "--solver", solver.name(), "--intervals", &job.intervals.to_string()]);
    }
    let mut process = command.stdout(Stdio::null()).stderr(Stdio::null()).spawn()?;
    let start = Instant::now();
    let status = format!("/proc/{}/status", process.id());
    loop {
        let mark = fs::read_to_string(&status).ok().and_then(|text| high_water_mark(&text));
        *peak_kb = (*peak_kb).max(mark);
        match process.try_wait()? {
            // Code 2 is bad input or a refusal: an answer of this program will say which.
            Some(ended) => return Ok(ended.code().is_some()),
            None if PATIENCE < start.elapsed().as_secs_f64() => {
                process.kill().and_then(|()| process.wait())?;
                return Ok(false);
            }
            None => sleep(PAUSE),
        }
    }
}

#[cfg(test)]
mod tests {
    use palkki::scene::file::{ReadProblem, parse};
    use palkki_evidence::extremes::{Ground, survey};

    use super::*;

    #[test]
    fn a_survey_is_read_as_it_was_written() {
        let scratch = tempfile::tempdir().expect("a directory for temporary files");
        let scene = survey(Ground::Walk, 100, 1e4).expect("a survey");
        written(scratch.path(), &scene).expect("it can be written");
        let text = |name: &str| fs::read_to_string(scratch.path().join(PLACE).join(name));
        let points = |name: &str| text(name).map_err(|_| ReadProblem::Missing);
        let read = parse("survey.toml", &text("survey.toml").expect("a file"), points).expect("a scene");
        assert_eq!((read.foundation(), read.load(), read.beam()), (scene.foundation(), scene.load(), scene.beam()));
    }
}
