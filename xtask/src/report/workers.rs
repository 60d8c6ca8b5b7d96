//! The evidence of all chapters, as many at once as the machine has cores.
//!
//! A chapter is computed by one thread, from the tree and from what [`Study`] measures once for all of them, and so it is the
//! same whichever thread computes it and when.

use std::path::Path;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::mpsc::{Sender, channel};
use std::thread;

use super::Progress;
use super::chapters::CHAPTERS;
use super::error::{Cause, Error};
use super::evidence::Evidence;
use super::study::Study;

/// What a thread says of the chapter with some number.
enum Said {
    Begun(usize),
    Done(usize, Result<Evidence, Cause>),
}

/// What every chapter rests on, in the order of [`CHAPTERS`]; the error of the first that has one.
pub(super) fn compute(root: &Path, progress: Progress<'_>) -> Result<Vec<Evidence>, Error> {
    let study = Study::new(root);
    let cores = thread::available_parallelism().map_or(1, std::num::NonZero::get);
    let taken = AtomicUsize::new(0);
    let mut found: Vec<Option<Result<Evidence, Cause>>> = CHAPTERS.iter().map(|_| None).collect();
    thread::scope(|scope| {
        let (sender, receiver) = channel();
        for _ in 0..cores.min(CHAPTERS.len()) {
            let (sender, study, taken) = (sender.clone(), &study, &taken);
            scope.spawn(move || work(study, taken, &sender));
        }
        // The threads have theirs; the loop ends with the last of them.
        drop(sender);
        for said in receiver {
            match said {
                Said::Begun(k) => progress(&format!("chapter {} of {}, {}", k + 1, CHAPTERS.len(), CHAPTERS[k].key())),
                Said::Done(k, evidence) => found[k] = Some(evidence),
            }
        }
    });
    let evidence = |(chapter, found): (&super::chapters::Chapter, Option<Result<Evidence, Cause>>)| {
        let found = found.unwrap_or_else(|| Err("its thread gave up".into()));
        found.map_err(|source| Error::Evidence { chapter: chapter.name, source })
    };
    CHAPTERS.iter().zip(found).map(evidence).collect()
}

/// One thread: chapter after chapter, until all are taken. The last ones are taken first: the longest is among them, and
/// would otherwise begin when nothing is left for the other threads.
fn work(study: &Study<'_>, taken: &AtomicUsize, sender: &Sender<Said>) {
    loop {
        let taken = 1 + taken.fetch_add(1, Ordering::Relaxed);
        let Some(k) = CHAPTERS.len().checked_sub(taken) else { return };
        // Nobody listens any more only when all is over.
        let _ = sender.send(Said::Begun(k));
        let _ = sender.send(Said::Done(k, (CHAPTERS[k].evidence)(study)));
    }
}
