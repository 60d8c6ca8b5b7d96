//! Deferred signals while there are files to clean up.

use std::io;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};

use signal_hook::consts::{SIGINT, SIGTERM};
use signal_hook::{flag, low_level};

/// The signals that end a program early: an interrupt, and a request to terminate.
const ENDING: [i32; 2] = [SIGINT, SIGTERM];

/// While this value exists, these signals wait. When it is dropped, a signal that was received ends the program as usual. A file that
/// grows beyond its size limit causes a write error, which cleans up, instead of a signal.
#[derive(Debug)]
pub(super) struct Held {
    free: Arc<AtomicBool>,
    caught: Arc<AtomicUsize>,
}

impl Held {
    pub(super) fn new() -> io::Result<Self> {
        let held = Self { free: Arc::default(), caught: Arc::default() };
        for signal in ENDING {
            flag::register_conditional_default(signal, Arc::clone(&held.free))?;
            let number = usize::try_from(signal).unwrap_or_default();
            flag::register_usize(signal, Arc::clone(&held.caught), number)?;
        }
        #[cfg(unix)]
        flag::register(signal_hook::consts::SIGXFSZ, Arc::default())?;
        Ok(held)
    }
}

impl Drop for Held {
    fn drop(&mut self) {
        self.free.store(true, Ordering::SeqCst);
        let signal = i32::try_from(self.caught.load(Ordering::SeqCst)).unwrap_or_default();
        if signal != 0 {
            // This ends the program. If the system has no such signal, the program continues.
            let _ = low_level::emulate_default_handler(signal);
        }
    }
}
