//! Normal form of lists: repaired and guessed lists are brought into this form before they are solved.

use super::list::{List, Node};
use super::piecewise::PiecewiseScene;
use crate::certificate::Slope;

/// The list without invalid nodes: starts and ends of zones without their counterpart, and neighbours with no span between them.
/// Supports remain.
pub(super) fn normal_form(given: &PiecewiseScene, nodes: &[Node]) -> List {
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

/// Replaces the end of a zone by a hinge on a straight foundation if the two positions cannot be distinguished.
fn at_hinge(given: &PiecewiseScene, node: Node, closed: f64) -> Node {
    if given.is_undivided() || !node.is_of_zone() {
        return node;
    }
    let beside = given.breakpoints_inside(node.x - closed, node.x + closed).find(|&i| given.is_hinge_on_a_line(i));
    beside.map_or(node, |i| Node::hinge_of_zone(given, i, node.starts_zone()))
}

/// The nodes of a list so far.
struct Normal<'a> {
    given: &'a PiecewiseScene,
    /// Width up to which a gap between two contacts on the same slope counts as closed. It is more likely the solution without a gap,
    /// which also satisfies the equations.
    closed: f64,
    /// The same width for two contacts on different slopes.
    least: f64,
    nodes: Vec<Node>,
    /// Whether a zone has begun and not ended.
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
                // If a zone has shrunk to nothing at a support, the foundation still fixes the slope there.
                (true, Some(last)) if support.is_some() && node.x - last.x <= self.least => last.lies = false,
                (true, _) => self.nodes.push(node),
            }
        } else if !self.inside && gap {
            self.inside = node.lies;
            self.nodes.push(node);
        } else if !self.inside && node.lies {
            self.inside = true;
            match (support, self.nodes.last_mut()) {
                // A zone that starts within the last digits of the position of a support, where the foundation starts at its level as
                // well.
                (Some(index), Some(last)) if given.supports[index].tangent[1] => {
                    last.lies = true;
                    last.hold(false);
                }
                (Some(_), _) => self.nodes.push(node),
                (None, last) => {
                    // The previous zone continues, or the zone begins where an edge was.
                    let goes_on = last.is_some_and(|last| last.ends_zone());
                    self.nodes.pop();
                    self.nodes.extend((!goes_on).then_some(node));
                }
            }
        }
    }

    /// Joins two contacts on one smooth piece to one zone if the whole zone between them is in compression.
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

    /// Removes the start of a zone that has no end.
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

    /// Adds a free end or a hinge: at the left end a zone starts, at the right end it ends.
    fn add_tip(&mut self, tip: Node) {
        let is_hinge = tip.breakpoint.is_some_and(|i| self.given.breakpoints[i].is_jointed());
        // Held by: theory::giving::random::random_beams_on_springs_and_stops
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
        // A contact within the last digits of the position of a free end belongs to that end.
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

    /// Replaces a zone that has shrunk to nothing at a free end by the end itself.
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

/// A node on an edge of the profile; its initial slope is the mean of the slopes on the two sides.
pub(super) fn edge_node(given: &PiecewiseScene, breakpoint: usize) -> Node {
    let x = given.breakpoints[breakpoint].x;
    let [left, right] = given.cells_beside(breakpoint);
    let slope = 0.5 * (given.derivative(left, x, 1) + given.derivative(right, x, 1));
    Node { slope: Slope::Free(slope), ..Node::at(given, breakpoint) }
}
