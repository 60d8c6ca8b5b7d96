//! A notice of long work: one line on standard error if it is a terminal and the work needs more than two seconds.

use std::io::{self, IsTerminal as _, Write};
use std::sync::mpsc::{self, Receiver, RecvTimeoutError};
use std::thread;
use std::time::Duration;

/// Time after which the line is written.
const DELAY: Duration = Duration::from_secs(2);

/// Does `work`. The notice names it `what`.
pub(super) fn telling<T>(what: String, work: impl FnOnce() -> T) -> T {
    if !io::stderr().is_terminal() {
        return work();
    }
    let (end, ended) = mpsc::channel();
    let teller = thread::Builder::new().spawn(move || tell(&ended, DELAY, &what, &mut io::stderr()));
    let done = work();
    drop(end);
    // The answer does not depend on whether the thread could start or the line could be written.
    let _ = teller.map(thread::JoinHandle::join);
    done
}

/// Writes the line unless the work ends before.
fn tell(ended: &Receiver<()>, delay: Duration, what: &str, terminal: &mut dyn Write) {
    if ended.recv_timeout(delay) == Err(RecvTimeoutError::Timeout) {
        let _ = writeln!(terminal, "palkki: {what} takes more than {} seconds", DELAY.as_secs());
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The notice of work that has or has not ended after the given time.
    fn written(has_ended: bool, delay: Duration) -> String {
        let (end, ended) = mpsc::channel();
        let end = (!has_ended).then_some(end);
        let mut terminal = Vec::new();
        tell(&ended, delay, "solving scene.toml", &mut terminal);
        drop(end);
        String::from_utf8(terminal).expect("text")
    }

    #[test]
    fn only_what_takes_long_is_told_and_once() {
        assert_eq!(written(false, Duration::ZERO), "palkki: solving scene.toml takes more than 2 seconds\n");
        assert_eq!(written(true, Duration::from_secs(600)), "", "it does not wait for the delay");
    }

    #[test]
    fn the_work_is_done() {
        assert_eq!(telling("counting".to_owned(), || 1 + 1), 2);
    }
}
