//! Standard output and standard error; and why there is no answer at all, exit code 2.

use std::io::{self, Write as _};
use std::path::PathBuf;

use anstream::{AutoStream, ColorChoice};
use clap::builder::styling::AnsiColor;
use palkki::certificate::NotLumped;
use palkki::route::Status;
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
    /// There is no such sweep, or a value of it has no answer.
    #[error(transparent)]
    Sweep(#[from] palkki::sweep::SweepError),
    /// The figure could not be drawn.
    #[error("cannot draw this answer: {0}")]
    Plot(#[from] palkki::plot::PlotError),
    /// There is no proof of the answer in fractions.
    #[error("no proof of this answer: {0}")]
    Unproven(#[from] palkki::proof::Unproven),
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
    /// Standard output, or standard error in its place, failed.
    #[error("cannot print the answer: {0}")]
    Print(io::Error),
}

impl Failure {
    /// Of options that a command does not take together, or not for such a scene.
    pub(super) fn refused(command: &'static str, message: impl Into<String>) -> Self {
        Self::Usage { command, kind: clap::error::ErrorKind::ArgumentConflict, message: message.into() }
    }
}

/// What is wrong with a place to write to.
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

/// The two streams that a program has to write to.
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

/// Whether standard output can be written to at all.
pub(super) fn can_be_written() -> io::Result<()> {
    unless_closed(unchecked(&io::stdout())?.write(&[]).map(|_| ()))
}

/// A stream as a file: the stream of the standard library takes one that cannot be written to for one that nobody wants to read, and
/// the answer would be lost with exit code 0.
#[cfg(unix)]
fn unchecked(stream: &impl std::os::fd::AsFd) -> io::Result<std::fs::File> {
    stream.as_fd().try_clone_to_owned().map(std::fs::File::from)
}

#[cfg(windows)]
fn unchecked(stream: &impl std::os::windows::io::AsHandle) -> io::Result<std::fs::File> {
    stream.as_handle().try_clone_to_owned().map(std::fs::File::from)
}

/// Prints an answer for a person: on a terminal that has colours, what it is worth is coloured.
pub(super) fn print_coloured(stream: Stream, text: &str) -> Result<(), Failure> {
    let choice = match stream {
        Stream::Output => AutoStream::choice(&io::stdout()),
        Stream::Error => AutoStream::choice(&io::stderr()),
    };
    if choice == ColorChoice::Never { print(stream, text) } else { print(stream, &coloured(text)) }
}

/// The text with each status in its colour: at the start, and in cells of tables, which two blanks part.
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

/// Writes a whole text; a reader that has read enough and closed the pipe, as `head` does, is no failure.
pub(super) fn write(stream: &mut impl io::Write, text: &str) -> io::Result<()> {
    unless_closed(stream.write_all(text.as_bytes()).and_then(|()| stream.flush()))
}

/// The result of writing, with success where a reader closed the pipe.
pub(super) fn unless_closed(written: io::Result<()>) -> io::Result<()> {
    written.or_else(|error| if error.kind() == io::ErrorKind::BrokenPipe { Ok(()) } else { Err(error) })
}

/// Prints on standard error why there is no answer.
pub(super) fn complain(failure: &Failure) {
    let mut err = io::stderr().lock();
    // As in the messages of clap: whether it is a terminal, TERM=dumb, NO_COLOR and CLICOLOR_FORCE decide.
    let colour = AutoStream::choice(&err) != ColorChoice::Never;
    let message = match failure {
        Failure::File(error) => error.render(colour),
        failure => format!("error: {failure}"),
    };
    // An error of standard error cannot be reported.
    let _ = writeln!(err, "{message}");
}
