//! What a witness says, as contact nodes: its places as they are, and the slopes that follow from them.
//!
//! Nothing is added to its contacts but the supports, and no place is moved: what is wrong stays wrong, and is paid for in
//! [`proof`](super::kernel::proof). The slopes `θ` of the beam at supports and corners are the one thing that places leave open.
//! With the places given they minimise the energy of the spans, and solve
//!
//! ```text
//! EI v''(x−) = EI v''(x+),     EI v'' = 0 at a support
//! ∂v''(a)/∂θ_a = −4/L,  ∂v''(a)/∂θ_b = −2/L,     ∂v''(b)/∂θ_a = 2/L,  ∂v''(b)/∂θ_b = 4/L     in a span from a to b
//! ```
//!
//! a linear system with three diagonals. Nothing that is proven rests on its solution: a slope that is off costs sharpness.

use super::kernel::contact_node::{ContactNode, EnclosedScene, Kind};
use super::kernel::foundation::EnclosedFoundation;
use super::kernel::span::Span;
use crate::scene::{Foundation, Scale};
use crate::state::Contact;

/// The contact nodes of a list of contacts in the units of the scene, in its order, with the slopes that follow from their
/// places. A contact at a single place is a corner of the foundation if there is one, and otherwise a point of tangency.
#[expect(clippy::float_cmp, reason = "a contact from a place to the same place is a point")]
pub(super) fn nodes(enclosed: &EnclosedScene<'_>, contacts: &[Contact], scale: &Scale) -> Vec<ContactNode> {
    let length = enclosed.length;
    let mut nodes: Vec<ContactNode> = Vec::with_capacity(2 * contacts.len() + 2);
    for contact in contacts {
        let [from, to] = [contact.from / scale.length, contact.to / scale.length];
        // Zones that share an end are one zone, and the end of a zone is no other contact.
        if nodes.last().is_some_and(|node| node.kind == Kind::End && node.x == from) {
            if from < to {
                nodes.pop();
                nodes.push(ContactNode::new(Kind::End, to));
            }
            continue;
        }
        if from != to {
            nodes.extend([ContactNode::new(Kind::Start, from), ContactNode::new(Kind::End, to)]);
        } else if from == 0.0 || from == length {
            // A point at a support says nothing that the support does not say.
        } else {
            let kind = if enclosed.foundation.is_corner(from) { Kind::Corner } else { Kind::Touch };
            nodes.push(ContactNode::new(kind, from));
        }
    }
    // A zone that begins or ends at a support takes its place.
    if nodes.first().is_none_or(|node| node.x != 0.0) {
        nodes.insert(0, ContactNode::new(Kind::Support, 0.0));
    }
    if nodes.last().is_none_or(|node| node.x != length) {
        nodes.push(ContactNode::new(Kind::Support, length));
    }
    find_slopes(enclosed, &mut nodes);
    nodes
}

impl ContactNode {
    pub(crate) fn new(kind: Kind, x: f64) -> Self {
        Self { kind, x, slope: 0.0 }
    }
}

/// A slope that is off by less, as a share, is off by rounding.
const ROUNDING: f64 = 1e-12;
/// How far slopes at corners stay inside what is allowed, as a share: just enough for rounding.
const INSIDE: f64 = 1e-14;

/// The slopes for given places, within what the foundation allows.
fn find_slopes(enclosed: &EnclosedScene<'_>, nodes: &mut [ContactNode]) {
    // Of places that are not in order, or are none, nothing is asked.
    if !nodes.is_sorted_by(|a, b| a.x < b.x) {
        return;
    }
    balance(enclosed, nodes);
    // Each of the two may hold, let go because of the other, and hold again.
    for _ in 0..3 {
        if !at_supports(enclosed, nodes) {
            break;
        }
        balance(enclosed, nodes);
    }
    at_corners(enclosed, nodes);
}

fn balance(enclosed: &EnclosedScene<'_>, nodes: &mut [ContactNode]) {
    // The second step is for rounding.
    for _ in 0..2 {
        let Some(changes) = changes(enclosed, nodes) else { return };
        nodes.iter_mut().zip(changes).for_each(|(node, change)| node.slope += change);
    }
}

/// By how much the slopes have to change for the moments to be balanced, zero where the foundation gives the slope.
fn changes(enclosed: &EnclosedScene<'_>, nodes: &[ContactNode]) -> Option<Vec<f64>> {
    // Rows `[below, diagonal, above, right side]`.
    let mut rows: Vec<[f64; 4]> =
        nodes.iter().map(|j| [0.0, f64::from(u8::from(!j.kind.is_hinge())), 0.0, 0.0]).collect();
    for (i, pair) in nodes.windows(2).enumerate() {
        let Some(span) = enclosed.span(&pair[0], &pair[1]) else { continue };
        let length = span.length();
        if pair[0].kind.is_hinge() {
            rows[i][1] += 4.0 / length;
            rows[i][2] += 2.0 / length;
            rows[i][3] += span.start[2].middle();
        }
        if pair[1].kind.is_hinge() {
            rows[i + 1][0] += 2.0 / length;
            rows[i + 1][1] += 4.0 / length;
            rows[i + 1][3] -= span.end[2].middle();
        }
    }
    tridiagonal(rows)
}

/// Solves rows `[below, diagonal, above, right side]`.
fn tridiagonal(mut rows: Vec<[f64; 4]>) -> Option<Vec<f64>> {
    for i in 1..rows.len() {
        let [_, pivot, above, right] = rows[i - 1];
        let factor = rows[i][0] / pivot;
        rows[i][1] -= factor * above;
        rows[i][3] -= factor * right;
    }
    let mut x = vec![0.0; rows.len() + 1];
    for (i, row) in rows.iter().enumerate().rev() {
        x[i] = (row[3] - row[2] * x[i + 1]) / row[1];
    }
    x.pop();
    x.iter().all(|x| x.is_finite()).then_some(x)
}

/// Turns slopes at corners into the range that the foundation allows.
fn at_corners(enclosed: &EnclosedScene<'_>, nodes: &mut [ContactNode]) {
    for node in nodes.iter_mut().filter(|j| j.kind == Kind::Corner) {
        let [before, after] = enclosed.foundation.slopes(node.x);
        let margin = |bound: f64| INSIDE * (bound.abs() + node.slope.abs());
        let least = before.map_or(f64::NEG_INFINITY, |b| b + margin(b));
        let most = after.map_or(f64::INFINITY, |a| a - margin(a));
        node.slope = if least <= most { node.slope.max(least).min(most) } else { 0.5 * (least + most) };
    }
}

/// A support that the foundation is level with holds a beam that would be steeper than the foundation, and lets go of one
/// that it would have to pull. True if one of them does.
fn at_supports(enclosed: &EnclosedScene<'_>, nodes: &mut [ContactNode]) -> bool {
    let mut changed = false;
    let last = nodes.len() - 1;
    for (i, sign) in [(0, 1.0), (last, -1.0)] {
        let ContactNode { kind, x, slope } = nodes[i];
        let level = enclosed.foundation.depth(x).magnitude() <= 0.0
            && enclosed.foundation.side(x, i == last).is_none_or(|u| u.abs() <= 0.0);
        let below = enclosed.foundation.jet(x, i == last)[1].middle();
        match kind {
            Kind::Support if level && ROUNDING * (slope.abs() + below.abs()) < sign * (slope - below) => {
                nodes[i].kind = Kind::Clamp;
                changed = true;
            }
            Kind::Clamp if curvature(enclosed, nodes, i) < 0.0 => {
                nodes[i] = ContactNode::new(Kind::Support, x);
                changed = true;
            }
            _ => {}
        }
    }
    changed
}

/// `v''` of the beam at one of its ends.
fn curvature(enclosed: &EnclosedScene<'_>, nodes: &[ContactNode], end: usize) -> f64 {
    let span = |a: usize| enclosed.span(&nodes[a], &nodes[a + 1]);
    let of = |span: Option<Span>, jet: fn(&Span) -> f64| span.as_ref().map_or(0.0, jet);
    if end == 0 { of(span(0), |s| s.start[2].middle()) } else { of(span(end - 1), |s| s.end[2].middle()) }
}

impl Kind {
    /// True where the slope of the beam is not that of the foundation.
    fn is_hinge(self) -> bool {
        matches!(self, Self::Support | Self::Corner)
    }
}

impl Span {
    pub(crate) fn length(&self) -> f64 {
        self.to - self.from
    }
}

impl EnclosedFoundation<'_> {
    /// The slopes on the two sides of a corner; [`None`] on the side of a step, which the beam is clear of.
    pub(super) fn slopes(&self, x: f64) -> [Option<f64>; 2] {
        let Foundation::Polyline { points } = self.given else { return [None, None] };
        let first = points.partition_point(|p| p[0] < x);
        let beyond = points.partition_point(|p| p[0] <= x);
        let here = points[first..beyond].iter().fold(f64::INFINITY, |least, p| least.min(p[1]));
        let slope = |at: usize, beside: Option<&[f64; 2]>| {
            let (at, beside) = (points.get(at)?, beside?);
            (at[1] <= here).then(|| (beside[1] - at[1]) / (beside[0] - at[0]))
        };
        [
            first.checked_sub(1).and_then(|before| slope(first, points.get(before))),
            beyond.checked_sub(1).and_then(|last| slope(last, points.get(beyond))),
        ]
    }

    /// Whether the foundation can carry a concentrated force at a place because it has a corner there that points upwards: the
    /// upper edge of a step, or a kink after which it falls more than before.
    pub(super) fn is_corner(&self, x: f64) -> bool {
        let Foundation::Polyline { points } = self.given else { return false };
        let first = points.partition_point(|p| p[0] < x).max(1);
        let beyond = points.partition_point(|p| p[0] <= x).min(points.len() - 1);
        // Of a step infinite, in the direction in which it goes.
        let slope = |a: [f64; 2], b: [f64; 2]| (b[1] - a[1]) / (b[0] - a[0]);
        (first..beyond).any(|i| slope(points[i - 1], points[i]) < slope(points[i], points[i + 1]))
    }
}

#[cfg(test)]
mod tests;
