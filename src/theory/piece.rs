//! The beam by pieces: over each part of a cell it is one polynomial, and so is (or nearly so, for a cosine) the clearance.

use super::given::Given;
use super::span::Span;

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
    /// `h, h', h'', h'''` at the anchor; [`None`] inside a zone, where the beam is the profile.
    pub(super) clearance: Option<[f64; 4]>,
}

impl Piece {
    /// Taylor coefficients of the clearance `h` at the anchor.
    pub(super) fn clearance(&self, given: &Given, out: &mut [f64]) {
        let Some([h, h1, h2, h3]) = self.clearance else {
            return out.fill(0.0);
        };
        given.profile(self.cell, self.anchor, out);
        out[..4].copy_from_slice(&[h, h1, h2 / 2.0, h3 / 6.0]);
        out[4] -= given.load(self.cell, self.anchor) / 24.0;
        out[5] -= given.cells[self.cell].load_slope / 120.0;
    }

    /// Taylor coefficients of the deflection `v` at the anchor.
    pub(super) fn deflection(&self, given: &Given, out: &mut [f64]) {
        given.profile(self.cell, self.anchor, out);
        if let Some([h, h1, h2, h3]) = self.clearance {
            out[0] -= h;
            out[1] -= h1;
            out[2] -= h2 / 2.0;
            out[3] -= h3 / 6.0;
            out[4] = given.load(self.cell, self.anchor) / 24.0;
            out[5] = given.cells[self.cell].load_slope / 120.0;
            out[6..].fill(0.0);
        }
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

/// The pieces of a span, from left to right: computed from both ends up to its middle.
pub(super) fn pieces_of(given: &Given, span: &Span, out: &mut Vec<Piece>) {
    let middle = 0.5 * (span.a.x + span.b.x);
    let mut taylor = vec![0.0; given.terms];
    let mut state = span.at_a;
    let mut cell = span.a.cell;
    let mut from = span.a.x;
    loop {
        let end = given.cells[cell].hi;
        let last = middle <= end || span.b.cell <= cell;
        let to = if last { middle } else { end };
        let piece = Piece { lo: from, hi: to, anchor: from, cell, clearance: Some(state) };
        out.push(piece);
        if last {
            break;
        }
        piece.clearance(given, &mut taylor);
        state = derivatives(&taylor, to - from);
        cell += 1;
        let joint = &given.joints[cell];
        state[0] += joint.step;
        state[1] += joint.kink;
        state[3] -= joint.force;
        from = to;
    }
    let meeting = out.len();
    let mut state = span.at_b;
    let mut right = span.b.cell;
    let mut to = span.b.x;
    loop {
        let start = given.cells[right].lo;
        let last = right <= cell || start <= middle;
        let from = if last { middle } else { start };
        let piece = Piece { lo: from, hi: to, anchor: to, cell: right, clearance: Some(state) };
        out.push(piece);
        if last {
            break;
        }
        piece.clearance(given, &mut taylor);
        state = derivatives(&taylor, from - to);
        let joint = &given.joints[right];
        state[0] -= joint.step;
        state[1] -= joint.kink;
        state[3] += joint.force;
        right -= 1;
        to = from;
    }
    out[meeting..].reverse();
}

/// The pieces of a zone, in which the beam is the profile.
pub(super) fn pieces_of_zone(given: &Given, from: f64, to: f64, out: &mut Vec<Piece>) {
    for cell in given.cell_from(from)..=given.cell_to(to) {
        let (lo, hi) = (given.cells[cell].lo.max(from), given.cells[cell].hi.min(to));
        if lo < hi {
            out.push(Piece { lo, hi, anchor: lo, cell, clearance: None });
        }
    }
}
