//! A root of its own for a test that writes files.

use std::path::PathBuf;
use std::{env, fs, process};

use crate::report::files;

/// An empty directory, removed in the end.
#[derive(Debug)]
pub(crate) struct Scratch(pub(crate) PathBuf);

impl Scratch {
    /// `name` tells the directories of tests that run at the same time apart.
    pub(crate) fn new(name: &str) -> Self {
        let place = env::temp_dir().join(format!("palkki-{}-{name}", process::id()));
        fs::create_dir_all(&place).expect("a scratch directory can be made");
        Self(place)
    }

    /// Writes a file below it.
    pub(crate) fn put(&self, path: &str, text: &str) {
        files::replace(&self.0.join(path), text).expect("the scratch directory can be written to");
    }
}

impl Drop for Scratch {
    fn drop(&mut self) {
        // What stays is in the directory for temporary files.
        let _ = fs::remove_dir_all(&self.0);
    }
}
