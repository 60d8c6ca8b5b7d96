//! The contents of a scene file, table by table; the numbers are not checked yet.

use toml::de::DeTable;

use super::Problem;
use super::columns::Named;
use super::table::{Error, Keys, Value};
use crate::scene::{CoupleLoad, Foundation, Joint, LinearLoad, PointLoad, Profile, Support, Units};

/// The contents of a scene file.
pub(super) struct Contents {
    pub(super) title: String,
    pub(super) units: Units,
    pub(super) beam: BeamKeys,
    pub(super) load: LoadKeys,
    pub(super) foundation: Option<Given>,
    /// Stiffness of an elastic foundation.
    pub(super) stiffness: Option<Stiffness>,
}

pub(super) fn read(document: &DeTable<'_>) -> Result<Contents, Error> {
    let file = Keys::of_file(document, &["title", "beam", "load", "foundation", "units"])?;
    let beam = beam(&file)?;
    let units = units(&file)?;
    Ok(Contents {
        title: file.line_of_text("title")?.unwrap_or_default(),
        units,
        beam,
        load: load(&file)?,
        foundation: profile(&file, "foundation", Profile::Foundation, GROUND)?,
        stiffness: match file.table("foundation", GROUND)?.and_then(|ground| ground.get("stiffness")) {
            Some(value) => Some(stiffness(&value)?),
            None => None,
        },
    })
}

/// Reads `[units]`, which is optional.
pub(super) fn units(file: &Keys<'_>) -> Result<Units, Error> {
    let units = file.table("units", &["length", "force"])?;
    let label = |key| units.as_ref().map_or(Ok(None), |units| units.line_of_text(key));
    Ok(Units { length: label("length")?, force: label("force")? })
}

/// The keys of `[beam]`.
#[derive(Debug)]
pub(super) struct BeamKeys {
    pub(super) length: f64,
    pub(super) bending_stiffness: Stiffness,
    pub(super) joints: Vec<Joint>,
    pub(super) tension: f64,
    pub(super) shape: Option<Given>,
    pub(super) supports: Option<Vec<Support>>,
}

fn beam(file: &Keys<'_>) -> Result<BeamKeys, Error> {
    let beam =
        file.required_table("beam", &["length", "bending_stiffness", "shape", "supports", "joints", "tension"])?;
    Ok(BeamKeys {
        length: beam.required_number("length")?,
        bending_stiffness: stiffness(&beam.required(
            "bending_stiffness",
            "a number",
            beam.get("bending_stiffness"),
        )?)?,
        joints: beam.elements("joints")?.iter().map(joint).collect::<Result<_, _>>()?,
        tension: beam.number("tension")?.unwrap_or(0.0),
        shape: profile(&beam, "shape", Profile::Shape, KINDS)?,
        supports: beam.get("supports").map(|value| supports(&value)).transpose()?,
    })
}

/// A stiffness of the beam or of the foundation.
#[derive(Debug)]
pub(super) enum Stiffness {
    /// Uniform from end to end.
    One(f64),
    /// Positions and the stiffness that begins at each.
    Steps(Vec<[f64; 2]>),
}

fn stiffness(value: &Value<'_>) -> Result<Stiffness, Error> {
    if !value.is_table() {
        // A bare list of pairs could mean steps, or points of a line as elsewhere.
        return value
            .number_or("a number, or steps { steps = [[x, stiffness], …] }, each from its x on")
            .map(Stiffness::One);
    }
    let keys = value.table(&["steps"])?;
    let steps = keys.required("steps", "an array of steps [x, stiffness]", keys.get("steps"))?;
    const STEP: &str = "a step [x, stiffness]";
    let step = |value: &Value<'_>| match &value.elements(STEP)?[..] {
        [x, stiffness] => Ok([x.number()?, stiffness.number()?]),
        _ => Err(value.wrong_type(STEP)),
    };
    let steps = steps.elements("an array of steps [x, stiffness]")?;
    Ok(Stiffness::Steps(steps.iter().map(step).collect::<Result<_, _>>()?))
}

fn joint(value: &Value<'_>) -> Result<Joint, Error> {
    let keys = value.table(&["at", "stiffness"])?;
    Ok(Joint { at: keys.required_number("at")?, stiffness: keys.number("stiffness")? })
}

fn supports(value: &Value<'_>) -> Result<Vec<Support>, Error> {
    value.elements("an array of supports { at = … }")?.iter().map(support).collect()
}

fn support(value: &Value<'_>) -> Result<Support, Error> {
    let keys = value.table(&["at", "level", "built_in", "slope", "pushes_only", "stiffness", "turning_stiffness"])?;
    let built_in = keys.truth("built_in")?.unwrap_or(false);
    let slope = keys.number("slope")?;
    let pushes_only = keys.truth("pushes_only")?.unwrap_or(false);
    let [stiffness, turning_stiffness] = [keys.number("stiffness")?, keys.number("turning_stiffness")?];
    let turns = keys.get("turning_stiffness");
    let more = if built_in { keys.get("built_in") } else { keys.get("slope").or(turns) };
    if let (true, Some(more)) = (pushes_only, more) {
        return Err(Error { span: more.span(), problem: Problem::PushesBuiltIn { path: more.path } });
    }
    if let (true, Some(gives)) = (built_in, keys.get("turning_stiffness").or(keys.get("stiffness"))) {
        return Err(Error { span: gives.span(), problem: Problem::GivesBuiltIn { path: gives.path } });
    }
    if let (false, None, Some(slope)) = (built_in, turning_stiffness, keys.get("slope")) {
        return Err(Error { span: slope.span(), problem: Problem::SlopeWithoutBuiltIn { path: slope.path } });
    }
    Ok(Support {
        at: keys.required_number("at")?,
        level: keys.number("level")?.unwrap_or(0.0),
        slope: (built_in || turning_stiffness.is_some()).then_some(slope.unwrap_or(0.0)),
        pushes_only,
        stiffness,
        turning_stiffness,
    })
}

/// The keys of `[load]`; all empty without that table.
#[derive(Debug, Default)]
pub(super) struct LoadKeys {
    pub(super) uniform: f64,
    pub(super) linear: Vec<LinearLoad>,
    pub(super) point: Vec<PointLoad>,
    pub(super) couple: Vec<CoupleLoad>,
}

/// Reads `[load]`: `uniform`, `linear`, `point` and `couple`, each of which is optional.
fn load(file: &Keys<'_>) -> Result<LoadKeys, Error> {
    let Some(load) = file.table("load", &["uniform", "linear", "point", "couple"])? else {
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
    for part in load.elements("couple")? {
        let part = part.table(&["at", "moment"])?;
        keys.couple.push(CoupleLoad { at: part.required_number("at")?, moment: part.required_number("moment")? });
    }
    Ok(keys)
}

/// The keys for the five ways to give a profile.
pub(super) const KINDS: &[&str] = &["depth", "polynomial", "cosine", "points", "survey"];

/// The keys of `[foundation]`: those of a profile, and its stiffness.
const GROUND: &[&str] = &["depth", "polynomial", "cosine", "points", "survey", "stiffness"];

/// The profile that a table gives.
#[derive(Debug)]
pub(super) enum Given {
    /// The profile itself.
    Profile(Foundation),
    /// The declaration of a survey that contains the profile.
    Survey(Named),
}

/// Reads the profile in the table `key` of `parent`, if there is one. Exactly one of five keys gives the depth `u(x)` or `w0(x)`.
fn profile(parent: &Keys<'_>, key: &str, of: Profile, keys: &'static [&'static str]) -> Result<Option<Given>, Error> {
    let Some(table) = parent.table(key, keys)? else {
        return Ok(None);
    };
    let mut given: Vec<(&'static str, Value<'_>)> =
        KINDS.iter().filter_map(|&kind| Some((kind, table.get(kind)?))).collect();
    given.sort_by_key(|(_, value)| value.span().start);
    match &given[..] {
        [] => Err(Error { span: table.span(), problem: Problem::NoProfileKind { of, known: KINDS } }),
        [(kind, value)] => one(kind, value).map(Some),
        [_, (_, second), ..] => Err(Error {
            span: second.span(),
            problem: Problem::SeveralProfileKinds { of, found: given.iter().map(|(kind, _)| *kind).collect() },
        }),
    }
}

fn one(kind: &str, value: &Value<'_>) -> Result<Given, Error> {
    Ok(Given::Profile(match kind {
        "depth" => Foundation::Flat { depth: value.number()? },
        "polynomial" => Foundation::Polynomial {
            coefficients: value
                .elements("an array of numbers, c0 + c1 x + c2 x² + …")?
                .iter()
                .map(Value::number)
                .collect::<Result<_, _>>()?,
        },
        "cosine" => {
            let cosine = value.table(&["mean", "amplitude", "wavelength", "phase"])?;
            Foundation::Cosine {
                mean: cosine.required_number("mean")?,
                amplitude: cosine.required_number("amplitude")?,
                wavelength: cosine.required_number("wavelength")?,
                phase: cosine.number("phase")?.unwrap_or(0.0),
            }
        }
        "points" => Foundation::Polyline {
            points: value.elements("an array of points [x, depth]")?.iter().map(point).collect::<Result<_, _>>()?,
        },
        _ => return Named::of(value).map(Given::Survey),
    }))
}

fn point(value: &Value<'_>) -> Result<[f64; 2], Error> {
    const POINT: &str = "a point [x, depth]";
    match &value.elements(POINT)?[..] {
        [x, depth] => Ok([x.number()?, depth.number()?]),
        _ => Err(value.wrong_type(POINT)),
    }
}
