//! `[foundation]` of a scene file: exactly one of five ways to give `u(x)`.

use super::Problem;
use super::table::{Error, Keys, Span, Value};
use crate::scene::Foundation;

/// The five ways, as the keys of `[foundation]`.
pub(super) const KINDS: &[&str] = &["depth", "polynomial", "cosine", "points", "survey"];

/// What `[foundation]` says.
#[derive(Debug)]
pub(super) enum Given {
    /// The foundation itself.
    Foundation(Foundation),
    /// The name of a survey, and where it is written.
    Survey { path: String, span: Span },
}

pub(super) fn read(file: &Keys<'_>) -> Result<Option<Given>, Error> {
    let Some(table) = file.table("foundation", KINDS)? else {
        return Ok(None);
    };
    let mut given: Vec<(&'static str, Value<'_>)> =
        KINDS.iter().filter_map(|&kind| Some((kind, table.get(kind)?))).collect();
    given.sort_by_key(|(_, value)| value.span().start);
    match &given[..] {
        [] => Err(Error { span: table.span(), problem: Problem::NoFoundationKind { known: KINDS } }),
        [(kind, value)] => one(kind, value).map(Some),
        [_, (_, second), ..] => Err(Error {
            span: second.span(),
            problem: Problem::SeveralFoundationKinds { found: given.iter().map(|(kind, _)| *kind).collect() },
        }),
    }
}

fn one(kind: &str, value: &Value<'_>) -> Result<Given, Error> {
    Ok(Given::Foundation(match kind {
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
