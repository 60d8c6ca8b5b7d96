//! `cargo xtask measure`: what accuracy costs, route by route. Times go into one file of data and nowhere else.
//!
//! A run can be stopped at any moment and goes on where it stopped: every result is a line of the file, written as soon as
//! it is there. Results of another machine, compiler or dependency are not mixed: the file says where it comes from, and
//! `--fresh` starts it again.

pub(crate) mod errors;
mod job;
mod machine;
mod plan;
pub(crate) mod store;

use std::path::Path;

use crate::report::scenes;
use job::Measured;
use plan::{Job, LIMIT};
use store::{Line, Store};

/// Runs all jobs that the file does not have yet.
pub(crate) fn run(root: &Path, fresh: bool, progress: &mut dyn FnMut(&str)) -> Result<(), String> {
    let described = machine::describe(root);
    let mut store = Store::open(root, &described, fresh)?;
    for (scene_name, jobs) in plan::all() {
        let scene = scenes::read(root, scene_name).map_err(|error| error.to_string())?;
        let references = errors::References::new(&scene)?;
        // Seconds of the last run of a series: the same route and tolerance on coarser grids.
        let mut last: Option<(Job, f64)> = None;
        for (k, job) in jobs.iter().enumerate() {
            let key = job.key(scene_name);
            let before = last.as_ref().filter(|(other, _)| other.same_series(job)).map(|(_, seconds)| *seconds);
            let line = match (store.find(&key), before) {
                (Some(line), _) => line.clone(),
                (None, Some(seconds)) if LIMIT < seconds => {
                    let line = Line::left_out(key, seconds);
                    store.append(&line)?;
                    line
                }
                (None, _) => {
                    progress(&format!("{scene_name}, {} of {}: {}", k + 1, jobs.len(), job.describe()));
                    let measured = Measured::of(&scene, *job)?;
                    // A solver that refuses hands back no number at all.
                    let line = if measured.residual.is_infinite() && measured.iterations == 0 {
                        Line::refused(key)
                    } else {
                        Line::measured(key, &measured, &references.errors(&scene, *job, &measured)?)
                    };
                    store.append(&line)?;
                    line
                }
            };
            // A series that was left out stays out.
            last = Some((*job, line.seconds().unwrap_or(f64::INFINITY)));
        }
    }
    progress("all of it is measured; `cargo xtask report` renders the chapter from it");
    Ok(())
}
