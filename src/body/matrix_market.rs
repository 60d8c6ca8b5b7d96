//! Reads symmetric matrices from Matrix Market files line by line; only the numbers are kept.
//!
//! Supported are `coordinate` and `array`, `real` (also `integer` and `double`), and `symmetric` and `general`. A general matrix
//! must be symmetric within rounding, and the mean of its two triangles is used (Boisvert, Pozo and Remington 1996).
//!
//! A file without the banner has rows of `row column value`, as CalculiX writes `.sti`, or of
//! `node, freedom, node, freedom, value`, as Abaqus does for `*MATRIX OUTPUT`. It is one triangle unless some entry is given on
//! both sides of the diagonal. Degrees of freedom are numbered by node, then by freedom.

mod fields;

use std::collections::BTreeMap;
use std::ops::Range;

use self::fields::{fields, finite, label, pieces, real, row, whole};
use super::BodyProblem;
use crate::memory::can_be_had;
use crate::qp::Profile;
use crate::scene::file::Found;

/// Limit for the stored values, from the first entry of each row to the diagonal: 128 MB, the same again for each factor, and
/// minutes to solve if the matrix is full.
pub const MOST_NUMBERS: usize = 1 << 24;

/// Greatest difference of two entries that should be equal, relative to `√(a_ii a_jj)`: programs print about ten digits.
const SYMMETRIC: f64 = 1e-10;

/// Limit for the number of rows: more than fit into any memory, and few enough for counts in 64 bits.
const MOST_ROWS: usize = u32::MAX as usize;

/// First characters of lines that are skipped: comments of Matrix Market, of tables and of Abaqus, and Abaqus keywords.
const COMMENTS: [char; 3] = ['%', '#', '*'];

/// An error in a matrix, with its location.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Wrong {
    /// Line, from 1.
    pub(crate) line: usize,
    /// The line. For an entry that is reported later, a text built from its numbers.
    pub(crate) text: String,
    /// The bytes of the line to which the error refers.
    pub(crate) marked: Range<usize>,
    /// The error.
    pub(crate) problem: BodyProblem,
}

/// The bytes of a line, and the error in them.
type Mark = (Range<usize>, BodyProblem);

/// An entry of the file, with its position on or below the diagonal.
#[derive(Debug, Clone, Copy)]
struct Entry {
    place: [usize; 2],
    above: bool,
    line: usize,
    value: f64,
}

/// The layout of a file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Form {
    /// Banner and size, then positions with values, or only values by columns; one triangle or both.
    Market { coordinate: bool, symmetric: bool },
    /// Row, column and value in each line.
    Columns,
    /// Node, freedom, node, freedom and value in each line.
    Labels,
}

/// A matrix that is being read.
#[derive(Debug, Default)]
pub(crate) struct Reader {
    sums_duplicates: bool,
    line: usize,
    form: Option<Form>,
    /// Number of rows, and number of entries that a file with a size must have.
    size: Option<[usize; 2]>,
    count: usize,
    /// Position of the next entry of an array.
    next: [usize; 2],
    entries: Vec<Entry>,
    /// The row of each pair of node and freedom, in order of first occurrence.
    labels: BTreeMap<[i64; 2], usize>,
}

impl Reader {
    /// A reader that adds duplicate entries, or rejects them.
    #[must_use]
    pub(crate) fn new(sums_duplicates: bool) -> Self {
        Self { sums_duplicates, ..Self::default() }
    }

    /// Reads one more line, without its line end.
    ///
    /// # Errors
    ///
    /// [`Wrong`].
    pub(crate) fn line(&mut self, text: &str) -> Result<(), Wrong> {
        self.line += 1;
        let text = text.trim_end();
        self.read(text).map_err(|(marked, problem)| Wrong { line: self.line, text: text.to_owned(), marked, problem })
    }

    fn read(&mut self, text: &str) -> Result<(), Mark> {
        let is_banner = text.starts_with('%') && text.to_lowercase().contains("matrixmarket");
        if self.form.is_none() && is_banner {
            self.form = Some(header(text)?);
            return Ok(());
        }
        if text.trim_start().is_empty() || text.starts_with(COMMENTS) {
            return Ok(());
        }
        let form = match self.form {
            Some(form) => form,
            None => *self.form.insert(form_of(text)?),
        };
        match form {
            Form::Market { coordinate, symmetric } => self.market(text, coordinate, symmetric),
            Form::Columns => {
                let [i, j, value] = fields(text, "three numbers: row, column and value")?;
                let place = [row("row", i)?, row("column", j)?];
                self.push(place, finite(value)?).map_err(|problem| (0..text.len(), problem))
            }
            Form::Labels => {
                let [node, freedom, other, its, value] =
                    fields(text, "five numbers: node, freedom, node, freedom and value")?;
                let place = [
                    [label("node", node)?, label("freedom", freedom)?],
                    [label("node", other)?, label("freedom", its)?],
                ];
                let place = place.map(|label| {
                    let next = self.labels.len();
                    *self.labels.entry(label).or_insert(next)
                });
                self.push(place, finite(value)?).map_err(|problem| (0..text.len(), problem))
            }
        }
    }

    /// Reads one more line below a banner.
    fn market(&mut self, text: &str, coordinate: bool, symmetric: bool) -> Result<(), Mark> {
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
        let value = finite(value)?;
        if expected <= self.count {
            let problem = BodyProblem::Entries { expected: expected.to_string(), found: self.count + 1 };
            return Err((0..text.len(), problem));
        }
        // All coordinates are kept, also of zeros, to find duplicates.
        if coordinate || value != 0.0 {
            return self.push([i, j], value).map_err(|problem| (0..text.len(), problem));
        }
        self.count += 1;
        Ok(())
    }

    fn push(&mut self, [i, j]: [usize; 2], value: f64) -> Result<(), BodyProblem> {
        self.count += 1;
        self.entries.push(Entry { place: [i.max(j), i.min(j)], above: i < j, line: self.line, value });
        // With a size this was checked before.
        if self.size.is_none() { affordable(self.count / 2) } else { Ok(()) }
    }

    /// The matrix, once all lines have been read; it may be indefinite.
    ///
    /// # Errors
    ///
    /// [`Wrong`].
    pub(crate) fn end(mut self) -> Result<Profile, Wrong> {
        let last = self.line.max(1);
        let at_end = |problem| Wrong { line: last, text: String::new(), marked: 0..0, problem };
        let symmetric = match self.form {
            None => return Err(at_end(BodyProblem::Header { found: Found::of("") })),
            Some(Form::Market { symmetric, .. }) => symmetric,
            Some(form) => {
                if form == Form::Columns {
                    self.without_size();
                }
                self.in_order_of_labels();
                let rows = self.entries.iter().map(|entry| entry.place[0] + 1).max().unwrap_or(0);
                self.size = Some([rows, 0]);
                false
            }
        };
        let [n, expected] = self.size.unwrap_or([0, usize::MAX]);
        // A row without entries has none on the diagonal either, and would need memory.
        if self.entries.len() < n && !matches!(self.form, Some(Form::Market { .. })) {
            return Err(at_end(BodyProblem::Entries { expected: format!("at least {n}"), found: self.entries.len() }));
        }
        if self.count < expected {
            let expected = self.size.map_or_else(|| "a size, and".to_owned(), |[_, expected]| expected.to_string());
            return Err(at_end(BodyProblem::Entries { expected, found: self.count }));
        }
        // Entries of the same position become neighbours, those below the diagonal first, in the order of the file.
        self.entries.sort_unstable_by_key(|entry| (entry.place, entry.above, entry.line));
        let mut entries = self.entries;
        if self.sums_duplicates {
            entries = summed(&entries);
        }
        let symmetric = symmetric || !matches!(self.form, Some(Form::Market { .. })) && !has_both_triangles(&entries);
        let lower = lower_triangle(&entries, n, symmetric)?;
        let mut first: Vec<usize> = (0..n).collect();
        lower.iter().for_each(|(i, j, _)| first[*i] = first[*i].min(*j));
        let numbers = first.iter().enumerate().map(|(i, first)| i + 1 - first).sum();
        affordable(numbers).map_err(at_end)?;
        Ok(Profile::of_entries(n, lower.into_iter()))
    }

    /// Removes the size with which a file without banner may begin: twice the number of rows, and the number of lines that
    /// follow. It is a size if the last diagonal entry occurs again among these lines.
    fn without_size(&mut self) {
        if let Some((first, rest)) = self.entries.split_first() {
            #[expect(clippy::cast_precision_loss, reason = "a count of lines")]
            let is_size = first.place[0] == first.place[1] && first.value.to_bits() == (rest.len() as f64).to_bits();
            let last = rest.iter().map(|entry| entry.place).max();
            if is_size && last == Some(first.place) {
                self.entries.remove(0);
            }
        }
    }

    /// Numbers the rows in the order of nodes and freedoms, if the file has them.
    fn in_order_of_labels(&mut self) {
        if self.labels.is_empty() {
            return;
        }
        let mut rows = vec![0; self.labels.len()];
        self.labels.values().enumerate().for_each(|(row, met)| rows[*met] = row);
        for entry in &mut self.entries {
            let [i, j] = entry.place.map(|met| rows[met]);
            let above = if entry.above { j < i } else { i < j };
            (entry.place, entry.above) = ([i.max(j), i.min(j)], above && i != j);
        }
    }
}

/// Adds the entries of each position and triangle.
fn summed(entries: &[Entry]) -> Vec<Entry> {
    let same = |a: &Entry, b: &Entry| (a.place, a.above) == (b.place, b.above);
    let sum = |group: &[Entry]| Entry { value: group.iter().map(|entry| entry.value).sum(), ..group[0] };
    entries.chunk_by(same).map(sum).collect()
}

/// Whether an off-diagonal entry is given on both sides of the diagonal.
fn has_both_triangles(entries: &[Entry]) -> bool {
    entries.windows(2).any(|pair| pair[0].place == pair[1].place && pair[0].above != pair[1].above)
}

/// The entries on or below the diagonal, one for each position.
fn lower_triangle(entries: &[Entry], n: usize, symmetric: bool) -> Result<Vec<(usize, usize, f64)>, Wrong> {
    let mut roots = vec![0.0; n];
    for Entry { place: [i, j], value, .. } in entries {
        if i == j {
            roots[*i] = value.abs().sqrt();
        }
    }
    let mut lower = Vec::with_capacity(entries.len());
    for pair in entries.chunk_by(|a, b| a.place == b.place) {
        let Entry { place: [i, j], value: here, .. } = pair[0];
        let there = match pair {
            [_] if symmetric || i == j => here,
            [_] => 0.0,
            [one, other] if !symmetric && one.above != other.above => other.value,
            [one, .., again] => {
                let (early, late) = if one.line < again.line { (one, again) } else { (again, one) };
                return Err(late.wrong(|i, j| BodyProblem::Twice { i, j, line: early.line }));
            }
            [] => continue,
        };
        if SYMMETRIC * roots[i] * roots[j] < (here - there).abs() {
            return Err(pair[0].wrong(|i, j| BodyProblem::NotSymmetric { i, j, here, there }));
        }
        lower.push((i, j, here + 0.5 * (there - here)));
    }
    Ok(lower)
}

impl Entry {
    /// An error that concerns an entry read before.
    fn wrong(&self, problem: impl Fn(usize, usize) -> BodyProblem) -> Wrong {
        let [i, j] = self.place.map(|index| index + 1);
        let [i, j] = if self.above { [j, i] } else { [i, j] };
        let text = format!("{i} {j} {:?}", self.value);
        Wrong { line: self.line, marked: 0..text.len(), text, problem: problem(i, j) }
    }
}

/// Returns an error if there are too many numbers.
fn affordable(numbers: usize) -> Result<(), BodyProblem> {
    let fits = numbers <= MOST_NUMBERS && can_be_had(numbers, 4 * size_of::<f64>());
    if fits { Ok(()) } else { Err(BodyProblem::TooLarge { numbers, most: MOST_NUMBERS }) }
}

fn header(text: &str) -> Result<Form, Mark> {
    let words = text.to_lowercase();
    match words.split_whitespace().collect::<Vec<_>>()[..] {
        ["%%matrixmarket", "matrix", form, "real" | "integer" | "double", kind]
            if ["coordinate", "array"].contains(&form) && ["symmetric", "general"].contains(&kind) =>
        {
            Ok(Form::Market { coordinate: form == "coordinate", symmetric: kind == "symmetric" })
        }
        _ => Err((0..text.len(), BodyProblem::Header { found: Found::of(text) })),
    }
}

/// The layout of a file without banner, determined from its first line.
fn form_of(text: &str) -> Result<Form, Mark> {
    let is_number = |field: &str| real(field).is_some();
    match pieces(text).map(|(field, _)| is_number(field)).collect::<Vec<_>>()[..] {
        [true, true, true] => Ok(Form::Columns),
        [true, true, true, true, true] => Ok(Form::Labels),
        _ => Err((0..text.len(), BodyProblem::Header { found: Found::of(text) })),
    }
}

fn size(text: &str, coordinate: bool, symmetric: bool) -> Result<[usize; 2], Mark> {
    let whole_line = |problem| Err((0..text.len(), problem));
    let (rows, columns, entries) = if coordinate {
        let [n, m, entries] = fields(text, "three numbers: rows, columns and entries")?;
        (n, m, Some(whole("entries", entries, 0, usize::MAX)?))
    } else {
        let [n, m] = fields(text, "two numbers: rows and columns")?;
        (n, m, None)
    };
    let (rows, columns) = (whole("rows", rows, 1, MOST_ROWS)?, whole("columns", columns, 1, MOST_ROWS)?);
    let of_array = if symmetric { rows.saturating_mul(rows + 1) / 2 } else { rows.saturating_mul(rows) };
    let entries = entries.unwrap_or(of_array);
    if rows != columns {
        return whole_line(BodyProblem::NotSquare { rows, columns });
    }
    // The diagonal alone has this many entries.
    if entries < rows {
        return whole_line(BodyProblem::Entries { expected: format!("at least {rows}"), found: entries });
    }
    affordable(entries / 2).map_or_else(whole_line, |()| Ok([rows, entries]))
}
