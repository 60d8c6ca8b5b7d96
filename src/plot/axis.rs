//! Axes of panels: label and unit, scale and direction, and labelled ticks at round numbers or decades.

use super::{PlotError, count as number, finite};
use crate::text::{decade, fixed, power_of_ten, significant, ten_to};

/// An axis of a panel.
#[derive(Debug, Clone, PartialEq)]
pub struct Axis {
    /// The quantity, without the unit; empty for no heading.
    pub label: String,
    /// Unit of the numbers.
    pub unit: Option<String>,
    /// Whether the scale is logarithmic instead of linear.
    pub log: bool,
    /// Whether the numbers of a vertical axis grow downwards, as deflections do. A horizontal axis grows to the right.
    pub down: bool,
    /// Numbers that the axis includes, whatever the data.
    pub include: Vec<f64>,
    /// Share of the range added at each end, so that lines do not run along the frame.
    pub padding: f64,
    /// Whether numbers and grid lines are drawn.
    pub numbers: bool,
    /// Names at 0, 1, 2 … instead of numbers; empty for an axis of numbers.
    pub names: Vec<String>,
}

impl Axis {
    /// A linear axis that grows upwards or to the right, without a unit.
    pub fn new(label: impl Into<String>) -> Self {
        Self {
            label: label.into(),
            unit: None,
            log: false,
            down: false,
            include: Vec::new(),
            padding: 0.04,
            numbers: true,
            names: Vec::new(),
        }
    }

    /// An axis along a beam between two positions, with room for the support symbols.
    pub fn along(label: impl Into<String>, ends: [f64; 2]) -> Self {
        Self { padding: 0.03, ..Self::new(label).including(&ends) }
    }

    /// An axis of names, one for each row or column of a map.
    pub fn named(label: impl Into<String>, names: Vec<String>) -> Self {
        Self { names, padding: 0.0, ..Self::new(label) }
    }

    /// With a unit, if there is one.
    #[must_use]
    pub fn unit(self, unit: Option<String>) -> Self {
        Self { unit, ..self }
    }

    /// With numbers that grow downwards.
    #[must_use]
    pub fn down(self) -> Self {
        Self { down: true, ..self }
    }

    /// With a logarithmic scale.
    #[must_use]
    pub fn log(self) -> Self {
        Self { log: true, ..self }
    }

    /// Without numbers, for a panel that only shows what has its own scale, such as forces.
    #[must_use]
    pub fn bare(self) -> Self {
        Self { numbers: false, ..self }
    }

    /// With these numbers inside its range.
    #[must_use]
    pub fn including(mut self, values: &[f64]) -> Self {
        self.include.extend_from_slice(values);
        self
    }

    /// The axis for `data`, with its least number at drawing coordinate `start` and its greatest at `end`, and about `count` labels.
    pub(super) fn resolve(
        &self,
        data: impl Iterator<Item = f64>,
        [start, end]: [f64; 2],
        count: f64,
    ) -> Result<Resolved, PlotError> {
        let mut range: Option<[f64; 2]> = None;
        for value in data.chain(self.include.iter().copied()) {
            let value = finite("a coordinate of the figure", value)?;
            if self.log && value <= 0.0 {
                return Err(PlotError::NotPositive { what: "a coordinate of the figure", value });
            }
            range = Some(range.map_or([value; 2], |[lo, hi]| [lo.min(value), hi.max(value)]));
        }
        let [lo, hi] = range.ok_or(PlotError::Empty { what: "a panel" })?;
        let (lo, hi, ticks, factor) = if !self.names.is_empty() {
            let tick = |(k, name): (usize, &String)| Tick { value: number(k), label: name.clone() };
            let ticks = self.names.iter().enumerate().map(tick).collect();
            (-0.5, number(self.names.len()) - 0.5, ticks, 0)
        } else if self.log {
            let [lo, hi] = [libm::log10(lo), libm::log10(hi)];
            // A range of one number gets half a decade on either side.
            let room = if lo < hi { self.padding * (hi - lo) } else { 0.5 };
            let (lo, hi) = (lo - room, hi + room);
            (lo, hi, log_ticks(lo, hi, count), 0)
        } else {
            let [lo, hi] = widened(lo, hi, self.padding);
            let (ticks, factor) = linear_ticks(lo, hi, count);
            (lo, hi, ticks, factor)
        };
        let (ticks, factor) = if self.numbers { (ticks, factor) } else { (Vec::new(), 0) };
        let [start, end] = if self.down { [end, start] } else { [start, end] };
        Ok(Resolved { log: self.log, lo, hi, start, end, ticks, factor })
    }

    /// Label and unit, with the power of ten that is left out of the numbers along the axis.
    pub(super) fn heading(&self, factor: i32) -> String {
        if self.label.is_empty() {
            return String::new();
        }
        let unit = match (&self.unit, factor) {
            (None, 0) => return self.label.clone(),
            (None, n) => power_of_ten(n),
            (Some(unit), 0) => unit.clone(),
            (Some(unit), n) => format!("{} {unit}", power_of_ten(n)),
        };
        format!("{} [{unit}]", self.label)
    }
}

/// An axis with its range of numbers and its position on the drawing.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Resolved {
    log: bool,
    /// Least and greatest number; their decimal logarithms on a logarithmic axis.
    lo: f64,
    hi: f64,
    start: f64,
    end: f64,
    pub(super) ticks: Vec<Tick>,
    /// Exponent of the power of ten by which the labels have to be multiplied.
    pub(super) factor: i32,
}

impl Resolved {
    /// The drawing coordinate of a number.
    pub(super) fn place(&self, value: f64) -> f64 {
        let value = if self.log { libm::log10(value) } else { value };
        // Halved, so that the range of all `f64` numbers does not overflow.
        let s = (0.5 * value - 0.5 * self.lo) / (0.5 * self.hi - 0.5 * self.lo);
        self.start + (self.end - self.start) * s
    }

    /// An axis of forces next to an axis of another quantity. Both have their zero at `zero`, and forces from `least` to `most` fit
    /// between `bottom` and `top`.
    pub(super) fn of_forces(
        axis: &Axis,
        [least, most]: [f64; 2],
        zero: f64,
        [bottom, top]: [f64; 2],
        count: f64,
    ) -> Self {
        let per = |room: f64, force: f64| if 0.0 < force { room.max(1.0) / force } else { f64::INFINITY };
        let unit = per(zero - top, most).min(per(bottom - zero, -least));
        let unit = if unit.is_finite() { unit } else { 1.0 };
        let (lo, hi) = ((zero - bottom) / unit, (zero - top) / unit);
        let (mut ticks, mut factor) = linear_ticks(lo, hi, count);
        ticks.retain(|tick| least <= tick.value);
        if !axis.numbers {
            (ticks, factor) = (Vec::new(), 0);
        }
        Self { log: false, lo, hi, start: bottom, end: top, ticks, factor }
    }
}

/// The axes of a panel on the drawing.
pub(super) struct Axes {
    pub(super) x: Resolved,
    pub(super) y: Resolved,
    /// The scale for the length of arrows, if it is not `y`.
    pub(super) forces: Option<Resolved>,
}

impl Axes {
    /// The drawing coordinates of a point in the numbers of the axes.
    pub(super) fn place(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        [self.x.place(x), self.y.place(y)]
    }

    /// The vertical extent of the arrow of a force on the drawing; upwards is negative.
    pub(super) fn length(&self, force: f64) -> f64 {
        let axis = self.forces.as_ref().unwrap_or(&self.y);
        axis.place(force) - axis.place(0.0)
    }
}

/// A range with some room at either end, and never empty: equal numbers get half of their magnitude on either side.
fn widened(lo: f64, hi: f64, padding: f64) -> [f64; 2] {
    /// Differences between numbers below this share of their magnitude are rounding, not data.
    const ROUNDING: f64 = 1e-12;
    let magnitude = lo.abs().max(hi.abs());
    let room = if ROUNDING * magnitude < hi - lo {
        padding * (0.5 * hi - 0.5 * lo) * 2.0
    } else if f64::MIN_POSITIVE < magnitude {
        0.5 * magnitude
    } else {
        1.0
    };
    [(lo - room).max(f64::MIN), (hi + room).min(f64::MAX)]
}

/// A labelled position on an axis.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Tick {
    pub(super) value: f64,
    pub(super) label: String,
}

/// About `count` round numbers in a range, and the exponent of the power of ten that their labels leave out.
pub(super) fn linear_ticks(lo: f64, hi: f64, count: f64) -> (Vec<Tick>, i32) {
    // A quarter more labels than requested is better than half of them, which the next larger step might leave.
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
    // If the range is narrow compared with its distance from zero, steps cannot be counted. It gets no labels instead of equal ones.
    while i <= last && ticks.len() < 64 {
        let value = i * step;
        ticks.push(Tick { value, label: fixed(value / ten_to(factor), decimals) });
        i += 1.0;
    }
    (ticks, factor)
}

/// Decades between two decimal logarithms, at most about `count` of them. If there are few, twice and five times a decade are added.
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

/// The nearest integer exponent; powers of ten in `f64` end at 308.
#[expect(clippy::cast_possible_truncation, reason = "clamped to what an i32 holds")]
fn whole(exponent: f64) -> i32 {
    exponent.clamp(-400.0, 400.0) as i32
}

#[cfg(test)]
mod tests {
    use super::{Axis, PlotError};

    fn labels(axis: &Axis, data: &[f64]) -> Vec<String> {
        let axis = axis.resolve(data.iter().copied(), [0.0, 100.0], 5.0).expect("finite data");
        axis.ticks.into_iter().map(|t| t.label).collect()
    }

    #[test]
    fn small_and_large_numbers_share_a_power_of_ten() {
        let axis = Axis::new("v").unit(Some("m".to_owned()));
        let resolved = axis.resolve([0.0, 4e-6].into_iter(), [0.0, 1.0], 5.0).expect("finite data");
        assert_eq!(axis.heading(resolved.factor), "v [10⁻⁶ m]");
        assert_eq!(labels(&axis, &[0.0, 4e-6]), ["0", "1", "2", "3", "4"]);
    }

    #[test]
    fn degenerate_ranges_get_room() {
        for data in [[0.0; 2], [3.0; 2], [-1e300, 1e308], [f64::MIN, f64::MAX], [5e-324; 2], [1.0, 1.0 + f64::EPSILON]]
        {
            let axis = Axis::new("x").resolve(data.into_iter(), [0.0, 100.0], 5.0).expect("finite data");
            for value in data {
                let place = axis.place(value);
                assert!((0.0..=100.0).contains(&place), "{value:e} of {data:?} lies at {place}");
            }
            assert!(!axis.ticks.is_empty(), "no labels for {data:?}");
        }
    }

    #[test]
    fn numbers_without_a_place_are_refused() {
        let nan = Axis::new("x").resolve([1.0, f64::NAN].into_iter(), [0.0, 1.0], 5.0);
        assert!(matches!(nan, Err(PlotError::NotFinite { .. })), "{nan:?}");
        let zero = Axis::new("x").log().resolve([1.0, 0.0].into_iter(), [0.0, 1.0], 5.0);
        assert!(matches!(zero, Err(PlotError::NotPositive { .. })), "{zero:?}");
        let none = Axis::new("x").resolve([].into_iter(), [0.0, 1.0], 5.0);
        assert!(matches!(none, Err(PlotError::Empty { .. })), "{none:?}");
    }
}
