//! An active set that goes on where the paper's four steps stop, and always ends.
//!
//! 1. **Full exchanges** (block principal pivoting). From a face, solve step 1°; every free variable that came out
//!    negative is set to zero, as in step 3° but all at once, and every variable at zero with a negative gradient is
//!    released, which the four steps never do. Fast, a handful of solves as a rule; it may cycle.
//! 2. **Descent on faces.** When the number of violators has not fallen for [`PATIENCE`] rounds, walk from the best point
//!    seen, made feasible, to the minimum on its face; drop the variables that block the way, release those with a negative
//!    gradient, and so on until there are fewer violators than ever before; then exchange again.
//!
//! *It ends.* Each stay in 2 lowers the objective strictly from one face minimum to the next, so that no face is seen twice
//! and there are finitely many; each return to 1 needs fewer violators than any before it, so that there are at most n. In
//! floating-point arithmetic, where a strict descent can drown in rounding, a limit on the number of solves says so.
//!
//! **Neighbourhoods.** Before the first round, and after each round of 1, programmes that allow it are
//! [settled](super::neighbourhood) around the borders between free variables and others, at a small part of the price of a
//! solve. That is one more finite way to choose the next face: the proof does not change.
//!
//! *Ties*, `x_i = 0` and `g_i = 0` within the [rounding](Programme::rounding) of the solves, stay on the side where they are.

// Discrepancy: beyond-four-steps
//
// The paper only names "some algorithm of nonlinear optimisation" to go on with. Full exchanges with a finite fallback
// are our choice; see Portugal, Júdice, Vicente (1994) for block principal pivoting and Lawson, Hanson (1974) for the descent.

use super::Answer;
use super::neighbourhood::{borders, settle};
use crate::problem::{NotPositiveDefinite, Programme, Stationary};

/// Rounds of full exchange without fewer violators before the descent: the usual choice for block pivoting is around ten.
const PATIENCE: usize = 10;

/// Variables on the wrong side at a face minimum, by more than rounding.
pub(super) fn violators(programme: &dyn Programme, point: &Stationary, free: &[bool]) -> Vec<usize> {
    let (sizes, rounding) = (programme.sizes(), programme.rounding());
    let (mut x, mut gradient) = (sizes.x, sizes.gradient);
    for (value, slope) in point.x.iter().zip(&point.gradient) {
        // Not `max`: a comparison is all that a number needs.
        x = if x < value.abs() { value.abs() } else { x };
        gradient = if gradient < slope.abs() { slope.abs() } else { gradient };
    }
    let (x, gradient) = (-rounding * x, -rounding * gradient);
    let wrong = |i: &usize| if free[*i] { point.x[*i] < x } else { point.gradient[*i] < gradient };
    (0..free.len()).filter(wrong).collect()
}

/// What it is set to.
pub(super) fn words() -> String {
    format!(
        "descent after {PATIENCE} exchanges without progress; a sign counts if it is more than the rounding of a solve"
    )
}

/// Solves from the face on which every variable is free, as the paper's algorithm does.
pub(super) fn solve(programme: &dyn Programme) -> Answer {
    solve_from(programme, vec![true; programme.dimension()])
}

/// A guess of the optimal face from another one, by exchanges in the neighbourhood of its borders; the number of solves.
/// Nothing is verified.
pub(super) fn guess_from(programme: &dyn Programme, mut free: Vec<bool>) -> (Vec<bool>, usize) {
    let borders = borders(&free);
    let solves = settle(programme, &mut free, &borders);
    (free, solves)
}

/// Solves from a given face: `free[i]` is false where `x_i = 0` at first.
pub(super) fn solve_from(programme: &dyn Programme, free: Vec<bool>) -> Answer {
    let mut run = Run { programme, solves: 0, settled: 0 };
    let n = programme.dimension();
    match run.exchange(free) {
        Ok((point, optimal)) => {
            let words = if optimal { "optimal" } else { "no further descent above rounding" };
            // What is left below zero is within rounding of it.
            let clip = |mut values: Vec<f64>| {
                if optimal {
                    values.iter_mut().for_each(|v| *v = v.max(0.0));
                }
                values
            };
            Answer {
                x: clip(point.x),
                gradient: clip(point.gradient),
                claims_success: optimal,
                words: words.to_owned(),
                iterations: run.solves + run.settled,
            }
        }
        Err(error) => Answer { iterations: run.solves, ..Answer::refused(n, error.to_string()) },
    }
}

struct Run<'a> {
    programme: &'a dyn Programme,
    /// Solves of the whole.
    solves: usize,
    /// Solves of neighbourhoods.
    settled: usize,
}

impl Run<'_> {
    /// Exchanges around some variables before the next solve of the whole.
    fn settle(&mut self, free: &mut [bool], places: &[usize]) {
        self.settled += settle(self.programme, free, places);
    }

    /// Step 1° on a face.
    fn minimum_on(&mut self, free: &[bool]) -> Result<Stationary, NotPositiveDefinite> {
        self.solves += 1;
        self.programme.stationary(free)
    }

    /// A limit on solves that only rounding can reach: many times what the slowest known instance needs.
    fn exhausted(&self) -> bool {
        200 + 20 * self.programme.dimension() < self.solves
    }

    /// Variables on the wrong side at a face minimum.
    fn violators(&self, point: &Stationary, free: &[bool]) -> Vec<usize> {
        violators(self.programme, point, free)
    }

    /// Full exchanges, with descents where they stall. True if the point is optimal.
    fn exchange(&mut self, mut free: Vec<bool>) -> Result<(Stationary, bool), NotPositiveDefinite> {
        let (mut fewest, mut patience) = (usize::MAX, PATIENCE);
        let mut best: Option<Stationary> = None;
        let borders = borders(&free);
        self.settle(&mut free, &borders);
        loop {
            let point = self.minimum_on(&free)?;
            let violators = self.violators(&point, &free);
            if violators.is_empty() {
                return Ok((point, true));
            }
            if violators.len() < fewest {
                (fewest, patience) = (violators.len(), PATIENCE);
                best = Some(point);
            } else {
                patience -= 1;
            }
            violators.iter().for_each(|&i| free[i] = !free[i]);
            if patience == 0 {
                let from = best.as_ref().map_or_else(Vec::new, |b| b.x.clone());
                let (point, face) = self.descend(from, fewest)?;
                let violators = self.violators(&point, &face);
                if violators.is_empty() || self.exhausted() {
                    return Ok((point, violators.is_empty()));
                }
                (fewest, patience) = (violators.len(), PATIENCE);
                best = Some(point);
                free = face;
                violators.iter().for_each(|&i| free[i] = !free[i]);
            }
            self.settle(&mut free, &violators);
        }
    }

    /// From face minimum to face minimum, each lower than the one before, until there are fewer than `fewest` violators.
    fn descend(&mut self, from: Vec<f64>, fewest: usize) -> Result<(Stationary, Vec<bool>), NotPositiveDefinite> {
        let mut x: Vec<f64> = from.iter().map(|x| x.max(0.0)).collect();
        let mut free: Vec<bool> = x.iter().map(|x| 0.0 < *x).collect();
        loop {
            let point = self.walk(&mut x, &mut free)?;
            let violators = self.violators(&point, &free);
            if violators.len() < fewest || self.exhausted() {
                return Ok((point, free));
            }
            let steepest = violators.iter().copied().min_by(|&i, &j| point.gradient[i].total_cmp(&point.gradient[j]));
            if let Some(i) = steepest {
                free[i] = true;
            }
        }
    }

    /// Walks from the feasible `x` to the minimum on its face, leaving the face where a variable reaches zero on the way.
    fn walk(&mut self, x: &mut [f64], free: &mut [bool]) -> Result<Stationary, NotPositiveDefinite> {
        loop {
            let target = self.minimum_on(free)?;
            let tiny = self.programme.rounding() * self.programme.sizes().x;
            let blocked = |i: usize, x: &[f64]| free[i] && target.x[i] < -tiny && target.x[i] < x[i];
            let way = |i: usize, x: &[f64]| x[i] / (x[i] - target.x[i]);
            let step = (0..x.len()).filter(|&i| blocked(i, x)).map(|i| way(i, x)).fold(1.0, f64::min);
            let blocking: Vec<usize> = (0..x.len()).filter(|&i| blocked(i, x) && way(i, x) <= step).collect();
            for (x, target) in x.iter_mut().zip(&target.x) {
                *x = (*x + step * (target - *x)).max(0.0);
            }
            if blocking.is_empty() {
                return Ok(target);
            }
            for i in blocking {
                (x[i], free[i]) = (0.0, false);
            }
        }
    }
}
