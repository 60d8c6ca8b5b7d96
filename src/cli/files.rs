//! Output files: regular files completely or not at all, streams and devices directly.

use std::fs::{self, File, OpenOptions};
use std::io::{self, Write as _};
use std::path::{Path, PathBuf};

use super::held::Held;
use super::output::{self, Failure, PlaceProblem, Stream};

/// The destination of a text.
#[derive(Debug, Clone, PartialEq, Eq)]
enum Place {
    /// A regular file, existing or new: a complete file is moved to this path.
    File(PathBuf),
    /// A device or a named pipe: written directly.
    Device(PathBuf),
    /// A stream of this program.
    Stream(Stream),
}

/// Files that are first written next to their destinations, and moved there when all of them are complete.
///
/// Dropping this value removes all files that have not been moved. Until then, signals wait.
#[derive(Debug, Default)]
pub(super) struct Files {
    places: Vec<(PathBuf, Place)>,
    staged: Vec<Staged>,
    direct: Vec<Direct>,
    held: Option<Held>,
}

/// A temporary file next to its destination.
#[derive(Debug)]
struct Staged {
    temporary: PathBuf,
    place: PathBuf,
}

/// A text that is written directly when all files are complete.
#[derive(Debug)]
struct Direct {
    place: Place,
    text: String,
}

impl Files {
    /// Checks, as far as possible in advance, that a file can be written at `path`.
    pub(super) fn reserve(&mut self, path: &Path, read: &[PathBuf]) -> Result<(), Failure> {
        let place = place(path)?;
        let not = |problem| Err(Failure::NoPlace { path: path.to_owned(), problem });
        if self.places.iter().any(|(_, other)| *other == place) {
            return not(PlaceProblem::Twice);
        }
        if let Place::File(file) = &place {
            if read.iter().any(|read| fs::canonicalize(read).is_ok_and(|read| read == *file)) {
                return not(PlaceProblem::TheInput);
            }
            if file.exists() {
                // A file that its owner has write-protected is not replaced by another one.
                open(file).map_err(|error| Failure::Write { path: path.to_owned(), error })?;
            }
        }
        self.places.push((path.to_owned(), place));
        Ok(())
    }

    /// The stream for the answer: standard error if a file goes to standard output.
    pub(super) fn stream_of_answer(&self) -> Stream {
        let taken = self.places.iter().any(|(_, place)| *place == Place::Stream(Stream::Output));
        if taken { Stream::Error } else { Stream::Output }
    }

    /// Writes `text` next to the reserved `path`.
    pub(super) fn stage(&mut self, path: &Path, text: String) -> Result<(), Failure> {
        let failed = |error| Failure::Write { path: path.to_owned(), error };
        let reserved = self.places.iter().find(|(reserved, _)| reserved == path).map(|(_, place)| place.clone());
        let place = reserved.map_or_else(|| place(path), Ok)?;
        let Place::File(file) = place else {
            self.direct.push(Direct { place, text });
            return Ok(());
        };
        if self.held.is_none() {
            self.held = Some(Held::new().map_err(failed)?);
        }
        let name = format!(".palkki.{}.{}.tmp", std::process::id(), self.staged.len());
        let temporary = file.with_file_name(name);
        let new = match create_like(&temporary, &file) {
            Ok(new) => new,
            // Only the owner of its directory could replace this file, but the file itself can be written.
            Err(error) if error.kind() == io::ErrorKind::PermissionDenied && file.exists() => {
                let _ = fs::remove_file(&temporary);
                self.direct.push(Direct { place: Place::Device(file), text });
                return Ok(());
            }
            Err(error) => return Err(failed(error)),
        };
        self.staged.push(Staged { temporary, place: file });
        write(new, &text).map_err(failed)
    }

    /// Moves all files to their destinations, and writes the texts that go to streams and devices.
    pub(super) fn publish(mut self) -> Result<(), Failure> {
        while let Some(file) = self.staged.last() {
            fs::rename(&file.temporary, &file.place)
                .map_err(|error| Failure::Write { path: file.place.clone(), error })?;
            self.staged.pop();
        }
        // A pipe may wait for its reader. A signal must then be able to end the program.
        self.held = None;
        for Direct { place, text } in std::mem::take(&mut self.direct) {
            match place {
                Place::Stream(stream) => output::print(stream, &text)?,
                Place::File(path) | Place::Device(path) => {
                    let failed = |error| Failure::Write { path: path.clone(), error };
                    let mut device = open(&path).map_err(failed)?;
                    // Removes any part of the old file that is longer than the new text; a device has no length.
                    if device.metadata().is_ok_and(|there| there.is_file()) {
                        device.set_len(0).map_err(failed)?;
                    }
                    output::write(&mut device, &text).map_err(failed)?;
                }
            }
        }
        Ok(())
    }
}

impl Drop for Files {
    fn drop(&mut self) {
        for file in &self.staged {
            // If it cannot be removed, the message why it was not moved is more important.
            let _ = fs::remove_file(&file.temporary);
        }
    }
}

/// Opens an existing file for writing, like a plain write.
fn open(path: &Path) -> io::Result<File> {
    OpenOptions::new().write(true).open(path)
}

fn write(mut file: File, text: &str) -> io::Result<()> {
    file.write_all(text.as_bytes())?;
    file.sync_all()
}

/// A new file with the mode, owner and group of the file that it will replace.
#[cfg(unix)]
fn create_like(new: &Path, old: &Path) -> io::Result<File> {
    use std::os::unix::fs::{MetadataExt as _, OpenOptionsExt as _, fchown};
    let mut options = OpenOptions::new();
    options.write(true).create_new(true);
    let Ok(there) = fs::metadata(old) else { return options.open(new) };
    // Nobody else may open the file before it has its mode.
    let file = options.mode(0o600).open(new)?;
    let made = file.metadata()?;
    if (made.uid(), made.gid()) != (there.uid(), there.gid()) {
        fchown(&file, Some(there.uid()), Some(there.gid()))?;
    }
    file.set_permissions(there.permissions())?;
    Ok(file)
}

#[cfg(not(unix))]
fn create_like(new: &Path, _: &Path) -> io::Result<File> {
    OpenOptions::new().write(true).create_new(true).open(new)
}

/// The stream that the shell has redirected into the file or pipe at `path`, whatever its name. Written separately, one text would
/// overwrite the other. A device accepts both.
#[cfg(unix)]
fn stream_into(path: &Path) -> Option<Stream> {
    use std::os::fd::AsFd;
    use std::os::unix::fs::{FileTypeExt as _, MetadataExt as _};
    let there = fs::metadata(path).ok().filter(|there| there.is_file() || there.file_type().is_fifo())?;
    let goes_there = |stream: &dyn AsFd| {
        let goes = stream.as_fd().try_clone_to_owned().and_then(|stream| File::from(stream).metadata());
        goes.is_ok_and(|goes| (goes.dev(), goes.ino()) == (there.dev(), there.ino()))
    };
    if goes_there(&io::stdout()) { Some(Stream::Output) } else { goes_there(&io::stderr()).then_some(Stream::Error) }
}

#[cfg(not(unix))]
fn stream_into(_: &Path) -> Option<Stream> {
    None
}

/// The real destination of a file at `path`: moving a file there must not replace a link or a device.
fn place(path: &Path) -> Result<Place, Failure> {
    place_through(path, MOST_LINKS)
}

/// Largest number of links that one name may lead through; more form a circle, also for the operating system.
const MOST_LINKS: usize = 40;

/// The same, if the name leads through at most this many links to a file that does not exist yet.
fn place_through(path: &Path, links: usize) -> Result<Place, Failure> {
    const NAMES: [(Stream, [&str; 3]); 2] = [
        (Stream::Output, ["/dev/stdout", "/dev/fd/1", "/proc/self/fd/1"]),
        (Stream::Error, ["/dev/stderr", "/dev/fd/2", "/proc/self/fd/2"]),
    ];
    let not = |problem| Failure::NoPlace { path: path.to_owned(), problem };
    if path == Path::new("-") {
        return Ok(Place::Stream(Stream::Output));
    }
    if let Some((stream, _)) = NAMES.iter().find(|(_, names)| names.iter().any(|name| path == Path::new(name))) {
        return Ok(Place::Stream(*stream));
    }
    if let Some(stream) = stream_into(path) {
        return Ok(Place::Stream(stream));
    }
    match fs::metadata(path) {
        Ok(there) if there.is_file() => {
            let file = fs::canonicalize(path).map_err(|error| Failure::Write { path: path.to_owned(), error })?;
            Ok(Place::File(file))
        }
        Ok(there) if there.is_dir() => Err(not(PlaceProblem::Directory)),
        Ok(_) => Ok(Place::Device(path.to_owned())),
        Err(_) => {
            let name = path.file_name().ok_or_else(|| not(PlaceProblem::NoName))?;
            let folder = match path.parent() {
                Some(folder) if folder != Path::new("") => folder,
                _ => Path::new("."),
            };
            let folder = fs::canonicalize(folder).map_err(|_| not(PlaceProblem::NoDirectory))?;
            match fs::read_link(path) {
                Ok(_) if links == 0 => return Err(not(PlaceProblem::Circle)),
                // The target of the link is created, and the link remains.
                Ok(target) => return place_through(&folder.join(target), links - 1),
                Err(_) => {}
            }
            if folder.is_dir() { Ok(Place::File(folder.join(name))) } else { Err(not(PlaceProblem::NoDirectory)) }
        }
    }
}
