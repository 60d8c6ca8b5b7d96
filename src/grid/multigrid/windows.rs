//! Windows: ranges of variables, each solved separately while all other variables keep their side.
//!
//! A guess from a coarser grid is wrong only where runs of contact end. The quadratic program *of the window* is (32) with the sign
//! constraints of its own variables only. Free variables outside the window may have any sign, and the others outside stay at zero.
//! It is of the same kind as (32) with fewer constraints, so every method that reaches the optimum of (32) also reaches the optimum
//! of a window.
//!
//! Windows around borders and violators are made optimal separately, by a [descent](crate::solvers::active_set). They are widened as
//! long as variables next to them are on the wrong side, but in the first rounds not far, because one window may disturb another.
//! This needs a small part of the time of a solve of the whole. Each time that exchanges of the whole do not end, windows reach twice
//! as far, until one window contains all variables. Its optimum is that of (32).

use std::ops::Range;

use super::Cost;
use super::local_beam::LocalBeam;
use crate::qp::{FreeSet, NotPositiveDefinite, Stationary};
use crate::solvers::MOST_WORK;
use crate::solvers::active_set::{PATIENCE, Reduced, descend, exchange, optimum, solves_within, violators};

/// Variables on both sides of a border or a violator in its first window: a few times the spacing of one grid in the next.
const REACH: usize = 32;

/// Rounds of separate windows. Most windows settle in one or two rounds; the influence of a window decreases geometrically with distance.
const ROUNDS: usize = 10;

/// Windows count as local if one solve of each costs less than this fraction, `1/LOCAL`, of a solve of the whole.
const LOCAL: usize = 2;

/// The largest work of windows, in solves of the whole: for windows around borders, which may all be right, and for the first windows
/// where exchanges do not end.
const BUDGET: [usize; 2] = [1, 8];

/// The overhead of a solve of a window, in variables.
const SOLVE: usize = 200;

/// The windows of a beam, and their cost so far.
pub(super) struct Windows<'a> {
    pub(super) beam: &'a LocalBeam<'a>,
    pub(super) cost: &'a mut Cost,
}

impl Windows<'_> {
    /// Turns a guess of the contact into one that is optimal near its borders, or otherwise everywhere.
    pub(super) fn guess(&mut self, free: &mut FreeSet) {
        if !self.solve_borders(free) {
            // A solve that fails here fails again on the finest grid, which returns the error.
            let _ = self.exchanged(free);
        }
    }

    /// The optimum of the whole, and whether no variable is on the wrong side.
    pub(super) fn optimum(&mut self, free: &mut FreeSet) -> Result<(Stationary, bool), NotPositiveDefinite> {
        self.solve_borders(free);
        self.exchanged(free)
    }

    /// The optimum of the whole by exchanges, by windows where exchanges do not end, and by a descent where windows do not.
    fn exchanged(&mut self, free: &mut FreeSet) -> Result<(Stationary, bool), NotPositiveDefinite> {
        let (n, beam) = (free.dimension(), self.beam);
        let (mut idle, mut scale, mut solves) = (0, 1, 0);
        let mut whole = Reduced {
            point: Box::new(|free| beam.point(free, 0..n)),
            make_definite: Box::new(|free| beam.hold(free)),
            most_solves: self.left(n),
        };
        let end = optimum(&mut whole, free, &mut solves, |free, wrong| {
            let windows = around(wrong, scale * REACH, n);
            if self.left(n) == 0 {
                return Ok(false);
            } else if n < LOCAL * price(&windows) && idle < PATIENCE {
                idle += 1;
            } else if scale * REACH < n {
                self.solve_windows(free, windows, scale * BUDGET[1]);
                scale *= 2;
            } else {
                return Ok(false);
            }
            Ok(true)
        });
        self.cost.whole += solves;
        self.cost.work += solves * n;
        end
    }

    /// Makes windows around the borders optimal if that is cheap. Returns whether there were any and all settled.
    fn solve_borders(&mut self, free: &mut FreeSet) -> bool {
        self.beam.hold(free);
        let windows = around(&borders(free), REACH, free.dimension());
        if windows.is_empty() || free.dimension() < price(&windows) {
            return false;
        }
        self.solve_windows(free, windows, BUDGET[0])
    }

    /// Makes windows optimal, together with as much of their surroundings as changes with them, in the work of `budget` solves of the
    /// whole. Returns whether all settled.
    fn solve_windows(&mut self, free: &mut FreeSet, windows: Vec<Range<usize>>, budget: usize) -> bool {
        let settled = self.settle(free, windows, budget).unwrap_or(false);
        // A window may have dropped the contacts that hold the beam. Any other failure occurs again in the solve of the whole, which
        // returns it.
        self.beam.hold(free);
        settled
    }

    /// The same, with an error if the contacts no longer hold the beam or a number is not finite.
    fn settle(
        &mut self,
        free: &mut FreeSet,
        windows: Vec<Range<usize>>,
        budget: usize,
    ) -> Result<bool, NotPositiveDefinite> {
        let spent = |cost: &Cost| cost.work + SOLVE * cost.windows;
        let n = free.dimension();
        let most = spent(self.cost) + budget * n;
        let mut pending = windows;
        for round in 0..ROUNDS {
            let mut settled = Vec::new();
            for range in pending {
                // A violator far away may be due to a window that is not solved yet, so the range is limited in this round.
                let longest = (4 * REACH).max(range.len()) << round;
                settled.push(self.solve_window(free, range, longest)?);
                if most < spent(self.cost) || self.left(n) == 0 {
                    return Ok(false);
                }
            }
            settled.sort_by_key(|range| range.start);
            pending = Vec::new();
            for range in merged(settled.into_iter()) {
                if !self.check(free, &range)?.1.is_empty() {
                    pending.push(range);
                }
            }
            if pending.is_empty() {
                return Ok(true);
            }
        }
        Ok(false)
    }

    /// Makes a range optimal, and widens it until nothing next to it is on the wrong side or it exceeds a length.
    ///
    /// At least `√n` variables next to it are checked. Behind a position where contact ends, the discrete optimum has a hole of that
    /// length.
    fn solve_window(
        &mut self,
        free: &mut FreeSet,
        mut range: Range<usize>,
        longest: usize,
    ) -> Result<Range<usize>, NotPositiveDefinite> {
        let n = free.dimension();
        while range.len() <= longest && 0 < self.left(n) {
            // If rounding keeps a descent from ending, it would do so again.
            if !self.descended(free, &range)? {
                break;
            }
            let wider = widened(range.clone(), range.len().max(n.isqrt()), n);
            let (point, wrong) = self.check(free, &wider)?;
            let (Some(first), Some(last)) = (wrong.first(), wrong.last()) else { break };
            exchange(free, wider.start, &wrong, &point.gradient);
            let seen = widened(wider.start + first..wider.start + last + 1, REACH, n);
            range = range.start.min(seen.start)..range.end.max(seen.end);
        }
        Ok(range)
    }

    /// Makes a range optimal by a descent. Returns whether it ended at an optimum.
    fn descended(&mut self, free: &mut FreeSet, range: &Range<usize>) -> Result<bool, NotPositiveDefinite> {
        let (beam, mut solves, mut local) = (self.beam, 0, free.part(range.clone()));
        let most_solves = self.left(range.len());
        let on_range = |local: &FreeSet| {
            free.replace(range.start, local);
            beam.point(free, range.clone())
        };
        // Whether the contacts hold the beam is checked after all windows are solved.
        let mut window = Reduced { point: Box::new(on_range), make_definite: Box::new(|_| {}), most_solves };
        let end = descend(&mut window, &mut local, &mut solves);
        drop(window);
        free.replace(range.start, &local);
        let whole = range.len() == free.dimension();
        *(if whole { &mut self.cost.whole } else { &mut self.cost.windows }) += solves;
        self.cost.work += solves * range.len();
        end.map(|(_, optimal)| optimal)
    }

    /// The number of solves of `n` variables that the budget of a run still allows.
    fn left(&self, n: usize) -> usize {
        solves_within(MOST_WORK.saturating_sub(self.cost.work), n)
    }

    /// Solves a range without changing it: the point, and its variables on the wrong side.
    fn check(&mut self, free: &FreeSet, range: &Range<usize>) -> Result<(Stationary, Vec<usize>), NotPositiveDefinite> {
        self.cost.windows += 1;
        self.cost.work += range.len();
        let point = self.beam.point(free, range.clone())?;
        let wrong = violators(&point, &free.part(range.clone()));
        Ok((point, wrong))
    }
}

/// The cost of one solve of each window, in variables.
fn price(windows: &[Range<usize>]) -> usize {
    windows.iter().map(|range| range.len() + SOLVE).sum()
}

/// The windows of the variables within `reach` of the given ones, ascending, among n.
fn around(places: &[usize], reach: usize, n: usize) -> Vec<Range<usize>> {
    merged(places.iter().map(|&i| widened(i..i + 1, reach, n)))
}

/// The last variable before each change between free and not free, among n.
fn borders(free: &FreeSet) -> Vec<usize> {
    let ends = free.runs().flat_map(|run| [run.start.wrapping_sub(1), run.end - 1]);
    ends.filter(|&i| i != usize::MAX && i + 1 < free.dimension()).collect()
}

/// A range with its neighbourhood among n variables.
fn widened(range: Range<usize>, reach: usize, n: usize) -> Range<usize> {
    range.start.saturating_sub(reach)..(range.end + reach).min(n)
}

/// Merges ranges with ascending starts where they overlap or touch.
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
