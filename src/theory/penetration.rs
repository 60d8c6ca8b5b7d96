//! The deepest penetration of the beam: cell by cell next to a contact, and over many cells of a straight foundation at once farther
//! away. Such a block is clear if the beam is nowhere deeper than its shallowest point.

use std::ops::RangeInclusive;

use super::bernstein::{lowest_below, range};
use super::piece::{NEAR, Piece, derivatives};
use super::piecewise::PiecewiseScene;
use super::span::{EndCondition, Span};

/// Maximum number of cells in a block: beyond it the cost per cell is negligible.
const MOST: usize = 4096;
/// Growth factor of the block after a clear one, and shrinkage factor after one that is not clear.
const MORE: usize = 4;

/// The penetration of each rigid compression-only support under a span that does not rest on it: `(position, depth)`, negative where
/// the beam is clear.
pub(super) fn in_bearings<'a>(
    given: &'a PiecewiseScene,
    pieces: &'a [Piece],
    span: &'a Span,
) -> impl Iterator<Item = (f64, f64)> + 'a {
    let under = |x: f64| {
        let [a, b] = [&span.a, &span.b].map(|end| (end.x, end.hold));
        (a.0 < x || a.1 == EndCondition::Free && a.0 <= x) && (x < b.0 || is_open(b.1) && x <= b.0)
    };
    let first = given.bearings.partition_point(|&i| given.breakpoints[i].x < span.a.x);
    let bearings = given.bearings[first..].iter().map(|&i| &given.breakpoints[i]);
    let bearings = bearings.take_while(|bearing| bearing.x <= span.b.x).filter(move |bearing| under(bearing.x));
    bearings.map(|bearing| {
        let piece = &pieces[pieces.partition_point(|p| p.hi < bearing.x).min(pieces.len() - 1)];
        let part = piece.part_in(given, given.cell_to(bearing.x));
        let mut taylor = vec![0.0; given.terms];
        part.deflection(given, &mut taylor);
        (bearing.x, derivatives(&taylor, bearing.x - part.anchor)[0] - bearing.depth)
    })
}

/// The deepest penetration in a span, if it is deeper than `allowed` at its position: `(position, depth)`.
pub(super) fn deepest(
    given: &PiecewiseScene,
    pieces: &[Piece],
    span: &Span,
    allowed: impl Fn(f64) -> f64,
) -> Option<(f64, f64)> {
    let mut worst: Option<(f64, f64)> = None;
    for (at, depth) in in_bearings(given, pieces, span) {
        if worst.map_or_else(|| allowed(at), |(_, depth)| depth) < depth {
            worst = Some((at, depth));
        }
    }
    if !given.founded {
        return worst;
    }
    let first = pieces.partition_point(|p| p.hi <= span.a.x);
    let mut taylor = vec![0.0; given.terms];
    for piece in pieces[first..].iter().take_while(|p| p.lo < span.b.x) {
        // Next to its anchor the clearance of a piece is more accurate than its deflection.
        by_blocks(given, piece, NEAR + 1, |part| {
            let bar = worst.map_or_else(|| allowed(part.lo), |(_, depth)| depth);
            if 1 < part.count() {
                return is_clear(given, part, bar, &mut taylor);
            }
            worst = in_cell(given, part, span, bar, &mut taylor).or(worst);
            true
        });
    }
    worst
}

/// Visits the cells of a piece from left to right, over a straight foundation in blocks. `look` returns whether a block is finished;
/// otherwise it is called with smaller blocks, down to single cells. The first `near` cells from the anchor are visited one by one.
pub(super) fn by_blocks(given: &PiecewiseScene, piece: &Piece, near: usize, mut look: impl FnMut(&Piece) -> bool) {
    let (all, mut i, mut together) = (piece.count(), 0, 1);
    let cells = |i: usize, count: usize| {
        if piece.is_from_the_left() { [i, i + count - 1] } else { [all - i - count, all - 1 - i] }
    };
    let room = |i: usize| match (given.is_straight(piece.cell), piece.is_from_the_left()) {
        (false, _) => 1,
        (true, true) if i < near => 1,
        (true, true) => all - i,
        (true, false) => (all - i).saturating_sub(near).max(1),
    };
    while i < all {
        let count = together.min(room(i)).max(1);
        let [k, last] = cells(i, count);
        let is_done = look(&piece.part(given, k, last));
        (i, together) = match (is_done, count) {
            (_, 1) => (i + 1, MORE),
            (true, _) => (i + count, MOST.min(MORE * count)),
            (false, _) => (i, count / MORE),
        };
    }
}

/// Whether nothing holds the beam at this end of a span.
fn is_open(hold: EndCondition) -> bool {
    matches!(hold, EndCondition::Free | EndCondition::Within)
}

/// The deepest penetration in one cell and at the edge at its end, if it is deeper than `allowed`.
fn in_cell(given: &PiecewiseScene, part: &Piece, span: &Span, allowed: f64, taylor: &mut [f64]) -> Option<(f64, f64)> {
    part.clearance(given, taylor);
    part.outwards(taylor);
    let inside = lowest_below(taylor, part.width(), -allowed).map(|(s, value)| (part.place(s), -value));
    // At the foot of steps: along them the clearance is a sum of their heights, while at the edge the depth is given.
    let edge = &given.breakpoints[part.cell + 1];
    let before_end = edge.x < span.b.x || span.b.hold == EndCondition::Within;
    let is_inside = edge.x <= part.hi && before_end && given.is_edge(part.cell + 1);
    let is_cliff = || edge.step != 0.0 || edge.depth.abs() <= given.rise(part.cell);
    if !is_inside || given.is_straight(part.cell) && !is_cliff() {
        return inside;
    }
    part.deflection(given, taylor);
    let depth = derivatives(taylor, part.hi - part.anchor)[0] - edge.depth;
    let is_deeper = inside.map_or(allowed, |(_, depth)| depth) < depth;
    if is_deeper { Some((part.hi, depth)) } else { inside }
}

/// Whether the beam is nowhere deeper than `depth` below the shallowest point of the straight foundation below a piece.
pub(super) fn is_clear(given: &PiecewiseScene, piece: &Piece, depth: f64, taylor: &mut [f64]) -> bool {
    let shallowest = given.breakpoints[below(piece)].iter().fold(f64::INFINITY, |least, j| least.min(j.depth));
    beam_range(given, piece, taylor).is_some_and(|[_, most]| most <= shallowest + depth)
}

/// Bounds of the clearance of a piece over a straight foundation, including both sides of a step; [`None`] if a rigid compression-only
/// support is below the piece.
pub(super) fn clearance_range(given: &PiecewiseScene, piece: &Piece, taylor: &mut [f64]) -> Option<[f64; 2]> {
    let below = below(piece);
    let next_bearing = given.bearings[given.bearings.partition_point(|i| i < below.start())..].first();
    if next_bearing.is_some_and(|i| below.contains(i)) {
        return None;
    }
    let [shallowest, deepest] =
        given.breakpoints[below].iter().fold([f64::INFINITY, f64::NEG_INFINITY], |[least, most], j| {
            [least.min(j.depth), most.max(j.depth + j.step.abs())]
        });
    beam_range(given, piece, taylor).map(|[least, most]| [shallowest - most, deepest - least])
}

/// Bounds of the deflection of a piece.
fn beam_range(given: &PiecewiseScene, piece: &Piece, taylor: &mut [f64]) -> Option<[f64; 2]> {
    piece.deflection(given, taylor);
    piece.outwards(taylor);
    range(taylor, piece.width())
}

/// The breakpoints of the cells of a piece.
fn below(piece: &Piece) -> RangeInclusive<usize> {
    let [one, other] = [piece.nth(0), piece.nth(piece.count() - 1)];
    one.min(other)..=one.max(other) + 1
}

#[cfg(test)]
mod tests {
    use super::super::list::List;
    use super::super::piece::pieces_of;
    use super::*;
    use crate::scene::{Beam, Foundation, Load, PointLoad, Scene};

    /// A foundation of `count` points, one of which may be the shallowest, and a beam that may sag onto it.
    fn given(count: u32, at: u32, depth: f64) -> PiecewiseScene {
        let beam = Beam::new(1.0, 1.0).expect("a beam");
        let point = vec![PointLoad { at: 0.7, force: 1.0 }];
        let load = Load::new(&beam, 10.0, Vec::new(), point).expect("a load");
        let rough = |i: u32| 0.01 * f64::from(i * 7919 % 101);
        let points =
            (0..=count).map(|i| [f64::from(i) / f64::from(count), if i == at { depth } else { 0.2 + rough(i) }]);
        let foundation = Foundation::Polyline { points: points.collect() };
        PiecewiseScene::new(&Scene::new(beam, load, Some(foundation)).expect("a scene"))
    }

    /// The beam without contact penetrates at one point or nowhere, for many positions of that point among ten thousand. The result by
    /// blocks equals the result cell by cell.
    #[test]
    fn one_point_among_many_is_found() {
        const COUNT: u32 = 10_000;
        for at in (1..COUNT).step_by(199) {
            let given = given(COUNT, at, 0.05);
            let (_, span) = List::free(&given).spans(&given).remove(0);
            let mut pieces = Vec::new();
            pieces_of(&given, &span, &mut pieces);
            assert!(pieces.len() <= 4, "one for each run and side: {}", pieces.len());
            let mut taylor = vec![0.0; given.terms];
            let mut clearance = |part: Piece| {
                part.clearance(&given, &mut taylor);
                [part.lo, part.hi].map(|x| (x, derivatives(&taylor, x - part.anchor)[0]))
            };
            let parts = pieces.iter().flat_map(|piece| piece.parts(&given)).flat_map(&mut clearance);
            let (place, least) = parts.min_by(|a, b| a.1.total_cmp(&b.1)).expect("a piece");
            let found = deepest(&given, &pieces, &span, |_| 0.0);
            match found {
                Some((x, depth)) => {
                    assert!((x - place).abs() < 1e-12 && (depth + least).abs() < 1e-15, "{at}: {found:?}")
                }
                None => assert!(0.0 <= least, "{at}: {least:e} at {place}"),
            }
        }
    }

    /// The clearance carried over kinks equals the depth minus the deflection.
    #[test]
    fn cells_continue_each_other() {
        for at in 1..200 {
            let given = given(200, at, 0.1);
            let (_, span) = List::free(&given).spans(&given).remove(0);
            let mut pieces = Vec::new();
            pieces_of(&given, &span, &mut pieces);
            for part in pieces.iter().flat_map(|piece| piece.parts(&given)) {
                let mut taylor = vec![0.0; given.terms];
                for x in [part.lo, 0.5 * (part.lo + part.hi), part.hi] {
                    part.clearance(&given, &mut taylor);
                    let clearance = derivatives(&taylor, x - part.anchor)[0];
                    part.deflection(&given, &mut taylor);
                    let deflection = derivatives(&taylor, x - part.anchor)[0];
                    let depth = given.derivative(part.cell, x, 0);
                    assert!((depth - deflection - clearance).abs() < 1e-14, "{at}, at {x}");
                }
            }
        }
    }
}
