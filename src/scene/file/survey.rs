//! A CSV table with the location of each field. A survey is such a table, either with the header `x,depth` and one point per row,
//! or with columns that the scene file [declares](super::columns).
//!
//! Blank lines and lines that start with `#` are skipped, and spaces around a field are trimmed. Fields may be quoted. A byte
//! order mark and the line ends of Windows and of old Macs are accepted. A CSV library would give only the location of a row, but
//! messages need the location of a field.
//!
//! Spreadsheets with decimal commas separate the fields by `;` and may declare this in a first line `sep=;`, or they quote the
//! fields. A file has only one decimal mark, because a point next to decimal commas could separate thousands.

use std::cell::Cell;
use std::path::Path;

use super::columns::{Columns, Named};
use super::reader::{Decimal, Reader, on_beam};
use super::survey_problem::{Declaration, SurveyProblem};
use super::table::Span;
use super::{FileError, Found, Problem, ReadProblem, Source};
use crate::memory::can_be_had;

const FIELDS: [&str; 2] = ["x", "depth"];

/// Possible field separators in order of preference; a comma may also be a decimal mark.
const SEPARATORS: [char; 3] = [';', '\t', ','];

/// A table in a file.
#[derive(Debug)]
pub(super) struct Survey {
    pub(super) name: String,
    pub(super) text: String,
    /// The name of the file in the scene file.
    path: String,
    /// The declared columns, if there is a declaration.
    columns: Option<Columns>,
    /// The number of points that were removed at the left end because they are beyond the beam.
    left_out: usize,
}

/// A field of a row: its text, trimmed and without quotes, and its location.
pub(super) type Field<'a> = (&'a str, Span);

/// The format of the rows of a file.
#[derive(Debug)]
pub(super) struct Layout {
    pub(super) separator: char,
    /// The decimal mark, once a number has shown it.
    mark: Cell<Option<char>>,
}

impl Layout {
    pub(super) fn of(separator: char) -> Self {
        Self { separator, mark: Cell::new(None) }
    }

    /// The fields of a row that starts at byte `start` of its file.
    pub(super) fn fields<'a>(&self, row: &'a str, start: usize) -> impl Iterator<Item = Field<'a>> {
        Fields { row, start, next: Some(0), separator: self.separator }
    }

    /// Parses a finite number. The error is the decimal mark of the other numbers if this one uses another mark. `1e999`, which
    /// parses as infinity, and `nan` and `inf` are rejected: none of them is a level or a force.
    pub(super) fn number(&self, text: &str) -> Result<Decimal, Option<char>> {
        let mark = text.bytes().position(|byte| matches!(byte, b'.' | b','));
        let mark = mark.map(|at| (at, char::from(text.as_bytes()[at])));
        let number = match mark {
            Some((_, ',')) => text.replacen(',', ".", 1).parse::<f64>(),
            _ => text.parse::<f64>(),
        };
        let value = number.ok().filter(|number| number.is_finite()).ok_or(None)?;
        let Some((at, mark)) = mark else { return Ok(Decimal { value, places: Some(0) }) };
        match self.mark.replace(Some(mark)) {
            Some(other) if other != mark => {
                self.mark.set(Some(other));
                Err(Some(other))
            }
            _ => {
                let places = &text[at + 1..];
                let is_plain = places.bytes().all(|byte| byte.is_ascii_digit());
                Ok(Decimal { value, places: is_plain.then_some(places.len()) })
            }
        }
    }
}

impl Survey {
    /// A table without declared columns.
    pub(super) fn new(name: String, text: String) -> Self {
        Self { name, text, path: String::new(), columns: None, left_out: 0 }
    }

    /// The survey that the scene file `scene` names.
    pub(super) fn named(scene: &str, Named { path, columns, .. }: Named, text: String) -> Self {
        Self { name: beside(scene, &path), text, path, columns, left_out: 0 }
    }

    /// The points on a beam of the given length.
    pub(super) fn points_on_beam(&mut self, length: f64) -> Result<Vec<[f64; 2]>, Box<FileError>> {
        let is_cut = self.columns.as_ref().is_some_and(|columns| columns.origin.is_some());
        let (points, left_out) = on_beam(self.points()?, length, is_cut);
        self.left_out = left_out;
        Ok(points)
    }

    /// All points of the file. Whether they form a valid polyline is checked by the scene.
    fn points(&self) -> Result<Vec<[f64; 2]>, Box<FileError>> {
        if let Some(columns) = &self.columns {
            return Reader::of(self, columns)?.points();
        }
        let (layout, mut rows) = (self.layout(), self.rows());
        let Some((header, span)) = rows.next() else {
            return Err(self.error(0..0, SurveyProblem::WithoutHeader.into()));
        };
        if !layout.fields(header, span.start).map(|(name, _)| name).eq(FIELDS) {
            let declare = Some(Declaration { file: self.path.clone(), columns: self.names(header) });
            return Err(self.error(span, SurveyProblem::Header { found: Found::of(header), declare }.into()));
        }
        rows.map(|(row, span)| self.point(&layout, row, span)).collect()
    }

    fn point(&self, layout: &Layout, row: &str, span: Span) -> Result<[f64; 2], Box<FileError>> {
        let mut given = layout.fields(row, span.start);
        let (Some(x), Some(depth), None) = (given.next(), given.next(), given.next()) else {
            let found = layout.fields(row, span.start).count();
            return Err(self.error(span, SurveyProblem::Fields { found }.into()));
        };
        Ok([self.number(layout, FIELDS[0], x)?, self.number(layout, FIELDS[1], depth)?])
    }

    /// The layout of the file, derived from its first row.
    pub(super) fn layout(&self) -> Layout {
        Layout::of(self.separator(self.rows().next().map_or("", |(header, _)| header)))
    }

    /// The separator of the fields if `first` is the first row.
    pub(super) fn separator(&self, first: &str) -> char {
        let separators = self.separators();
        let used = separators.iter().find(|separator| 1 < Layout::of(**separator).fields(first, 0).count());
        used.or(separators.last()).copied().unwrap_or(',')
    }

    /// The possible field separators; only the declared one if the first line is `sep=;` or similar.
    pub(super) fn separators(&self) -> Vec<char> {
        self.begin().1.map_or_else(|| SEPARATORS.to_vec(), |separator| vec![separator])
    }

    /// The column names in a row, if it is the header.
    pub(super) fn names(&self, header: &str) -> Vec<String> {
        Layout::of(self.separator(header)).fields(header, 0).map(|(name, _)| name.to_owned()).collect()
    }

    pub(super) fn number(
        &self,
        layout: &Layout,
        quantity: &'static str,
        field: Field<'_>,
    ) -> Result<f64, Box<FileError>> {
        self.decimal(layout, quantity, field).map(|number| number.value)
    }

    pub(super) fn decimal(
        &self,
        layout: &Layout,
        quantity: &'static str,
        (text, span): Field<'_>,
    ) -> Result<Decimal, Box<FileError>> {
        layout.number(text).map_err(|other| {
            let found = Found::of(text);
            let problem = match other {
                Some(mark) => Problem::BothDecimalMarks { quantity, found, mark },
                None => Problem::SurveyNumber { quantity, found },
            };
            self.error(span, problem)
        })
    }

    /// Name and location of coordinate `axis` of point `index`.
    pub(super) fn place(&self, index: usize, axis: usize) -> (&'static str, Span) {
        let end = self.text.len()..self.text.len();
        let Some(columns) = &self.columns else {
            let (layout, row) = (self.layout(), self.rows().nth(index + 1));
            let field = row.and_then(|(row, span)| layout.fields(row, span.start).nth(axis));
            return (FIELDS[axis], field.map_or(end, |(_, span)| span));
        };
        let rows = Reader::of(self, columns).map(|reader| reader.places()).unwrap_or_default();
        let field = rows.get(self.left_out + index).map(|(fields, _)| fields[axis].1.clone());
        (["x", columns.quantity()][axis], field.unwrap_or(end))
    }

    /// The location of the last row.
    pub(super) fn last_row(&self) -> Span {
        if let Some(columns) = &self.columns {
            let rows = Reader::of(self, columns).map(|reader| reader.places()).unwrap_or_default();
            return rows.last().map_or(0..0, |(_, whole)| whole.clone());
        }
        self.rows().last().map_or(0..0, |(_, span)| span)
    }

    /// The rows with content, trimmed and with their locations; the first is the header.
    pub(super) fn rows(&self) -> impl Iterator<Item = Field<'_>> {
        let (mut next, end) = (self.begin().0, line_end(&self.text));
        std::iter::from_fn(move || {
            let rest = self.text.get(next..)?;
            let length = position(rest, end).unwrap_or(rest.len());
            let (line, begin) = (&rest[..length], next);
            next = begin + length + end.len_utf8();
            let bare = line.trim_start_matches(BLANKS);
            let at = begin + (line.len() - bare.len());
            Some((bare.trim_end_matches(BLANKS), at))
        })
        .filter(|(line, _)| !matches!(line.trim_start().bytes().next(), None | Some(b'#')))
        .map(|(line, at)| (line, at..at + line.len()))
    }

    /// The start of the rows, and the separator that a first line `sep=` declares.
    fn begin(&self) -> (usize, Option<char>) {
        // `trim` does not treat U+FEFF, the byte order mark, as white space.
        let start = if self.text.starts_with('\u{feff}') { '\u{feff}'.len_utf8() } else { 0 };
        let line = self.text[start..].split(line_end(&self.text)).next().unwrap_or_default();
        let mut rest = line.get(..4).filter(|key| key.eq_ignore_ascii_case("sep=")).map_or("", |_| &line[4..]).chars();
        match (rest.next(), rest.as_str().trim()) {
            (Some(separator), "") if separator != '\r' => {
                ((start + line.len() + 1).min(self.text.len()), Some(separator))
            }
            _ => (start, None),
        }
    }

    pub(super) fn error(&self, span: Span, problem: Problem) -> Box<FileError> {
        Source { name: &self.name, text: &self.text }.error(span, problem)
    }
}

/// Trimmed around a row; a tab may be a field separator.
const BLANKS: [char; 2] = [' ', '\r'];

/// The line end: `\n`, or `\r` in a file of old Macs, which contains no `\n`.
pub(super) fn line_end(text: &str) -> char {
    if text.contains('\n') || !text.contains('\r') { '\n' } else { '\r' }
}

/// The index of the first occurrence of a character. Rows and fields are short, and a search by bytes is faster for them than an
/// algorithm for long texts.
fn position(text: &str, wanted: char) -> Option<usize> {
    let mut encoded = [0; 4];
    match wanted.encode_utf8(&mut encoded).as_bytes() {
        [byte] => text.bytes().position(|b| b == *byte),
        _ => text.find(wanted),
    }
}

/// A text without surrounding white space.
fn trimmed(text: &str) -> &str {
    let is_bare = |byte: Option<&u8>| byte.is_some_and(u8::is_ascii_graphic);
    if is_bare(text.as_bytes().first()) && is_bare(text.as_bytes().last()) { text } else { text.trim() }
}

/// The fields of a row.
struct Fields<'a> {
    row: &'a str,
    start: usize,
    /// Start of the next field; [`None`] at the end.
    next: Option<usize>,
    separator: char,
}

impl<'a> Iterator for Fields<'a> {
    type Item = Field<'a>;

    fn next(&mut self) -> Option<Field<'a>> {
        let begin = self.next?;
        let rest = &self.row[begin..];
        let quoted = quoted(rest);
        let end = begin + quoted + position(&rest[quoted..], self.separator).unwrap_or(rest.len() - quoted);
        self.next = (end < self.row.len()).then_some(end + self.separator.len_utf8());
        let field = &self.row[begin..end];
        let text = trimmed(field);
        let at = begin + if text.len() == field.len() { 0 } else { field.len() - field.trim_start().len() };
        let inside = text.strip_prefix('"').and_then(|text| text.strip_suffix('"')).filter(|_| 0 < quoted);
        let (text, at) = inside.map_or((text, at), |inside| {
            (inside.trim(), at + '"'.len_utf8() + inside.len() - inside.trim_start().len())
        });
        Some((text, self.start + at..self.start + at + text.len()))
    }
}

/// The length in bytes of the quoted part at the beginning of a text; two quotes inside it stand for one.
fn quoted(text: &str) -> usize {
    let blank = text.len() - text.trim_start_matches(' ').len();
    let bytes = text.as_bytes();
    if bytes.get(blank) != Some(&b'"') {
        return 0;
    }
    let mut at = blank + 1;
    while let Some(quote) = text[at..].find('"') {
        at += quote + 1;
        if bytes.get(at) != Some(&b'"') {
            return at;
        }
        at += 1;
    }
    text.len()
}

/// Returns the text if there is enough memory for its points.
pub(super) fn with_memory(text: String) -> Result<String, ReadProblem> {
    /// Memory per row while a scene is created: about four times the memory of a point.
    const BYTES_PER_ROW: usize = 64;
    let end = line_end(&text);
    if can_be_had(text.bytes().filter(|byte| char::from(*byte) == end).count(), BYTES_PER_ROW) {
        return Ok(text);
    }
    Err(ReadProblem::Refused { reason: "out of memory".to_owned() })
}

/// The path of a survey in messages: relative to the folder of the scene file `scene`, where it is read.
pub(super) fn beside(scene: &str, path: &str) -> String {
    Path::new(scene).parent().map_or_else(|| path.to_owned(), |folder| folder.join(path).display().to_string())
}
