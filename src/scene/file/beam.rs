//! `[beam]` of a scene file: length and stiffness, and if they are given its own shape and its supports.

use super::Problem;
use super::profile::{self, Given};
use super::table::{Error, Keys, Value};
use crate::scene::{Profile, Support};

/// What `[beam]` says.
#[derive(Debug)]
pub(super) struct BeamKeys {
    pub(super) length: f64,
    pub(super) bending_stiffness: f64,
    pub(super) shape: Option<Given>,
    pub(super) supports: Option<Vec<Support>>,
}

pub(super) fn read(file: &Keys<'_>) -> Result<BeamKeys, Error> {
    let beam = file.required_table("beam", &["length", "bending_stiffness", "shape", "supports"])?;
    Ok(BeamKeys {
        length: beam.required_number("length")?,
        bending_stiffness: beam.required_number("bending_stiffness")?,
        shape: profile::read(&beam, "shape", Profile::Shape)?,
        supports: beam.get("supports").map(|value| supports(&value)).transpose()?,
    })
}

fn supports(value: &Value<'_>) -> Result<Vec<Support>, Error> {
    value.elements("an array of supports { at = … }")?.iter().map(support).collect()
}

fn support(value: &Value<'_>) -> Result<Support, Error> {
    let keys = value.table(&["at", "level", "built_in", "slope"])?;
    let built_in = keys.truth("built_in")?.unwrap_or(false);
    let slope = keys.number("slope")?;
    if let (false, Some(slope)) = (built_in, keys.get("slope")) {
        return Err(Error { span: slope.span(), problem: Problem::SlopeWithoutBuiltIn { path: slope.path } });
    }
    Ok(Support {
        at: keys.required_number("at")?,
        level: keys.number("level")?.unwrap_or(0.0),
        slope: built_in.then_some(slope.unwrap_or(0.0)),
    })
}
