//! What a panel shows, in the numbers of its axes.

use super::canvas::TEXT;
use super::count;
use super::palette::{Color, Dash, Style};

/// A point in the numbers of the axes, `[x, y]`.
pub type Place = [f64; 2];

/// One thing that is drawn in a panel.
#[derive(Debug, Clone, PartialEq)]
pub enum Layer {
    /// A line, markers, or both.
    Series {
        /// Points in their order; a vertical step is two points at the same place.
        points: Vec<Place>,
        /// Look.
        style: Style,
        /// Name, written in its colour beside the frame if the line has an end there, or else at its last point; empty for
        /// none.
        label: String,
    },
    /// The area between a curve and a level.
    Area {
        /// The curve.
        points: Vec<Place>,
        /// The level.
        level: f64,
        /// Colour, drawn light.
        color: Color,
    },
    /// A stretch that moves: the area between two curves over the same places, and both curves.
    Band {
        /// One curve.
        from: Vec<Place>,
        /// The other.
        to: Vec<Place>,
        /// Colour of the curves; the area is light.
        color: Color,
    },
    /// Concentrated forces.
    Arrows(Arrows),
    /// The foundation: a line with hatching, and the ground below it filled.
    Foundation {
        /// The line.
        points: Vec<Place>,
    },
    /// Dotted lines down the panel, with labels at its top, and what holds between them.
    Divisions(Divisions),
    /// Words at a point.
    Note {
        /// The point.
        at: Place,
        /// The words.
        text: String,
        /// Their colour.
        color: Color,
        /// Whether the point gets a dot.
        dot: bool,
    },
    /// Supports, as engineers draw them.
    Supports(Vec<SupportMark>),
    /// Loads, sketched above a level on a scale of their own.
    Load(LoadSketch),
    /// Coloured, lettered cells of a map, as wide and as high as one unit of its axes, which have names; see [`Axis::named`].
    ///
    /// [`Axis::named`]: super::Axis::named
    Cells(Vec<Cell>),
}

/// Values at which something changes.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Divisions {
    /// Where each line crosses, from left to right, and its label; empty for none. Labels take [`Self::headroom`].
    pub lines: Vec<(f64, String)>,
    /// What holds from one value to another, written between them if there is room.
    pub between: Vec<([f64; 2], String)>,
}

impl Divisions {
    /// Rows of labels: in two rows there is room for more of them.
    pub(super) fn rows(&self) -> usize {
        /// More characters than this, with one between labels, take two rows: a frame of 1700 drawing units has room for them.
        const ONE_ROW: usize = 52;
        let labels = self.lines.iter().filter(|line| !line.1.is_empty());
        match labels.map(|line| line.1.chars().count() + 1).sum() {
            0 => 0,
            characters if characters <= ONE_ROW => 1,
            _ => 2,
        }
    }

    /// Room that a panel needs above its data \[drawing units\].
    #[must_use]
    pub fn headroom(&self) -> f64 {
        let slanted = if self.rows() == 0 { 0.0 } else { TEXT };
        LABEL_ROW * count(self.rows() + usize::from(!self.between.is_empty())) + slanted
    }
}

/// Height of a row of labels.
pub(super) const LABEL_ROW: f64 = 1.3 * TEXT;

/// One cell of a map.
#[derive(Debug, Clone, PartialEq)]
pub struct Cell {
    /// Its middle: which column, which row.
    pub at: Place,
    /// Its colour, drawn light.
    pub color: Color,
    /// A letter or a short word, which says it again for those who do not see the colour.
    pub text: String,
}

/// A support, with the place of the axis of the beam that it holds.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SupportMark {
    /// The place.
    pub at: Place,
    /// How it looks.
    pub kind: SupportKind,
}

/// How a support looks.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum SupportKind {
    /// A triangle: the beam can turn.
    Hinge,
    /// A triangle with a second line below: it can roll as well.
    Roller,
    /// Hatched walls: the beam is built in. True on the sides, left and right, on which the beam ends.
    BuiltIn {
        /// The wall stands at the end of the beam, on its left or on its right.
        ends: [bool; 2],
    },
    /// It pushes, and lets the beam lift off.
    Bearing,
    /// A zigzag: it gives. True if it lets the beam lift off.
    Spring(bool),
    /// A spiral around the place: it holds the slope and gives.
    Turning,
    /// A circle on the beam: no support, but a joint; open for a hinge.
    Joint {
        /// It has no stiffness.
        open: bool,
    },
}

/// Forces as arrows whose length is read on the force axis of the panel, or on its vertical axis if it has none.
#[derive(Debug, Clone, PartialEq)]
pub struct Arrows {
    /// The arrows.
    pub arrows: Vec<Arrow>,
    /// Colour.
    pub color: Color,
    /// How the shaft is drawn.
    pub dash: Dash,
}

/// A force, positive upwards on the page whichever way the axis grows. The arrow starts at its place.
#[derive(Debug, Clone, PartialEq)]
pub struct Arrow {
    /// Where the arrow starts.
    pub at: Place,
    /// The force.
    pub force: f64,
    /// Its value in words; empty for none.
    pub text: String,
    /// Whether the text is left out where there is no room.
    pub optional: bool,
}

/// Loads as a shaded block with small arrows, point loads as large arrows. Positive downwards.
#[derive(Debug, Clone, PartialEq)]
pub struct LoadSketch {
    /// The level that they rest on: the beam.
    pub level: f64,
    /// Intensity along the beam, `[x, force per length]`; a step is two points at the same place.
    pub intensity: Vec<Place>,
    /// Value of each stretch to be written, `(x, intensity, text)`.
    pub values: Vec<(f64, f64, String)>,
    /// Point loads, `(x, force, text)`.
    pub points: Vec<(f64, f64, String)>,
    /// Couples, `(x, moment, text)`, positive clockwise on the page.
    pub couples: Vec<(f64, f64, String)>,
}

impl LoadSketch {
    /// Whether there is anything to draw.
    #[must_use]
    pub(crate) fn is_empty(&self) -> bool {
        let none = |acts: &[(f64, f64, String)]| acts.iter().all(|p| p.1 == 0.0);
        self.intensity.iter().all(|p| p[1] == 0.0) && none(&self.points) && none(&self.couples)
    }
}

impl Layer {
    /// A line, markers, or both, without a name.
    #[must_use]
    pub fn line(points: Vec<Place>, style: Style) -> Self {
        Self::named(points, style, "")
    }

    /// The line `0`, from one place to another.
    #[must_use]
    pub fn zero_line([from, to]: [f64; 2]) -> Self {
        Self::line(vec![[from, 0.0], [to, 0.0]], Style { width: 3, ..Style::solid(Color::BLACK) })
    }

    /// Words at a point, without a dot.
    pub fn words(at: Place, color: Color, text: impl Into<String>) -> Self {
        Self::Note { at, text: text.into(), color, dot: false }
    }

    /// Two simple supports at the ends of a beam from 0 to `length`, at level 0.
    #[must_use]
    pub fn simple_supports(length: f64) -> Self {
        let ends = [(0.0, SupportKind::Hinge), (length, SupportKind::Roller)];
        Self::Supports(ends.map(|(x, kind)| SupportMark { at: [x, 0.0], kind }).to_vec())
    }

    /// A line, markers, or both, with a name.
    pub fn named(points: Vec<Place>, style: Style, label: impl Into<String>) -> Self {
        Self::Series { points, style, label: label.into() }
    }

    /// Numbers on the x axis and on the y axis that the layer needs.
    pub(super) fn needs(&self) -> [Vec<f64>; 2] {
        let of = |points: &[Place]| [0, 1].map(|k| points.iter().map(|p| p[k]).collect::<Vec<f64>>());
        match self {
            Self::Series { points, .. } | Self::Foundation { points } => of(points),
            Self::Area { points, level, .. } => {
                let [xs, mut ys] = of(points);
                ys.push(*level);
                [xs, ys]
            }
            Self::Band { from, to, .. } => of(&[from.as_slice(), to].concat()),
            Self::Divisions(divisions) => {
                let ends = divisions.between.iter().flat_map(|(ends, _)| ends);
                [divisions.lines.iter().map(|line| &line.0).chain(ends).copied().collect(), Vec::new()]
            }
            Self::Arrows(arrows) => of(&arrows.arrows.iter().map(|a| a.at).collect::<Vec<_>>()),
            Self::Note { at, .. } => of(&[*at]),
            Self::Supports(supports) => of(&supports.iter().map(|support| support.at).collect::<Vec<_>>()),
            Self::Cells(cells) => of(&cells.iter().map(|cell| cell.at).collect::<Vec<_>>()),
            Self::Load(load) => {
                let [mut xs, _] = of(&load.intensity);
                xs.extend(load.points.iter().chain(&load.couples).map(|p| p.0));
                [xs, vec![load.level]]
            }
        }
    }

    /// The forces that the layer draws as arrows.
    pub(super) fn forces(&self) -> impl Iterator<Item = f64> {
        let arrows = if let Self::Arrows(layer) = self { layer.arrows.as_slice() } else { &[] };
        arrows.iter().map(|arrow| arrow.force)
    }

    /// The ends of a line with a name, the last one first.
    pub(super) fn named_ends(&self) -> Option<([Place; 2], &str)> {
        match self {
            Self::Series { points, style, label } if style.dash.is_some() && !label.is_empty() => {
                Some(([*points.last()?, *points.first()?], label.as_str()))
            }
            _ => None,
        }
    }
}
