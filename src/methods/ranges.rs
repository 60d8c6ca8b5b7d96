//! Ranges of values at the nodes of a grid, block by block: most questions about extremes need to look into few blocks.

use crate::state::Extremes;

/// Nodes in a block.
pub(super) const BLOCK: usize = 256;

/// Values at the inner nodes of a beam that has zero at both ends, with the greatest and the least one of each block.
pub(super) struct Ranges<'a> {
    values: &'a [f64],
    blocks: Vec<[f64; 2]>,
}

impl<'a> Ranges<'a> {
    /// One pass.
    pub(super) fn of(values: &'a [f64]) -> Self {
        Self { values, blocks: values.chunks(BLOCK).map(range).collect() }
    }

    /// The values.
    pub(super) fn values(&self) -> &'a [f64] {
        self.values
    }

    /// Greatest and least value of a block, if there is one.
    pub(super) fn block(&self, number: usize) -> Option<[f64; 2]> {
        self.blocks.get(number).copied()
    }

    /// The value at a node, the ends of the beam included.
    pub(super) fn at(&self, node: usize) -> f64 {
        if node == 0 || node == self.values.len() + 1 { 0.0 } else { self.values[node - 1] }
    }

    /// Extremes along the beam, with numbers of nodes for places.
    pub(super) fn extremes(&self) -> Extremes {
        let whole = self.blocks.iter().fold([0.0; 2], |whole, block| wider(whole, *block));
        Extremes::known(whole[0], whole[1], |extreme, equal| self.near(extreme, equal))
    }

    /// Pairs of node and value that show every stretch that comes within `equal` of a value: of blocks in which all do or none
    /// does the first and the last node are enough.
    fn near(&self, extreme: f64, equal: f64) -> impl Iterator<Item = (f64, f64)> + '_ {
        let blocks = self.values.chunks(BLOCK).zip(&self.blocks).enumerate().flat_map(move |(b, (values, range))| {
            let [max, min] = range.map(|value| (value - extreme).abs() <= equal);
            // If neither of the two does, some between them may.
            let alike = if max || min { max && min } else { (range[0] < extreme) == (range[1] < extreme) };
            let last = values.len() - 1;
            let (head, tail) = if alike && 0 < last { (&values[..1], &values[last..]) } else { (values, &values[..0]) };
            let first = b * BLOCK + 1;
            numbered(first, head).chain(numbered(first + last, tail))
        });
        let end = numbered(self.values.len() + 1, &[0.0]);
        numbered(0, &[0.0]).chain(blocks).chain(end)
    }
}

/// Values at node `first` and those behind it, with the number of the node for their place.
#[expect(clippy::cast_precision_loss, reason = "grids stay far below 2⁵³ nodes")]
fn numbered(first: usize, values: &[f64]) -> impl Iterator<Item = (f64, f64)> + '_ {
    values.iter().enumerate().map(move |(k, value)| ((first + k) as f64, *value))
}

/// Greatest and least of some values, which may be no numbers. Each of four lanes waits for itself only.
fn range(values: &[f64]) -> [f64; 2] {
    const LANES: usize = 4;
    let (mut max, mut min) = ([f64::NEG_INFINITY; LANES], [f64::INFINITY; LANES]);
    let (all, rest) = values.as_chunks::<LANES>();
    for four in all {
        for k in 0..LANES {
            [max[k], min[k]] = wider([max[k], min[k]], [four[k]; 2]);
        }
    }
    let lanes = max.into_iter().zip(min).map(|(max, min)| [max, min]);
    lanes.chain(rest.iter().map(|value| [*value; 2])).reduce(wider).unwrap_or_default()
}

/// Not `max` and `min`: a comparison is all that a number needs.
fn wider([max, min]: [f64; 2], [above, below]: [f64; 2]) -> [f64; 2] {
    [if max < above { above } else { max }, if below < min { below } else { min }]
}

#[cfg(test)]
mod tests {
    use super::{BLOCK, Ranges};
    use crate::state::Extremes;

    /// Plateaus within, across and at the ends of blocks, and equal peaks far apart.
    #[test]
    fn extremes_are_those_of_all_values_one_by_one() {
        let hill = |from: usize, to: usize, top: f64| {
            (1..=1000_usize).map(|i| if (from..=to).contains(&i) { top } else { 1e-3 * (i % 7) as f64 }).collect()
        };
        let mut cases: Vec<Vec<f64>> = vec![Vec::new(), vec![0.0; 3], vec![-1.0], vec![2.0; 2 * BLOCK]];
        for (from, to) in [(10, 10), (10, 20), (BLOCK, BLOCK), (BLOCK, BLOCK + 1), (200, 900), (1, 1000), (900, 1000)] {
            cases.extend([1.0, -1.0].map(|top| hill(from, to, top)));
        }
        let mut peaks: Vec<f64> = hill(3, 3, 1.0);
        peaks[700] = 1.0 + 1e-15;
        peaks[701] = 1.0;
        cases.push(peaks);
        for values in cases {
            let zero = std::iter::once(0.0);
            let all = zero.clone().chain(values.iter().copied()).chain(zero);
            let expected = Extremes::of((0_i32..).map(f64::from).zip(all).collect::<Vec<_>>());
            assert_eq!(Ranges::of(&values).extremes(), expected, "{} values", values.len());
        }
    }
}
