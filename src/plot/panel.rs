//! A panel: two axes, a light grid, a legend above, and layers.

use super::axis::{Axes, Axis};
use super::canvas::{Align, Canvas, Type, text_width};
use super::draw::{draw, swatch};
use super::error::PlotError;
use super::label::{Frame, Labels};
use super::layer::Layer;
use super::palette::{Color, Dash};

/// One pair of axes and what is drawn in it.
#[derive(Debug, Clone, PartialEq)]
pub struct Panel {
    /// The horizontal axis. Without a label it takes no room for one.
    pub x: Axis,
    /// The vertical axis; its label stands above the panel, upright.
    pub y: Axis,
    /// From back to front.
    pub layers: Vec<Layer>,
    /// Height between the horizontal frame lines \[drawing units\].
    pub height: f64,
    /// Room inside the frame above the data, for arrows, sketches of loads and labels \[drawing units\].
    pub headroom: f64,
    /// Room inside the frame below the data \[drawing units\].
    pub footroom: f64,
}

/// Left of the frame, for the numbers of the vertical axis.
const LEFT: f64 = 190.0;
/// Right of the frame.
const RIGHT: f64 = 60.0;
/// Height of the heading, of a row of the legend, of the numbers below the frame and of the axis label.
const HEADING: f64 = 78.0;
const LEGEND_ROW: f64 = 56.0;
const NUMBERS: f64 = 62.0;
const X_LABEL: f64 = 58.0;
/// Below the panel.
const GAP: f64 = 44.0;
/// Room for the sample of a series in the legend, and between two entries.
const SWATCH: f64 = 110.0;
const BETWEEN: f64 = 60.0;

impl Panel {
    /// An empty panel of ordinary height.
    #[must_use]
    pub fn new(x: Axis, y: Axis) -> Self {
        Self { x, y, layers: Vec::new(), height: 520.0, headroom: 0.0, footroom: 0.0 }
    }

    /// With one more layer in front.
    #[must_use]
    pub fn with(mut self, layer: Layer) -> Self {
        self.layers.push(layer);
        self
    }

    /// With another height.
    #[must_use]
    pub fn tall(self, height: f64) -> Self {
        Self { height, ..self }
    }

    /// With room above and below the data.
    #[must_use]
    pub fn room(self, headroom: f64, footroom: f64) -> Self {
        Self { headroom, footroom, ..self }
    }

    /// Height with all that belongs to it, in a column of `width` \[drawing units\].
    pub(super) fn total_height(&self, width: f64) -> f64 {
        let rows = self.legend_rows(width).len();
        let label = if self.x.label.is_empty() { 0.0 } else { X_LABEL };
        HEADING + LEGEND_ROW * f64::from(u32::try_from(rows).unwrap_or(0)) + self.height + NUMBERS + label + GAP
    }

    /// The layers that the legend names, row by row.
    fn legend_rows(&self, width: f64) -> Vec<Vec<(&Layer, &str)>> {
        let mut rows: Vec<Vec<(&Layer, &str)>> = Vec::new();
        let mut left = 0.0;
        for (layer, label) in self.layers.iter().filter_map(|layer| Some((layer, layer.legend()?))) {
            let needed = SWATCH + text_width(label, Type::PLAIN) + BETWEEN;
            match rows.last_mut() {
                Some(row) if needed <= left => {
                    row.push((layer, label));
                    left -= needed;
                }
                _ => {
                    rows.push(vec![(layer, label)]);
                    left = width - LEFT - RIGHT - needed;
                }
            }
        }
        rows
    }

    /// Draws the panel with its upper left corner at `(left, top)`.
    pub(super) fn draw(&self, canvas: &Canvas<'_>, [left, top]: [f64; 2], width: f64) -> Result<(), PlotError> {
        let mut y = top + HEADING;
        for row in self.legend_rows(width) {
            let mut x = left + LEFT;
            for (layer, label) in row {
                swatch(canvas, layer, [x, y + 0.4 * LEGEND_ROW])?;
                canvas.text(label, [x + SWATCH, y + 0.4 * LEGEND_ROW], Align::Left, Type::PLAIN)?;
                x += SWATCH + text_width(label, Type::PLAIN) + BETWEEN;
            }
            y += LEGEND_ROW;
        }
        let frame = Frame { left: left + LEFT, top: y, right: left + width - RIGHT, bottom: y + self.height };
        let axes = self.axes(&frame)?;
        canvas.text(&self.y.heading(axes.y.factor), [left + 40.0, top + 0.45 * HEADING], Align::Left, Type::BOLD)?;
        self.grid(canvas, &frame, &axes)?;
        let mut labels = Labels::default();
        for layer in &self.layers {
            draw(canvas, layer, &axes, &frame, &mut labels)?;
        }
        labels.write(canvas, &frame)
    }

    fn axes(&self, frame: &Frame) -> Result<Axes, PlotError> {
        let xs = self.layers.iter().flat_map(Layer::xs);
        let ys = self.layers.iter().flat_map(Layer::ys);
        let (low, high) = (frame.bottom - self.footroom, frame.top + self.headroom);
        Ok(Axes {
            x: self.x.resolve(xs, [frame.left, frame.right], (frame.right - frame.left) / 190.0)?,
            y: self.y.resolve(ys, [low, high], ((low - high) / 85.0).max(2.0))?,
        })
    }

    /// Grid lines, numbers, frame and the label of the horizontal axis.
    fn grid(&self, canvas: &Canvas<'_>, frame: &Frame, axes: &Axes) -> Result<(), PlotError> {
        for tick in &axes.x.ticks {
            let x = axes.x.place(tick.value);
            canvas.line(&[[x, frame.top], [x, frame.bottom + 12.0]], Color::GRID, 2, Dash::Solid)?;
            canvas.text(&tick.label, [x, frame.bottom + 0.55 * NUMBERS], Align::Center, Type::PLAIN)?;
        }
        for tick in &axes.y.ticks {
            let y = axes.y.place(tick.value);
            canvas.line(&[[frame.left - 12.0, y], [frame.right, y]], Color::GRID, 2, Dash::Solid)?;
            canvas.text(&tick.label, [frame.left - 24.0, y], Align::Right, Type::PLAIN)?;
        }
        let corners = [[frame.left, frame.top], [frame.left, frame.bottom], [frame.right, frame.bottom]];
        canvas.line(&corners, Color::GRAY, 3, Dash::Solid)?;
        let label = self.x.heading(axes.x.factor);
        let middle = 0.5 * (frame.left + frame.right);
        canvas.text(&label, [middle, frame.bottom + NUMBERS + 0.4 * X_LABEL], Align::Center, Type::PLAIN)
    }
}
