//! Symmetric matrices in Matrix Market files, line by line: nothing but the numbers is kept.
//!
//! `coordinate` or `array`, `real` (or `integer`, `double`), `symmetric` or `general`. A general matrix has to be symmetric up to rounding;
//! it stands for the mean of its two triangles (Boisvert, Pozo and Remington 1996).

use std::ops::Range;
use std::str::FromStr;

use super::BodyProblem;
use crate::memory::can_be_had;
use crate::qp::Profile;
use crate::scene::file::Found;

/// Numbers from the first entry of each row to the diagonal, all together: 128 MB, as much for each factor, and minutes to solve if the
/// matrix is full.
pub const MOST_NUMBERS: usize = 1 << 24;

/// What two entries may be apart that should be the same, as a share of `√(a_ii a_jj)`: programs print some ten digits.
const SYMMETRIC: f64 = 1e-10;

/// What is wrong with a matrix, and where.
#[derive(Debug, Clone, PartialEq)]
pub struct Wrong {
    /// Line, from 1.
    pub line: usize,
    /// The line; as it was read, where it is met again later.
    pub text: String,
    /// Bytes of it that are meant.
    pub marked: Range<usize>,
    /// What is wrong.
    pub problem: BodyProblem,
}

/// Bytes of a line, and what is wrong with them.
type Mark = (Range<usize>, BodyProblem);

/// An entry that was read, by its place on or below the diagonal.
#[derive(Debug, Clone, Copy)]
struct Entry {
    place: [usize; 2],
    above: bool,
    line: usize,
    value: f64,
}

/// A matrix as far as it has been read.
#[derive(Debug, Default)]
pub struct Reader {
    line: usize,
    /// Whether places are given, and whether one triangle is.
    form: Option<[bool; 2]>,
    /// Rows, and entries that the file must have.
    size: Option<[usize; 2]>,
    count: usize,
    /// Place of the next entry of an array.
    next: [usize; 2],
    entries: Vec<Entry>,
}

impl Reader {
    /// One more line, without its end.
    ///
    /// # Errors
    ///
    /// [`Wrong`].
    pub fn line(&mut self, text: &str) -> Result<(), Wrong> {
        self.line += 1;
        let text = text.trim_end();
        self.read(text).map_err(|(marked, problem)| Wrong { line: self.line, text: text.to_owned(), marked, problem })
    }

    fn read(&mut self, text: &str) -> Result<(), Mark> {
        let Some([coordinate, symmetric]) = self.form else {
            self.form = Some(header(text)?);
            return Ok(());
        };
        if text.is_empty() || text.starts_with('%') {
            return Ok(());
        }
        let Some([n, expected]) = self.size else {
            self.size = Some(size(text, coordinate, symmetric)?);
            return Ok(());
        };
        let ([i, j], value) = if coordinate {
            let [i, j, value] = fields(text, "three numbers: row, column and value")?;
            ([whole("row", i, 1, n)? - 1, whole("column", j, 1, n)? - 1], value)
        } else {
            let [i, j] = self.next;
            // By columns, each from the top or from the diagonal.
            self.next = if i + 1 < n { [i + 1, j] } else { [if symmetric { j + 1 } else { 0 }, j + 1] };
            let [value] = fields(text, "one number")?;
            ([i, j], value)
        };
        let value = number("value", value, |value: &f64| value.is_finite(), || "a finite number".to_owned())?;
        self.count += 1;
        if expected < self.count {
            let problem = BodyProblem::Entries { expected: expected.to_string(), found: self.count };
            return Err((0..text.len(), problem));
        }
        // Coordinates are kept, zero or not, to find those that are there twice.
        if coordinate || value != 0.0 {
            self.entries.push(Entry { place: [i.max(j), i.min(j)], above: i < j, line: self.line, value });
        }
        Ok(())
    }

    /// The matrix, when there are no more lines; it need not be positive definite.
    ///
    /// # Errors
    ///
    /// [`Wrong`].
    pub fn end(mut self) -> Result<Profile, Wrong> {
        let last = self.line.max(1);
        let at_end = |problem| Wrong { line: last, text: String::new(), marked: 0..0, problem };
        let Some([_, symmetric]) = self.form else {
            return Err(at_end(BodyProblem::Header { found: Found::of("") }));
        };
        let [n, expected] = self.size.unwrap_or([0, usize::MAX]);
        if self.count < expected {
            let expected = self.size.map_or_else(|| "a size, and".to_owned(), |[_, expected]| expected.to_string());
            return Err(at_end(BodyProblem::Entries { expected, found: self.count }));
        }
        // The entries of a place beside each other, in the order of the file.
        self.entries.sort_unstable_by_key(|entry| (entry.place, entry.line));
        let (mut roots, mut first) = (vec![0.0; n], (0..n).collect::<Vec<_>>());
        for Entry { place: [i, j], value, .. } in &self.entries {
            first[*i] = first[*i].min(*j);
            if i == j {
                roots[*i] = value.abs().sqrt();
            }
        }
        let mut lower = Vec::with_capacity(self.entries.len());
        for pair in self.entries.chunk_by(|a, b| a.place == b.place) {
            let Entry { place: [i, j], value: here, .. } = pair[0];
            let there = match pair {
                [_] if symmetric || i == j => here,
                [_] => 0.0,
                [one, other] if !symmetric && one.above != other.above => other.value,
                [one, .., again] => return Err(again.wrong(|i, j| BodyProblem::Twice { i, j, line: one.line })),
                [] => continue,
            };
            if SYMMETRIC * roots[i] * roots[j] < (here - there).abs() {
                return Err(pair[0].wrong(|i, j| BodyProblem::NotSymmetric { i, j, here, there }));
            }
            lower.push((i, j, here + 0.5 * (there - here)));
        }
        let numbers = first.iter().enumerate().map(|(i, first)| i + 1 - first).sum();
        affordable(numbers).map_err(at_end)?;
        Ok(Profile::of_entries(n, lower.into_iter()))
    }
}

impl Entry {
    /// What is wrong with an entry that was read before.
    fn wrong(&self, problem: impl Fn(usize, usize) -> BodyProblem) -> Wrong {
        let [i, j] = self.place.map(|index| index + 1);
        let [i, j] = if self.above { [j, i] } else { [i, j] };
        let text = format!("{i} {j} {:?}", self.value);
        Wrong { line: self.line, marked: 0..text.len(), text, problem: problem(i, j) }
    }
}

/// An error if there are too many numbers.
fn affordable(numbers: usize) -> Result<(), BodyProblem> {
    let fits = numbers <= MOST_NUMBERS && can_be_had(numbers, 4 * size_of::<f64>());
    if fits { Ok(()) } else { Err(BodyProblem::TooLarge { numbers, most: MOST_NUMBERS }) }
}

fn header(text: &str) -> Result<[bool; 2], Mark> {
    let words = text.to_lowercase();
    match words.split_whitespace().collect::<Vec<_>>()[..] {
        ["%%matrixmarket", "matrix", form, "real" | "integer" | "double", kind]
            if ["coordinate", "array"].contains(&form) && ["symmetric", "general"].contains(&kind) =>
        {
            Ok([form == "coordinate", kind == "symmetric"])
        }
        _ => Err((0..text.len(), BodyProblem::Header { found: Found::of(text) })),
    }
}

fn size(text: &str, coordinate: bool, symmetric: bool) -> Result<[usize; 2], Mark> {
    /// More rows than any memory holds, and few enough for their numbers to be counted in 64 bits.
    const MOST: usize = u32::MAX as usize;
    let whole_line = |problem| Err((0..text.len(), problem));
    let (rows, columns, entries) = if coordinate {
        let [n, m, entries] = fields(text, "three numbers: rows, columns and entries")?;
        (n, m, Some(whole("entries", entries, 0, usize::MAX)?))
    } else {
        let [n, m] = fields(text, "two numbers: rows and columns")?;
        (n, m, None)
    };
    let (rows, columns) = (whole("rows", rows, 1, MOST)?, whole("columns", columns, 1, MOST)?);
    let of_array = if symmetric { rows.saturating_mul(rows + 1) / 2 } else { rows.saturating_mul(rows) };
    let entries = entries.unwrap_or(of_array);
    if rows != columns {
        return whole_line(BodyProblem::NotSquare { rows, columns });
    }
    // Its diagonal alone has as many.
    if entries < rows {
        return whole_line(BodyProblem::Entries { expected: format!("at least {rows}"), found: entries });
    }
    affordable(entries / 2).map_or_else(whole_line, |()| Ok([rows, entries]))
}

/// A field with its place in the line.
type Field<'a> = (&'a str, Range<usize>);

fn fields<'a, const N: usize>(text: &'a str, expected: &'static str) -> Result<[Field<'a>; N], Mark> {
    let place = |field: &'a str| {
        let start = field.as_ptr() as usize - text.as_ptr() as usize;
        (field, start..start + field.len())
    };
    let found: Vec<_> = text.split_ascii_whitespace().map(place).collect();
    found.try_into().map_err(|found: Vec<_>| (0..text.len(), BodyProblem::Fields { expected, found: found.len() }))
}

fn whole(quantity: &'static str, field: Field<'_>, least: usize, most: usize) -> Result<usize, Mark> {
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
