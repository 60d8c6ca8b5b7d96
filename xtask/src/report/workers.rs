//! The evidence of all subjects, as many at once as the machine has cores.
//!
//! A subject is computed by one thread, from the tree and from what [`Study`] measures once for all of them, and so it is the
//! same whichever thread computes it and when.

use std::collections::BTreeSet;
use std::path::Path;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::mpsc::{Sender, channel};
use std::thread;

use super::Progress;
use super::error::{Cause, Error};
use super::evidence::{EVIDENCE, Evidence, Subject};
use super::study::Study;

/// What a thread says of the subject with some number.
enum Said {
    Begun(usize),
    Done(usize, Result<Evidence, Cause>),
}

/// What the `wanted` subjects rest on, in the order of [`EVIDENCE`]; the error of the first that has one.
pub(super) fn compute(
    root: &Path,
    wanted: &BTreeSet<String>,
    progress: Progress<'_>,
) -> Result<Vec<(&'static str, Evidence)>, Error> {
    let subjects: Vec<Subject> = EVIDENCE.iter().filter(|(name, _)| wanted.contains(*name)).copied().collect();
    let study = Study::new(root);
    let cores = thread::available_parallelism().map_or(1, std::num::NonZero::get);
    let taken = AtomicUsize::new(0);
    let mut found: Vec<Option<Result<Evidence, Cause>>> = subjects.iter().map(|_| None).collect();
    thread::scope(|scope| {
        let (sender, receiver) = channel();
        for _ in 0..cores.min(subjects.len()) {
            let (sender, subjects, study, taken) = (sender.clone(), &subjects, &study, &taken);
            scope.spawn(move || work(subjects, study, taken, &sender));
        }
        // The threads have theirs; the loop ends with the last of them.
        drop(sender);
        for said in receiver {
            match said {
                Said::Begun(k) => progress(&format!("evidence {} of {}, {}", k + 1, subjects.len(), subjects[k].0)),
                Said::Done(k, evidence) => found[k] = Some(evidence),
            }
        }
    });
    let evidence = |(&(subject, _), found): (&Subject, Option<Result<Evidence, Cause>>)| {
        let found = found.unwrap_or_else(|| Err("its thread gave up".into()));
        found.map(|evidence| (subject, evidence)).map_err(|source| Error::Evidence { subject, source })
    };
    subjects.iter().zip(found).map(evidence).collect()
}

/// One thread: subject after subject, until all are taken. The last ones are taken first: the longest is among them, and
/// would otherwise begin when nothing is left for the other threads.
fn work(subjects: &[Subject], study: &Study<'_>, taken: &AtomicUsize, sender: &Sender<Said>) {
    loop {
        let taken = 1 + taken.fetch_add(1, Ordering::Relaxed);
        let Some(k) = subjects.len().checked_sub(taken) else { return };
        // Nobody listens any more only when all is over.
        let _ = sender.send(Said::Begun(k));
        let _ = sender.send(Said::Done(k, (subjects[k].1)(study)));
    }
}
