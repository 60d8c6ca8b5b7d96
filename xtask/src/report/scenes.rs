//! The scene files of the report.

use std::fs;
use std::io;
use std::path::Path;

use palkki::scene::Scene;
use palkki::scene::file::{ReadProblem, parse};

use super::error::Cause;
use super::files;

/// Where they are.
const DIRECTORY: &str = "report/scenes";

/// Names (without `.toml`) and scenes, in the order of their names.
pub(crate) fn all(root: &Path) -> Result<Vec<(String, Scene)>, Cause> {
    let mut found = Vec::new();
    for path in files::list(root, DIRECTORY)? {
        let name = path.strip_prefix(DIRECTORY).and_then(|path| path.strip_prefix('/')?.strip_suffix(".toml"));
        if let Some(name) = name {
            found.push((name.to_owned(), read(root, name)?));
        }
    }
    Ok(found)
}

/// One scene.
pub(crate) fn read(root: &Path, name: &str) -> Result<Scene, Cause> {
    let directory = root.join(DIRECTORY);
    let text = fs::read_to_string(directory.join(format!("{name}.toml")))?;
    let survey = |file: &str| fs::read_to_string(directory.join(file)).map_err(|error| problem(&error));
    Ok(parse(&format!("{DIRECTORY}/{name}.toml"), &text, survey)?)
}

fn problem(error: &io::Error) -> ReadProblem {
    match error.kind() {
        io::ErrorKind::NotFound => ReadProblem::Missing,
        kind => ReadProblem::Refused { reason: kind.to_string() },
    }
}
