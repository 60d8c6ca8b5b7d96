//! `[foundation]` and `beam.shape` of a scene file: exactly one of five ways to give a depth `u(x)`, or `w0(x)`.

use super::Problem;
use super::table::{Error, Keys, Span, Value};
use crate::scene::{Foundation, Profile};

/// The five ways, as the keys of the table.
pub(super) const KINDS: &[&str] = &["depth", "polynomial", "cosine", "points", "survey"];

/// What the table says.
#[derive(Debug)]
pub(super) enum Given {
    /// The profile itself.
    Profile(Foundation),
    /// The name of a survey, and where it is written.
    Survey { path: String, span: Span },
}

/// The profile in the table `key` of `parent`, if it is there.
pub(super) fn read(parent: &Keys<'_>, key: &str, of: Profile) -> Result<Option<Given>, Error> {
    let Some(table) = parent.table(key, KINDS)? else {
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
        _ => return Ok(Given::Survey { path: value.line_of_text()?, span: value.span() }),
    }))
}

fn point(value: &Value<'_>) -> Result<[f64; 2], Error> {
    const POINT: &str = "a point [x, depth]";
    match &value.elements(POINT)?[..] {
        [x, depth] => Ok([x.number()?, depth.number()?]),
        _ => Err(value.wrong_type(POINT)),
    }
}
