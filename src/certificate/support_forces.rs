//! Brackets of the reactions and of the total contact force.
//!
//! The moment fields of the pair and of the beam differ by `m` with `½ ∫ m²/EI dx ≤ gap`. Where the clearance of `v̂` is larger than the
//! bound on `|v̂ − v*|`, the true beam is not in contact. If this is true up to the distance `c` from a support, and the contact load of
//! the pair is zero there as well, both moment fields have `M'' = −q`, so that they differ by a line, and
//!
//! ```text
//! ½ ∫₀^c (m + κ x)²/EI dx ≤ gap:     |M'(x) − M*'(x)| = |κ| ≤ √( 24 EI gap / c³ ),     √( 6 EI gap / c³ ) for m = 0
//! ```
//!
//! If this is true all the way to a free end, nothing differs on that side, and at a simple support `m = 0` on the other side.
//!
//! Where the foundation begins at the level of a support, the clearance and its bound both vanish there, and their quotients by the
//! distance are compared. Forces of foundation and support at one position cannot be distinguished: the force there is the sum of both.
//!
//! If at most two supports and no foundation can carry a beam, its reactions follow from statics alone.
//!
//! Under an axial force the vertical forces differ by such a `κ` (`under_axial_force`).
//!
//! A compression-only support is a point of the foundation. If the beam is clear of the foundation next to it, its reaction follows in
//! the same way. If the beam is clear of the support, its reaction is zero.

mod axial;

use self::axial::{pulled, under_axial_force};
use super::beside::{bends_away, lies_beside, lies_idle, opens};
use super::kernel::contact_node::{EnclosedScene, EnclosedSupport};
use super::kernel::distance::{factor, lines, on_part};
use super::kernel::foundation::inside;
use super::kernel::giving::SaidSpring;
use super::kernel::interval::Interval;
use super::kernel::polynomial::{Polynomial, number};
use super::kernel::proof::{Pair, Piece};
use super::kernel::reference::{Datum, Line, OUTWARDS};
use super::largest::least_magnitude;
use super::quantities::{moment, resultant};
use crate::scene::{Load, Scene};

/// Brackets of the reactions from left to right under this load of a scene, and of the total contact force. The total contact force is
/// the load minus the reactions, and never negative. [`None`] where nothing could be proven.
pub(super) fn forces(
    scene: &Scene,
    load: &Load,
    enclosed: &EnclosedScene<'_>,
    pair: &Pair,
) -> (Vec<Option<Interval>>, Option<Interval>) {
    let by_statics = by_statics(scene, load, enclosed, pair);
    let load = resultant(load, enclosed.length);
    let mut supports = by_statics.unwrap_or_else(|| supports(enclosed, pair, load));
    if scene.ground_stiffness().is_some() {
        let width = |of: &Interval| of.hi() - of.lo();
        for (bracket, sprung) in supports.iter_mut().zip(on_springs(enclosed, pair)) {
            *bracket = bracket.filter(|known| width(known) <= width(&sprung)).or(Some(sprung));
        }
    }
    if scene.foundation().is_none() {
        return (supports, Some(Interval::ZERO));
    }
    let contact = supports.iter().try_fold(load, |left, force| Some(left - (*force)?));
    let contact = contact.map(Interval::not_negative).filter(|force| force.is_finite());
    (supports, contact)
}

/// The reactions on an elastic foundation. With `φ = 1` at a support, zero at the others, and no slope where a support holds it,
///
/// ```text
/// R = ∫ q φ dx − ∫ p φ dx + ∫ M φ'' dx,    ½∫ (M − M*)²/EI + ½∫ (p − p*)²/k ≤ gap
/// |R − R*| ≤ √( 2 gap ∫ (EI φ''² + k φ²) dx ),    φ = 1 − 3t² + 2t³ for t = s/w:    12 EI/w³ + 13 k w/35 on each side
/// ```
///
/// (under an axial force twice that, and `pulled`) with the greatest `EI` and `k`, for the forces of the pair. The bound is least for
/// `w⁴ = 36·35 EI / 13 k`. If statics alone determines the reactions, `φ` is a line, and only `∫ k φ² dx` remains, which is smaller on a
/// soft foundation. `R` is a reaction of the pair. Its enclosure includes the tension that is cut off: each support carries at most the
/// share that is added on both sides.
fn on_springs(enclosed: &EnclosedScene<'_>, pair: &Pair) -> Vec<Interval> {
    let [k, stiffness] = [enclosed.stiffest_ground(), enclosed.stiffest].map(Interval::exact);
    let widest = (36.0 * 35.0 / 13.0 * enclosed.stiffest / enclosed.stiffest_ground()).sqrt().sqrt();
    let side = |width: f64| {
        let w = Interval::exact(width);
        number(12) * stiffness / (w * w * w) + number(13) * k * w / number(35)
    };
    let all = enclosed.all_supports();
    let bracket = |(i, force): (usize, Interval)| {
        let x = all[i];
        let before = i.checked_sub(1).map_or(x, |i| Interval::length(all[i], x).lo());
        let end = Interval::length(x, enclosed.length).lo();
        let after = all.get(i + 1).map_or(end, |next| Interval::length(x, *next).lo());
        // At an end of the beam there is only one side.
        let widths = [before, after].map(|room| room.min(widest)).into_iter().filter(|width| 0.0 < *width);
        let bent = widths.clone().map(side).fold(Interval::ZERO, |sum, side| sum + side);
        if enclosed.tension != 0.0 {
            let root = (number(2) * Interval::exact(pair.gap) * bent).sqrt() * number(2);
            return force + Interval::around_zero((root + pulled(enclosed, pair, widths.map(Interval::exact))).hi());
        }
        let size = straight(enclosed, i).map(|square| k * square).filter(|size| size.hi() < bent.hi()).unwrap_or(bent);
        force + Interval::around_zero((number(2) * Interval::exact(pair.gap) * size).sqrt().hi())
    };
    supports_of(enclosed, pair).into_iter().enumerate().map(bracket).collect()
}

/// The reactions of all supports in the pair; zero for compression-only supports that the pair does not touch.
fn supports_of(enclosed: &EnclosedScene<'_>, pair: &Pair) -> Vec<Interval> {
    let at = |x: f64| pair.carried.iter().find(|(place, _)| place.total_cmp(&x).is_eq());
    let force = |x: f64| match enclosed.said_at(x) {
        Some(said) => Interval::exact(said.force),
        None => at(x).map_or(Interval::ZERO, |carried| carried.1),
    };
    enclosed.all_supports().into_iter().map(force).collect()
}

impl EnclosedScene<'_> {
    /// Positions of all supports, including compression-only ones, from left to right.
    pub(super) fn all_supports(&self) -> Vec<f64> {
        let mut all: Vec<f64> = self.supports.iter().map(|s| s.x).collect();
        all.extend(self.gap.ground.bearings.iter().map(|p| p[0]).chain(self.said.iter().map(|said| said.x)));
        all.sort_by(f64::total_cmp);
        all.dedup();
        all
    }

    /// Whether a compression-only support is at a position, except an elastic one that is pressed.
    pub(super) fn pushes_at(&self, x: f64) -> bool {
        !inside(self.gap.ground.bearings, x.next_down(), x.next_up()).is_empty() || self.idle_at(x).is_some()
    }

    /// The elastic support at a position, if it is treated as a load.
    fn said_at(&self, x: f64) -> Option<&SaidSpring> {
        self.said.iter().find(|said| said.x.total_cmp(&x).is_eq())
    }

    /// The level of a compression-only spring that is not pressed according to the candidate contact list.
    fn idle_at(&self, x: f64) -> Option<Interval> {
        let idle = self.said_at(x).filter(|said| said.gives.pushes && said.force <= 0.0)?;
        idle.gives.spring.map(|[_, level]| level)
    }
}

/// `∫ φ² dx` of the line that is 1 at a support and 0 at the other one, or 1 everywhere if there is no other; [`None`] if no line is
/// admissible.
fn straight(enclosed: &EnclosedScene<'_>, i: usize) -> Option<Interval> {
    let length = Interval::exact(enclosed.length);
    if !enclosed.said.is_empty() || enclosed.supports.iter().any(|support| support.gives.is_some()) {
        return None;
    }
    match enclosed.supports {
        [_] => Some(length),
        [a, b] if a.slope.is_none() && b.slope.is_none() => {
            let other = Interval::exact(if i == 0 { b.x } else { a.x });
            let (left, right, apart) = (other, length - other, Interval::length(a.x, b.x));
            Some((left * left * left + right * right * right) / (number(3) * apart * apart))
        }
        _ => None,
    }
}

/// The reactions by statics. This requires that there is no foundation, that the beam is proven to be clear of all supports except two,
/// and that no support holds its slope. The rounding of the deflection then has no influence.
fn by_statics(scene: &Scene, load: &Load, enclosed: &EnclosedScene<'_>, pair: &Pair) -> Option<Vec<Option<Interval>>> {
    let (all, factor) = (enclosed.all_supports(), factor(pair.gap, enclosed.stiffness));
    let is_free = scene.foundation().is_none()
        && pair.turns_about.is_none()
        && enclosed.supports.iter().all(|support| !support.holds_slope());
    let touches = |x: &f64| !enclosed.pushes_at(*x) || !is_clear_of(enclosed, pair, factor, *x);
    let touched: Vec<f64> = all.iter().copied().filter(|x| is_free && touches(x)).collect();
    let [a, b] = touched[..] else { return None };
    let apart = Interval::length(a, b);
    // The axial force acts on a beam with supports at its two ends through the difference of their levels.
    let pulled = if enclosed.tension == 0.0 {
        Interval::ZERO
    } else {
        let levels = [(a, 0.0), (b, enclosed.length)].map(|(x, end)| {
            let is_firm = |support: &&EnclosedSupport| x.total_cmp(&end).is_eq() && support.gives.is_none();
            let held = enclosed.support(x).filter(is_firm);
            held.map(|support| support.deflection)
        });
        Interval::exact(enclosed.tension) * (levels[1]? - levels[0]?) / apart
    };
    let force = |x: f64| {
        let force = match x {
            _ if x <= a && a <= x => -moment(load, enclosed.length, b) / apart + pulled,
            _ if x <= b && b <= x => moment(load, enclosed.length, a) / apart - pulled,
            _ => return Interval::ZERO,
        };
        if enclosed.pushes_at(x) { force.not_negative() } else { force }
    };
    Some(all.into_iter().map(|x| Some(force(x))).collect())
}

fn supports(enclosed: &EnclosedScene<'_>, pair: &Pair, load: Interval) -> Vec<Option<Interval>> {
    // For a pair without a gap the moments are the true ones.
    if pair.gap <= 0.0 {
        return supports_of(enclosed, pair).into_iter().map(Some).collect();
    }
    let all = enclosed.all_supports();
    if let Some(about) = pair.turns_about {
        let is_alone = carries_all(enclosed, pair, about);
        let force = |x: f64| if x.total_cmp(&about).is_eq() { load } else { Interval::ZERO };
        return all.into_iter().map(|x| is_alone.then(|| force(x))).collect();
    }
    let bracket = |(k, force): (usize, Interval)| {
        let x = all[k];
        let factor = factor(pair.gap, enclosed.stiffness);
        let touched = |x: &&f64| !enclosed.pushes_at(**x) || !is_clear_of(enclosed, pair, factor, **x);
        if !touched(&&x) {
            return Some(Interval::ZERO);
        }
        let before = all[..k].iter().rfind(touched).copied();
        let after = all[k + 1..].iter().find(touched).copied();
        let ends = [before.unwrap_or(0.0), after.unwrap_or(enclosed.length)];
        let reached = ends.map(|end| clear_from(enclosed, pair, x, end));
        let clear = reached.map(|reached| Interval::exact(reached) - Interval::exact(x));
        let given =
            [(before, 0), (after, 1)].map(|(next, side)| next.is_none() && (ends[side] - reached[side]).abs() <= 0.0);
        let mut turns = Interval::ZERO;
        for side in [0, 1] {
            let share = if given[1 - side] && enclosed.support(x).is_none_or(|s| !s.holds_slope()) { 6 } else { 24 };
            let c = Interval::exact(least_magnitude(clear[side]));
            let turn = if enclosed.tension == 0.0 {
                number(share) * Interval::exact(enclosed.stiffest) * Interval::exact(pair.gap) / (c * c * c)
            } else {
                under_axial_force(enclosed, pair, c)
            };
            match (given[side] || lies_beside(enclosed, pair, x, side), c.lo() <= 0.0) {
                (true, _) => {}
                (false, true) => return None,
                (false, false) => turns = turns + turn.sqrt(),
            }
        }
        let force = force + Interval::around_zero(turns.hi());
        Some(if enclosed.pushes_at(x) { force.not_negative() } else { force })
    };
    // A spring also has a bracket of its own.
    let sprung = |(k, force): (usize, Interval)| {
        let own = own_bracket(enclosed, pair, all[k], force);
        let known = if enclosed.said_at(all[k]).is_some_and(|said| said.force.abs() > 0.0) {
            None
        } else {
            bracket((k, force))
        };
        let width = |of: &Interval| of.hi() - of.lo();
        known.into_iter().chain(own).min_by(|a, b| width(a).total_cmp(&width(b)))
    };
    supports_of(enclosed, pair).into_iter().enumerate().map(sprung).collect()
}

/// The bracket of a spring force from its own contribution to the gap, `(R − R*)²/2k`; [`None`] for a rigid support.
fn own_bracket(enclosed: &EnclosedScene<'_>, pair: &Pair, x: f64, force: Interval) -> Option<Interval> {
    let of_support = || enclosed.support(x).and_then(|support| support.gives);
    let gives = enclosed.said_at(x).map(|said| said.gives).or_else(of_support)?;
    let [k, _] = gives.spring?;
    let bracket = force + Interval::around_zero((number(2) * Interval::exact(pair.gap) * k).sqrt().hi());
    Some(if gives.pushes { bracket.positive_part() } else { bracket })
}

/// Whether the beam is proven to be clear of the compression-only support at a position.
fn is_clear_of(enclosed: &EnclosedScene<'_>, pair: &Pair, factor: f64, x: f64) -> bool {
    on_part(pair, factor, [x, x]) < clear_of(enclosed, piece_at(pair, x), x).lo()
}

/// The piece that contains a position; if there are two, the left one.
pub(super) fn piece_at(pair: &Pair, x: f64) -> &Piece {
    &pair.pieces[pair.pieces.partition_point(|piece| piece.to < x).min(pair.pieces.len() - 1)]
}

/// The clearance of a piece at a position, from the foundation or from a support there.
fn clear_of(enclosed: &EnclosedScene<'_>, piece: &Piece, x: f64) -> Interval {
    let v = piece.v.at(Interval::length(piece.from, x));
    let clear = enclosed.gap.depth(x) - v;
    enclosed
        .idle_at(x)
        .map_or(clear, |level| Interval::between((level - v).lo().min(clear.lo()), (level - v).hi().min(clear.hi())))
}

/// A part of the beam next to a support, in the direction away from it: the clearance of `v̂` from the nearer end on.
struct Part<'a> {
    piece: &'a Piece,
    ends: [f64; 2],
    clearance: Polynomial,
    width: Interval,
}

/// The parts of the beam from a support to another position, the nearest first. Many parts are combined into one, above the highest
/// point of the foundation there, if that `is_enough`.
fn parts<'a>(
    enclosed: &EnclosedScene<'a>,
    pair: &'a Pair,
    [support, end]: [f64; 2],
    is_enough: impl Fn(&Part<'_>) -> bool,
) -> impl Iterator<Item = Part<'a>> {
    /// Parts per piece; only the length over which a proof succeeds depends on it.
    const PARTS: u32 = 16;
    /// The same for many pieces, as under an axial force: *tuned* on 2,000 pieces.
    const FEWER: u32 = 2;
    /// Number of pieces that counts as many: *tuned* on the same.
    const MANY: usize = 256;
    /// Number of parts that are tested together: *tuned* on surveys of 2·10⁴ and 2·10⁵ points, one of which is in contact.
    const TOGETHER: usize = 64;
    let (gap, from, to) = (enclosed.gap, support.min(end), support.max(end));
    let count = if enclosed.tension != 0.0 && MANY < pair.pieces.len() { FEWER } else { PARTS };
    let part = move |piece: &'a Piece, ends: [f64; 2], ground: &Polynomial| {
        let near = ends[usize::from(end < support)];
        let clearance = ground.minus(&piece.v.shifted(Interval::exact(near) - Interval::exact(piece.from)));
        let clearance = if end < support { clearance.mirrored() } else { clearance };
        Part { piece, ends, clearance, width: Interval::exact(ends[1]) - Interval::exact(ends[0]) }
    };
    // Evaluated only as far as the caller iterates.
    let mut left = pair.pieces.iter().filter(move |piece| from < piece.to && piece.from < to);
    let pieces = std::iter::from_fn(move || if end < support { left.next_back() } else { left.next() });
    let blocks = pieces.flat_map(move |piece| {
        let mut ends: Vec<f64> =
            (0..=count).map(|k| piece.from + (piece.to - piece.from) * (f64::from(k) / f64::from(count))).collect();
        ends.extend(gap.breaks(piece.from, piece.to));
        ends.sort_by(f64::total_cmp);
        ends.dedup();
        let mut parts: Vec<[f64; 2]> = ends.windows(2).map(|w| [w[0], w[1]]).collect();
        parts.retain(|ends| from <= ends[0] && ends[1] <= to);
        if end < support {
            parts.reverse();
        }
        let blocks: Vec<Vec<[f64; 2]>> = parts.chunks(TOGETHER).map(<[[f64; 2]]>::to_vec).collect();
        blocks.into_iter().map(move |block| (piece, block))
    });
    blocks.flat_map(move |(piece, block)| {
        let (first, last) = (block[0], block[block.len() - 1]);
        let ends = [first[0].min(last[0]), first[1].max(last[1])];
        let level = || Polynomial::new(&[Interval::exact(gap.least(ends[0], ends[1]))]);
        let one = (block.len() == TOGETHER).then(|| part(piece, ends, &level())).filter(&is_enough);
        let each = if one.is_some() { Vec::new() } else { block };
        let about = move |ends: [f64; 2]| part(piece, ends, &gap.about(ends[usize::from(end < support)], ends));
        one.into_iter().chain(each.into_iter().map(about))
    })
}

/// The farthest position, from `x` towards `end`, up to which the beam is proven to be clear of the foundation and the pair has no
/// contact load. Both are needed: a wrong candidate contact list may have contact forces where `v̂` is clear of an elastic foundation.
pub(super) fn clear_from(enclosed: &EnclosedScene<'_>, pair: &Pair, x: f64, end: f64) -> f64 {
    let (at_level, factor) =
        (enclosed.support(x).map_or([false; 2], |s| s.at_level), factor(pair.gap, enclosed.stiffness));
    let towards = usize::from(x < end);
    // The compression-only supports strictly between the two positions.
    let stands = |y: &f64| x.min(end) < *y && *y < x.max(end) && enclosed.pushes_at(*y);
    let is_above = |part: &Part<'_>| on_part(pair, factor, part.ends) < part.clearance.range(part.width).lo();
    let is_clear = |part: &Part<'_>| {
        let beside = part.ends[1 - towards].total_cmp(&x).is_eq() && at_level[towards];
        let by = if beside {
            // The error of a deflection that is known at the support is at most this, over the distance from the support.
            let is_here = |at: &Datum| at.from.max(at.to) <= x && x <= at.from;
            let known = lines(pair, part.ends)
                .filter(|Line(a, b)| a.uncertainty.max(b.uncertainty) <= 0.0 && (is_here(a) || is_here(b)));
            let off = known.map(|Line(a, b)| {
                let reach = b.to.max(part.ends[1]) - a.from.min(part.ends[0]);
                factor * reach.sqrt() * OUTWARDS
            });
            off.fold(f64::INFINITY, f64::min) < part.clearance.divided(1).range(part.width).lo()
                || pair.ground.is_none() && bends_away(enclosed, x, end, part.ends)
                || opens(enclosed, pair, x, part.ends)
        } else {
            is_above(part)
        };
        let of_bearings = || part.ends.iter().filter(|y| stands(y)).all(|&y| is_clear_of(enclosed, pair, factor, y));
        !part.piece.pressed && (by && of_bearings() || lies_idle(enclosed, pair, x, part.ends))
    };
    let clear = parts(enclosed, pair, [x, end], is_above).take_while(is_clear).last();
    clear.map_or(x, |part| part.ends[towards])
}

/// Whether a single position carries all of a load that is in balance above it, although the beam can rotate about it. Contact on one
/// side would require contact on the other. With a rotation by `θ` the clearance at the distance `a` from the support changes by
/// `± θ a`, and its error is at most `√(2 gap/3 EI) a^(3/2)`. It cannot vanish on both sides if the sum of both quotients by the
/// distance is larger.
fn carries_all(enclosed: &EnclosedScene<'_>, pair: &Pair, support: f64) -> bool {
    let most = Interval::exact(factor(pair.gap, enclosed.stiffness)) * Interval::exact(enclosed.length).sqrt();
    let least = |end: f64| {
        let quotient = |part: Part<'_>| {
            let far = part.ends.map(|x| (x - support).abs()).into_iter().fold(0.0, f64::max);
            let least = part.clearance.range(part.width).lo();
            let stands = part.ends.iter().filter(|y| enclosed.pushes_at(**y) && 0.0 < (**y - support).abs());
            let least = stands.fold(least, |least, &y| least.min(clear_of(enclosed, part.piece, y).lo()));
            let all = Interval::exact(least) / Interval::exact(far);
            if 0.0 <= least { all.lo() } else { f64::NEG_INFINITY }
        };
        parts(enclosed, pair, [support, end], |_| false).map(quotient).fold(f64::INFINITY, f64::min)
    };
    let [left, right] = [0.0, enclosed.length].map(least);
    (number(2) * most).hi() < (Interval::exact(left) + Interval::exact(right)).lo()
        || left == f64::INFINITY
        || right == f64::INFINITY
}

#[cfg(test)]
mod tests;
