//! `cargo xtask judge`: the judge is judged on every scene of the gallery, by every route, on every grid, and with every
//! fault put into the answers. It takes minutes, so what comes out is kept in two files of data; the report computes a stated
//! part of them again each time.

pub(crate) mod answers;
pub(crate) mod faults;
mod table;

use std::fs;
use std::path::Path;

use crate::report::scenes;

/// Computes both files.
pub(crate) fn run(root: &Path, progress: &mut dyn FnMut(&str)) -> Result<(), String> {
    let scenes = scenes::all(root).map_err(|error| error.to_string())?;
    let mut rows = Vec::new();
    for (name, scene) in &scenes {
        for intervals in answers::GRIDS {
            progress(&format!("{name}, every route on {intervals} intervals"));
            rows.extend(answers::rows(name, scene, &[intervals]).map_err(|error| error.to_string())?);
        }
    }
    write(root, answers::PATH, &answers::text(&rows))?;
    let mut rows = Vec::new();
    for (name, scene) in &scenes {
        progress(&format!("{name}, every fault"));
        rows.extend(faults::rows(name, scene, &scenes).map_err(|error| error.to_string())?);
    }
    write(root, faults::PATH, &faults::text(&rows))?;
    progress("`cargo xtask report` renders the chapter from it");
    Ok(())
}

fn write(root: &Path, path: &str, text: &str) -> Result<(), String> {
    fs::write(root.join(path), text).map_err(|error| format!("{path}: {error}"))
}
