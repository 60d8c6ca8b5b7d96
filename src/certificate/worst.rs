//! The worst of many numbers, NaN not forgotten.

/// The largest number seen, at least 0, and whether all were numbers.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Worst {
    largest: f64,
    nan: bool,
}

impl Worst {
    /// One more number. Most are not larger than one before, and for these a comparison is all.
    #[inline]
    pub(super) fn see(&mut self, value: f64) {
        if value <= self.largest {
            return;
        }
        if value.is_nan() {
            self.nan = true;
        } else {
            self.largest = value;
        }
    }

    /// Many more. If none of them is larger than one before, they are compared side by side.
    #[inline]
    pub(super) fn see_all(&mut self, values: impl Iterator<Item = f64> + Clone) {
        let before = self.largest;
        // What cannot be compared is not known to be small.
        let all_small = |small, value: f64| small & (value <= before);
        if !values.clone().fold(true, all_small) {
            values.for_each(|value| self.see(value));
        }
    }

    /// The largest; infinite if one of them was NaN.
    pub(super) fn value(&self) -> f64 {
        if self.nan { f64::INFINITY } else { self.largest }
    }
}

/// The largest of some numbers, at least 0; infinite if one of them is NaN.
pub(super) fn worst(values: impl IntoIterator<Item = f64>) -> f64 {
    let mut worst = Worst::default();
    values.into_iter().for_each(|value| worst.see(value));
    worst.value()
}

#[cfg(test)]
mod tests {
    use super::{Worst, worst};

    /// One by one or all together, with numbers before and behind that are larger or none.
    #[test]
    fn many_are_seen_as_one_by_one() {
        let numbers = [-1.0, 0.0, 1.0, 2.0, f64::INFINITY, f64::NAN];
        for before in numbers {
            for (one, two) in numbers.into_iter().flat_map(|one| numbers.map(|two| (one, two))) {
                let (mut single, mut all) = (Worst::default(), Worst::default());
                [before, one, two].into_iter().for_each(|value| single.see(value));
                all.see(before);
                all.see_all([one, two].into_iter());
                assert_eq!(all.value().to_bits(), single.value().to_bits(), "{before}, {one}, {two}");
            }
        }
    }

    #[test]
    fn nan_is_the_worst_wherever_it_stands() {
        assert_eq!(worst([-1.0, -2.0]).to_bits(), 0.0_f64.to_bits(), "at least zero");
        assert_eq!(worst([1.0, 3.0, 2.0]).to_bits(), 3.0_f64.to_bits(), "the largest");
        for place in 0..3 {
            let mut values = [1.0, 3.0, 2.0];
            values[place] = f64::NAN;
            assert!(worst(values).is_infinite(), "NaN at {place}");
        }
    }
}
