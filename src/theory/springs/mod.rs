//! Elastic foundation: unilateral springs, `p = k (v − g)` where the beam is pressed into the foundation and zero elsewhere.
//!
//! There is no contact list. `J` is convex with a continuous derivative. Newton's method in the space of deflections finds its minimum;
//! each step is a linear problem (`links`, `chain`):
//!
//! ```text
//! S ← whole beam;    v ← the beam on springs that press on S,  S ← { v > g },    until S stays
//! ```
//!
//! The search (`search`) starts from stretches that are known to be near, of a neighbouring scene or of fewer readings (`coarse`).
//! Otherwise it starts with a soft foundation and raises the stiffness step by step to the given one. An outer loop finds the pressed
//! compression-only supports (`bearings`). `answer` evaluates the polynomials, and `change` their derivatives with respect to the
//! numbers of the scene.

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
    /// Stiffness of the springs over the greatest stiffness; zero where there are none.
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

    /// `v, v', e v'', e v'''` at a position in it.
    pub(in crate::theory) fn beam(&self, x: f64) -> [f64; 4] {
        let [v, v1, v2, v3] = derivatives(&self.deflection, x - self.piece.anchor);
        [v, v1, v2 * self.stiffness, v3 * self.stiffness]
    }

    /// `w, w', w'', w'''` at a position in it.
    pub(in crate::theory) fn sunk(&self, x: f64) -> [f64; 4] {
        derivatives(&self.penetration, x - self.piece.anchor)
    }
}

/// The part at `x`, at a boundary the left or the right one.
fn part_at(parts: &[Part], x: f64, right: bool) -> &Part {
    let i = parts.partition_point(|part| if right { part.piece.hi <= x } else { part.piece.hi < x });
    &parts[i.min(parts.len() - 1)]
}

/// `v, v', e v'', e v'''` just left and just right of a boundary between two parts, zero where there is no beam.
fn beside(parts: &[Part], x: f64) -> [[f64; 4]; 2] {
    let i = parts.partition_point(|part| part.piece.lo < x);
    [i.checked_sub(1), Some(i)].map(|i| i.and_then(|i| parts.get(i)).map_or([0.0; 4], |part| part.beam(x)))
}

/// The pressed stretches, and the beam on them.
#[derive(Debug)]
struct StretchSet {
    parts: Vec<Part>,
    /// From left to right.
    stretches: Vec<[f64; 2]>,
    solves: usize,
    /// Whether the set no longer changes.
    settled: bool,
}

/// A penetration below this share of the largest one has no reliable sign: it does not move a position to the other side.
const ROUNDING: f64 = 1e-13;

/// The largest penetration of a beam.
fn deepest(parts: &[Part]) -> f64 {
    let inside = |part: &Part| {
        let (lo, hi) = (part.piece.lo, part.piece.hi);
        [lo, 0.5 * (lo + hi), hi].map(|x| part.sunk(x)[0].abs()).into_iter().fold(0.0, f64::max)
    };
    parts.iter().filter(|part| part.pressed).map(inside).fold(0.0, f64::max)
}
