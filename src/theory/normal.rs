//! Lists that are valid: repaired and guessed ones are brought into this form before they are solved.

use super::list::{List, Node};
use super::piecewise::PiecewiseScene;
use crate::certificate::Slope;

/// The list without nodes that are not valid: starts and ends of zones that have lost their partner, and neighbours that
/// leave no span between them. Supports stay.
pub(super) fn merged(given: &PiecewiseScene, nodes: &[Node]) -> List {
    let mut normal = Normal {
        given,
        closed: 1e-11 * given.length,
        least: 16.0 * f64::EPSILON * given.length,
        nodes: Vec::with_capacity(nodes.len()),
        inside: false,
    };
    for &node in nodes {
        let node = at_hinge(given, node, normal.closed);
        if let Some(index) = node.support(given) {
            normal.add_support(index, node);
        } else if node.is_tip(given) {
            normal.add_tip(node);
        } else {
            normal.add_contact(node);
        }
    }
    normal.end_of_beam()
}

/// The end of a zone that cannot be told from a hinge on straight ground is the hinge.
fn at_hinge(given: &PiecewiseScene, node: Node, closed: f64) -> Node {
    if given.divisions.is_empty() || !node.is_of_zone() {
        return node;
    }
    let hinge = |i: &usize| given.breakpoints[*i].joint.is_infinite() && given.is_straight(*i) && !given.breaks_at(*i);
    let beside = given.breakpoints_inside(node.x - closed, node.x + closed).find(hinge);
    beside.map_or(node, |i| Node::hinge_of_zone(given, i, node.starts_zone()))
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
        let support = self.nodes.last().and_then(|last| last.support(given));
        if node.ends_zone() {
            match (std::mem::take(&mut self.inside), self.nodes.last_mut()) {
                (false, _) => {}
                // Of a zone that has shrunk to nothing at a support the slope is left that the ground holds.
                (true, Some(last)) if support.is_some() && node.x - last.x <= self.least => last.lies = false,
                (true, _) => self.nodes.push(node),
            }
        } else if !self.inside && gap {
            self.inside = node.lies;
            self.nodes.push(node);
        } else if !self.inside && node.lies {
            self.inside = true;
            match (support, self.nodes.last_mut()) {
                // A zone that starts in the last digits beside a support where the ground starts as well.
                (Some(index), Some(last)) if given.supports[index].tangent[1] => {
                    last.lies = true;
                    last.hold(false);
                }
                (Some(_), _) => self.nodes.push(node),
                (None, last) => {
                    // The zone before goes on, or it begins where an edge was.
                    let goes_on = last.is_some_and(|last| last.ends_zone());
                    self.nodes.pop();
                    self.nodes.extend((!goes_on).then_some(node));
                }
            }
        }
    }

    /// Two contacts on one smooth piece are one zone if it would press everywhere between them.
    fn joins_zone(&mut self, node: &Node) -> bool {
        let given = self.given;
        if !self.inside
            && node.can_move()
            && !node.ends_zone()
            && let Some(last) = self.nodes.last_mut()
            && last.can_move()
            && given.cells[last.cell].shape == given.cells[node.cell].shape
            && given.pulling_between(last.x, node.x).next().is_none()
        {
            let ends = !node.lies && last.x < node.x;
            if last.ends_zone() {
                self.nodes.pop();
            } else {
                last.lies = true;
            }
            self.inside = !ends;
            let end = Node { low: node.low, ..Node::end(node.x, node.cell) };
            self.nodes.extend(ends.then_some(end));
            return true;
        }
        false
    }

    fn add_support(&mut self, index: usize, mut node: Node) {
        let tangent = self.given.supports[index].tangent[0];
        let mut shrunk = false;
        while let Some(last) =
            self.nodes.pop_if(|last| last.support(self.given).is_none() && node.x - last.x <= self.least)
        {
            shrunk = tangent && self.inside && last.starts_zone();
            self.inside = last.ends_zone();
        }
        if self.inside && !tangent {
            self.give_up();
        }
        if self.inside || shrunk {
            node.hold(true);
        } else if node.lies {
            node.hold(false);
        }
        self.inside = node.lies;
        self.nodes.push(node);
    }

    /// A zone that begins and has no end does not begin.
    fn give_up(&mut self) {
        self.inside = false;
        let given = self.given;
        let Some(last) = self.nodes.last_mut().filter(|last| last.lies) else { return };
        if last.support(given).is_none() {
            self.nodes.pop();
            return;
        }
        last.lies = false;
        if last.slope == (Slope::OfGround { from_the_left: false }) {
            last.slope = Slope::Free(0.0);
        }
    }

    /// At the left end a zone starts, at the right one it ends.
    fn add_tip(&mut self, tip: Node) {
        let is_hinge = tip.breakpoint.is_some_and(|i| self.given.breakpoints[i].joint != 0.0);
        if is_hinge && tip.lies && !self.inside {
            self.nodes.pop_if(|last| last.breakpoint == tip.breakpoint);
        }
        if tip.lies && (self.nodes.is_empty() || is_hinge && !self.inside) || !tip.lies && self.inside {
            self.nodes.push(tip);
            self.inside = tip.lies;
        }
    }

    fn end_of_beam(mut self) -> List {
        let given = self.given;
        let last = given.cells.len();
        // A contact in the last digits before a free end is one of that end.
        if given.free_ends[1]
            && let Some(end) = self.nodes.last_mut()
            && end.can_move()
            && given.length - end.x <= self.least
            && !(end.ends_zone() && given.is_bearing(last))
        {
            *end = if end.ends_zone() { Node::tip(given, false) } else { edge_node(given, last) };
            self.inside = false;
        }
        if self.inside {
            self.give_up();
        }
        if given.free_ends[0]
            && let Some(first) = self.nodes.first_mut()
            && first.can_move()
            && first.x <= self.least
            && !(first.lies && given.is_bearing(0))
        {
            *first = if first.lies { Node::tip(given, true) } else { edge_node(given, 0) };
        }
        self.close_short_tips();
        List { nodes: self.nodes }
    }

    /// Of a zone that has shrunk to nothing at a free end the end itself is left.
    fn close_short_tips(&mut self) {
        let given = self.given;
        if let [tip, end, ..] = self.nodes[..]
            && tip.is_tip(given)
            && end.ends_zone()
            && end.x <= self.least
        {
            self.nodes[0] = edge_node(given, 0);
            self.nodes.remove(1);
        }
        if let [.., start, tip] = self.nodes[..]
            && start.starts_zone()
            && tip.is_tip(given)
            && given.length - start.x <= self.least
        {
            self.nodes.pop();
            self.nodes.pop();
            self.nodes.push(edge_node(given, given.cells.len()));
        }
    }
}

/// A node on an edge of the profile, with the mean of the slopes on its two sides to start from.
pub(super) fn edge_node(given: &PiecewiseScene, breakpoint: usize) -> Node {
    let x = given.breakpoints[breakpoint].x;
    let [left, right] = given.cells_beside(breakpoint);
    let slope = 0.5 * (given.derivative(left, x, 1) + given.derivative(right, x, 1));
    Node { slope: Slope::Free(slope), ..Node::at(given, breakpoint) }
}
