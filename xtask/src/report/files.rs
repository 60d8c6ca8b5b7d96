//! The report on disk: comparing, and writing each file whole or not at all.

use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use palkki::verification::{Difference, numdiff, numdiff_svg};

use super::Rendered;
use super::error::Error;

/// The directories whose files are all made by the report.
const MADE: [&str; 2] = ["report/figures", "report/data"];

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
        let outcome = if path.ends_with(".svg") { numdiff_svg(&stored, text) } else { numdiff(&stored, text) };
        if let Err(difference) = outcome {
            stale.push(Stale::Differs { path: path.clone(), difference });
        }
    }
    stale.extend(left_over(root, rendered)?.into_iter().map(|path| Stale::LeftOver { path }));
    Ok(stale)
}

/// Writes what changed and removes what is left over; returns how many files that were.
pub(super) fn write(root: &Path, rendered: &Rendered) -> Result<usize, Error> {
    let mut changes = 0;
    for (path, text) in rendered {
        let path = root.join("report").join(path);
        if read(&path)?.as_ref() != Some(text) {
            replace(&path, text).map_err(|source| Error::File { path, source })?;
            changes += 1;
        }
    }
    for path in left_over(root, rendered)? {
        let path = root.join(path);
        fs::remove_file(&path).map_err(|source| Error::File { path, source })?;
        changes += 1;
    }
    Ok(changes)
}

/// Writes beside the file and renames, so that a reader sees the old text or the new one and never half of it.
fn replace(path: &Path, text: &str) -> io::Result<()> {
    if let Some(directory) = path.parent() {
        fs::create_dir_all(directory)?;
    }
    let beside = PathBuf::from(format!("{}.{}.new", path.display(), std::process::id()));
    let outcome = fs::write(&beside, text).and_then(|()| fs::rename(&beside, path));
    if outcome.is_err() {
        // The reason of the failure is what counts; a half file that cannot be removed shows as left over.
        let _ = fs::remove_file(&beside);
    }
    outcome
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
pub(super) fn list(root: &Path, directory: &str) -> Result<Vec<String>, Error> {
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
