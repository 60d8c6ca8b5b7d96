//! The restraints of a beam, which also carry the tension that is cut off from its contact load: two of its supports, positions with
//! contact force, or the foundation next to a single position that carries the beam.

use super::contact_node::{ContactNode, EnclosedScene};
use super::distance::factor;
use super::interval::Interval;
use super::lines::lines;
use super::load::cells;
use super::polynomial::number;
use super::pressing::PullCutOff;
use super::proof::{Pair, Piece};
use super::reference::{Datum, Line};

/// A datum with the uncertainty of the deflection there; [`None`] if the tension that is cut off uses up its contact force.
pub(super) fn known(place: Datum, gap: f64, share: Interval) -> Option<Datum> {
    if place.presses.is_infinite() {
        return Some(place);
    }
    let remains = (Interval::exact(place.presses) - share).lo();
    if place.energy.is_finite() {
        // A compression-only elastic support that is pressed acts as a spring.
        return (0.0 < remains && gap < place.energy).then_some(place);
    }
    let spread = Interval::exact(place.spread);
    let off = place.uncertainty.max((spread * Interval::exact(gap) / Interval::exact(remains)).hi());
    (0.0 < remains).then_some(Datum { uncertainty: off, ..place })
}

/// Finds the restraints of a beam: its supports; if these are not enough, two of the positions that carry it, or one of them and the
/// positions where the foundation stops the beam. The gap follows from the moments and the share of the tension that is cut off, and from
/// the distance between the foundation and the positions that carry the share. Returns the gap, this share and the reference lines.
pub(super) fn held_by(
    enclosed: &EnclosedScene<'_>,
    turns_about: Option<f64>,
    carriers: &mut [Datum],
    pieces: &[Piece],
    cut_off: &PullCutOff,
    gap_of: impl Fn([Interval; 2], f64) -> f64,
) -> Option<(f64, Interval, Vec<Line>)> {
    // About a position of balance, each part between hinges can rotate separately.
    if turns_about.is_some() && enclosed.is_hinged() {
        return None;
    }
    let fixed = enclosed.supports.iter().filter(|s| s.is_fixed).map(|s| s.x);
    let lines = lines(enclosed, fixed.chain(turns_about), carriers);
    if !lines.is_empty() {
        let carried = cut_off.carried(&lines, enclosed.stiffness, enclosed.soft());
        let gap = gap_of(carried, 0.0);
        let both = |Line(a, b)| Some(Line(known(a, gap, carried[1])?, known(b, gap, carried[1])?));
        // A line through a datum that is used up is not valid.
        if let Some(lines) = lines.into_iter().map(both).collect() {
            return Some((gap, carried[1], lines));
        }
    }
    if 0.0 < enclosed.tension {
        // Under tension the beam is restrained as a string by one position, which carries nothing of what is cut off.
        let carried = cut_off.carried(&[], enclosed.stiffness, enclosed.soft());
        return Some((gap_of(carried, 0.0), carried[1], Vec::new()));
    }
    // Beams with hinges are excluded: a hinge could rotate next to the one position that carries the beam.
    let place = *carriers.iter().find(|place| place.to <= place.from && !enclosed.is_hinged())?;
    let couples: f64 = cut_off.pulls.iter().map(|pull| pull.2).sum();
    let stops = stops(enclosed, pieces, place.from, 16.0 * (couples / place.presses))?;
    // A couple is carried by the stop towards which it rotates the beam, so both stops count.
    let lines = [Line(Datum::at(stops.0.from), place), Line(place, Datum::at(stops.1.from))];
    let both = lines.map(|line| cut_off.carried(&[line], enclosed.stiffness, enclosed.soft()));
    let carried = [0, 1].map(|k| both[0][k] + both[1][k]);
    let gap = gap_of(carried, stops.0.uncertainty.max(stops.1.uncertainty));
    Some((
        gap,
        carried[1],
        vec![between_stops(stops, known(place, gap, carried[1])?, factor(gap, enclosed.stiffness), enclosed.soft())],
    ))
}

/// The positions that carry the beam: single nodes, parts of zones, and point loads inside zones. A force taken from a part is
/// distributed in proportion to the pressure there. Its effect is the mean over single positions, and the worst position is counted.
pub(super) fn carriers(enclosed: &EnclosedScene<'_>, nodes: &[ContactNode], forces: &[Interval]) -> Vec<Datum> {
    let carried = |(x, force): (f64, Interval)| match enclosed.support(x) {
        Some(support) => enclosed.datum(support, force),
        None => Datum { presses: force.lo(), ..Datum::at(x) },
    };
    let mut carriers: Vec<Datum> = nodes.iter().map(|node| node.x).zip(forces.iter().copied()).map(carried).collect();
    // Two supports hold the beam without its zones, unless there are hinges.
    let is_held = 2 <= enclosed.holding().count() && !enclosed.is_hinged();
    for (from, to) in nodes.windows(2).filter(|w| w[0].lies && !is_held).map(|w| (w[0].x, w[1].x)) {
        let breaks = enclosed.breaks(from, to);
        carriers.extend(breaks.iter().map(|&x| carried((x, enclosed.load.point(x)))));
        carriers.extend(cells(from, to, breaks).into_iter().flat_map(|cell| every_other(enclosed, cell, 3)));
    }
    carriers.into_iter().filter(|place| 0.0 < place.presses).collect()
}

/// The first, third, fifth … of some equal parts of a zone, where they contain no break of the load, each with a lower bound of the
/// contact force on it: the load plus the change of the shear force of the beam that follows the foundation.
fn every_other(enclosed: &EnclosedScene<'_>, [from, to]: [f64; 2], parts: u32) -> Vec<Datum> {
    let end = |k: u32| if k < parts { from + (to - from) * (f64::from(k) / f64::from(parts)) } else { to };
    let pressed = |k: u32| {
        let [from, to] = [end(k), end(k + 1)];
        let [start, end] = [(from, false), (to, true)].map(|(x, left)| enclosed.gap.jet(x, left));
        let load = [from, to].map(|x| enclosed.load.line(x, [from, to])[0] * Interval::length(from, to) / number(2));
        let stiffness = Interval::exact(enclosed.stiffness_between([from, to]));
        let presses = stiffness * (start[3] - end[3]) + load[0] + load[1];
        let pulled = || Interval::exact(enclosed.tension) * (end[1] - start[1]);
        let presses = if enclosed.tension == 0.0 { presses } else { presses + pulled() }.lo();
        (from < to && enclosed.breaks(from, to).is_empty()).then_some(Datum { to, presses, ..Datum::at(from) })
    };
    (0..parts).step_by(2).filter_map(pressed).collect()
}

/// Adds reference lines through zones to a beam that its supports hold, because zones are nearer. Every second part of each zone forms a
/// line with the next part and with the supports on both sides. The supports carry what is cut off, and the contact force in a zone is
/// never smaller than without it.
pub(crate) fn hold_by_zones(enclosed: &EnclosedScene<'_>, nodes: &[ContactNode], pair: &mut Pair) {
    /// Limit for all zones together: the cost of an error bound is proportional to it.
    const MOST_PARTS: u32 = 256;
    let zones: Vec<[f64; 2]> = nodes.windows(2).filter(|w| w[0].lies).map(|w| [w[0].x, w[1].x]).collect();
    let parts = u32::try_from(zones.len()).ok().and_then(|zones| MOST_PARTS.checked_div(zones)).unwrap_or(0);
    if parts < 3 || enclosed.is_hinged() || pair.lines.iter().any(|line| line.presses().is_finite()) {
        return;
    }
    let pressed = zones.into_iter().flat_map(|zone| every_other(enclosed, zone, parts));
    let held = pressed.filter_map(|place| known(place, pair.gap, Interval::ZERO));
    let mut places: Vec<Datum> = held.chain(enclosed.holding()).collect();
    places.sort_by(|a, b| a.from.total_cmp(&b.from));
    let lines = places.windows(2).map(|w| Line(w[0], w[1]));
    pair.zones = lines.filter(|line| line.0.to < line.1.from && line.presses().is_finite()).collect();
}

/// The positions on the left and on the right of the single position that carries a beam at which the foundation stops a rotation of the
/// beam: those that need the smallest angle, each with the clearance there, and none nearer than half of `apart`. Inside a beam on a
/// smooth foundation the beam is tangent to the foundation at that position: clearance and slope of the clearance are known to be zero
/// there.
fn stops(enclosed: &EnclosedScene<'_>, pieces: &[Piece], x: f64, apart: f64) -> Option<Line> {
    /// As a share of the length of the beam.
    const NEAR: f64 = 1.0 / 274_877_906_944.0;
    let EnclosedScene { gap, length, .. } = *enclosed;
    let is_tangent = enclosed.supports.is_empty() && gap.is_smooth_at(x) && 0.0 < x && x < length;
    let far = apart.max(NEAR * length);
    let mut found = Vec::new();
    for Piece { from, to, v, pressed } in pieces {
        // Over a smooth break an enclosure is wider, but still valid.
        let breaks = gap.breaks(*from, *to).into_iter().filter(|y| far <= (y - x).abs() || !gap.is_smooth_at(*y));
        for [a, b] in cells(*from, *to, breaks.chain([x - far, x + far]).collect()) {
            let [near, far] = if a < x { [b, a] } else { [a, b] };
            let clear = gap.about(near, [a, b]).minus(&v.shifted(Interval::length(*from, near)));
            let clear = if is_tangent && (near - x).abs() <= 0.0 { clear.known(&[Interval::ZERO; 2]) } else { clear };
            // At a step or a support, the depth at the end of the cell may be smaller than the limit from inside the cell.
            let alone = (gap.depth(far) - v.at(Interval::length(*from, far))).hi();
            let off = clear.at(Interval::length(near, far)).hi().min(alone).max(0.0);
            found.push(Datum { uncertainty: if *pressed { 0.0 } else { off }, ..Datum::at(far) });
        }
    }
    let distance = |place: &Datum| (place.from - x).abs();
    let angle = |place: &Datum| place.uncertainty / distance(place);
    let is_off = |place: &&Datum| 0.0 < distance(place) && 0.5 * apart <= distance(place);
    let [left, right] = [true, false].map(|left| {
        let beside = found.iter().filter(is_off).filter(|place| (place.from < x) == left);
        // For equal angles, the farthest.
        beside.min_by(|a, b| angle(a).total_cmp(&angle(b)).then(distance(b).total_cmp(&distance(a))))
    });
    Some(Line(*left?, *right?))
}

/// Both stops as a reference line, for a beam that is pressed at a position between them, with an error of at most `ε` there. The
/// clearances at the stops are `c`, and the stops are at distances `a` and `b` from the position. The deflection is wrong by `d ≤ c` at
/// both stops, and differs by at most `e` from a line between them:
///
/// ```text
/// (b d₁ + a d₂)/(a + b) ≥ −ε − e,      −d₁ ≤ ((a + b)(ε + e) + a c₂)/b,      −d₂ ≤ ((a + b)(ε + e) + b c₁)/a
/// ```
fn between_stops(Line(left, right): Line, at: Datum, factor: f64, soft: f64) -> Line {
    let [a, b] = [Interval::length(left.from, at.from), Interval::length(at.from, right.from)];
    let bent = Interval::exact(factor) * Interval::exact(Line(left, right).lever([at.from; 2], soft));
    let risen = (a + b) * (Interval::exact(at.uncertainty) + bent);
    let known = |own: Datum, [near, far]: [Interval; 2], other: Datum| Datum {
        uncertainty: own.uncertainty.max(((risen + near * Interval::exact(other.uncertainty)) / far).hi()),
        ..own
    };
    Line(known(left, [a, b], right), known(right, [b, a], left))
}

#[cfg(test)]
mod tests;
