//! Deflections by pieces, and the integrals over them.

use super::load::{Pieces, cells};
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

/// A deflection: its value and its slope are continuous, and it vanishes at both ends.
#[derive(Debug, Clone, Default)]
pub(super) struct Curve {
    pub(super) pieces: Vec<Piece>,
}

impl Curve {
    /// `J(v) = ½∫EI v''² dx − ∫q v dx − Σ P v`, (17) with point loads.
    pub(super) fn energy(&self, load: &Pieces, stiffness: f64) -> Interval {
        let mut sum = Interval::ZERO;
        for Piece { from, to, v, .. } in &self.pieces {
            let second = v.derivative().derivative();
            for [a, b] in cells(*from, *to, load.breaks(*from, *to)) {
                let width = Interval::exact(b) - Interval::exact(a);
                let shift = Interval::exact(a) - Interval::exact(*from);
                let (v, second) = if *from < a { (v.shifted(shift), second.shifted(shift)) } else { (*v, second) };
                let bending = second.integral_of_square(width) * Interval::exact(0.5 * stiffness);
                sum = sum + bending - load.cell(a, b).integral_of_product(&v, width);
                if let Some(force) = load.point(a).filter(|_| 0.0 < a) {
                    sum = sum - force * v.at(Interval::ZERO);
                }
            }
        }
        sum
    }
}

/// Calls `visit(a, b, f, g)` for every `[a, b]` on which two deflections have one formula each, with both polynomials about
/// `a`. Both lists run from 0 to `l`.
pub(super) fn overlay(
    curve: impl Iterator<Item = ([f64; 2], Polynomial)>,
    other: impl Iterator<Item = ([f64; 2], Polynomial)>,
    mut visit: impl FnMut(f64, f64, &Polynomial, &Polynomial),
) {
    let (mut curve, mut other) = (curve, other);
    let (mut first, mut second) = (curve.next(), other.next());
    let about = |polynomial: &Polynomial, origin: f64, a: f64| {
        if origin < a { polynomial.shifted(Interval::exact(a) - Interval::exact(origin)) } else { *polynomial }
    };
    while let (Some((one, f)), Some((two, g))) = (&first, &second) {
        let (a, b) = (one[0].max(two[0]), one[1].min(two[1]));
        if a < b {
            visit(a, b, &about(f, one[0], a), &about(g, two[0], a));
        }
        let (done_one, done_two) = (one[1] <= b, two[1] <= b);
        if done_one {
            first = curve.next();
        }
        if done_two {
            second = other.next();
        }
    }
}
