//! Brackets of the greatest and the least moment of a beam on an elastic foundation: the moments `M` of the pair, with its pressure `p`,
//! and an error bound.
//!
//! `v̂`, `M` and `p` of the pair and `v*`, `M* = −EI v*''` and `p* = k w*₊` of the beam satisfy
//!
//! ```text
//! ½∫ (EI v̂'' + M)²/EI + ½∫ (k w₊ − p)²/k ≤ gap,    ½∫ (EI v̂'' − EI v*'')²/EI + ½∫ (k w₊ − p*)²/k ≤ gap
//! ```
//!
//! with `p = 0` where the beam hangs. Where `p` is in tension, `k w₊ − p` is at most `k w − p` plus the tension that is cut off, and the
//! root of the gap includes both. Hence `m = M − M*` and `f = p − p*` satisfy `∫ m²/EI + ∫ f²/k ≤ (2 √(2 gap))²`. Between supports
//! `m'' = f`, without jumps of `m` and `m'`: both fields balance the same loads. For a function `φ` with `φ = 0` and `φ' = −1` at `x`,
//! integration by parts on one side of `x` gives
//!
//! ```text
//! m(x) = ∫ m φ'' dx − ∫ f φ dx:    |m(x)| ≤ 2 √( 2 gap S ),    S = ∫ (EI φ''² + k φ²) dx
//! ```
//!
//! with the greatest `EI` and `k`. This requires `φ = φ' = 0` before the next support. At a free end `φ` may be arbitrary, because the
//! moments of both fields there follow from the loads.
//!
//! - `φ'' = 3/2w` for `0 < s < w` and `−1/2w` for `w < s < 2w`: `S = 5 EI/2w + k w³/12`, least for `w⁴ = 10 EI/k`. Between two supports
//!   at a distance `b`, `w ≤ b/4`. In an overhang `w` is not limited, because there is no beam beyond the tip.
//! - `φ = −s` up to a free end at a distance of at most `a`: `S ≤ k a³/3`. This uses statics alone, so a softer foundation gives a
//!   smaller bound.
//! - The influence line of a beam on only two simple supports at a distance `b`, with overhangs `a` and `c`. `φ'` jumps by −1 at `x`,
//!   and `φ` vanishes at both supports: `S ≤ k (b³/48 + (a³ + c³)/3)`.
//!
//! An elastic support counts as a support here: at its position both fields may differ by a force and a couple.
//!
//! `m` is the same on both sides of a couple.
//!
//! Under an axial force `m'' = f − N w''` with `w = v̂ − v*`. By parts `∫ N w'' φ dx` is at most `3 |N| max |w|` if `φ = φ' = 0` before
//! the next support and before the next end, so there `w ≤ b/4` in every bay.

use crate::certificate::kernel::contact_node::EnclosedScene;
use crate::certificate::kernel::distance;
use crate::certificate::kernel::interval::Interval;
use crate::certificate::kernel::polynomial::number;
use crate::certificate::kernel::proof::{Pair, Sprung};
use crate::certificate::largest::extremes;

/// Brackets of the greatest and of the least moment; [`None`] if nothing could be proven.
pub(super) fn moments(enclosed: &EnclosedScene<'_>, pair: &Pair, sprung: &Sprung) -> [Option<Interval>; 2] {
    let (gap, force) = (pair.gap, Interval::exact(3.0 * enclosed.tension.abs()));
    let pulled = match enclosed.tension == 0.0 {
        true => Interval::ZERO,
        false => force * Interval::exact(distance::anywhere(pair, enclosed.stiffness, enclosed.length)),
    };
    let mut places: Vec<f64> = [0.0].into_iter().chain(enclosed.supports.iter().map(|s| s.x)).collect();
    places.extend(enclosed.said.iter().map(|said| said.x));
    places.push(enclosed.length);
    places.sort_by(f64::total_cmp);
    places.dedup();
    let begins_before = |x: f64| sprung.moments.partition_point(|(ends, _)| ends[0] < x);
    let brackets = places.windows(2).map(|bay| {
        let error = number(2) * (number(2) * Interval::exact(gap) * size(enclosed, [bay[0], bay[1]])).sqrt() + pulled;
        let inside = &sprung.moments[begins_before(bay[0])..begins_before(bay[1])];
        extremes(inside.iter().copied()).map(|of| of + Interval::around_zero(error.hi()))
    });
    let none = Interval::exact(f64::NEG_INFINITY);
    let greater = |a: Interval, b: Interval| Interval::between(a.lo().max(b.lo()), a.hi().max(b.hi()));
    let [greatest, negated] =
        brackets.fold([none; 2], |most, [greatest, least]| [greater(most[0], greatest), greater(most[1], -least)]);
    [greatest, -negated].map(|bracket| Some(bracket).filter(|bracket| bracket.is_finite()))
}

/// `S` of the best `φ` for all positions between two neighbouring supports, or between a support and an end of the beam.
fn size(enclosed: &EnclosedScene<'_>, [from, to]: [f64; 2]) -> Interval {
    let [k, stiffness] = [enclosed.stiffest_ground(), enclosed.stiffest].map(Interval::exact);
    let (length, supports) = (enclosed.length, enclosed.supports);
    let width = Interval::length(from, to);
    let stands =
        |x: f64| enclosed.support(x).is_some() || enclosed.said.iter().any(|said| said.x.total_cmp(&x).is_eq());
    let is_free = [from, to].map(|x| enclosed.tension == 0.0 && !stands(x));
    let best = (number(10) * stiffness / k).sqrt().sqrt();
    let room = if is_free == [false; 2] { best.lo().min((width / number(4)).lo()) } else { best.lo() };
    let w = Interval::exact(room);
    let bent = number(5) * stiffness / (number(2) * w) + k * w * w * w / number(12);
    let cube = |a: Interval| a * a * a;
    let straight = match (is_free, supports) {
        ([true, true], _) => k * cube(width / number(2)) / number(3),
        ([true, false] | [false, true], _) => k * cube(width) / number(3),
        (_, [a, b]) if enclosed.tension == 0.0 && !a.holds_slope() && !b.holds_slope() && enclosed.said.is_empty() => {
            let overhangs = [Interval::length(0.0, a.x), Interval::length(b.x, length)].map(cube);
            k * (cube(width) / number(48) + (overhangs[0] + overhangs[1]) / number(3))
        }
        _ => return bent,
    };
    if straight.hi() < bent.hi() { straight } else { bent }
}
