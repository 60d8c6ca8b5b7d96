//! Labelled places along an axis: round numbers, or decades.

use super::number::{decade, fixed, power_of_ten, ten_to};

/// A labelled place on an axis.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Tick {
    pub(super) value: f64,
    pub(super) label: String,
}

/// Round numbers in a range, about `count` of them, and the power of ten that their labels leave out.
pub(super) fn linear_ticks(lo: f64, hi: f64, count: f64) -> (Vec<Tick>, i32) {
    // A quarter more than asked for is better than half of it, which the next larger step might leave.
    let raw = (0.5 * hi - 0.5 * lo) / (0.625 * count);
    let unit = ten_to(decade(raw));
    let step = [1.0, 2.0, 5.0, 10.0].iter().map(|m| m * unit).find(|&step| raw <= step).unwrap_or(10.0 * unit);
    let magnitude = decade(lo.abs().max(hi.abs()));
    // Numbers from 0.01 up to 99 999 are written out.
    let factor = if (-2..=4).contains(&magnitude) { 0 } else { 3 * magnitude.div_euclid(3) };
    let decimals = usize::try_from(factor - decade(step)).unwrap_or(0);
    let (first, last) = ((lo / step).ceil(), (hi / step).floor());
    let mut ticks = Vec::new();
    let mut i = first;
    // A range far from zero compared with its width cannot be counted in steps; it gets no labels rather than equal ones.
    while i <= last && ticks.len() < 64 {
        let value = i * step;
        ticks.push(Tick { value, label: fixed(value / ten_to(factor), decimals) });
        i += 1.0;
    }
    (ticks, factor)
}

/// Decades, all of them or every second, third …, so that there are at most about `count`.
pub(super) fn log_ticks(first: i32, last: i32, count: f64) -> Vec<Tick> {
    let mut every = 1;
    while count < f64::from((last - first) / every) {
        every += 1;
    }
    (first..=last)
        .filter(|n| n.rem_euclid(every) == 0)
        .map(|n| Tick { value: ten_to(n), label: power_of_ten(n) })
        // The decades just beyond the range of f64 have no number.
        .filter(|tick| 0.0 < tick.value && tick.value < f64::INFINITY)
        .collect()
}
