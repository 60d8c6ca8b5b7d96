//! The beam next to a support at which a rigid foundation begins at the level of the support: it is in contact there, or clear of the
//! foundation.
//!
//! Everything follows from one fact. Let the clearance `h = g − v*` satisfy `h = h' = 0` at two positions. Between them let the pressure
//! `P = q − EI g''''` of a beam that follows the foundation satisfy `P ≥ 0`. Where `h > 0`, `EI h'''' = −P ≤ 0`. But a beam that is
//! built in or simply supported at the ends of such a part bends everywhere in the direction of its load, and it does so under such an
//! end couple too (their influence lines have one sign). So there is no such part, and `h = 0` between the two positions.
//!
//! **It is in contact** ([`lies_beside`]) as far as a contact `β`, if one is proven. At `β` `h = h' = 0`. At the support `h = 0`, and
//! either `h' = 0` because foundation or support allow no other slope, or `h'' = g'' ≥ 0` at a simple support at the end of the beam.
//! From the pair
//!
//! ```text
//! ∫ φ dp* = ∫ M* φ'' + ∫ q φ ≥ ∫ −EI v̂'' φ'' + ∫ q φ − √( 2 gap ∫ EI φ''² ),    φ = s² (w − s)²,  ∫ φ''² = 4w⁵/5
//! ```
//!
//! If this is positive, the beam is in contact somewhere between two positions at the distance `w`, one of which may be the support.
//! Where `P = 0` it is in contact without pressure ([`lies_idle`]), and its moments there depend on the same loads as where it is clear.
//!
//! **It is clear** ([`opens`]) of a foundation from which the pair separates with a curvature. Let `v*` be clear of it from the distance
//! `s` on, with the slope of the foundation at the support. Suppose that there are nearer contacts, the last of them at `β ≤ s`. Then
//! `h = 0` up to `β`, and at `β` `h = h' = 0` and `h'' ≤ η`. Here `η` is zero, or the effect of a load that acts away from the
//! foundation, `EI η = s² max(−P, 0)/12`. Beyond `β`
//!
//! ```text
//! h(x) = h''(β) (x − β)²/2 + T (x − β)³/6 − ∫ (x − ξ)³ P dξ / 6 EI
//! h(4s) − ρ³ h(2s) ≥ −η (4s)² − (1 + ½) (4s)⁴ max |P| / 24 EI,      ρ = (4s − β)/(2s − β) from 2 to 3
//! ```
//!
//! for any `T`. If the clearance opens with the square of the distance, the left side, at most `h(4s) − 8 h(2s)`, is smaller.

use super::kernel::contact_node::{EnclosedScene, EnclosedSupport};
use super::kernel::distance::{factor, on_part};
use super::kernel::interval::Interval;
use super::kernel::load::cells;
use super::kernel::polynomial::{Polynomial, number};
use super::kernel::pressing::pressure;
use super::kernel::proof::{Pair, Piece};
use super::kernel::reference::OUTWARDS;
use super::support_forces::piece_at;

/// Whether a rigid foundation bends away from the beam in a part next to a support at its level, from which the beam extends to a free
/// end. Contact forces act upwards, wherever they are, and at a distance `s` from the support
///
/// ```text
/// EI h'' = EI g'' + M ≥ EI g'' − ∫ |q| (ξ − s) dξ − Σ |P| (ξ − s) − Σ |C| > 0,    h = 0 and h' ≥ 0 for s = 0:    h > 0
/// ```
///
/// On an elastic foundation the beam may penetrate next to the support, `h' < 0`.
pub(super) fn bends_away(enclosed: &EnclosedScene<'_>, x: f64, end: f64, part: [f64; 2]) -> bool {
    let beyond = |place: f64| x.min(end) <= place && place <= x.max(end) && (place - x).abs() > 0.0;
    let is_free = end <= 0.0 || enclosed.length <= end;
    let is_joined = enclosed.joints.iter().any(|joint| beyond(joint.0));
    if !is_free || is_joined || enclosed.supports.iter().any(|support| beyond(support.x)) {
        return false;
    }
    let load = enclosed.load;
    let (from, to) = (x.min(end), x.max(end));
    let spread = cells(from, to, load.breaks(from, to)).into_iter().map(|cell| {
        let most = cell.map(|x| load.line(x, cell)[0].magnitude()).into_iter().fold(0.0, f64::max);
        let far = cell.map(|place| (place - x).abs()).into_iter().fold(0.0, f64::max);
        Interval::exact(most) * Interval::length(cell[0], cell[1]) * Interval::exact(far * OUTWARDS)
    });
    let points = load.points.iter().filter(|(place, _)| beyond(*place));
    let points =
        points.map(|(place, force)| Interval::exact(force.magnitude()) * Interval::exact((place - x).abs() * OUTWARDS));
    let couples = load.couples.iter().filter(|(place, _)| x.min(end) <= *place && *place <= x.max(end));
    let couples = couples.map(|(_, couple)| Interval::exact(couple.magnitude()));
    let bent = spread.chain(points).chain(couples).fold(Interval::ZERO, |sum, part| sum + part);
    let width = Interval::length(part[0], part[1]);
    let ground = enclosed.gap.about(part[0], part).derivative().derivative().times(Interval::exact(enclosed.stiffness));
    bent.hi() < ground.range(width).lo()
}

/// Whether the beam is proven to be clear of a rigid foundation in all of a part next to a support at its level. At the support itself
/// it has the slope of the foundation. For the proof see the head of this file.
pub(super) fn opens(enclosed: &EnclosedScene<'_>, pair: &Pair, x: f64, ends: [f64; 2]) -> bool {
    /// Halvings of the distance `s`: the bound is proportional to `s^(3/2)`, and the clearance to `s²`.
    const HALVINGS: u32 = 16;
    let side = usize::from(ends[0].total_cmp(&x).is_eq());
    let is_tangent = enclosed.support(x).is_some_and(|support| keeps_slope(support, side));
    if !is_tangent
        || !is_uniform(enclosed)
        || is_turned(enclosed, ends)
        || pair.ground.is_some()
        || !enclosed.gap.is_smooth_between(ends[0], ends[1])
    {
        return false;
    }
    let (piece, stiffness) = (piece_at(pair, 0.5 * (ends[0] + ends[1])), Interval::exact(enclosed.stiffness));
    let mirrored = |of: Polynomial| if side == 0 { of.mirrored() } else { of };
    let v = piece.v.shifted(Interval::exact(x) - Interval::exact(piece.from));
    let clearance = mirrored(enclosed.gap.about(x, ends).minus(&v));
    let pressure = mirrored(pressure(enclosed, x, ends));
    let (width, factor) = ((ends[1] - ends[0]).next_up(), factor(pair.gap, enclosed.stiffness));
    // A part between two distances from the support, and the error bound of the deflection there.
    let off = |near: f64, far: f64| {
        let part = if side == 0 { [x - far, x - near] } else { [x + near, x + far] };
        Interval::exact(on_part(pair, factor, [part[0].next_down(), part[1].next_up()]))
    };
    let is_above = |near: f64, far: f64| {
        let apart = clearance.shifted(Interval::exact(near)).range(Interval::length(near, far.next_up()));
        off(near, far).hi() < apart.lo()
    };
    let opens = |s: f64| {
        let all = pressure.range(Interval::exact(4.0 * s));
        let [square, four] = [Interval::exact(s).square(), Interval::exact(4.0 * s)];
        let bent = square * Interval::exact((-all.lo()).max(0.0)) / number(12) * four.square();
        let pressed = number(3) * four.square().square() * Interval::exact(all.magnitude()) / number(48);
        let most = clearance.at(four) + off(s, 4.0 * s);
        let least = clearance.at(Interval::exact(2.0 * s)) - off(s, 4.0 * s);
        ((most - number(8) * least) * stiffness + bent + pressed).hi() < 0.0
    };
    // From the far end towards the support, as far as the beam is clear.
    let mut far = width;
    for _ in 0..HALVINGS {
        let near = 0.5 * far;
        if !is_above(near, far) {
            return false;
        }
        if 4.0 * near <= width && opens(near) {
            return true;
        }
        far = near;
    }
    false
}

/// Whether the slope of the foundation is the only possible slope of the beam on one side of a support at its level.
fn keeps_slope(support: &EnclosedSupport, side: usize) -> bool {
    support.at_level[side] && support.is_fixed && (support.slope.is_none() || support.tangent[side])
}

/// Whether a beam in contact next to a support cannot lift off between the support and a contact, where the pressure is not negative.
fn starts_along(enclosed: &EnclosedScene<'_>, support: &EnclosedSupport, side: usize) -> bool {
    let at_end = support.x <= 0.0 || enclosed.length <= support.x;
    let is_turned = || is_turned(enclosed, [support.x, support.x]);
    let hinged =
        || at_end && support.slope.is_none() && !is_turned() && 0.0 <= enclosed.gap.jet(support.x, side == 0)[2].lo();
    keeps_slope(support, side) || support.at_level[side] && hinged()
}

/// Whether the beam is in contact next to a support, on its left or on its right side, like the pair; see the head of this file.
pub(super) fn lies_beside(enclosed: &EnclosedScene<'_>, pair: &Pair, x: f64, side: usize) -> bool {
    let Some(support) = enclosed.support(x).filter(|_| pair.ground.is_none() && is_uniform(enclosed)) else {
        return false;
    };
    let to_the_left = side == 0;
    let is_beside = |piece: &&Piece| (if to_the_left { piece.to } else { piece.from }).total_cmp(&x).is_eq();
    if !pair.pieces.iter().find(is_beside).is_some_and(|piece| piece.pressed) {
        return false;
    }
    if !starts_along(enclosed, support, side) {
        return false;
    }
    reaches(enclosed, x, side).any(|part| presses_all_along(enclosed, part) && touches(enclosed, pair, part))
}

/// Parts from a position to one side: up to the next support, the next corner of the foundation or the end of the beam, and halves of
/// this part.
fn reaches(enclosed: &EnclosedScene<'_>, x: f64, side: usize) -> impl Iterator<Item = [f64; 2]> {
    /// Only the size of the smallest part depends on it.
    const HALVINGS: usize = 16;
    let to_the_left = side == 0;
    let [from, to] = if to_the_left { [0.0, x] } else { [x, enclosed.length] };
    let breaks = enclosed.gap.breaks(from, to).into_iter().filter(|y| !enclosed.gap.is_smooth_at(*y));
    let others = enclosed.supports.iter().map(|s| s.x).filter(|y| from < *y && *y < to);
    let room = breaks.chain(others).map(|y| (y - x).abs()).fold(to - from, f64::min);
    let halves = std::iter::successors(Some(room), |reach| Some(0.5 * reach)).take(HALVINGS);
    halves.map(move |reach| if to_the_left { [x - reach, x] } else { [x, x + reach] })
}

/// Whether the beam is proven to be in contact with a rigid foundation from a support to the far end of a part, without pressure there,
/// because contact is proven beyond the part.
pub(super) fn lies_idle(enclosed: &EnclosedScene<'_>, pair: &Pair, x: f64, ends: [f64; 2]) -> bool {
    let side = usize::from(x <= ends[0]);
    let starts = enclosed.support(x).is_some_and(|support| starts_along(enclosed, support, side));
    let idle = || pressure(enclosed, ends[0], ends).range(Interval::length(ends[0], ends[1])).magnitude() <= 0.0;
    let beyond = |[from, to]: [f64; 2]| if side == 0 { [from, ends[0]] } else { [ends[1], to] };
    let touches_beyond = |part: [f64; 2]| {
        let [from, to] = beyond(part);
        from < to && presses_all_along(enclosed, part) && touches(enclosed, pair, [from, to])
    };
    pair.ground.is_none() && is_uniform(enclosed) && starts && idle() && reaches(enclosed, x, side).any(touches_beyond)
}

/// Whether the beam has one stiffness, no joints, no axial force, and no springs except vertical ones at supports. The proofs of this
/// file are valid only for such beams.
fn is_uniform(enclosed: &EnclosedScene<'_>) -> bool {
    let turns = |support: &EnclosedSupport| support.gives.is_some_and(|gives| gives.turning.is_some());
    let gives = !enclosed.said.is_empty() || enclosed.supports.iter().any(turns);
    enclosed.changes.is_empty() && enclosed.joints.is_empty() && enclosed.tension == 0.0 && !gives
}

/// Whether a couple acts in a part or at an end of it.
fn is_turned(enclosed: &EnclosedScene<'_>, [from, to]: [f64; 2]) -> bool {
    enclosed.load.couples.iter().any(|(place, couple)| from <= *place && *place <= to && 0.0 < couple.magnitude())
}

/// Whether, on a part where the beam follows the foundation, no load acts away from the foundation and no couple acts.
fn presses_all_along(enclosed: &EnclosedScene<'_>, [from, to]: [f64; 2]) -> bool {
    let breaks = [enclosed.load.breaks(from, to), enclosed.gap.breaks(from, to)].concat();
    let pushes = |x: &f64| 0.0 <= enclosed.load.point(*x).lo();
    // A pressure that vanishes at one end of a cell is not negative only as seen from that end: elsewhere it is rounded.
    let presses = |cell: &[f64; 2]| {
        let seen_from = [pressure(enclosed, cell[0], *cell), pressure(enclosed, cell[1], *cell).mirrored()];
        seen_from.iter().any(|pressure| 0.0 <= pressure.range(Interval::length(cell[0], cell[1])).lo())
    };
    !is_turned(enclosed, [from, to]) && breaks.iter().all(pushes) && cells(from, to, breaks).iter().all(presses)
}

/// Whether contact is proven strictly between two positions.
fn touches(enclosed: &EnclosedScene<'_>, pair: &Pair, [from, to]: [f64; 2]) -> bool {
    let (stiffness, w) = (Interval::exact(enclosed.stiffness), Interval::length(from, to));
    let bump = Polynomial::new(&[Interval::ZERO, Interval::ZERO, w * w, -(number(2) * w), number(1)]);
    let mut contact = Interval::ZERO;
    for piece in pair.pieces.iter().filter(|piece| from < piece.to && piece.from < to) {
        let (a, b) = (piece.from.max(from), piece.to.min(to));
        let (at, width) = (bump.shifted(Interval::length(from, a)), Interval::length(a, b));
        let bent = piece.v.shifted(Interval::length(piece.from, a)).derivative().derivative().times(stiffness);
        let load = Polynomial::new(&enclosed.load.line(a, [a, b]));
        let stands = if from < a { enclosed.load.point(a) * at.at(Interval::ZERO) } else { Interval::ZERO };
        let turned = at.derivative().derivative();
        contact = contact + load.integral_of_product(&at, width) - bent.integral_of_product(&turned, width) + stands;
    }
    let square = number(4) * w.square() * w.square() * w / number(5);
    let off = (number(2) * Interval::exact(pair.gap) * stiffness * square).sqrt();
    off.hi() < contact.lo()
}
