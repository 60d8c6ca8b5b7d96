//! What a gap is worth, against beams for which the bound is reached.

use super::*;
use crate::certificate::bounds::curve::Curve;

const LENGTH: f64 = 20.0;
const STIFFNESS: f64 = 70.0;
/// A few dozen roundings.
const ROUNDING: f64 = 1e-13;

#[track_caller]
fn sharp(bound: f64, value: f64) {
    assert!((value * (1.0 - ROUNDING)..=value * (1.0 + ROUNDING)).contains(&bound), "{bound}, not {value}");
}

fn piece([from, to]: [f64; 2], coefficients: &[f64]) -> Piece {
    let coefficients: Vec<Interval> = coefficients.iter().map(|c| Interval::exact(*c)).collect();
    Piece { from, to, v: Polynomial::new(&coefficients), follows: false }
}

/// A force `F` at mid-span bends the beam by `F l³/48 EI` there and stores `F² l³/96 EI`: no deflection with that energy
/// is larger, so that the bound is reached.
#[test]
fn a_force_at_mid_span_reaches_the_bound() {
    let cube = LENGTH * LENGTH * LENGTH;
    let force = 3.0;
    let (deflection, gap) = (force * cube / (48.0 * STIFFNESS), force * force * cube / (96.0 * STIFFNESS));
    sharp(of_gap(gap, STIFFNESS, LENGTH), deflection);
    sharp(factor(gap, STIFFNESS, LENGTH).hi() * 0.25 * LENGTH * LENGTH, deflection);
}

/// Deflections that are off by one in one cell: the bound adds the largest `x (l − x)` of that cell.
#[test]
fn the_bound_of_a_cell_has_its_own_lever() {
    const FACTOR: f64 = 1e-3;
    let cells = [([0.0, 5.0], 5.0 * 15.0), ([5.0, 12.0], 10.0 * 10.0), ([12.0, 20.0], 12.0 * 8.0)];
    let straight = [piece([0.0, LENGTH], &[0.0])];
    for (k, (off, lever)) in cells.into_iter().enumerate() {
        let one = |i: usize| f64::from(u8::from(i == k));
        let judged = cells.iter().enumerate().map(|(i, (cell, _))| (*cell, piece(*cell, &[one(i)]).v));
        let mut error = Error::NONE;
        let reached = error.compare(&straight, judged, Interval::exact(FACTOR), LENGTH);
        sharp(error.most, 1.0 + FACTOR * lever);
        sharp(error.at, 0.5 * (off[0] + off[1]));
        sharp(error.size, 1.0);
        sharp(reached, LENGTH);
    }
}

/// No number among the values is no bound, wherever it comes from, and of equal bounds the first place is named.
#[test]
fn what_is_no_number_is_no_bound() {
    for (bound, size) in [(f64::NAN, 1.0), (1.0, f64::NAN)] {
        let mut error = Error::NONE;
        error.include(2.0, 2.0, 3.0);
        error.include(bound, size, 5.0);
        assert!(error.most.is_infinite() && error.size.is_infinite(), "{bound} and {size}");
    }
    let mut error = Error::NONE;
    error.include(2.0, 1.0, 3.0);
    error.include(2.0, 1.0, 5.0);
    sharp(error.at, 3.0);
}

/// Half the deflection is missing: nothing is known of the rest.
#[test]
fn what_ends_on_the_way_is_not_judged() {
    let curve = Curve { pieces: vec![piece([0.0, LENGTH], &[0.0])] };
    let pair = Pair { curve, gap: Interval::exact(1.0), reactions: [Interval::ZERO; 2], lifted: 0.0 };
    let judged = [([0.0, 10.0], Polynomial::ZERO)];
    assert!(of_pieces(&pair, judged.into_iter(), STIFFNESS, LENGTH).most.is_infinite());
}
