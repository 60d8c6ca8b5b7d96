//! The report on disk: comparing, and writing all of it or, if anything goes wrong before the last text is there, nothing.

use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use palkki::verification::{Difference, numdiff, numdiff_svg};

use super::Rendered;
use super::error::Error;
use super::html;

/// The directories whose files are all made by the report.
const MADE: [&str; 3] = ["report/figures", "report/data", "report/pages"];

/// A file that is not what it should be.
#[derive(Debug, thiserror::Error)]
pub(crate) enum Stale {
    #[error("missing:   report/{path}")]
    Missing { path: String },
    #[error("stale:     report/{path}, {difference}")]
    Differs { path: String, difference: Difference },
    #[error("left over: {path}")]
    LeftOver { path: String },
}

/// Compares what was rendered with the files.
///
/// Not byte for byte: processors may round the last digit of a computation differently. Texts may differ by one unit of
/// the last printed decimal, drawings also by one pixel; see [`palkki::verification`].
pub(super) fn compare(root: &Path, rendered: &Rendered) -> Result<Vec<Stale>, Error> {
    let mut stale = Vec::new();
    for (path, text) in rendered {
        let Some(stored) = read(&root.join("report").join(path))? else {
            stale.push(Stale::Missing { path: path.clone() });
            continue;
        };
        let drawn = path.ends_with(".svg") || path == html::PATH;
        let outcome = if drawn { numdiff_svg(&stored, text) } else { numdiff(&stored, text) };
        if let Err(difference) = outcome {
            stale.push(Stale::Differs { path: path.clone(), difference });
        }
    }
    stale.extend(left_over(root, rendered)?.into_iter().map(|path| Stale::LeftOver { path }));
    Ok(stale)
}

/// The file that refers to all others, and so is the last to change.
const LAST: &str = "README.md";

/// Writes what changed and removes what is left over; returns how many files that were.
///
/// All texts are written beside their files before the first of them takes its place, so that a run that is interrupted while
/// it writes leaves the old report. What it leaves beside the files is removed by the next one.
pub(super) fn write(root: &Path, rendered: &Rendered) -> Result<usize, Error> {
    let mut changes = put(root, rendered)?;
    for path in left_over(root, rendered)? {
        let path = root.join(path);
        fs::remove_file(&path).map_err(|source| Error::File { path, source })?;
        changes += 1;
    }
    Ok(changes)
}

/// Writes what changed; returns how many files that were.
pub(super) fn put(root: &Path, rendered: &Rendered) -> Result<usize, Error> {
    let mut staged = Staged::default();
    let (last, others): (Vec<_>, Vec<_>) = rendered.iter().partition(|(path, _)| *path == LAST);
    for (path, text) in others.into_iter().chain(last) {
        let path = root.join("report").join(path);
        if read(&path)?.as_ref() != Some(text) {
            staged.add(&path, text).map_err(|source| Error::File { path, source })?;
        }
    }
    staged.publish()
}

/// Files that are written and have not taken their places yet: `(beside, place)`. Dropped, they are removed.
#[derive(Debug, Default)]
struct Staged(Vec<(PathBuf, PathBuf)>);

impl Staged {
    fn add(&mut self, path: &Path, text: &str) -> io::Result<()> {
        if let Some(directory) = path.parent() {
            fs::create_dir_all(directory)?;
        }
        let beside = PathBuf::from(format!("{}.{}.new", path.display(), std::process::id()));
        self.0.push((beside.clone(), path.to_owned()));
        fs::write(&beside, text)
    }

    /// Renames, so that a reader of any file sees its old text or its new one and never half of it.
    fn publish(mut self) -> Result<usize, Error> {
        let changes = self.0.len();
        for (beside, path) in self.0.drain(..) {
            fs::rename(&beside, &path).map_err(|source| Error::File { path, source })?;
        }
        Ok(changes)
    }
}

impl Drop for Staged {
    fn drop(&mut self) {
        for (beside, _) in &self.0 {
            // The reason of the failure is what counts; a half file that cannot be removed shows as left over.
            let _ = fs::remove_file(beside);
        }
    }
}

/// The text of a file, `None` if there is none. What is not UTF-8 is not ours either, and reads as something else.
fn read(path: &Path) -> Result<Option<String>, Error> {
    match fs::read(path) {
        Ok(bytes) => Ok(Some(String::from_utf8_lossy(&bytes).into_owned())),
        Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(None),
        Err(source) => Err(Error::File { path: path.to_owned(), source }),
    }
}

/// Files in the directories of the report that it does not make, relative to the root.
fn left_over(root: &Path, rendered: &Rendered) -> Result<Vec<String>, Error> {
    let mut found = Vec::new();
    for directory in MADE {
        let is_made = |path: &str| path.strip_prefix("report/").is_some_and(|path| rendered.contains_key(path));
        found.extend(list(root, directory)?.into_iter().filter(|path| !is_made(path)));
    }
    Ok(found)
}

/// All files below a directory, relative to the root, with `/`, in order; none if there is no such directory.
pub(crate) fn list(root: &Path, directory: &str) -> Result<Vec<String>, Error> {
    let place = root.join(directory);
    let failed = |source| Error::File { path: place.clone(), source };
    let entries = match fs::read_dir(&place) {
        Ok(entries) => entries,
        Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok(Vec::new()),
        Err(source) => return Err(failed(source)),
    };
    let mut found = Vec::new();
    for entry in entries {
        let entry = entry.map_err(failed)?;
        let path = format!("{directory}/{}", entry.file_name().to_string_lossy());
        if entry.file_type().map_err(failed)?.is_dir() {
            found.extend(list(root, &path)?);
        } else {
            found.push(path);
        }
    }
    found.sort();
    Ok(found)
}
