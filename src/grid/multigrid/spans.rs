//! Spans of any length in the time of a short one.

use crate::methods::span::Span;

/// Intervals of the shortest stored span. A query adds at most twice as many loads one by one.
const LEAF: usize = 32;

/// Spans of `LEAF · 2^k` intervals, `k = 0, 1, …`, from which every span is joined in O(log n).
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Spans {
    levels: Vec<Vec<Span>>,
}

impl Spans {
    /// The spans between the nodes that carry `loads`, including the two ends of the beam.
    pub(super) fn new(loads: &[f64]) -> Self {
        let leaves = (loads.len() - 1) / LEAF;
        let leaf = |k: usize| Span::summed(&loads[k * LEAF + 1..(k + 1) * LEAF]);
        let mut levels = vec![(0..leaves).map(leaf).collect::<Vec<_>>()];
        let mut reach = LEAF;
        while let Some(finer) = levels.last().filter(|finer| 2 <= finer.len()) {
            let pair = |(k, p): (usize, &[Span])| p[0].joined(p[1], loads[(2 * k + 1) * reach]);
            levels.push(finer.chunks_exact(2).enumerate().map(pair).collect());
            reach *= 2;
        }
        Self { levels }
    }

    /// The beam between two nodes, `first < last`, as a simple beam. Not inlined, because in dense contact the caller has only single
    /// intervals.
    #[inline(never)]
    pub(super) fn between(&self, loads: &[f64], first: usize, last: usize) -> Span {
        if last <= first + LEAF {
            return Span::summed(&loads[first + 1..last]);
        }
        let mut node = first.next_multiple_of(LEAF);
        let mut whole = (first < node).then(|| Span::summed(&loads[first + 1..node]));
        let mut join = |next: Span, node: usize| {
            whole = Some(whole.map_or(next, |whole| whole.joined(next, loads[node])));
        };
        while node + LEAF <= last {
            let mut level = 0;
            while node.is_multiple_of(LEAF << (level + 1)) && node + (LEAF << (level + 1)) <= last {
                level += 1;
            }
            join(self.levels[level][node / (LEAF << level)], node);
            node += LEAF << level;
        }
        if node < last {
            join(Span::summed(&loads[node + 1..last]), node);
        }
        whole.unwrap_or_default()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Against sums over all loads, for ends within, at and across the stored spans.
    #[test]
    fn joined_spans_are_one_span() {
        let loads: Vec<f64> = (0..=1000).map(|i| f64::from(1 + i % 7)).collect();
        let spans = Spans::new(&loads);
        for (first, last) in [(0, 1000), (0, 1), (31, 33), (5, 37), (5, 38), (32, 64), (1, 999), (500, 900), (63, 513)]
        {
            let (found, expected) = (spans.between(&loads, first, last), Span::under(&loads[first + 1..last]));
            assert_eq!(found.steps.to_bits(), expected.steps.to_bits(), "from {first} to {last}");
            for side in 0..2 {
                // A dozen joins, each with a few roundings of terms of one sign.
                let close = |x: f64, y: f64| (x - y).abs() <= 32.0 * f64::EPSILON * y;
                assert!(close(found.shares[side], expected.shares[side]), "{found:?} from {first} to {last}");
                assert!(close(found.rotations[side], expected.rotations[side]), "{found:?} from {first} to {last}");
            }
        }
    }
}
