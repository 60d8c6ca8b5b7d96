//! Windows: a few ranges of variables, solved for themselves while all others keep their side.
//!
//! A guess from a coarser grid is wrong only where runs of free variables end. Where a programme can solve a face
//! [near some variables](Programme::stationary_near), the programme *of the window* is (32) with the signs of its own
//! variables only: variables outside that are free may have any sign, and those at zero stay there. It is a programme of the
//! same kind with fewer constraints, so that whatever ends at the optimum of (32) ends at that of a window as well.

use std::ops::Range;

use crate::problem::{NotPositiveDefinite, Programme, Stationary};

/// A share `1/WORTH` of all variables in windows is the most with which a round costs much less than a solve of the whole.
const WORTH: usize = 4;

/// Some of the variables of a programme.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Window {
    /// Ascending, not empty, with gaps between them.
    pub(super) ranges: Vec<Range<usize>>,
}

impl Window {
    /// All n variables.
    pub(super) fn whole(n: usize) -> Self {
        Self { ranges: std::iter::once(0..n).collect() }
    }

    /// The variables within `reach` of some places, ascending, among n.
    pub(super) fn around(places: &[usize], reach: usize, n: usize) -> Self {
        Self { ranges: merged(places.iter().map(|&i| widened(i..i + 1, reach, n))) }
    }

    /// One range.
    pub(super) fn of(range: Range<usize>) -> Self {
        Self { ranges: std::iter::once(range).collect() }
    }

    /// The variables of both.
    pub(super) fn with(&self, other: &Self) -> Self {
        let mut ranges: Vec<_> = self.ranges.iter().chain(&other.ranges).cloned().collect();
        ranges.sort_by_key(|range| range.start);
        Self { ranges: merged(ranges.into_iter()) }
    }

    /// Number of variables.
    pub(super) fn len(&self) -> usize {
        self.ranges.iter().map(Range::len).sum()
    }

    /// Whether solving it costs much less than solving all n.
    pub(super) fn is_worth_it(&self, n: usize) -> bool {
        WORTH * self.len() <= n
    }

    /// The variables.
    pub(super) fn places(&self) -> impl Iterator<Item = usize> + '_ {
        self.ranges.iter().cloned().flatten()
    }

    /// Step 1° of the paper's algorithm on a face, at the variables of the window only.
    pub(super) fn minimum_on(
        &self,
        programme: &dyn Programme,
        free: &[bool],
    ) -> Result<Stationary, NotPositiveDefinite> {
        if self.len() == free.len() {
            return programme.stationary(free);
        }
        let mut all: Option<Stationary> = None;
        for range in &self.ranges {
            let Some(part) = programme.stationary_near(free, range.clone()) else {
                let whole = programme.stationary(free)?;
                let chosen = |values: &[f64]| self.places().map(|i| values[i]).collect();
                return Ok(Stationary { x: chosen(&whole.x), gradient: chosen(&whole.gradient) });
            };
            let part = part?;
            match &mut all {
                None => all = Some(part),
                Some(all) => {
                    all.x.extend(part.x);
                    all.gradient.extend(part.gradient);
                }
            }
        }
        Ok(all.unwrap_or(Stationary { x: Vec::new(), gradient: Vec::new() }))
    }
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
