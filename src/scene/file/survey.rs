//! A survey: the depths of a foundation as CSV, `x,depth`, one point in each row.
//!
//! Blank lines and lines that start with `#` are left out, spaces round a field are trimmed, a byte order mark and
//! Windows line ends are accepted. Nothing is quoted: the fields are numbers.
//!
//! Where a comma is the decimal mark, spreadsheets part the fields by `;`. A file whose header does so may have decimal commas;
//! one that has any has no decimal points, as a point could then part thousands.

use std::path::Path;

use super::table::Span;
use super::{FileError, Found, Problem, ReadProblem, Source};
use crate::memory::can_be_had;

const FIELDS: [&str; 2] = ["x", "depth"];

/// A survey as a file.
#[derive(Debug)]
pub(super) struct Survey {
    pub(super) name: String,
    pub(super) text: String,
}

/// A field of a row: its text, trimmed, and where it is.
pub(super) type Field<'a> = (&'a str, Span);

/// How the rows of a file are written.
#[derive(Debug, Clone, Copy)]
pub(super) struct Layout {
    separator: char,
    decimal_comma: bool,
}

impl Layout {
    /// The fields of a row that starts at byte `start` of its file.
    pub(super) fn fields(self, row: &str, start: usize) -> impl Iterator<Item = Field<'_>> {
        pieces(row, self.separator, start)
    }

    /// A finite number. `1e999` parses as infinity, `nan` and `inf` as what they say: none of them is a level or a force.
    fn number(self, text: &str) -> Option<f64> {
        let number = match self.decimal_comma {
            true if text.contains('.') => return None,
            true => text.replace(',', ".").parse::<f64>(),
            false => text.parse::<f64>(),
        };
        number.ok().filter(|number| number.is_finite())
    }
}

impl Survey {
    /// The points, as many as the file has: whether they make a polyline is for the scene to judge.
    pub(super) fn points(&self) -> Result<Vec<[f64; 2]>, Box<FileError>> {
        let (layout, mut rows) = (self.layout(), self.rows());
        let Some((header, span)) = rows.next() else {
            return Err(self.error(0..0, Problem::SurveyWithoutHeader));
        };
        if !layout.fields(header, span.start).map(|(name, _)| name).eq(FIELDS) {
            return Err(self.error(span, Problem::SurveyHeader { found: Found::of(header) }));
        }
        rows.map(|(row, span)| self.point(layout, row, span)).collect()
    }

    fn point(&self, layout: Layout, row: &str, span: Span) -> Result<[f64; 2], Box<FileError>> {
        let mut given = layout.fields(row, span.start);
        let (Some(x), Some(depth), None) = (given.next(), given.next(), given.next()) else {
            let found = layout.fields(row, span.start).count();
            return Err(self.error(span, Problem::SurveyFields { found }));
        };
        Ok([self.number(layout, FIELDS[0], x)?, self.number(layout, FIELDS[1], depth)?])
    }

    /// The layout of the file: `;` parts its fields if it does so in the header, and then commas are decimal.
    pub(super) fn layout(&self) -> Layout {
        let semicolon = self.rows().next().is_some_and(|(header, _)| header.contains(';'));
        let decimal_comma = semicolon && self.rows().skip(1).any(|(row, _)| row.contains(','));
        Layout { separator: if semicolon { ';' } else { ',' }, decimal_comma }
    }

    pub(super) fn number(
        &self,
        layout: Layout,
        quantity: &'static str,
        (text, span): Field<'_>,
    ) -> Result<f64, Box<FileError>> {
        let wrong = || {
            let found = Found::of(text);
            let problem = if layout.decimal_comma && text.contains('.') {
                Problem::BothDecimalMarks { quantity, found }
            } else {
                Problem::SurveyNumber { quantity, found }
            };
            self.error(span.clone(), problem)
        };
        layout.number(text).ok_or_else(wrong)
    }

    /// Name and place of coordinate `axis` of point `index`.
    pub(super) fn place(&self, index: usize, axis: usize) -> (&'static str, Span) {
        let end = self.text.len();
        let (layout, row) = (self.layout(), self.rows().nth(index + 1));
        let field = row.and_then(|(row, span)| layout.fields(row, span.start).nth(axis));
        (FIELDS[axis], field.map_or(end..end, |(_, span)| span))
    }

    /// Where the points end.
    pub(super) fn last_row(&self) -> Span {
        self.rows().last().map_or(0..0, |(_, span)| span)
    }

    /// The lines that say something, trimmed, with their places; the first is the header.
    pub(super) fn rows(&self) -> impl Iterator<Item = Field<'_>> {
        // U+FEFF, the byte order mark, is no white space to `trim`.
        let start = if self.text.starts_with('\u{feff}') { '\u{feff}'.len_utf8() } else { 0 };
        pieces(&self.text[start..], '\n', start).filter(|(line, _)| !line.is_empty() && !line.starts_with('#'))
    }

    pub(super) fn error(&self, span: Span, problem: Problem) -> Box<FileError> {
        Source { name: &self.name, text: &self.text }.error(span, problem)
    }
}

/// The text, if there is memory for its points.
pub(super) fn with_memory(text: String) -> Result<String, ReadProblem> {
    /// For each row while a scene is made: some four times its point.
    const BYTES_PER_ROW: usize = 64;
    if can_be_had(text.matches('\n').count(), BYTES_PER_ROW) {
        return Ok(text);
    }
    Err(ReadProblem::Refused { reason: "out of memory".to_owned() })
}

/// Pieces of a text that starts at byte `start` of its file, trimmed.
fn pieces(text: &str, separator: char, start: usize) -> impl Iterator<Item = Field<'_>> {
    text.split(separator).scan(start, move |next, piece| {
        let at = *next + (piece.len() - piece.trim_start().len());
        *next += piece.len() + separator.len_utf8();
        let piece = piece.trim();
        Some((piece, at..at + piece.len()))
    })
}

/// The survey `path` as messages call it: beside the scene file `scene`, where it is looked for.
pub(super) fn beside(scene: &str, path: &str) -> String {
    Path::new(scene).parent().map_or_else(|| path.to_owned(), |folder| folder.join(path).display().to_string())
}
