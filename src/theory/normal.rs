//! Lists that make sense: repaired and guessed ones are brought into this form before they are solved.

use super::list::{Beside, Kind, List, Node};
use super::piecewise::PiecewiseScene;

/// The list without nodes that make no sense: starts and ends of zones that have lost their partner, and neighbours that
/// leave no span between them. Supports stay.
pub(super) fn normalised(given: &PiecewiseScene, nodes: &[Node]) -> List {
    let mut normal = Normal {
        given,
        closed: 1e-11 * given.length,
        least: 16.0 * f64::EPSILON * given.length,
        nodes: Vec::with_capacity(nodes.len()),
        inside: false,
    };
    for &node in nodes {
        match node.kind {
            Kind::Support(index, beside) => normal.add_support(index, beside, node),
            Kind::Tip if node.x <= 0.0 => {
                normal.inside = normal.nodes.is_empty();
                normal.nodes.extend(normal.inside.then_some(node));
            }
            Kind::Tip => normal.end_at_tip(node),
            _ => normal.add_contact(node),
        }
    }
    normal.end_of_beam()
}

/// The nodes of a list so far.
struct Normal<'a> {
    given: &'a PiecewiseScene,
    /// A gap of this width between two contacts cannot be told from none; one between contacts on the same slope is more
    /// likely the solution without a gap, which the equations have as well.
    closed: f64,
    /// The same of two contacts on different slopes.
    least: f64,
    nodes: Vec<Node>,
    /// True if a zone has begun and not ended.
    inside: bool,
}

impl Normal<'_> {
    fn add_contact(&mut self, node: Node) {
        let given = self.given;
        let before = self.nodes.last().map_or(0.0, |n| n.x);
        let on_one_slope = node.can_move() && self.nodes.last().is_some_and(Node::can_move);
        let begins = self.nodes.is_empty() && given.free_ends[0];
        let gap = begins || (if on_one_slope { self.closed } else { self.least }) < node.x - before;
        if self.joins_zone(&node) {
            return;
        }
        match node.kind {
            Kind::ZoneEnd if self.inside => {
                self.inside = false;
                match self.nodes.last_mut() {
                    // Of a zone that has shrunk to nothing at a support the slope is left that the ground holds.
                    Some(Node { kind: Kind::Support(_, [_, beside]), x, .. }) if node.x - *x <= self.least => {
                        *beside = Beside::Clamped;
                    }
                    _ => self.nodes.push(node),
                }
            }
            Kind::ZoneEnd => {}
            _ if self.inside => {}
            _ if gap => {
                self.inside = node.kind == Kind::ZoneStart;
                self.nodes.push(node);
            }
            Kind::ZoneStart => {
                self.inside = true;
                match self.nodes.last_mut() {
                    // A zone that starts in the last digits beside a support where the ground starts as well.
                    Some(Node { kind: Kind::Support(index, beside), .. }) => {
                        if given.supports[*index].grounded[1] {
                            beside[1] = Beside::Zone;
                        } else {
                            self.nodes.push(node);
                        }
                    }
                    _ => {
                        self.nodes.pop();
                        self.nodes.push(node);
                    }
                }
            }
            _ => {}
        }
    }

    /// Two contacts on one smooth piece are one zone if it would press everywhere between them.
    fn joins_zone(&mut self, node: &Node) -> bool {
        let given = self.given;
        if !self.inside
            && node.can_move()
            && node.kind != Kind::ZoneEnd
            && let Some(last) = self.nodes.last_mut()
            && last.can_move()
            && given.cells[last.cell].shape == given.cells[node.cell].shape
            && given.tension_between(last.x, node.x).next().is_none()
        {
            let ends = node.kind == Kind::Smooth && last.x < node.x;
            if last.kind == Kind::ZoneEnd {
                self.nodes.pop();
            } else {
                last.kind = Kind::ZoneStart;
            }
            self.inside = !ends;
            self.nodes.extend(ends.then_some(Node { kind: Kind::ZoneEnd, ..*node }));
            return true;
        }
        false
    }

    fn add_support(&mut self, index: usize, [left, right]: [Beside; 2], node: Node) {
        let grounded = self.given.supports[index].grounded[0];
        let mut shrunk = false;
        while self.nodes.last().is_some_and(|n| n.support().is_none() && node.x - n.x <= self.least) {
            let kind = self.nodes.pop().map(|n| n.kind);
            shrunk = grounded && self.inside && kind == Some(Kind::ZoneStart);
            self.inside = kind == Some(Kind::ZoneEnd);
        }
        if self.inside && !grounded {
            self.give_up();
        }
        let left = match left {
            _ if self.inside => Beside::Zone,
            _ if shrunk => Beside::Clamped,
            Beside::Zone => Beside::Apart,
            other => other,
        };
        self.inside = right == Beside::Zone;
        self.nodes.push(Node { kind: Kind::Support(index, [left, right]), ..node });
    }

    /// A zone that begins and has no end does not begin.
    fn give_up(&mut self) {
        self.inside = false;
        match self.nodes.last_mut() {
            Some(Node { kind: Kind::Support(_, beside), .. }) => beside[1] = Beside::Apart,
            Some(Node { kind: Kind::ZoneStart | Kind::Tip, .. }) => {
                self.nodes.pop();
            }
            _ => {}
        }
    }

    fn end_at_tip(&mut self, tip: Node) {
        if !std::mem::take(&mut self.inside) {
            return;
        }
        self.nodes.push(tip);
    }

    fn end_of_beam(mut self) -> List {
        let given = self.given;
        let last = given.cells.len();
        // A contact in the last digits before a free end is one of that end.
        if given.free_ends[1]
            && let Some(end) = self.nodes.last_mut()
            && end.can_move()
            && given.length - end.x <= self.least
        {
            *end = match end.kind {
                Kind::ZoneEnd => Node::new(Kind::Tip, given.length, end.cell),
                _ => edge_node(given, last),
            };
            self.inside = false;
        }
        if self.inside {
            self.give_up();
        }
        if given.free_ends[0]
            && let Some(first) = self.nodes.first_mut()
            && first.can_move()
            && first.x <= self.least
        {
            *first = match first.kind {
                Kind::ZoneStart => Node::new(Kind::Tip, 0.0, 0),
                _ => edge_node(given, 0),
            };
        }
        self.close_short_tips();
        List { nodes: self.nodes }
    }

    /// Of a zone that has shrunk to nothing at a free end the end itself is left.
    fn close_short_tips(&mut self) {
        let given = self.given;
        if let [Node { kind: Kind::Tip, .. }, Node { kind: Kind::ZoneEnd, x, .. }, ..] = self.nodes[..]
            && x <= self.least
        {
            self.nodes[0] = edge_node(given, 0);
            self.nodes.remove(1);
        }
        if let [.., Node { kind: Kind::ZoneStart, x, .. }, Node { kind: Kind::Tip, .. }] = self.nodes[..]
            && given.length - x <= self.least
        {
            self.nodes.pop();
            self.nodes.pop();
            self.nodes.push(edge_node(given, given.cells.len()));
        }
    }
}

/// The list with zones that reach the free ends next to which they begin, if the ground is not bent there but for rounding; [`None`]
/// if there are none. Between such a zone and its end nothing can be told.
pub(super) fn reaching_free_ends(given: &PiecewiseScene, list: &List) -> Option<List> {
    let tip = |end: &Node, zone: &Node| {
        let [bend, rate] = [2, 3].map(|order| given.derivative(zone.cell, end.x, order).abs());
        let straight = bend <= STRAIGHT * STRAIGHT * given.length * rate;
        let beside = zone.kind.is_of_zone() && (zone.x - end.x).abs() <= STRAIGHT * given.length;
        let free = matches!(end.kind, Kind::Edge(breakpoint) if given.is_free_end(breakpoint) && !given.is_bearing(breakpoint));
        (free && straight && beside).then(|| Node::new(Kind::Tip, end.x, zone.cell))
    };
    let mut nodes = list.nodes.clone();
    if let [end, zone, ..] = &list.nodes[..]
        && let Some(tip) = tip(end, zone)
    {
        nodes.splice(..2, [tip]);
    }
    if let [.., zone, end] = &list.nodes[..]
        && let Some(tip) = tip(end, zone)
    {
        nodes.truncate(nodes.len() - 2);
        nodes.push(tip);
    }
    (nodes.len() < list.nodes.len()).then_some(List { nodes })
}

/// The bend of the ground at a free end is rounding if it is this squared of the change that its rate makes over the length of the
/// beam, and lifts a beam off within this share of the length: a hundred units in the last place, as that of a cosine's phase.
const STRAIGHT: f64 = 1e-7;

/// A node on an edge of the profile, with the mean of the slopes on its two sides to start from.
pub(super) fn edge_node(given: &PiecewiseScene, breakpoint: usize) -> Node {
    let x = given.breakpoints[breakpoint].x;
    let [left, right] = given.cells_beside(breakpoint);
    let slope = 0.5 * (given.derivative(left, x, 1) + given.derivative(right, x, 1));
    Node { slope, ..Node::new(Kind::Edge(breakpoint), x, right) }
}
