//! Ground that gives: unilateral springs, `p = k (v − g)` where the beam is pressed into the ground and nothing elsewhere.
//!
//! There is no list of contacts. `J` is convex with a continuous derivative, and its minimum is found by Newton's method in the space
//! of deflections, each step of which is a linear problem (`links`, `chain`):
//!
//! ```text
//! S ← whole beam;    v ← the beam on springs that press on S,  S ← { v > g },    until S stays
//! ```
//!
//! from stretches that are known to be near (`search`), of a scene beside this one or of fewer readings (`coarse`), or else first for soft
//! ground, then for stiffer and stiffer ground up to the given. Which supports that only push press is found around that (`bearings`).
//! `answer` is what is read off the polynomials, and `change` how that changes with the numbers of the scene.

mod answer;
mod bearings;
mod chain;
mod change;
mod coarse;
mod join;
mod links;
mod pulled;
mod search;
mod solved;

pub(super) use self::answer::{Springs, exact};
use self::search::{Work, search};
use super::piece::{Piece, derivatives};
use super::piecewise::{Cell, PiecewiseScene};

/// A part of the beam with its polynomials about the anchor of its piece.
#[derive(Debug, Clone)]
pub(in crate::theory) struct Part {
    pub(in crate::theory) piece: Piece,
    /// Whether the springs press on it.
    pub(in crate::theory) pressed: bool,
    /// How stiff they are over the stiffest; zero where there are none.
    pub(in crate::theory) ground: f64,
    /// `e`.
    pub(in crate::theory) stiffness: f64,
    /// Taylor coefficients of `v`.
    pub(in crate::theory) deflection: Vec<f64>,
    /// Taylor coefficients of `w = v − g`.
    pub(in crate::theory) penetration: Vec<f64>,
}

impl Part {
    fn new(given: &PiecewiseScene, piece: Piece, pressed: bool, [deflection, penetration]: [Vec<f64>; 2]) -> Self {
        let Cell { ground, stiffness, .. } = given.cells[piece.cell];
        Self { piece, pressed, ground, stiffness, deflection, penetration }
    }

    /// `v, v', e v'', e v'''` at a place of it.
    pub(in crate::theory) fn beam(&self, x: f64) -> [f64; 4] {
        let [v, v1, v2, v3] = derivatives(&self.deflection, x - self.piece.anchor);
        [v, v1, v2 * self.stiffness, v3 * self.stiffness]
    }

    /// `w, w', w'', w'''` at a place of it.
    pub(in crate::theory) fn sunk(&self, x: f64) -> [f64; 4] {
        derivatives(&self.penetration, x - self.piece.anchor)
    }
}

/// The part at `x`, of two the left or the right one.
fn part_at(parts: &[Part], x: f64, right: bool) -> &Part {
    let i = parts.partition_point(|part| if right { part.piece.hi <= x } else { part.piece.hi < x });
    &parts[i.min(parts.len() - 1)]
}

/// `v, v', e v'', e v'''` before a place between two parts and behind it, zero where there is no beam.
fn beside(parts: &[Part], x: f64) -> [[f64; 4]; 2] {
    let i = parts.partition_point(|part| part.piece.lo < x);
    [i.checked_sub(1), Some(i)].map(|i| i.and_then(|i| parts.get(i)).map_or([0.0; 4], |part| part.beam(x)))
}

/// The stretches that press, and the beam on them.
#[derive(Debug)]
struct StretchSet {
    parts: Vec<Part>,
    /// From left to right.
    stretches: Vec<[f64; 2]>,
    solves: usize,
    /// Whether the set stays.
    settled: bool,
}

/// A penetration below this share of the largest one has no sign of its own: what is so near stays on the side on which it is.
const ROUNDING: f64 = 1e-13;

/// The largest penetration of a beam.
fn deepest(parts: &[Part]) -> f64 {
    let inside = |part: &Part| {
        let (lo, hi) = (part.piece.lo, part.piece.hi);
        [lo, 0.5 * (lo + hi), hi].map(|x| part.sunk(x)[0].abs()).into_iter().fold(0.0, f64::max)
    };
    parts.iter().filter(|part| part.pressed).map(inside).fold(0.0, f64::max)
}
