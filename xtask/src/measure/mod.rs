//! `cargo xtask measure`: what accuracy costs, route by route. Times go into one file of data and nowhere else.
//!
//! A run can be stopped at any moment and goes on where it stopped: every result is a line of the file, written as soon as
//! it is there. Results of another machine, compiler or dependency are not mixed: the file says where it comes from, and
//! `--fresh` starts it again. `--only TEXT` measures what has the text in its line, `scene,route,intervals,tolerance`; with
//! `--fresh` it measures that again and keeps the rest. `--only "points of"` measures the surveys, `--only population` the errors on
//! the population, which has a file of its own and no times, and `--only soil` the surveys on soil, which have one as well.

pub(crate) mod advice;
pub(crate) mod instruments;
mod job;
pub(crate) mod line;
pub(crate) mod plan;
pub(crate) mod population;
mod process;
mod references;
pub(crate) mod soil;

use std::path::Path;

use crate::{Cause, tell};
use line::{Line, Store};
use plan::{Job, LIMIT, PART, PATIENCE, Subject};
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
}

/// Runs all jobs that are wanted and that the file does not have yet.
pub(crate) fn run(root: &Path, wish: &Wish) -> Result<(), Cause> {
    // It takes seconds, and has to follow the advice.
    if population::NAME.contains(&wish.only) {
        tell(population::NAME);
        population::run(root)?;
    }
    if soil::NAME.contains(&wish.only) {
        soil::run(root)?;
    }
    if [population::NAME, soil::NAME].contains(&wish.only.as_str()) {
        return Ok(());
    }
    let wanted = |name: &str| name.contains(&wish.only);
    let mut store = Store::open(root, &instruments::describe(root), wish.fresh, wanted)?;
    let all = plan::all();
    for (k, jobs) in all.iter().enumerate() {
        let is_missing = |job: &&Job| wanted(&job.name()) && store.named(&job.name()).is_none();
        let missing: Vec<Job> = jobs.iter().filter(is_missing).copied().collect();
        let Some(subject) = missing.first().map(|job| job.subject) else { continue };
        let scene = subject.scene(root)?;
        let is_survey = matches!(subject, Subject::Survey(_));
        if is_survey {
            process::written(root, &scene)?;
        }
        let limit = if is_survey { PART * PATIENCE } else { LIMIT };
        let references = References::new(&scene, !is_survey);
        for job in missing {
            // What the same took on the grid or the survey before, or longer than anything if it was left out.
            let before = all[..=k].iter().flatten().rev().skip_while(|other| **other != job).skip(1);
            let before = before.filter(|other| other.same_series(&job)).find_map(|other| store.named(&other.name()));
            let line = if before.is_some_and(|line| line.median_s.is_none_or(|seconds| limit < seconds)) {
                Line::of(job).left_out()
            } else {
                tell(&job.name());
                job::measured(root, &scene, job, &references)?
            };
            store.append(line)?;
        }
    }
    tell("all of it is measured; `cargo xtask report` renders the chapter from it");
    Ok(())
}

#[cfg(test)]
mod tests;
