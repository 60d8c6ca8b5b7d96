//! Deflections by pieces, and the integrals over them.

use super::load::Pieces;
use super::polynomial::Polynomial;
use crate::certificate::interval::Interval;

/// A deflection on a part of the beam.
#[derive(Debug, Clone)]
pub(super) struct Piece {
    pub(super) from: f64,
    pub(super) to: f64,
    /// `v(from + s)`.
    pub(super) v: Polynomial,
    /// True where it is the foundation itself, exactly.
    pub(super) follows: bool,
}

/// A deflection: its value and its slope are continuous, and it vanishes at both ends. Pieces end where the load changes its
/// formula and at point loads.
#[derive(Debug, Clone, Default)]
pub(super) struct Curve {
    pub(super) pieces: Vec<Piece>,
}

impl Curve {
    /// `J(v) = ½∫EI v''² dx − ∫q v dx − Σ P v`, (17) with point loads.
    pub(super) fn energy(&self, load: &Pieces, stiffness: f64) -> Interval {
        let mut sum = Interval::ZERO;
        // Every piece ends where the load changes.
        for Piece { from, to, v, .. } in &self.pieces {
            let width = Interval::exact(*to) - Interval::exact(*from);
            let bending = v.derivative().derivative().integral_of_square(width) * Interval::exact(0.5 * stiffness);
            sum = sum + bending - load.cell(*from, *to).integral_of_product(v, width);
            if let Some(force) = load.point(*from).filter(|_| 0.0 < *from) {
                sum = sum - force * v.at(Interval::ZERO);
            }
        }
        sum
    }
}
