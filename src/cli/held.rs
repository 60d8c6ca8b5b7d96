//! Signals that wait while there are files to clean up.

use std::io;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};

use signal_hook::consts::{SIGINT, SIGTERM};
use signal_hook::{flag, low_level};

/// What ends a program in the middle: an interrupt, and an end that is asked for.
const ENDING: [i32; 2] = [SIGINT, SIGTERM];

/// While this is there, such a signal waits; when it is dropped, the signal ends the program as it would have done. A file that
/// grows beyond its limit is an error of writing, which cleans up, and no signal.
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
            // It ends the program; where the system has no such signal, the program goes on.
            let _ = low_level::emulate_default_handler(signal);
        }
    }
}
