//! The drawing sheet: lines, areas and text in drawing units, drawn by plotters' SVG backend.
//!
//! No system font is read, so the size of text is an estimate, on the generous side.

use plotters::backend::{DrawingBackend, SVGBackend};
/// Horizontal alignment of a text relative to its point.
pub(super) use plotters::style::text_anchor::HPos as Align;
use plotters::style::text_anchor::{Pos, VPos};
use plotters::style::{Color as _, FontDesc, FontFamily, FontStyle, RGBColor, ShapeStyle, TextStyle};

use super::palette::{Color, Dash, Marker};
use super::{PlotError, finite};

/// Width of the shaft of an arrow.
pub(super) const SHAFT: u32 = 7;
/// Size of ordinary text \[drawing units\]: 9 pixels if the drawing is as wide as a telephone, 19 if it is 800 pixels wide.
pub(super) const TEXT: f64 = 58.0;

/// The backend divides a font size by this number before writing it. Multiplying first gives the sizes we set.
const BACKEND_FONT_FACTOR: f64 = 1.24;

/// The appearance of text.
#[derive(Debug, Clone, Copy)]
pub(super) struct Type {
    pub(super) size: f64,
    pub(super) color: Color,
    pub(super) bold: bool,
}

impl Type {
    pub(super) const PLAIN: Self = Self { size: TEXT, color: Color::BLACK, bold: false };
    pub(super) const BOLD: Self = Self { bold: true, ..Self::PLAIN };
    pub(super) const TITLE: Self = Self { size: 66.0, ..Self::BOLD };
}

/// The sheet to draw on.
pub(super) struct Canvas<'a> {
    backend: SVGBackend<'a>,
}

impl<'a> Canvas<'a> {
    /// An unbounded sheet that writes to `buffer`.
    pub(super) fn new(buffer: &'a mut String) -> Self {
        Self { backend: SVGBackend::with_string(buffer, (1, 1)) }
    }

    /// Finishes the drawing; without it an error in the last step would be lost.
    pub(super) fn present(mut self) -> Result<(), PlotError> {
        done(self.backend.present())
    }

    /// Draws a line through `points`.
    pub(super) fn line(&mut self, points: &[Point], color: Color, width: u32, dash: Dash) -> Result<(), PlotError> {
        for stroke in dashes(&simplified(points)?, dash.pattern()).iter().filter(|stroke| 1 < stroke.len()) {
            done(self.backend.draw_path(pixels(stroke)?, &ShapeStyle::from(&rgb(color)).stroke_width(width)))?;
        }
        Ok(())
    }

    /// Draws several lines with the same appearance.
    pub(super) fn lines(
        &mut self,
        lines: &[impl AsRef<[Point]>],
        color: Color,
        width: u32,
        dash: Dash,
    ) -> Result<(), PlotError> {
        lines.iter().try_for_each(|line| self.line(line.as_ref(), color, width, dash))
    }

    /// Draws a filled polygon.
    pub(super) fn fill(&mut self, points: &[Point], color: Color, opacity: f64) -> Result<(), PlotError> {
        done(self.backend.fill_polygon(pixels(&simplified(points)?)?, &rgb(color).mix(opacity)))
    }

    /// Draws a filled rectangle between two opposite corners.
    pub(super) fn rectangle(
        &mut self,
        [x0, y0]: Point,
        [x1, y1]: Point,
        color: Color,
        opacity: f64,
    ) -> Result<(), PlotError> {
        self.fill(&[[x0, y0], [x1, y0], [x1, y1], [x0, y1]], color, opacity)
    }

    /// Draws a marker at `at`.
    pub(super) fn mark(&mut self, at: Point, marker: Marker, color: Color) -> Result<(), PlotError> {
        /// Half the size of a marker.
        const R: f64 = 13.0;
        let [x, y] = at;
        match marker {
            Marker::Circle => self.disc(at, R, color),
            Marker::OpenCircle => self.circle(at, R, ShapeStyle::from(&rgb(color)).stroke_width(5)),
            Marker::Square => self.rectangle([x - R, y - R], [x + R, y + R], color, 1.0),
            Marker::Triangle => self.fill(&[[x, y - 1.3 * R], [x + 1.2 * R, y + R], [x - 1.2 * R, y + R]], color, 1.0),
            Marker::Diamond => {
                self.fill(&[[x, y - 1.4 * R], [x + 1.4 * R, y], [x, y + 1.4 * R], [x - 1.4 * R, y]], color, 1.0)
            }
            Marker::Cross => {
                let strokes = [[[x - R, y - R], [x + R, y + R]], [[x - R, y + R], [x + R, y - R]]];
                self.lines(&strokes, color, 6, Dash::Solid)
            }
            Marker::Plus => {
                let strokes = [[[x - 1.2 * R, y], [x + 1.2 * R, y]], [[x, y - 1.2 * R], [x, y + 1.2 * R]]];
                self.lines(&strokes, color, 6, Dash::Solid)
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

    /// Draws a filled circle.
    pub(super) fn disc(&mut self, at: Point, radius: f64, color: Color) -> Result<(), PlotError> {
        self.circle(at, radius, ShapeStyle::from(&rgb(color)).filled())
    }

    fn circle(&mut self, at: Point, radius: f64, style: ShapeStyle) -> Result<(), PlotError> {
        let radius = pixel([radius, 0.0])?.0.unsigned_abs();
        done(self.backend.draw_circle(pixel(at)?, radius, &style, style.filled))
    }

    /// Draws a vertical arrow at `x` from `tail` to `tip`. Its head is never longer than the arrow.
    pub(super) fn arrow(
        &mut self,
        x: f64,
        [tail, tip]: [f64; 2],
        color: Color,
        width: u32,
        dash: Dash,
    ) -> Result<(), PlotError> {
        let length = (tip - tail).abs();
        if length < 1.0 {
            return Ok(());
        }
        let head = (4.5 * f64::from(width) + 6.0).min(length);
        let down = (tip - tail).signum();
        let (neck, side) = (tip - down * head, down * 0.38 * head);
        self.line(&[[x, tail], [x, neck]], color, width, dash)?;
        self.fill(&[[x, tip], [x - side, neck], [x + side, neck]], color, 1.0)
    }

    /// Draws text on one line, vertically centred at `at`.
    pub(super) fn text(&mut self, text: &str, at: Point, align: Align, kind: Type) -> Result<(), PlotError> {
        if text.is_empty() {
            return Ok(());
        }
        let style = if kind.bold { FontStyle::Bold } else { FontStyle::Normal };
        let font = FontDesc::new(FontFamily::SansSerif, kind.size * BACKEND_FONT_FACTOR, style);
        let color = rgb(kind.color.of_words());
        let style = TextStyle::from(font).color(&color).pos(Pos::new(align, VPos::Center));
        // The backend's "centre" puts the base line half an x-height below the point; a digit is taller than an x.
        done(self.backend.draw_text(text, &style, pixel([at[0], at[1] + 0.09 * kind.size])?))
    }
}

/// Estimated width of `text`: wide fonts need about 0.6 em per letter, and a little more in bold.
pub(super) fn text_width(text: &str, kind: Type) -> f64 {
    let em = if kind.bold { 0.66 } else { 0.58 };
    // The limit is far more characters than fit on the sheet, and makes the conversion exact.
    f64::from(u16::try_from(text.chars().count()).unwrap_or(u16::MAX)) * em * kind.size
}

/// `text` in lines of at most `width`, broken at spaces, but not within a unit in brackets at its end.
pub(super) fn wrapped(text: &str, width: f64, kind: Type) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    let unit = text.rfind(" [").filter(|_| text.ends_with(']'));
    let (words, unit) = text.split_at(unit.unwrap_or(text.len()));
    for word in words.split_whitespace().chain(Some(unit.trim()).filter(|unit| !unit.is_empty())) {
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

/// Converts an error of the backend.
fn done<E: std::error::Error>(drawn: Result<(), E>) -> Result<(), PlotError> {
    drawn.map_err(|error| PlotError::Backend(error.to_string()))
}

fn rgb(Color(red, green, blue): Color) -> RGBColor {
    RGBColor(red, green, blue)
}

/// The nearest integer drawing units. A position off the sheet stays off it, without overflow.
#[expect(clippy::cast_possible_truncation, reason = "the value is finite and clamped to what an i32 holds")]
fn pixel([x, y]: Point) -> Result<(i32, i32), PlotError> {
    let whole = |value: f64| -> Result<i32, PlotError> {
        Ok(finite("a place on the drawing", value)?.clamp(-1e6, 1e6).round() as i32)
    };
    Ok((whole(x)?, whole(y)?))
}

fn pixels(points: &[Point]) -> Result<Vec<(i32, i32)>, PlotError> {
    points.iter().map(|&point| pixel(point)).collect()
}

/// A position on the drawing, `[right, down]`.
pub(super) type Point = [f64; 2];

/// Largest distance between a line and a point that is left out \[drawing units\].
const BESIDE: f64 = 0.6;

/// The line through fewer of its points, so that none of the others is farther from it than [`BESIDE`] (Douglas and Peucker 1973).
pub(super) fn simplified(line: &[Point]) -> Result<Vec<Point>, PlotError> {
    for &[x, y] in line {
        finite("a place on the drawing", x)?;
        finite("a place on the drawing", y)?;
    }
    let Some(last) = line.len().checked_sub(1) else { return Ok(Vec::new()) };
    let mut kept = vec![false; line.len()];
    (kept[0], kept[last]) = (true, true);
    let mut pending = vec![(0, last)];
    while let Some((from, to)) = pending.pop() {
        let distance = |k: usize| (k, from_segment(line[k], line[from], line[to]));
        let farthest = (from + 1..to).map(distance).fold((from, BESIDE), |far, k| if far.1 < k.1 { k } else { far });
        if farthest.0 != from {
            kept[farthest.0] = true;
            pending.extend([(from, farthest.0), (farthest.0, to)]);
        }
    }
    Ok(line.iter().zip(kept).filter(|(_, kept)| *kept).map(|(&point, _)| point).collect())
}

/// Distance of a point from the segment between `a` and `b`.
fn from_segment([x, y]: Point, a: Point, b: Point) -> f64 {
    let (dx, dy) = (b[0] - a[0], b[1] - a[1]);
    let square = dx * dx + dy * dy;
    let s = if 0.0 < square { (((x - a[0]) * dx + (y - a[1]) * dy) / square).clamp(0.0, 1.0) } else { 0.0 };
    libm::hypot(x - a[0] - s * dx, y - a[1] - s * dy)
}

/// The strokes of a dashed line; the line itself if the pattern is empty.
pub(super) fn dashes(line: &[Point], pattern: &[f64]) -> Vec<Vec<Point>> {
    let Some(&first) = line.first().filter(|_| !pattern.is_empty()) else {
        return vec![line.to_vec()];
    };
    let mut strokes = Vec::new();
    let mut stroke = vec![first];
    let (mut phase, mut left) = (0, pattern[0]);
    for pair in line.windows(2) {
        let ([mut x, mut y], [to_x, to_y]) = (pair[0], pair[1]);
        loop {
            let (dx, dy) = (to_x - x, to_y - y);
            let distance = libm::hypot(dx, dy);
            if distance < left {
                left -= distance;
                if phase % 2 == 0 {
                    stroke.push([to_x, to_y]);
                }
                break;
            }
            (x, y) = (x + dx * left / distance, y + dy * left / distance);
            if phase % 2 == 0 {
                stroke.push([x, y]);
                strokes.push(std::mem::take(&mut stroke));
            } else {
                stroke = vec![[x, y]];
            }
            phase += 1;
            left = pattern[phase % pattern.len()];
        }
    }
    if 1 < stroke.len() {
        strokes.push(stroke);
    }
    strokes
}

#[cfg(test)]
mod tests {
    use super::{Type, wrapped};

    #[test]
    fn no_line_is_broken_within_a_unit() {
        let lines = |text: &str| wrapped(text, 20.0 * 0.58 * Type::PLAIN.size, Type::PLAIN);
        assert_eq!(lines("clearance v, [10⁻⁶ m]"), ["clearance v,", "[10⁻⁶ m]"]);
        assert_eq!(lines("clearance [10⁻⁶ m]"), ["clearance [10⁻⁶ m]"]);
        assert_eq!(lines("a beam [wide] on rock at sea"), ["a beam [wide] on", "rock at sea"], "no unit");
    }
}
