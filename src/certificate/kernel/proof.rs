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
//! without two supports is held by contact forces: what is cut off is taken from two of them, and none may be used up. Where only
//! one place carries the beam, the ground beside it stops the beam from turning (`stops`), and takes couples.

use super::clearance;
use super::contact_node::{ContactNode, EnclosedScene, Slope};
use super::distance::factor;
use super::hold::{Hold, Place};
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
    /// `v̂`: its value and its slope are continuous, and its supports hold it. Pieces end where the load changes its formula
    /// and at point loads.
    pub(crate) pieces: Vec<Piece>,
    /// At least `J(v̂) − D(p, R)`.
    pub(crate) gap: f64,
    /// What the supports exert upwards, from left to right, where the contacts of `M` are those of the beam.
    pub(crate) reactions: Vec<Interval>,
    /// What holds the beam: each of them alone bounds the distance of `v̂` from `v*`.
    pub(crate) holds: Vec<Hold>,
    /// The place about which the beam may turn without a force, if the contacts of `M` do not say how it stands.
    pub(crate) turns_about: Option<f64>,
    /// How far `v̂` was lifted at most off the deflection that the places of the witness make; infinite if it is of no witness.
    pub(crate) lifted: f64,
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
    let moments: Vec<_> = (0..nodes.len()).map(|i| moments(enclosed, nodes, &spans, i)).collect();
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
            pieces.extend(pressing::zone(enclosed, left.x, right.x, &mut cut_off)?);
            shears.push([(left, false), (right, true)].map(|(j, left)| -(stiffness * enclosed.gap.jet(j.x, left)[3])));
            continue;
        };
        let length = Interval::exact(span.to) - Interval::exact(span.from);
        if let [Some(_), Some(_)] = ends(i) {
            let moments = [moments[i - 1].0[1], moments[i].0[0]];
            let r = [stiffness * span.start[2] + moments[0], stiffness * span.end[2] + moments[1]];
            // Not from the third derivative, of which rounding is larger by the square of a short span.
            let shear = (moments[1] - moments[0] + span.loaded[0]) / length;
            shears.push([shear, shear - span.loaded[1]]);
            gap = gap + length * (r[0].square() + r[1].square() + (r[0] + r[1]).square()) / (number(12) * stiffness);
        } else {
            shears.push([span.start, span.end].map(|jet| -(stiffness * jet[3])));
        }
        let parts = span.curves(enclosed.load, enclosed.stiffness);
        let lift = clearance::lift(enclosed, span, &parts, ends(i))?;
        lifts = lifts + lift.derivative().derivative().integral_of_square(length) * stiffness;
        lifted = lifted.max(lift.range(length).magnitude());
        pieces.extend(parts.into_iter().map(|([from, to], [v, _])| {
            let v = v.minus(&lift.shifted(Interval::exact(from) - Interval::exact(span.from)));
            Piece { from, to, v, follows: false }
        }));
    }
    let point = |x: f64| enclosed.load.point(x).unwrap_or(Interval::ZERO);
    let forces: Vec<Interval> =
        nodes.iter().enumerate().map(|(i, node)| shears[i + 1][0] - shears[i][1] + point(node.x)).collect();
    // The place above which the loads are in balance, if that is all that carries the beam.
    let turns_about = enclosed.balanced_at.filter(|_| matches!(nodes, [node] if enclosed.balanced_at == Some(node.x)));
    let mut couples = 0.0;
    for ((node, &force), &(_, jump)) in nodes.iter().zip(&forces).zip(&moments) {
        let support = enclosed.support(node.x);
        if support.is_none() {
            cut_off.force(node.x, force);
        }
        // Loads in balance need no couple, and what the beam is built in exerts any.
        if turns_about.is_none() {
            let made = |left: bool| support.is_some_and(|s| s.slope.is_some() || enclosed.order(node, left) == 2);
            cut_off.couple(node.x, jump, [true, false].map(made));
            couples += jump.magnitude();
        }
    }
    let held = match held(enclosed, turns_about) {
        holds if holds.is_empty() => {
            held_by_contact(enclosed, &pieces, carriers(enclosed, nodes, &forces), couples, &cut_off)?
        }
        holds => Held { carried: cut_off.carried(&holds, enclosed.stiffness), holds, stops: None },
    };
    let [moment, share] = held.carried;
    let correction = lifts.sqrt() + moment;
    // What presses at stops has the clearance there for its gap.
    let opened = held.stops.map_or(Interval::ZERO, |Hold(a, b)| share * Interval::exact(a.off.max(b.off)));
    let root = (number(2) * Interval::between(gap.lo().max(0.0), gap.hi())).sqrt() + correction;
    // Without correction the square would only add rounding.
    let gap = (if correction.is_zero() { gap } else { root.square() / number(2) } + opened).hi();
    let holds = held.known(gap, enclosed.stiffness)?;
    let corrected = Interval::around_zero(share.hi());
    let supports = nodes.iter().zip(forces).filter(|(node, _)| enclosed.support(node.x).is_some());
    Some(Pair {
        pieces,
        gap,
        reactions: supports.map(|(_, force)| force + corrected).collect(),
        holds,
        turns_about,
        lifted,
    })
}

/// What holds the beam and carries what is cut off: the moments that this takes, and the share of each place.
struct Held {
    holds: Vec<Hold>,
    /// Of a beam that a single place carries, which is between them.
    stops: Option<Hold>,
    carried: [Interval; 2],
}

impl Held {
    /// Each of the holds with what is known of the deflection there; [`None`] if a place is used up.
    fn known(self, gap: f64, stiffness: f64) -> Option<Vec<Hold>> {
        let Self { mut holds, stops, carried } = self;
        for place in holds.iter_mut().flat_map(|Hold(left, right)| [left, right]).filter(|p| p.presses.is_finite()) {
            // What is cut off is taken from it.
            let remains = (Interval::exact(place.presses) - carried[1]).lo();
            if remains <= 0.0 {
                return None;
            }
            place.off = place.off.max((Interval::exact(gap) / Interval::exact(remains)).hi());
        }
        Some(match stops {
            Some(stops) => vec![between_stops(stops, &holds[0].1, factor(gap, stiffness))],
            None => holds,
        })
    }
}

/// What holds a beam that its supports do not hold: two of the places that carry it, or one of them and what stops it there.
fn held_by_contact(
    enclosed: &EnclosedScene<'_>,
    pieces: &[Piece],
    mut carriers: Vec<Place>,
    couples: f64,
    cut_off: &TensionCutOff,
) -> Option<Held> {
    if let Some(hold) = widest(&mut carriers) {
        let carried = cut_off.carried(&[hold], enclosed.stiffness);
        // Not with a place that is used up.
        if carried[1].hi() < hold.0.presses.min(hold.1.presses) {
            return Some(Held { holds: vec![hold], stops: None, carried });
        }
    }
    let place = *carriers.iter().find(|place| place.to <= place.from)?;
    let stops = stops(enclosed, pieces, place.from, 16.0 * (couples / place.presses))?;
    // A couple is taken by the stop to which it turns the beam, and so by either.
    let holds = vec![Hold(Place::at(stops.0.from), place), Hold(place, Place::at(stops.1.from))];
    let both = [0, 1].map(|k| cut_off.carried(&holds[k..=k], enclosed.stiffness));
    Some(Held { holds, stops: Some(stops), carried: [0, 1].map(|k| both[0][k] + both[1][k]) })
}

/// What holds the beam whatever it touches, from left to right: neighbouring two of its supports, and one at which it cannot turn,
/// or about which the loads are in balance.
fn held(enclosed: &EnclosedScene<'_>, turns_about: Option<f64>) -> Vec<Hold> {
    let two = enclosed.supports.windows(2).map(|w| [w[0].x, w[1].x]);
    let one = enclosed.supports.iter().filter(|s| s.is_fixed).map(|s| s.x).chain(turns_about).map(|x| [x; 2]);
    let mut holds: Vec<Hold> = two.chain(one).map(|[a, b]| Hold(Place::at(a), Place::at(b))).collect();
    holds.sort_by(|a, b| a.0.from.total_cmp(&b.0.from));
    holds
}

/// Where the beam is carried: single nodes, parts of zones, and loads that stand in them. What is taken from a part is taken in
/// proportion to what presses there: the mean of what single places would give, of which the worst is counted.
fn carriers(enclosed: &EnclosedScene<'_>, nodes: &[ContactNode], forces: &[Interval]) -> Vec<Place> {
    let carried = |(x, force): (f64, Interval)| match enclosed.support(x) {
        Some(_) => Place::at(x),
        None => Place { presses: force.lo(), ..Place::at(x) },
    };
    let mut carriers: Vec<Place> = nodes.iter().map(|node| node.x).zip(forces.iter().copied()).map(carried).collect();
    for (from, to) in nodes.windows(2).filter(|w| w[0].lies).map(|w| (w[0].x, w[1].x)) {
        let breaks = enclosed.load.breaks(from, to);
        carriers.extend(breaks.iter().filter_map(|&x| Some(carried((x, enclosed.load.point(x)?)))));
        carriers.extend(cells(from, to, breaks).into_iter().flat_map(|cell| outer_thirds(enclosed, cell)));
    }
    carriers.into_iter().filter(|place| 0.0 < place.presses).collect()
}

/// The outer thirds of a part of a zone without a break of the load.
fn outer_thirds(enclosed: &EnclosedScene<'_>, [from, to]: [f64; 2]) -> [Place; 2] {
    let third = (to - from) / 3.0;
    [[from, from + third], [to - third, to]].map(|part| pressed(enclosed, part))
}

/// A part of a zone without a break of the load, with what presses on it at least: the load, and what the shear of the beam that
/// follows the ground changes by.
fn pressed(enclosed: &EnclosedScene<'_>, [from, to]: [f64; 2]) -> Place {
    let [start, end] = [(from, false), (to, true)].map(|(x, left)| enclosed.gap.jet(x, left)[3]);
    let width = Interval::exact(to) - Interval::exact(from);
    let one = Polynomial::new(&[Interval::exact(1.0)]);
    let load = enclosed.load.cell(from, to).integral_of_product(&one, width);
    Place { from, to, presses: (Interval::exact(enclosed.stiffness) * (start - end) + load).lo(), off: 0.0 }
}

/// Zones hold a beam that supports hold, too, and from nearer by: each second part of them, with the next one and with the supports
/// on both sides. What is cut off is carried by the supports, and never less presses in a zone than without.
pub(crate) fn hold_by_zones(enclosed: &EnclosedScene<'_>, nodes: &[ContactNode], pair: &mut Pair) {
    /// Of all zones together: the price of a bound is in proportion.
    const MOST_PARTS: u32 = 256;
    let zones: Vec<[f64; 2]> = nodes.windows(2).filter(|w| w[0].lies).map(|w| [w[0].x, w[1].x]).collect();
    let parts = u32::try_from(zones.len()).ok().and_then(|zones| MOST_PARTS.checked_div(zones)).unwrap_or(0);
    if parts < 3 || pair.holds.iter().any(|Hold(left, right)| left.presses.min(right.presses).is_finite()) {
        return;
    }
    for [from, to] in zones {
        let end = |k: u32| if k < parts { from + (to - from) * (f64::from(k) / f64::from(parts)) } else { to };
        let part =
            |k: u32| Some([end(k), end(k + 1)]).filter(|[a, b]| a < b && enclosed.load.breaks(*a, *b).is_empty());
        let pressed = (0..parts).step_by(2).filter_map(part).map(|part| pressed(enclosed, part));
        let off = |place: &Place| (Interval::exact(pair.gap) / Interval::exact(place.presses)).hi();
        let held = pressed.filter(|place| 0.0 < place.presses).map(|place| Place { off: off(&place), ..place });
        let beside = |x: f64, left: bool| {
            let mut supports = enclosed.supports.iter().map(|s| s.x);
            if left { supports.rfind(|s| *s < x) } else { supports.find(|s| x < *s) }.map(Place::at)
        };
        let places: Vec<Place> = beside(from, true).into_iter().chain(held).chain(beside(to, false)).collect();
        pair.holds.extend(places.windows(2).map(|w| Hold(w[0], w[1])));
    }
    pair.holds.sort_by(|a, b| a.0.from.total_cmp(&b.0.from));
}

/// Of places that press the two that hold the beam best: strongly, and far apart.
fn widest(carriers: &mut [Place]) -> Option<Hold> {
    /// Of the strongest places.
    const MOST: usize = 64;
    carriers.sort_by(|a, b| b.presses.total_cmp(&a.presses));
    let strongest = &carriers[..carriers.len().min(MOST)];
    let pairs = strongest.iter().flat_map(|a| strongest.iter().map(move |b| Hold(*a, *b)));
    let worth = |Hold(a, b): &Hold| (b.from - a.to) * a.presses.min(b.presses);
    pairs.filter(|Hold(a, b)| a.to < b.from).max_by(|a, b| worth(a).total_cmp(&worth(b)))
}

/// The places on the left and on the right of the single place that carries a beam at which the ground stops it if it turns: those to
/// which it turns by the least angle, each with the clearance there, and none much nearer than `apart`. Where the beam is tangent to the ground, the clearance beside
/// that place is small, and smaller the nearer it is:
///
/// ```text
/// g − v̂ ≤ ½ s² max (g − v̂)''     at the distance s from a place where g = v̂ and g' = v̂'
/// ```
fn stops(enclosed: &EnclosedScene<'_>, pieces: &[Piece], x: f64, apart: f64) -> Option<Hold> {
    /// Of the length of the beam.
    const NEAR: f64 = 1.0 / 274_877_906_944.0;
    let far = apart.max(NEAR * enclosed.length);
    let mut found: [Option<(f64, Place)>; 2] = [None; 2];
    let mut stop = |y: f64, off: f64| {
        if (y - x).abs() < 0.5 * apart {
            return;
        }
        let (angle, best) = (off / (y - x).abs(), &mut found[usize::from(x < y)]);
        let farther = |place: &Place| (place.from - x).abs() < (y - x).abs();
        if best.as_ref().is_none_or(|(least, place)| angle < *least || (angle <= *least && farther(place))) {
            *best = Some((angle, Place { off, ..Place::at(y) }));
        }
    };
    for Piece { from, to, v, follows } in pieces {
        for y in enclosed.gap.breaks(*from, *to).into_iter().chain([*from, *to]).filter(|y| (y - x).abs() > 0.0) {
            let clear = enclosed.gap.depth(y) - v.at(Interval::exact(y) - Interval::exact(*from));
            stop(y, if *follows { 0.0 } else { clear.hi().max(0.0) });
        }
    }
    // On smooth ground a beam that touches it inside is tangent to it.
    let tangent = enclosed.supports.is_empty() && enclosed.gap.is_smooth_at(x) && 0.0 < x && x < enclosed.length;
    for [a, b] in [[(x - far).max(0.0), x], [x, (x + far).min(enclosed.length)]].into_iter().filter(|_| tangent) {
        let smooth = enclosed.gap.breaks(a, b).into_iter().filter(|y| !enclosed.gap.is_smooth_at(*y));
        let [left, right] = smooth.fold([a, b], |[a, b], y| if y < x { [a.max(y), b] } else { [a, b.min(y)] });
        let mut bend = 0.0_f64;
        for piece in pieces.iter().filter(|piece| left < piece.to && piece.from < right && !piece.follows) {
            let [from, to] = [piece.from.max(left), piece.to.min(right)];
            let v = piece.v.shifted(Interval::exact(from) - Interval::exact(piece.from));
            for cell in cells(from, to, enclosed.gap.breaks(from, to)) {
                let v = v.shifted(Interval::exact(cell[0]) - Interval::exact(from));
                let clear = enclosed.gap.cell(cell[0], cell[1]).minus(&v).derivative().derivative();
                bend = bend.max(clear.range(Interval::exact(cell[1]) - Interval::exact(cell[0])).hi());
            }
        }
        let off = (Interval::exact(right) - Interval::exact(left)).square() * Interval::exact(bend) / number(2);
        stop(if x < right { right } else { left }, off.hi());
    }
    let [left, right] = found;
    Some(Hold(left?.1, right?.1))
}

/// Both stops as a hold, of a beam that is pressed between them where it is off by `ε` at most. With the clearances `c` at the stops,
/// `a` and `b` away from there, and the deflection that is off by `d ≤ c` at both and by `e` more than a line between them makes it,
///
/// ```text
/// (b d₁ + a d₂)/(a + b) ≥ −ε − e,      −d₁ ≤ ((a + b)(ε + e) + a c₂)/b,      −d₂ ≤ ((a + b)(ε + e) + b c₁)/a
/// ```
fn between_stops(Hold(left, right): Hold, at: &Place, factor: f64) -> Hold {
    let [a, b] = [[left.from, at.from], [at.from, right.from]].map(|[y, z]| Interval::exact(z) - Interval::exact(y));
    let bent = Interval::exact(factor) * Interval::exact(Hold(left, right).lever([at.from; 2]));
    let risen = (a + b) * (Interval::exact(at.off) + bent);
    let off = |own: &Place, [near, far]: [Interval; 2], other: &Place| {
        own.off.max(((risen + near * Interval::exact(other.off)) / far).hi())
    };
    Hold(Place { off: off(&left, [a, b], &right), ..left }, Place { off: off(&right, [b, a], &left), ..right })
}

/// Whether nodes are in order, have all supports among them, end every zone that they start, and follow the ground only where
/// they meet it. Of anything else nothing follows.
fn is_complete(enclosed: &EnclosedScene<'_>, nodes: &[ContactNode]) -> bool {
    let in_order = nodes.windows(2).all(|w| w[0].x < w[1].x) && nodes.last().is_some_and(|node| !node.lies);
    let inside = nodes.iter().all(|node| (0.0..=enclosed.length).contains(&node.x));
    let supports = nodes.iter().filter(|node| enclosed.support(node.x).is_some()).count();
    let meet = nodes.iter().enumerate().all(|(i, node)| {
        let [left, right] = [true, false].map(|left| enclosed.order(node, left) == 2);
        let built_in = enclosed.support(node.x).is_some_and(|s| s.slope.is_some());
        let follows = !built_in && matches!(node.slope, Slope::OfGround { .. });
        (!follows || left || right) && (i == 0 || !nodes[i - 1].lies || left) && (!node.lies || right)
    });
    in_order && inside && supports == enclosed.supports.len() && meet
}

/// `M` beside node `i`, on its left and on its right side, and its jump. Part `i` of the beam is on the left and part `i + 1` on the
/// right. Beside a zone, an overhang and no beam only one moment is possible. Between two spans any is, and where none but
/// the same on both sides is admissible, a number between theirs is taken.
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
        -(Interval::exact(enclosed.stiffness) * curvature)
    });
    let held =
        enclosed.support(node.x).is_some_and(|s| s.slope.is_some() || matches!(node.slope, Slope::OfGround { .. }));
    if held || given == [true; 2] {
        return (own, own[1] - own[0]);
    }
    let continuous = match given {
        [true, _] => own[0],
        [_, true] => own[1],
        _ => Interval::exact(0.5 * (own[0].middle() + own[1].middle())),
    };
    ([continuous; 2], Interval::ZERO)
}

#[cfg(test)]
mod tests;
