//! Reading: a scene file, the files that it names, and files of arguments.

use std::fs::{self, File, Metadata};
use std::io::{self, BufRead as _, BufReader, Read as _};
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};

use palkki::body::Body;
use palkki::body::proof::Brought;
use palkki::scene::file::{
    Beside, FileError, Model, Problem, ReadProblem, parse_answers, parse_forces, parse_model, parse_train,
};
use palkki::scene::{Scene, SceneError, Units};
use palkki::text::Results;

use super::output::Failure;
use super::table::Labels;
use super::text::warning_lines;

/// Bytes of the largest survey, or file of contact forces, that is read: ten million rows with all their digits.
const LARGEST_TABLE: u64 = 512 * 1024 * 1024;

/// Bytes of the largest scene file that is read. Its document takes some fifty times its size in memory; a foundation with more
/// points has room in a survey.
const LARGEST_SCENE: u64 = 16 * 1024 * 1024;

/// Bytes of the largest matrix that is read: twice the numbers of the largest one that is factorised, for both triangles, with places
/// and all digits, are some 1.2 GB.
const LARGEST_MATRIX: u64 = 2 * 1024 * 1024 * 1024;

/// Bytes of the longest line of a matrix: the format allows 1024 characters.
const LONGEST_LINE: u64 = 4096;

/// A scene, of a beam if nothing else is said, with the files that it came from.
#[derive(Debug)]
pub(super) struct Input<M = Scene> {
    /// The scene file as messages call it.
    pub(super) name: String,
    title: String,
    units: Units,
    /// The scene.
    pub(super) scene: M,
    /// The files that were read.
    pub(super) files: Vec<PathBuf>,
    /// How the numbers of its answer are written in text.
    results: Results,
    /// What may be wrong with the scene, though it has an answer.
    warnings: Vec<String>,
}

/// Where the point loads of a scene may be.
#[derive(Debug, Clone, Copy)]
pub(super) enum Loads {
    OnBeam,
    /// Also beyond the beam, for a sweep.
    Anywhere,
}

/// What a scene file turns out to be.
#[derive(Debug)]
pub(super) enum Read {
    Beam(Box<Input>),
    Body(Box<Input<Body>>),
}

impl Read {
    /// Reads the scene file `path`, or standard input; what it names is relative to its folder, or to the working directory.
    pub(super) fn scene(path: &Path, results: Results, loads: Loads) -> Result<Self, Failure> {
        let name = called(path);
        let text = read_argument(path, LARGEST_SCENE)
            .map_err(|problem| Box::new(FileError::whole(&name, Problem::Unreadable(problem))))?;
        let first = if is_standard(path) { PathBuf::from("/dev/stdin") } else { path.to_owned() };
        let mut beside = BesideScene { path, files: vec![first], shown: vec![name.clone()] };
        let parse = match loads {
            Loads::OnBeam => parse_model,
            Loads::Anywhere => parse_train,
        };
        let model = parse(&name, &text, &mut beside).map_err(|error| beside.shown(error))?;
        let files = beside.files;
        Ok(match model {
            Model::Scene(scene) => {
                let (title, units) = (scene.title().to_owned(), scene.units().clone());
                let warnings = scene.far_depths().iter().map(ToString::to_string).collect();
                Self::Beam(Box::new(Input { name, title, units, scene, files, results, warnings }))
            }
            Model::Body(scene) => {
                let (title, units) = (scene.title.clone(), scene.units.clone());
                Self::Body(Box::new(Input { name, title, units, scene: *scene, files, results, warnings: Vec::new() }))
            }
        })
    }

    /// The files that were read.
    pub(super) fn files(&self) -> &[PathBuf] {
        match self {
            Self::Beam(input) => &input.files,
            Self::Body(input) => &input.files,
        }
    }
}

/// Files beside a scene file.
struct BesideScene<'a> {
    path: &'a Path,
    files: Vec<PathBuf>,
    /// Files whose text a message may repeat, as messages call them: the scene, and what lies in its folder. Whoever sends a scene to be
    /// solved could otherwise read any file in the messages.
    shown: Vec<String>,
}

impl BesideScene<'_> {
    fn file(&mut self, name: &str) -> PathBuf {
        let file = self.path.with_file_name(name);
        if is_within(&file, self.path) {
            self.shown.push(file.display().to_string());
        }
        self.files.push(file.clone());
        file
    }

    /// The error as it may be shown.
    fn shown(&self, error: Box<FileError>) -> Box<FileError> {
        if self.shown.contains(&error.file) { error } else { Box::new(error.without_text()) }
    }
}

/// Whether a file lies in the folder of a scene, or below it, when all links are followed.
fn is_within(file: &Path, scene: &Path) -> bool {
    let folder = scene.parent().filter(|folder| *folder != Path::new("")).unwrap_or(Path::new("."));
    let whole = fs::canonicalize(folder).and_then(|folder| Ok((folder, fs::canonicalize(file)?)));
    whole.is_ok_and(|(folder, file)| file.starts_with(folder))
}

impl Beside for BesideScene<'_> {
    fn text(&mut self, name: &str) -> Result<String, ReadProblem> {
        text_of(open_regular(&self.file(name), LARGEST_TABLE)?, LARGEST_TABLE)
    }

    fn lines(&mut self, name: &str, each: &mut dyn FnMut(&str) -> ControlFlow<()>) -> Result<(), ReadProblem> {
        let mut stream = BufReader::new(open_regular(&self.file(name), LARGEST_MATRIX)?.take(LARGEST_MATRIX));
        let mut bytes = Vec::new();
        for number in 1.. {
            bytes.clear();
            // One byte more, to see that there is more.
            let taken = stream.by_ref().take(LONGEST_LINE + 1).read_until(b'\n', &mut bytes);
            if taken.map_err(|error| refused(&error))? == 0 {
                break;
            }
            if usize::try_from(LONGEST_LINE).is_ok_and(|limit| limit < bytes.len()) {
                return Err(ReadProblem::LongLine { line: number, limit: LONGEST_LINE });
            }
            let line = str::from_utf8(&bytes).map_err(|error| {
                let good = String::from_utf8_lossy(&bytes[..error.valid_up_to()]);
                ReadProblem::NotText { line: number, column: good.chars().count() + 1 }
            })?;
            if each(line.trim_end_matches(['\n', '\r'])).is_break() {
                break;
            }
        }
        Ok(())
    }
}

impl<M> Input<M> {
    /// Names and numbers of this scene in text.
    pub(super) fn labels(&self) -> Labels {
        Labels::of(&self.units, self.results)
    }

    /// What may be wrong with the scene, though it has an answer.
    pub(super) fn warnings(&self) -> &[String] {
        &self.warnings
    }

    /// The same as lines for a person, with a blank line behind them; empty if there are none.
    pub(super) fn warning_lines(&self) -> String {
        warning_lines(&self.warnings)
    }

    /// What the scene is called: by its title, or else by its file.
    pub(super) fn title(&self) -> &str {
        if self.title.is_empty() { &self.name } else { &self.title }
    }
}

impl Input<Body> {
    /// Reads what a program brought for this body.
    pub(super) fn answers(&self, path: &Path) -> Result<Brought, Failure> {
        let name = called(path);
        let text = read_argument(path, LARGEST_TABLE)
            .map_err(|problem| Box::new(FileError::whole(&name, Problem::UnreadableForces(problem))))?;
        Ok(parse_answers(&name, &text, &self.scene)?)
    }
}

impl Input {
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

/// An argument of at most `largest` bytes as text. A pipe of the shell or a device may be what its user means.
fn read(path: &Path, largest: u64) -> Result<String, ReadProblem> {
    // Opening one would wait until somebody writes.
    if is_named_pipe(path) {
        return Err(ReadProblem::NamedPipe);
    }
    let file = File::open(path).map_err(|error| refused(&error))?;
    let there = file.metadata().map_err(|error| refused(&error))?;
    of_size(&there, largest)?;
    text_of(file, largest)
}

/// A file that a scene names: a regular one of at most `largest` bytes. Opening anything else may wait, or do something.
fn open_regular(path: &Path, largest: u64) -> Result<File, ReadProblem> {
    regular(&fs::metadata(path).map_err(|error| refused(&error))?, largest)?;
    let file = File::open(path).map_err(|error| refused(&error))?;
    // Again, as it may be another one by now.
    regular(&file.metadata().map_err(|error| refused(&error))?, largest)?;
    Ok(file)
}

fn regular(there: &Metadata, largest: u64) -> Result<(), ReadProblem> {
    of_size(there, largest)?;
    if there.is_file() { Ok(()) } else { Err(ReadProblem::NotRegular) }
}

/// Before half a gigabyte is read in vain.
fn of_size(there: &Metadata, largest: u64) -> Result<(), ReadProblem> {
    match there {
        there if there.is_dir() => Err(ReadProblem::Directory),
        there if largest < there.len() => Err(ReadProblem::TooLarge { limit: largest }),
        _ => Ok(()),
    }
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
    let named = || fs::canonicalize(path).is_ok();
    fs::metadata(path).is_ok_and(|there| there.file_type().is_fifo()) && named()
}

#[cfg(not(unix))]
fn is_named_pipe(_: &Path) -> bool {
    false
}
