//! The maximum and minimum of a quantity along the beam, with their positions.

use std::ops::ControlFlow;

/// The maximum and minimum of a quantity along the beam, with their positions.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Extremes {
    /// Maximum.
    pub max: f64,
    /// Position of the maximum \[length\].
    pub max_at: f64,
    /// Minimum.
    pub min: f64,
    /// Position of the minimum \[length\].
    pub min_at: f64,
}

impl Extremes {
    /// Values with a smaller difference, relative to the largest one, count as equal. Of two symmetric extremes the left one is
    /// then reported, regardless of rounding.
    const EQUAL: f64 = 1e-12;

    /// The largest magnitude, `max(|max|, |min|)`.
    #[must_use]
    pub fn magnitude(&self) -> f64 {
        self.max.abs().max(self.min.abs())
    }

    /// The extremes of `(position, value)` pairs from left to right; zero at position 0 if there are none.
    ///
    /// If the extreme value occurs over a stretch, the position is the middle of the first such stretch, otherwise the first
    /// occurrence.
    #[must_use]
    pub(crate) fn of<I: IntoIterator<Item = (f64, f64), IntoIter: Clone>>(values: I) -> Self {
        let values = values.into_iter();
        let (max, min) = values
            .clone()
            // `f64::max` and `f64::min` also check for NaN and are slower.
            .fold((f64::NEG_INFINITY, f64::INFINITY), |(max, min), (_, value)| {
                (if max < value { value } else { max }, if value < min { value } else { min })
            });
        if max < min {
            return Self::default();
        }
        Self::at_known_values(max, min, |_, _| values.clone())
    }

    /// The positions of known extremes. `near(extreme, equal)` may omit values. Of each omitted stretch it must return one value,
    /// and both end values if the stretch contains values within `equal` of the extreme.
    pub(crate) fn at_known_values<I: Iterator<Item = (f64, f64)>>(
        max: f64,
        min: f64,
        near: impl Fn(f64, f64) -> I,
    ) -> Self {
        let largest = max.abs().max(min.abs());
        let equal = Self::EQUAL * largest;
        let place = |extreme: f64| place_of(near(extreme, equal), extreme, equal);
        // What remains of a zero value is rounding and has no meaningful sign.
        let clean = |value: f64| if value.abs() <= 16.0 * f64::EPSILON * largest { 0.0 } else { value };
        Self { max: clean(max), max_at: place(max), min: clean(min), min_at: place(min) }
    }

    /// Converts to the units of the values and of length.
    pub(crate) fn in_units(self, unit: f64, length: f64) -> Self {
        let Self { max, max_at, min, min_at } = self;
        Self { max: max * unit, max_at: max_at * length, min: min * unit, min_at: min_at * length }
    }

    /// Includes one more value if it clearly exceeds the current extremes.
    #[must_use]
    pub(crate) fn beyond(self, at: f64, value: f64) -> Self {
        let equal = Self::EQUAL * self.magnitude();
        if self.max + equal < value {
            Self { max: value, max_at: at, ..self }
        } else if value < self.min - equal {
            Self { min: value, min_at: at, ..self }
        } else {
            self
        }
    }
}

/// The position of an extreme value: the middle of the first stretch of consecutive values that reach it, otherwise the first
/// occurrence.
fn place_of(mut values: impl Iterator<Item = (f64, f64)>, extreme: f64, equal: f64) -> f64 {
    let mut first = f64::NAN;
    let mut run: Option<(f64, f64)> = None;
    // `try_for_each` processes chained iterators part by part and is faster than `for`.
    let _ = values.try_for_each(|(at, value)| {
        if (value - extreme).abs() <= equal {
            run = Some(run.map_or((at, at), |(from, _)| (from, at)));
            if first.is_nan() {
                first = at;
            }
        } else if let Some((from, to)) = run {
            if from < to {
                return ControlFlow::Break(());
            }
            run = None;
        }
        ControlFlow::Continue(())
    });
    match run {
        Some((from, to)) if from < to => 0.5 * (from + to),
        _ => first,
    }
}
