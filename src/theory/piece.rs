//! The beam in pieces. Each piece is one polynomial: from a contact over all cells under one line of load to the next contact, or to
//! the middle between the two. In each of its cells the clearance is one polynomial (or nearly so, for a cosine).

use super::list::List;
use super::piecewise::{Cell, PiecewiseScene};
use super::span::{End, EndCondition, Span, difference};
use super::tension::continued;

/// A part of the beam that is one polynomial.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Piece {
    /// Left end.
    pub(super) lo: f64,
    /// Right end.
    pub(super) hi: f64,
    /// The origin of its polynomial: the end that is nearer to the contact or support from which it was computed.
    pub(super) anchor: f64,
    /// The cell at the anchor.
    pub(super) cell: usize,
    /// The cell at its other end.
    far: usize,
    /// The state at the anchor; [`None`] inside a zone, where the beam follows the profile.
    pub(super) state: Option<State>,
}

/// Beam and clearance at a position, with three derivatives.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct State {
    /// `v, v', e v'', e v'''`.
    pub(super) beam: [f64; 4],
    /// `h, h', e h'', e h'''`: next to a contact more accurate than `u − v`.
    pub(super) clearance: [f64; 4],
}

/// Number of breaks of a straight foundation from the anchor of a piece within which cells are examined one by one and slopes count for
/// rounding.
pub(super) const NEAR: usize = 64;

impl Piece {
    /// Taylor coefficients of the clearance `h` at the anchor, in its cell.
    pub(super) fn clearance(&self, given: &PiecewiseScene, out: &mut [f64]) {
        let Some(State { clearance: [h, h1, h2, h3], .. }) = self.state else {
            return out.fill(0.0);
        };
        given.profile(self.cell, self.anchor, out);
        let e = self.stiffness(given);
        if given.tension != 0.0 {
            return self.clearance_under_tension(given, out);
        }
        out[..4].copy_from_slice(&[h, h1, h2 / 2.0 / e, h3 / 6.0 / e]);
        out[4] -= given.load(self.cell, self.anchor) / 24.0 / e;
        out[5] -= given.cells[self.cell].load_slope / 120.0 / e;
    }

    /// The same under an axial force, where `out` already contains the profile: subtracts the deflection from it.
    fn clearance_under_tension(&self, given: &PiecewiseScene, out: &mut [f64]) {
        let Some(State { clearance: [h, h1, h2, h3], .. }) = self.state else { return };
        let (e, mut beam) = (self.stiffness(given), vec![0.0; out.len()]);
        self.deflection(given, &mut beam);
        out.iter_mut().zip(&beam).skip(4).for_each(|(profile, beam)| *profile -= beam);
        out[..4].copy_from_slice(&[h, h1, h2 / 2.0 / e, h3 / 6.0 / e]);
    }

    /// `e` on this piece.
    fn stiffness(&self, given: &PiecewiseScene) -> f64 {
        given.cells[self.cell].stiffness
    }

    /// `v, v', e v'', e v'''` at `t` from the anchor, from the Taylor coefficients of `v`.
    pub(super) fn beam(&self, given: &PiecewiseScene, taylor: &[f64], t: f64) -> [f64; 4] {
        let ([v, v1, v2, v3], e) = (derivatives(taylor, t), self.stiffness(given));
        [v, v1, v2 * e, v3 * e]
    }

    /// Converts the Taylor coefficients of `v` into those of `e v''`.
    pub(super) fn bent<'a>(&self, given: &PiecewiseScene, taylor: &'a mut [f64]) -> &'a mut [f64] {
        let bent = differentiated(differentiated(taylor));
        bent.iter_mut().for_each(|c| *c *= self.stiffness(given));
        bent
    }

    /// `½ e v''²`, the bending energy per length at a curvature.
    pub(super) fn bending_energy(&self, given: &PiecewiseScene, curvature: f64) -> f64 {
        0.5 * curvature * curvature * self.stiffness(given)
    }

    /// Taylor coefficients of the deflection `v` at the anchor.
    pub(super) fn deflection(&self, given: &PiecewiseScene, out: &mut [f64]) {
        let Some(State { beam, .. }) = self.state else {
            return given.profile(self.cell, self.anchor, out);
        };
        out.fill(0.0);
        out[..6].copy_from_slice(&beam_taylor(given, self.cell, self.anchor, &beam));
        if given.tension != 0.0 {
            let load = [given.load(self.cell, self.anchor), given.cells[self.cell].load_slope];
            continued(out, load, self.stiffness(given), given.tension);
        }
    }

    /// The position at the distance `s ≥ 0` from the anchor.
    pub(super) fn place(&self, s: f64) -> f64 {
        if self.is_from_the_left() { self.lo + s } else { self.hi - s }
    }

    /// Its length.
    pub(super) fn width(&self) -> f64 {
        self.hi - self.lo
    }

    /// A part of the beam in one cell, whose polynomial is stored elsewhere.
    pub(super) fn of_part([lo, hi]: [f64; 2], anchor: f64, cell: usize) -> Self {
        Self { lo, hi, anchor, cell, far: cell, state: None }
    }

    /// Converts coefficients in powers of `x − anchor` into powers of the distance from the anchor.
    pub(super) fn outwards(&self, taylor: &mut [f64]) {
        if !self.is_from_the_left() {
            taylor.iter_mut().skip(1).step_by(2).for_each(|c| *c = -*c);
        }
    }

    /// Whether it was computed from its left end.
    pub(super) fn is_from_the_left(&self) -> bool {
        self.anchor <= self.lo
    }

    /// The number of its cells.
    pub(super) fn count(&self) -> usize {
        self.cell.abs_diff(self.far) + 1
    }

    /// The cell number `k`, counted from the anchor.
    pub(super) fn nth(&self, k: usize) -> usize {
        if self.is_from_the_left() { self.cell + k } else { self.cell - k }
    }

    /// Its part in a cell, or in the nearest of its cells.
    pub(super) fn part_in(&self, given: &PiecewiseScene, cell: usize) -> Self {
        let k = if self.is_from_the_left() { cell.saturating_sub(self.cell) } else { self.cell.saturating_sub(cell) };
        let k = k.min(self.count() - 1);
        self.part(given, k, k)
    }

    /// Its parts in single cells, starting at the anchor.
    pub(super) fn parts<'a>(&self, given: &'a PiecewiseScene) -> impl Iterator<Item = Self> + use<'a> {
        let whole = *self;
        (0..whole.count()).map(move |k| whole.part(given, k, k))
    }

    /// Its cells from number `k` to number `last`, with the state at their near end.
    pub(super) fn part(&self, given: &PiecewiseScene, k: usize, last: usize) -> Self {
        let (cell, far, right) = (self.nth(k), self.nth(last), self.is_from_the_left());
        let near_end = |k: usize, cell: usize, end: f64| match (k, right) {
            (0, _) => end,
            (_, true) => given.cells[cell].lo,
            (_, false) => given.cells[cell].hi,
        };
        let far_end = |end: f64| match (far == self.far, right) {
            (true, _) => end,
            (_, true) => given.cells[far].hi,
            (_, false) => given.cells[far].lo,
        };
        let [lo, hi] = if right {
            [near_end(k, cell, self.lo), far_end(self.hi)]
        } else {
            [far_end(self.lo), near_end(k, cell, self.hi)]
        };
        let anchor = if right { lo } else { hi };
        let state = if k == 0 { self.state } else { self.state.map(|state| self.carried(given, &state, k)) };
        Self { lo, hi, anchor, cell, far, state }
    }

    /// The state at the beginning of its cell number `k`, or of the cell behind its last one.
    fn carried(&self, given: &PiecewiseScene, state: &State, k: usize) -> State {
        let right = self.is_from_the_left();
        // The break at which cell `k` begins, seen from the anchor, and the cell.
        let at = |k: usize| if right { self.cell + k } else { self.cell + 1 - k };
        let cell = self.nth(k);
        let x = given.breakpoints[at(k)].x;
        let taylor = beam_taylor(given, self.cell, self.anchor, &state.beam);
        let beam = self.beam(given, &taylor, x - self.anchor);
        State { beam, clearance: difference(&given.derivatives(cell, x), &beam) }
    }

    /// The state behind its far end, where a force may act.
    fn beyond(&self, given: &PiecewiseScene) -> Option<State> {
        let breakpoint = if self.is_from_the_left() { self.far + 1 } else { self.far };
        let sign = if self.is_from_the_left() { 1.0 } else { -1.0 };
        let [couple, force] = given.breakpoints[breakpoint].acts.jumps();
        self.state.map(|state| {
            let mut state = self.carried(given, &state, self.count());
            for (j, jump) in [(3, sign * force), (2, sign * couple)] {
                state.beam[j] += jump;
                state.clearance[j] -= jump;
            }
            state
        })
    }
}

/// The first four derivatives of a polynomial at `t`.
pub(super) fn derivatives(taylor: &[f64], t: f64) -> [f64; 4] {
    let mut work = [0.0; 4];
    // Horner's scheme with its first three derivatives.
    for &c in taylor.iter().rev() {
        work[3] = work[3] * t + work[2];
        work[2] = work[2] * t + work[1];
        work[1] = work[1] * t + work[0];
        work[0] = work[0] * t + c;
    }
    [work[0], work[1], 2.0 * work[2], 6.0 * work[3]]
}

/// Coefficients of the derivative, in place.
pub(super) fn differentiated(c: &mut [f64]) -> &mut [f64] {
    #[expect(clippy::cast_precision_loss, reason = "a degree is a small number")]
    c.iter_mut().enumerate().for_each(|(j, c)| *c *= j as f64);
    c.get_mut(1..).unwrap_or_default()
}

/// Taylor coefficients of a beam under the load of `cell` at `x`.
fn beam_taylor(given: &PiecewiseScene, cell: usize, x: f64, [v, v1, v2, v3]: &[f64; 4]) -> [f64; 6] {
    let Cell { stiffness: e, load_slope, .. } = given.cells[cell];
    [*v, *v1, v2 / 2.0 / e, v3 / 6.0 / e, given.load(cell, x) / 24.0 / e, load_slope / 120.0 / e]
}

/// The position where the pieces computed from the two ends of a span meet: midspan, or a load very close to one end. Nearly all of
/// such a load goes into that end. The rest of the shear force beyond it, a difference of nearly equal numbers there, is computed from
/// the other end.
fn meeting(given: &PiecewiseScene, span: &Span) -> f64 {
    /// Share of the span: at this distance six digits of the shear force would be lost. The rest of the load beyond it falls with the
    /// distance from an end that is free to rotate.
    const BESIDE: f64 = 1e-6;
    /// The same from an end that is not free to rotate: the rest falls with the square of the distance.
    const BESIDE_HELD: f64 = 1e-3;
    let (a, b) = (&span.a, &span.b);
    let [near_a, near_b] = [a, b].map(|end| {
        let held = matches!(end.hold, EndCondition::Edge { .. });
        span.length() * if held { BESIDE_HELD } else { BESIDE }
    });
    let loaded = |end: &End, i: &usize| end.hold != EndCondition::Free && given.load_changes_at(*i);
    let left = given.breakpoints_inside(a.x, a.x + near_a).rfind(|i| loaded(a, i));
    let right = given.breakpoints_inside(b.x - near_b, b.x).find(|i| loaded(b, i));
    match (left, right) {
        (Some(i), None) | (None, Some(i)) => given.breakpoints[i].x,
        // Next to both ends: at the larger load.
        (Some(i), Some(j)) => {
            let largest = |from: f64, to: f64| {
                let inside = given.breakpoints_inside(from, to);
                inside.fold(0.0, |most: f64, i| most.max(given.breakpoints[i].acts.force().abs()))
            };
            let is_left = largest(b.x - near_b, b.x) < largest(a.x, a.x + near_a);
            given.breakpoints[if is_left { i } else { j }].x
        }
        (None, None) => 0.5 * (a.x + b.x),
    }
}

/// The pieces of a span from left to right, computed from both ends up to their meeting position.
pub(super) fn pieces_of(given: &PiecewiseScene, span: &Span, out: &mut Vec<Piece>) {
    let middle = meeting(given, span);
    // The cells at the meeting position: two if it is a break.
    let inside = &given.breakpoints[span.a.cell + 1..(span.b.cell + 1).max(span.a.cell + 1)];
    let [left, right] =
        [inside.partition_point(|j| j.x < middle), inside.partition_point(|j| j.x <= middle)].map(|i| span.a.cell + i);
    let right = right.min(span.b.cell);
    let mut state = Some(State { beam: span.beam_a, clearance: span.at_a });
    let mut lo = span.a.x;
    for [cell, far] in given.runs(span.a.cell, left) {
        let hi = if far == left { middle } else { given.cells[far].hi };
        let piece = Piece { lo, hi, anchor: lo, cell, far, state };
        out.push(piece);
        if far < left {
            (state, lo) = (piece.beyond(given), hi);
        }
    }
    let meeting = out.len();
    let mut state = Some(State { beam: span.beam_b, clearance: span.at_b });
    let mut hi = span.b.x;
    for [far, cell] in given.runs(right, span.b.cell).rev() {
        let lo = if far == right { middle } else { given.cells[far].lo };
        let piece = Piece { lo, hi, anchor: hi, cell, far, state };
        out.push(piece);
        if right < far {
            (state, hi) = (piece.beyond(given), lo);
        }
    }
    out[meeting..].reverse();
}

/// The pieces of the beam, from end to end.
pub(super) fn all_pieces(given: &PiecewiseScene, list: &List, spans: &[(usize, Span)]) -> Vec<Piece> {
    let mut pieces = Vec::with_capacity(2 * spans.len());
    let (mut next_span, mut next_zone) = (spans.iter().peekable(), list.zones());
    for i in 0..=list.nodes.len() {
        if list.in_zone_before(i) {
            if let Some(zone) = next_zone.next() {
                pieces_of_zone(given, zone.from, zone.to, &mut pieces);
            }
        } else {
            while let Some((_, span)) = next_span.next_if(|(before, _)| *before == i) {
                pieces_of(given, span, &mut pieces);
            }
        }
    }
    if pieces.is_empty() {
        // There are only zones that end before they start.
        pieces_of_zone(given, 0.0, given.length, &mut pieces);
    }
    pieces
}

/// The pieces of a zone, in which the beam follows the profile.
pub(super) fn pieces_of_zone(given: &PiecewiseScene, from: f64, to: f64, out: &mut Vec<Piece>) {
    for cell in given.cell_from(from)..=given.cell_to(to) {
        let (lo, hi) = (given.cells[cell].lo.max(from), given.cells[cell].hi.min(to));
        if lo < hi {
            out.push(Piece { lo, hi, anchor: lo, cell, far: cell, state: None });
        }
    }
}
