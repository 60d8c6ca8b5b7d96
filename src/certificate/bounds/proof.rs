//! From joints to a proven pair: a deflection `v̂` that is admissible everywhere and a moment field `M` whose contact load
//! presses everywhere.
//!
//! In contact `v̂ = u` and `M = −EI u''`; in a span `v̂` is the exact beam between its joints and `M` the moment field with
//! `M'' = −q` and the moments of its two ends. Then `(u − v̂) p = 0` everywhere, `EI v̂'' + M` is linear in each span, `r`
//! say, and
//!
//! ```text
//! J(v̂) − D(p) = Σ L (r₀² + r₀ r₁ + r₁²) / 6 EI
//! ```
//!
//! To prove are `u − v̂ ≥ 0` in spans, `q − EI u'''' ≥ 0` in zones, and the concentrated forces at the joints,
//! `M'(x+) − M'(x−) + P ≥ 0` with a point load `P` that stands there.

use super::curve::{Curve, Piece};
use super::joints::{Joint, Kind, Setting};
use super::load::{Pieces, cells};
use super::polynomial::{Polynomial, number};
use super::span::Span;
use super::statics::{Carried, deflection};
use crate::certificate::interval::Interval;

/// A proven pair.
#[derive(Debug, Clone)]
pub(super) struct Pair {
    /// `v̂`.
    pub(super) curve: Curve,
    /// `J(v̂) − D(p)`.
    pub(super) gap: Interval,
    /// `M'` at the two ends: the reactions that belong to `M`, without loads on the supports themselves.
    pub(super) reactions: [Interval; 2],
}

/// Parts into which a cell is cut before it is given up.
const MOST_PARTS: usize = 400;

/// The pair of some joints, if it can be proven.
pub(super) fn pair(setting: &Setting<'_>, joints: &[Joint]) -> Option<Pair> {
    if !covers(joints, setting.length) || joints.windows(2).any(|w| w[1].x <= w[0].x) {
        return None;
    }
    let stiffness = Interval::exact(setting.stiffness);
    let spans: Vec<Option<Span>> = joints.windows(2).map(|w| setting.span(&w[0], &w[1])).collect();
    let moment = |i: usize| moment_at(setting, joints, &spans, i);
    let mut gap = Interval::ZERO;
    let mut shears = Vec::new();
    let mut pieces = Vec::new();
    for (i, span) in spans.iter().enumerate() {
        let (left, right) = (&joints[i], &joints[i + 1]);
        if let Some(span) = span {
            let length = Interval::exact(span.to) - Interval::exact(span.from);
            let r = [stiffness * span.start[2] + moment(i), stiffness * span.end[2] + moment(i + 1)];
            let turn = (r[1] - r[0]) / length;
            shears.push([turn - stiffness * span.start[3], turn - stiffness * span.end[3]]);
            gap = gap + length * (r[0].square() + r[1].square() + (r[0] + r[1]).square()) / (number(12) * stiffness);
            if !is_clear(setting, span, left, right) {
                return None;
            }
            let curve = span.curve(Vec::new(), setting.load, setting.stiffness);
            pieces.extend(curve.into_iter().map(|([from, to], v)| Piece { from, to, v, follows: false }));
        } else {
            if !presses(setting, left.x, right.x) {
                return None;
            }
            let third = |x: f64| -(stiffness * setting.ground.jet(x)[3]);
            shears.push([third(left.x), third(right.x)]);
            let mut breaks = setting.ground.breaks(left.x, right.x);
            breaks.extend(setting.load.breaks(left.x, right.x));
            pieces.extend(cells(left.x, right.x, breaks).into_iter().map(|[from, to]| Piece {
                from,
                to,
                v: setting.ground.cell(from, to),
                follows: true,
            }));
        }
    }
    for i in 1..joints.len() - 1 {
        let point = setting.load.point(joints[i].x).unwrap_or(Interval::ZERO);
        if (shears[i][0] - shears[i - 1][1] + point).lo() < 0.0 {
            return None;
        }
    }
    let gap = Interval::between(gap.lo().max(0.0), gap.hi());
    let (first, last) = (shears.first()?, shears.last()?);
    Some(Pair { curve: Curve { pieces }, gap, reactions: [first[0], -last[1]] })
}

/// Whether joints reach from support to support. A zone that ends at a support may have been moved away from it by the search
/// for places, and a deflection of a part of the beam proves nothing.
fn covers(joints: &[Joint], length: f64) -> bool {
    joints.first().is_some_and(|first| first.x <= 0.0) && joints.last().is_some_and(|last| length <= last.x)
}

/// `M` at a joint. Where only continuity is asked for, a number between the moments of the two spans.
fn moment_at(setting: &Setting<'_>, joints: &[Joint], spans: &[Option<Span>], i: usize) -> Interval {
    match joints[i].kind {
        Kind::Support => Interval::ZERO,
        Kind::Start | Kind::End => -(Interval::exact(setting.stiffness) * setting.ground.jet(joints[i].x)[2]),
        Kind::Corner | Kind::Touch => {
            let left = i.checked_sub(1).and_then(|k| spans[k].as_ref()).map_or(0.0, |s| s.end[2].middle());
            let right = spans.get(i).and_then(Option::as_ref).map_or(0.0, |s| s.start[2].middle());
            Interval::exact(-0.5 * setting.stiffness * (left + right))
        }
    }
}

/// Whether the beam can lie on the foundation all the way between two places, and is pressed onto it.
fn presses(setting: &Setting<'_>, from: f64, to: f64) -> bool {
    let smooth = setting.ground.is_smooth_between(from, to);
    // Where a zone begins at a support, support and foundation together exert a moment: the limit of a contact force that
    // grows as it comes nearer to the support. It presses if it bends the beam upwards, and costs nothing in the limit:
    // the gap of a force at the distance ε is M² ε / 6 EI.
    let level = |x: f64| 0.0 <= setting.ground.jet(x)[2].lo() && setting.ground.depth(x).magnitude() <= 0.0;
    let held = (0.0 < from || level(from)) && (to < setting.length || level(to));
    let mut breaks = setting.ground.breaks(from, to);
    breaks.extend(setting.load.breaks(from, to));
    let stiffness = Interval::exact(setting.stiffness);
    let pressure = |&[from, to]: &[f64; 2]| {
        let fourth = setting.ground.cell(from, to).derivative().derivative().derivative().derivative();
        let p = setting.load.cell(from, to).minus(&fourth.times(stiffness));
        is_positive(&p, Interval::exact(to) - Interval::exact(from))
    };
    let points = setting.load.breaks(from, to);
    let points_press = points.iter().all(|&x| setting.load.point(x).is_none_or(|p| 0.0 <= p.lo()));
    smooth && held && points_press && cells(from, to, breaks).iter().all(pressure)
}

/// Which power of the distance from a joint is a factor of the clearance beside it.
fn order(setting: &Setting<'_>, joint: &Joint, from_the_left: bool) -> usize {
    let touches =
        setting.ground.side(joint.x, from_the_left).is_none_or(|u| (u - setting.end(joint)[0].middle()).abs() <= 0.0);
    match joint.kind {
        Kind::Support => usize::from(setting.ground.depth(joint.x).magnitude() <= 0.0),
        Kind::Corner => usize::from(touches),
        Kind::Touch | Kind::Start | Kind::End => 2,
    }
}

/// Proves `u − v̂ ≥ 0` in a span. Beside a joint, where the clearance vanishes with a power of the distance, the quotient by
/// that power is proven to be positive.
fn is_clear(setting: &Setting<'_>, span: &Span, left: &Joint, right: &Joint) -> bool {
    let smooth = |j: &Joint| matches!(j.kind, Kind::Support | Kind::Corner) || setting.ground.is_smooth_at(j.x);
    if !smooth(left) || !smooth(right) {
        return false;
    }
    let mut breaks = setting.ground.breaks(span.from, span.to);
    breaks.push(0.5 * (span.from + span.to));
    let curve = span.curve(breaks, setting.load, setting.stiffness);
    let last = curve.len() - 1;
    curve.iter().enumerate().all(|(k, (cell, v))| {
        let [from, to] = *cell;
        let width = Interval::exact(to) - Interval::exact(from);
        if k == last {
            let v = span.mirrored(from, setting.load, setting.stiffness);
            let h = setting.ground.mirrored_cell(from, to).minus(&v).divided(order(setting, right, true));
            is_positive(&h, width)
        } else {
            let h = setting.ground.cell(from, to).minus(v);
            let h = if k == 0 { h.divided(order(setting, left, false)) } else { h };
            is_positive(&h, width)
        }
    })
}

/// Proves that a polynomial is not negative on `0 ≤ s ≤ w`.
fn is_positive(polynomial: &Polynomial, width: Interval) -> bool {
    is_positive_within(polynomial, width, &mut MOST_PARTS.clone())
}

fn is_positive_within(polynomial: &Polynomial, width: Interval, parts: &mut usize) -> bool {
    let range = polynomial.range(width);
    if 0.0 <= range.lo() {
        return true;
    }
    *parts = parts.saturating_sub(1);
    if *parts == 0 || polynomial.at(width).hi() < 0.0 || polynomial.at(Interval::ZERO).hi() < 0.0 {
        return false;
    }
    // Halves of the upper bound of the width: they overlap by rounding and leave nothing out.
    let half = Interval::exact(0.5 * width.hi());
    is_positive_within(polynomial, half, parts) && is_positive_within(&polynomial.shifted(half), half, parts)
}

/// The pair of a beam that hangs free: where there is no foundation.
pub(super) fn free(load: &Pieces, stiffness: f64, length: f64) -> Pair {
    let carried = Carried::of(&[], load, stiffness, length);
    let pieces = carried.cells.iter().map(|cell| {
        let [from, to] = cell.0;
        Piece { from, to, v: deflection(cell, load, stiffness), follows: false }
    });
    Pair { curve: Curve { pieces: pieces.collect() }, gap: Interval::ZERO, reactions: carried.reactions }
}

/// The deflection of joints that are not proven.
pub(super) fn drawn(setting: &Setting<'_>, joints: &[Joint]) -> Option<Curve> {
    if !covers(joints, setting.length) {
        return None;
    }
    let mut pieces = Vec::new();
    for pair in joints.windows(2) {
        if pair[1].x <= pair[0].x {
            return None;
        }
        let Some(span) = setting.span(&pair[0], &pair[1]) else {
            if !setting.ground.is_smooth_between(pair[0].x, pair[1].x) {
                return None;
            }
            let breaks = setting.ground.breaks(pair[0].x, pair[1].x);
            pieces.extend(cells(pair[0].x, pair[1].x, breaks).into_iter().map(|[from, to]| Piece {
                from,
                to,
                v: setting.ground.cell(from, to),
                follows: true,
            }));
            continue;
        };
        let curve = span.curve(Vec::new(), setting.load, setting.stiffness);
        pieces.extend(curve.into_iter().map(|([from, to], v)| Piece { from, to, v, follows: false }));
    }
    Some(Curve { pieces })
}
