//! A map of verdicts: rows and columns of coloured, lettered cells.

use super::words::Words;
use palkki::plot::{Axis, Cell, Color, Figure, Layer, Panel, Place, PlotError};

/// What a cell says; its letter says it again for those who do not see the colour.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Tone {
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
    fn color(self) -> Color {
        match self {
            Self::Good => Color::GREEN,
            Self::Fair => Color::ORANGE,
            Self::Bad => Color::VERMILLION,
            Self::Absent => Color::PALE,
        }
    }
}

/// A row of a map: its name, and one cell for each column.
pub(super) type Row = (String, Vec<(Tone, String)>);

/// The map as a drawing; the legend says what the columns are.
pub(super) fn drawn(words: &Words, columns: Vec<String>, rows: Vec<Row>) -> Result<String, PlotError> {
    /// Height of a cell \[drawing units\].
    const CELL: u32 = 76;
    let (names, cells): (Vec<String>, Vec<_>) = rows.into_iter().unzip();
    let height = f64::from(CELL * u32::try_from(names.len()).unwrap_or(u32::MAX / CELL));
    let mut layer = Vec::new();
    for (y, row) in (0_u32..).zip(cells) {
        for (x, (tone, text)) in (0_u32..).zip(row) {
            let at: Place = [f64::from(x), f64::from(y)];
            layer.push(Cell { at, color: tone.color(), text });
        }
    }
    let panel = Panel::new(Axis::named(&*words.legend, columns), Axis::named("", names).down()).tall(height);
    Figure::new(&*words.title, &*words.description, vec![panel.with(Layer::Cells(layer))])
        .notes(words.notes.clone())
        .svg()
}
