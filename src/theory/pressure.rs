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
pub(super) fn tension_intervals(given: &Given) -> Vec<(f64, f64)> {
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
        let straight = given.shapes[cell.shape].degree().is_some_and(|degree| degree < 4);
        if straight && 0.0 <= cell.load && 0.0 <= cell.load + cell.load_slope * width {
            continue;
        }
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

/// How much a zone would pull on the average between `lo` and `hi`, or at these two; a point load that pulls, spread over
/// the beam, if there is one.
pub(super) fn mean_pull(given: &Given, lo: f64, hi: f64) -> f64 {
    let (first, last) = (given.cell_from(lo), given.cell_to(hi).max(given.cell_from(lo)));
    let from = given.joints.partition_point(|j| j.x < lo);
    let inside = given.joints[from..].iter().take_while(|j| j.x <= hi);
    let point = -inside.map(|j| j.force.min(0.0)).sum::<f64>() / given.length;
    if hi <= lo {
        return point;
    }
    let mut sum = 0.0;
    for cell in first..=last {
        let c = &given.cells[cell];
        let (from, to) = (c.lo.max(lo), c.hi.min(hi));
        if from < to {
            sum += given.load_rule.integral(from, to, |x| given.drive(cell, x).max(0.0));
        }
    }
    point.max(sum / (hi - lo)).max(given.drive(first, lo)).max(given.drive(last, hi))
}
