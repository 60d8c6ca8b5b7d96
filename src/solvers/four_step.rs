//! The paper's algorithm, as printed:
//!
//! ```text
//! 1°  solve A x = b                       (on the variables not yet set to zero)
//! 2°  if x ≥ 0, the solution is found
//! 3°  set min { x_i | i = 1 … n } = 0
//! 4°  go to 1°
//! ```
//!
//! It ends after at most n rounds, at a point that is stationary on a face of the feasible set. That point is optimal
//! only if no variable that was set to zero has a negative gradient, which the four steps do not ask.

// Discrepancy: four-step-solution
//
// Step 2° reads "if x ≥ 0, the solution has been found". The text above the algorithm says more carefully that its first
// three steps lead to the edge of the feasible set, from where some algorithm of nonlinear optimisation can continue.
// `four-step` is the algorithm as printed and stops there; `active-set` continues.
// Where two components are equally small, as mirror images are, the first of them is set to zero.

use super::Answer;
use crate::problem::Programme;

/// Largest dimension for which the four steps are tried: they take up to n solves of O(n) operations each.
const LARGEST: usize = 10_000;

/// Runs the four steps.
pub(super) fn solve(programme: &dyn Programme) -> Answer {
    let n = programme.dimension();
    if LARGEST < n {
        return Answer::refused(n, format!("not tried: up to {n} solves, {LARGEST} is the limit of this solver"));
    }
    let mut free = vec![true; n];
    let mut steps = 0;
    loop {
        steps += 1;
        let point = match programme.stationary(&free) {
            Ok(point) => point,
            Err(error) => {
                return Answer { iterations: steps, work: steps * n, ..Answer::refused(n, error.to_string()) };
            }
        };
        match smallest(&point.x, &free) {
            Some(i) => free[i] = false,
            None => {
                return Answer {
                    x: point.x,
                    gradient: point.gradient,
                    claims_success: true,
                    words: "x ≥ 0".to_owned(),
                    own_residual: None,
                    iterations: steps,
                    work: steps * n,
                };
            }
        }
    }
}

/// The smallest negative component among the free ones, the first of equal ones.
fn smallest(x: &[f64], free: &[bool]) -> Option<usize> {
    (0..x.len()).filter(|&i| free[i] && x[i] < 0.0).min_by(|&i, &j| x[i].total_cmp(&x[j]))
}
