//! `cargo xtask measure`: what accuracy costs, route by route. Times go into one file of data and nowhere else.
//!
//! A run can be stopped at any moment and goes on where it stopped: every result is a line of the file, written as soon as
//! it is there. Results of another machine, compiler or dependency are not mixed: the file says where it comes from, and
//! `--fresh` starts it again. `--only TEXT` measures what has the text in its line, `scene,route,intervals,tolerance`; with
//! `--fresh` it measures that again and keeps the rest. `--scale` measures surveys of up to a million points, into a file of
//! their own.

pub(crate) mod instruments;
mod job;
pub(crate) mod line;
pub(crate) mod plan;
mod references;
pub(crate) mod scale;

use std::path::Path;

use crate::data::Row;
use crate::{Cause, scenes, tell};
use line::{Line, Store};
use plan::{Job, LIMIT};
use references::References;

/// What is to be measured.
#[derive(Debug, clap::Args)]
pub(crate) struct Wish {
    /// Again, whether it is in the file or not.
    #[arg(long)]
    fresh: bool,
    /// Lines that contain this text.
    #[arg(long, default_value = "", value_name = "TEXT")]
    only: String,
    /// Time and memory over the points of a survey, instead of the price of accuracy.
    #[arg(long)]
    scale: bool,
    /// Of these, surveys of at most so many points.
    #[arg(long, default_value_t = u32::MAX, value_name = "POINTS")]
    up_to: u32,
}

/// Runs all jobs that are wanted and that the file does not have yet.
pub(crate) fn run(root: &Path, wish: &Wish) -> Result<(), Cause> {
    let described = instruments::describe(root);
    let wanted = |name: &str| name.contains(&wish.only);
    if wish.scale {
        return scale::run(root, &described, wish.fresh, wish.up_to, wanted);
    }
    let mut store = Store::open(root, &described, wish.fresh, wanted)?;
    for (name, mut jobs) in plan::all() {
        jobs.retain(|job| wanted(&job.name(name)));
        if jobs.iter().all(|job| store.named(&job.name(name)).is_some()) {
            continue;
        }
        let scene = scenes::read(root, name)?;
        let references = References::new(&scene)?;
        // Seconds of the last run of a series: the same route and tolerance on coarser grids.
        let mut last: Option<(Job, f64)> = None;
        for (k, &job) in jobs.iter().enumerate() {
            let begun = Line::of(name, job);
            let before = last.filter(|(other, _)| other.same_series(&job)).map(|(_, seconds)| seconds);
            let line = match (store.named(&begun.name()), before) {
                (Some(line), _) => line.clone(),
                (None, before) => {
                    let line = if before.is_some_and(|seconds| LIMIT < seconds) {
                        begun.left_out()
                    } else {
                        tell(&format!("{} of {}: {}", k + 1, jobs.len(), begun.name()));
                        job::measured(begun, &scene, job, &references)?
                    };
                    store.append(line.clone())?;
                    line
                }
            };
            // A series that was left out stays out.
            last = Some((job, line.median_s.unwrap_or(f64::INFINITY)));
        }
    }
    tell("all of it is measured; `cargo xtask report` renders the chapter from it");
    Ok(())
}

#[cfg(test)]
mod tests;
