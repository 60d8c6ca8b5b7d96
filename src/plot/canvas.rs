//! The sheet of paper: lines, areas and words in drawing units, by way of plotters' SVG backend.
//!
//! No system font is read, so the size of text is an estimate, on the generous side.

use plotters::backend::SVGBackend;
use plotters::coord::Shift;
use plotters::drawing::{DrawingArea, IntoDrawingArea};
use plotters::element::{Circle, PathElement, Polygon, Text};
use plotters::style::text_anchor::{HPos, Pos, VPos};
use plotters::style::{Color as _, FontDesc, FontFamily, FontStyle, FontTransform, RGBColor, ShapeStyle, TextStyle};

use super::error::{PlotError, finite};
use super::palette::{Color, Dash, Marker};
use super::trace::{Point, dashes, simplified};

/// Width of the shaft of an arrow.
pub(super) const SHAFT: u32 = 7;
/// Size of ordinary text \[drawing units\]: 8 pixels on a telephone, 18 where the drawing is 900 pixels wide.
pub(super) const TEXT: f64 = 48.0;

/// The backend divides a font size by this before it writes it; we multiply, so that sizes are as we say.
const BACKEND_FONT_FACTOR: f64 = 1.24;

/// Where a text lies relative to its point.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Align {
    Left,
    Center,
    Right,
}

/// How words look.
#[derive(Debug, Clone, Copy)]
pub(super) struct Type {
    pub(super) size: f64,
    pub(super) color: Color,
    pub(super) bold: bool,
    /// Running upwards.
    pub(super) turned: bool,
}

impl Type {
    pub(super) const PLAIN: Self = Self { size: TEXT, color: Color::BLACK, bold: false, turned: false };
    pub(super) const BOLD: Self = Self { bold: true, ..Self::PLAIN };
    pub(super) const TITLE: Self = Self { size: 58.0, ..Self::BOLD };
}

/// What is drawn on.
pub(super) struct Canvas<'a> {
    area: DrawingArea<SVGBackend<'a>, Shift>,
}

impl<'a> Canvas<'a> {
    /// A white sheet of `size` drawing units that writes to `buffer`.
    pub(super) fn new(buffer: &'a mut String, size: (u32, u32)) -> Result<Self, PlotError> {
        let area = SVGBackend::with_string(buffer, size).into_drawing_area();
        area.fill(&rgb(Color::WHITE))?;
        Ok(Self { area })
    }

    /// Ends the drawing; without it an error in the last step would be lost.
    pub(super) fn present(self) -> Result<(), PlotError> {
        Ok(self.area.present()?)
    }

    /// A line through `points`.
    pub(super) fn line(&self, points: &[Point], color: Color, width: u32, dash: Dash) -> Result<(), PlotError> {
        for stroke in dashes(&simplified(points)?, dash.pattern()) {
            let path: Vec<_> = stroke.iter().map(|&p| pixel(p)).collect::<Result<_, _>>()?;
            if 1 < path.len() {
                self.area.draw(&PathElement::new(path, ShapeStyle::from(&rgb(color)).stroke_width(width)))?;
            }
        }
        Ok(())
    }

    /// A filled polygon.
    pub(super) fn fill(&self, points: &[Point], color: Color, opacity: f64) -> Result<(), PlotError> {
        let path: Vec<_> = simplified(points)?.into_iter().map(pixel).collect::<Result<_, _>>()?;
        Ok(self.area.draw(&Polygon::new(path, rgb(color).mix(opacity)))?)
    }

    /// A filled rectangle between two opposite corners.
    pub(super) fn rectangle(
        &self,
        [x0, y0]: Point,
        [x1, y1]: Point,
        color: Color,
        opacity: f64,
    ) -> Result<(), PlotError> {
        self.fill(&[[x0, y0], [x1, y0], [x1, y1], [x0, y1]], color, opacity)
    }

    /// A marker at `at`.
    pub(super) fn mark(&self, at: Point, marker: Marker, color: Color) -> Result<(), PlotError> {
        /// Half the size of a marker.
        const R: f64 = 13.0;
        let [x, y] = at;
        let stroke = |a: Point, b: Point| self.line(&[a, b], color, 6, Dash::Solid);
        match marker {
            Marker::Circle => self.disc(at, R, color),
            Marker::OpenCircle => {
                let style = ShapeStyle::from(&rgb(color)).stroke_width(5);
                Ok(self.area.draw(&Circle::new(pixel(at)?, units(R)?, style))?)
            }
            Marker::Square => self.rectangle([x - R, y - R], [x + R, y + R], color, 1.0),
            Marker::Triangle => self.fill(&[[x, y - 1.3 * R], [x + 1.2 * R, y + R], [x - 1.2 * R, y + R]], color, 1.0),
            Marker::Diamond => {
                self.fill(&[[x, y - 1.4 * R], [x + 1.4 * R, y], [x, y + 1.4 * R], [x - 1.4 * R, y]], color, 1.0)
            }
            Marker::Cross => {
                stroke([x - R, y - R], [x + R, y + R])?;
                stroke([x - R, y + R], [x + R, y - R])
            }
            Marker::Plus => {
                stroke([x - 1.2 * R, y], [x + 1.2 * R, y])?;
                stroke([x, y - 1.2 * R], [x, y + 1.2 * R])
            }
            Marker::Star => {
                /// Directions of the ten corners in tenths of a turn from the top, for an outer radius of one.
                const CORNERS: [Point; 10] = [
                    [0.0, -1.0],
                    [0.224, -0.309],
                    [0.951, -0.309],
                    [0.363, 0.118],
                    [0.588, 0.809],
                    [0.0, 0.382],
                    [-0.588, 0.809],
                    [-0.363, 0.118],
                    [-0.951, -0.309],
                    [-0.224, -0.309],
                ];
                self.fill(&CORNERS.map(|[dx, dy]| [x + 3.0 * R * dx, y + 3.0 * R * dy]), color, 1.0)
            }
        }
    }

    /// A filled circle.
    pub(super) fn disc(&self, at: Point, radius: f64, color: Color) -> Result<(), PlotError> {
        Ok(self.area.draw(&Circle::new(pixel(at)?, units(radius)?, ShapeStyle::from(&rgb(color)).filled()))?)
    }

    /// An arrow from `tail` to `tip`; its head never is longer than the arrow.
    pub(super) fn arrow(&self, tail: Point, tip: Point, color: Color, width: u32, dash: Dash) -> Result<(), PlotError> {
        let (dx, dy) = (tip[0] - tail[0], tip[1] - tail[1]);
        let length = (dx * dx + dy * dy).sqrt();
        if length < 1.0 {
            return Ok(());
        }
        let head = (4.5 * f64::from(width) + 6.0).min(length);
        let (ex, ey) = (dx / length, dy / length);
        let neck = [tip[0] - ex * head, tip[1] - ey * head];
        let side = 0.38 * head;
        self.line(&[tail, neck], color, width, dash)?;
        self.fill(
            &[tip, [neck[0] - ey * side, neck[1] + ex * side], [neck[0] + ey * side, neck[1] - ex * side]],
            color,
            1.0,
        )
    }

    /// Words on one line, centred across it at `at`.
    pub(super) fn text(&self, text: &str, at: Point, align: Align, kind: Type) -> Result<(), PlotError> {
        if text.is_empty() {
            return Ok(());
        }
        let style = if kind.bold { FontStyle::Bold } else { FontStyle::Normal };
        let turn = if kind.turned { FontTransform::Rotate270 } else { FontTransform::None };
        let font = FontDesc::new(FontFamily::SansSerif, kind.size * BACKEND_FONT_FACTOR, style).transform(turn);
        let across = match align {
            Align::Left => HPos::Left,
            Align::Center => HPos::Center,
            Align::Right => HPos::Right,
        };
        let color = rgb(kind.color);
        let style = TextStyle::from(font).color(&color).pos(Pos::new(across, VPos::Center));
        // The backend's "centre" puts the base line half an x-height below the point; a digit is taller than an x.
        let lower = 0.09 * kind.size;
        let at = if kind.turned { [at[0] + lower, at[1]] } else { [at[0], at[1] + lower] };
        Ok(self.area.draw(&Text::new(text, pixel(at)?, style))?)
    }
}

/// Estimated width of `text`: wide fonts take about 0.6 em for a letter, a little more in bold.
pub(super) fn text_width(text: &str, kind: Type) -> f64 {
    let em = if kind.bold { 0.66 } else { 0.58 };
    // Far more characters than fit on the sheet; the bound makes the conversion exact.
    f64::from(u16::try_from(text.chars().count()).unwrap_or(u16::MAX)) * em * kind.size
}

/// `text` in lines of at most `width`, broken at spaces.
pub(super) fn wrapped(text: &str, width: f64, kind: Type) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for word in text.split_whitespace() {
        match lines.last_mut() {
            Some(line) if text_width(line, kind) + text_width(word, kind) + kind.size < width => {
                line.push(' ');
                line.push_str(word);
            }
            _ => lines.push(word.to_owned()),
        }
    }
    lines
}

fn rgb(Color(r, g, b): Color) -> RGBColor {
    RGBColor(r, g, b)
}

/// The nearest whole drawing unit; a place off the sheet stays off it, without overflow.
#[expect(clippy::cast_possible_truncation, reason = "the value is finite and clamped to what an i32 holds")]
fn pixel([x, y]: Point) -> Result<(i32, i32), PlotError> {
    let whole = |value: f64| -> Result<i32, PlotError> {
        Ok(finite("a place on the drawing", value)?.clamp(-1e6, 1e6).round() as i32)
    };
    Ok((whole(x)?, whole(y)?))
}

fn units(length: f64) -> Result<u32, PlotError> {
    Ok(pixel([length, 0.0])?.0.unsigned_abs())
}
