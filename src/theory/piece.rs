//! The beam by pieces: over each part of a cell it is one polynomial, and so is (or nearly so, for a cosine) the clearance.

use super::piecewise::PiecewiseScene;
use super::span::{End, Hold, Span, difference};

/// A part of a cell over which the beam is one polynomial.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Piece {
    /// Left end.
    pub(super) lo: f64,
    /// Right end.
    pub(super) hi: f64,
    /// Where its polynomial starts: the end that is nearer to the contact, or support, from which it was computed.
    pub(super) anchor: f64,
    /// The cell.
    pub(super) cell: usize,
    /// What is known at the anchor; [`None`] inside a zone, where the beam is the profile.
    pub(super) state: Option<State>,
}

/// Beam and clearance at a place, with three derivatives.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct State {
    /// `v, v', v'', v'''`.
    pub(super) beam: [f64; 4],
    /// `h, h', h'', h'''`: beside a contact more accurate than `u − v`.
    pub(super) clearance: [f64; 4],
}

impl Piece {
    /// Taylor coefficients of the clearance `h` at the anchor.
    pub(super) fn clearance(&self, given: &PiecewiseScene, out: &mut [f64]) {
        let Some(State { clearance: [h, h1, h2, h3], .. }) = self.state else {
            return out.fill(0.0);
        };
        given.profile(self.cell, self.anchor, out);
        out[..4].copy_from_slice(&[h, h1, h2 / 2.0, h3 / 6.0]);
        out[4] -= given.load(self.cell, self.anchor) / 24.0;
        out[5] -= given.cells[self.cell].load_slope / 120.0;
    }

    /// Taylor coefficients of the deflection `v` at the anchor.
    pub(super) fn deflection(&self, given: &PiecewiseScene, out: &mut [f64]) {
        let Some(State { beam, .. }) = self.state else {
            return given.profile(self.cell, self.anchor, out);
        };
        out.fill(0.0);
        out[..6].copy_from_slice(&beam_taylor(given, self.cell, self.anchor, &beam));
    }

    /// A place `s ≥ 0` away from the anchor.
    pub(super) fn place(&self, s: f64) -> f64 {
        if self.anchor <= self.lo { self.lo + s } else { self.hi - s }
    }

    /// Its length.
    pub(super) fn width(&self) -> f64 {
        self.hi - self.lo
    }

    /// Turns coefficients in powers of `x − anchor` into powers of the distance from the anchor.
    pub(super) fn outwards(&self, taylor: &mut [f64]) {
        if self.lo < self.anchor {
            taylor.iter_mut().skip(1).step_by(2).for_each(|c| *c = -*c);
        }
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

/// Taylor coefficients of a beam under the load of `cell` at `x`.
fn beam_taylor(given: &PiecewiseScene, cell: usize, x: f64, [v, v1, v2, v3]: &[f64; 4]) -> [f64; 6] {
    [*v, *v1, v2 / 2.0, v3 / 6.0, given.load(cell, x) / 24.0, given.cells[cell].load_slope / 120.0]
}

/// Where the pieces meet that are computed from the two ends of a span: in its middle, or at a load that stands right beside one
/// end. Nearly all of such a load goes into that end, and what is left of the shear force beyond it, a difference of nearly equal
/// numbers there, is known from the other end.
fn meeting(given: &PiecewiseScene, span: &Span) -> f64 {
    /// Share of the span; at this distance six of the digits of the shear force would be lost.
    const BESIDE: f64 = 1e-6;
    let (a, b, near) = (&span.a, &span.b, BESIDE * span.length());
    let loaded = |end: &End, i: &usize| end.hold != Hold::Free && given.load_changes_at(*i);
    let left = given.breakpoints_inside(a.x, a.x + near).rfind(|i| loaded(a, i));
    let right = given.breakpoints_inside(b.x - near, b.x).find(|i| loaded(b, i));
    match (left, right) {
        (Some(i), None) | (None, Some(i)) => given.breakpoints[i].x,
        _ => 0.5 * (a.x + b.x),
    }
}

/// The pieces of a span, from left to right: computed from both ends up to where they meet.
pub(super) fn pieces_of(given: &PiecewiseScene, span: &Span, out: &mut Vec<Piece>) {
    let middle = meeting(given, span);
    let mut state = State { beam: span.beam_a, clearance: span.at_a };
    let mut cell = span.a.cell;
    let mut from = span.a.x;
    loop {
        let end = given.cells[cell].hi;
        let last = middle <= end || span.b.cell <= cell;
        let to = if last { middle } else { end };
        out.push(Piece { lo: from, hi: to, anchor: from, cell, state: Some(state) });
        if last {
            break;
        }
        state = carried(given, &state, [from, to], [cell, cell + 1], given.breakpoints[cell + 1].force);
        cell += 1;
        from = to;
    }
    let meeting = out.len();
    let mut state = State { beam: span.beam_b, clearance: span.at_b };
    let mut right = span.b.cell;
    let mut to = span.b.x;
    loop {
        let start = given.cells[right].lo;
        let last = right <= cell || start <= middle;
        let from = if last { middle } else { start };
        out.push(Piece { lo: from, hi: to, anchor: to, cell: right, state: Some(state) });
        if last {
            break;
        }
        state = carried(given, &state, [to, from], [right, right - 1], -given.breakpoints[right].force);
        right -= 1;
        to = from;
    }
    out[meeting..].reverse();
}

/// The state carried on through a cell to its other end, and over the breakpoint there into the next cell; `v'''` jumps by the
/// load on the breakpoint.
fn carried(given: &PiecewiseScene, state: &State, [from, to]: [f64; 2], [cell, next]: [usize; 2], jump: f64) -> State {
    let mut beam = derivatives(&beam_taylor(given, cell, from, &state.beam), to - from);
    beam[3] += jump;
    State { beam, clearance: difference(&given.derivatives(next, to), &beam) }
}

/// The pieces of a zone, in which the beam is the profile.
pub(super) fn pieces_of_zone(given: &PiecewiseScene, from: f64, to: f64, out: &mut Vec<Piece>) {
    for cell in given.cell_from(from)..=given.cell_to(to) {
        let (lo, hi) = (given.cells[cell].lo.max(from), given.cells[cell].hi.min(to));
        if lo < hi {
            out.push(Piece { lo, hi, anchor: lo, cell, state: None });
        }
    }
}
