//! Double sums that lose no digits on fine grids, from forces to moments and from curvatures to deflections:
//!
//! ```text
//! y_i = y_{i−1} + s_{i−1},   s_i = s_{i−1} − f_i,      y_0 = 0, s_0 given
//! ```
//!
//! A million rounding errors of a slope would be a million times larger in the height. So within a short block slopes and heights are
//! counted from the start of the block, where they are small. From block to block both sums keep their rounding errors, as in Kahan's
//! and Neumaier's sums, and the error of the slope is passed on to the height.

/// The current state of a double sum.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct DoubleSum {
    height: Sum,
    slope: Sum,
}

/// Nodes in a block: a power of two, so that the product of slope and block length is exact.
const BLOCK: usize = 16;

impl DoubleSum {
    /// Starts with a height and a slope.
    pub(super) fn from(height: f64, slope: f64) -> Self {
        let sum = |value| Sum { value, lost: 0.0 };
        Self { height: sum(height), slope: sum(slope) }
    }

    /// Continues over the next nodes: replaces the decrease of the slope at each node by the height there.
    pub(super) fn along(&mut self, falls: &mut [f64]) {
        let (blocks, rest) = falls.as_chunks_mut::<BLOCK>();
        blocks.iter_mut().for_each(|block| self.block(block));
        rest.as_chunks_mut::<1>().0.iter_mut().for_each(|single| self.block(single));
    }

    /// The same for a number of nodes that is a power of two.
    #[inline]
    #[expect(clippy::cast_precision_loss, reason = "a block is short")]
    fn block<const NODES: usize>(&mut self, falls: &mut [f64; NODES]) {
        let (from, rise) = (self.height.total(), self.slope.total());
        // The decreases of slope and height within the block.
        let (mut steep, mut deep) = (0.0, 0.0);
        for (k, y) in falls.iter_mut().enumerate() {
            let fall = *y;
            deep += steep;
            steep += fall;
            *y = (from + (k + 1) as f64 * rise) - deep;
        }
        let nodes = NODES as f64;
        self.height.add(nodes * self.slope.value);
        self.height.lost += nodes * self.slope.lost;
        self.height.add(-deep);
        self.slope.add(-steep);
    }

    /// The slope after the last node.
    pub(super) fn slope(self) -> f64 {
        self.slope.total()
    }

    /// The height at the last node.
    pub(super) fn height(self) -> f64 {
        self.height.total()
    }

    /// Raises the height from here on.
    pub(super) fn raise(&mut self, by: f64) {
        self.height.add(by);
    }
}

/// A sum and its accumulated rounding error.
#[derive(Debug, Clone, Copy, Default)]
struct Sum {
    value: f64,
    lost: f64,
}

impl Sum {
    /// Adds a number; `lost` accumulates the exact error of the addition (Knuth's two-sum).
    fn add(&mut self, next: f64) {
        let sum = self.value + next;
        let of_next = sum - self.value;
        self.lost += (self.value - (sum - of_next)) + (next - of_next);
        self.value = sum;
    }

    fn total(self) -> f64 {
        self.value + self.lost
    }
}

#[cfg(test)]
mod tests {
    use super::{DoubleSum, Sum};

    /// Decreases of one, on a slope of 10¹⁶ that is changed by them only if no digit is lost.
    #[test]
    fn nothing_is_lost() {
        let mut sums = DoubleSum { slope: Sum { value: 1e16, lost: 0.0 }, ..DoubleSum::default() };
        sums.along(&mut [1.0; 100]);
        sums.along(&mut [1e16]);
        // 101 intervals with the steep slope; the k-th decrease of one lowers the 102 − k nodes after it.
        let ones: f64 = (1..=100_i32).map(|k| f64::from(102 - k)).sum();
        sums.along(&mut [0.0]);
        assert_eq!(sums.height().to_bits(), (101.0 * 1e16 - ones).to_bits());
        assert_eq!(sums.slope.total().to_bits(), (-100.0_f64).to_bits());
    }

    /// Decreases of a third between two supports: a parabola `y_i = f i (N − i)/2`, to a few units in the last place of its height, on a
    /// grid of any size, with the slope `f (N − 1)/2` at the left end.
    #[test]
    fn uniform_falls_make_a_parabola() {
        /// Rounding of the computed slope, of a sum of sixteen numbers and of two products.
        const UNITS: f64 = 4.0;
        let fall = 1.0 / 3.0;
        for n in [1, 15, 16, 17, 1000, 300_000_u32] {
            let number = f64::from(n);
            let mut heights = vec![fall; n as usize];
            let mut shot = DoubleSum::default();
            shot.along(&mut heights.clone());
            let sum = -shot.slope();
            shot.along(&mut [0.0]);
            let slope = -shot.height() / (number + 1.0);
            DoubleSum::from(0.0, slope).along(&mut heights);
            assert!((slope - fall * number / 2.0).abs() <= UNITS * f64::EPSILON * slope, "{slope} of {n}");
            assert!((sum - fall * number).abs() <= UNITS * f64::EPSILON * sum, "{sum} of {n}");
            let most = fall * (number + 1.0) * (number + 1.0) / 8.0;
            for (i, y) in (1..).map(f64::from).zip(heights) {
                let exact = fall * i * (number + 1.0 - i) / 2.0;
                assert!((y - exact).abs() <= UNITS * f64::EPSILON * most, "{y} instead of {exact} at {i} of {n}");
            }
        }
    }
}
