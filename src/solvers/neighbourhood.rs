//! Exchanges in the neighbourhood of the border between free variables and those at zero.
//!
//! A guess from a coarser grid is wrong only where runs of free variables end. Where a programme can solve a face
//! [near some variables](Programme::stationary_near), full exchanges go on in a window around each border, and only there,
//! until no window has a violator. A window grows where violators come near its edge.
//!
//! *It proves nothing by itself, and need not.* It changes the face, in finitely many rounds, before the next solve of the
//! whole; that solve looks at every variable, and only what passes it is called optimal.

use std::ops::Range;

use super::active_set::violators;
use crate::problem::Programme;

/// Variables on both sides of a border or a violator that are looked at: the spacing of one grid in the next, a few times.
const REACH: usize = 32;

/// Rounds without fewer violators before the whole has to decide. As for full exchanges, around ten.
const PATIENCE: usize = 10;

/// A share `1/WORTH` of all variables in windows is the most with which a round costs much less than a solve of the whole.
const WORTH: usize = 4;

/// The places between which `free` changes, as variables.
pub(super) fn borders(free: &[bool]) -> Vec<usize> {
    free.windows(2).enumerate().filter(|(_, pair)| pair[0] != pair[1]).map(|(i, _)| i).collect()
}

/// Exchanges around `places`, ascending. Returns the number of solves, none if the programme has no neighbourhoods.
pub(super) fn settle(programme: &dyn Programme, free: &mut [bool], places: &[usize]) -> usize {
    let n = free.len();
    let mut windows = merged(places.iter().map(|&i| around(i..i + 1, n)));
    let (mut solves, mut fewest, mut patience) = (0, usize::MAX, PATIENCE);
    while !windows.is_empty() && windows.iter().map(Range::len).sum::<usize>() <= n / WORTH && 0 < patience {
        let (mut unsettled, mut count) = (Vec::new(), 0);
        for window in windows {
            let Some(Ok(point)) = programme.stationary_near(free, window.clone()) else { return solves };
            solves += 1;
            let wrong = violators(programme, &point, &free[window.clone()]);
            if let [first, .., _] | [first] = wrong[..] {
                let last = wrong[wrong.len() - 1];
                count += wrong.len();
                wrong.iter().for_each(|i| free[window.start + i] = !free[window.start + i]);
                let seen = around(window.start + first..window.start + last + 1, n);
                unsettled.push(seen.start.min(window.start)..seen.end.max(window.end));
            }
        }
        if count < fewest {
            (fewest, patience) = (count, PATIENCE);
        } else {
            patience -= 1;
        }
        windows = merged(unsettled.into_iter());
    }
    solves
}

/// A range with its neighbourhood among n variables.
fn around(range: Range<usize>, n: usize) -> Range<usize> {
    range.start.saturating_sub(REACH)..(range.end + REACH).min(n)
}

/// Ranges with ascending starts, those that overlap put together.
fn merged(ranges: impl Iterator<Item = Range<usize>>) -> Vec<Range<usize>> {
    let mut merged: Vec<Range<usize>> = Vec::new();
    for range in ranges {
        match merged.last_mut() {
            Some(last) if range.start <= last.end => last.end = last.end.max(range.end),
            _ => merged.push(range),
        }
    }
    merged
}
