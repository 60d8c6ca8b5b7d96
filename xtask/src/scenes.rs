//! The scene files of the report.

use std::fs;
use std::io;
use std::path::Path;

use palkki::scene::Scene;
use palkki::scene::file::{ReadProblem, parse};

use crate::Cause;
use crate::report::files;

/// Where they are.
const DIRECTORY: &str = "report/scenes";

/// Names (without `.toml`) and scenes, in the order of their names.
pub(crate) fn all(root: &Path) -> Result<Vec<(String, Scene)>, Cause> {
    let paths = files::list(root, DIRECTORY)?;
    let names = paths.iter().filter_map(|path| path.strip_prefix(DIRECTORY)?.strip_prefix('/')?.strip_suffix(".toml"));
    names.map(|name| Ok((name.to_owned(), read(root, name)?))).collect()
}

/// One scene.
pub(crate) fn read(root: &Path, name: &str) -> Result<Scene, Cause> {
    let directory = root.join(DIRECTORY);
    let text = fs::read_to_string(directory.join(format!("{name}.toml")))?;
    let survey = |file: &str| {
        fs::read_to_string(directory.join(file)).map_err(|error| match error.kind() {
            io::ErrorKind::NotFound => ReadProblem::Missing,
            kind => ReadProblem::Refused { reason: kind.to_string() },
        })
    };
    Ok(parse(&format!("{DIRECTORY}/{name}.toml"), &text, survey)?)
}
