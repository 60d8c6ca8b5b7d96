//! A part of the beam on ground that gives: its polynomials.

use crate::theory::piece::{Piece, derivatives};

/// A part of the beam with its polynomials about the anchor of its piece.
#[derive(Debug, Clone)]
pub(in crate::theory) struct Part {
    pub(in crate::theory) piece: Piece,
    /// Whether the springs press on it.
    pub(in crate::theory) pressed: bool,
    /// Taylor coefficients of `v`.
    pub(in crate::theory) deflection: Vec<f64>,
    /// Taylor coefficients of `w = v − g`.
    pub(in crate::theory) penetration: Vec<f64>,
}

impl Part {
    /// `v, v', v'', v'''` at a place of it.
    pub(in crate::theory) fn beam(&self, x: f64) -> [f64; 4] {
        derivatives(&self.deflection, x - self.piece.anchor)
    }

    /// `w, w', w'', w'''` at a place of it.
    pub(in crate::theory) fn sunk(&self, x: f64) -> [f64; 4] {
        derivatives(&self.penetration, x - self.piece.anchor)
    }
}
