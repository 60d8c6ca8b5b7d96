//! Figures without curves: a map of verdicts, and bars with their values.

use super::axis::Axis;
use super::canvas::{Align, Canvas, TEXT, Type, text_width, wrapped};
use super::error::{PlotError, finite};
use super::figure::{MARGIN, TITLE_LINE, whole};
use super::number::{DIGITS, significant};
use super::palette::{Color, Dash};
use super::svg::{WIDTH, document};

/// What a cell says; its letter says it again for those who do not see the colour.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Tone {
    /// As it should be.
    Good,
    /// With a reservation.
    Fair,
    /// Not as it should be.
    Bad,
    /// Nothing to judge.
    Absent,
}

impl Tone {
    /// Colour and opacity of the cell.
    fn fill(self) -> (Color, f64) {
        match self {
            Self::Good => (Color::GREEN, 0.40),
            Self::Fair => (Color::ORANGE, 0.45),
            Self::Bad => (Color::VERMILLION, 0.60),
            Self::Absent => (Color::GRID, 0.60),
        }
    }
}

/// One cell of a map of verdicts.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Cell {
    /// Its colour.
    pub tone: Tone,
    /// A letter or a short word.
    pub text: String,
}

/// A row of a map: its name, and one cell for each column.
pub type Row<'a> = (&'a str, Vec<Cell>);

const LINE: f64 = 1.25 * TEXT;
const CELL: f64 = 76.0;
const SWATCH: f64 = 120.0;

/// Rows and columns of coloured, lettered cells; `legend` explains the letters.
///
/// # Errors
///
/// A [`PlotError`] if there is no row or no column, or a row does not have a cell for each column.
pub fn verdict_map(
    title: &str,
    description: &str,
    columns: &[&str],
    rows: &[Row<'_>],
    legend: &[(Cell, &str)],
) -> Result<String, PlotError> {
    if columns.is_empty() || rows.is_empty() {
        return Err(PlotError::Empty { what: "a map of verdicts" });
    }
    for (_, cells) in rows {
        if cells.len() != columns.len() {
            let (count, expected) = (cells.len(), columns.len());
            return Err(PlotError::LengthMismatch { what: "a row of verdicts", count, expected });
        }
    }
    let sheet = f64::from(WIDTH);
    let left = MARGIN + name_width(rows.iter().map(|row| row.0));
    let width = ((sheet - MARGIN - left) / count(columns.len())).min(420.0);
    // Names that do not fit above their columns run upwards.
    let longest = |names: &mut dyn Iterator<Item = &str>| {
        names.fold(0.0_f64, |most, name| most.max(text_width(name, Type::PLAIN)))
    };
    let turned = width - 16.0 < longest(&mut columns.iter().flat_map(|c| c.split_whitespace()));
    let headings: Vec<Vec<String>> = columns.iter().map(|c| wrapped(c, width - 16.0, Type::PLAIN)).collect();
    let heading = if turned {
        longest(&mut columns.iter().copied()) + 24.0
    } else {
        LINE * count(headings.iter().map(Vec::len).max().unwrap_or(0)) + 20.0
    };
    let top = Heading::of(title).height + heading;
    let below = top + CELL * count(rows.len()) + 50.0;
    let height = below + CELL * count(legend.len()) + MARGIN;
    document(title, description, whole(height), |canvas| {
        Heading::of(title).draw(canvas)?;
        for (j, lines) in headings.iter().enumerate() {
            let middle = left + width * (count(j) + 0.5);
            if turned {
                let kind = Type { turned, ..Type::PLAIN };
                canvas.text(columns[j], [middle, top - 16.0], Align::Left, kind)?;
                continue;
            }
            for (k, line) in lines.iter().rev().enumerate() {
                canvas.text(line, [middle, top - 32.0 - LINE * count(k)], Align::Center, Type::PLAIN)?;
            }
        }
        for (i, (name, cells)) in rows.iter().enumerate() {
            let y = top + CELL * count(i);
            canvas.text(name, [left - 24.0, y + 0.5 * CELL], Align::Right, Type::PLAIN)?;
            for (j, cell) in cells.iter().enumerate() {
                draw_cell(canvas, cell, [left + width * count(j), y], width)?;
            }
        }
        for (i, (cell, meaning)) in legend.iter().enumerate() {
            let y = below + CELL * count(i);
            draw_cell(canvas, cell, [left, y], SWATCH.min(width))?;
            canvas.text(meaning, [left + SWATCH + 24.0, y + 0.5 * CELL], Align::Left, Type::PLAIN)?;
        }
        Ok(())
    })
}

fn draw_cell(canvas: &Canvas<'_>, cell: &Cell, [x, y]: [f64; 2], width: f64) -> Result<(), PlotError> {
    /// White between the cells.
    const GAP: f64 = 4.0;
    let (color, opacity) = cell.tone.fill();
    canvas.rectangle([x + GAP, y + GAP], [x + width - GAP, y + CELL - GAP], color, opacity)?;
    canvas.text(&cell.text, [x + 0.5 * width, y + 0.5 * CELL], Align::Center, Type::BOLD)
}

/// Horizontal bars from zero (or from the left end of a logarithmic axis), each with its name and its value.
///
/// A histogram is this with the bins as names and the counts as values.
///
/// # Errors
///
/// A [`PlotError`] if there is no bar, for a value that is not finite, or not positive on a logarithmic axis.
pub fn bars(title: &str, description: &str, axis: &Axis, items: &[(&str, f64)]) -> Result<String, PlotError> {
    const BAR: f64 = 62.0;
    let sheet = f64::from(WIDTH);
    let left = MARGIN + name_width(items.iter().map(|item| item.0));
    let mut texts = Vec::new();
    for &(_, value) in items {
        texts.push(significant(finite("the value of a bar", value)?, DIGITS));
    }
    // The values stand beyond the ends of the bars.
    let beside = texts.iter().fold(0.0_f64, |most, text| most.max(text_width(text, Type::PLAIN))) + 40.0;
    let zero = if axis.scale == super::Scale::Linear { &[0.0][..] } else { &[] };
    let axis = axis.clone().including(zero);
    let axis = Axis { padding: 0.0, direction: super::Direction::Up, ..axis };
    let right = sheet - MARGIN - beside;
    let negative = items.iter().any(|item| item.1 < 0.0);
    let start = if negative { left + beside } else { left };
    let resolved = axis.resolve(items.iter().map(|item| item.1), [start, right], (right - start) / 240.0)?;
    let origin = if axis.scale == super::Scale::Linear { resolved.place(0.0) } else { start };
    let top = Heading::of(title).height;
    let bottom = top + BAR * count(items.len()) + 16.0;
    document(title, description, whole(bottom + 2.6 * LINE + MARGIN), |canvas| {
        Heading::of(title).draw(canvas)?;
        for tick in &resolved.ticks {
            let x = resolved.place(tick.value);
            canvas.line(&[[x, top], [x, bottom + 10.0]], Color::GRID, 2, Dash::Solid)?;
            canvas.text(&tick.label, [x, bottom + 0.8 * LINE], Align::Center, Type::PLAIN)?;
        }
        let label = axis.heading(resolved.factor);
        canvas.text(&label, [0.5 * (start + right), bottom + 2.0 * LINE], Align::Center, Type::PLAIN)?;
        for (i, (&(name, value), text)) in items.iter().zip(&texts).enumerate() {
            let y = top + BAR * (count(i) + 0.5);
            let end = resolved.place(value);
            canvas.text(name, [left - 24.0, y], Align::Right, Type::PLAIN)?;
            canvas.rectangle([origin, y - 0.34 * BAR], [end, y + 0.34 * BAR], Color::BLUE, 0.8)?;
            let (at, align) = if value < 0.0 { (end - 16.0, Align::Right) } else { (end + 16.0, Align::Left) };
            canvas.text(text, [at, y], align, Type::PLAIN)?;
        }
        canvas.line(&[[origin, top], [origin, bottom]], Color::GRAY, 3, Dash::Solid)
    })
}

/// A title in as many lines as it needs.
struct Heading {
    lines: Vec<String>,
    height: f64,
}

impl Heading {
    fn of(title: &str) -> Self {
        let lines = wrapped(title, f64::from(WIDTH) - 2.0 * MARGIN, Type::TITLE);
        let height = MARGIN + TITLE_LINE * count(lines.len()) + 30.0;
        Self { lines, height }
    }

    fn draw(&self, canvas: &Canvas<'_>) -> Result<(), PlotError> {
        for (i, line) in self.lines.iter().enumerate() {
            let y = MARGIN + TITLE_LINE * (count(i) + 0.5);
            canvas.text(line, [MARGIN, y], Align::Left, Type::TITLE)?;
        }
        Ok(())
    }
}

/// Room for the names of rows.
fn name_width<'a>(names: impl Iterator<Item = &'a str>) -> f64 {
    names.fold(0.0_f64, |most, name| most.max(text_width(name, Type::PLAIN))).min(0.5 * f64::from(WIDTH)) + 32.0
}

fn count(n: usize) -> f64 {
    f64::from(u32::try_from(n).unwrap_or(u32::MAX))
}

#[cfg(test)]
mod tests {
    use super::{Axis, Cell, PlotError, Tone, bars, verdict_map};

    fn cell(tone: Tone, text: &str) -> Cell {
        Cell { tone, text: text.to_owned() }
    }

    #[test]
    fn a_map_letters_its_cells() {
        let rows = [("force", vec![cell(Tone::Good, "C"), cell(Tone::Bad, "X")])];
        let legend = [(cell(Tone::Good, "C"), "certified")];
        let svg = verdict_map("Verdicts", "All.", &["active-set", "four-step"], &rows, &legend).expect("a map");
        for text in ["active-set", "four-step", "force", "\nC\n", "\nX\n", "certified", "<desc id=\"desc\">All.</desc>"]
        {
            assert!(svg.contains(text), "`{text}` is missing");
        }
        let short = verdict_map("", "", &["a"], &rows, &legend);
        assert!(
            matches!(short, Err(PlotError::LengthMismatch { count: 2, expected: 1, .. })),
            "two cells for one column"
        );
        assert!(matches!(verdict_map("", "", &[], &[], &[]), Err(PlotError::Empty { .. })), "no cells");
    }

    #[test]
    fn bars_carry_their_values() {
        let svg = bars("Counts", "All.", &Axis::new("scenes"), &[("a", 12.0), ("b", -3.5), ("c", 0.0)]).expect("bars");
        for text in ["\n12\n", "\n−3.5\n", "\n0\n", "scenes"] {
            assert!(svg.contains(text), "`{text}` is missing");
        }
        let axis = Axis::new("sweeps").log();
        assert!(bars("", "", &axis, &[("a", 1e4), ("b", 3.0)]).is_ok(), "logarithmic");
        assert!(matches!(bars("", "", &axis, &[("a", 0.0)]), Err(PlotError::NotPositive { .. })), "zero on it");
        assert!(matches!(bars("", "", &axis, &[("a", f64::NAN)]), Err(PlotError::NotFinite { .. })), "NaN");
        assert!(matches!(bars("", "", &axis, &[]), Err(PlotError::Empty { .. })), "no bar");
    }
}
