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

/// Exchanges around `places`, ascending; when they have come to rest, a wider look around all borders. Returns the number
/// of solves, none if the programme has no neighbourhoods.
///
/// The wider look reaches `√n` variables: behind a place where contact ends, the discrete optimum has a hole of that length.
pub(super) fn settle(programme: &dyn Programme, free: &mut [bool], places: &[usize]) -> usize {
    let n = free.len();
    let mut patience = Patience::new();
    let mut solves = rest(programme, free, windows(places, REACH, n));
    loop {
        let (found, wide) = look(programme, free, &windows(&borders(free), n.isqrt(), n));
        solves += wide;
        if found.is_empty() || !patience.with(found.len()) {
            return solves;
        }
        found.iter().for_each(|&i| free[i] = !free[i]);
        solves += rest(programme, free, windows(&found, REACH, n));
    }
}

/// Rounds that may still pass without fewer violators than ever before.
struct Patience {
    fewest: usize,
    left: usize,
}

impl Patience {
    fn new() -> Self {
        Self { fewest: usize::MAX, left: PATIENCE }
    }

    /// Whether a round with `count` violators may be followed by another.
    fn with(&mut self, count: usize) -> bool {
        if count < self.fewest {
            (self.fewest, self.left) = (count, PATIENCE);
        } else {
            self.left -= 1;
        }
        0 < self.left
    }
}

/// Exchanges in windows until none has a violator; windows grow where violators come near their edges.
fn rest(programme: &dyn Programme, free: &mut [bool], mut windows: Vec<Range<usize>>) -> usize {
    let mut patience = Patience::new();
    let n = free.len();
    let mut solves = 0;
    while !windows.is_empty() {
        let (mut unsettled, mut count) = (Vec::new(), 0);
        for window in windows {
            let (found, tried) = look(programme, free, std::slice::from_ref(&window));
            solves += tried;
            if let (Some(&first), Some(&last)) = (found.first(), found.last()) {
                count += found.len();
                found.iter().for_each(|&i| free[i] = !free[i]);
                let seen = around(first..last + 1, REACH, n);
                unsettled.push(seen.start.min(window.start)..seen.end.max(window.end));
            }
        }
        if !patience.with(count) {
            return solves;
        }
        windows = merged(unsettled.into_iter());
    }
    solves
}

/// Violators in some windows, ascending, and the number of solves; none of either if that is not worth it.
fn look(programme: &dyn Programme, free: &[bool], windows: &[Range<usize>]) -> (Vec<usize>, usize) {
    let (mut found, mut solves) = (Vec::new(), 0);
    if free.len() < WORTH * windows.iter().map(Range::len).sum::<usize>() {
        return (found, solves);
    }
    for window in windows {
        let Some(Ok(point)) = programme.stationary_near(free, window.clone()) else { break };
        solves += 1;
        found.extend(violators(programme, &point, &free[window.clone()]).iter().map(|i| window.start + i));
    }
    (found, solves)
}

/// Windows around places among n variables.
fn windows(places: &[usize], reach: usize, n: usize) -> Vec<Range<usize>> {
    merged(places.iter().map(|&i| around(i..i + 1, reach, n)))
}

/// A range with its neighbourhood among n variables.
fn around(range: Range<usize>, reach: usize, n: usize) -> Range<usize> {
    range.start.saturating_sub(reach)..(range.end + reach).min(n)
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
