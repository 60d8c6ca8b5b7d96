//! Writing: files whole or not at all, then standard output; and why there is no answer at all, exit code 2.

use std::fs::{self, OpenOptions};
use std::io::{self, IsTerminal as _, Write as _};
use std::path::{Path, PathBuf};

use palkki::certificate::NotLumped;
use palkki::scene::file::FileError;

use super::input::Input;

/// Why the program ends without an answer.
#[derive(Debug, thiserror::Error)]
pub(super) enum Failure {
    /// Options that do not go together.
    #[error("{message}")]
    Usage {
        /// The subcommand that they were given to.
        command: &'static str,
        kind: clap::error::ErrorKind,
        message: String,
    },
    /// The scene is none, or cannot be solved; the message has its picture.
    #[error("{0}")]
    File(#[from] Box<FileError>),
    /// Contact forces that do not belong to nodal loads.
    #[error("{path:?} does not go with --load nodal: {error}")]
    NotLumped {
        /// The file of the forces.
        path: PathBuf,
        error: NotLumped,
    },
    /// Theory has no solution for this scene.
    #[error("beam theory has no answer for this scene: {0}; choose another --method")]
    NoTheory(#[from] palkki::theory::TheoryError),
    /// The figure could not be drawn.
    #[error("cannot draw this answer: {0}")]
    Plot(#[from] palkki::plot::PlotError),
    /// A place to which no file can be written.
    #[error("cannot write {path:?}: {problem}")]
    NoPlace {
        /// The place.
        path: PathBuf,
        problem: PlaceProblem,
    },
    /// The operating system refused to write.
    #[error("cannot write {path:?}: {error}")]
    Write {
        /// The file.
        path: PathBuf,
        error: io::Error,
    },
    /// Standard output failed, and not because its reader had enough.
    #[error("cannot print the answer: {0}")]
    Print(io::Error),
}

/// What is wrong with a place to write to.
#[derive(Debug, Clone, Copy, thiserror::Error)]
pub(super) enum PlaceProblem {
    #[error("there is no such directory")]
    NoDirectory,
    #[error("it is not a regular file")]
    NotAFile,
    #[error("it is the scene itself, or its survey")]
    TheInput,
    #[error("it is named twice")]
    Twice,
    #[error("it is not the name of a file")]
    NoName,
}

/// Files that are written beside their places first, and moved there when all of them are complete.
///
/// Whatever has not been moved when this is dropped is removed again.
#[derive(Debug, Default)]
pub(super) struct Files {
    places: Vec<PathBuf>,
    staged: Vec<Staged>,
}

#[derive(Debug)]
struct Staged {
    temporary: PathBuf,
    place: PathBuf,
}

impl Files {
    /// Checks that a file can be put at `path`, as far as that can be told before.
    pub(super) fn reserve(&mut self, path: &Path, input: &Input) -> Result<(), Failure> {
        let place = place(path)?;
        let not = |problem| Err(Failure::NoPlace { path: path.to_owned(), problem });
        if input.files.iter().any(|file| fs::canonicalize(file).is_ok_and(|file| file == place)) {
            return not(PlaceProblem::TheInput);
        }
        if self.places.contains(&place) {
            return not(PlaceProblem::Twice);
        }
        self.places.push(place);
        Ok(())
    }

    /// Writes `text` beside `path`.
    pub(super) fn stage(&mut self, path: &Path, text: &str) -> Result<(), Failure> {
        let failed = |error| Failure::Write { path: path.to_owned(), error };
        let place = place(path)?;
        let mut name = std::ffi::OsString::from(".");
        name.push(place.file_name().unwrap_or_default());
        name.push(format!(".{}.tmp", std::process::id()));
        let temporary = place.with_file_name(name);
        let mut file = OpenOptions::new().write(true).create_new(true).open(&temporary).map_err(failed)?;
        self.staged.push(Staged { temporary, place });
        file.write_all(text.as_bytes()).and_then(|()| file.sync_all()).map_err(failed)
    }

    /// Moves all files to their places.
    pub(super) fn publish(mut self) -> Result<(), Failure> {
        while let Some(file) = self.staged.last() {
            fs::rename(&file.temporary, &file.place)
                .map_err(|error| Failure::Write { path: file.place.clone(), error })?;
            self.staged.pop();
        }
        Ok(())
    }
}

impl Drop for Files {
    fn drop(&mut self) {
        for file in &self.staged {
            // If it cannot be removed either, the message about why it was not moved is the one to give.
            let _ = fs::remove_file(&file.temporary);
        }
    }
}

/// Where a file at `path` is in truth: moving something there must not replace a link, and still less a device.
fn place(path: &Path) -> Result<PathBuf, Failure> {
    let not = |problem| Failure::NoPlace { path: path.to_owned(), problem };
    match fs::metadata(path) {
        Ok(there) if there.is_file() => {
            fs::canonicalize(path).map_err(|error| Failure::Write { path: path.to_owned(), error })
        }
        Ok(_) => Err(not(PlaceProblem::NotAFile)),
        Err(_) => {
            let name = path.file_name().ok_or_else(|| not(PlaceProblem::NoName))?;
            let folder = match path.parent() {
                Some(folder) if folder != Path::new("") => folder,
                _ => Path::new("."),
            };
            let folder = fs::canonicalize(folder).map_err(|_| not(PlaceProblem::NoDirectory))?;
            if folder.is_dir() { Ok(folder.join(name)) } else { Err(not(PlaceProblem::NoDirectory)) }
        }
    }
}

/// Prints the answer. A reader that has seen enough and closed the pipe is no failure.
pub(super) fn print(text: &str) -> Result<(), Failure> {
    let mut out = io::stdout().lock();
    match out.write_all(text.as_bytes()).and_then(|()| out.flush()) {
        Err(error) if error.kind() != io::ErrorKind::BrokenPipe => Err(Failure::Print(error)),
        _ => Ok(()),
    }
}

/// Says on standard error why there is no answer.
pub(super) fn complain(failure: &Failure) {
    let mut err = io::stderr().lock();
    let colour = err.is_terminal() && std::env::var_os("NO_COLOR").is_none_or(|value| value.is_empty());
    let message = match failure {
        Failure::File(error) => error.render(colour),
        failure => format!("error: {failure}"),
    };
    // Nobody is left to tell if this does not reach anybody.
    let _ = writeln!(err, "{message}");
}
