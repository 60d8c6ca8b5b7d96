//! An active set that goes on where the paper's four steps stop, and always ends.
//!
//! The four steps drop variables one by one and never release one. Here variables are also released where the gradient is
//! negative, and many change at a time.
//!
//! **Exchanges.** From one face to the next all free variables that came out negative are dropped, and of each run of
//! neighbours with a negative gradient the steepest one is released, as long as runs on the wrong side become fewer. In dense
//! contact ten exchanges settle most of a face. What is left goes round in circles, at a few places.
//!
//! **Windows.** Programmes that allow it are solved in windows around such places, and before all exchanges around the borders
//! between free variables and others, where a guess from a coarser grid is wrong as a rule. That takes a small part of the price of
//! a solve of the whole. Each window is made optimal by itself, by a [`descent`](super::descent), and widened as long as variables
//! beside it are on the wrong side, but in the first rounds not far, as one window may disturb another. Where a programme has
//! a [dual](Programme::dual) with windows, these and the exchanges are those of the dual.
//!
//! *It ends.* A window is a programme of its own, and the descent ends at its optimum. Exchanges go on where there are fewer runs
//! on the wrong side than ever before, or else a few times in all; windows reach twice as far each time, until only the one
//! that holds all variables is left, whose optimum is that of (32). Whether exchanges and windows help is a matter of speed:
//! what is called optimal has passed a solve of the whole, which looks at every variable.

// Discrepancy: beyond-four-steps
//
// The paper only names "some algorithm of nonlinear optimisation" to go on with. A descent from face to face that drops and
// releases many variables at a time is our choice; see Lawson and Hanson (1974) for the step that makes it finite, and
// Portugal, Júdice and Vicente (1994) for exchanges of many variables, which without such a step may go round in circles.

use std::ops::Range;

use super::Answer;
use super::descent::{Cost, Descent, Violators, steepest};
use super::neighbourhood::{around, borders, merged, widened};
use crate::problem::{NotPositiveDefinite, Programme, Stationary};

/// Variables on both sides of a border or a violator that are looked at first: the spacing of one grid in the next, a few
/// times.
const REACH: usize = 32;

/// Rounds of windows by themselves. Most settle in one or two; distant windows are felt like terms of a geometric series.
const ROUNDS: usize = 10;

/// Exchanges help while the runs on the wrong side are fewer by this part than ever before.
const FEWER: usize = 10;

/// Windows are local where one solve of each costs less than this part of one of the whole.
const LOCAL: usize = 2;

/// Exchanges in all that need not help where windows would not be local: in dense contact between the nodes of a coarser grid
/// the second one undoes part of the first.
const PATIENCE: usize = 5;

/// What windows may cost, in solves of the whole: those around the borders, which may all be right, and the first ones around
/// places where exchanges do not end.
const WORTH: [usize; 2] = [1, 8];

/// What a solve of a window costs beside its variables, in variables.
const SOLVE: usize = 200;

/// What it is set to.
pub(super) fn words() -> String {
    "of each run of neighbours with the wrong sign the worst one changes; a sign counts if it is larger than the rounding of a solve"
        .to_owned()
}

/// Solves from the face on which every variable is free, as the paper's algorithm does.
pub(super) fn solve(programme: &dyn Programme) -> Answer {
    solve_from(programme, vec![true; programme.dimension()]).0
}

/// What becomes of one face.
pub(crate) struct Guess {
    /// Another face.
    pub(crate) free: Vec<bool>,
    /// Number of solves, and of variables in all of them.
    pub(crate) solves: usize,
    pub(crate) work: usize,
}

/// A guess of the optimal face from another one: optimal near its borders, or else everywhere.
pub(super) fn guess_from(programme: &dyn Programme, mut free: Vec<bool>) -> Guess {
    let mut run = Run::of(programme);
    // A solve that fails here fails again where it is reported.
    if !run.settle_borders(&mut free).is_ok_and(|rested| rested) {
        let _ = run.exchanged(&mut free);
    }
    Guess { free, solves: run.cost.whole + run.cost.windows, work: run.cost.variables }
}

/// Solves from a given face: `free[i]` is false where `x_i = 0` at first.
pub(super) fn solve_from(programme: &dyn Programme, free: Vec<bool>) -> (Answer, Cost) {
    let mut run = Run::of(programme);
    let n = programme.dimension();
    let end = run.optimum(free);
    let iterations = run.cost.whole + run.cost.windows;
    let work = run.cost.variables;
    let answer = match end {
        Ok((point, optimal)) => {
            let words = if optimal { "optimal" } else { "no further descent above rounding" };
            Answer {
                x: point.x,
                gradient: point.gradient,
                claims_success: optimal,
                words: words.to_owned(),
                own_residual: None,
                iterations,
                work,
            }
        }
        Err(error) => Answer { iterations, work, ..Answer::refused(n, error.to_string()) },
    };
    (answer, run.cost)
}

struct Run<'a> {
    programme: &'a dyn Programme,
    /// Where windows are solved, if that is not the programme itself.
    dual: Option<Box<dyn Programme + 'a>>,
    cost: Cost,
}

impl<'a> Run<'a> {
    fn of(programme: &'a dyn Programme) -> Self {
        Self { programme, dual: programme.dual(), cost: Cost::default() }
    }

    /// The optimum of the whole.
    fn optimum(&mut self, mut free: Vec<bool>) -> Result<(Stationary, bool), NotPositiveDefinite> {
        self.settle_borders(&mut free)?;
        self.exchanged(&mut free)
    }

    /// The optimum of the whole by exchanges, by windows where these do not end, and by a descent where windows do not.
    fn exchanged(&mut self, free: &mut [bool]) -> Result<(Stationary, bool), NotPositiveDefinite> {
        let n = free.len();
        let (mut fewest, mut idle, mut scale) = (usize::MAX, 0, 1);
        loop {
            self.cost.whole += 1;
            self.cost.variables += n;
            let point = self.programme.stationary(free)?;
            let violators = Violators::of(self.programme, &point, free.iter().copied());
            if violators.wrong.is_empty() {
                return Ok((violators.clipped(point), true));
            }
            let dual = self.dual.is_some();
            exchange(free, &violators.wrong, if dual { &point.x } else { &point.gradient }, dual);
            let runs = violators.wrong.chunk_by(|i, j| i + 1 == *j).count();
            if runs < fewest - fewest / FEWER {
                fewest = runs;
                continue;
            }
            let windows = around(&violators.wrong, scale * REACH, n);
            if n < LOCAL * price(&windows) && idle < PATIENCE {
                idle += 1;
            } else if scale * REACH < n && self.has_neighbourhoods() {
                self.settle(free, windows, scale * WORTH[1])?;
                scale *= 2;
            } else {
                return Descent::new(self.programme, 0..n).run(free, &mut self.cost);
            }
        }
    }

    fn has_neighbourhoods(&self) -> bool {
        self.dual.as_deref().unwrap_or(self.programme).has_neighbourhoods()
    }

    /// Makes windows around the borders optimal, as far as that is cheap. Whether there were any, and they came to rest.
    fn settle_borders(&mut self, free: &mut [bool]) -> Result<bool, NotPositiveDefinite> {
        let windows = around(&borders(free), REACH, free.len());
        if windows.is_empty() || !self.has_neighbourhoods() || free.len() < price(&windows) {
            return Ok(false);
        }
        self.settle(free, windows, WORTH[0])
    }

    /// Makes windows optimal, and as much around them as changes with them, for the price of so many solves of the whole.
    /// Whether all came to rest.
    fn settle(
        &mut self,
        free: &mut [bool],
        windows: Vec<Range<usize>>,
        worth: usize,
    ) -> Result<bool, NotPositiveDefinite> {
        let turn = |free: &mut [bool]| free.iter_mut().for_each(|free| *free = !*free);
        let mut near = Near { programme: self.dual.as_deref().unwrap_or(self.programme), cost: self.cost };
        if self.dual.is_some() {
            turn(free);
        }
        let rested = near.settle(free, windows, worth);
        if self.dual.is_some() {
            turn(free);
        }
        self.cost = near.cost;
        rested
    }
}

/// Windows of a programme with neighbourhoods.
struct Near<'a> {
    programme: &'a dyn Programme,
    cost: Cost,
}

impl Near<'_> {
    /// See [`Run::settle`].
    fn settle(
        &mut self,
        free: &mut [bool],
        windows: Vec<Range<usize>>,
        worth: usize,
    ) -> Result<bool, NotPositiveDefinite> {
        let spent = |cost: Cost| cost.variables + SOLVE * cost.windows;
        let most = spent(self.cost) + worth * free.len();
        let mut pending = windows;
        for round in 0..ROUNDS {
            let mut rested = Vec::new();
            for range in pending {
                // What is far off on one side may be so because of a window that waits for its turn.
                let longest = (4 * REACH).max(range.len()) << round;
                rested.push(self.rest(free, range, longest)?);
                if most < spent(self.cost) {
                    return Ok(false);
                }
            }
            rested.sort_by_key(|range| range.start);
            pending = Vec::new();
            for range in merged(rested.into_iter()) {
                if !self.look(free, &range)?.1.is_empty() {
                    pending.push(range);
                }
            }
            if pending.is_empty() {
                return Ok(true);
            }
        }
        Ok(false)
    }

    /// Makes a range optimal, and widens it until nothing beside it is on the wrong side, or beyond a length.
    ///
    /// The look beside it reaches `√n` variables: behind a place where contact ends, the discrete optimum has a hole of that
    /// length.
    fn rest(
        &mut self,
        free: &mut [bool],
        mut range: Range<usize>,
        longest: usize,
    ) -> Result<Range<usize>, NotPositiveDefinite> {
        let n = free.len();
        while range.len() <= longest {
            Descent::new(self.programme, range.clone()).run(free, &mut self.cost)?;
            let wider = widened(range.clone(), range.len().max(n.isqrt()), n);
            let (point, wrong) = self.look(free, &wider)?;
            let (Some(first), Some(last)) = (wrong.first(), wrong.last()) else { break };
            exchange(&mut free[wider.clone()], &wrong, &point.gradient, false);
            let seen = widened(wider.start + first..wider.start + last + 1, REACH, n);
            range = range.start.min(seen.start)..range.end.max(seen.end);
        }
        Ok(range)
    }

    /// A range as it is: the point, and its variables on the wrong side.
    fn look(&mut self, free: &[bool], range: &Range<usize>) -> Result<(Stationary, Vec<usize>), NotPositiveDefinite> {
        self.cost.windows += 1;
        self.cost.variables += range.len();
        let point = self.programme.stationary_near(free, range.clone())?;
        let violators = Violators::of(self.programme, &point, free[range.clone()].iter().copied());
        Ok((point, violators.wrong))
    }
}

/// What one solve of each window costs, in variables.
fn price(windows: &[Range<usize>]) -> usize {
    windows.iter().map(|range| range.len() + SOLVE).sum()
}

/// Drops the free ones of some variables on the wrong side, and releases of each run of the others the one with the smallest
/// slope. Where flags are those of the dual programme, they say who is not free.
fn exchange(flags: &mut [bool], wrong: &[usize], slopes: &[f64], dual: bool) {
    wrong.iter().for_each(|&k| flags[k] = dual);
    steepest(wrong, slopes).into_iter().for_each(|k| flags[k] = !dual);
}
