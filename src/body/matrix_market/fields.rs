//! Parses the fields of a line of a matrix file.

use std::ops::Range;
use std::str::FromStr;

use super::{MOST_ROWS, Mark};
use crate::body::BodyProblem;
use crate::scene::file::Found;

/// A field with its location in the line.
type Field<'a> = (&'a str, Range<usize>);

/// The fields of a line, separated by white space or commas.
pub(super) fn pieces(text: &str) -> impl Iterator<Item = Field<'_>> {
    let fields = text.split(|c: char| c.is_ascii_whitespace() || c == ',').filter(|field| !field.is_empty());
    fields.map(|field| {
        let start = field.as_ptr() as usize - text.as_ptr() as usize;
        (field, start..start + field.len())
    })
}

pub(super) fn fields<'a, const N: usize>(text: &'a str, expected: &'static str) -> Result<[Field<'a>; N], Mark> {
    let found: Vec<_> = pieces(text).collect();
    found.try_into().map_err(|found: Vec<_>| (0..text.len(), BodyProblem::Fields { expected, found: found.len() }))
}

/// Parses a number as programs write it: Fortran uses the exponent `D` for double precision.
pub(super) fn real(text: &str) -> Option<f64> {
    text.parse().or_else(|_| text.replace(['D', 'd'], "e").parse()).ok()
}

pub(super) fn finite((field, place): Field<'_>) -> Result<f64, Mark> {
    let wrong = || {
        let expected = "a finite number".to_owned();
        (place, BodyProblem::Number { quantity: "value", expected, found: Found::of(field) })
    };
    real(field).filter(|value| value.is_finite()).ok_or_else(wrong)
}

/// Parses a row or a column in a file without a size.
pub(super) fn row(quantity: &'static str, field: Field<'_>) -> Result<usize, Mark> {
    Ok(whole(quantity, field, 1, MOST_ROWS)? - 1)
}

/// Parses the label of a node or of one of its degrees of freedom; some programs give negative labels to internal nodes.
pub(super) fn label(quantity: &'static str, field: Field<'_>) -> Result<i64, Mark> {
    number(quantity, field, |_| true, || "a whole number".to_owned())
}

pub(super) fn whole(quantity: &'static str, field: Field<'_>, least: usize, most: usize) -> Result<usize, Mark> {
    let expected = || format!("a whole number from {least} to {most}");
    number(quantity, field, |number| (least..=most).contains(number), expected)
}

fn number<T: FromStr>(
    quantity: &'static str,
    (field, place): Field<'_>,
    is_right: impl Fn(&T) -> bool,
    expected: impl Fn() -> String,
) -> Result<T, Mark> {
    let wrong = || (place, BodyProblem::Number { quantity, expected: expected(), found: Found::of(field) });
    field.parse().ok().filter(is_right).ok_or_else(wrong)
}
