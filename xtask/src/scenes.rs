//! The scene files of the report.

use std::fs;
use std::io;
use std::path::Path;

use palkki::scene::Scene;
use palkki::scene::file::{Model, ReadProblem, parse, parse_train};
use palkki_evidence::texts::Files;

use crate::Cause;
use crate::report::files;

/// Where those of the gallery are.
pub(crate) const GALLERY: &str = "report/scenes";
/// Where those are that are held otherwise than by two simple supports at the ends.
pub(crate) const HELD: &str = "report/scenes/held";
/// Where those on ground that gives are.
pub(crate) const SOFT: &str = "report/scenes/soft";
/// Where those that engineers have are.
pub(crate) const PRACTICE: &str = "report/scenes/practice";
/// Where those of the exercises are.
pub(crate) const TAUGHT: &str = "report/scenes/taught";

/// Names (without `.toml`) and scenes of the gallery, in the order of their names.
pub(crate) fn all(root: &Path) -> Result<Vec<(String, Scene)>, Cause> {
    listed(root, GALLERY)
}

/// The same for the scenes that are held in other ways.
pub(crate) fn held(root: &Path) -> Result<Vec<(String, Scene)>, Cause> {
    listed(root, HELD)
}

/// The scenes of a directory, without those of the directories in it.
pub(crate) fn listed(root: &Path, directory: &str) -> Result<Vec<(String, Scene)>, Cause> {
    let paths = files::list(root, directory)?;
    let names = paths.iter().filter_map(|path| path.strip_prefix(directory)?.strip_prefix('/')?.strip_suffix(".toml"));
    let names = names.filter(|name| !name.contains('/'));
    names.map(|name| Ok((name.to_owned(), of(root, directory, name)?))).collect()
}

/// One scene of the gallery.
pub(crate) fn read(root: &Path, name: &str) -> Result<Scene, Cause> {
    of(root, GALLERY, name)
}

/// Trains that cross a bridge: scenes for sweeps.
pub(crate) const TRAINS: &str = "report/scenes/trains";

/// A train.
pub(crate) fn train(root: &Path, name: &str) -> Result<Scene, Cause> {
    let text = fs::read_to_string(root.join(TRAINS).join(format!("{name}.toml")))?;
    match parse_train(name, &text, &mut Files(&[]))? {
        Model::Scene(scene) => Ok(scene),
        Model::Body(_) => Err(format!("{name} is a body").into()),
    }
}

/// A scene of one of the directories.
pub(crate) fn of(root: &Path, path: &str, name: &str) -> Result<Scene, Cause> {
    let directory = root.join(path);
    let text = fs::read_to_string(directory.join(format!("{name}.toml")))?;
    let survey = |file: &str| {
        fs::read_to_string(directory.join(file)).map_err(|error| match error.kind() {
            io::ErrorKind::NotFound => ReadProblem::Missing,
            kind => ReadProblem::Refused { reason: kind.to_string() },
        })
    };
    Ok(parse(&format!("{path}/{name}.toml"), &text, survey)?)
}
