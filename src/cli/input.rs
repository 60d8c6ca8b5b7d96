//! Reading: a scene file and the survey that it may name.

use std::cell::RefCell;
use std::fs::File;
use std::io::{self, Read as _};
use std::path::{Path, PathBuf};

use palkki::scene::file::{FileError, Problem, ReadProblem, parse, parse_forces};
use palkki::scene::{Scene, SceneError};
use palkki::text::Results;

use super::output::Failure;
use super::table::Labels;

/// Bytes of the largest survey, or file of contact forces, that is read: ten million rows with all their digits.
const LARGEST_TABLE: u64 = 512 * 1024 * 1024;

/// Bytes of the largest scene file that is read. Its document takes some fifty times its size in memory; a foundation with more
/// points has room in a survey.
const LARGEST_SCENE: u64 = 16 * 1024 * 1024;

/// A scene with the files that it came from.
#[derive(Debug)]
pub(super) struct Input {
    /// The scene file as messages call it.
    pub(super) name: String,
    /// The scene.
    pub(super) scene: Scene,
    /// The files that were read.
    pub(super) files: Vec<PathBuf>,
    /// How the numbers of its answer are written in text.
    results: Results,
}

impl Input {
    /// Reads the scene file `path`, or standard input; its survey is relative to its folder, or to the working directory.
    pub(super) fn read(path: &Path, results: Results) -> Result<Self, Failure> {
        let name = called(path);
        let text = read_argument(path, LARGEST_SCENE)
            .map_err(|problem| Box::new(FileError::whole(&name, Problem::Unreadable(problem))))?;
        let files = RefCell::new(vec![if is_standard(path) { PathBuf::from("/dev/stdin") } else { path.to_owned() }]);
        let scene = parse(&name, &text, |survey| {
            let survey = path.with_file_name(survey);
            let text = read(&survey, LARGEST_TABLE);
            files.borrow_mut().push(survey);
            text
        })?;
        Ok(Self { name, scene, files: files.into_inner(), results })
    }

    /// Names and numbers of this scene in text.
    pub(super) fn labels(&self) -> Labels {
        Labels::of(self.scene.units(), self.results)
    }

    /// What the scene is called: by its title, or else by its file.
    pub(super) fn title(&self) -> &str {
        if self.scene.title().is_empty() { &self.name } else { self.scene.title() }
    }

    /// Reads contact forces for the beam of this scene.
    pub(super) fn forces(&self, path: &Path) -> Result<Vec<(f64, f64)>, Failure> {
        let name = called(path);
        let text = read_argument(path, LARGEST_TABLE)
            .map_err(|problem| Box::new(FileError::whole(&name, Problem::UnreadableForces(problem))))?;
        Ok(parse_forces(&name, &text, self.scene.beam().length())?)
    }

    /// An error that only showed when the scene was solved.
    pub(super) fn error(&self, error: SceneError) -> Failure {
        Failure::File(Box::new(FileError::whole(&self.name, Problem::Scene { error, quantity: None })))
    }
}

/// Whether an argument stands for standard input.
pub(super) fn is_standard(argument: &Path) -> bool {
    argument == Path::new("-")
}

/// What messages call a file that is an argument.
pub(super) fn called(argument: &Path) -> String {
    if is_standard(argument) { "standard input".to_owned() } else { argument.display().to_string() }
}

/// What an argument names, as text: a file, or standard input.
fn read_argument(argument: &Path, largest: u64) -> Result<String, ReadProblem> {
    if is_standard(argument) { text_of(io::stdin().lock(), largest) } else { read(argument, largest) }
}

/// Why reading failed.
fn refused(error: &io::Error) -> ReadProblem {
    match error.kind() {
        io::ErrorKind::NotFound => ReadProblem::Missing,
        io::ErrorKind::IsADirectory => ReadProblem::Directory,
        kind => ReadProblem::Refused { reason: kind.to_string() },
    }
}

/// A file of at most `largest` bytes as text.
fn read(path: &Path, largest: u64) -> Result<String, ReadProblem> {
    // Opening one would wait until somebody writes.
    if is_named_pipe(path) {
        return Err(ReadProblem::NamedPipe);
    }
    let file = File::open(path).map_err(|error| refused(&error))?;
    if file.metadata().map_err(|error| refused(&error))?.is_dir() {
        return Err(ReadProblem::Directory);
    }
    text_of(file, largest)
}

/// All of a stream of at most `largest` bytes, as text.
fn text_of(stream: impl io::Read, largest: u64) -> Result<String, ReadProblem> {
    let mut bytes = Vec::new();
    // One byte more, to see that there is more. The size that a file claims is no help: a device claims none.
    stream.take(largest + 1).read_to_end(&mut bytes).map_err(|error| refused(&error))?;
    if usize::try_from(largest).is_ok_and(|limit| limit < bytes.len()) {
        return Err(ReadProblem::TooLarge { limit: largest });
    }
    String::from_utf8(bytes).map_err(|error| {
        let (good, _) = error.as_bytes().split_at(error.utf8_error().valid_up_to());
        let good = String::from_utf8_lossy(good);
        let column = good.rsplit('\n').next().map_or(0, |line| line.chars().count()) + 1;
        ReadProblem::NotText { line: good.matches('\n').count() + 1, column }
    })
}

/// True for a pipe with a name of its own; standard input and the pipes of a shell, which have writers, have none.
#[cfg(unix)]
fn is_named_pipe(path: &Path) -> bool {
    use std::os::unix::fs::FileTypeExt as _;
    let named = || std::fs::canonicalize(path).is_ok();
    std::fs::metadata(path).is_ok_and(|there| there.file_type().is_fifo()) && named()
}

#[cfg(not(unix))]
fn is_named_pipe(_: &Path) -> bool {
    false
}
