//! Declaration of the columns of a survey: `survey = { file, x, depth | elevation, datum, origin, direction, no_data }`.

use std::fmt;

use super::Problem;
use super::survey_problem::SurveyProblem;
use super::table::{Error, Keys, Span, Value};

/// The keys of the table.
const KEYS: &[&str] = &["file", "x", "depth", "elevation", "datum", "origin", "direction", "no_data"];

/// A survey as the scene file declares it.
#[derive(Debug, Clone)]
pub(super) struct Named {
    pub(super) path: String,
    /// Location of the file name.
    pub(super) span: Span,
    /// Declared columns; without a declaration the header is `x,depth`.
    pub(super) columns: Option<Columns>,
}

/// The declared columns and the meaning of their values.
#[derive(Debug, Clone)]
pub(super) struct Columns {
    pub(super) x: Column,
    pub(super) value: Column,
    /// For elevations, the elevation at which the depth is 0 \[length\]; [`None`] for depths.
    pub(super) datum: Option<f64>,
    /// Chainage of the left end of the beam; points beyond the beam are then removed. Without it x is measured from the left end,
    /// and the survey reaches exactly from end to end.
    pub(super) origin: Option<f64>,
    /// Whether chainage increases from right to left.
    pub(super) falls: bool,
    pub(super) no_data: Option<NoData>,
}

/// A column, given by its name or by its number from 1.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) enum Column {
    Name(String),
    Number(usize),
}

/// The marker of a missing value.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum NoData {
    Number(f64),
    Text(String),
}

impl Named {
    /// Reads the value of a key `survey`: a file name or a table.
    pub(super) fn of(value: &Value<'_>) -> Result<Self, Error> {
        if !value.is_table() {
            return Ok(Self { path: value.line_of_text()?, span: value.span(), columns: None });
        }
        let keys = value.table(KEYS)?;
        let file = keys.required_value("file", "the name of a CSV file")?;
        let columns = Some(Columns::of(&keys)?);
        Ok(Self { path: file.line_of_text()?, span: file.span(), columns })
    }
}

impl Columns {
    fn of(keys: &Keys<'_>) -> Result<Self, Error> {
        let x = Column::of(&keys.required_value("x", COLUMN)?)?;
        let (value, datum) = match (keys.get("depth"), keys.get("elevation")) {
            (Some(depth), None) => {
                if let Some(datum) = keys.get("datum") {
                    return Err(Error { span: datum.span(), problem: SurveyProblem::DatumOfDepths.into() });
                }
                (depth, None)
            }
            (None, Some(elevation)) => (
                elevation,
                Some(keys.required_value("datum", "a number, the elevation at which the depth is 0")?.finite()?),
            ),
            _ => return Err(Error { span: keys.span(), problem: SurveyProblem::DepthOrElevation.into() }),
        };
        let falls = match keys.get("direction") {
            None => false,
            Some(direction) => match direction.line_of_text()?.as_str() {
                "up" => false,
                "down" if keys.get("origin").is_none() => {
                    let problem = SurveyProblem::DirectionWithoutOrigin.into();
                    return Err(Error { span: direction.span(), problem });
                }
                "down" => true,
                _ => return Err(direction.wrong_type("\"up\", where x grows to the right, or \"down\"")),
            },
        };
        let origin = keys.get("origin").map(|origin| origin.finite()).transpose()?;
        let no_data = keys.get("no_data").map(|mark| NoData::of(&mark)).transpose()?;
        Ok(Self { x, value: Column::of(&value)?, datum, origin, falls, no_data })
    }

    /// The name of the values.
    pub(super) fn quantity(&self) -> &'static str {
        if self.datum.is_some() { "elevation" } else { "depth" }
    }
}

/// The permitted ways to give a column, for messages.
const COLUMN: &str = "the name of a column, or its number from 1";

impl Column {
    fn of(value: &Value<'_>) -> Result<Self, Error> {
        if let Some(number) = value.whole() {
            return if number == 0 { Err(value.wrong_type(COLUMN)) } else { Ok(Self::Number(number)) };
        }
        value.line_of_text().map(Self::Name).map_err(|error| match error.problem {
            Problem::WrongType { .. } => value.wrong_type(COLUMN),
            problem => Error { problem, ..error },
        })
    }
}

impl fmt::Display for Column {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Name(name) => f.write_str(name),
            Self::Number(number) => write!(f, "{number}"),
        }
    }
}

impl NoData {
    fn of(value: &Value<'_>) -> Result<Self, Error> {
        value.line_of_text().map(Self::Text).or_else(|_| value.finite().map(Self::Number))
    }

    /// Whether a field contains the marker; `number` parses a field.
    pub(super) fn is(&self, text: &str, number: impl Fn(&str) -> Option<f64>) -> bool {
        match self {
            Self::Text(mark) => mark == text,
            Self::Number(mark) => number(text).is_some_and(|number| number.total_cmp(mark).is_eq()),
        }
    }
}
