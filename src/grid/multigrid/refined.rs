//! Transfers contact to a finer grid.

use std::ops::Range;

use crate::qp::FreeSet;

/// The longest run of nodes in contact that is an edge: the one or two nodes of a concentrated force, and one node next to them.
const EDGE: usize = 3;
/// The longest hole behind an edge: the one or two nodes with almost no contact force, doubled for the error of a coarse grid.
const HOLE: usize = 4;

/// Contact on a grid of `intervals`, from contact on a coarser one. The variables are the contact forces at all nodes except the ends
/// that are `held`.
///
/// At lift-off a contact zone begins with a concentrated force. One or two nodes of any grid carry it, and the next one or two carry
/// nothing. So edges keep their number of nodes, around the same position, and the holes behind them keep theirs. All nodes between
/// are in contact.
pub(super) fn refined(contact: &FreeSet, intervals: usize, held: [bool; 2]) -> FreeSet {
    let [first, last] = held.map(usize::from);
    let finer = Finer { coarse: contact.dimension() + first + last - 1, nodes: first..intervals + 1 - last, intervals };
    let mut fine = FreeSet::none(finer.nodes.len());
    let runs: Vec<_> = contact.runs().map(|run| run.start + first..run.end + first).collect();
    for zone in runs.chunk_by(|run, next| next.start <= run.end + HOLE) {
        let left = finer.run(&zone[0], Inward::Right);
        let right = zone[1..].last().map_or(left.clone(), |last| finer.run(last, Inward::Left));
        // The zone behind an edge begins after its hole.
        let mut inner = left.start..right.end;
        if let [edge, next, ..] = zone
            && edge.len() <= EDGE
        {
            inner.start = left.end + (next.start - edge.end);
        }
        if let [.., before, edge] = zone
            && edge.len() <= EDGE
        {
            inner.end = right.start.saturating_sub(edge.start - before.end);
        }
        for nodes in [left, inner, right] {
            let indices = nodes.start.saturating_sub(first)..nodes.end.min(finer.nodes.end) - first;
            if indices.start < indices.end {
                fine.release(indices);
            }
        }
    }
    fine
}

/// The side of an edge on which its zone lies.
#[derive(Clone, Copy, PartialEq)]
enum Inward {
    Left,
    Right,
}

/// Converts positions on one grid to positions on a finer one.
struct Finer {
    coarse: usize,
    intervals: usize,
    /// The nodes that may be in contact.
    nodes: Range<usize>,
}

impl Finer {
    /// The nodes of a run: as many around the same middle if the run is short, otherwise those between the nodes nearest to its ends.
    fn run(&self, run: &Range<usize>, inward: Inward) -> Range<usize> {
        if EDGE < run.len() {
            return self.nearest(run.start)..self.nearest(run.end - 1) + 1;
        }
        // Twice the middle, because it may lie between two nodes. Of two choices the one nearer to the zone.
        let middle = (run.start + run.end - 1) * self.intervals;
        let twice = if inward == Inward::Right { middle / self.coarse + 1 } else { middle.div_ceil(self.coarse) };
        let first = (twice.saturating_sub(run.len() - 1) / 2).clamp(self.nodes.start, self.nodes.end - run.len());
        first..first + run.len()
    }

    /// The node nearest to a node of the coarser grid, among those that may be in contact.
    fn nearest(&self, node: usize) -> usize {
        ((2 * node * self.intervals + self.coarse) / (2 * self.coarse)).clamp(self.nodes.start, self.nodes.end - 1)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Edges of one or two nodes and the holes behind them keep their length, whichever side the zone is on. Long runs are scaled,
    /// and so are all positions.
    #[test]
    fn edges_keep_their_length() {
        let flags = |runs: &[(usize, bool)]| -> FreeSet {
            runs.iter().flat_map(|&(length, touches)| std::iter::repeat_n(touches, length)).collect()
        };
        let (on, off) = (true, false);
        for (coarse, fine) in [
            // Nodes 17 and 18 of 75 intervals, a hole, and the zone: 35 and 36 of 150.
            (
                flags(&[(16, off), (2, on), (1, off), (36, on), (1, off), (2, on), (16, off)]),
                flags(&[(34, off), (2, on), (1, off), (75, on), (1, off), (2, on), (34, off)]),
            ),
            // One node stays one node, at the same position.
            (flags(&[(9, off), (1, on), (29, off)]), flags(&[(19, off), (1, on), (59, off)])),
            // A zone without edges, and one over all inner nodes.
            (flags(&[(9, off), (20, on), (10, off)]), flags(&[(19, off), (39, on), (21, off)])),
            (flags(&[(39, on)]), flags(&[(1, off), (77, on), (1, off)])),
            // No contact.
            (flags(&[(39, off)]), flags(&[(79, off)])),
        ] {
            assert_eq!(refined(&coarse, fine.dimension() + 1, [true; 2]), fine);
        }
    }

    /// A guess has as many flags as its grid has inner nodes, for any coarse contact.
    #[test]
    fn any_contact_can_be_refined() {
        for pattern in 0..1_u32 << 9 {
            let contact: FreeSet = (0..9).map(|k| pattern >> k & 1 == 1).collect();
            for intervals in [20, 21, 23, 80, 87] {
                let fine = refined(&contact, intervals, [true; 2]);
                assert_eq!(fine.dimension(), intervals - 1);
                assert_eq!(fine.iter().any(|touches| touches), pattern != 0, "{contact:?} on {intervals} intervals");
            }
        }
    }

    /// If an end has no support, its node may be in contact, and a zone that reaches the end continues to it.
    #[test]
    fn free_ends_may_be_in_contact() {
        for held in [[false, false], [false, true], [true, false]] {
            let nodes = |intervals: usize| intervals + 1 - usize::from(held[0]) - usize::from(held[1]);
            let everywhere = refined(&FreeSet::all(nodes(40)), 80, held);
            // On one side the node next to a support has no counterpart on the coarser grid.
            let last = nodes(80) - 1;
            let touches = |k: usize| (0 < k || !held[0]) && (k < last || !held[1]);
            assert_eq!(everywhere, (0..=last).map(touches).collect(), "{held:?}");
            let nowhere = refined(&FreeSet::none(nodes(40)), 80, held);
            assert_eq!(nowhere, FreeSet::none(nodes(80)), "{held:?}");
        }
    }
}
