//! An active set that goes on where the paper's four steps stop, and always ends.
//!
//! The four steps drop variables one by one and never release one. Here one of each run of negative neighbours is dropped,
//! others are released where the gradient is negative, and the objective falls strictly from one feasible face minimum to the next: see
//! [`descent`](super::descent) for the steps and why they end.
//!
//! **Windows.** A guess of the face is wrong near the borders between free variables and others only. Programmes that allow
//! it are solved in windows around these, at a small part of the price of a solve of the whole:
//!
//! 1. Each window by itself, widened as long as variables beside it are on the wrong side, but in the first rounds not far;
//!    [`ROUNDS`] times, as one window may disturb another, and then all of them as one.
//! 2. A solve of the whole. If no variable is on the wrong side, this is the optimum. Otherwise the windows grow around those
//!    that are.
//!
//! *It ends.* A window is a programme of its own, and the descent ends at its optimum. Windows only ever grow: those of 1
//! within their rounds, and all of them in 2, or else they are given up for the window that holds all variables. There are n
//! variables to grow by, and what ends in that window is the optimum of (32). Whether windows help is a matter of speed:
//! what is called optimal has passed a solve of the whole, which looks at every variable.

// Discrepancy: beyond-four-steps
//
// The paper only names "some algorithm of nonlinear optimisation" to go on with. A descent from face to face that drops and
// releases many variables at a time is our choice; see Lawson and Hanson (1974) for the step that makes it finite, and
// Portugal, Júdice and Vicente (1994) for exchanges of many variables, which without such a step may go round in circles.

use std::ops::Range;

use super::Answer;
use super::descent::{Cost, Descent, Violators, steepest};
use super::neighbourhood::{Window, borders, widened};
use crate::problem::{NotPositiveDefinite, Programme, Stationary};

/// Variables on both sides of a border or a violator that are looked at first: the spacing of one grid in the next, a few
/// times.
const REACH: usize = 32;

/// Rounds of windows by themselves. Most settle in one or two; distant windows are felt like terms of a geometric series.
const ROUNDS: usize = 10;

/// What it is set to.
pub(super) fn words() -> String {
    "of each run of neighbours with the wrong sign the worst one changes; a sign counts if it is larger than the rounding of a solve"
        .to_owned()
}

/// Solves from the face on which every variable is free, as the paper's algorithm does.
pub(super) fn solve(programme: &dyn Programme) -> Answer {
    solve_from(programme, vec![true; programme.dimension()]).0
}

/// What windows around the borders of one face make of it.
pub(crate) struct Guess {
    /// Another face.
    pub(crate) free: Vec<bool>,
    /// Whether the windows came to rest, small beside the whole. What is outside of them was not looked at.
    pub(crate) settled: bool,
    /// Number of solves, and of variables in all of them.
    pub(crate) solves: usize,
    pub(crate) work: usize,
}

/// A guess of the optimal face from another one.
pub(super) fn guess_from(programme: &dyn Programme, mut free: Vec<bool>) -> Guess {
    let mut run = Run { programme, cost: Cost::default() };
    let window = Window::around(&borders(&free), REACH, free.len());
    // A solve that fails here fails again where it is reported.
    let rested = run.settle(&mut free, window);
    let settled = rested.is_ok_and(|window| run.is_worth_it(&window, free.len()));
    Guess { free, settled, solves: run.cost.windows, work: run.cost.variables }
}

/// Solves from a given face: `free[i]` is false where `x_i = 0` at first.
pub(super) fn solve_from(programme: &dyn Programme, free: Vec<bool>) -> (Answer, Cost) {
    let mut run = Run { programme, cost: Cost::default() };
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
    cost: Cost,
}

impl Run<'_> {
    /// Whether windows of a programme with n variables can be solved for less than the whole.
    fn is_worth_it(&self, window: &Window, n: usize) -> bool {
        self.programme.has_neighbourhoods() && window.is_worth_it(n)
    }

    /// The optimum of the whole, by windows that grow until none outside is on the wrong side.
    fn optimum(&mut self, mut free: Vec<bool>) -> Result<(Stationary, bool), NotPositiveDefinite> {
        let n = free.len();
        let mut reach = REACH;
        let mut window = Window::around(&borders(&free), reach, n);
        while self.is_worth_it(&window, n) {
            window = self.settle(&mut free, window)?;
            self.cost.whole += 1;
            self.cost.variables += n;
            let point = self.programme.stationary(&free)?;
            let violators = Violators::of(self.programme, &point, free.iter().copied());
            if violators.wrong.is_empty() {
                return Ok((violators.clipped(point), true));
            }
            exchange(&mut free, &violators.wrong, &point.gradient);
            reach *= 2;
            let wider = window.with(&Window::around(&violators.wrong, reach, n));
            if wider == window {
                break;
            }
            window = wider;
        }
        Descent::new(self.programme, &Window::whole(n)).run(&mut free, &mut self.cost)
    }

    /// Makes a window optimal, and as much around it as changes with it: the window that is optimal in the end.
    fn settle(&mut self, free: &mut [bool], mut window: Window) -> Result<Window, NotPositiveDefinite> {
        let n = free.len();
        let mut pending = window.ranges.clone();
        for round in 0..ROUNDS {
            for range in pending {
                // What is far off on one side may be so because of a window that waits for its turn.
                let most = (4 * REACH).max(range.len()) << round;
                let rested = self.rest(free, range, most)?;
                window = window.with(&Window::of(rested));
                if !self.is_worth_it(&window, n) {
                    return Ok(window);
                }
            }
            pending = Vec::new();
            for range in &window.ranges {
                if !self.look(free, range)?.1.is_empty() {
                    pending.push(range.clone());
                }
            }
            if pending.is_empty() {
                return Ok(window);
            }
        }
        Descent::new(self.programme, &window).run(free, &mut self.cost)?;
        Ok(window)
    }

    /// Makes a range optimal, and widens it until nothing beside it is on the wrong side, or up to `most` variables.
    ///
    /// The look beside it reaches `√n` variables: behind a place where contact ends, the discrete optimum has a hole of that
    /// length.
    fn rest(
        &mut self,
        free: &mut [bool],
        mut range: Range<usize>,
        most: usize,
    ) -> Result<Range<usize>, NotPositiveDefinite> {
        let n = free.len();
        loop {
            let window = Window::of(range.clone());
            if !self.is_worth_it(&window, n) || most < range.len() {
                return Ok(range);
            }
            Descent::new(self.programme, &window).run(free, &mut self.cost)?;
            let wider = widened(range.clone(), range.len().max(n.isqrt()), n);
            let (point, wrong) = self.look(free, &wider)?;
            let (Some(first), Some(last)) = (wrong.first(), wrong.last()) else { return Ok(range) };
            exchange(&mut free[wider.clone()], &wrong, &point.gradient);
            let seen = widened(wider.start + first..wider.start + last + 1, REACH, n);
            range = range.start.min(seen.start)..range.end.max(seen.end);
        }
    }

    /// A range as it is: the point, and its variables on the wrong side.
    fn look(&mut self, free: &[bool], range: &Range<usize>) -> Result<(Stationary, Vec<usize>), NotPositiveDefinite> {
        self.cost.windows += 1;
        self.cost.variables += range.len();
        let point = Window::of(range.clone()).minimum_on(self.programme, free)?;
        let violators = Violators::of(self.programme, &point, free[range.clone()].iter().copied());
        Ok((point, violators.wrong))
    }
}

/// Drops the free ones of some variables on the wrong side, and releases the steepest of each run of the others.
fn exchange(free: &mut [bool], wrong: &[usize], gradient: &[f64]) {
    wrong.iter().for_each(|&k| free[k] = false);
    steepest(wrong, gradient).into_iter().for_each(|k| free[k] = true);
}
