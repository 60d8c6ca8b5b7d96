//! Input: a scene file, the files that it names, and files named as arguments.

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

/// Bytes of the largest survey or file of contact forces that is read: ten million rows with all their digits.
const LARGEST_TABLE: u64 = 512 * 1024 * 1024;

/// Bytes of the largest scene file that is read. Its document needs some fifty times its size in memory. A foundation with more
/// points can be given as a survey.
const LARGEST_SCENE: u64 = 16 * 1024 * 1024;

/// Bytes of the largest matrix that is read. The largest matrix that is factorised needs some 1.2 GB for both triangles, with
/// positions and all digits.
const LARGEST_MATRIX: u64 = 2 * 1024 * 1024 * 1024;

/// Bytes of the longest line of a matrix: the format allows 1024 characters.
const LONGEST_LINE: u64 = 4096;

/// A scene, by default of a beam, with the files from which it was read.
#[derive(Debug)]
pub(super) struct Input<M = Scene> {
    /// The name of the scene file in messages.
    pub(super) name: String,
    title: String,
    units: Units,
    /// The scene.
    pub(super) scene: M,
    /// The files that were read.
    pub(super) files: Vec<PathBuf>,
    /// The number format of the answer in text.
    results: Results,
    /// Warnings about the scene that do not prevent an answer.
    warnings: Vec<String>,
}

/// The allowed positions of point loads.
#[derive(Debug, Clone, Copy)]
pub(super) enum Loads {
    OnBeam,
    /// Also beyond the beam, for a sweep.
    Anywhere,
}

/// The content of a scene file.
#[derive(Debug)]
pub(super) enum Read {
    Beam(Box<Input>),
    Body(Box<Input<Body>>),
}

impl Read {
    /// Reads the scene file `path` or standard input. Files that it names are relative to its folder, or to the working directory.
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
                let signs = scene.doubtful_signs();
                let far = scene.far_depths();
                let warnings =
                    far.iter().map(ToString::to_string).chain(signs.iter().map(ToString::to_string)).collect();
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

/// The files that a scene file names.
struct BesideScene<'a> {
    path: &'a Path,
    files: Vec<PathBuf>,
    /// Names, as in messages, of the files whose text a message may repeat: the scene file, and files in its folder. Otherwise,
    /// whoever submits a scene to be solved could read any file through the messages.
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

    /// The error without text that must not be shown.
    fn shown(&self, error: Box<FileError>) -> Box<FileError> {
        if self.shown.contains(&error.file) { error } else { Box::new(error.without_text()) }
    }
}

/// Whether a file is in the folder of a scene or below it, after all links are followed.
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
            // One more byte shows that the line is too long.
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
    /// Unit labels and number format of this scene in text.
    pub(super) fn labels(&self) -> Labels {
        Labels::of(&self.units, self.results)
    }

    /// Warnings about the scene that do not prevent an answer.
    pub(super) fn warnings(&self) -> &[String] {
        &self.warnings
    }

    /// The warnings as lines of text, followed by a blank line; empty if there are none.
    pub(super) fn warning_lines(&self) -> String {
        warning_lines(&self.warnings)
    }

    /// The title of the scene, or the name of its file if it has no title.
    pub(super) fn title(&self) -> &str {
        if self.title.is_empty() { &self.name } else { &self.title }
    }
}

impl Input<Body> {
    /// Reads an answer from another program for this body.
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

    /// A scene error that was found only when the scene was solved.
    pub(super) fn error(&self, error: SceneError) -> Failure {
        Failure::File(Box::new(FileError::whole(&self.name, Problem::Scene { error, quantity: None })))
    }
}

/// Whether an argument stands for standard input.
pub(super) fn is_standard(argument: &Path) -> bool {
    argument == Path::new("-")
}

/// The name of a file argument in messages.
pub(super) fn called(argument: &Path) -> String {
    if is_standard(argument) { "standard input".to_owned() } else { argument.display().to_string() }
}

/// The text of an argument: of a file or of standard input.
fn read_argument(argument: &Path, largest: u64) -> Result<String, ReadProblem> {
    if is_standard(argument) { text_of(io::stdin().lock(), largest) } else { read(argument, largest) }
}

/// The reason why reading failed.
fn refused(error: &io::Error) -> ReadProblem {
    match error.kind() {
        io::ErrorKind::NotFound => ReadProblem::Missing,
        io::ErrorKind::IsADirectory => ReadProblem::Directory,
        kind => ReadProblem::Refused { reason: kind.to_string() },
    }
}

/// The text of an argument of at most `largest` bytes. It may be a pipe of the shell or a device.
fn read(path: &Path, largest: u64) -> Result<String, ReadProblem> {
    // Opening a named pipe would wait until somebody writes.
    if is_named_pipe(path) {
        return Err(ReadProblem::NamedPipe);
    }
    let file = File::open(path).map_err(|error| refused(&error))?;
    let there = file.metadata().map_err(|error| refused(&error))?;
    of_size(&there, largest)?;
    text_of(file, largest)
}

/// Opens a file that a scene names: a regular file of at most `largest` bytes. Opening anything else may wait or have side effects.
fn open_regular(path: &Path, largest: u64) -> Result<File, ReadProblem> {
    regular(&fs::metadata(path).map_err(|error| refused(&error))?, largest)?;
    let file = File::open(path).map_err(|error| refused(&error))?;
    // Checked again, because it may be another file by now.
    regular(&file.metadata().map_err(|error| refused(&error))?, largest)?;
    Ok(file)
}

fn regular(there: &Metadata, largest: u64) -> Result<(), ReadProblem> {
    of_size(there, largest)?;
    if there.is_file() { Ok(()) } else { Err(ReadProblem::NotRegular) }
}

/// Checks the size before half a gigabyte is read in vain.
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
    // One more byte shows that the stream is too long. The size that a file reports is not reliable: a device reports none.
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

/// Whether a path is a pipe with its own name. Standard input and pipes of a shell have none; they have writers.
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
