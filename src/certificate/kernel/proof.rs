//! From nodes to a proven pair: a deflection `v̂` that is admissible everywhere and a moment field `M` whose contact load
//! presses everywhere.
//!
//! In contact `v̂ = g` and `M = −EI g''`; in a span `v̂` is the exact beam between its nodes and `M` the moment field with
//! `M'' = −q` and the moments of its two ends, of which a free end of the beam has none. Then `(g − v̂) p = 0` everywhere,
//! `EI v̂'' + M` is linear in each span, `r` say, and
//!
//! ```text
//! J(v̂) − D(p, R) = Σ L (r₀² + r₀ r₁ + r₁²) / 6 EI
//! ```
//!
//! To prove are `g − v̂ ≥ 0` in spans, `q − EI g'''' ≥ 0` in zones, and at nodes without a support the concentrated forces
//! `M'(x+) − M'(x−) + P ≥ 0`, with a point load `P` that stands there, and `M(x+) = M(x−)`.
//!
//! Where one of them fails, the pair is corrected until it holds: a span is lifted by `α φ` (module `clearance`), which is zero
//! wherever the beam is pressed, and what pulls, `p⁻`, is cut off, which changes `M` by the moments of `p⁻` on the beam on two
//! of its supports, or built in. With `‖m‖² = ∫ m²/EI dx`
//!
//! ```text
//! ‖M⁻‖ ≤ ∫ p⁻ √c(x, x) dx,     gap = ½ (‖r‖ + ‖EI α φ''‖ + ‖M⁻‖)²
//! ```
//!
//! so that what rounding leaves open at a tie costs as much as the rounding, and a wrong witness what it is wrong by. A beam
//! without two supports is held by contact forces: what is cut off is taken from two of them, and none may be used up.

use super::clearance;
use super::contact_node::{ContactNode, EnclosedScene, Slope};
use super::hold::{Hold, Place};
use super::interval::Interval;
use super::load::cells;
use super::polynomial::{Polynomial, number};
use super::pressing::{self, TensionCutOff};
use super::span::{Span, step};

/// `v̂` on a part of the beam.
#[derive(Debug, Clone)]
pub(crate) struct Piece {
    pub(crate) from: f64,
    pub(crate) to: f64,
    /// `v(from + s)`.
    pub(crate) v: Polynomial,
    /// True where it is the foundation itself, exactly.
    pub(crate) follows: bool,
}

/// A proven pair.
#[derive(Debug, Clone)]
pub(crate) struct Pair {
    /// `v̂`: its value and its slope are continuous, and its supports hold it. Pieces end where the load changes its formula
    /// and at point loads.
    pub(crate) pieces: Vec<Piece>,
    /// `J(v̂) − D(p, R)`.
    pub(crate) gap: Interval,
    /// What the supports exert upwards, from left to right, where the contacts of `M` are those of the beam.
    pub(crate) reactions: Vec<Interval>,
    /// What holds the beam: each of them alone bounds the distance of `v̂` from `v*`.
    pub(crate) holds: Vec<Hold>,
    /// How far `v̂` was lifted at most off the deflection that the places of the witness make; infinite if it is of no witness.
    pub(crate) lifted: f64,
}

impl Pair {
    /// Whether a turn about a place is all that is not known.
    pub(crate) fn turns_about(&self, x: f64) -> bool {
        matches!(self.holds[..], [Hold(left, right)] if x <= left.from && right.to <= x)
    }
}

/// The pair of some nodes, if there is one.
pub(crate) fn pair(enclosed: &EnclosedScene<'_>, nodes: &[ContactNode]) -> Option<Pair> {
    if !is_complete(enclosed, nodes) {
        return None;
    }
    let stiffness = Interval::exact(enclosed.stiffness);
    // Part i is that to the left of node i.
    let ends = |i: usize| [i.checked_sub(1).map(|i| &nodes[i]), nodes.get(i)];
    let spans: Vec<Option<Span>> = (0..=nodes.len()).map(|i| enclosed.span(ends(i)[0], ends(i)[1])).collect();
    let beam = Moments { enclosed, nodes, spans: &spans };
    let mut gap = Interval::ZERO;
    let (mut lifts, mut lifted) = (Interval::ZERO, 0.0_f64);
    let mut cut_off = TensionCutOff::default();
    let mut shears = Vec::new();
    let mut pieces = Vec::new();
    for (i, span) in spans.iter().enumerate() {
        let Some(span) = span else {
            let [Some(left), Some(right)] = ends(i) else {
                shears.push([Interval::ZERO; 2]);
                continue;
            };
            pressing::zone(enclosed, left.x, right.x, &mut cut_off)?;
            shears.push([(left, false), (right, true)].map(|(j, left)| -(stiffness * enclosed.gap.jet(j.x, left)[3])));
            pieces.extend(lying(enclosed, left.x, right.x));
            continue;
        };
        let length = Interval::exact(span.to) - Interval::exact(span.from);
        if let [Some(_), Some(_)] = ends(i) {
            let moments = [beam.moment(i - 1, 1), beam.moment(i, 0)];
            let r = [stiffness * span.start[2] + moments[0], stiffness * span.end[2] + moments[1]];
            // Not from the third derivative, of which rounding is larger by the square of a short span.
            let shear = (moments[1] - moments[0] + span.loaded[0]) / length;
            shears.push([shear, shear - span.loaded[1]]);
            gap = gap + length * (r[0].square() + r[1].square() + (r[0] + r[1]).square()) / (number(12) * stiffness);
        } else {
            shears.push([span.start, span.end].map(|jet| -(stiffness * jet[3])));
        }
        let mut curve = span.curve(Vec::new(), enclosed.load, enclosed.stiffness);
        let alpha = clearance::lift(enclosed, span, ends(i))?;
        if 0.0 < alpha {
            let powers = ends(i).map(|end| clearance::power(enclosed, end));
            let lift = clearance::shape(span, powers).times(Interval::exact(alpha));
            lifts = lifts + lift.derivative().derivative().integral_of_square(length) * stiffness;
            lifted = lifted.max(lift.range(length).magnitude());
            for ([from, _], v) in &mut curve {
                *v = v.minus(&lift.shifted(Interval::exact(*from) - Interval::exact(span.from)));
            }
        }
        pieces.extend(curve.into_iter().map(|([from, to], v)| Piece { from, to, v, follows: false }));
    }
    let (mut reactions, mut presses) = (Vec::new(), Vec::new());
    for (i, node) in nodes.iter().enumerate() {
        let point = enclosed.load.point(node.x).unwrap_or(Interval::ZERO);
        let force = shears[i + 1][0] - shears[i][1] + point;
        if enclosed.support(node.x).is_some() {
            reactions.push(force);
        } else {
            cut_off.force(node.x, force);
            presses.extend((0.0 < force.lo()).then(|| (Place::at(node.x), force.lo())));
        }
        if let Some((jump, made)) = beam.jump(i) {
            cut_off.couple(node.x, jump, made);
        }
    }
    let mut holds = held(enclosed, nodes);
    let by_contacts = holds.is_empty();
    if by_contacts {
        // Parts of zones press, too, and so do loads that stand in them. What is taken from a part is taken in proportion to what
        // presses there: the mean of what single places would give, of which the worst is counted.
        for (from, to) in nodes.windows(2).filter(|w| w[0].lies).map(|w| (w[0].x, w[1].x)) {
            let breaks = enclosed.load.breaks(from, to);
            let stands = |x: &f64| Some((Place::at(*x), enclosed.load.point(*x)?.lo()));
            let stand: Vec<(Place, f64)> = breaks.iter().filter_map(stands).collect();
            let parts = cells(from, to, breaks).into_iter().flat_map(|cell| outer_thirds(enclosed, cell));
            presses.extend(stand.into_iter().chain(parts).filter(|p| 0.0 < p.1));
        }
        presses.extend(enclosed.supports.iter().map(|s| (Place::at(s.x), f64::INFINITY)));
        holds.extend(widest(&mut presses));
    }
    // Beside a single place the gap is open by this much, and the force is moved there.
    let mut open = 0.0;
    if holds.is_empty() {
        let couple = beam.jump(0).map_or(0.0, |(jump, _)| jump.magnitude());
        let single = presses.iter().find(|(place, _)| place.to <= place.from);
        let (Some(&(Place { from: x, .. }, force)), []) = (single, enclosed.supports) else { return None };
        let force = Interval::exact(force);
        let hold = match nodes {
            [node] => astride(enclosed, node, [&spans[0], &spans[1]], couple / force.lo()).filter(|_| lifted <= 0.0),
            _ => nodes.windows(2).find(|w| w[0].lies && w[0].x < x && x < w[1].x).map(|w| inside(w[0].x, x, w[1].x)),
        }?;
        open = hold.0.off;
        cut_off.force(x, -force);
        // Each takes half of the force and at most a thirtieth for the couple. What is counted below as taken from both is all
        // of it, and as much as is needed for that is added here: less than is there remains.
        presses = [hold.0, hold.1].map(|place| (place, (number(6) * force / number(5)).lo())).to_vec();
        holds.push(hold);
    }
    let [moments, share] = cut_off.carried(&holds, enclosed.stiffness);
    let correction = lifts.sqrt() + moments;
    let root = (number(2) * Interval::between(gap.lo().max(0.0), gap.hi())).sqrt() + correction;
    // Without correction the square would only add rounding.
    let gap = if correction.is_zero() { gap } else { root.square() / number(2) };
    let gap = if 0.0 < open { gap + share * Interval::exact(open) } else { gap }.hi();
    for place in holds.iter_mut().filter(|_| by_contacts).flat_map(|Hold(left, right)| [left, right]) {
        let force =
            presses.iter().find(|(other, _)| (other.from - place.from).abs() <= 0.0).map_or(0.0, |(_, force)| *force);
        if force < f64::INFINITY {
            // What is cut off is taken from it.
            let left = (Interval::exact(force) - share).lo();
            place.off =
                if 0.0 < left { (Interval::exact(gap) / Interval::exact(left)).hi().max(open) } else { return None };
        }
    }
    let corrected = Interval::around_zero(share.hi());
    Some(Pair {
        pieces,
        gap: Interval::between(0.0, gap),
        reactions: reactions.into_iter().map(|force| force + corrected).collect(),
        holds,
        lifted,
    })
}

/// What holds the beam whatever it touches: neighbouring two of its supports, and one at which it cannot turn, or about which the
/// loads are in balance.
fn held(enclosed: &EnclosedScene<'_>, nodes: &[ContactNode]) -> Vec<Hold> {
    let twice = |x: f64| Hold(Place::at(x), Place::at(x));
    let two = enclosed.supports.windows(2).map(|w| Hold(Place::at(w[0].x), Place::at(w[1].x)));
    let one = enclosed.supports.iter().filter(|s| s.is_fixed).map(|s| s.x);
    two.chain(one.chain(enclosed.balanced_at.filter(|_| nodes.len() == 1)).map(twice)).collect()
}

/// The outer thirds of a part of a zone without a break of the load, with what presses on them at least: the load, and what the
/// shear of the beam that follows the ground changes by.
fn outer_thirds(enclosed: &EnclosedScene<'_>, [from, to]: [f64; 2]) -> [(Place, f64); 2] {
    let third = (to - from) / 3.0;
    [[from, from + third], [to - third, to]].map(|[from, to]| {
        let [start, end] = [(from, false), (to, true)].map(|(x, left)| enclosed.gap.jet(x, left)[3]);
        let width = Interval::exact(to) - Interval::exact(from);
        let one = Polynomial::new(&[Interval::exact(1.0)]);
        let load = enclosed.load.cell(from, to).integral_of_product(&one, width);
        (Place { from, to, off: 0.0 }, (Interval::exact(enclosed.stiffness) * (start - end) + load).lo())
    })
}

/// Of places with what presses there the two that hold the beam best: strongly, and far apart.
fn widest(presses: &mut [(Place, f64)]) -> Option<Hold> {
    /// Of the strongest places.
    const MOST: usize = 64;
    presses.sort_by(|a, b| b.1.total_cmp(&a.1));
    let strongest = &presses[..presses.len().min(MOST)];
    let pairs = strongest.iter().flat_map(|a| strongest.iter().map(move |b| (a, b)));
    let apart = pairs.filter(|(a, b)| a.0.to < b.0.from).map(|(a, b)| ((b.0.from - a.0.to) * a.1.min(b.1), a.0, b.0));
    apart.max_by(|a, b| a.0.total_cmp(&b.0)).map(|(_, left, right)| Hold(left, right))
}

/// The two sides of the single place that carries a beam, where it is tangent to the ground, so near to it that the gap is hardly
/// open there, and so far from it that two halves of the force balance a couple, given as a share of the force.
fn astride(enclosed: &EnclosedScene<'_>, node: &ContactNode, spans: [&Option<Span>; 2], couple: f64) -> Option<Hold> {
    /// Of the length of the beam.
    const NEAR: f64 = 1.0 / 274_877_906_944.0;
    let [Some(before), Some(after)] = spans else { return None };
    let far = (NEAR * enclosed.length).max(16.0 * couple);
    let [left, right] = [node.x - far, node.x + far];
    let inside = 0.0 <= left && right <= enclosed.length && left < node.x && node.x < right;
    let smooth = enclosed.gap.is_smooth_between(left, right) && enclosed.is_tangent(node, true);
    if !inside
        || !smooth
        || !enclosed.is_tangent(node, false)
        || !enclosed.load.breaks(left, right).iter().all(|x| (x - node.x).abs() <= 0.0)
    {
        return None;
    }
    let width = Interval::exact(right) - Interval::exact(left);
    let beside =
        enclosed.gap.mirrored_cell(left, node.x).minus(&before.mirrored(left, enclosed.load, enclosed.stiffness));
    let beyond = step(&after.start, [node.x, right], enclosed.load, enclosed.stiffness).0;
    let beyond = enclosed.gap.cell(node.x, right).minus(&beyond);
    let open = [beside, beyond].map(|clear| clear.vanishing(2).range(width).hi().max(0.0));
    let off = open[0].max(open[1]).max(f64::MIN_POSITIVE);
    let place = |x: f64| Place { off, ..Place::at(x) };
    Some(Hold(place(left), place(right)))
}

/// The two sides of a load that is carried where it stands in a zone, where the gap is closed.
fn inside(from: f64, x: f64, to: f64) -> Hold {
    // Nearer than the nearer end of the zone by thirty powers of two.
    let far = (x - from).min(to - x) / 1_073_741_824.0;
    let place = |x: f64| Place { off: f64::MIN_POSITIVE, ..Place::at(x) };
    Hold(place(x - far), place(x + far))
}

/// Whether nodes are in order, have all supports among them, end every zone that they start, and follow the ground only where
/// they meet it. Of anything else nothing follows.
fn is_complete(enclosed: &EnclosedScene<'_>, nodes: &[ContactNode]) -> bool {
    let in_order = nodes.windows(2).all(|w| w[0].x < w[1].x) && nodes.last().is_some_and(|node| !node.lies);
    let inside = nodes.iter().all(|node| (0.0..=enclosed.length).contains(&node.x));
    let supports = nodes.iter().filter(|node| enclosed.support(node.x).is_some()).count();
    // A beam that follows the ground to a support is held there only if the ground is, on that side of a step.
    let meets = |node: &ContactNode, left: bool| {
        let support = enclosed.support(node.x);
        let held = support.and_then(|s| s.slope);
        enclosed.gap.ground.is_upper(node.x, left)
            && support.is_none_or(|s| s.grounded[usize::from(!left)])
            && held.map_or(enclosed.is_tangent(node, left), |slope| slope == enclosed.gap.jet(node.x, left)[1])
    };
    let meet = nodes.iter().enumerate().all(|(i, node)| {
        let lies = [0 < i && nodes[i - 1].lies, node.lies];
        let built_in = enclosed.support(node.x).is_some_and(|s| s.slope.is_some());
        let own = !built_in && matches!(node.slope, Slope::OfGround { .. });
        let follows = own && !lies[0] && !lies[1];
        (!follows || meets(node, true) || meets(node, false))
            && (!lies[0] || meets(node, true))
            && (!lies[1] || meets(node, false))
    });
    in_order && inside && supports == enclosed.supports.len() && meet
}

/// The foundation between two places, as pieces.
fn lying(enclosed: &EnclosedScene<'_>, from: f64, to: f64) -> impl Iterator<Item = Piece> {
    let mut breaks = enclosed.gap.breaks(from, to);
    breaks.extend(enclosed.load.breaks(from, to));
    let gap = enclosed.gap;
    cells(from, to, breaks).into_iter().map(move |[from, to]| Piece { from, to, v: gap.cell(from, to), follows: true })
}

/// The moments beside the nodes, on the left side, 0, and on the right one, 1.
struct Moments<'a> {
    enclosed: &'a EnclosedScene<'a>,
    nodes: &'a [ContactNode],
    /// The part to the left of each node, and that to the right of the last one.
    spans: &'a [Option<Span>],
}

impl Moments<'_> {
    /// `v̂''`, zero where there is no beam.
    fn curvature(&self, i: usize, side: usize) -> Interval {
        match &self.spans[i + side] {
            Some(span) => [span.end, span.start][side][2],
            None if i + side == 0 || i + side == self.nodes.len() => Interval::ZERO,
            None => self.enclosed.gap.jet(self.nodes[i].x, side == 0)[2],
        }
    }

    /// Whether only one moment is possible: in a zone, beside a free end, and where there is no beam.
    fn is_given(&self, i: usize, side: usize) -> bool {
        self.spans[i + side].is_none() || i + side == 0 || i + side == self.nodes.len()
    }

    /// Whether something at a node may make the moment jump.
    fn may_jump(&self, i: usize) -> bool {
        let support = self.enclosed.support(self.nodes[i].x);
        support.is_some_and(|s| s.slope.is_some() || matches!(self.nodes[i].slope, Slope::OfGround { .. }))
    }

    /// `M`. Where only continuity is asked for, a number between the moments of the two spans.
    fn moment(&self, i: usize, side: usize) -> Interval {
        let own = |side: usize| -(Interval::exact(self.enclosed.stiffness) * self.curvature(i, side));
        if self.may_jump(i) || self.is_given(i, side) {
            own(side)
        } else if self.is_given(i, 1 - side) {
            own(1 - side)
        } else {
            let sum = self.curvature(i, 0).middle() + self.curvature(i, 1).middle();
            Interval::exact(-0.5 * self.enclosed.stiffness * sum)
        }
    }

    /// `M(x+) − M(x−)` where it may not vanish and is not made by what the beam is built in, or in which the loads are in balance;
    /// and whether ground on the left and on the right can make it.
    fn jump(&self, i: usize) -> Option<(Interval, [bool; 2])> {
        let node = &self.nodes[i];
        let support = self.enclosed.support(node.x);
        let balanced = self.nodes.len() == 1 && self.enclosed.balanced_at == Some(node.x);
        let built_in = support.is_some_and(|s| s.slope.is_some());
        let may = self.may_jump(i) || (self.is_given(i, 0) && self.is_given(i, 1));
        let made = |side| support.is_some_and(|s| s.grounded[side]) && self.enclosed.is_tangent(node, side == 0);
        (may && !built_in && !balanced).then(|| (self.moment(i, 1) - self.moment(i, 0), [0, 1].map(made)))
    }
}

#[cfg(test)]
mod tests;
