//! Panels: a vertical axis on the left, an axis of forces on the right if there are arrows, a light grid, and layers.

use super::axis::{Axes, Axis, Resolved, Tick};
use super::canvas::{Align, Canvas, TEXT, Type, text_width, wrapped};
use super::draw::draw;
use super::label::{BESIDE, Frame, Labels};
use super::layer::Layer;
use super::palette::{Color, Dash};
use super::{PlotError, count};

/// Axes and the layers drawn between them.
#[derive(Debug, Clone, PartialEq)]
pub struct Panel {
    /// The horizontal axis. Without a label it needs no room for one.
    pub x: Axis,
    /// The vertical axis; its label is above the panel, horizontal.
    pub y: Axis,
    /// The axis for the length of arrows: on the right, with its zero at the zero of `y`. Without it the length is read on `y`.
    pub forces: Option<Axis>,
    /// The layers from back to front.
    pub layers: Vec<Layer>,
    /// Height between the horizontal frame lines \[drawing units\].
    pub height: f64,
    /// Room inside the frame above the data, for arrows, load sketches and labels \[drawing units\].
    pub headroom: f64,
    /// Room inside the frame below the data \[drawing units\].
    pub footroom: f64,
    /// Whether the panel occupies a whole row of the figure.
    pub wide: bool,
}

/// Margin beside the panel.
const MARGIN: f64 = 40.0;
/// Distance between the frame and the numbers of a vertical axis.
const CLEAR: f64 = 24.0;
/// Height of the numbers below the frame, of a line of text, and of the gap below the panel.
const NUMBERS: f64 = 1.6 * TEXT;
const LINE: f64 = 1.25 * TEXT;
const GAP: f64 = 50.0;
/// Largest share of the width for the name of a line beside the frame.
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

    /// The panel in a column of `width` \[drawing units\], with the texts around its frame and the room that they need.
    pub(super) fn layout(&self, width: f64) -> Result<Layout<'_>, PlotError> {
        let frame = Frame { left: 0.0, top: 0.0, right: width, bottom: self.height, outer: width };
        let axes = self.axes(&frame)?;
        let widest = |ticks: &[Tick]| ticks.iter().fold(0.0_f64, |most, t| most.max(text_width(&t.label, Type::PLAIN)));
        let right = axes.forces.as_ref().map_or(0.0, |forces| CLEAR + widest(&forces.ticks));
        let names = self.layers.iter().filter_map(Layer::named_ends);
        let beside = names.filter(|(ends, _)| ends.iter().any(|end| frame.ends_at(axes.x.place(end[0]))));
        // Names that would need too much of the width are written inside.
        let widths = beside.map(|(_, name)| BESIDE + text_width(name, Type::PLAIN)).filter(|w| *w < NAMES * width);
        let right = widths.fold(right, f64::max);
        // The last number below the frame is centred at the right edge.
        let last = axes.x.ticks.last().map_or(0.0, |tick| 0.5 * text_width(&tick.label, Type::PLAIN));
        let margins = [MARGIN + widest(&axes.y.ticks) + CLEAR, MARGIN + right.max(last)];

        let forces = self.forces.as_ref().zip(axes.forces.as_ref());
        let forces = forces.map_or_else(String::new, |(axis, resolved)| axis.heading(resolved.factor));
        let taken = if forces.is_empty() { 0.0 } else { text_width(&forces, Type::BOLD) + TEXT };
        let above = wrapped(&self.y.heading(axes.y.factor), width - 2.0 * MARGIN - taken, Type::BOLD);
        Ok(Layout { panel: self, width, margins, above, forces, below: self.x.heading(axes.x.factor) })
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
            // The value of the longest arrow is written beyond its tip.
            let below = if least < 0.0 { frame.bottom - 1.4 * TEXT } else { frame.bottom };
            Resolved::of_forces(axis, [least, most], y.place(0.0), [below, frame.top + 1.4 * TEXT], 1.5 * count)
        });
        let x = self.x.resolve(xs, [frame.left, frame.right], (frame.right - frame.left) / 250.0)?;
        Ok(Axes { x, y, forces })
    }
}

/// A panel in a column of the figure.
#[derive(Debug, Clone)]
pub(super) struct Layout<'a> {
    panel: &'a Panel,
    width: f64,
    /// Room for numbers and names on the left and on the right of the frame.
    pub(super) margins: [f64; 2],
    /// The lines of the label of the vertical axis, and the label of the force axis, which is on the right of the first line.
    above: Vec<String>,
    forces: String,
    /// The label of the horizontal axis.
    below: String,
}

impl Layout<'_> {
    /// With the margins of a column.
    pub(super) fn with_margins(&self, margins: [f64; 2]) -> Self {
        Self { margins, ..self.clone() }
    }

    /// The total height of the panel with everything that belongs to it.
    pub(super) fn height(&self) -> f64 {
        let lines = self.above.len() + self.x_label().len();
        let numbers = if self.panel.x.numbers { NUMBERS } else { 0.0 };
        LINE * count(lines) + 0.3 * LINE + self.panel.height + numbers + GAP
    }

    /// The lines of the label of the horizontal axis, which are centred below the frame.
    fn x_label(&self) -> Vec<String> {
        let [left, right] = self.margins;
        let half = 0.5 * (self.width - left - right) + left.min(right) - MARGIN;
        wrapped(&self.below, 2.0 * half, Type::PLAIN)
    }

    /// Draws the panel with its upper left corner at `(left, top)`.
    pub(super) fn draw(&self, canvas: &mut Canvas, [left, top]: [f64; 2]) -> Result<(), PlotError> {
        for (i, line) in self.above.iter().enumerate() {
            canvas.text(line, [left + MARGIN, top + LINE * (count(i) + 0.5)], Align::Left, Type::BOLD)?;
        }
        let outer = left + self.width;
        canvas.text(&self.forces, [outer - MARGIN, top + 0.5 * LINE], Align::Right, Type::BOLD)?;
        let top = top + LINE * (count(self.above.len()) + 0.3);
        let frame = Frame {
            left: left + self.margins[0],
            top,
            right: outer - self.margins[1],
            bottom: top + self.panel.height,
            outer,
        };
        let axes = self.panel.axes(&frame)?;
        self.grid(canvas, &frame, &axes)?;
        let mut labels = Labels::default();
        for layer in &self.panel.layers {
            draw(canvas, layer, &axes, &frame, &mut labels)?;
        }
        labels.write(canvas, &frame)
    }

    /// Draws grid lines, numbers, frame and the label of the horizontal axis.
    fn grid(&self, canvas: &mut Canvas, frame: &Frame, axes: &Axes) -> Result<(), PlotError> {
        for tick in &axes.x.ticks {
            let x = axes.x.place(tick.value);
            if self.panel.x.names.is_empty() {
                canvas.line(&[[x, frame.top], [x, frame.bottom + 12.0]], Color::GRID, 2, Dash::Solid)?;
            }
            canvas.text(&tick.label, [x, frame.bottom + 0.55 * NUMBERS], Align::Center, Type::PLAIN)?;
        }
        for tick in &axes.y.ticks {
            let y = axes.y.place(tick.value);
            if self.panel.y.names.is_empty() {
                canvas.line(&[[frame.left - 12.0, y], [frame.right, y]], Color::GRID, 2, Dash::Solid)?;
            }
            canvas.text(&tick.label, [frame.left - CLEAR, y], Align::Right, Type::PLAIN)?;
        }
        // An axis without numbers has no frame line.
        let mut corners = Vec::new();
        if self.panel.y.numbers {
            corners.extend([[frame.left, frame.top], [frame.left, frame.bottom]]);
        }
        if self.panel.x.numbers {
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
        for (i, line) in self.x_label().iter().enumerate() {
            let y = frame.bottom + NUMBERS + LINE * (count(i) + 0.4);
            canvas.text(line, [middle, y], Align::Center, Type::PLAIN)?;
        }
        Ok(())
    }
}
