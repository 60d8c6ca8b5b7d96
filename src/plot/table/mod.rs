//! Figures without curves: a map of verdicts.

mod map;

use super::canvas::{Align, Canvas, TEXT, Type, text_width, wrapped};
use super::error::PlotError;
use super::figure::{MARGIN, TITLE_LINE};
use super::svg::WIDTH;

pub use self::map::{Cell, Row, Tone, verdict_map};

/// Height of a line of text.
const LINE: f64 = 1.25 * TEXT;

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
