//! Brackets of the greatest and the least bending moment of the beam, from the gap alone, without a further solve.
//!
//! The moments `M = −EI v̂''` of the pair and `M*` of the beam differ by `m` with `½ ∫ m²/EI dx ≤ gap`. Between supports `M*'' = p* − q`
//! with `p* ≥ 0`, wherever contact is and however concentrated: `M*` is convex apart from the effect of the load. If two such functions
//! are close in the mean, neither has a narrow peak, so they are close everywhere. For a function `φ` that begins at `x` with `φ = 0`,
//! `φ' = −1` and ends with `φ = φ' = 0` before the next support, integration by parts gives
//!
//! ```text
//! M*(x) = ∫ M* φ'' dx − ∫ φ dp* + ∫ q φ dx
//! φ'' = 3/2w for 0 < s < w,  −1/2w for w < s < 2w:     −w/3 ≤ φ ≤ 0,   ∫ φ dx = −w²/3,   ∫ EI φ''² dx = 5 EI/2w
//! M*(x) ≥ ∫ M φ'' dx − |q| w²/3 − P w/3 − √(5 gap EI/w)
//! ```
//!
//! with the point loads `P` within `2w`, on the side of `x` where the next support is farther than `2w`. The upper bound, at a distance
//! of at least `w` from supports and with `M = 0` beyond a free end, is
//!
//! ```text
//! φ = (w − |s|)²/4w:     M*(x) ≤ ∫ M dx/2w + |q| w²/6 + P w/4 + √(gap EI/w)
//! ```
//!
//! At a support the first relation is an equation if the beam is clear of the foundation next to it. Nearer to the support than `w` the
//! moment is at most the larger of the moments at both ends of that strip, plus `|q| w²/8 + P w/4`. At a simple support inside the beam,
//! one clear side is enough, since a couple caused by the foundation on the other side bends the beam upwards. At the ends of the beam
//! `M* ≤ 0` unless the beam is built in. Where the beam is in contact with the foundation from a support on (`support_forces`), its moment
//! there is the moment of the pair.
//!
//! Over `2w` the moments of the pair change by at most `V` times this length, plus their jumps `J` at nodes. So for any `w` both
//! extremes are known to within
//!
//! ```text
//! (V + P) w + |q| w²/2 + 3J/2 + √(5 gap EI/w)     least for w³ = 5 gap EI / 4 (V + P)²
//! ```
//!
//! Couples are omitted from all of this: without the jumps that couples cause, both moments are of the kind above, and the jumps are
//! known. `P` and `J` are sums over everything within `2w` of a position that is within `w` of another one, so the largest sum over any
//! `8w` is enough.
//!
//! An axial force acts as a load `N v*''`. Of this `N v̂''` is known, and by parts `∫ N (v* − v̂)'' φ dx` is at most
//! `4 |N| max |v* − v̂|`.
//!
//! Two solves of a beam with a kink at `x` would also bound `M*(x)`, since the energy is convex in the angle and its derivative is
//! `−M*(x)`. But they bound it at one position only, and only to an error of the order `√ε`, with the relative rounding `ε` of an energy.
//! A gap that is nothing but rounding is of the order `ε²`. The bound here is proportional to its cube root, so of the order `ε^(2/3)`.
//!
//! On an elastic foundation contact is never concentrated, and sharper bounds exist (`on_springs`).

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

/// Brackets of the greatest and of the least moment; the former is [`None`] if nothing could be proven next to a support.
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
    // At an end where the beam is not built in the moment is zero; couples caused by the foundation next to it leave other moments
    // nearby.
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

/// The error bound of both extremes, and whether it is valid for the greatest moment as well.
fn error(enclosed: &EnclosedScene<'_>, pair: &Pair, pieces: &[([f64; 2], Polynomial)]) -> Option<(f64, bool)> {
    /// Windows of `4w` and `2w` as shares of the distance between two supports and of the clear length: just below one.
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

/// The largest load `|N v̂''|` of an axial force, and the contribution of `v* − v̂`; [`None`] with joints, where this load is also
/// concentrated.
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

/// An upper bound of the largest sum of sizes in a window of this width; the positions are sorted from left to right.
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
    // Each sum and difference is rounded in proportion to its own size, which is less than the total.
    #[expect(clippy::cast_precision_loss, reason = "a count, and more than twice as many roundings as there are")]
    let roundings = 4.0 * (places.len() as f64) * f64::EPSILON;
    (most + roundings * total) * OUTWARDS
}

/// The distance next to a support within which an upper bound of the moment is known; zero if there is none.
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

    /// A window includes both of its ends, and everything at one position.
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
