//! The list of contacts, and the spans that it makes.
//!
//! Every contact has one unknown for each of its ends that is free to move, and one equation:
//!
//! | node | unknown | given | equation |
//! |---|---|---|---|
//! | smooth point | position | `h = h' = 0` | `h''` the same on both sides |
//! | edge (kink, step) | slope of the beam | `v = u`, position | `v''` the same on both sides |
//! | start or end of a zone | position | `h = h' = 0` | `h'' = 0` in the span |

use super::piecewise::PiecewiseScene;
use super::span::{End, Hold, Span};

/// What kind of node it is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Kind {
    /// A point on a smooth piece of the profile.
    Smooth,
    /// The breakpoint of that index, an edge of the profile.
    Edge(usize),
    /// Where a zone starts.
    ZoneStart,
    /// Where a zone ends.
    ZoneEnd,
}

impl Kind {
    /// True if a zone starts, or ends, at such a node.
    pub(super) fn is_of_zone(self) -> bool {
        matches!(self, Self::ZoneStart | Self::ZoneEnd)
    }
}

/// A node of the list.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Node {
    /// What kind it is.
    pub(super) kind: Kind,
    /// Where it is.
    pub(super) x: f64,
    /// Slope `v'` of the beam at an edge; not used elsewhere.
    pub(super) slope: f64,
    /// What its place is beyond `x`, and at an edge its slope beyond `slope`, less than a unit in the last place: where
    /// contacts lie close together, their forces feel it.
    pub(super) rest: f64,
    /// A cell of the smooth piece of the profile on which it lies; for an edge the one to its right.
    pub(super) cell: usize,
}

/// What happens at a support. All but the first need a foundation that starts at depth 0 there.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum AtSupport {
    /// A simple support, `v = v'' = 0`.
    Free,
    /// The foundation holds the slope: `v' = u'`. Next to the support it pushes up while the support pulls down: a couple.
    Clamped,
    /// A zone of contact begins at the support.
    Zone,
}

/// The nodes from left to right, and the supports.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct List {
    /// At `x = 0` and `x = l`.
    pub(super) supports: [AtSupport; 2],
    /// Between them.
    pub(super) nodes: Vec<Node>,
}

impl List {
    /// The beam without contact.
    pub(super) fn free() -> Self {
        Self { supports: [AtSupport::Free; 2], nodes: Vec::new() }
    }

    /// The spans with the number of nodes to their left.
    pub(super) fn spans<'a>(&'a self, given: &'a PiecewiseScene) -> impl Iterator<Item = (usize, Span)> + 'a {
        (0..=self.nodes.len()).filter(|&i| !self.in_zone_before(i)).map(|i| (i, self.span(given, i)))
    }

    /// The span before node `i`, or before the right support.
    pub(super) fn span(&self, given: &PiecewiseScene, i: usize) -> Span {
        Span::between(given, self.left_end(given, i), self.right_end(given, i))
    }

    /// The zones, from where to where.
    pub(super) fn zones(&self, given: &PiecewiseScene) -> Vec<(f64, f64)> {
        (0..=self.nodes.len())
            .filter(|&i| self.in_zone_before(i))
            .map(|i| {
                let from = i.checked_sub(1).map_or(0.0, |i| self.nodes[i].x);
                (from, self.nodes.get(i).map_or(given.length, |n| n.x))
            })
            .collect()
    }

    /// True if the stretch that ends at node `i` (or at the right support) is a zone.
    pub(super) fn in_zone_before(&self, i: usize) -> bool {
        match i.checked_sub(1) {
            Some(left) => self.nodes[left].kind == Kind::ZoneStart,
            None => self.supports[0] == AtSupport::Zone,
        }
    }

    fn left_end(&self, given: &PiecewiseScene, i: usize) -> End {
        let Some(node) = i.checked_sub(1).map(|i| &self.nodes[i]) else {
            return support(0.0, 0, self.supports[0]);
        };
        let [cell, _] = node.cells(given);
        End { x: node.x, rest: node.rest, cell, hold: node.hold(given, cell) }
    }

    fn right_end(&self, given: &PiecewiseScene, i: usize) -> End {
        let Some(node) = self.nodes.get(i) else {
            return support(given.length, given.cells.len() - 1, self.supports[1]);
        };
        let [_, cell] = node.cells(given);
        End { x: node.x, rest: node.rest, cell, hold: node.hold(given, cell) }
    }
}

impl Node {
    /// True if it lies on a break of the profile and cannot move.
    pub(super) fn is_edge(&self) -> bool {
        matches!(self.kind, Kind::Edge(_))
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

    /// Turns the beam at an edge.
    pub(super) fn turn_by(&mut self, step: f64) {
        let rest = self.rest + step;
        let slope = self.slope + rest;
        self.rest = rest - (slope - self.slope);
        self.slope = slope;
    }

    /// The cells to its right and to its left.
    fn cells(&self, given: &PiecewiseScene) -> [usize; 2] {
        match self.kind {
            Kind::Edge(breakpoint) => [breakpoint, breakpoint - 1],
            _ => given.cells_at(self.x, self.cell),
        }
    }

    /// How the node holds a span that lies in `cell` beside it.
    fn hold(&self, given: &PiecewiseScene, cell: usize) -> Hold {
        match self.kind {
            Kind::Edge(breakpoint) => {
                // The lower side of a step lies below the beam, which rests on the upper one.
                let step = given.breakpoints[breakpoint].step;
                Hold::Edge {
                    height: if cell < breakpoint { (-step).max(0.0) } else { step.max(0.0) },
                    level: given.depth_at_breakpoint(breakpoint),
                    slope: [self.slope, self.rest],
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

/// How a support holds a span.
fn support(x: f64, cell: usize, at: AtSupport) -> End {
    let hold = match at {
        AtSupport::Free | AtSupport::Zone => Hold::Support,
        AtSupport::Clamped => Hold::Resting,
    };
    End { x, rest: 0.0, cell, hold }
}

/// The list without nodes that make no sense: starts and ends of zones that have lost their partner, and neighbours that
/// leave no span between them.
pub(super) fn normalised(given: &PiecewiseScene, list: List) -> List {
    // A gap of this width between two contacts cannot be told from none; one between contacts on the same slope is more
    // likely the solution without a gap, which the equations have as well.
    let closed = 1e-11 * given.length;
    let least = 16.0 * f64::EPSILON * given.length;
    let mut nodes: Vec<Node> = Vec::with_capacity(list.nodes.len());
    let mut supports = list.supports;
    let mut inside = supports[0] == AtSupport::Zone;
    for node in list.nodes {
        let before = nodes.last().map_or(0.0, |n| n.x);
        let on_one_slope = !node.is_edge() && nodes.last().is_some_and(|n| !n.is_edge());
        let gap = (if on_one_slope { closed } else { least }) < node.x - before;
        // Two contacts on one smooth piece are one zone if it would press everywhere between them.
        if !inside
            && !node.is_edge()
            && node.kind != Kind::ZoneEnd
            && let Some(last) = nodes.last_mut()
            && !last.is_edge()
            && given.cells[last.cell].shape == given.cells[node.cell].shape
            && given.tension_between(last.x, node.x).next().is_none()
        {
            if last.kind == Kind::ZoneEnd {
                nodes.pop();
            } else {
                last.kind = Kind::ZoneStart;
            }
            inside = true;
            if node.kind == Kind::Smooth && before < node.x {
                inside = false;
                nodes.push(Node { kind: Kind::ZoneEnd, ..node });
            }
            continue;
        }
        match node.kind {
            Kind::ZoneStart | Kind::Smooth | Kind::Edge(_) if inside => {}
            Kind::ZoneEnd if !inside => {}
            Kind::ZoneEnd => {
                inside = false;
                nodes.push(node);
            }
            _ if gap => {
                inside = node.kind == Kind::ZoneStart;
                nodes.push(node);
            }
            Kind::ZoneStart if nodes.last().is_some_and(|n| n.kind == Kind::ZoneEnd) => {
                // Two zones that meet are one.
                nodes.pop();
                inside = true;
            }
            Kind::ZoneStart => {
                nodes.pop();
                inside = true;
                nodes.push(node);
            }
            Kind::Smooth | Kind::Edge(_) => {}
        }
    }
    while nodes.last().is_some_and(|n| given.length - n.x <= least) {
        inside = nodes.pop().is_some_and(|n| n.kind == Kind::ZoneEnd);
    }
    // A zone that starts, or ends, in the last digits beside a support where the foundation starts as well.
    if nodes.first().is_some_and(|n| n.kind == Kind::ZoneStart && n.x <= least) && given.starts_at_zero(0) {
        nodes.remove(0);
        supports[0] = AtSupport::Zone;
    }
    if inside && given.starts_at_zero(1) {
        supports[1] = AtSupport::Zone;
    }
    if inside && supports[1] != AtSupport::Zone {
        // The zone that was opened last has no end.
        match nodes.iter().rposition(|n| n.kind == Kind::ZoneStart) {
            Some(i) => {
                nodes.remove(i);
            }
            None => supports[0] = AtSupport::Free,
        }
    } else if !inside && supports[1] == AtSupport::Zone {
        supports[1] = AtSupport::Free;
    }
    List { supports, nodes }
}

/// A node on an edge of the profile, with the mean of the slopes on its two sides to start from.
pub(super) fn edge_node(given: &PiecewiseScene, breakpoint: usize) -> Node {
    let x = given.breakpoints[breakpoint].x;
    let slope = 0.5 * (given.derivative(breakpoint - 1, x, 1) + given.derivative(breakpoint, x, 1));
    Node { slope, ..Node::new(Kind::Edge(breakpoint), x, breakpoint) }
}
