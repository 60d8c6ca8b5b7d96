//! The paper's algorithm, as printed:
//!
//! ```text
//! 1°  solve A x = b                       (on the variables not yet set to zero)
//! 2°  if x ≥ 0, the solution is found
//! 3°  set min { x_i | i = 1 … n } = 0
//! 4°  go to 1°
//! ```
//!
//! If `A` is only semidefinite, there may be no `x` to begin with. We then add a step 0°. It fixes variables at zero so that a
//! solution exists for the others.
//!
//! The algorithm ends after at most n + 1 rounds, at a point that is stationary on a face of the feasible set. That point is optimal
//! only if no variable that was set to zero has a negative gradient. The four steps do not check this.

// Discrepancy: four-step-solution
//
// Step 2° reads "if x ≥ 0, the solution has been found". `four-step` is the algorithm as printed; of two equally small components it
// sets the first to zero.

use super::{Answer, Run};
use crate::qp::{FreeSet, NotPositiveDefinite, Qp, Stationary};

/// Largest dimension for which the four steps are tried: they need up to n solves of O(n) operations each.
const LARGEST: usize = 10_000;

/// Runs the four steps.
pub(super) fn solve(qp: &dyn Qp) -> Answer {
    let n = qp.dimension();
    if LARGEST < n {
        return Answer::refused(n, format!("not tried: up to {n} solves, {LARGEST} is the limit of this solver"));
    }
    let mut rounds = 0;
    let end = four_steps(qp, &mut rounds);
    let run = |reports_success, message| Run {
        reports_success,
        message,
        iterations: rounds,
        work: rounds * n,
        ..Run::default()
    };
    match end {
        Ok(Stationary { x, gradient }) => Answer { x, gradient, run: run(true, "x ≥ 0".to_owned()) },
        Err(error) => Answer::without_numbers(n, run(false, error.to_string())),
    }
}

// Report: four-step
fn four_steps(qp: &dyn Qp, rounds: &mut usize) -> Result<Stationary, NotPositiveDefinite> {
    let mut free = FreeSet::all(qp.dimension());
    // 0° Where A is only semidefinite: begin with a set on which there is a solution.
    qp.make_definite(&mut free);
    loop {
        *rounds += 1;
        // 1° Solve A x = b on the variables that are not yet set to zero.
        let point = qp.stationary(&free)?;
        // 2° If x ≥ 0, stop.
        let Some(i) = smallest_negative(&point.x, &free) else { return Ok(point) };
        // 3° Set the smallest component of x to zero; 4° go to 1°.
        free.set(i, false);
    }
}

/// The smallest negative component among the free ones, the first of equal ones.
fn smallest_negative(x: &[f64], free: &FreeSet) -> Option<usize> {
    free.variables().filter(|&i| x[i] < 0.0).min_by(|&i, &j| x[i].total_cmp(&x[j]))
}
// Report: end
