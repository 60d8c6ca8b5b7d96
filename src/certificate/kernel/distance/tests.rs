//! What a gap is worth, against beams for which the bound is reached; and every term of the distance between two deflections.

use super::*;
use crate::certificate::judged::{Cell, NARROW, parts};
use crate::certificate::kernel::polynomial::Polynomial;
use crate::certificate::kernel::reference::{Datum, Line};
use crate::certificate::kernel::tension::Taut;

const LENGTH: f64 = 20.0;
const STIFFNESS: f64 = 70.0;
/// What rounding adds to the bounds.
const ROUNDING: f64 = 1e-9;

#[track_caller]
fn at_least(bound: f64, value: f64) {
    assert!((value..=value + ROUNDING * value.max(1.0)).contains(&bound), "{bound}, not {value}");
}

fn piece([from, to]: [f64; 2], coefficients: &[f64]) -> Piece {
    let coefficients: Vec<Interval> = coefficients.iter().map(|c| Interval::exact(*c)).collect();
    Piece { from, to, v: Polynomial::new(&coefficients), pressed: false }
}

fn pair(pieces: Vec<Piece>) -> Pair {
    let lines = vec![Line(Datum::at(0.0), Datum::at(LENGTH))];
    Pair {
        pieces,
        gap: 0.0,
        carried: Vec::new(),
        lines,
        zones: Vec::new(),
        turns_about: None,
        lifted: 0.0,
        ground: None,
        turned: Interval::ZERO,
        soft: 0.0,
        taut: Taut::default(),
    }
}

/// A pair with the gap that makes a factor.
fn pair_of_factor(pieces: Vec<Piece>, factor: f64) -> Pair {
    Pair { gap: 1.5 * factor * factor * STIFFNESS * LENGTH, ..pair(pieces) }
}

/// The error of a deflection by cells, without bound where nothing is known.
fn of_cells(pair: &Pair, cells: impl IntoIterator<Item = ([f64; 2], Polynomial)>) -> Error {
    let known = of(pair, parts(&pair.pieces, cells.into_iter().map(Cell::of), LENGTH), STIFFNESS, LENGTH);
    known.unwrap_or(Error { most: f64::INFINITY, at: 0.0, size: f64::INFINITY })
}

fn constant(value: f64) -> Polynomial {
    Polynomial::new(&[Interval::exact(value)])
}

/// A force `F` at mid-span bends the beam by `F l³/48 EI` there and stores `F² l³/96 EI`: no deflection with that energy
/// is larger, so that the bound is reached.
#[test]
fn a_force_at_mid_span_reaches_the_bound() {
    let cube = LENGTH * LENGTH * LENGTH;
    let force = 3.0;
    let (deflection, gap) = (force * cube / (48.0 * STIFFNESS), force * force * cube / (96.0 * STIFFNESS));
    let pair = Pair { gap, ..pair(Vec::new()) };
    at_least(anywhere(&pair, STIFFNESS, LENGTH), deflection);
    at_least(on_part(&pair, factor(gap, STIFFNESS), [0.5 * LENGTH; 2]), deflection);
}

/// What a place is known by counts, and of several pairs of places the best one.
#[test]
fn the_best_of_what_holds_the_beam_counts() {
    let off = |off: f64| {
        Line(Datum { uncertainty: off, ..Datum::at(5.0) }, Datum { uncertainty: 2.0 * off, ..Datum::at(15.0) })
    };
    let held = |lines: Vec<Line>| on_part(&Pair { lines, ..pair(Vec::new()) }, 0.5, [10.0; 2]);
    let lever = 5.0 * 5.0 / 10.0_f64.sqrt();
    at_least(held(vec![off(0.0)]), 0.5 * lever);
    at_least(held(vec![off(2.0)]), 0.5 * lever + 3.0);
    at_least(held(vec![off(2.0), off(1.0), off(3.0)]), 0.5 * lever + 1.5);
    assert!(held(Vec::new()).is_infinite());
}

/// The judged deflection is zero but for one in one cell, the admissible one zero but for `−2` in one piece.
#[test]
fn every_cell_and_every_piece_is_compared() {
    let cells = [0.0, 0.001, 5.0, 12.5, 19.999, LENGTH];
    let pieces = [0.0, 4.9, 5.1, 5.2, LENGTH];
    let no_pieces = || vec![piece([0.0, LENGTH], &[])];
    for odd in 0..5 {
        let judged =
            (0..5).map(|k| ([cells[k], cells[k + 1]], if k == odd { constant(1.0) } else { Polynomial::ZERO }));
        let error = of_cells(&pair(no_pieces()), judged);
        at_least(error.most, 1.0);
        at_least(error.size, 1.0);
        assert!(cells[odd] < error.at && error.at < cells[odd + 1], "{error:?} in cell {odd}");
    }
    for odd in 0..4 {
        let pieces = (0..4).map(|k| piece([pieces[k], pieces[k + 1]], if k == odd { &[-2.0] } else { &[] })).collect();
        let judged = [([0.0, 5.15], Polynomial::ZERO), ([5.15, LENGTH], constant(0.5))];
        let error = of_cells(&pair(pieces), judged);
        at_least(error.most, if odd < 2 { 2.0 } else { 2.5 });
        at_least(error.size, 0.5);
    }
}

/// The distance and what the gap allows add up in each part, about the origins of cell and piece: `x/l` against `−(x/l)²`.
#[test]
fn both_terms_of_the_bound_are_there() {
    /// The parts in the middle are this wide, and the one beside the middle counts with its arc.
    const WIDTH: f64 = NARROW * LENGTH;
    let with =
        |factor: f64| pair_of_factor(vec![piece([0.0, 0.7 * LENGTH], &[]), piece([0.7 * LENGTH, LENGTH], &[])], factor);
    let lever = 0.25 * LENGTH * LENGTH + 0.25 * WIDTH * WIDTH;
    let error = |factor: f64, off: f64| of_cells(&with(factor), [([0.0, LENGTH], constant(off))]);
    at_least(error(2.0, 0.0).most, 2.0 * lever);
    at_least(error(2.0, 3.0).most, 2.0 * lever + 3.0);
    assert!((error(2.0, 0.0).at - 0.5 * LENGTH).abs() <= WIDTH);
    let [rising, falling] = [[0.0, 1.0 / LENGTH, 0.0], [0.0, 0.0, -1.0 / LENGTH / LENGTH]]
        .map(|c| Polynomial::new(&c.map(Interval::exact)));
    for at in [3.0, 17.0] {
        let split = |v: &Polynomial, ends: [f64; 3]| {
            [([ends[0], ends[1]], *v), ([ends[1], ends[2]], v.shifted(Interval::exact(ends[1])))]
        };
        let pieces = split(&falling, [0.0, 0.6 * LENGTH, LENGTH])
            .map(|([from, to], v)| Piece { from, to, v, pressed: false })
            .to_vec();
        let judged = split(&rising, [0.0, at, LENGTH]);
        let error = of_cells(&pair(pieces), judged);
        // At the end of the last part, with the bow of its curvature.
        assert!((2.0..2.0 + 0.25 * NARROW * NARROW + ROUNDING).contains(&error.most), "{error:?}");
        at_least(error.size, 1.0);
    }
}

/// The largest difference may be at the left end of a part, where no other part ends.
#[test]
fn the_left_end_of_the_beam_counts() {
    let falling = Polynomial::new(&[1.0, -1.0 / LENGTH].map(Interval::exact));
    let error = of_cells(&pair(vec![piece([0.0, LENGTH], &[])]), [([0.0, LENGTH], falling)]);
    at_least(error.most, 1.0);
    at_least(error.size, 1.0);
}

/// Of two deflections with the same values and curvatures at both ends nothing is known but their fourth derivatives, which may
/// have different signs: `w⁴/64` of their sum. `v̂ = 2 + x⁴/1000` from `x = 1`.
#[test]
fn fourth_derivatives_of_both_deflections_count() {
    let fourth = 24.0 / 1000.0;
    let admissible = piece([1.0, 1.0 + LENGTH], &[2.0, 0.0, 0.0, 0.0, 1.0 / 1000.0]);
    let pair = Pair { pieces: vec![piece([0.0, 1.0], &[]), admissible], ..pair(Vec::new()) };
    let values = |v: f64, bent: f64| [v, bent].map(Interval::exact);
    let square = LENGTH * LENGTH;
    let own = 3.0;
    let part = |ends: [f64; 2], values, fourth| Part { ends, values, fourth };
    let parts = [
        part([0.0, 1.0], [values(0.0, 0.0); 2], 0.0),
        part(
            [1.0, 1.0 + LENGTH],
            [values(2.0, 0.0), values(2.0 + square * square / 1000.0, 0.5 * fourth * square)],
            own,
        ),
    ];
    let error = of(&pair, parts.into_iter(), STIFFNESS, LENGTH).expect("parts of the whole beam");
    let expected = square * square / 64.0 * (own + fourth);
    assert!((expected..expected * (1.0 + ROUNDING)).contains(&error.most), "{error:?}, not {expected}");
    let size = 2.0 + square * square / 1000.0 + square / 8.0 * (0.5 * fourth * square + square / 8.0 * own);
    assert!((size..size * (1.0 + ROUNDING)).contains(&error.size), "{error:?}, not {size}");
}

/// The same of `v̂ = x⁵/10⁴`, whose fourth derivative is largest at the right end.
#[test]
fn a_fourth_derivative_that_grows_counts_with_its_largest_value() {
    let (cube, share) = (LENGTH * LENGTH * LENGTH, 1e-4);
    let ends = [[0.0; 2], [share * cube * LENGTH * LENGTH, 20.0 * share * cube]];
    let part = Part { ends: [0.0, LENGTH], values: ends.map(|end| end.map(Interval::exact)), fourth: 0.0 };
    let growing = pair(vec![piece([0.0, LENGTH], &[0.0, 0.0, 0.0, 0.0, 0.0, share])]);
    let error = of(&growing, [part].into_iter(), STIFFNESS, LENGTH).expect("one part, the whole beam");
    at_least(error.most, cube * LENGTH / 64.0 * 120.0 * share * LENGTH);
}

/// A difference `16 (x/l)² (1 − x/l)²` of one cell, which its curvature at the ends makes twice too large, is found to a twentieth in
/// a short cell and nearly as it is in a long one.
#[test]
fn differences_in_a_cell_are_found_sharply() {
    for (cell, share) in [(0.001 * LENGTH, 0.05), (LENGTH, 1e-4)] {
        let v = [0.0, 0.0, 16.0, -32.0, 16.0];
        let mut power = 1.0;
        let scaled = v.map(|c| {
            let value = c / power;
            power *= cell;
            Interval::exact(value)
        });
        let mut judged = vec![([0.0, cell], Polynomial::new(&scaled))];
        judged.extend((cell < LENGTH).then_some(([cell, LENGTH], Polynomial::ZERO)));
        let error = of_cells(&pair(vec![piece([0.0, LENGTH], &[])]), judged);
        assert!((1.0..1.0 + share).contains(&error.most), "{error:?}");
    }
}

/// What the places of a witness make is off by what it was lifted by, and by what the gap allows; nothing is known of it where
/// another list is better.
#[test]
fn what_a_witness_was_lifted_by_counts() {
    let own = |gap: f64, lifted: f64| {
        let pair = Pair { gap, lifted, ..pair(vec![piece([0.0, LENGTH], &[2.0])]) };
        of_witness(&pair, STIFFNESS, LENGTH)
    };
    at_least(own(0.0, 0.25), 0.25);
    let gap = Pair { gap: 3.0, ..pair(Vec::new()) };
    at_least(own(3.0, 0.25), 0.25 + anywhere(&gap, STIFFNESS, LENGTH));
    assert!(own(0.0, f64::INFINITY).is_infinite());
    assert!(own(f64::INFINITY, 0.0).is_infinite());
}

#[test]
fn no_number_is_no_bound() {
    for odd in 0..3 {
        for order in 0..3 {
            let mut coefficients = [1.0; 3];
            coefficients[order] = f64::NAN;
            let wrong = Polynomial::new(&coefficients.map(Interval::exact));
            let cells = [0.0, 1.0, 11.0, LENGTH];
            let judged = (0..3).map(|k| ([cells[k], cells[k + 1]], if k == odd { wrong } else { Polynomial::ZERO }));
            let error = of_cells(&pair(vec![piece([0.0, LENGTH], &[])]), judged);
            assert!(error.most.is_infinite() && error.size.is_infinite(), "coefficient {order} of cell {odd}");
        }
    }
}

/// Where `v̂` is of any bend, over a width of which the square is below the range of numbers, the bound is none, whatever is judged.
#[test]
fn where_a_bound_is_no_number_it_is_none() {
    let narrow = 1e-170;
    let wild = piece([0.0, narrow], &[0.0, 0.0, 0.0, 0.0, f64::INFINITY]);
    let pair = pair(vec![wild, piece([narrow, LENGTH], &[])]);
    let zero = [[Interval::ZERO; 2]; 2];
    let judged = [[0.0, narrow], [narrow, LENGTH]].map(|ends| Part { ends, values: zero, fourth: 0.0 });
    assert!(of(&pair, judged.into_iter(), STIFFNESS, LENGTH).is_none_or(|error| error.most.is_infinite()));
}

/// Pieces and cells that do not go all the way, or leave a part out, bound nothing.
#[test]
fn what_ends_on_the_way_is_not_judged() {
    let known = |pieces: &[[f64; 2]], judged: &[[f64; 2]]| {
        let pieces = pieces.iter().map(|ends| piece(*ends, &[])).collect();
        let judged = judged.iter().map(|ends| (*ends, Polynomial::ZERO));
        of_cells(&pair(pieces), judged).most < ROUNDING
    };
    let [all, two] = [&[[0.0, LENGTH]][..], &[[0.0, 4.0], [4.0, LENGTH]]];
    assert!(known(all, all) && known(all, two) && known(two, two) && known(two, &[[0.0, 3.0], [3.0, LENGTH]]));
    for part in [
        &[][..],
        &[[0.0, 10.0]],
        &[[1.0, LENGTH]],
        &[[0.0, 4.0], [4.5, LENGTH]],
        &[[0.0, 4.0], [4.0, LENGTH - 1.0]],
        &[[0.0, f64::NAN]],
    ] {
        assert!(!known(two, part), "{part:?} is judged");
        assert!(!known(part, two), "{part:?} is what is compared with");
    }
    assert!(!known(two, &[[0.0, LENGTH + 1.0]]) && !known(two, &[[0.0, 4.0], [4.0, 4.0], [4.0, 3.0]]));
}
