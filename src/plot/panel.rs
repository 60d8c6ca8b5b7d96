//! A panel: a vertical axis on the left, one for forces on the right if there are arrows, a light grid, and layers.

use super::axis::{Axes, Axis, Resolved, Tick};
use super::canvas::{Align, Canvas, TEXT, Type, text_width, wrapped};
use super::draw::draw;
use super::label::{BESIDE, Frame, Labels};
use super::layer::Layer;
use super::palette::{Color, Dash};
use super::{PlotError, count};

/// Axes and what is drawn between them.
#[derive(Debug, Clone, PartialEq)]
pub struct Panel {
    /// The horizontal axis. Without a label it takes no room for one.
    pub x: Axis,
    /// The vertical axis; its label stands above the panel, upright.
    pub y: Axis,
    /// The axis on which the length of arrows is read: on the right, its zero beside that of `y`. Without it arrows are read
    /// on `y`.
    pub forces: Option<Axis>,
    /// From back to front.
    pub layers: Vec<Layer>,
    /// Height between the horizontal frame lines \[drawing units\].
    pub height: f64,
    /// Room inside the frame above the data, for arrows, sketches of loads and labels \[drawing units\].
    pub headroom: f64,
    /// Room inside the frame below the data \[drawing units\].
    pub footroom: f64,
    /// Whether the panel takes a whole row of the figure.
    pub wide: bool,
}

/// Beside the panel.
const MARGIN: f64 = 40.0;
/// Between the frame and the numbers of a vertical axis.
const CLEAR: f64 = 24.0;
/// Height of the numbers below the frame, of a line of words, and below the panel.
const NUMBERS: f64 = 78.0;
const LINE: f64 = 1.25 * TEXT;
const GAP: f64 = 50.0;
/// At most this part of the width is for names beside the frame.
const NAMES: f64 = 0.35;

impl Panel {
    /// An empty panel of ordinary height.
    #[must_use]
    pub fn new(x: Axis, y: Axis) -> Self {
        Self { x, y, forces: None, layers: Vec::new(), height: 560.0, headroom: 0.0, footroom: 0.0, wide: false }
    }

    /// With one more layer in front.
    #[must_use]
    pub fn with(mut self, layer: Layer) -> Self {
        self.layers.push(layer);
        self
    }

    /// With an axis for the length of arrows.
    #[must_use]
    pub fn forces(self, axis: Axis) -> Self {
        Self { forces: Some(axis), ..self }
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

    /// In a row of its own.
    #[must_use]
    pub fn wide(self) -> Self {
        Self { wide: true, ..self }
    }

    /// Height with all that belongs to it, in a column of `width` \[drawing units\].
    pub(super) fn total_height(&self, width: f64) -> Result<f64, PlotError> {
        let frame = self.frame([0.0, 0.0], width, [0.0, 0.0]);
        let axes = self.axes(&frame)?;
        let lines = self.heading(&axes, width).0.len() + self.x_label(&axes, width).len();
        let numbers = if self.x.numbers { NUMBERS } else { 0.0 };
        Ok(LINE * count(lines) + 0.3 * LINE + self.height + numbers + GAP)
    }

    /// Room for numbers and names on the left and on the right of the frame.
    pub(super) fn margins(&self, width: f64) -> Result<[f64; 2], PlotError> {
        let frame = self.frame([0.0, 0.0], width, [0.0, 0.0]);
        let axes = self.axes(&frame)?;
        let widest = |ticks: &[Tick]| ticks.iter().fold(0.0_f64, |most, t| most.max(text_width(&t.label, Type::PLAIN)));
        let right = axes.forces.as_ref().map_or(0.0, |forces| CLEAR + widest(&forces.ticks));
        let names = self.layers.iter().filter_map(Layer::named_ends);
        let beside = names.filter(|(ends, _)| ends.iter().any(|end| frame.ends_at(axes.x.place(end[0]))));
        // Names that would take too much of the width stand inside.
        let widths = beside.map(|(_, name)| BESIDE + text_width(name, Type::PLAIN)).filter(|w| *w < NAMES * width);
        let right = widths.fold(right, f64::max);
        // The last number below the frame is centred at its end.
        let last = axes.x.ticks.last().map_or(0.0, |tick| 0.5 * text_width(&tick.label, Type::PLAIN));
        Ok([MARGIN + widest(&axes.y.ticks) + CLEAR, MARGIN + right.max(last)])
    }

    /// The label of the vertical axis in lines, and that of the forces, which stands on the right of the first line.
    fn heading(&self, axes: &Axes, width: f64) -> (Vec<String>, String) {
        let forces = self.forces.as_ref().zip(axes.forces.as_ref());
        let right = forces.map_or_else(String::new, |(axis, resolved)| axis.heading(resolved.factor));
        let left = width - 2.0 * MARGIN - text_width(&right, Type::BOLD) - if right.is_empty() { 0.0 } else { TEXT };
        (wrapped(&self.y.heading(axes.y.factor), left, Type::BOLD), right)
    }

    fn x_label(&self, axes: &Axes, width: f64) -> Vec<String> {
        wrapped(&self.x.heading(axes.x.factor), width - 2.0 * MARGIN, Type::PLAIN)
    }

    fn frame(&self, [left, top]: [f64; 2], width: f64, margins: [f64; 2]) -> Frame {
        let (right, bottom) = (left + width - margins[1], top + self.height);
        Frame { left: left + margins[0], top, right, bottom, outer: left + width }
    }

    /// Draws the panel with its upper left corner at `(left, top)`.
    pub(super) fn draw(
        &self,
        canvas: &mut Canvas,
        [left, top]: [f64; 2],
        width: f64,
        margins: [f64; 2],
    ) -> Result<(), PlotError> {
        let frame = self.frame([left, top], width, margins);
        let (lines, forces) = self.heading(&self.axes(&frame)?, width);
        for (i, line) in lines.iter().enumerate() {
            canvas.text(line, [left + MARGIN, top + LINE * (count(i) + 0.5)], Align::Left, Type::BOLD)?;
        }
        canvas.text(&forces, [left + width - MARGIN, top + 0.5 * LINE], Align::Right, Type::BOLD)?;
        let frame = self.frame([left, top + LINE * (count(lines.len()) + 0.3)], width, margins);
        let axes = self.axes(&frame)?;
        self.grid(canvas, &frame, &axes, width)?;
        let mut labels = Labels::default();
        for layer in &self.layers {
            draw(canvas, layer, &axes, &frame, &mut labels)?;
        }
        labels.write(canvas, &frame)
    }

    fn axes(&self, frame: &Frame) -> Result<Axes, PlotError> {
        let needs: Vec<[Vec<f64>; 2]> = self.layers.iter().map(Layer::needs).collect();
        let [xs, ys] = [0, 1].map(|k| needs.iter().flat_map(move |needs| needs[k].iter().copied()));
        let (low, high) = (frame.bottom - self.footroom, frame.top + self.headroom);
        let count = ((low - high) / 110.0).max(2.0);
        let y = self.y.resolve(ys, [low, high], count)?;
        let forces = self.forces.as_ref().map(|axis| {
            let of_arrows = self.layers.iter().flat_map(Layer::forces);
            let [least, most] = of_arrows
                .chain(axis.include.iter().copied())
                .fold([0.0_f64; 2], |[least, most], force| [least.min(force), most.max(force)]);
            // The value of the longest arrow stands beyond its tip.
            let below = if least < 0.0 { frame.bottom - 1.4 * TEXT } else { frame.bottom };
            Resolved::of_forces(axis, [least, most], y.place(0.0), [below, frame.top + 1.4 * TEXT], 1.5 * count)
        });
        let x = self.x.resolve(xs, [frame.left, frame.right], (frame.right - frame.left) / 250.0)?;
        Ok(Axes { x, y, forces })
    }

    /// Grid lines, numbers, frame and the label of the horizontal axis.
    fn grid(&self, canvas: &mut Canvas, frame: &Frame, axes: &Axes, width: f64) -> Result<(), PlotError> {
        for tick in &axes.x.ticks {
            let x = axes.x.place(tick.value);
            canvas.line(&[[x, frame.top], [x, frame.bottom + 12.0]], Color::GRID, 2, Dash::Solid)?;
            canvas.text(&tick.label, [x, frame.bottom + 0.55 * NUMBERS], Align::Center, Type::PLAIN)?;
        }
        for tick in &axes.y.ticks {
            let y = axes.y.place(tick.value);
            canvas.line(&[[frame.left - 12.0, y], [frame.right, y]], Color::GRID, 2, Dash::Solid)?;
            canvas.text(&tick.label, [frame.left - CLEAR, y], Align::Right, Type::PLAIN)?;
        }
        // What has no numbers has no frame.
        let mut corners = Vec::new();
        if self.y.numbers {
            corners.extend([[frame.left, frame.top], [frame.left, frame.bottom]]);
        }
        if self.x.numbers {
            corners.extend([[frame.left, frame.bottom], [frame.right, frame.bottom]]);
        }
        if let Some(forces) = axes.forces.as_ref().filter(|forces| !forces.ticks.is_empty()) {
            corners.push([frame.right, frame.top]);
            for tick in &forces.ticks {
                let y = forces.place(tick.value);
                canvas.line(&[[frame.right, y], [frame.right + 12.0, y]], Color::GRAY, 3, Dash::Solid)?;
                canvas.text(&tick.label, [frame.right + CLEAR, y], Align::Left, Type::PLAIN)?;
            }
        }
        canvas.line(&corners, Color::GRAY, 3, Dash::Solid)?;
        let middle = 0.5 * (frame.left + frame.right);
        for (i, line) in self.x_label(axes, width).iter().enumerate() {
            let y = frame.bottom + NUMBERS + LINE * (count(i) + 0.4);
            canvas.text(line, [middle, y], Align::Center, Type::PLAIN)?;
        }
        Ok(())
    }
}
