//! `[load]` of a scene file: `uniform`, `linear` and `point`, each of which may be left out.

use super::table::{Error, Keys};
use crate::scene::{LinearLoad, PointLoad};

/// What `[load]` says; nothing at all if it is left out.
#[derive(Debug, Default)]
pub(super) struct LoadKeys {
    pub(super) uniform: f64,
    pub(super) linear: Vec<LinearLoad>,
    pub(super) point: Vec<PointLoad>,
}

pub(super) fn read(file: &Keys<'_>) -> Result<LoadKeys, Error> {
    let Some(load) = file.table("load", &["uniform", "linear", "point"])? else {
        return Ok(LoadKeys::default());
    };
    let mut keys = LoadKeys { uniform: load.number("uniform")?.unwrap_or(0.0), ..LoadKeys::default() };
    for part in load.elements("linear")? {
        let part = part.table(&["from", "to", "start", "end"])?;
        keys.linear.push(LinearLoad {
            from: part.required_number("from")?,
            to: part.required_number("to")?,
            start: part.required_number("start")?,
            end: part.required_number("end")?,
        });
    }
    for part in load.elements("point")? {
        let part = part.table(&["at", "force"])?;
        keys.point.push(PointLoad { at: part.required_number("at")?, force: part.required_number("force")? });
    }
    Ok(keys)
}
