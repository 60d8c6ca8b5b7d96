//! What the greatest and the least bending moment of the beam lie between, from the gap alone: no further solve.
//!
//! The moments `M = −EI v̂''` of the pair and `M*` of the beam differ by `m` with `½ ∫ m²/EI dx ≤ gap`. Between supports
//! `M*'' = p* − q` with `p* ≥ 0`, wherever and however concentrated contact is: `M*` is convex but for the load. Of two such functions
//! that are close in the mean none has a narrow peak, so that they are close everywhere. For a function `φ` that begins at `x` with
//! `φ = 0`, `φ' = −1` and ends with `φ = φ' = 0` before the next support, by parts
//!
//! ```text
//! M*(x) = ∫ M* φ'' dx − ∫ φ dp* + ∫ q φ dx
//! φ'' = 3/2w for 0 < s < w,  −1/2w for w < s < 2w:     −w/3 ≤ φ ≤ 0,   ∫ φ dx = −w²/3,   ∫ EI φ''² dx = 5 EI/2w
//! M*(x) ≥ ∫ M φ'' dx − |q| w²/3 − P w/3 − √(5 gap EI/w)
//! ```
//!
//! with the point loads `P` within `2w`, to that side of `x` on which the next support is farther than `2w`. From above, at the distance `w` from
//! supports, and with zero for `M` beyond a free end,
//!
//! ```text
//! φ = (w − |s|)²/4w:     M*(x) ≤ ∫ M dx/2w + |q| w²/6 + P w/4 + √(gap EI/w)
//! ```
//!
//! At a support the first one is an equation where the beam is clear of the ground beside it, and nearer than `w` the moment is at
//! most the larger one at both ends of that strip, and `|q| w²/8 + P w/4`. At a simple support inside one clear side is enough, since
//! a couple by the ground on the other side bends the beam upwards; at the ends of the beam `M* ≤ 0` unless it is built in. Where the
//! beam lies on the ground from a support on (`support_forces`), its moment there is that of the pair.
//!
//! Over `2w` the moments of the pair change by no more than `V` times their length, and their jumps `J` at nodes. So both extremes are
//! known, with any `w`, to
//!
//! ```text
//! (V + P) w + |q| w²/2 + 3J/2 + √(5 gap EI/w)     least for w³ = 5 gap EI / 4 (V + P)²
//! ```
//!
//! Couples are left out of all of this: both moments, without the steps that these make, are of the kind above, and the steps are known.
//! `P` and `J` are sums over what is within `2w` of a place that is within `w` of another one: the greatest sum over any `8w` is enough.
//!
//! An axial force is a load `N v*''`, of which `N v̂''` is known and `∫ N (v* − v̂)'' φ dx` is by parts no more than `4 |N| max |v* − v̂|`.
//!
//! Two solves of a beam with a kink at `x` bound `M*(x)` as well, since the energy is convex in the angle and its derivative is
//! `−M*(x)`; but at one place each time, and to the root of what is rounded of an energy. A gap is of the size of the square of
//! that, and this its third root.
//!
//! On an elastic foundation contact is never concentrated, and more is known (`on_springs`).

mod on_springs;

use super::beside::lies_beside;
use super::kernel::contact_node::{EnclosedScene, EnclosedSupport};
use super::kernel::distance;
use super::kernel::interval::Interval;
use super::kernel::polynomial::{Polynomial, number};
use super::kernel::proof::Pair;
use super::kernel::reference::OUTWARDS;
use super::largest::extremes;
use super::support_forces::clear_from;

/// Bounds of the greatest and of the least moment; the former is [`None`] where nothing could be shown beside a support.
pub(super) fn moments(enclosed: &EnclosedScene<'_>, pair: &Pair) -> [Option<Interval>; 2] {
    if let Some(sprung) = &pair.ground {
        return on_springs::moments(enclosed, pair, sprung);
    }
    let EnclosedScene { length, .. } = *enclosed;
    let moment = |ends: [f64; 2], v: &Polynomial| {
        v.derivative().derivative().times(Interval::exact(-enclosed.stiffness_between(ends)))
    };
    let moment = |ends: [f64; 2], v: &Polynomial| (ends, moment(ends, v));
    let pieces: Vec<([f64; 2], Polynomial)> = pair.pieces.iter().map(|p| moment([p.from, p.to], &p.v)).collect();
    let [greatest, least] = extremes(pieces.iter().copied());
    // Where the beam is not built in at an end, there is a moment of zero; couples by the ground beside it leave others near by.
    let is_loaded = |x: f64| enclosed.load.couples.iter().any(|(at, _)| at.total_cmp(&x).is_eq());
    let is_hinge = |x: f64| enclosed.support(x).is_none_or(|support| !support.holds_slope()) && !is_loaded(x);
    let zero = if is_hinge(0.0) || is_hinge(length) { 0.0 } else { f64::NEG_INFINITY };
    let Some((error, is_known)) = error(enclosed, pair, &pieces) else { return [None; 2] };
    let around = Interval::around_zero(error);
    let [greatest, least] = [greatest + around, least + around];
    let finite = |bound: Interval| Some(bound).filter(|bound| bound.is_finite());
    [
        finite(Interval::between(greatest.lo(), greatest.hi().max(zero))).filter(|_| is_known),
        finite(Interval::between(least.lo().min(-zero), least.hi())),
    ]
}

/// How far both extremes may be off, and whether that is so for the greatest moment as well.
fn error(enclosed: &EnclosedScene<'_>, pair: &Pair, pieces: &[([f64; 2], Polynomial)]) -> Option<(f64, bool)> {
    /// Shares of what lies between two supports and of what is clear that windows of `4w` and `2w` take: no more than a whole.
    const WITHIN: [f64; 2] = [0.249, 0.499];
    let EnclosedScene { stiffest: stiffness, length, supports, load, .. } = *enclosed;
    let width = |ends: &[f64; 2]| Interval::length(ends[0], ends[1]);
    let jumps = pieces.windows(2).filter(|w| enclosed.support(w[1].0[0]).is_none());
    let jump = |w: &[([f64; 2], Polynomial)]| {
        let jump = w[1].1.at(Interval::ZERO) - w[0].1.at(width(&w[0].0)) - load.couple(w[1].0[0]);
        (w[1].0[0], jump.magnitude())
    };
    let jumps: Vec<(f64, f64)> = jumps.map(jump).collect();
    if pair.gap <= 0.0 {
        return Some((1.5 * within(&jumps, length) * OUTWARDS, true));
    }
    let slope = pieces.iter().map(|(ends, m)| m.derivative().range(width(ends)).magnitude()).fold(0.0, f64::max);
    let distributed = pieces.iter().flat_map(|(ends, _)| ends.map(|x| load.line(x, *ends)[0].magnitude()));
    let distributed = distributed.fold(0.0, f64::max);
    let (pulled, turned) = axial(enclosed, pair, pieces)?;
    let distributed = distributed + pulled;
    let mut points: Vec<(f64, f64)> = load.points.iter().map(|p| (p.0, p.1.magnitude())).collect();
    let off = |[k, _]: [Interval; 2]| (number(2) * Interval::exact(pair.gap) * k).sqrt().hi();
    points.extend(enclosed.said.iter().map(|said| (said.x, said.gives.spring.map_or(0.0, off))));
    points.sort_by(|a, b| a.0.total_cmp(&b.0));
    let changes = |w: f64| slope + within(&points, 8.0 * w);
    let mut places: Vec<f64> = supports.iter().map(|s| s.x).chain([length]).collect();
    places.dedup();
    let mut before = 0.0;
    let bays = places.iter().map(|x| x - std::mem::replace(&mut before, *x)).filter(|bay| 0.0 < *bay);
    let bay = WITHIN[0] * bays.fold(length, f64::min);
    let beside = (0..supports.len()).map(|k| known_beside(enclosed, pair, k)).fold(f64::INFINITY, f64::min);
    let most = if 0.0 < beside { bay.min(WITHIN[1] * beside) } else { bay };
    let energy = 5.0 * pair.gap * stiffness;
    let best = libm::cbrt(energy / (4.0 * changes(0.0) * changes(0.0)));
    let w = if best < most { best } else { most };
    let sprung = enclosed.said.iter().filter_map(|said| said.gives.turning).map(off).sum::<f64>();
    let jump = within(&jumps, 8.0 * w) + 2.0 * sprung;
    let error = changes(w) * w + 0.5 * distributed * w * w + 1.5 * jump + (energy / w).sqrt() + turned;
    (error.is_finite() && 0.0 < w).then_some((error * OUTWARDS, 0.0 < beside))
}

/// The load `|N v̂''|` that an axial force is at most, and what it makes of `v* − v̂`; [`None`] with joints, where it is concentrated as well.
fn axial(enclosed: &EnclosedScene<'_>, pair: &Pair, pieces: &[([f64; 2], Polynomial)]) -> Option<(f64, f64)> {
    let force = enclosed.tension.abs();
    if force == 0.0 {
        return Some((0.0, 0.0));
    }
    enclosed.joints.is_empty().then_some(())?;
    let bent = pieces.iter().map(|(ends, m)| m.range(Interval::length(ends[0], ends[1])).magnitude());
    let off = distance::anywhere(pair, enclosed.stiffness, enclosed.length);
    Some((force * bent.fold(0.0, f64::max) / enclosed.stiffness * OUTWARDS, 4.0 * force * off * OUTWARDS))
}

/// At least the greatest sum of what is at places, from left to right, in a window of this width.
fn within(places: &[(f64, f64)], width: f64) -> f64 {
    let (mut most, mut sum, mut first, mut total) = (0.0_f64, 0.0, 0, 0.0);
    for (x, size) in places {
        (sum, total) = (sum + size, total + size);
        while width * OUTWARDS < x - places[first].0 {
            sum -= places[first].1;
            first += 1;
        }
        most = most.max(sum);
    }
    // Each of the sums and differences is rounded by its own size, which is less than the total.
    #[expect(clippy::cast_precision_loss, reason = "a count, and more than twice as many roundings as there are")]
    let roundings = 4.0 * (places.len() as f64) * f64::EPSILON;
    (most + roundings * total) * OUTWARDS
}

/// How far beside a support the moment there is known from above: zero where it is not.
fn known_beside(enclosed: &EnclosedScene<'_>, pair: &Pair, k: usize) -> f64 {
    let EnclosedSupport { x, .. } = enclosed.supports[k];
    let supports = enclosed.supports;
    let before = k.checked_sub(1).map_or(0.0, |k| supports[k].x);
    let ends = [before, supports.get(k + 1).map_or(enclosed.length, |support| support.x)];
    let known = |side: usize| {
        if lies_beside(enclosed, pair, x, side) {
            return f64::INFINITY;
        }
        (clear_from(enclosed, pair, x, ends[side]) - x).abs()
    };
    match (enclosed.supports[k].holds_slope(), ends.map(|end| (end - x).abs() <= 0.0)) {
        (false, [true, _] | [_, true]) => f64::INFINITY,
        (false, _) => known(0).max(known(1)),
        (true, [true, _]) => known(1),
        (true, [_, true]) => known(0),
        (true, _) => known(0).min(known(1)),
    }
}

#[cfg(test)]
mod tests {
    use super::within;

    /// A window has room for what is at both of its ends, and for all of what is at one place.
    #[test]
    fn the_fullest_window_counts() {
        let places = [(0.0, 1.0), (1.0, 4.0), (1.0, 3.0), (2.5, 2.0), (4.0, 6.0), (9.0, 5.0)];
        for (width, expected) in [(0.0, 7.0), (1.0, 8.0), (1.5, 9.0), (2.0, 9.0), (3.0, 15.0), (5.0, 16.0), (9.0, 21.0)]
        {
            let found = within(&places, width);
            assert!((expected..expected * (1.0 + 1e-13)).contains(&found), "{width}: {found} for {expected}");
        }
        assert!(within(&[], 1.0) <= 0.0);
    }
}
