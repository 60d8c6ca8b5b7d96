//! Double sums over a grid: forces to moments, curvatures to deflections.
//!
//! ```text
//! y_i = y_{i−1} + s_{i−1},   s_i = s_{i−1} − f_i,      y_0 = 0, s_0 given
//! ```
//!
//! A million roundings of a slope would be a million times larger in the height. So within a short block slopes and heights
//! count from its beginning, where they are small, and from block to block both sums keep what rounding takes from them, as
//! in Kahan's and Neumaier's sums; the slope passes its share on.

/// Nodes in a block: a power of two, so that the way which a slope rises over a block is exact.
const BLOCK: usize = 16;

/// Height and slope on the way along a grid.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Twice {
    height: Sum,
    slope: Sum,
}

impl Twice {
    /// At node 0, with a slope.
    pub(super) fn rising(slope: f64) -> Self {
        Self { height: Sum::default(), slope: Sum { value: slope, lost: 0.0 } }
    }

    /// Over the next nodes: what the slope loses at each of them gives way to the height there.
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
        // What falls in the block have taken from slope and height.
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

    /// The slope behind the last node.
    pub(super) fn slope(&self) -> f64 {
        self.slope.total()
    }

    /// The height one node further on.
    pub(super) fn next(mut self) -> f64 {
        let mut height = [0.0];
        self.along(&mut height);
        height[0]
    }
}

/// A sum, and what rounding has taken from it.
#[derive(Debug, Clone, Copy, Default)]
struct Sum {
    value: f64,
    lost: f64,
}

impl Sum {
    /// Adds a number; `lost` gets the exact error of the addition (Knuth's two-sum).
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
    use super::Twice;

    /// Falls of one, on a slope of 10¹⁶ that cannot be told from what they leave of it unless nothing is lost.
    #[test]
    fn nothing_is_lost() {
        let mut sums = Twice::rising(1e16);
        sums.along(&mut [1.0; 100]);
        sums.along(&mut [1e16]);
        // 101 intervals with the steep slope; the k-th fall of one is felt in the 102 − k nodes behind it.
        let ones: f64 = (1..=100_i32).map(|k| f64::from(102 - k)).sum();
        assert_eq!(sums.next().to_bits(), (101.0 * 1e16 - ones).to_bits());
        assert_eq!(sums.slope().to_bits(), (-100.0_f64).to_bits());
    }

    /// Falls of a third from a slope that brings the right end back: a parabola `y_i = f i (N − i)/2`, to a few units in the
    /// last place of its height, on a grid of any size.
    #[test]
    fn uniform_falls_make_a_parabola() {
        /// Of the slope that is given, of a sum of sixteen, of two products.
        const UNITS: f64 = 4.0;
        let fall = 1.0 / 3.0;
        for n in [1, 15, 16, 17, 1000, 300_000_u32] {
            let number = f64::from(n);
            let mut sums = Twice::rising(fall * number / 2.0);
            let mut heights = vec![fall; n as usize];
            heights.chunks_mut(256).for_each(|batch| sums.along(batch));
            let most = fall * (number + 1.0) * (number + 1.0) / 8.0;
            for (i, y) in (1..).map(f64::from).zip(heights) {
                let exact = fall * i * (number + 1.0 - i) / 2.0;
                assert!((y - exact).abs() <= UNITS * f64::EPSILON * most, "{y} instead of {exact} at {i} of {n}");
            }
        }
    }
}
