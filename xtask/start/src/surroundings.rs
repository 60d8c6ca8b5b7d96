//! What the checks ask this machine for.

use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

/// The machine, as far as the checks ask about it; tests put another in its place.
pub(crate) trait Surroundings {
    /// True if the command starts and ends with code 0.
    fn succeeds(&self, program: &str, arguments: &[&str]) -> bool;
    /// What the command prints, trimmed; `None` if it does not start or fails.
    fn output(&self, program: &str, arguments: &[&str]) -> Option<String>;
    /// The value of an environment variable, if it is set.
    fn variable(&self, name: &str) -> Option<String>;
    /// True if files can be made in a directory below the root of the repository.
    fn writable(&self, directory: &str) -> bool;
    /// The text of a file of the repository.
    fn text(&self, file: &str) -> Option<String>;
}

/// This machine and this repository.
#[derive(Debug)]
pub(crate) struct Machine {
    /// The root of the repository.
    pub(crate) root: PathBuf,
}

impl Machine {
    fn command(&self, program: &str, arguments: &[&str]) -> Command {
        // A program with a slash is a file of the repository.
        let program = if program.contains('/') { self.root.join(program) } else { PathBuf::from(program) };
        let mut command = Command::new(program);
        command.args(arguments).current_dir(&self.root).stdin(Stdio::null()).stderr(Stdio::null());
        command
    }
}

impl Surroundings for Machine {
    fn succeeds(&self, program: &str, arguments: &[&str]) -> bool {
        self.command(program, arguments).stdout(Stdio::null()).status().is_ok_and(|status| status.success())
    }

    fn output(&self, program: &str, arguments: &[&str]) -> Option<String> {
        let output = self.command(program, arguments).output().ok()?;
        output.status.success().then(|| String::from_utf8_lossy(&output.stdout).trim().to_owned())
    }

    fn variable(&self, name: &str) -> Option<String> {
        std::env::var(name).ok().filter(|value| !value.is_empty())
    }

    fn writable(&self, directory: &str) -> bool {
        let directory = self.root.join(directory);
        let existing = directory.ancestors().find(|place| place.is_dir()).unwrap_or(Path::new("/"));
        let probe = existing.join(format!(".doctor-{}", std::process::id()));
        let written = std::fs::write(&probe, "").is_ok();
        // The probe is ours and empty; if it cannot be removed, nothing is lost.
        let _ = std::fs::remove_file(&probe);
        written
    }

    fn text(&self, file: &str) -> Option<String> {
        std::fs::read_to_string(self.root.join(file)).ok()
    }
}
