//! Why there is no answer at all: exit code 2.

use std::io;
use std::path::PathBuf;

use palkki::certificate::bounds::NotLumped;
use palkki::scene::file::FileError;

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
