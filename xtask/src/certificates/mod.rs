//! `cargo xtask certificates`: the certificates of every route on every grid for every scene of the gallery beside beam theory,
//! and fault injection: every fault put into the answers. It takes minutes, so what comes out is kept in two files of data; the report computes a stated
//! part of them again each time.

pub(crate) mod answers;
pub(crate) mod faults;
mod table;

use std::fs;
use std::path::Path;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::mpsc::{Sender, channel};
use std::thread;

use palkki::scene::Scene;

use crate::report::scenes;

/// What is found about one scene, or why nothing is.
type Found = Result<(Vec<answers::Row>, Vec<faults::Row>), String>;

/// What a thread says of the scene with some number: that it is at work on a part of it, or that it has done.
enum Said {
    Begun(usize, String),
    Done(usize, Found),
}

/// Computes both files, as many scenes at once as the machine has cores. The rows are in the order of the scenes.
pub(crate) fn run(root: &Path, progress: &mut dyn FnMut(&str)) -> Result<(), String> {
    let scenes = scenes::all(root).map_err(|error| error.to_string())?;
    let cores = thread::available_parallelism().map_or(1, std::num::NonZero::get);
    let next = AtomicUsize::new(0);
    let mut found: Vec<Option<Found>> = scenes.iter().map(|_| None).collect();
    thread::scope(|scope| {
        let (sender, receiver) = channel();
        for _ in 0..cores {
            let (sender, scenes, next) = (sender.clone(), &scenes, &next);
            scope.spawn(move || work(scenes, next, &sender));
        }
        // The threads have theirs; the loop ends with the last of them.
        drop(sender);
        for said in receiver {
            match said {
                Said::Begun(k, part) => progress(&format!("{} of {}, {}: {part}", k + 1, scenes.len(), scenes[k].0)),
                Said::Done(k, rows) => found[k] = Some(rows),
            }
        }
    });
    let (mut judged, mut broken) = (Vec::new(), Vec::new());
    for (rows, (name, _)) in found.into_iter().zip(&scenes) {
        let (answers, faults) = rows.unwrap_or_else(|| Err(format!("{name}: its thread gave up")))?;
        judged.extend(answers);
        broken.extend(faults);
    }
    write(root, answers::PATH, &answers::text(&judged))?;
    write(root, faults::PATH, &faults::text(&broken))?;
    progress("`cargo xtask report` renders the page from it");
    Ok(())
}

/// One thread: scene after scene, until all are taken.
fn work(scenes: &[(String, Scene)], next: &AtomicUsize, sender: &Sender<Said>) {
    loop {
        let k = next.fetch_add(1, Ordering::Relaxed);
        let Some((name, scene)) = scenes.get(k) else { return };
        let begun = |part: String| {
            // Nobody listens any more only when all is over.
            let _ = sender.send(Said::Begun(k, part));
        };
        let found = one(name, scene, scenes, &begun);
        let _ = sender.send(Said::Done(k, found));
    }
}

fn one(name: &str, scene: &Scene, scenes: &[(String, Scene)], begun: &dyn Fn(String)) -> Found {
    let mut judged = Vec::new();
    for intervals in answers::GRIDS {
        begun(format!("every route on {intervals} intervals"));
        judged.extend(answers::rows(name, scene, &[intervals]).map_err(|error| error.to_string())?);
    }
    begun("every fault".to_owned());
    let broken = faults::rows(name, scene, scenes).map_err(|error| error.to_string())?;
    Ok((judged, broken))
}

fn write(root: &Path, path: &str, text: &str) -> Result<(), String> {
    fs::write(root.join(path), text).map_err(|error| format!("{path}: {error}"))
}
