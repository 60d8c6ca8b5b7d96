//! From nodes to a proven pair: a deflection `v̂` that is admissible everywhere and a moment field `M` whose contact load
//! presses everywhere.
//!
//! In contact `v̂ = u` and `M = −EI u''`; in a span `v̂` is the exact beam between its nodes and `M` the moment field with
//! `M'' = −q` and the moments of its two ends. Then `(u − v̂) p = 0` everywhere, `EI v̂'' + M` is linear in each span, `r`
//! say, and
//!
//! ```text
//! J(v̂) − D(p) = Σ L (r₀² + r₀ r₁ + r₁²) / 6 EI
//! ```
//!
//! To prove are `u − v̂ ≥ 0` in spans, `q − EI u'''' ≥ 0` in zones, and the concentrated forces at the nodes,
//! `M'(x+) − M'(x−) + P ≥ 0` with a point load `P` that stands there.
//!
//! Where one of them fails, the pair is corrected until it holds: a span is lifted by `α φ` (module `clearance`), which is zero
//! wherever the beam is pressed, and pressure that pulls, `p⁻`, is cut off, which changes `M` by the moments of `p⁻` on the
//! simple beam. With `‖m‖² = ∫ m²/EI dx`
//!
//! ```text
//! ‖M⁻‖ ≤ ∫ p⁻ x (l − x) / √(3 EI l) dx,     gap = ½ (‖r‖ + ‖EI α φ''‖ + ‖M⁻‖)²
//! ```
//!
//! so that what rounding leaves open at a tie costs as much as the rounding, and a wrong witness what it is wrong by.

use super::clearance;
use super::contact_node::{ContactNode, EnclosedScene, Kind};
use super::interval::Interval;
use super::load::cells;
use super::polynomial::{Polynomial, number};
use super::pressing::{self, TensionCutOff};
use super::span::Span;

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
    /// `v̂`: its value and its slope are continuous, and it vanishes at both ends. Pieces end where the load changes its formula
    /// and at point loads.
    pub(crate) pieces: Vec<Piece>,
    /// `J(v̂) − D(p)`.
    pub(crate) gap: Interval,
    /// `M'` at the two ends: the reactions that belong to `M`, without loads on the supports themselves.
    pub(crate) reactions: [Interval; 2],
    /// How far `v̂` was lifted at most off the deflection that the places of the witness make; infinite if it is of no witness.
    pub(crate) lifted: f64,
}

/// The pair of some nodes, if there is one.
pub(crate) fn pair(enclosed: &EnclosedScene<'_>, nodes: &[ContactNode]) -> Option<Pair> {
    if !is_complete(enclosed, nodes) {
        return None;
    }
    let stiffness = Interval::exact(enclosed.stiffness);
    let spans: Vec<Option<Span>> = nodes.windows(2).map(|w| enclosed.span(&w[0], &w[1])).collect();
    let moment = |i: usize| moment_at(enclosed, nodes, &spans, i);
    let mut gap = Interval::ZERO;
    let (mut lifts, mut lifted) = (Interval::ZERO, 0.0_f64);
    let mut cut_off = TensionCutOff::new(enclosed);
    let mut shears = Vec::new();
    let mut pieces = Vec::new();
    for (i, span) in spans.iter().enumerate() {
        let (left, right) = (&nodes[i], &nodes[i + 1]);
        let Some(span) = span else {
            pressing::zone(enclosed, left.x, right.x, &mut cut_off)?;
            let third = |node: &ContactNode| -(stiffness * enclosed.jet(node)[3]);
            shears.push([third(left), third(right)]);
            pieces.extend(lying(enclosed, left.x, right.x));
            continue;
        };
        let length = Interval::exact(span.to) - Interval::exact(span.from);
        let r = [stiffness * span.start[2] + moment(i), stiffness * span.end[2] + moment(i + 1)];
        // Not from the third derivative, of which rounding is larger by the square of a short span.
        let shear = (moment(i + 1) - moment(i) + span.loaded[0]) / length;
        shears.push([shear, shear - span.loaded[1]]);
        gap = gap + length * (r[0].square() + r[1].square() + (r[0] + r[1]).square()) / (number(12) * stiffness);
        let mut curve = span.curve(Vec::new(), enclosed.load, enclosed.stiffness);
        let alpha = clearance::lift(enclosed, span, left, right)?;
        if 0.0 < alpha {
            let lift = clearance::shape(span, left, right).times(Interval::exact(alpha));
            lifts = lifts + lift.derivative().derivative().integral_of_square(length) * stiffness;
            lifted = lifted.max(lift.range(length).magnitude());
            for ([from, _], v) in &mut curve {
                *v = v.minus(&lift.shifted(Interval::exact(*from) - Interval::exact(span.from)));
            }
        }
        pieces.extend(curve.into_iter().map(|([from, to], v)| Piece { from, to, v, follows: false }));
    }
    for i in 1..nodes.len() - 1 {
        let point = enclosed.load.point(nodes[i].x).unwrap_or(Interval::ZERO);
        cut_off.force(nodes[i].x, shears[i][0] - shears[i - 1][1] + point);
    }
    for i in [0, nodes.len() - 1] {
        cut_off.couple(moment(i));
    }
    let correction = lifts.sqrt() + cut_off.moments;
    let root = (number(2) * Interval::between(gap.lo().max(0.0), gap.hi())).sqrt() + correction;
    let (first, last) = (shears.first()?, shears.last()?);
    let corrected = Interval::around_zero(cut_off.shear.hi());
    Some(Pair {
        pieces,
        // Without correction the square would only add rounding.
        gap: Interval::between(0.0, if correction.is_zero() { gap.hi() } else { (root.square() / number(2)).hi() }),
        reactions: [first[0] + corrected, -last[1] + corrected],
        lifted,
    })
}

/// Whether nodes are in order, reach from support to support and end every zone that they start. Of anything else nothing
/// follows.
fn is_complete(enclosed: &EnclosedScene<'_>, nodes: &[ContactNode]) -> bool {
    let [first, .., last] = nodes else { return false };
    let in_order = nodes.windows(2).all(|w| w[0].x < w[1].x);
    let zones_end = nodes.windows(2).all(|w| (w[0].kind == Kind::Start) <= (w[1].kind == Kind::End));
    let from_the_left = first.x.abs() <= 0.0 && matches!(first.kind, Kind::Support | Kind::Clamp | Kind::Start);
    let to_the_right = enclosed.length <= last.x && matches!(last.kind, Kind::Support | Kind::Clamp | Kind::End);
    // A beam that follows the foundation to a support is held there only if the foundation is, on that side of a step.
    let held = [first, last].iter().all(|j| j.kind == Kind::Support || enclosed.jet(j)[0].magnitude() <= 0.0);
    let inside = nodes[1..nodes.len() - 1].iter().all(|j| !matches!(j.kind, Kind::Support | Kind::Clamp));
    in_order && zones_end && from_the_left && to_the_right && last.x <= enclosed.length && inside && held
}

/// The foundation between two places, as pieces.
fn lying(enclosed: &EnclosedScene<'_>, from: f64, to: f64) -> impl Iterator<Item = Piece> {
    let mut breaks = enclosed.foundation.breaks(from, to);
    breaks.extend(enclosed.load.breaks(from, to));
    let foundation = enclosed.foundation;
    cells(from, to, breaks).into_iter().map(move |[from, to]| Piece {
        from,
        to,
        v: foundation.cell(from, to),
        follows: true,
    })
}

/// `M` at a node. Where only continuity is asked for, a number between the moments of the two spans.
fn moment_at(enclosed: &EnclosedScene<'_>, nodes: &[ContactNode], spans: &[Option<Span>], i: usize) -> Interval {
    // At the ends there is only one of them.
    let left = i.checked_sub(1).and_then(|k| spans[k].as_ref()).map(|s| s.end[2]);
    let right = spans.get(i).and_then(Option::as_ref).map(|s| s.start[2]);
    let known = |curvature: Option<Interval>| curvature.unwrap_or(Interval::ZERO);
    match nodes[i].kind {
        Kind::Support => Interval::ZERO,
        Kind::Clamp => -(Interval::exact(enclosed.stiffness) * known(left.or(right))),
        Kind::Start | Kind::End => -(Interval::exact(enclosed.stiffness) * enclosed.jet(&nodes[i])[2]),
        Kind::Corner | Kind::Touch => {
            Interval::exact(-0.5 * enclosed.stiffness * (known(left).middle() + known(right).middle()))
        }
    }
}

#[cfg(test)]
mod tests;
