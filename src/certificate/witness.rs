//! Contact nodes from a candidate contact list: the positions as given, and the slopes that follow from them.
//!
//! Only the supports are added to the listed contacts, and touched corners where the listed contacts prove little. No position is
//! changed: an error remains and increases the duality gap of [`proof`](super::kernel::proof). The list also states at which supports a
//! foundation at their level fixes the slope. The slopes `θ` of the beam at other supports and at corners are unknown. For the given
//! positions they minimise the energy of the spans and solve
//!
//! ```text
//! EI v''(x−) = EI v''(x+) + C,     EI v'' = 0 at an end of the beam, given by the loads beside an overhang
//! ∂v''(a)/∂θ_a = −4/L,  ∂v''(a)/∂θ_b = −2/L,     ∂v''(b)/∂θ_a = 2/L,  ∂v''(b)/∂θ_b = 4/L     in a uniform span from a to b
//! ```
//!
//! This is a tridiagonal linear system. The slope at a corner is then limited to the range that the foundation allows. A beam that can
//! rotate about a single position gets the slope nearest to zero that is clear of the foundation, found by sampling. No proof depends on
//! these slopes: a wrong slope makes the bounds wide.

use super::kernel::contact_node::{ContactNode, EnclosedScene, EnclosedSupport, Slope};
use super::kernel::gap::EnclosedGap;
use super::kernel::giving::Giving;
use super::kernel::interval::Interval;
use super::kernel::polynomial::Polynomial;
use super::kernel::proof::{Pair, Piece};
use crate::scene::Scale;
use crate::state::Contact;

/// The contact nodes of the supports and of a list of contacts, given in order and in the units of the scene, with the slopes that
/// follow from their positions. A contact at a single position is a corner of the gap if there is one, or the end of the beam, and
/// otherwise a point of tangency. `held` contains the positions of the supports at which the foundation fixes the slope, and whether it
/// does so from the left.
#[expect(clippy::float_cmp, reason = "a contact from a place to the same place is a point")]
pub(super) fn nodes(
    enclosed: &EnclosedScene<'_>,
    contacts: &[Contact],
    held: &[(f64, bool)],
    scale: &Scale,
) -> Vec<ContactNode> {
    let mut nodes: Vec<ContactNode> = Vec::with_capacity(2 * contacts.len() + enclosed.supports.len());
    let mut in_zone = false;
    for contact in contacts {
        let [from, to] = [contact.from / scale.length, contact.to / scale.length];
        // Zones that share an end are one zone, and a contact at the end of a zone is part of the zone.
        if in_zone && nodes.last().is_some_and(|node| node.x == from) {
            nodes.pop();
            nodes.push(enclosed.end_of_zone(to));
            continue;
        }
        in_zone = from != to;
        if in_zone {
            nodes.extend([ContactNode::start(from), enclosed.end_of_zone(to)]);
        } else if enclosed.support(from).is_some() {
            // A contact point at a support is the support.
        } else if from == 0.0 || from == enclosed.length || enclosed.is_edge(from) {
            nodes.push(ContactNode::free(from));
        } else {
            nodes.push(ContactNode::on_ground(from, false));
        }
    }
    // A zone that begins or ends at a support replaces it, and a zone that extends beyond it includes it.
    for support in enclosed.supports {
        let at = nodes.iter().position(|node| support.x <= node.x).unwrap_or(nodes.len());
        if nodes.get(at).is_none_or(|node| node.x != support.x) {
            let lies = 0 < at && nodes[at - 1].lies;
            let side =
                held.iter().find(|(x, _)| x / scale.length == support.x).map(|(_, from_the_left)| *from_the_left);
            nodes.insert(at, ContactNode::at_support(support.x, lies, support.held_side(side)));
        }
    }
    if nodes.is_empty() {
        nodes.extend(enclosed.balanced_at.map(ContactNode::free));
    }
    find_slopes(enclosed, &mut nodes);
    nodes
}

/// The list of contacts with additional corners and ends that the beam touches up to the lift of its deflection: a body at rest can
/// touch corners that carry no force. [`None`] if there are none.
pub(super) fn with_touched(
    enclosed: &EnclosedScene<'_>,
    contacts: &[Contact],
    pair: &Pair,
    scale: &Scale,
) -> Option<Vec<Contact>> {
    /// A lift by rounding on one side of a position raises the other side above the foundation by the same amount times the ratio of the
    /// lever arms (*tuned* on random sleepers).
    const ARMS: f64 = 16.0;
    let mut all = contacts.to_vec();
    for Piece { from, to, v, .. } in pair.pieces.iter().filter(|piece| !piece.pressed && 0.0 < pair.lifted) {
        let touches = |x: &f64| {
            let clearance = enclosed.gap.depth(*x) - v.at(Interval::length(*from, *x));
            let carries = *x <= 0.0 || enclosed.length <= *x || enclosed.is_edge(*x);
            clearance.lo() <= ARMS * pair.lifted && carries && enclosed.support(*x).is_none()
        };
        let places = enclosed.gap.breaks(*from, *to).into_iter().chain([*from, *to]);
        all.extend(places.filter(touches).map(|x| Contact::at(x * scale.length, 0.0)));
    }
    all.sort_by(|a, b| a.from.total_cmp(&b.from));
    // A step has two points, and a contact may already be listed there.
    all.dedup_by(|second, first| second.from <= first.from);
    (contacts.len() < all.len()).then_some(all)
}

impl EnclosedScene<'_> {
    /// The node at the end of a zone: at a hinge the slope is free.
    fn end_of_zone(&self, x: f64) -> ContactNode {
        if self.is_hinge(x) { ContactNode::free(x) } else { ContactNode::on_ground(x, true) }
    }

    /// Whether the beam may rest on a position and rotate there: at a corner of the gap, or at a joint.
    fn is_edge(&self, x: f64) -> bool {
        self.gap.is_corner(x) || self.is_joint(x)
    }
}

impl EnclosedSupport {
    /// The side from which the foundation fixes the slope: the stated side if the foundation is level with a simple support there;
    /// without a statement the left side, if no other slope is possible.
    fn held_side(&self, said: Option<bool>) -> Option<bool> {
        let is_level = |from_the_left: &bool| self.tangent[usize::from(!from_the_left)];
        said.or(self.is_fixed.then_some(true)).filter(is_level).filter(|_| self.slope.is_none())
    }
}

impl ContactNode {
    /// A node with a free slope.
    pub(super) fn free(x: f64) -> Self {
        Self { x, slope: Slope::Free(0.0), lies: false }
    }

    /// A node with the slope of the gap, on one of its sides.
    pub(super) fn on_ground(x: f64, from_the_left: bool) -> Self {
        Self { x, slope: Slope::OfGround { from_the_left }, lies: false }
    }

    /// A node at a support, inside a zone or not; `side` is the side from which the foundation fixes the slope, if it does.
    fn at_support(x: f64, lies: bool, side: Option<bool>) -> Self {
        match side {
            _ if lies => Self::start(x),
            Some(from_the_left) => Self::on_ground(x, from_the_left),
            None => Self::free(x),
        }
    }

    /// The start of a zone.
    fn start(x: f64) -> Self {
        Self { lies: true, ..Self::on_ground(x, false) }
    }
}

/// Margin of slopes at corners from the limits of the allowed range, as a share: just enough for rounding.
const INSIDE: f64 = 1e-14;

/// Finds the slopes for given positions, within the range that the foundation allows.
fn find_slopes(enclosed: &EnclosedScene<'_>, nodes: &mut [ContactNode]) {
    // Positions that are out of order or NaN have no slopes.
    if !nodes.is_sorted_by(|a, b| a.x < b.x) {
        return;
    }
    if let [node] = nodes
        && enclosed.tension <= 0.0
        && (enclosed.balanced_at == Some(node.x) || enclosed.supports.is_empty())
        && let Slope::Free(slope) = &mut node.slope
    {
        *slope = turn(enclosed, node.x);
        return;
    }
    if enclosed.tension == 0.0 {
        balance(enclosed, nodes);
    } else {
        as_given(enclosed, nodes);
    }
    at_corners(enclosed, nodes);
}

/// The slope nearest to zero at which a beam that can rotate about a position is clear of the foundation at all samples.
fn turn(enclosed: &EnclosedScene<'_>, about: f64) -> f64 {
    /// Distance of that slope from its limits, as a share of the range between them: more than the samples can miss.
    const FROM_LIMITS: f64 = 1e-6;
    let node = ContactNode::free(about);
    let spans = [enclosed.span(None, Some(&node)), enclosed.span(Some(&node), None)];
    // The largest rotation downwards on the left and on the right.
    let [left, right] = [0, 1].map(|side| {
        let sign = if side == 0 { -1.0 } else { 1.0 };
        let mut most = level_slopes(enclosed, about)[side].map_or(f64::INFINITY, |slope| sign * slope);
        if let Some(span) = &spans[side] {
            let breaks = enclosed.gap.breaks(span.from, span.to);
            for ([a, b], [v, _]) in span.curves(enclosed, breaks) {
                let clear = enclosed.gap.about(a, [a, b]).minus(&v);
                let slope = |s: f64| {
                    let clear = clear.at(Interval::exact(s));
                    if clear.is_finite() { clear.middle() / (sign * (a + s - about)) } else { f64::INFINITY }
                };
                most = least_sample(slope, b - a, most);
                for y in [a, b] {
                    if enclosed.pushes_at(y) && 0.0 < (y - about).abs() {
                        let clear = enclosed.gap.depth(y) - v.at(Interval::length(a, y));
                        most = most.min(clear.middle() / (y - about).abs());
                    }
                }
            }
        }
        most
    });
    // At a limit the beam would touch the foundation, and rounding could cause penetration.
    let size = [left, right].into_iter().filter(|slope| slope.is_finite()).fold(0.0, |size: f64, s| size.max(s.abs()));
    let inside = FROM_LIMITS * (left + right).min(size).max(0.0);
    if -left <= right { 0.0_f64.max(inside - left).min(right - inside) } else { 0.5 * (right - left) }
}

/// The minimum of a function for `0 ≤ s ≤ width`, or `bound` if that is smaller. The function is sampled, and more samples are taken
/// around the minimum as long as it may be below `bound`. Values that are infinite or NaN are ignored.
fn least_sample(function: impl Fn(f64) -> f64, width: f64, bound: f64) -> f64 {
    /// Parts per round: the next round covers a quarter of the previous interval.
    const PARTS: usize = 8;
    /// A minimum is flat, so half of the digits of its position are enough.
    const ROUNDS: usize = 16;
    let (mut least, mut part) = (bound, [0.0, width]);
    for _ in 0..ROUNDS {
        #[expect(clippy::cast_precision_loss, reason = "small numbers")]
        let place = |k: usize| part[0] + (part[1] - part[0]) * (k as f64 / PARTS as f64);
        let samples: Vec<f64> = (0..=PARTS).map(|k| function(place(k))).collect();
        let finite = (0..=PARTS).filter(|k| samples[*k].is_finite());
        let Some(best) = finite.min_by(|a, b| samples[*a].total_cmp(&samples[*b])) else { break };
        least = least.min(samples[best]);
        let beside = [best.saturating_sub(1), (best + 1).min(PARTS)];
        let rise = beside.map(|k| samples[k] - samples[best]).into_iter().fold(0.0, f64::max);
        if least < samples[best] - rise {
            break;
        }
        part = beside.map(place);
    }
    least
}

/// Under an axial force the slopes come from the proposed deflection, just to the right of a node or, if there is none, to the left.
fn as_given(enclosed: &EnclosedScene<'_>, nodes: &mut [ContactNode]) {
    for node in nodes {
        let Slope::Free(slope) = &mut node.slope else { continue };
        let right = enclosed.hung.iter().find(|part| part.from <= node.x && node.x < part.to);
        let Some(part) = right.or_else(|| enclosed.hung.iter().find(|part| part.to.total_cmp(&node.x).is_eq())) else {
            continue;
        };
        let turned = Polynomial::of(part.deflection.iter().map(|c| Interval::exact(*c))).derivative();
        *slope = turned.at(Interval::length(part.from, node.x)).middle();
    }
}

/// Finds the slopes for which the moments are in equilibrium.
pub(super) fn balance(enclosed: &EnclosedScene<'_>, nodes: &mut [ContactNode]) {
    // The second step reduces rounding.
    for _ in 0..2 {
        let Some(changes) = changes(enclosed, nodes) else { return };
        for (node, change) in nodes.iter_mut().zip(changes) {
            if let Slope::Free(slope) = &mut node.slope {
                *slope += change;
            }
        }
    }
}

/// The changes of the slopes that bring the moments into equilibrium, zero where a support or the foundation fixes the slope.
fn changes(enclosed: &EnclosedScene<'_>, nodes: &[ContactNode]) -> Option<Vec<f64>> {
    let built_in = |node: &ContactNode| enclosed.support(node.x).is_some_and(|s| s.slope.is_some());
    let is_hinge: Vec<bool> = nodes.iter().map(|j| matches!(j.slope, Slope::Free(_)) && !built_in(j)).collect();
    // Rows `[below, diagonal, above, right side]`.
    let mut rows: Vec<[f64; 4]> = is_hinge.iter().map(|hinge| [0.0, f64::from(u8::from(!hinge)), 0.0, 0.0]).collect();
    let stiffness = |x: f64, left: bool| enclosed.stiffness_beside(x, left).middle() / enclosed.unit();
    for i in 0..=nodes.len() {
        let ends = [i.checked_sub(1).map(|i| &nodes[i]), nodes.get(i)];
        let Some(span) = enclosed.span(ends[0], ends[1]) else { continue };
        // The moments of an overhang do not depend on its slope.
        let [[near, across], [_, far]] =
            if let [Some(_), Some(_)] = ends { span.answer(enclosed) } else { [[0.0; 2]; 2] };
        if 0 < i && is_hinge[i - 1] {
            rows[i - 1][1] -= near;
            rows[i - 1][2] -= across;
            rows[i - 1][3] += span.start[2].middle() * stiffness(span.from, false);
        }
        if i < nodes.len() && is_hinge[i] {
            rows[i][0] -= across;
            rows[i][1] += far;
            rows[i][3] -= span.end[2].middle() * stiffness(span.to, true);
        }
    }
    for (row, node) in rows.iter_mut().zip(nodes).zip(&is_hinge).filter(|(_, hinge)| **hinge).map(|(both, _)| both) {
        row[3] += enclosed.load.couple(node.x).middle() / enclosed.unit();
        let gives = enclosed.support(node.x).and_then(|support| support.gives);
        if let Some(Giving { turning: Some([k, without]), .. }) = gives {
            let (k, [_, slope]) = (k.middle() / enclosed.unit(), enclosed.end(node));
            row[1] += k;
            row[3] -= k * (slope - without).middle();
        }
    }
    tridiagonal(rows)
}

/// Solves a tridiagonal system with rows `[below, diagonal, above, right side]`.
pub(crate) fn tridiagonal(mut rows: Vec<[f64; 4]>) -> Option<Vec<f64>> {
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

/// Limits the slopes at corners to the range that the foundation allows.
fn at_corners(enclosed: &EnclosedScene<'_>, nodes: &mut [ContactNode]) {
    for node in nodes.iter_mut().filter(|node| enclosed.support(node.x).is_none()) {
        let Slope::Free(slope) = &mut node.slope else { continue };
        let [before, after] = enclosed.gap.slopes(node.x);
        // The slope of a node is the slope beyond its joint.
        let before = before.filter(|_| !enclosed.is_joint(node.x));
        let margin = |bound: f64| INSIDE * (bound.abs() + slope.abs());
        let least = before.filter(|_| 0.0 < node.x).map_or(f64::NEG_INFINITY, |b| b + margin(b));
        let most = after.filter(|_| node.x < enclosed.length).map_or(f64::INFINITY, |a| a - margin(a));
        *slope = if least <= most { slope.max(least).min(most) } else { 0.5 * (least + most) };
    }
}

/// The slopes of the foundation on the two sides of a simple support, where the foundation is level with the support.
fn level_slopes(enclosed: &EnclosedScene<'_>, x: f64) -> [Option<f64>; 2] {
    let tangent = enclosed.support(x).filter(|s| s.slope.is_none()).map_or([false; 2], |s| s.tangent);
    [0, 1].map(|side| tangent[side].then(|| enclosed.gap.jet(x, side == 0)[1].middle()))
}

impl EnclosedGap<'_> {
    /// The slopes on the two sides of a position; [`None`] on the lower side of a step, which the beam is clear of.
    fn slopes(&self, x: f64) -> [Option<f64>; 2] {
        [true, false].map(|left| self.ground.is_upper(x, left).then(|| self.jet(x, left)[1].middle()))
    }

    /// Whether a position can carry a concentrated force because of an upward corner: the upper edge of a step, a kink after which the
    /// foundation falls away more steeply than before, or a compression-only support.
    pub(super) fn is_corner(&self, x: f64) -> bool {
        match self.slopes(x) {
            _ if self.is_smooth_at(x) => false,
            [Some(before), Some(after)] => before < after,
            _ => true,
        }
    }
}

#[cfg(test)]
mod tests;
