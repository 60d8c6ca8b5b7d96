//! The list of nodes from left to right, and the spans that they make: every beam is a free beam, and nodes hold it.
//!
//! | node | given | unknown | equation | force |
//! |---|---|---|---|---|
//! | support | `v` | slope | `v''` the same on both sides | of either sign |
//! | built in | `v`, `v'` | – | – | of either sign, and a couple |
//! | edge (kink, step, a free end that touches) | `v = g` | slope | `v''` the same on both sides | ≥ 0 |
//! | smooth point | `h = h' = 0` | place | `h''` the same on both sides | ≥ 0 |
//! | start or end of a zone | `h = h' = 0` | place | `h'' = 0` in the span | ≥ 0 |
//! | tip: a zone that reaches a free end | `h = h' = 0` | – | `g'' = 0` there, or it lifts | ≥ 0 |
//!
//! Beyond the outermost nodes the beam hangs over: moment and shear force there follow from its loads. So the outermost node, if
//! it leaves the slope free, is a hinge with a given moment and has no unknown either. A tip has none because beside a zone on
//! straight ground the moment of an overhang vanishes doubly at the free end, and the equation of a place would be singular.
//!
//! The ground may start at the level of a support, and then hold the slope of the beam there or carry a zone: [`Beside`].

use super::piecewise::PiecewiseScene;
use super::span::{End, Hold, Overhang, Span};

/// What the ground does beside a support, on one side of it. All but the first need ground at the level of the support.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Beside {
    /// Nothing.
    Apart,
    /// It holds the slope of the beam, `h' = 0`: it pushes up next to the support, which pulls down. The two are a couple.
    Clamped,
    /// A zone of contact begins at the support; it holds the slope as well. Of the force there only the sum with that of the
    /// support is unique: the support is said to take all of it.
    Zone,
}

/// What kind of node it is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Kind {
    /// The support of that index, with what the ground does to its left and to its right.
    Support(usize, [Beside; 2]),
    /// A point on a smooth piece of the profile.
    Smooth,
    /// The breakpoint of that index, an edge of the profile or a free end of the beam.
    Edge(usize),
    /// Where a zone starts.
    ZoneStart,
    /// Where a zone ends.
    ZoneEnd,
    /// A free end of the beam, at which a zone starts or ends.
    Tip,
}

impl Kind {
    /// True if a zone starts, or ends, at such a node, and moves with it.
    pub(super) fn is_of_zone(self) -> bool {
        matches!(self, Self::ZoneStart | Self::ZoneEnd)
    }
}

/// What is not known of a node.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Unknown {
    /// Where it is.
    Place,
    /// The slope of the beam.
    Slope,
}

/// A node of the list.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Node {
    /// What kind it is.
    pub(super) kind: Kind,
    /// Where it is.
    pub(super) x: f64,
    /// Slope `v'` of the beam at an edge or a support; not used elsewhere.
    pub(super) slope: f64,
    /// What its place is beyond `x`, and at an edge or a support its slope beyond `slope`, less than a unit in the last place:
    /// where contacts lie close together, their forces feel it.
    pub(super) rest: f64,
    /// A cell of the smooth piece of the profile on which it lies; for an edge or a support the one to its right.
    pub(super) cell: usize,
}

/// The nodes from left to right, every support among them.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct List {
    /// From left to right.
    pub(super) nodes: Vec<Node>,
}

impl List {
    /// The beam without contact.
    pub(super) fn free(given: &PiecewiseScene) -> Self {
        Self { nodes: (0..given.supports.len()).map(|i| support_node(given, i, [Beside::Apart; 2])).collect() }
    }

    /// What is not known of node `i`.
    pub(super) fn unknown(&self, given: &PiecewiseScene, i: usize) -> Option<Unknown> {
        let node = self.nodes.get(i)?;
        let inner = 0 < i && i + 1 < self.nodes.len();
        match node.kind {
            Kind::Smooth | Kind::ZoneStart | Kind::ZoneEnd => Some(Unknown::Place),
            Kind::Edge(_) => inner.then_some(Unknown::Slope),
            Kind::Support(..) => (inner && node.held_slope(given).is_none()).then_some(Unknown::Slope),
            Kind::Tip => None,
        }
    }

    /// The number of unknowns.
    pub(super) fn unknowns(&self, given: &PiecewiseScene) -> usize {
        (0..self.nodes.len()).filter(|&i| self.unknown(given, i).is_some()).count()
    }

    /// The spans and overhangs with the number of nodes to their left.
    pub(super) fn spans(&self, given: &PiecewiseScene) -> Vec<(usize, Span)> {
        let n = self.nodes.len();
        let mut spans = Vec::with_capacity(n + 1);
        spans.extend((1..n).filter(|&i| !self.in_zone_before(i)).map(|i| (i, self.span(given, i))));
        let (Some(first), Some(last)) = (self.nodes.first(), self.nodes.last()) else { return spans };
        // An overhang takes the slope that the span beside its node has there.
        if 0.0 < first.x {
            let beside = spans.first().filter(|(i, _)| *i == 1).map(|(_, span)| span.beam_a[1]);
            let [_, cell] = first.cells(given);
            let held = first.end(given, cell, Hinged::No);
            spans.insert(0, (0, Span::overhang(given, held, first.slope_beside(given, cell, beside), true)));
        }
        if last.x < given.length {
            let beside = spans.last().filter(|(i, _)| 0 < *i && i + 1 == n).map(|(_, span)| span.beam_b[1]);
            let [cell, _] = last.cells(given);
            let held = last.end(given, cell, Hinged::No);
            spans.push((n, Span::overhang(given, held, last.slope_beside(given, cell, beside), false)));
        }
        spans
    }

    /// The span between node `i − 1` and node `i`.
    fn span(&self, given: &PiecewiseScene, i: usize) -> Span {
        let (left, right) = (&self.nodes[i - 1], &self.nodes[i]);
        let hinged = |outermost: bool, side: Hinged| if outermost { side } else { Hinged::No };
        let ([from, _], [_, to]) = (left.cells(given), right.cells(given));
        let a = left.end(given, from, hinged(i == 1, Hinged::Left));
        let b = right.end(given, to, hinged(i + 1 == self.nodes.len(), Hinged::Right));
        Span::between(given, a, b)
    }

    /// The zones, from where to where.
    pub(super) fn zones(&self) -> Vec<(f64, f64)> {
        (1..self.nodes.len())
            .filter(|&i| self.in_zone_before(i))
            .map(|i| (self.nodes[i - 1].x, self.nodes[i].x))
            .collect()
    }

    /// True if the stretch that ends at node `i` is a zone.
    pub(super) fn in_zone_before(&self, i: usize) -> bool {
        let Some(left) = i.checked_sub(1).and_then(|left| self.nodes.get(left)) else { return false };
        match left.kind {
            Kind::ZoneStart | Kind::Support(_, [_, Beside::Zone]) => true,
            Kind::Tip => i == 1 && i < self.nodes.len(),
            _ => false,
        }
    }
}

/// Whether a node that leaves the slope free is the outermost one on a side, and so a hinge.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Hinged {
    No,
    Left,
    Right,
}

impl Node {
    /// True if it lies on a break of the profile and cannot move.
    pub(super) fn is_edge(&self) -> bool {
        matches!(self.kind, Kind::Edge(_))
    }

    /// True if it lies on a smooth piece of the profile and can move on it.
    pub(super) fn can_move(&self) -> bool {
        matches!(self.kind, Kind::Smooth | Kind::ZoneStart | Kind::ZoneEnd)
    }

    /// The support that it is, if it is one.
    pub(super) fn support(&self) -> Option<usize> {
        match self.kind {
            Kind::Support(index, _) => Some(index),
            _ => None,
        }
    }

    /// A node at `x`.
    pub(super) fn new(kind: Kind, x: f64, cell: usize) -> Self {
        Self { kind, x, slope: 0.0, rest: 0.0, cell }
    }

    /// Moves it to the sum of `x` and `rest`, of which `x` is much the larger.
    pub(super) fn move_to(&mut self, x: f64, rest: f64) {
        self.x = x + rest;
        self.rest = rest - (self.x - x);
    }

    /// Turns the beam at an edge or a support.
    pub(super) fn turn_by(&mut self, step: f64) {
        let rest = self.rest + step;
        let slope = self.slope + rest;
        self.rest = rest - (slope - self.slope);
        self.slope = slope;
    }

    /// The slope of the beam at a support that does not leave it free, because the beam is built in or because of the ground.
    pub(super) fn held_slope(&self, given: &PiecewiseScene) -> Option<f64> {
        let Kind::Support(index, beside) = self.kind else { return None };
        given.supports[index].slope.or_else(|| {
            let side = beside.iter().position(|&beside| beside != Beside::Apart)?;
            let cell = given.cells_beside(given.supports[index].breakpoint)[side];
            Some(given.derivative(cell, self.x, 1))
        })
    }

    /// The slope of an overhang at its node, beside a span in `cell` that has the slope `beside` there.
    fn slope_beside(&self, given: &PiecewiseScene, cell: usize, beside: Option<f64>) -> f64 {
        match self.kind {
            Kind::Edge(_) => beside.unwrap_or(self.slope),
            Kind::Support(..) => self.held_slope(given).or(beside).unwrap_or(self.slope),
            Kind::Smooth | Kind::ZoneStart | Kind::ZoneEnd | Kind::Tip => given.derivative(cell, self.x, 1),
        }
    }

    /// The cells to its right and to its left.
    fn cells(&self, given: &PiecewiseScene) -> [usize; 2] {
        match self.kind {
            Kind::Edge(breakpoint) => {
                let [left, right] = given.cells_beside(breakpoint);
                [right, left]
            }
            Kind::Support(index, _) => {
                let [left, right] = given.cells_beside(given.supports[index].breakpoint);
                [right, left]
            }
            _ => given.cells_at(self.x, self.cell),
        }
    }

    /// The end of a span that lies in `cell` beside the node.
    fn end(&self, given: &PiecewiseScene, cell: usize, hinged: Hinged) -> End {
        End { x: self.x, rest: self.rest, cell, hold: self.hold(given, cell, hinged) }
    }

    /// How the node holds that span.
    fn hold(&self, given: &PiecewiseScene, cell: usize, hinged: Hinged) -> Hold {
        let free_slope = |height: f64, level: f64| match hinged {
            Hinged::No => Hold::Edge { height, level, slope: [self.slope, self.rest] },
            side => {
                let curvature = Overhang::of(given, self.x, side == Hinged::Left).moment;
                Hold::Hinge { height, level, curvature }
            }
        };
        match self.kind {
            Kind::Edge(breakpoint) => {
                // The lower side of a step lies below the beam, which rests on the upper one.
                let step = given.breakpoints[breakpoint].step;
                let height = if cell < breakpoint { (-step).max(0.0) } else { step.max(0.0) };
                free_slope(height, given.depth_at_breakpoint(breakpoint))
            }
            Kind::Support(index, beside) => {
                let support = &given.supports[index];
                let [left, _] = given.cells_beside(support.breakpoint);
                let side = usize::from(cell != left || self.x <= 0.0);
                let height = support.clearance[side];
                match self.held_slope(given) {
                    _ if beside[side] != Beside::Apart => Hold::Resting,
                    Some(slope) => Hold::Edge { height, level: support.level, slope: [slope, 0.0] },
                    None => free_slope(height, support.level),
                }
            }
            // A node at the very end of its piece of the profile has the next one on its other side.
            _ if given.cells[cell].shape != given.cells[self.cell].shape => {
                let level = given.derivative(self.cell, self.x, 0);
                Hold::Edge {
                    height: given.derivative(cell, self.x, 0) - level,
                    level,
                    slope: [given.derivative(self.cell, self.x, 1), 0.0],
                }
            }
            _ => Hold::Resting,
        }
    }
}

/// The node of the support of that index, with what the ground does beside it.
pub(super) fn support_node(given: &PiecewiseScene, index: usize, beside: [Beside; 2]) -> Node {
    let breakpoint = given.supports[index].breakpoint;
    let [_, cell] = given.cells_beside(breakpoint);
    Node::new(Kind::Support(index, beside), given.breakpoints[breakpoint].x, cell)
}
