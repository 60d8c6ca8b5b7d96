//! Windows: ranges of variables, each solved for itself while all others keep their side.
//!
//! A guess from a coarser grid is wrong only where runs of free variables end. Where a programme can solve a face
//! [near some variables](crate::problem::Programme::stationary_near), the programme *of the window* is (32) with the signs of its own
//! variables only: variables outside that are free may have any sign, and those at zero stay there. It is a programme of the
//! same kind with fewer constraints, so that whatever ends at the optimum of (32) ends at that of a window as well.

use std::ops::Range;

/// The windows of the variables within `reach` of some places, ascending, among n.
pub(super) fn around(places: &[usize], reach: usize, n: usize) -> Vec<Range<usize>> {
    merged(places.iter().map(|&i| widened(i..i + 1, reach, n)))
}

/// The places between which `free` changes, as variables.
pub(super) fn borders(free: &[bool]) -> Vec<usize> {
    free.windows(2).enumerate().filter(|(_, pair)| pair[0] != pair[1]).map(|(i, _)| i).collect()
}

/// A range with its neighbourhood among n variables.
pub(super) fn widened(range: Range<usize>, reach: usize, n: usize) -> Range<usize> {
    range.start.saturating_sub(reach)..(range.end + reach).min(n)
}

/// Ranges with ascending starts, those that overlap or touch put together.
pub(super) fn merged(ranges: impl Iterator<Item = Range<usize>>) -> Vec<Range<usize>> {
    let mut merged: Vec<Range<usize>> = Vec::new();
    for range in ranges {
        match merged.last_mut() {
            Some(last) if range.start <= last.end => last.end = last.end.max(range.end),
            _ => merged.push(range),
        }
    }
    merged
}
