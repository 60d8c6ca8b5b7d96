//! Taylor's polynomials of the profiles that have a formula, as enclosures on a cell.

use super::polynomial::{Polynomial, TERMS, number};
use crate::certificate::interval::Interval;

/// Taylor's polynomial about an origin, for a cell; terms beyond those that are kept become the remainder of Lagrange.
pub(super) fn of_polynomial(given: &[f64], origin: f64, cell: [f64; 2]) -> Polynomial {
    let mut shifted: Vec<Interval> = given.iter().map(|&c| Interval::exact(c)).collect();
    let shift = |coefficients: &mut [Interval], s: Interval| {
        for start in 0..coefficients.len() {
            for j in (start..coefficients.len() - 1).rev() {
                coefficients[j] = coefficients[j] + coefficients[j + 1] * s;
            }
        }
    };
    if shifted.len() <= TERMS {
        shift(&mut shifted, Interval::exact(origin));
        return Polynomial::new(&shifted);
    }
    // The coefficient of the remainder: that of Taylor's polynomial at any place of the cell.
    let mut anywhere = shifted.clone();
    shift(&mut anywhere, Interval::between(cell[0], cell[1]));
    shift(&mut shifted, Interval::exact(origin));
    shifted.truncate(TERMS);
    shifted[TERMS - 1] = anywhere[TERMS - 1];
    Polynomial::new(&shifted)
}

/// Derivatives of a cosine at `x`, over factorials; the last one at any place.
pub(super) fn of_cosine([mean, amplitude, wavelength, phase]: [f64; 4], x: f64) -> Polynomial {
    let [cos, sin] = Interval::cos_sin(Interval::exact(x) / Interval::exact(wavelength), Interval::exact(phase));
    let wave_number = Interval::TAU / Interval::exact(wavelength);
    let mut factor = Interval::exact(amplitude);
    let mut coefficients = [Interval::ZERO; TERMS];
    for (j, c) in coefficients.iter_mut().enumerate() {
        let value = match j % 4 {
            _ if j == TERMS - 1 => Interval::around_zero(1.0),
            0 => cos,
            1 => -sin,
            2 => -cos,
            _ => sin,
        };
        *c = factor * value;
        factor = factor * wave_number / number(j + 1);
    }
    coefficients[0] = coefficients[0] + Interval::exact(mean);
    Polynomial::new(&coefficients)
}
