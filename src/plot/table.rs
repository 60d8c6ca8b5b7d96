//! A map of verdicts: rows and columns of coloured, lettered cells.

use super::canvas::{Align, Canvas, TEXT, Type, text_width, wrapped};
use super::figure::{Heading, MARGIN, WIDTH, document, whole};
use super::palette::Color;
use super::{PlotError, count};

/// Height of a line of text.
const LINE: f64 = 1.25 * TEXT;

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

/// Height of a cell, width of one in the legend.
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
    let longest = |names: &mut dyn Iterator<Item = &str>| {
        names.fold(0.0_f64, |most, name| most.max(text_width(name, Type::PLAIN)))
    };
    let left = MARGIN + longest(&mut rows.iter().map(|row| row.0)).min(0.5 * sheet) + 32.0;
    let width = ((sheet - MARGIN - left) / count(columns.len())).min(420.0);
    // Names that do not fit above their columns run upwards.
    let turned = width - 16.0 < longest(&mut columns.iter().flat_map(|c| c.split_whitespace()));
    let headings: Vec<Vec<String>> = columns.iter().map(|c| wrapped(c, width - 16.0, Type::PLAIN)).collect();
    let heading = if turned {
        longest(&mut columns.iter().copied()) + 24.0
    } else {
        LINE * count(headings.iter().map(Vec::len).max().unwrap_or(0)) + 20.0
    };
    let title_lines = Heading::of(title);
    let top = title_lines.bottom + 30.0 + heading;
    let below = top + CELL * count(rows.len()) + 50.0;
    let height = below + CELL * count(legend.len()) + MARGIN;
    document(title, description, whole(height), |canvas| {
        title_lines.draw(canvas)?;
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

fn draw_cell(canvas: &mut Canvas, cell: &Cell, [x, y]: [f64; 2], width: f64) -> Result<(), PlotError> {
    /// White between the cells.
    const GAP: f64 = 4.0;
    let (color, opacity) = cell.tone.fill();
    canvas.rectangle([x + GAP, y + GAP], [x + width - GAP, y + CELL - GAP], color, opacity)?;
    canvas.text(&cell.text, [x + 0.5 * width, y + 0.5 * CELL], Align::Center, Type::BOLD)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn cell(tone: Tone, text: &str) -> Cell {
        Cell { tone, text: text.to_owned() }
    }

    #[test]
    fn a_map_letters_its_cells() {
        let rows = [("force", vec![cell(Tone::Good, "C"), cell(Tone::Bad, "X")])];
        let legend = [(cell(Tone::Good, "C"), "certified")];
        let svg = verdict_map("Verdicts", "All.", &["active-set", "four-step"], &rows, &legend).expect("a map");
        for text in ["active-set", "four-step", "force", ">C<", ">X<", "certified", "<desc id=\"desc\">All.</desc>"] {
            assert!(svg.contains(text), "`{text}` is missing");
        }
        let short = verdict_map("", "", &["a"], &rows, &legend);
        assert!(
            matches!(short, Err(PlotError::LengthMismatch { count: 2, expected: 1, .. })),
            "two cells for one column"
        );
        assert!(matches!(verdict_map("", "", &[], &[], &[]), Err(PlotError::Empty { .. })), "no cells");
    }
}
