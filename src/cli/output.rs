//! Standard output and standard error, and the reasons why there is no answer (exit code 2).

use std::io::{self, Write as _};
use std::path::PathBuf;

use anstream::{AutoStream, ColorChoice};
use clap::builder::styling::AnsiColor;
use palkki::certificate::NotLumped;
use palkki::route::Status;
use palkki::scene::file::FileError;

/// The reason why the program ends without an answer.
#[derive(Debug, thiserror::Error)]
pub(super) enum Failure {
    /// Options that cannot be combined.
    #[error("{message}")]
    Usage {
        /// The subcommand with these options.
        command: &'static str,
        kind: clap::error::ErrorKind,
        message: String,
    },
    /// The scene file is invalid or the scene cannot be solved; the message shows the place in the file.
    #[error("{0}")]
    File(#[from] Box<FileError>),
    /// Contact forces that do not fit nodal loads.
    #[error("{path:?} does not go with --load nodal: {error}")]
    NotLumped {
        /// The file of the forces.
        path: PathBuf,
        error: NotLumped,
    },
    /// Theory has no solution for this scene.
    #[error("beam theory has no answer for this scene: {0}; choose another --method")]
    NoTheory(#[from] palkki::theory::TheoryError),
    /// The sweep is not possible, or one of its values has no answer.
    #[error(transparent)]
    Sweep(#[from] palkki::sweep::SweepError),
    /// The figure could not be drawn.
    #[error("cannot draw this answer: {0}")]
    Plot(#[from] palkki::plot::PlotError),
    /// The answer has no proof in rational arithmetic.
    #[error("no proof of this answer: {0}")]
    Unproven(#[from] palkki::proof::Unproven),
    /// A path to which no file can be written.
    #[error("cannot write {path:?}: {problem}")]
    NoPlace {
        /// The path.
        path: PathBuf,
        problem: PlaceProblem,
    },
    /// The operating system could not write the file.
    #[error("cannot write {path:?}: {error}")]
    Write {
        /// The file.
        path: PathBuf,
        error: io::Error,
    },
    /// Standard output, or standard error in its place, failed.
    #[error("cannot print the answer: {0}")]
    Print(io::Error),
}

impl Failure {
    /// An error for options that a command does not accept together, or not for this scene.
    pub(super) fn refused(command: &'static str, message: impl Into<String>) -> Self {
        Self::Usage { command, kind: clap::error::ErrorKind::ArgumentConflict, message: message.into() }
    }
}

/// The reason why a path cannot be written.
#[derive(Debug, Clone, Copy, thiserror::Error)]
pub(super) enum PlaceProblem {
    #[error("there is no such directory")]
    NoDirectory,
    #[error("it is a directory")]
    Directory,
    #[error("it is the scene itself, or its survey")]
    TheInput,
    #[error("it is named twice")]
    Twice,
    #[error("it is not the name of a file")]
    NoName,
    #[error("it is a link that leads to itself")]
    Circle,
}

/// The two output streams of the program.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Stream {
    Output,
    Error,
}

/// Prints an answer, or a file that goes to a stream.
pub(super) fn print(stream: Stream, text: &str) -> Result<(), Failure> {
    let written = match stream {
        Stream::Output => unchecked(&io::stdout()).and_then(|mut file| write(&mut file, text)),
        Stream::Error => unchecked(&io::stderr()).and_then(|mut file| write(&mut file, text)),
    };
    written.map_err(Failure::Print)
}

/// Checks whether standard output can be written at all.
pub(super) fn can_be_written() -> io::Result<()> {
    unless_closed(unchecked(&io::stdout())?.write(&[]).map(|_| ()))
}

/// A stream as a file. The standard library treats a stream that cannot be written like one that nobody reads. The answer would be
/// lost with exit code 0.
#[cfg(unix)]
fn unchecked(stream: &impl std::os::fd::AsFd) -> io::Result<std::fs::File> {
    stream.as_fd().try_clone_to_owned().map(std::fs::File::from)
}

#[cfg(windows)]
fn unchecked(stream: &impl std::os::windows::io::AsHandle) -> io::Result<std::fs::File> {
    stream.as_handle().try_clone_to_owned().map(std::fs::File::from)
}

/// Prints an answer as text. On a terminal with colours, its status is coloured.
pub(super) fn print_coloured(stream: Stream, text: &str) -> Result<(), Failure> {
    let choice = match stream {
        Stream::Output => AutoStream::choice(&io::stdout()),
        Stream::Error => AutoStream::choice(&io::stderr()),
    };
    if choice == ColorChoice::Never { print(stream, text) } else { print(stream, &coloured(text)) }
}

/// The text with each status in its colour: at the start, and in table cells, which two spaces separate.
fn coloured(text: &str) -> String {
    let words = Status::ALL.map(|status| {
        let colour = if status == Status::Certified { AnsiColor::Green } else { AnsiColor::Red };
        let style = colour.on_default().bold();
        (status.name(), format!("{style}{status}{style:#}"))
    });
    let mut painted = String::with_capacity(text.len());
    for (i, line) in text.split_inclusive('\n').enumerate() {
        let found = words.iter().find_map(|(word, shown)| {
            let at = if i == 0 { 0 } else { line.find(&format!("  {word}  "))? + 2 };
            let rest = line[at..].strip_prefix(word)?;
            Some([&line[..at], shown, rest].concat())
        });
        painted += found.as_deref().unwrap_or(line);
    }
    painted
}

/// Writes a whole text. It is not a failure if the reader has read enough and closes the pipe, as `head` does.
pub(super) fn write(stream: &mut impl io::Write, text: &str) -> io::Result<()> {
    unless_closed(stream.write_all(text.as_bytes()).and_then(|()| stream.flush()))
}

/// The result of writing, with success if the reader closed the pipe.
pub(super) fn unless_closed(written: io::Result<()>) -> io::Result<()> {
    written.or_else(|error| if error.kind() == io::ErrorKind::BrokenPipe { Ok(()) } else { Err(error) })
}

/// Prints on standard error why there is no answer.
pub(super) fn complain(failure: &Failure) {
    let mut err = io::stderr().lock();
    // As in the messages of clap, the terminal, TERM=dumb, NO_COLOR and CLICOLOR_FORCE decide.
    let colour = AutoStream::choice(&err) != ColorChoice::Never;
    let message = match failure {
        Failure::File(error) => error.render(colour),
        failure => format!("error: {failure}"),
    };
    // An error on standard error cannot be reported.
    let _ = writeln!(err, "{message}");
}
