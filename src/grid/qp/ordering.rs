//! The elimination order of the unknowns of a sparse matrix. Rows should be short from their first entry to the diagonal.
//!
//! Rows coupled to many others come last (Amestoy, Davis and Duff 1996). The others keep their order, or follow their neighbours
//! (Cuthill and McKee 1969, reversed by George 1971). A new order is used only if it saves half of all products, so that a banded
//! matrix keeps its own.

use super::Profile;

/// A row coupled to more than this many times `√n` others counts as full (Amestoy, Davis and Duff 1996).
const FULL: f64 = 10.0;

/// The neighbours of each unknown.
struct Graph {
    start: Vec<usize>,
    neighbours: Vec<usize>,
}

impl Graph {
    fn of(matrix: &Profile) -> Self {
        let n = matrix.dimension();
        let off_diagonal = || matrix.entries().filter(|(i, j, _)| i != j);
        let mut start = vec![0; n + 1];
        off_diagonal().for_each(|(i, j, _)| [i, j].iter().for_each(|k| start[k + 1] += 1));
        (0..n).for_each(|i| start[i + 1] += start[i]);
        let (mut next, mut neighbours) = (start.clone(), vec![0; start[n]]);
        for (i, j, _) in off_diagonal() {
            for (one, other) in [(i, j), (j, i)] {
                neighbours[next[one]] = other;
                next[one] += 1;
            }
        }
        Self { start, neighbours }
    }

    fn of_unknown(&self, i: usize) -> &[usize] {
        &self.neighbours[self.start[i]..self.start[i + 1]]
    }

    fn degree(&self, i: usize) -> usize {
        self.start[i + 1] - self.start[i]
    }

    /// Approximate number of products of a factorisation in the given order, counted as in [`Profile::products`].
    fn products(&self, order: &[usize]) -> usize {
        let mut place = vec![0; order.len()];
        order.iter().enumerate().for_each(|(k, i)| place[*i] = k);
        let length = |(k, i): (usize, &usize)| {
            let first = self.of_unknown(*i).iter().map(|j| place[*j]).min().unwrap_or(k);
            k + 1 - first.min(k)
        };
        order.iter().enumerate().map(length).map(|w| w * w / 2 + w).sum()
    }

    /// The unknowns that can be reached from one unknown, each after the neighbour from which it is reached. Neighbours with few
    /// neighbours come first.
    fn reached_from(&self, from: usize, is_open: &mut [bool]) -> Vec<usize> {
        let mut reached = vec![from];
        is_open[from] = false;
        let mut at = 0;
        while let Some(&i) = reached.get(at) {
            let mut next: Vec<usize> = self.of_unknown(i).iter().copied().filter(|j| is_open[*j]).collect();
            next.sort_by_key(|j| self.degree(*j));
            next.iter().for_each(|j| is_open[*j] = false);
            reached.extend(next);
            at += 1;
        }
        reached
    }

    /// The unknowns of `rest`, ordered so that neighbours follow each other.
    fn along(&self, rest: &[usize]) -> Vec<usize> {
        let mut is_open = vec![false; self.start.len() - 1];
        rest.iter().for_each(|i| is_open[*i] = true);
        let mut order = Vec::with_capacity(rest.len());
        for i in rest {
            if !is_open[*i] {
                continue;
            }
            // Starts at the far end of the connected part, which a first walk finds.
            let far = self.reached_from(*i, &mut is_open.clone()).last().copied().unwrap_or(*i);
            order.extend(self.reached_from(far, &mut is_open));
        }
        order.reverse();
        order
    }
}

/// The order in which unknowns are eliminated.
pub(super) fn elimination_order(matrix: &Profile) -> Vec<usize> {
    let n = matrix.dimension();
    let own: Vec<usize> = (0..n).collect();
    let products = matrix.products();
    // Neither a narrow band nor a full matrix has a better order.
    let [few, many] = [16 * n, n * n / 8];
    if products <= few || many < matrix.entries().count() {
        return own;
    }
    let graph = Graph::of(matrix);
    #[expect(clippy::cast_precision_loss, reason = "far below 2⁵³ rows")]
    let (full, rest): (Vec<usize>, Vec<usize>) =
        own.iter().partition(|i| FULL * (n as f64).sqrt() < graph.degree(**i) as f64);
    let last = |rest: Vec<usize>| [rest, full.clone()].concat();
    let others = [last(rest.clone()), last(graph.along(&rest))];
    let best = others.into_iter().min_by_key(|order| graph.products(order));
    best.filter(|order| 2 * graph.products(order) < products).unwrap_or(own)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A chain coupled to its first unknown everywhere, and a chain with scrambled numbers: both are eliminated without fill.
    #[test]
    fn arrows_and_shuffled_chains_are_narrow() {
        let n = 400;
        let arrow =
            (1..n).map(|i| (i, 0, 1.0)).chain((2..n).map(|i| (i, i - 1, 1.0))).chain((0..n).map(|i| (i, i, 4.0)));
        let arrow = Profile::of_entries(n, arrow.collect::<Vec<_>>().into_iter());
        let shuffled = |k: usize| k * 171 % n;
        let links = (0..n).map(|k| [shuffled(k), shuffled(k + 1)]).take(n - 1);
        let chain = links.map(|[a, b]| (a.max(b), a.min(b), 1.0)).chain((0..n).map(|i| (i, i, 4.0)));
        let chain = Profile::of_entries(n, chain.collect::<Vec<_>>().into_iter());
        for (name, matrix) in [("arrow", arrow), ("chain", chain)] {
            let order = elimination_order(&matrix);
            let mut sorted = order.clone();
            sorted.sort_unstable();
            assert!(sorted.into_iter().eq(0..n), "{name}: each unknown once");
            let part = matrix.part(&order, 0.0);
            // A full last row has n²/2 products, and a band few.
            assert!(part.products() < n * n / 2 + 10 * n, "{name}: {} products", part.products());
            assert!(100 * part.products() < 30 * matrix.products(), "{name}: of {}", matrix.products());
        }
    }
}
