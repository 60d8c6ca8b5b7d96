//! Where a zone of contact is possible: its pressure `q − u''''` must not be negative.

use super::bernstein::{lowest_below, sign_changes};
use super::given::Given;

/// Taylor coefficients of the pressure of a zone at the left end of `cell`.
pub(super) fn pressure(given: &Given, cell: usize) -> Vec<f64> {
    let c = &given.cells[cell];
    let mut taylor = vec![0.0; given.terms.max(6)];
    given.profile(cell, c.lo, &mut taylor);
    let mut pressure: Vec<f64> = taylor
        .iter()
        .enumerate()
        .skip(4)
        .map(|(j, c)| {
            #[expect(clippy::cast_precision_loss, reason = "a degree is a small number")]
            let j = j as f64;
            -c * j * (j - 1.0) * (j - 2.0) * (j - 3.0)
        })
        .collect();
    pressure[0] += c.load;
    pressure[1] += c.load_slope;
    pressure
}

/// Stretches in which a zone would pull at the beam, from left to right; a point load that does so is one without length.
pub(super) fn lifting(given: &Given) -> Vec<(f64, f64)> {
    /// Rounding of `q` and `u''''` against each other.
    const ROUNDING: f64 = 1e-13;
    let mut found: Vec<(f64, f64)> = Vec::new();
    let mut add = |from: f64, to: f64| match found.last_mut() {
        Some(last) if from <= last.1 => last.1 = last.1.max(to),
        _ => found.push((from, to)),
    };
    for (i, cell) in given.cells.iter().enumerate() {
        if given.joints[i].force < 0.0 {
            add(cell.lo, cell.lo);
        }
        let width = cell.hi - cell.lo;
        let p = pressure(given, i);
        let fourth = given.derivative(i, cell.lo, 4).abs();
        let size = fourth + cell.load.abs() + (cell.load_slope * width).abs();
        if lowest_below(&p, width, -ROUNDING * size).is_some() {
            let mut ends = vec![0.0];
            ends.extend(sign_changes(&p, width));
            ends.push(width);
            for w in ends.windows(2) {
                if super::bernstein::value(&p, 0.5 * (w[0] + w[1])) < 0.0 {
                    add(cell.lo + w[0], if w[1] < width { cell.lo + w[1] } else { cell.hi });
                }
            }
        }
    }
    found
}
