//! Labelled places along an axis: round numbers, or decades.

use crate::text::{decade, fixed, power_of_ten, significant, ten_to};

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

/// Decades between two decimal logarithms, so many that there are at most about `count`; where there are few, twice and five
/// times a decade as well.
pub(super) fn log_ticks(lo: f64, hi: f64, count: f64) -> Vec<Tick> {
    let inside = |value: &f64| (lo..=hi).contains(&libm::log10(*value));
    let (first, last) = (whole(lo.floor()), whole(hi.ceil()));
    let decades: Vec<i32> = (first..=last).filter(|&n| inside(&ten_to(n))).collect();
    let few = || (first..=last).flat_map(|n| [1.0, 2.0, 5.0].map(|m| m * ten_to(n))).filter(inside);
    let written = (-3..=4).contains(&first) && (-3..=4).contains(&last);
    let label = |value: f64| {
        let n = decade(value);
        if written || value.to_bits() != ten_to(n).to_bits() { significant(value, 2) } else { power_of_ten(n) }
    };
    let tick = |value: f64| Tick { value, label: label(value) };
    match decades.len() {
        3.. => {
            let mut every = 1;
            while count < f64::from(last - first) / f64::from(every) {
                every += 1;
            }
            decades.into_iter().filter(|n| n.rem_euclid(every) == 0).map(|n| tick(ten_to(n))).collect()
        }
        _ if 1 < few().count() => few().map(tick).collect(),
        _ => linear_ticks(libm::pow(10.0, lo), libm::pow(10.0, hi), count).0,
    }
}

/// The nearest power of ten; those of `f64` end at 308.
#[expect(clippy::cast_possible_truncation, reason = "clamped to what an i32 holds")]
fn whole(exponent: f64) -> i32 {
    exponent.clamp(-400.0, 400.0) as i32
}
