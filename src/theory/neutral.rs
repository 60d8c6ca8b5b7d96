//! A beam in balance on a single position: on its only support, on the end of the foundation, or on a corner of it. Forces, moments and
//! energy are determined, and the beam can rotate about that position until it touches.
//!
//! ```text
//! v(x) = v₀(x) + s (x − x₀),    from = max (g − v₀)/(x − x₀) left of x₀,    to = min (g − v₀)/(x − x₀) right of x₀
//! ```
//!
//! with the deflection `v₀` for the slope 0 at `x₀`. A foundation that starts at `x₀` at the level of the beam limits the slope there
//! too, by its own slope. If `from` exceeds `to`, the foundation does not let the beam balance there without bending it. If it starts
//! at that level on both sides without a corner, it leaves only its own slope. The position is then found by the usual search.

use super::bernstein::lowest_below;
use super::check::{Check, check};
use super::list::{List, Node};
use super::normal::edge_node;
use super::penetration::in_bearings;
use super::piecewise::PiecewiseScene;
use super::search::Candidate;
use crate::certificate::Slope;

/// The beam with the slope nearest to zero, and the interval of slopes if there is more than one; [`None`] if the beam does not rest on
/// the position `about` alone.
pub(super) fn balanced(given: &PiecewiseScene, about: f64) -> Option<(Candidate, Option<[f64; 2]>)> {
    /// Slopes that differ by less than this share count as equal.
    const ROUNDING: f64 = 64.0 * f64::EPSILON;
    let node = match given.supports.first() {
        None => edge_node(given, given.breakpoint_at(about).filter(|&breakpoint| given.is_edge(breakpoint))?),
        Some(support) => Node::at(given, support.breakpoint),
    };
    if node.held_slope(given).is_some() {
        return None;
    }
    let level = List { nodes: vec![Node { slope: Slope::Free(0.0), ..node }] };
    let slopes = if given.has_obstacle() { slopes(given, &level, about) } else { [f64::NEG_INFINITY, f64::INFINITY] };
    // If the foundation leaves one slope, its limits are known only to rounding and may be in either order.
    let rounding = ROUNDING * slopes[0].abs().max(slopes[1].abs());
    if slopes[1] < slopes[0] - rounding {
        return None;
    }
    let turns = slopes[1].is_infinite() || slopes[0].is_infinite() || rounding < slopes[1] - slopes[0];
    let slope = 0.0_f64.max(slopes[0]).min(slopes[1]);
    let list = List { nodes: vec![Node { slope: Slope::Free(slope), ..node }] };
    let checked = check(given, &list);
    let found = Candidate { list, checked, steps: 0, lists: 1, samples: 0, converged: true };
    found.solved().then_some((found, turns.then_some(slopes)))
}

/// The interval of slopes for which the beam is clear of the foundation.
fn slopes(given: &PiecewiseScene, level: &List, about: f64) -> [f64; 2] {
    /// Each step moves to a more restrictive position; a few steps are enough, as in Newton's method.
    const STEPS: usize = 60;
    let Check { pieces, spans, .. } = check(given, level);
    let mut taylor = vec![0.0; given.terms];
    let mut bound = |left: bool| {
        let sign = if left { -1.0 } else { 1.0 };
        let tangent = given.supports.first().is_some_and(|support| support.tangent[usize::from(!left)]);
        // Measured outwards from x₀: the limit of the downward rotation on this side.
        let bearings = spans.iter().flat_map(|(_, span)| in_bearings(given, &pieces, span));
        let arms = bearings.map(|(x, depth)| (sign * (x - about), -depth)).filter(|(arm, _)| 0.0 < *arm);
        let mut least = arms.fold(f64::INFINITY, |least, (arm, clear)| least.min(clear / arm));
        for _ in 0..if given.founded { STEPS } else { 0 } {
            let before = least;
            let pieces = pieces.iter().filter(|piece| if left { piece.hi <= about } else { about <= piece.lo });
            for piece in pieces.flat_map(|piece| piece.parts(given)) {
                piece.clearance(given, &mut taylor);
                let base = if least.is_finite() { least } else { 0.0 };
                let turn = sign * base;
                taylor[0] -= turn * (piece.anchor - about);
                taylor[1] -= turn;
                piece.outwards(&mut taylor);
                let rounding = if least.is_finite() { -f64::EPSILON * least.abs() } else { f64::INFINITY };
                let beside = (piece.anchor - about).abs() <= 0.0;
                if beside && (tangent || taylor[0] <= 0.0) {
                    // The foundation starts at x₀ at the level of the beam: h/(x − x₀) is a polynomial whose values include its limit
                    // at x₀.
                    if let Some((_, rate)) = lowest_below(&taylor[1..], piece.width(), rounding) {
                        least = least.min(base + rate);
                    }
                    continue;
                }
                let Some((s, value)) = lowest_below(&taylor, piece.width(), rounding * piece.width()) else { continue };
                let arm = sign * (piece.place(s) - about);
                if 0.0 < arm {
                    least = least.min(base + value / arm);
                }
            }
            if before.to_bits() == least.to_bits() {
                break;
            }
        }
        least
    };
    [-bound(true), bound(false)]
}
