//! Placement of labels: near their point, inside the panel, not on top of each other and not on lines.

use super::canvas::{Align, Canvas, Point, TEXT, Type, text_width};
use super::palette::{Color, Dash};
use super::{PlotError, count};

/// A label to be placed.
#[derive(Debug, Clone)]
pub(super) struct Label {
    pub(super) text: String,
    /// Its point on the drawing.
    pub(super) at: Point,
    pub(super) color: Color,
    /// Whether it is left out instead of being printed over another label.
    pub(super) optional: bool,
    /// Whether it is placed below its point if possible, and not above.
    pub(super) below: bool,
}

impl Label {
    /// A label that must be written, above its point if possible.
    pub(super) fn new(text: &str, at: Point, color: Color) -> Self {
        Self { text: text.to_owned(), at, color, optional: false, below: false }
    }
}

/// A rectangle on the drawing.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Frame {
    pub(super) left: f64,
    pub(super) top: f64,
    pub(super) right: f64,
    pub(super) bottom: f64,
    /// Right edge of the area that belongs to the frame: names of lines may extend to here.
    pub(super) outer: f64,
}

impl Frame {
    fn meets(&self, other: &Self) -> bool {
        self.left < other.right && other.left < self.right && self.top < other.bottom && other.top < self.bottom
    }

    /// Whether a line that ends at `x` ends near the right edge, allowing for the room that an axis leaves there.
    pub(super) fn ends_at(&self, x: f64) -> bool {
        self.right - 0.15 * (self.right - self.left) < x
    }

    /// Whether the name of a line that ends at `x` is written beside the frame, because there is room for it.
    pub(super) fn names_beside(&self, x: f64, name: &str) -> bool {
        self.ends_at(x) && self.right + BESIDE + text_width(name, Type::PLAIN) <= self.outer
    }

    fn holds(&self, [x, y]: Point) -> bool {
        (self.left..=self.right).contains(&x) && (self.top..=self.bottom).contains(&y)
    }

    /// Whether a point is inside and not along an edge, where a line or a marker stays visible.
    fn covers(&self, [x, y]: Point) -> bool {
        /// Half the width of a line.
        const ALONG: f64 = 3.0;
        self.holds([x - ALONG, y - ALONG]) && self.holds([x + ALONG, y + ALONG])
    }
}

/// The labels of one panel and everything that they must not cover.
#[derive(Debug, Default)]
pub(super) struct Labels {
    wanted: Vec<Label>,
    /// Names of lines that end at the right edge of the frame; they are written beside it.
    names: Vec<Label>,
    /// Points of lines, which labels should not cover.
    ink: Vec<Point>,
    /// Texts whose position is fixed.
    written: Vec<Frame>,
}

/// Spacing of the points that represent a line when labels are placed.
pub(super) const INK: f64 = 9.0;

/// Distances between a point and its label, in the order in which they are tried.
const RINGS: [f64; 6] = [12.0, 30.0, 60.0, 100.0, 150.0, 210.0];

/// Distance of a name from the right edge of the frame.
pub(super) const BESIDE: f64 = 44.0;

/// A label farther from its point than this gets a line to it.
const FAR: f64 = 45.0;

impl Labels {
    pub(super) fn ask(&mut self, label: Label) {
        if !label.text.is_empty() {
            self.wanted.push(label);
        }
    }

    /// Adds the name of a line that ends at the right edge of the frame.
    pub(super) fn name(&mut self, label: Label) {
        if !label.text.is_empty() {
            self.names.push(label);
        }
    }

    /// Reserves the area of a text between two corners.
    pub(super) fn leave(&mut self, [left, top]: Point, [right, bottom]: Point) {
        self.written.push(Frame { left, top, right, bottom, outer: right });
    }

    pub(super) fn avoid(&mut self, points: impl IntoIterator<Item = Point>) {
        self.ink.extend(points);
    }

    /// Writes the labels in the order in which they were requested, required labels before optional ones.
    pub(super) fn write(mut self, canvas: &mut Canvas, bounds: &Frame) -> Result<(), PlotError> {
        self.names.sort_by(|a, b| a.at[1].total_cmp(&b.at[1]));
        let heights: Vec<f64> = self.names.iter().map(|name| name.at[1]).collect();
        let heights = apart(&heights, [bounds.top, bounds.bottom], 1.12 * TEXT);
        for (name, y) in self.names.iter().zip(heights) {
            let [from, to] = [[name.at[0] + 14.0, name.at[1]], [bounds.right + BESIDE - 12.0, y]];
            canvas.line(&[from, to], name.color, 2, Dash::Solid)?;
            let kind = Type { color: name.color, ..Type::PLAIN };
            canvas.text(&name.text, [bounds.right + BESIDE, y], Align::Left, kind)?;
        }
        self.wanted.sort_by_key(|label| label.optional);
        let mut taken = std::mem::take(&mut self.written);
        for label in &self.wanted {
            let frame = self.place(label, bounds, &taken);
            if label.optional && taken.iter().any(|t| t.meets(&frame)) {
                continue;
            }
            taken.push(frame);
            // From the point to the nearest point of the label.
            let near = [label.at[0].clamp(frame.left, frame.right), label.at[1].clamp(frame.top, frame.bottom)];
            if FAR < (near[0] - label.at[0]).abs().max((near[1] - label.at[1]).abs()) {
                canvas.line(&[label.at, near], Color::GRAY, 2, Dash::Solid)?;
            }
            if self.ink.iter().any(|p| frame.covers(*p)) {
                canvas.rectangle([frame.left, frame.top], [frame.right, frame.bottom], Color::WHITE, 0.8)?;
            }
            let middle = [0.5 * (frame.left + frame.right), 0.5 * (frame.top + frame.bottom)];
            canvas.text(&label.text, middle, Align::Center, Type { color: label.color, ..Type::PLAIN })?;
        }
        Ok(())
    }

    /// The position around the label's point that covers least.
    fn place(&self, label: &Label, bounds: &Frame, taken: &[Frame]) -> Frame {
        /// Covering a label costs more than covering any number of points of lines.
        const COVERED_LABEL: f64 = 1e4;
        let kind = Type::PLAIN;
        let (width, height) = (text_width(&label.text, kind) + 14.0, 1.2 * kind.size);
        /// Distance between the left edge of the frame, which is an axis, and a label.
        const INSET: f64 = 12.0;
        let near: Vec<Point> = self
            .ink
            .iter()
            .copied()
            .filter(|p| (p[0] - label.at[0]).abs() < width + 400.0 && (p[1] - label.at[1]).abs() < 400.0)
            .collect();
        let down = if label.below { 1.0 } else { -1.0 };
        let mut best: Option<(f64, Frame)> = None;
        // An optional label stays close to its point; the others may move away and get a line to it.
        let rings = if label.optional { 2 } else { RINGS.len() };
        let both = (0..rings).flat_map(|across| (0..rings).map(move |along| [across, along]));
        for [across, along] in both {
            let (side, over) = (0.5 * width + RINGS[along], 0.5 * height + RINGS[across]);
            let places = [
                (0.0, down * over),
                (side, down * over),
                (-side, down * over),
                (side, 0.0),
                (-side, 0.0),
                (0.0, -down * over),
                (side, -down * over),
                (-side, -down * over),
            ];
            let ring = across.max(along);
            for (turn, (dx, dy)) in places.into_iter().enumerate() {
                let x = clamped(label.at[0] + dx, bounds.left + INSET + 0.5 * width, bounds.right - 0.5 * width);
                let y = clamped(label.at[1] + dy, bounds.top + 0.5 * height, bounds.bottom - 0.5 * height);
                let frame = Frame {
                    left: x - 0.5 * width,
                    top: y - 0.5 * height,
                    right: x + 0.5 * width,
                    bottom: y + 0.5 * height,
                    outer: x + 0.5 * width,
                };
                let covered = taken.iter().filter(|t| t.meets(&frame)).count();
                let crossed = near.iter().filter(|p| frame.holds(**p)).count() + usize::from(frame.holds(label.at));
                let cost =
                    COVERED_LABEL * count(covered) + 6.0 * count(crossed) + 5.0 * count(ring) + 0.5 * count(turn);
                if best.is_none_or(|(least, _)| cost < least) {
                    best = Some((cost, frame));
                }
            }
        }
        best.map_or(*bounds, |(_, frame)| frame)
    }
}

/// Positions close to the wanted ones, in their order, at least `distance` apart and, if there is room, between two ends.
pub(super) fn apart(wanted: &[f64], [low, high]: [f64; 2], distance: f64) -> Vec<f64> {
    let mut places: Vec<f64> = Vec::new();
    // Labels that would overlap form a group centred on the mean of their wanted positions, with equal spacing. Groups are merged
    // until none overlap.
    let mut groups: Vec<(f64, usize)> = Vec::new();
    let inside = |middle: f64, n: usize| {
        let half = 0.5 * distance * count(n);
        clamped(middle, low + half, high - half)
    };
    for &place in wanted {
        groups.push((place, 1));
        while let [.., (before, m), (after, n)] = groups[..] {
            if inside(before, m) + 0.5 * distance * count(m) <= inside(after, n) - 0.5 * distance * count(n) {
                break;
            }
            let middle = (before * count(m) + after * count(n)) / count(m + n);
            groups.truncate(groups.len() - 2);
            groups.push((middle, m + n));
        }
    }
    for (middle, n) in groups {
        let first = inside(middle, n) - 0.5 * distance * count(n);
        places.extend((0..n).map(|k| first + distance * (count(k) + 0.5)));
    }
    places
}

/// Points along a line, at most `step` apart, which labels should not cover.
pub(super) fn sampled(line: &[Point], step: f64) -> Vec<Point> {
    let mut points: Vec<Point> = line.first().copied().into_iter().collect();
    for pair in line.windows(2) {
        let ([x, y], [to_x, to_y]) = (pair[0], pair[1]);
        let distance = libm::hypot(to_x - x, to_y - y);
        let mut done = step;
        while done < distance {
            points.push([x + (to_x - x) * done / distance, y + (to_y - y) * done / distance]);
            done += step;
        }
        points.push([to_x, to_y]);
    }
    points
}

/// `value` limited to the range from `lo` to `hi`; the middle if the range is empty.
fn clamped(value: f64, lo: f64, hi: f64) -> f64 {
    if lo <= hi { value.clamp(lo, hi) } else { 0.5 * (lo + hi) }
}

#[cfg(test)]
mod tests {
    use super::{Color, Frame, Label, Labels, apart};

    /// A label stays in its panel wherever its point is, also in a panel that is hardly higher than the label.
    #[test]
    fn labels_stay_inside() {
        let bounds = Frame { left: 100.0, top: 50.0, right: 900.0, bottom: 130.0, outer: 1000.0 };
        for x in [100.0, 500.0, 900.0] {
            for (y, below) in [(50.0, false), (90.0, false), (90.0, true), (130.0, true)] {
                let label = Label { below, ..Label::new("h = 2", [x, y], Color::GRAY) };
                let Frame { left, top, right, bottom, .. } = Labels::default().place(&label, &bounds, &[]);
                assert!(100.0 <= left + 1e-9 && right <= 900.0 + 1e-9, "{left} to {right} at {x}, {y}");
                assert!(50.0 <= top + 1e-9 && bottom <= 130.0 + 1e-9, "{top} to {bottom} at {x}, {y}");
            }
        }
    }

    #[test]
    fn a_line_along_a_side_is_not_covered() {
        let frame = Frame { left: 0.0, top: 0.0, right: 100.0, bottom: 50.0, outer: 100.0 };
        for place in [[2.0, 25.0], [98.0, 25.0], [50.0, 2.0], [50.0, 48.0]] {
            assert!(!frame.covers(place), "{place:?}");
        }
        assert!(frame.covers([4.0, 46.0]));
    }

    #[test]
    fn names_of_lines_stand_a_line_apart() {
        let heights = apart(&[100.0, 105.0, 600.0, 995.0, 996.0], [0.0, 1000.0], 53.0);
        assert!(heights.windows(2).all(|pair| 50.0 < pair[1] - pair[0]), "{heights:?}");
        assert!((heights[2] - 600.0).abs() < 1e-9, "one that has room stays: {heights:?}");
        assert!(heights.iter().all(|y| (0.0..=1000.0).contains(y)), "{heights:?}");
    }
}
