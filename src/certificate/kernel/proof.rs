//! From nodes to a proven pair: a deflection `v̂` that is admissible everywhere and a moment field `M` whose contact load is compressive
//! everywhere.
//!
//! In contact `v̂ = g` and `M = −EI g''`. In a span `v̂` is the exact beam between its nodes, and `M` is the moment field with `M'' = −q`
//! and the moments of its two ends; at a free end of the beam this moment is zero. Then `(g − v̂) p = 0` everywhere, `r = EI v̂'' + M` is
//! linear in each span, and
//!
//! ```text
//! J(v̂) − D(p, R) = Σ L (r₀² + r₀ r₁ + r₁²) / 6 EI
//! ```
//!
//! The proof needs `g − v̂ ≥ 0` in spans, and `q − EI g'''' ≥ 0` in zones, in which no couple may act. At nodes without a support it
//! needs concentrated forces `M'(x+) − M'(x−) + P ≥ 0`, with a point load `P` there, and `M(x+) = M(x−) + C` with a couple `C`. In hinges
//! it needs `M = 0`.
//!
//! If one of these conditions fails, the pair is corrected until it is satisfied. A span is lifted by `α φ` (module `clearance`), which
//! is zero wherever the beam is pressed. Tension `p⁻` is cut off. This changes `M` by the moments of `p⁻` on the beam on two of its
//! supports, or built in. With `‖m‖² = ∫ m²/EI dx`
//!
//! ```text
//! ‖M⁻‖ ≤ ∫ p⁻ √c(x, x) dx,     gap = ½ (‖r‖ + ‖EI α φ''‖ + ‖M⁻‖)²
//! ```
//!
//! So a tie that rounding leaves open costs as much as the rounding, and a wrong witness costs as much as its error. A beam without two
//! supports is held by contact forces: what is cut off is taken from two of them, and neither may be used up. If only one position
//! carries the beam, the foundation next to it stops the rotation of the beam (`stops`), and carries couples.

use super::clearance;
use super::contact_node::{ContactNode, EnclosedScene, EnclosedSupport, Slope};
use super::giving;
use super::held::{carriers, held_by};
use super::interval::Interval;
use super::polynomial::{Polynomial, number};
use super::pressing::{self, PullCutOff};
use super::reference::Line;
use super::span::Span;
use super::tension::Taut;

/// `v̂` on a part of the beam.
#[derive(Debug, Clone)]
pub(crate) struct Piece {
    pub(crate) from: f64,
    pub(crate) to: f64,
    /// `v(from + s)`.
    pub(crate) v: Polynomial,
    /// Whether the contact load of `M` may be positive here. On a rigid foundation `v` is then the foundation itself, exactly.
    pub(crate) pressed: bool,
}

/// A proven pair.
#[derive(Debug, Clone)]
pub(crate) struct Pair {
    /// `v̂`, with continuous value and slope, which satisfies the support conditions. Pieces end where the formula of the load changes
    /// and at point loads.
    pub(crate) pieces: Vec<Piece>,
    /// An upper bound of `J(v̂) − D(p, R)`.
    pub(crate) gap: f64,
    /// The positions that carry the beam and the upward force at each, from left to right, if the contacts of `M` are the contacts of the
    /// beam.
    pub(crate) carried: Vec<(f64, Interval)>,
    /// The reference lines: each of them alone bounds the distance of `v̂` from `v*`.
    pub(crate) lines: Vec<Line>,
    /// The reference lines through parts of zones, if they were requested.
    pub(crate) zones: Vec<Line>,
    /// The position about which the beam can rotate without a force, if the contacts of `M` do not determine its position.
    pub(crate) turns_about: Option<f64>,
    /// The largest distance by which `v̂` was lifted from the deflection implied by the positions of the witness; infinite if it follows
    /// from no witness.
    pub(crate) lifted: f64,
    /// Data for an elastic foundation; [`None`] on a rigid one.
    pub(crate) ground: Option<Sprung>,
    /// The energy of joints and springs, `½Σ k [v̂']²` and so on, minus the work of springs that act as loads.
    pub(crate) turned: Interval,
    /// [`EnclosedScene::soft`].
    pub(crate) soft: f64,
    /// The restraints of the beam as a string.
    pub(crate) taut: Taut,
}

/// Further data of a pair on an elastic foundation.
#[derive(Debug, Clone)]
pub(crate) struct Sprung {
    /// `½∫ k (v̂ − g)₊²`.
    pub(crate) energy: Interval,
    /// `M(from + s)` of the pair before tension is cut off, by parts from left to right: in equilibrium with the loads except at
    /// supports.
    pub(crate) moments: Vec<([f64; 2], Polynomial)>,
}

/// Proves the pair of some nodes, if there is one.
pub(crate) fn pair(enclosed: &EnclosedScene<'_>, nodes: &[ContactNode]) -> Option<Pair> {
    is_complete(enclosed, nodes).then_some(())?;
    let (stiffest, mut turned) = (Interval::exact(enclosed.stiffest), Interval::ZERO);
    // Part `i` is to the left of node `i`.
    let ends = |i: usize| [i.checked_sub(1).map(|i| &nodes[i]), nodes.get(i)];
    let spans: Vec<Option<Span>> = (0..=nodes.len()).map(|i| enclosed.span(ends(i)[0], ends(i)[1])).collect();
    let spans = enclosed.balanced(nodes, spans);
    let moments: Vec<_> = (0..nodes.len()).map(|i| moments(enclosed, nodes, &spans, i)).collect();
    let mut gap = Interval::ZERO;
    let (mut lifts, mut lifted) = (Interval::ZERO, 0.0_f64);
    let mut cut_off = PullCutOff::default();
    let mut shears = vec![[Interval::ZERO; 2]; spans.len()];
    let mut pieces = Vec::new();
    for (i, span) in spans.iter().enumerate() {
        let Some(span) = span else {
            let [Some(left), Some(right)] = ends(i) else { continue };
            pieces.extend(pressing::zone(enclosed, [left.x, right.x], &mut cut_off)?);
            shears[i] = [(left, false), (right, true)].map(|(j, left)| enclosed.force_along(j.x, left));
            continue;
        };
        let length = Interval::length(span.from, span.to);
        // The moments at the free ends are the couples that act there.
        let [first, last] = [enclosed.load.couple(0.0), -enclosed.load.couple(enclosed.length)];
        let beside = |i: usize, side: usize, end| moments.get(i).map_or(end, |node| node.0[side]);
        let moments = [beside(i.wrapping_sub(1), 1, first), beside(i, 0, last)];
        shears[i] = span.shears(enclosed.tension, moments);
        gap = gap + span.work(enclosed, moments);
        span.hinges(enclosed, moments).into_iter().for_each(|(x, moment)| cut_off.hinge(enclosed, x, moment));
        for (x, kink) in span.kinks() {
            let k = enclosed.joints.iter().find(|joint| joint.0.total_cmp(x).is_eq()).map_or(0.0, |joint| joint.1);
            turned = turned + kink.square() * Interval::exact(0.5 * k);
        }
        let mut parts = span.curves(enclosed, Vec::new());
        let beside = span.lift_beside(enclosed, &mut parts, ends(i))?;
        let lift = clearance::lift(enclosed, span, &parts, ends(i))?;
        let bent = lift.derivative().derivative();
        let bent = bent.integral_of_product(&bent, length).not_negative() * stiffest;
        let bent = enclosed.lifted(bent, &lift, length);
        lifts = lifts + if beside.is_zero() { bent } else { (bent.sqrt() + beside).square() };
        lifted = lifted.max(lift.range(length).magnitude());
        pieces.extend(parts.into_iter().map(|([from, to], [v, _])| {
            let v = v.minus(&lift.shifted(Interval::length(span.from, from)));
            Piece { from, to, v, pressed: false }
        }));
    }
    // The position above which the loads are in balance, if only this position carries the beam.
    let turns_about = enclosed.balanced_at.filter(|_| matches!(nodes, [node] if enclosed.balanced_at == Some(node.x)));
    let mut forces = Vec::new();
    for (i, (node, &(_, jump))) in nodes.iter().zip(&moments).enumerate() {
        let force = shears[i + 1][0] - shears[i][1] + enclosed.load.point(node.x);
        forces.push(force);
        if enclosed.is_hinge(node.x) && spans[i].is_none() {
            cut_off.hinge(enclosed, node.x, moments[i].0[0]);
        }
        // Loads in balance need no couple. A couple `C` that a single position lacks is left to the tension. It costs `C |w'|`, which is
        // less than the cost of a moment in a hinge.
        let alone = 0.0 < enclosed.tension && enclosed.supports.is_empty() && nodes.len() == 1;
        let turns = turns_about.is_some() || enclosed.hangs_on(nodes) || alone;
        if alone {
            cut_off.hinge(enclosed, node.x, jump);
        }
        let [more, energy] = at_node(enclosed, node, [force, jump], turns, &mut cut_off);
        (gap, turned) = (gap + more, turned + energy);
    }
    let steady = Interval::exact(enclosed.steadiness());
    (0.0 < steady.lo()).then_some(())?;
    let [more, energy] = giving::of_loads(enclosed, &pieces);
    let gap_of = |carried, off| (Interval::exact(corrected(gap, lifts, carried, off, steady)) + more).hi();
    let mut carriers = carriers(enclosed, nodes, &forces);
    let (gap, share, lines) = held_by(enclosed, turns_about, &mut carriers, &pieces, &cut_off, gap_of)?;
    let taut = Taut::of(enclosed, carriers, gap, share);
    let corrected = Interval::around_zero(share.hi());
    let carried = nodes.iter().zip(forces).map(|(node, force)| (node.x, force + corrected)).collect();
    let (zones, ground, soft) = (Vec::new(), None, enclosed.soft());
    let turned = turned + energy;
    Some(Pair { pieces, gap, carried, lines, zones, turns_about, lifted, ground, turned, soft, taut })
}

/// Cuts off the part of the force and of the couple that a node cannot exert. Returns the deviation of an elastic support from its law,
/// and its energy.
fn at_node(
    enclosed: &EnclosedScene<'_>,
    node: &ContactNode,
    [force, jump]: [Interval; 2],
    turns: bool,
    cut_off: &mut PullCutOff,
) -> [Interval; 2] {
    let support = enclosed.support(node.x);
    let pushes = support.is_none_or(EnclosedSupport::pushes);
    if pushes {
        cut_off.force(node.x, force);
    }
    let (mut jump, mut costs) = (jump, [Interval::ZERO; 2]);
    if let Some(gives) = support.and_then(|support| support.gives) {
        let (state, force) = (enclosed.end(node), if pushes { force.positive_part() } else { force });
        // Where the foundation fixes the slope, it carries the moment that a rotational spring does not.
        let follows = matches!(node.slope, Slope::OfGround { .. });
        let own = if follows { gives.jump(state[1]) } else { jump };
        costs = [gives.misfit([force, own], state), gives.energy(state)];
        jump = if follows { jump - own } else { jump };
    }
    if !turns {
        // A built-in support can exert any couple.
        let any = support.is_some_and(|s| s.slope.is_some() || s.holds_slope() && matches!(node.slope, Slope::Free(_)));
        let made = |left: bool| any || support.is_some() && enclosed.order(node, left) == 2;
        cut_off.couple(node.x, jump, [true, false].map(made));
    }
    costs
}

/// The gap including the cost of corrections: the lifts of `v̂`, and the moments and the share of what is cut off. The share is taken
/// from positions that are `off` the foundation by at most this distance.
fn corrected(gap: Interval, lifts: Interval, [moment, share]: [Interval; 2], off: f64, steady: Interval) -> f64 {
    let root = (number(2) * gap.not_negative()).sqrt() + lifts.sqrt() + moment;
    // A contact force at a distance from the foundation adds its product with the clearance.
    let gap = root.square() / number(2) + share * Interval::exact(off);
    if steady == number(1) { gap.hi() } else { (gap / steady.square()).hi() }
}

/// Whether the nodes are in order, include all supports, end every zone that they start, and follow the foundation only where they meet
/// it. No proof is attempted otherwise.
fn is_complete(enclosed: &EnclosedScene<'_>, nodes: &[ContactNode]) -> bool {
    let in_order = nodes.windows(2).all(|w| w[0].x < w[1].x) && nodes.last().is_some_and(|node| !node.lies);
    let inside = nodes.iter().all(|node| (0.0..=enclosed.length).contains(&node.x));
    let supports = nodes.iter().filter(|node| enclosed.support(node.x).is_some()).count();
    let meet = nodes.iter().enumerate().all(|(i, node)| {
        let [left, right] = [true, false].map(|left| enclosed.order(node, left) == 2);
        let built_in = enclosed.support(node.x).is_some_and(|s| s.slope.is_some());
        let follows = !built_in && matches!(node.slope, Slope::OfGround { .. });
        // A zone that ends in a hinge may have any slope beyond it.
        let ends = left || enclosed.is_hinge(node.x) && enclosed.support(node.x).is_none();
        (!follows || left || right) && (i == 0 || !nodes[i - 1].lies || ends) && (!node.lies || right)
    });
    in_order && inside && supports == enclosed.supports.len() && meet
}

/// `M` on the left and on the right of node `i`, and the excess of its jump over the couple that acts there. Part `i` of the beam is on
/// the left of the node and part `i + 1` on the right. Next to a zone, at an overhang and at an end of the beam only one moment is
/// possible. Between two spans any moment is possible. If it must be the same on both sides, the mean of the two values is used.
fn moments(
    enclosed: &EnclosedScene<'_>,
    nodes: &[ContactNode],
    spans: &[Option<Span>],
    i: usize,
) -> ([Interval; 2], Interval) {
    let node = &nodes[i];
    let outside = [i == 0, i + 1 == nodes.len()];
    let given = [0, 1].map(|side| outside[side] || spans[i + side].is_none());
    let own = [0, 1].map(|side| {
        let curvature = match &spans[i + side] {
            Some(span) => [span.end, span.start][side][2],
            None if outside[side] => Interval::ZERO,
            None => enclosed.gap.jet(node.x, side == 0)[2],
        };
        -(enclosed.stiffness_beside(node.x, side == 0) * curvature)
    });
    let couple = enclosed.load.couple(node.x);
    let held =
        enclosed.support(node.x).is_some_and(|s| s.holds_slope() || matches!(node.slope, Slope::OfGround { .. }));
    if held || given == [true; 2] {
        return (own, own[1] - own[0] - couple);
    }
    // Without the couple, the moment is the same on both sides.
    let from = [own[0], own[1] - couple];
    let between = || Interval::exact(0.5 * (from[0].middle() + from[1].middle()));
    let left = [0, 1].into_iter().find(|side| given[*side]).map_or_else(between, |side| from[side]);
    ([left, left + couple], Interval::ZERO)
}

#[cfg(test)]
mod tests;
