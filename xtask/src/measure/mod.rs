//! `cargo xtask measure`: what accuracy costs, route by route. Times go into one file of data and nowhere else.
//!
//! A run can be stopped at any moment and goes on where it stopped: every result is a line of the file, written as soon as
//! it is there. Results of another machine, compiler or dependency are not mixed: the file says where it comes from, and
//! `--fresh` starts it again. `--only TEXT` measures what has the text in its line, `scene,route,intervals,tolerance`; with
//! `--fresh` it measures that again and keeps the rest. `--scale` measures surveys of up to a million points, into a file of
//! their own.

pub(crate) mod errors;
mod job;
mod machine;
mod memory;
pub(crate) mod plan;
mod reference;
mod rows;
pub(crate) mod scale;
pub(crate) mod store;
mod tridiagonal;

use std::path::Path;

use palkki::scene::Scene;

use crate::report::scenes;
use errors::References;
use job::Measured;
pub(crate) use memory::own_peak;
use plan::{Job, LIMIT, Route};
use store::{Key, Line, Store};

/// What is to be measured.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Wish<'a> {
    /// Again, whether it is in the file or not.
    pub(crate) fresh: bool,
    /// Lines that contain this text.
    pub(crate) only: &'a str,
    /// Time and memory over the points of a survey, instead of the price of accuracy.
    pub(crate) scale: bool,
    /// Of these, surveys of at most so many points.
    pub(crate) up_to: u32,
}

impl<'a> Wish<'a> {
    /// From the arguments of the command.
    pub(crate) fn of(arguments: &[&'a str]) -> Option<Self> {
        match arguments {
            [] => Some(Self { fresh: false, only: "", scale: false, up_to: u32::MAX }),
            ["--fresh", rest @ ..] => Some(Self { fresh: true, ..Self::of(rest)? }),
            ["--only", only, rest @ ..] => Some(Self { only, ..Self::of(rest)? }),
            ["--scale", rest @ ..] => Some(Self { scale: true, ..Self::of(rest)? }),
            ["--up-to", up_to, rest @ ..] => Some(Self { up_to: up_to.parse().ok()?, ..Self::of(rest)? }),
            _ => None,
        }
    }
}

/// Runs all jobs that are wanted and that the file does not have yet.
pub(crate) fn run(root: &Path, wish: Wish<'_>, progress: &mut dyn FnMut(&str)) -> Result<(), String> {
    if wish.scale {
        return scale::run(root, wish, progress);
    }
    let described = machine::describe(root);
    let wanted = |key: &str| key.contains(wish.only);
    let mut store = Store::open(root, &described, wish.fresh, wanted)?;
    for (scene_name, mut jobs) in plan::all() {
        jobs.retain(|job| wanted(&job.key(scene_name).name()));
        if jobs.iter().all(|job| store.find(&job.key(scene_name)).is_some()) {
            continue;
        }
        let scene = scenes::read(root, scene_name).map_err(|error| error.to_string())?;
        let references = References::new(&scene)?;
        // Seconds of the last run of a series: the same route and tolerance on coarser grids.
        let mut last: Option<(Job, f64)> = None;
        for (k, job) in jobs.iter().enumerate() {
            let key = job.key(scene_name);
            let before = last.as_ref().filter(|(other, _)| other.same_series(job)).map(|(_, seconds)| *seconds);
            let line = match (store.find(&key), before) {
                (Some(line), _) => line.clone(),
                (None, Some(seconds)) if LIMIT < seconds => {
                    let line = Line::left_out(&key);
                    store.append(line.clone())?;
                    line
                }
                (None, _) => {
                    progress(&format!("{scene_name}, {} of {}: {}", k + 1, jobs.len(), job.describe()));
                    let line = measure(scene_name, &scene, *job, &key, &references)?;
                    store.append(line.clone())?;
                    line
                }
            };
            // A series that was left out stays out.
            last = Some((*job, line.median_s.unwrap_or(f64::INFINITY)));
        }
    }
    progress("all of it is measured; `cargo xtask report` renders the chapter from it");
    Ok(())
}

/// One line of the file.
fn measure(name: &str, scene: &Scene, job: Job, key: &Key, references: &References) -> Result<Line, String> {
    if matches!(job.route, Route::Optimum(_)) {
        return Ok(match references.reference(scene, job) {
            Some(found) => Line::proven(key, found.exchanges, found.seconds, &references.of_grid(&found)),
            None => Line::without_result(key, "not-proven"),
        });
    }
    let measured = Measured::of(name, scene, job)?;
    // A solver that refuses hands back no number at all.
    if measured.residual.is_infinite() && measured.iterations == 0 {
        return Ok(Line::without_result(key, "refused"));
    }
    Ok(Line::measured(key, &measured, &references.errors(scene, job, &measured)))
}

#[cfg(test)]
mod tests {
    use super::Wish;

    #[test]
    fn arguments_are_read_in_any_order() {
        let read = |arguments: &[&str]| Wish::of(arguments).map(|wish| (wish.fresh, wish.only.to_owned()));
        assert_eq!(read(&[]), Some((false, String::new())));
        assert_eq!(read(&["--only", "wave,force", "--fresh"]), Some((true, "wave,force".to_owned())));
        assert_eq!(read(&["--fresh", "--only", "wave"]), Some((true, "wave".to_owned())));
        assert_eq!([read(&["--only"]), read(&["--fast"])], [None, None], "no such wish");
        let scale = Wish::of(&["--up-to", "1000", "--scale"]).map(|wish| (wish.scale, wish.up_to));
        assert_eq!(scale, Some((true, 1000)));
    }
}
