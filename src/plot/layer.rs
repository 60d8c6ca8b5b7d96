//! Layers: the content of a panel, in the numbers of its axes.

use super::canvas::TEXT;
use super::count;
use super::palette::{Color, Dash, Style};

/// A point in the numbers of the axes, `[x, y]`.
pub type Place = [f64; 2];

/// One element of a panel.
#[derive(Debug, Clone, PartialEq)]
pub enum Layer {
    /// A line, markers, or both.
    Series {
        /// Points in their order; a vertical step is two points at the same position.
        points: Vec<Place>,
        /// Appearance.
        style: Style,
        /// Name, written in the colour of the series beside the frame if the line has an end there, otherwise at its last point;
        /// empty for no name.
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
    /// A moving interval: the area between two curves over the same positions, and both curves.
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
    /// The foundation: a hatched line with the area below it filled.
    Foundation {
        /// The line.
        points: Vec<Place>,
    },
    /// Dotted vertical lines with labels at the top of the panel, and texts that apply between them.
    Divisions(Divisions),
    /// Text at a point.
    Note {
        /// The point.
        at: Place,
        /// The text.
        text: String,
        /// The colour of the text.
        color: Color,
        /// Whether the point gets a dot.
        dot: bool,
    },
    /// Supports as engineering symbols.
    Supports(Vec<SupportMark>),
    /// Loads, sketched above a level on their own scale.
    Load(LoadSketch),
    /// Coloured cells of a map with letters, one unit of the axes wide and high. The axes have names; see [`Axis::named`].
    ///
    /// [`Axis::named`]: super::Axis::named
    Cells(Vec<Cell>),
}

/// Values at which something changes.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Divisions {
    /// Position and label of each line, from left to right; the label is empty for none. Labels need [`Self::headroom`].
    pub lines: Vec<(f64, String)>,
    /// Text that applies from one value to another, written between them if there is room.
    pub between: Vec<([f64; 2], String)>,
}

impl Divisions {
    /// Number of rows of labels: two rows have room for more labels.
    pub(super) fn rows(&self) -> usize {
        /// Largest number of characters, with one between labels, in one row: a frame of 1700 drawing units has room for them.
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
    /// Its centre: column and row.
    pub at: Place,
    /// Its colour, drawn light.
    pub color: Color,
    /// A letter or a short word, which repeats the information for readers who do not see the colour.
    pub text: String,
}

/// A support symbol and its position on the axis of the beam.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SupportMark {
    /// The position.
    pub at: Place,
    /// The symbol.
    pub kind: SupportKind,
}

/// The symbol of a support.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum SupportKind {
    /// A triangle: the beam can rotate.
    Hinge,
    /// A triangle with a second line below: the support can also roll.
    Roller,
    /// Hatched walls: the beam is built in.
    BuiltIn {
        /// Whether the beam ends here, so that the wall is across it: at the left end of the beam, at the right end.
        ends: [bool; 2],
    },
    /// A block with a plate: a compression-only support.
    Bearing,
    /// A zigzag: an elastic support. True if it is compression-only.
    Spring(bool),
    /// A spiral around the position: a support that is elastic against rotation.
    Turning,
    /// A circle on the beam: a joint and not a support; open for a hinge.
    Joint {
        /// Whether it has no stiffness.
        open: bool,
    },
}

/// Forces as arrows. Their length is read on the force axis of the panel, or on its vertical axis if there is no force axis.
#[derive(Debug, Clone, PartialEq)]
pub struct Arrows {
    /// The arrows.
    pub arrows: Vec<Arrow>,
    /// Colour.
    pub color: Color,
    /// Line style of the shaft.
    pub dash: Dash,
}

/// A force, positive upwards on the page, whichever way the axis grows. The arrow starts at its point.
#[derive(Debug, Clone, PartialEq)]
pub struct Arrow {
    /// The start of the arrow.
    pub at: Place,
    /// The force.
    pub force: f64,
    /// Its value as text; empty for none.
    pub text: String,
    /// Whether the text is left out if there is no room.
    pub optional: bool,
}

/// Distributed loads as a shaded block with small arrows, point loads as large arrows. Positive downwards.
#[derive(Debug, Clone, PartialEq)]
pub struct LoadSketch {
    /// The level on which the loads act: the beam.
    pub level: f64,
    /// Intensity along the beam, `[x, force per length]`; a step is two points at the same position.
    pub intensity: Vec<Place>,
    /// Values to be written, one for each interval, `(x, intensity, text)`.
    pub values: Vec<(f64, f64, String)>,
    /// Point loads, `(x, force, text)`.
    pub points: Vec<(f64, f64, String)>,
    /// Couples, `(x, moment, text)`, positive clockwise on the page.
    pub couples: Vec<(f64, f64, String)>,
}

impl LoadSketch {
    /// Whether all loads are zero.
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

    /// The line `0` between two positions.
    #[must_use]
    pub fn zero_line([from, to]: [f64; 2]) -> Self {
        Self::line(vec![[from, 0.0], [to, 0.0]], Style { width: 3, ..Style::solid(Color::BLACK) })
    }

    /// Text at a point, without a dot.
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

    /// The numbers on the x axis and on the y axis that the layer needs.
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

    /// The ends of a named line, the last one first.
    pub(super) fn named_ends(&self) -> Option<([Place; 2], &str)> {
        match self {
            Self::Series { points, style, label } if style.dash.is_some() && !label.is_empty() => {
                Some(([*points.last()?, *points.first()?], label.as_str()))
            }
            _ => None,
        }
    }
}
