//! Double sums over a grid: forces to moments, curvatures to deflections.
//!
//! ```text
//! s_i = s_{i−1} − f_i,   y_{i+1} = y_i + s_i,      y_0 = 0, s_0 = 0
//! ```
//!
//! A million roundings of a slope would be a million times larger in the height: both sums keep what rounding takes from
//! them, as in Kahan's and Neumaier's sums, and the slope passes its share on.

/// Height and slope side by side, and what rounding has taken from each.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Twice {
    value: [f64; 2],
    lost: [f64; 2],
}

impl Twice {
    /// From node `i − 1` to node `i`: the height there, before the slope falls by `f_i`.
    ///
    /// Both additions at once; `lost` gets their exact errors (Knuth's two-sum).
    #[inline]
    pub(super) fn step(&mut self, fall: f64) -> f64 {
        let Self { value, lost } = *self;
        let (next, passed) = ([value[1], -fall], [lost[1], 0.0]);
        for k in 0..2 {
            let sum = value[k] + next[k];
            let of_next = sum - value[k];
            self.lost[k] = (lost[k] + passed[k]) + ((value[k] - (sum - of_next)) + (next[k] - of_next));
            self.value[k] = sum;
        }
        self.value[0] + self.lost[0]
    }

    /// The slope behind the last node.
    pub(super) fn slope(&self) -> f64 {
        self.value[1] + self.lost[1]
    }
}

#[cfg(test)]
mod tests {
    use super::Twice;

    /// Falls of one, after a hundred that cannot be told from a slope of 10¹⁶ without what rounding takes.
    #[test]
    fn nothing_is_lost() {
        let mut sums = Twice::default();
        let falls = std::iter::once(-1e16).chain([1.0; 100]).chain([1e16, 0.0]);
        let last = falls.map(|fall| sums.step(fall)).last();
        // 101 intervals with the steep slope; the k-th fall of one is felt in the 102 − k nodes behind it.
        let ones: f64 = (1..=100_i32).map(|k| f64::from(102 - k)).sum();
        assert_eq!(last.map(f64::to_bits), Some((101.0 * 1e16 - ones).to_bits()));
        assert_eq!(sums.slope().to_bits(), (-100.0_f64).to_bits());
    }
}
