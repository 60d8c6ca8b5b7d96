//! Edges of the profile, on which a beam can rest.

use super::given::Given;
use super::list::{Kind, Node};
use super::span::Span;

/// A node on an edge of the profile, with the mean of the slopes on its two sides to start from.
pub(super) fn edge_node(given: &Given, joint: usize) -> Node {
    let x = given.joints[joint].x;
    let slope = 0.5 * (given.derivative(joint - 1, x, 1) + given.derivative(joint, x, 1));
    Node { slope, ..Node::new(Kind::Edge(joint), x, joint) }
}

/// The edge at `at` in a span, if there is one.
pub(super) fn edge_at(given: &Given, span: &Span, at: f64) -> Option<usize> {
    let near = 1e-6 * span.length();
    (span.a.cell + 1..=span.b.cell).find(|&j| given.is_edge(j) && (given.joints[j].x - at).abs() <= near)
}
