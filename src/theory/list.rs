//! The list of nodes from left to right, and the spans that they make: every beam is a free beam, and nodes hold it.
//!
//! | node | given | unknown | equation | force |
//! |---|---|---|---|---|
//! | support | `v` | slope | `v''` the same on both sides | of either sign |
//! | built in | `v`, `v'` | – | – | of either sign, and a couple |
//! | edge (kink, step, support that only pushes, a free end that touches) | `v = g` | slope | `v''` the same on both sides | ≥ 0 |
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

/// A zone of a list.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Zone {
    /// Index of the node to its right.
    pub(super) node: usize,
    /// Where it starts.
    pub(super) from: f64,
    /// Where it ends.
    pub(super) to: f64,
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

    /// The spans and overhangs from left to right, each with the number of nodes to its left.
    pub(super) fn spans(&self, given: &PiecewiseScene) -> impl Iterator<Item = (usize, Span)> {
        let n = self.nodes.len();
        let overhang = |end: Option<&Node>, i, at_left| end.map(|node| (i, self.overhang(given, node, at_left)));
        let left = overhang(self.nodes.first().filter(|first| 0.0 < first.x), 0, true);
        let right = overhang(self.nodes.last().filter(|last| last.x < given.length), n, false);
        let between = (1..n).filter(|&i| !self.in_zone_before(i)).map(|i| (i, self.span(given, i)));
        left.into_iter().chain(between).chain(right)
    }

    /// The overhang beyond the outermost node on a side.
    fn overhang(&self, given: &PiecewiseScene, node: &Node, at_left: bool) -> Span {
        let [right, left] = node.cells(given);
        let cell = if at_left { left } else { right };
        // Where the node leaves the slope free, it is that of the span beside it.
        let beside = || {
            let i = if at_left { 1 } else { self.nodes.len() - 1 };
            let is_span = 0 < i && i < self.nodes.len() && !self.in_zone_before(i);
            is_span.then(|| self.span(given, i)).map(|span| if at_left { span.beam_a[1] } else { span.beam_b[1] })
        };
        let slope = match node.kind {
            Kind::Edge(_) => beside().unwrap_or(node.slope),
            Kind::Support(..) => node.held_slope(given).or_else(beside).unwrap_or(node.slope),
            // Of the piece on which the node lies, which may end just there.
            Kind::Smooth | Kind::ZoneStart | Kind::ZoneEnd | Kind::Tip => given.derivative(node.cell, node.x, 1),
        };
        Span::overhang(given, node.end(given, cell, Hinged::No), slope, at_left)
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

    /// The zones from left to right.
    pub(super) fn zones(&self) -> impl Iterator<Item = Zone> {
        let zone = |i: usize| Zone { node: i, from: self.nodes[i - 1].x, to: self.nodes[i].x };
        (1..self.nodes.len()).filter(|&i| self.in_zone_before(i)).map(zone)
    }

    /// True if a zone starts or ends at node `i`.
    pub(super) fn ends_zone(&self, i: usize) -> bool {
        self.in_zone_before(i) || self.in_zone_before(i + 1)
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

    /// The same, or the support that only pushes, which come after those.
    pub(super) fn any_support(&self, given: &PiecewiseScene) -> Option<usize> {
        match self.kind {
            Kind::Edge(breakpoint) => given.bearing_index(breakpoint),
            _ => self.support(),
        }
    }

    /// True for a contact with the ground at a single place.
    pub(super) fn is_ground(&self, given: &PiecewiseScene) -> bool {
        match self.kind {
            Kind::Smooth => true,
            Kind::Edge(breakpoint) => !given.is_bearing(breakpoint),
            _ => false,
        }
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
                free_slope(given.height(breakpoint, cell), given.breakpoints[breakpoint].depth)
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
