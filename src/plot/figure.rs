//! A figure: a title, a description for those who cannot see it, and panels.

use super::canvas::{Align, Type, wrapped};
use super::error::PlotError;
use super::panel::Panel;
use super::svg::{WIDTH, document};

/// Panels under one title, in rows from left to right.
#[derive(Debug, Clone, PartialEq)]
pub struct Figure {
    /// The title, printed above the panels.
    pub title: String,
    /// What the figure shows, in words: it becomes the description of the image.
    pub description: String,
    /// The panels, at least one.
    pub panels: Vec<Panel>,
    /// How many of them stand side by side, at least one.
    pub columns: usize,
}

/// Around the figure, and between the lines of its title \[drawing units\].
pub(super) const MARGIN: f64 = 40.0;
pub(super) const TITLE_LINE: f64 = 60.0;

impl Figure {
    /// A figure with its panels one below the other.
    pub fn new(title: impl Into<String>, description: impl Into<String>, panels: Vec<Panel>) -> Self {
        Self { title: title.into(), description: description.into(), panels, columns: 1 }
    }

    /// The figure as an SVG document, the same to the byte for the same data.
    ///
    /// # Errors
    ///
    /// A [`PlotError`] for a number that is not finite, or not positive on a logarithmic axis, and for an empty panel.
    pub fn svg(&self) -> Result<String, PlotError> {
        if self.panels.is_empty() {
            return Err(PlotError::Empty { what: "a figure" });
        }
        let columns = self.columns.clamp(1, self.panels.len());
        let sheet = f64::from(WIDTH);
        let width = sheet / f64::from(u32::try_from(columns).unwrap_or(1));
        let title = wrapped(&self.title, sheet - 2.0 * MARGIN, Type::TITLE);
        let top = 1.5 * MARGIN + TITLE_LINE * f64::from(u32::try_from(title.len()).unwrap_or(0));
        let rows: Vec<(&[Panel], f64)> = self
            .panels
            .chunks(columns)
            .map(|row| (row, row.iter().fold(0.0_f64, |most, panel| most.max(panel.total_height(width)))))
            .collect();
        let height = top + rows.iter().map(|(_, height)| height).sum::<f64>();
        document(&self.title, &self.description, whole(height), |canvas| {
            let mut y = MARGIN;
            for line in &title {
                canvas.text(line, [MARGIN, y + 0.5 * TITLE_LINE], Align::Left, Type::TITLE)?;
                y += TITLE_LINE;
            }
            y += 0.5 * MARGIN;
            for (row, height) in &rows {
                let mut x = 0.0;
                for panel in *row {
                    panel.draw(canvas, [x, y], width)?;
                    x += width;
                }
                y += height;
            }
            Ok(())
        })
    }
}

/// A height in whole drawing units.
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "clamped to what a u32 holds")]
pub(super) fn whole(height: f64) -> u32 {
    height.ceil().clamp(1.0, 1e6) as u32
}

#[cfg(test)]
mod tests {
    use super::{Figure, PlotError};
    use crate::plot::{Axis, Layer, Panel, Style};

    fn panel(i: usize) -> Panel {
        let label = format!("series {i}");
        let points = vec![[0.0, 0.0], [1.0, 1.0]];
        Panel::new(Axis::new("x"), Axis::new("y")).with(Layer::Series { points, style: Style::of_series(i), label })
    }

    #[test]
    fn a_figure_without_a_panel_or_a_point_is_refused() {
        let none = Figure::new("", "", Vec::new()).svg();
        assert!(matches!(none, Err(PlotError::Empty { what: "a figure" })), "no panel");
        let empty = Figure::new("", "", vec![Panel::new(Axis::new("x"), Axis::new("y"))]).svg();
        assert!(matches!(empty, Err(PlotError::Empty { what: "a panel" })), "no point");
    }

    #[test]
    fn panels_stand_side_by_side() {
        let height = |columns: usize| {
            let figure = Figure { columns, ..Figure::new("title", "words", vec![panel(0), panel(1)]) };
            let svg = figure.svg().expect("a figure");
            assert!(svg.contains("series 0") && svg.contains("series 1"), "a panel is missing");
            svg.split("height=\"")
                .nth(1)
                .and_then(|rest| rest.split('"').next()?.parse::<u32>().ok())
                .expect("a height")
        };
        assert!(height(2) < height(1), "two columns need less height than one");
    }

    #[test]
    fn series_differ_without_their_colours() {
        let styles: Vec<Style> = (0..7).map(Style::of_series).collect();
        for (i, a) in styles.iter().enumerate() {
            for b in &styles[..i] {
                assert!(a.color != b.color && a.marker != b.marker, "{a:?} and {b:?}");
            }
        }
    }
}
