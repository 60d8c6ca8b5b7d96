//! Symmetric matrices in Matrix Market files, line by line: nothing but the numbers is kept.
//!
//! `coordinate` or `array`, `real` (or `integer`, `double`), `symmetric` or `general`. A general matrix has to be symmetric up to rounding; it
//! stands for the mean of its two triangles. See Boisvert, Pozo and Remington, "The Matrix Market exchange formats", NISTIR 5935 (1996).

use std::ops::Range;

use super::BodyProblem;
use crate::memory::can_be_had;
use crate::qp::{NotPositiveDefinite, Profile};

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

/// An entry that was read.
#[derive(Debug, Clone, Copy)]
struct Entry {
    place: [u32; 2],
    line: usize,
    value: f64,
}

/// A matrix as far as it has been read.
#[derive(Debug, Default)]
pub struct Reader {
    line: usize,
    /// Whether there are places, and whether there is one triangle.
    form: Option<[bool; 2]>,
    /// Rows, and entries that the file must have.
    size: Option<[usize; 2]>,
    /// Entries that were read, zeros of arrays included.
    count: usize,
    /// Place of the next entry of an array.
    next: [u32; 2],
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
        let Some([coordinate, symmetric]) = self.form else {
            self.form = Some(self.header(text)?);
            return Ok(());
        };
        if text.trim_start().is_empty() || text.starts_with('%') {
            return Ok(());
        }
        match self.size {
            None => self.size = Some(self.size(text, coordinate, symmetric)?),
            Some([_, expected]) if expected <= self.count => {
                return Err(self.wrong(
                    text,
                    0..text.len(),
                    BodyProblem::Entries { expected: expected.to_string(), found: self.count + 1 },
                ));
            }
            Some([n, _]) => {
                let (place, value) = if coordinate {
                    let [i, j, a] = self.fields(text, "three numbers: row, column and value")?;
                    ([self.index(text, "row", i, n)?, self.index(text, "column", j, n)?], self.value(text, a)?)
                } else {
                    let [a] = self.fields(text, "one number")?;
                    (self.next_place(n, symmetric), self.value(text, a)?)
                };
                self.count += 1;
                // Coordinates are kept, zero or not, to find those that are there twice.
                if coordinate || value != 0.0 {
                    self.entries.push(Entry { place, line: self.line, value });
                }
            }
        }
        Ok(())
    }

    fn wrong(&self, text: &str, marked: Range<usize>, problem: BodyProblem) -> Wrong {
        Wrong { line: self.line, text: text.to_owned(), marked, problem }
    }

    fn header(&self, text: &str) -> Result<[bool; 2], Wrong> {
        let words: Vec<String> = text.split_whitespace().map(str::to_lowercase).collect();
        match words.iter().map(String::as_str).collect::<Vec<_>>()[..] {
            [
                "%%matrixmarket",
                "matrix",
                form @ ("coordinate" | "array"),
                "real" | "integer" | "double",
                kind @ ("symmetric" | "general"),
            ] => Ok([form == "coordinate", kind == "symmetric"]),
            _ => {
                let found = text.chars().take(60).collect();
                Err(self.wrong(text, 0..text.len(), BodyProblem::Header { found }))
            }
        }
    }

    /// So many fields with their places in the line.
    fn fields<'a, const N: usize>(
        &self,
        text: &'a str,
        expected: &'static str,
    ) -> Result<[(&'a str, Range<usize>); N], Wrong> {
        let place = |field: &'a str| {
            let start = field.as_ptr() as usize - text.as_ptr() as usize;
            (field, start..start + field.len())
        };
        let mut fields = text.split_ascii_whitespace();
        let found: Vec<_> = fields.by_ref().take(N).map(place).collect();
        let rest = fields.count();
        let many = found.len() + rest;
        match found.try_into() {
            Ok(found) if rest == 0 => Ok(found),
            _ => Err(self.wrong(text, 0..text.len(), BodyProblem::Fields { expected, found: many })),
        }
    }

    /// A whole number up to a limit.
    fn whole(
        &self,
        text: &str,
        quantity: &'static str,
        (field, place): (&str, Range<usize>),
        range: std::ops::RangeInclusive<usize>,
    ) -> Result<usize, Wrong> {
        field.parse().ok().filter(|number| range.contains(number)).ok_or_else(|| {
            let expected = format!("a whole number from {} to {}", range.start(), range.end());
            let found = field.chars().take(60).collect();
            self.wrong(text, place, BodyProblem::Number { quantity, expected, found })
        })
    }

    fn index(&self, text: &str, quantity: &'static str, field: (&str, Range<usize>), n: usize) -> Result<u32, Wrong> {
        self.whole(text, quantity, field, 1..=n).map(|index| u32::try_from(index - 1).unwrap_or(u32::MAX))
    }

    fn value(&self, text: &str, (field, place): (&str, Range<usize>)) -> Result<f64, Wrong> {
        field.parse().ok().filter(|value: &f64| value.is_finite()).ok_or_else(|| {
            let (expected, found) = ("a finite number".to_owned(), field.chars().take(60).collect());
            self.wrong(text, place, BodyProblem::Number { quantity: "value", expected, found })
        })
    }

    fn size(&self, text: &str, coordinate: bool, symmetric: bool) -> Result<[usize; 2], Wrong> {
        const MOST: usize = u32::MAX as usize;
        let [rows, columns, entries] = if coordinate {
            let [n, m, entries] = self.fields(text, "three numbers: rows, columns and entries")?;
            [
                self.whole(text, "rows", n, 1..=MOST)?,
                self.whole(text, "columns", m, 1..=MOST)?,
                self.whole(text, "entries", entries, 0..=usize::MAX)?,
            ]
        } else {
            let [n, m] = self.fields(text, "two numbers: rows and columns")?;
            let [n, m] = [self.whole(text, "rows", n, 1..=MOST)?, self.whole(text, "columns", m, 1..=MOST)?];
            [n, m, if symmetric { n.saturating_mul(n + 1) / 2 } else { n.saturating_mul(n) }]
        };
        if rows != columns {
            return Err(self.wrong(text, 0..text.len(), BodyProblem::NotSquare { rows, columns }));
        }
        if entries < rows {
            // Its diagonal alone has as many.
            let expected = format!("at least {rows}");
            return Err(self.wrong(text, 0..text.len(), BodyProblem::Entries { expected, found: entries }));
        }
        Ok([rows, entries])
    }

    /// Arrays go by columns, from the top or from the diagonal.
    fn next_place(&mut self, n: usize, symmetric: bool) -> [u32; 2] {
        let [i, j] = self.next;
        let in_column = usize::try_from(i).is_ok_and(|i| i + 1 < n);
        self.next = if in_column { [i + 1, j] } else { [if symmetric { j + 1 } else { 0 }, j + 1] };
        [i, j]
    }

    /// The matrix, when there are no more lines.
    ///
    /// # Errors
    ///
    /// [`Wrong`]; a matrix that is not positive definite is none yet.
    pub fn end(mut self) -> Result<Profile, Wrong> {
        let missing = |expected: String| self.wrong("", 0..0, BodyProblem::Entries { expected, found: self.count });
        let Some(([_, symmetric], [n, expected])) = self.form.zip(self.size) else {
            return Err(match self.form {
                None => self.wrong("", 0..0, BodyProblem::Header { found: String::new() }),
                Some(_) => missing("its size and its".to_owned()),
            });
        };
        if self.count < expected {
            return Err(missing(expected.to_string()));
        }
        // Both entries of a pair beside each other, in the order of the file.
        self.entries.sort_unstable_by_key(|&Entry { place: [i, j], line, .. }| (i.max(j), i.min(j), line));
        let mut roots = vec![0.0; n];
        for entry in self.entries.iter().filter(|entry| entry.place[0] == entry.place[1]) {
            roots[entry.place[0] as usize] = entry.value.abs().sqrt();
        }
        let mut kept = 0;
        let mut next = 0;
        while next < self.entries.len() {
            let Entry { place: [i, j], value, .. } = self.entries[next];
            let pair = self.entries[next..].iter().take_while(|other| same_pair(other.place, [i, j])).count();
            let there =
                twin(&self.entries[next..next + pair], symmetric)?.unwrap_or(if symmetric { value } else { 0.0 });
            let there = if i == j { value } else { there };
            if SYMMETRIC * roots[i as usize] * roots[j as usize] < (value - there).abs() {
                let problem = BodyProblem::NotSymmetric { i: i as usize + 1, j: j as usize + 1, here: value, there };
                return Err(self.entries[next].wrong(problem));
            }
            self.entries[kept] =
                Entry { place: [i.max(j), i.min(j)], value: value + 0.5 * (there - value), ..self.entries[next] };
            kept += 1;
            next += pair;
        }
        self.entries.truncate(kept);
        let lower = self.entries.iter().map(|e| (e.place[0] as usize, e.place[1] as usize, e.value));
        let lower = lower.filter(|(i, j, value)| i == j || *value != 0.0);
        let numbers = numbers(n, lower.clone());
        if MOST_NUMBERS < numbers || !can_be_had(numbers, 4 * size_of::<f64>()) {
            return Err(self.wrong("", 0..0, BodyProblem::TooLarge { numbers, most: MOST_NUMBERS }));
        }
        Ok(Profile::of_entries(n, lower))
    }
}

impl Entry {
    /// What is wrong with an entry that was read before.
    fn wrong(&self, problem: BodyProblem) -> Wrong {
        let text = format!("{} {} {:?}", self.place[0] + 1, self.place[1] + 1, self.value);
        Wrong { line: self.line, marked: 0..text.len(), text, problem }
    }
}

fn same_pair([i, j]: [u32; 2], [k, l]: [u32; 2]) -> bool {
    (i, j) == (k, l) || (i, j) == (l, k)
}

/// The second entry of a pair, if it is there and may be.
fn twin(pair: &[Entry], symmetric: bool) -> Result<Option<f64>, Wrong> {
    let [first, others @ ..] = pair else { return Ok(None) };
    let [i, j] = first.place.map(|index| index as usize + 1);
    let again = others.iter().find(|other| other.place == first.place).or(others.get(1));
    match (again, others) {
        (Some(again), _) => {
            let before = pair.iter().find(|before| before.place == again.place).unwrap_or(first);
            let [i, j] = again.place.map(|index| index as usize + 1);
            Err(again.wrong(BodyProblem::Twice { i, j, line: before.line }))
        }
        (None, [other, ..]) if symmetric => {
            Err(other.wrong(BodyProblem::BothTriangles { i: j, j: i, line: first.line }))
        }
        (None, others) => Ok(others.first().map(|other| other.value)),
    }
}

/// What a profile of these entries stores.
fn numbers(n: usize, lower: impl Iterator<Item = (usize, usize, f64)>) -> usize {
    let mut first: Vec<usize> = (0..n).collect();
    lower.for_each(|(i, j, _)| first[i] = first[i].min(j));
    first.iter().enumerate().map(|(i, first)| i + 1 - first).sum()
}

impl BodyProblem {
    /// A pivot that is not positive.
    #[must_use]
    pub fn indefinite(error: NotPositiveDefinite) -> Self {
        Self::NotPositiveDefinite { pivot: error.index + 1, value: error.pivot }
    }
}
