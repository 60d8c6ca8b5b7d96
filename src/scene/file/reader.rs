//! Reads a survey with declared columns: finds the header and converts the rows to points.

use std::cell::Cell;

use super::columns::{Column, Columns};
use super::survey::{Field, Layout, Survey};
use super::survey_problem::SurveyProblem;
use super::{FileError, Found};

/// Greatest number of rows before the header: titles, the name of an instrument, a date.
const MOST_BEFORE_HEADER: usize = 50;

/// A survey with the locations of its declared columns.
#[derive(Debug)]
pub(super) struct Reader<'a> {
    survey: &'a Survey,
    columns: &'a Columns,
    layout: Layout,
    /// Number of rows up to and including the header. `places` are the columns of x and of the value, from 0.
    behind: usize,
    places: [usize; 2],
    /// Number of fields in the header, or in the first row without a header.
    width: usize,
    /// Origin and datum of the declaration.
    origin: Option<Decimal>,
    datum: Option<Decimal>,
    /// Distance between stations, once a row has shown it.
    station: Cell<Option<f64>>,
}

/// A row with a value: its two fields, and the location of the whole row.
struct Row<'a> {
    fields: [Field<'a>; 2],
    whole: std::ops::Range<usize>,
}

impl<'a> Reader<'a> {
    pub(super) fn of(survey: &'a Survey, columns: &'a Columns) -> Result<Self, Box<FileError>> {
        let Some((first, span)) = survey.rows().next() else {
            return Err(survey.error(0..0, SurveyProblem::WithoutHeader.into()));
        };
        let reader = |layout: Layout, row, behind, places| {
            let width = layout.fields(row, 0).count();
            let [origin, datum] = [columns.origin, columns.datum].map(|number| number.map(Decimal::of));
            Self { survey, columns, layout, behind, places, width, origin, datum, station: Cell::new(None) }
        };
        if let (Column::Number(x), Column::Number(value)) = (&columns.x, &columns.value) {
            let separator = survey.separator(first);
            let places = [x - 1, value - 1];
            // The trial has a layout of its own, so that the decimal mark and the stations of a header have no effect.
            let trial = reader(Layout::of(separator), first, 0, places);
            let is_no_number =
                |[x, value]: [Field<'_>; 2]| trial.length(x).is_err() && trial.layout.number(value.0).is_err();
            let is_header = trial.fields(first, span.start).is_some_and(is_no_number);
            return Ok(reader(Layout::of(separator), first, usize::from(is_header), places));
        }
        for separator in survey.separators() {
            for (behind, (row, span)) in (1..).zip(survey.rows().take(MOST_BEFORE_HEADER)) {
                let layout = Layout::of(separator);
                let names: Vec<&str> = layout.fields(row, span.start).map(|(name, _)| name).collect();
                let places = [&columns.x, &columns.value].map(|column| place(column, &names));
                if let [Some(x), Some(value)] = places {
                    for column in [&columns.x, &columns.value] {
                        if is_twice(column, &names) {
                            return Err(
                                survey.error(span, SurveyProblem::ColumnTwice { column: column.to_string() }.into())
                            );
                        }
                    }
                    return Ok(reader(layout, row, behind, [x, value]));
                }
            }
        }
        let names = survey.names(first);
        let known: Vec<&str> = names.iter().map(String::as_str).collect();
        let missing = [&columns.x, &columns.value].into_iter().find(|column| place(column, &known).is_none());
        let column = missing.unwrap_or(&columns.x).to_string();
        Err(survey.error(span, SurveyProblem::NoColumn { column, columns: Some(names) }.into()))
    }

    /// The points from left to right.
    pub(super) fn points(&self) -> Result<Vec<[f64; 2]>, Box<FileError>> {
        let mut points = Vec::new();
        for row in self.rows() {
            let [x, value] = row?.fields;
            points.push(self.point(x, value)?);
        }
        if points.first().zip(points.last()).is_some_and(|(first, last)| last[0] < first[0]) {
            points.reverse();
        }
        Ok(points)
    }

    /// The rows with a value, in the order of the points and without invalid rows: the locations of the points in the file.
    pub(super) fn places(&self) -> Vec<([Field<'a>; 2], std::ops::Range<usize>)> {
        let rows = self.rows().filter_map(Result::ok);
        let mut places: Vec<_> = rows.map(|row| (row.fields, row.whole)).collect();
        let ends = [places.first(), places.last()].map(|row| self.at(row?.0[0].clone()).ok());
        if let [Some(first), Some(last)] = ends
            && last < first
        {
            places.reverse();
        }
        places
    }

    fn rows(&self) -> impl Iterator<Item = Result<Row<'a>, Box<FileError>>> {
        self.survey.rows().skip(self.behind).filter_map(|(row, whole)| match self.fields(row, whole.start) {
            Some(fields) if self.is_missing(&fields) => None,
            Some(_) if self.is_wide(row) => {
                let (width, found) = (self.width, self.layout.fields(row, whole.start).count());
                Some(Err(self.survey.error(whole, SurveyProblem::Wide { width, found }.into())))
            }
            Some(fields) => Some(Ok(Row { fields, whole })),
            None if row.chars().all(|c| c == self.layout.separator || c.is_whitespace()) => None,
            None => {
                let found = self.layout.fields(row, whole.start).count();
                let column = self.places[0].max(self.places[1]) + 1;
                Some(Err(self.survey.error(whole, SurveyProblem::Row { column, found }.into())))
            }
        })
    }

    /// The two declared fields of a row, if it has enough fields.
    fn fields(&self, row: &'a str, start: usize) -> Option<[Field<'a>; 2]> {
        let [x, value] = self.places;
        let mut fields = self.layout.fields(row, start);
        if x == value {
            let field = fields.nth(x)?;
            return Some([field.clone(), field]);
        }
        let first = fields.nth(x.min(value))?;
        let second = fields.nth(x.abs_diff(value) - 1)?;
        Some(if x < value { [first, second] } else { [second, first] })
    }

    /// Whether a row separated by commas has more fields than the header; some of the commas may be decimal marks.
    fn is_wide(&self, row: &str) -> bool {
        // Most rows have no more commas than the header, and need no further check.
        self.layout.separator == ','
            && self.width <= row.bytes().filter(|byte| *byte == b',').count()
            && self.layout.fields(row, 0).skip(self.width).any(|(text, _)| !text.is_empty())
    }

    /// Whether a row has no value: the value is the marker of missing data, or both fields are empty.
    fn is_missing(&self, [x, value]: &[Field<'_>; 2]) -> bool {
        let mark = self.columns.no_data.as_ref();
        let number = |text: &str| Layout::of(self.layout.separator).number(text).ok().map(|number| number.value);
        x.0.is_empty() && value.0.is_empty() || mark.is_some_and(|mark| mark.is(value.0, number))
    }

    /// The position on the beam \[length\].
    fn at(&self, x: Field<'_>) -> Result<f64, Box<FileError>> {
        let x = self.length(x)?;
        Ok(match self.origin {
            Some(origin) if self.columns.falls => origin.minus(x),
            Some(origin) => x.minus(origin),
            None => x,
        }
        .value)
    }

    fn point(&self, x: Field<'a>, value: Field<'a>) -> Result<[f64; 2], Box<FileError>> {
        let x = self.at(x)?;
        let value = self.survey.decimal(&self.layout, self.columns.quantity(), value)?;
        let depth = self.datum.map_or(value, |datum| datum.minus(value));
        Ok([x, depth.value])
    }
}

impl Reader<'_> {
    /// A position along the survey: a number, or a station such as `12+34.5`.
    fn length(&self, (text, span): Field<'_>) -> Result<Decimal, Box<FileError>> {
        let Some((negative, head, tail)) = station(text) else {
            return self.survey.decimal(&self.layout, "x", (text, span));
        };
        let unclear = || self.survey.error(span.clone(), SurveyProblem::Station { found: Found::of(text) }.into());
        let rest = self.survey.decimal(&self.layout, "x", (tail, span.clone()))?;
        let stations: f64 = head.parse().map_err(|_| unclear())?;
        let mut x = rest;
        // Before the first station the distance between stations has no effect.
        if 0.0 < stations {
            let length = match tail.split(['.', ',']).next().unwrap_or_default().len() {
                2 => 100.0,
                3 => 1000.0,
                _ => return Err(unclear()),
            };
            if self.station.replace(Some(length)).is_some_and(|other: f64| other.total_cmp(&length).is_ne()) {
                return Err(unclear());
            }
            x = Decimal { value: -stations * length, places: Some(0) }.minus(rest).negated();
        }
        Ok(if negative { x.negated() } else { x })
    }
}

/// The sign, the station number and the part after the `+`.
fn station(text: &str) -> Option<(bool, &str, &str)> {
    let (negative, digits) = text.strip_prefix('-').map_or((false, text), |rest| (true, rest));
    let (head, tail) = digits.split_once('+')?;
    let is_station = !head.is_empty()
        && head.bytes().all(|byte| byte.is_ascii_digit())
        && tail.bytes().next().is_some_and(|byte| byte.is_ascii_digit());
    is_station.then_some((negative, head, tail))
}

fn place(column: &Column, names: &[&str]) -> Option<usize> {
    match column {
        Column::Name(name) => names.iter().position(|other| other == name),
        Column::Number(number) => Some(number - 1),
    }
}

fn is_twice(column: &Column, names: &[&str]) -> bool {
    matches!(column, Column::Name(name) if 1 < names.iter().filter(|other| *other == name).count())
}

/// The points of a survey on a beam of the given length. A first or last position that equals an end of the beam within rounding
/// is moved to it. If the survey has an origin (`is_cut`), the points beyond the beam are removed. Also returns the number of
/// points removed at the left end.
pub(super) fn on_beam(mut points: Vec<[f64; 2]>, length: f64, is_cut: bool) -> (Vec<[f64; 2]>, usize) {
    /// Fraction of the beam length; positions have about ten digits.
    const AT_END: f64 = 1e-9;
    let near = |x: f64, end: f64| (x - end).abs() <= AT_END * length.abs();
    points.iter_mut().take_while(|point| near(point[0], 0.0)).for_each(|point| point[0] = 0.0);
    points.iter_mut().rev().take_while(|point| near(point[0], length)).for_each(|point| point[0] = length);
    if !is_cut {
        return (points, 0);
    }
    let beyond = points.iter().rev().take_while(|point| length < point[0]).count();
    let mut end = points.len() - beyond;
    if 0 < beyond && 0 < end && points[end - 1][0] < length {
        points[end] = between(points[end - 1], points[end], length);
        end += 1;
    }
    points.truncate(end);
    let mut start = points.iter().take_while(|point| point[0] < 0.0).count();
    if 0 < start && start < end && 0.0 < points[start][0] {
        start -= 1;
        points[start] = between(points[start], points[start + 1], 0.0);
    }
    points.drain(..start);
    (points, start)
}

/// The point at x on the line through two points.
fn between([a, u]: [f64; 2], [b, v]: [f64; 2], x: f64) -> [f64; 2] {
    [x, u + (v - u) * ((x - a) / (b - a))]
}

/// A number with its count of decimal places, if it is written without a power of ten.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Decimal {
    pub(super) value: f64,
    pub(super) places: Option<usize>,
}

impl Decimal {
    /// A number of the scene file, with the decimal places of its shortest text.
    fn of(value: f64) -> Self {
        let text = value.to_string();
        Self { value, places: Some(text.split_once('.').map_or(0, |(_, places)| places.len())) }
    }

    fn negated(self) -> Self {
        Self { value: -self.value + 0.0, ..self }
    }

    /// The difference of two decimal numbers, rounded to the larger number of decimal places. A survey of elevations thus has the
    /// same depths as a survey of depths, to the last bit.
    fn minus(self, other: Self) -> Self {
        /// Powers of ten that are exact in floating point.
        const POWERS: [f64; 10] = [1.0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9];
        /// Integers and half-integers below this limit are exact.
        const EXACT: f64 = (1_u64 << 51) as f64;
        let value = self.value - other.value;
        let places = self.places.zip(other.places).map(|(a, b)| a.max(b));
        let rounded = places.and_then(|places| POWERS.get(places)).and_then(|power| {
            let size = self.value.abs().max(other.value.abs()) * power;
            (size < EXACT).then(|| (value * power).round() / power)
        });
        Self { value: rounded.unwrap_or(value), places }
    }
}
