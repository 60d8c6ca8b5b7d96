//! The report on disk: comparing, and writing all of it or, if anything goes wrong before the last text is there, nothing.

use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use palkki_evidence::numdiff::{numdiff, numdiff_svg};

use super::{Rendered, html};
use crate::Cause;

/// The directories whose files are all made by the report.
const MADE: [&str; 3] = ["report/figures", "report/data", "report/pages"];

/// Compares what was rendered with the files: what is missing, stale, or left over.
///
/// Not byte for byte: processors may round the last digit of a computation differently. Texts may differ by one unit of
/// the last printed decimal, drawings also by one pixel; see [`palkki_evidence::numdiff`].
pub(super) fn compare(root: &Path, rendered: &Rendered) -> Result<Vec<String>, Cause> {
    let mut wrong = Vec::new();
    for (path, text) in rendered {
        let Some(stored) = read(&root.join("report").join(path))? else {
            // The page is no part of the repository: whoever wants it makes it.
            if path != html::PATH {
                wrong.push(format!("missing:   report/{path}"));
            }
            continue;
        };
        let drawn = path.ends_with(".svg") || path == html::PATH;
        let outcome = if drawn { numdiff_svg(&stored, text) } else { numdiff(&stored, text) };
        if let Err(difference) = outcome {
            wrong.push(format!("stale:     report/{path}, {difference}"));
        }
    }
    wrong.extend(left_over(root, rendered)?.into_iter().map(|path| format!("left over: {path}")));
    Ok(wrong)
}

/// The file that refers to all others, and so is the last to change.
const LAST: &str = "README.md";

/// Writes what changed and removes what is left over; returns how many files that were.
///
/// All texts are there before the first of them is written, and each takes the place of its file at once.
pub(super) fn write(root: &Path, rendered: &Rendered) -> Result<usize, Cause> {
    let mut changes = put(root, rendered)?;
    for path in left_over(root, rendered)? {
        let path = root.join(path);
        fs::remove_file(&path).map_err(|error| at(&path, &error))?;
        changes += 1;
    }
    Ok(changes)
}

/// Writes what changed; returns how many files that were.
pub(super) fn put(root: &Path, rendered: &Rendered) -> Result<usize, Cause> {
    let mut changes = 0;
    let (last, others): (Vec<_>, Vec<_>) = rendered.iter().partition(|(path, _)| *path == LAST);
    for (path, text) in others.into_iter().chain(last) {
        let path = root.join("report").join(path);
        if read(&path)?.as_ref() != Some(text) {
            replace(&path, text).map_err(|error| at(&path, &error))?;
            changes += 1;
        }
    }
    Ok(changes)
}

/// Writes a file beside its place and renames it, which the system does at once or not at all: who reads it, or stops the
/// program, finds the old text or the new one and never half of it.
pub(crate) fn replace(path: &Path, text: &str) -> io::Result<()> {
    if let Some(directory) = path.parent() {
        fs::create_dir_all(directory)?;
    }
    let beside = PathBuf::from(format!("{}.new", path.display()));
    fs::write(&beside, text).and_then(|()| fs::rename(&beside, path))
}

/// What went wrong, and at which file.
fn at(path: &Path, error: &io::Error) -> Cause {
    format!("{}: {error}", path.display()).into()
}

/// The text of a file that has to be there.
pub(super) fn text(root: &Path, path: &str) -> Result<String, Cause> {
    let path = root.join(path);
    fs::read_to_string(&path).map_err(|error| at(&path, &error))
}

/// The texts of some kinds of files below some directories, by their paths relative to the root.
pub(super) fn texts(root: &Path, directories: &[&str], kinds: &[&str]) -> Result<Vec<(String, String)>, Cause> {
    let mut found = Vec::new();
    for directory in directories {
        for path in list(root, directory)? {
            if kinds.iter().any(|kind| path.ends_with(kind)) {
                let text = text(root, &path)?;
                found.push((path, text));
            }
        }
    }
    Ok(found)
}

/// The text of a file, `None` if there is none. What is not UTF-8 is not ours either, and reads as something else.
fn read(path: &Path) -> Result<Option<String>, Cause> {
    match fs::read(path) {
        Ok(bytes) => Ok(Some(String::from_utf8_lossy(&bytes).into_owned())),
        Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(None),
        Err(error) => Err(at(path, &error)),
    }
}

/// Files in the directories of the report that it does not make, relative to the root.
fn left_over(root: &Path, rendered: &Rendered) -> Result<Vec<String>, Cause> {
    let mut found = Vec::new();
    for directory in MADE {
        let is_made = |path: &str| path.strip_prefix("report/").is_some_and(|path| rendered.contains_key(path));
        found.extend(list(root, directory)?.into_iter().filter(|path| !is_made(path)));
    }
    Ok(found)
}

/// All files below a directory, relative to the root, with `/`, in order; none if there is no such directory.
pub(crate) fn list(root: &Path, directory: &str) -> Result<Vec<String>, Cause> {
    let place = root.join(directory);
    let entries = match fs::read_dir(&place) {
        Ok(entries) => entries,
        Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok(Vec::new()),
        Err(error) => return Err(at(&place, &error)),
    };
    let mut found = Vec::new();
    for entry in entries {
        let entry = entry.map_err(|error| at(&place, &error))?;
        let path = format!("{directory}/{}", entry.file_name().to_string_lossy());
        if entry.file_type().map_err(|error| at(&place, &error))?.is_dir() {
            found.extend(list(root, &path)?);
        } else {
            found.push(path);
        }
    }
    found.sort();
    Ok(found)
}
