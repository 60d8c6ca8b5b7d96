//! Colours that colour-blind readers can distinguish, and dashes and markers that are distinct without colour.
//!
//! The colours come from M. Okabe and K. Ito, "Color Universal Design" (2008). Their yellow is left out because it is too light for a
//! line on white.

use std::fmt;

/// A colour: red, green, blue.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Color(pub u8, pub u8, pub u8);

/// The replacement of each colour in dark surroundings. The colour of the paper is a property that a page may override.
const DARK: [(Color, &str); 12] = [
    (Color::BLACK, "#E6EDF3"),
    (Color::BLUE, "#479FE6"),
    (Color::VERMILLION, "#F4803C"),
    (Color::GREEN, "#2CC295"),
    (Color::PURPLE, "#E09AC2"),
    (Color::ORANGE, "#F0B93A"),
    (Color::SKY, "#8CD0F5"),
    (Color::WHITE, "var(--figure-paper, #0D1117)"),
    (Color::GRAY, "#A6AFB9"),
    (Color::GRID, "#30363D"),
    (Color::PALE, "#59616B"),
    (Color::GROUND, "#3B352C"),
];

/// The colours of text, dark enough for a contrast of 4.5 (WCAG 2.2, 1.4.3) on the fill of the foundation, which is the darkest
/// background of text.
const WORDS: [(Color, Color); 6] = [
    (Color::BLUE, Color(0, 100, 157)),
    (Color::VERMILLION, Color(155, 69, 0)),
    (Color::GREEN, Color(0, 109, 79)),
    (Color::PURPLE, Color(131, 77, 107)),
    (Color::ORANGE, Color(126, 87, 0)),
    (Color::SKY, Color(48, 101, 130)),
];

/// Style rules that make a figure dark. Each figure applies them if its surroundings prefer dark colours.
#[must_use]
pub fn dark_rules() -> String {
    let rule = |(color, dark): (Color, &str)| {
        let words = color.of_words();
        let words = if words == color { String::new() } else { format!("[fill=\"{words}\"]{{fill:{dark}}}") };
        format!("[fill=\"{color}\"]{{fill:{dark}}}[stroke=\"{color}\"]{{stroke:{dark}}}{words}")
    };
    DARK.map(rule).concat()
}

/// In SVG notation, `#D55E00`.
impl fmt::Display for Color {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self(red, green, blue) = self;
        write!(f, "#{red:02X}{green:02X}{blue:02X}")
    }
}

impl Color {
    /// The colour of text that belongs to a line of this colour.
    pub(super) fn of_words(self) -> Self {
        WORDS.iter().find(|(color, _)| *color == self).map_or(self, |(_, words)| *words)
    }

    /// Black: text, beam, axes.
    pub const BLACK: Self = Self(0, 0, 0);
    /// Blue: computed results.
    pub const BLUE: Self = Self(0, 114, 178);
    /// Vermillion: contact and contact forces.
    pub const VERMILLION: Self = Self(213, 94, 0);
    /// Bluish green.
    pub const GREEN: Self = Self(0, 158, 115);
    /// Reddish purple.
    pub(crate) const PURPLE: Self = Self(204, 121, 167);
    /// Orange.
    pub const ORANGE: Self = Self(230, 159, 0);
    /// Sky blue.
    pub const SKY: Self = Self(86, 180, 233);
    /// White: the paper.
    pub(crate) const WHITE: Self = Self(255, 255, 255);
    /// Dark grey: secondary text, beam theory.
    pub const GRAY: Self = Self(90, 90, 90);
    /// Light grey: grid lines.
    pub(crate) const GRID: Self = Self(225, 225, 225);
    /// Pale grey: areas of beam theory.
    pub const PALE: Self = Self(190, 190, 190);
    /// Grey of the foundation.
    pub(crate) const GROUND: Self = Self(222, 217, 208);
}

/// The line style.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Dash {
    /// Unbroken: computed results.
    Solid,
    /// Dashed: beam theory.
    Dashed,
    /// Dotted: guides and borders.
    Dotted,
    /// Dashes and dots alternating.
    DashDot,
    /// Long dashes with short gaps.
    LongDashed,
}

impl Dash {
    /// Lengths of strokes and gaps, alternating \[drawing units\]; empty for an unbroken line.
    pub(super) fn pattern(self) -> &'static [f64] {
        match self {
            Self::Solid => &[],
            Self::Dashed => &[30.0, 18.0],
            Self::Dotted => &[6.0, 14.0],
            Self::DashDot => &[34.0, 14.0, 6.0, 14.0],
            Self::LongDashed => &[60.0, 14.0],
        }
    }
}

/// The shape drawn at each point of a series.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[expect(missing_docs, reason = "the names are the shapes")]
pub enum Marker {
    Circle,
    OpenCircle,
    Square,
    Triangle,
    Diamond,
    Cross,
    Plus,
    Star,
}

/// The appearance of one series.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Style {
    /// Colour of line and markers.
    pub color: Color,
    /// Style of the line between the points; no line if `None`.
    pub dash: Option<Dash>,
    /// The marker at each point, if any.
    pub marker: Option<Marker>,
    /// Width of the line \[drawing units\].
    pub width: u32,
}

impl Style {
    /// An unbroken line of one colour.
    #[must_use]
    pub fn solid(color: Color) -> Self {
        Self { color, dash: Some(Dash::Solid), marker: None, width: 6 }
    }

    /// Beam theory, dashed in every figure as in the paper.
    #[must_use]
    pub fn theory() -> Self {
        Self { color: Color::GRAY, dash: Some(Dash::Dashed), marker: None, width: 5 }
    }

    /// Markers without a line.
    #[must_use]
    pub fn marks(color: Color, marker: Marker) -> Self {
        Self { color, dash: None, marker: Some(marker), width: 4 }
    }

    /// The appearance of series `i` of several; the first seven have different colours and different markers.
    #[must_use]
    pub fn of_series(i: usize) -> Self {
        const COLORS: [Color; 7] =
            [Color::BLUE, Color::VERMILLION, Color::GREEN, Color::PURPLE, Color::ORANGE, Color::SKY, Color::BLACK];
        const MARKERS: [Marker; 7] = [
            Marker::Circle,
            Marker::Square,
            Marker::Triangle,
            Marker::Diamond,
            Marker::Cross,
            Marker::OpenCircle,
            Marker::Plus,
        ];
        const DASHES: [Dash; 4] = [Dash::Solid, Dash::Dashed, Dash::DashDot, Dash::LongDashed];
        Self {
            color: COLORS[i % COLORS.len()],
            dash: Some(DASHES[i % DASHES.len()]),
            marker: Some(MARKERS[i % MARKERS.len()]),
            width: 5,
        }
    }
}
