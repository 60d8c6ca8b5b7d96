//! The greatest and the least of values along the beam, with the places that a person would name.

use std::ops::ControlFlow;

/// The greatest and the least value of a quantity along the beam, and where they are.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Extremes {
    /// Greatest value.
    pub max: f64,
    /// Where it is \[length\].
    pub max_at: f64,
    /// Least value.
    pub min: f64,
    /// Where it is \[length\].
    pub min_at: f64,
}

impl Extremes {
    /// Values that differ by less than this share of the largest one are equal: of mirror images the left one is named, and
    /// not the one that rounding favours.
    const EQUAL: f64 = 1e-12;

    /// The largest magnitude, `max(|max|, |min|)`.
    #[must_use]
    pub fn magnitude(&self) -> f64 {
        self.max.abs().max(self.min.abs())
    }

    /// Extremes of `(place, value)` pairs from left to right; zero at 0 if there are none.
    ///
    /// Where the extreme value holds over a stretch, the middle of the first such stretch is named, otherwise its first place.
    #[must_use]
    pub(crate) fn of<I: IntoIterator<Item = (f64, f64), IntoIter: Clone>>(values: I) -> Self {
        let values = values.into_iter();
        let (max, min) = values
            .clone()
            // Not `f64::max` and `f64::min`, which also look for NaN and are slower.
            .fold((f64::NEG_INFINITY, f64::INFINITY), |(max, min), (_, value)| {
                (if max < value { value } else { max }, if value < min { value } else { min })
            });
        if max < min {
            return Self::default();
        }
        Self::known(max, min, |_, _| values.clone())
    }

    /// The same for values of which the extremes are known. `near(extreme, equal)` may pass over values as long as it shows
    /// one of each stretch that is passed over, and its two ends if it comes within `equal` of the extreme.
    pub(crate) fn known<I: Iterator<Item = (f64, f64)>>(max: f64, min: f64, near: impl Fn(f64, f64) -> I) -> Self {
        let largest = max.abs().max(min.abs());
        let equal = Self::EQUAL * largest;
        let place = |extreme: f64| place_of(near(extreme, equal), extreme, equal);
        // What is left of a value that is zero is rounding, and has no sign.
        let clean = |value: f64| if value.abs() <= 16.0 * f64::EPSILON * largest { 0.0 } else { value };
        Self { max: clean(max), max_at: place(max), min: clean(min), min_at: place(min) }
    }

    /// In units of the values and of length.
    pub(crate) fn in_units(self, unit: f64, length: f64) -> Self {
        let Self { max, max_at, min, min_at } = self;
        Self { max: max * unit, max_at: max_at * length, min: min * unit, min_at: min_at * length }
    }

    /// With one more value, if it lies clearly beyond those seen.
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

/// Where a value is reached: the middle of the first stretch of neighbours that reach it, otherwise the first place.
fn place_of(mut values: impl Iterator<Item = (f64, f64)>, extreme: f64, equal: f64) -> f64 {
    let mut first = f64::NAN;
    let mut run: Option<(f64, f64)> = None;
    // `try_for_each` and not `for`: iterators that are put together are walked part by part.
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
