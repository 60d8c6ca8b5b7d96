//! NSOR: successive over-relaxation with projection on `x ≥ 0` (Mangasarian 1977; today also PSOR), which the paper
//! recommends for large `n`:
//!
//! ```text
//! x_i ← max(0, x_i − ω g_i / a_ii),   i = 1 … n,   g_i = (A x − b)_i with the newest x
//! ```
//!
//! It converges for every symmetric positive definite `A` and `0 < ω < 2`. The best `ω` depends on the matrix and is found by
//! successive halving. Every candidate makes some sweeps, the one with the largest residual is dropped, and the others make twice as
//! many. The first to pass the convergence test is used; all sweeps count.
//!
//! Rounding may keep the residual above the tolerance. The sweeps then end in a cycle, mostly of a single point. A candidate that
//! completed its cycle without passing the test never will, and makes no more sweeps.

// Discrepancy: nsor-relaxation
//
// The paper gives neither a relaxation factor nor a stopping rule. We try nine factors and stop on the scaled residual of the
// optimality conditions.

use super::{Answer, Run, no_matrix, too_large};
use crate::qp::{Matrix, Qp, residual};

/// Relaxation factors of the first round.
const FACTORS: [f64; 9] = [1.0, 1.2, 1.4, 1.6, 1.7, 1.8, 1.85, 1.9, 1.95];

/// Sweeps of each candidate in the first round.
const FIRST_ROUND: usize = 50;

/// Sweeps between two evaluations of the residual.
const SWEEPS_PER_LOOK: usize = 10;

/// Operations of a sweep besides the multiplications: some for each variable, and its share of evaluating the residual.
const OVERHEAD: usize = 40;

/// Budget of a run in operations; the page on speed and accuracy gives the time for it. The limit on sweeps follows from it, so that
/// the answer does not depend on a clock.
const OPERATIONS: usize = 1 << 30;

/// The settings as text.
pub(super) fn settings_text(tolerance: f64) -> String {
    format!(
        "ω from a race of {} factors from {:.2} to {:.2}; stops at a scaled residual of {tolerance:.0e}, looked at every \
         {SWEEPS_PER_LOOK} sweeps; a budget of {} million operations, of which a sweep takes one for each entry of the matrix and {OVERHEAD} for each variable; less where rounding makes the sweeps go in circles",
        FACTORS.len(),
        FACTORS[0],
        FACTORS[FACTORS.len() - 1],
        OPERATIONS / 1_000_000,
    )
}

/// Runs NSOR until the scaled residual is at most `tolerance`, or the budget is used up.
pub(super) fn solve(qp: &dyn Qp, tolerance: f64) -> Answer {
    if let Some(message) = no_matrix(qp).or_else(|| too_large(qp)) {
        return Answer::refused(qp.dimension(), message);
    }
    let relaxation = Relaxation { qp, matrix: qp.matrix(), linear: qp.linear() };
    let limit =
        (OPERATIONS / (relaxation.matrix.entries() + OVERHEAD * qp.dimension())).max(FACTORS.len() * SWEEPS_PER_LOOK);
    let mut race = FACTORS.map(|factor| Candidate::new(factor, qp.dimension())).to_vec();
    let (mut sweeps, mut round) = (0, FIRST_ROUND);
    let mut winner = None;
    while winner.is_none() && sweeps < limit && !race.iter().all(Candidate::cycles) {
        let looks = (round / SWEEPS_PER_LOOK).min(1 + (limit - sweeps) / SWEEPS_PER_LOOK / race.len());
        'round: for (k, candidate) in race.iter_mut().enumerate() {
            for _ in 0..looks {
                if candidate.cycles() {
                    break;
                }
                relaxation.advance(candidate);
                sweeps += SWEEPS_PER_LOOK;
                if candidate.residual <= tolerance {
                    winner = Some(k);
                    break 'round;
                }
            }
        }
        if winner.is_none() && 1 < race.len() {
            let worst = (0..race.len()).max_by(|&i, &j| race[i].residual.total_cmp(&race[j].residual));
            worst.map(|k| race.remove(k));
        }
        round *= 2;
    }
    let ahead = (0..race.len()).min_by(|&i, &j| race[i].residual.total_cmp(&race[j].residual));
    let Candidate { factor, x, residual, cycle } = race.swap_remove(winner.or(ahead).unwrap_or(0));
    let message = if winner.is_some() {
        format!("converged with ω = {factor} in {} of its own sweeps", SWEEPS_PER_LOOK * cycle.looks)
    } else {
        let end = if cycle.closed { ", which go in circles" } else { "" };
        format!("not converged: residual {residual:.1e} after {sweeps} sweeps, at last with ω = {factor}{end}")
    };
    Answer {
        gradient: qp.gradient(&x),
        run: Run {
            reports_success: winner.is_some(),
            message,
            iterations: sweeps,
            work: sweeps * x.len(),
            ..Run::default()
        },
        x,
    }
}

/// A relaxation factor and the state of its sweeps.
#[derive(Clone)]
struct Candidate {
    factor: f64,
    x: Vec<f64>,
    residual: f64,
    cycle: Cycle,
}

impl Candidate {
    fn new(factor: f64, dimension: usize) -> Self {
        let x = vec![0.0; dimension];
        Self { factor, cycle: Cycle { mark: x.clone(), looks: 0, closed: false }, x, residual: f64::INFINITY }
    }

    /// Whether more sweeps would only repeat earlier points.
    fn cycles(&self) -> bool {
        self.cycle.closed
    }
}

/// Detects whether a sequence has returned to an earlier point, by Brent's method (Brent 1980). One point is kept, and replaced by a
/// later one whenever the number of points has doubled. A sweep depends on `x` alone, so a point that returns once returns again and
/// again.
#[derive(Clone)]
struct Cycle {
    mark: Vec<f64>,
    looks: usize,
    closed: bool,
}

impl Cycle {
    fn look(&mut self, x: &[f64]) {
        self.closed = self.mark.iter().zip(x).all(|(mark, x)| mark.to_bits() == x.to_bits());
        self.looks += 1;
        if self.looks.is_power_of_two() {
            self.mark.copy_from_slice(x);
        }
    }
}

struct Relaxation<'a> {
    qp: &'a dyn Qp,
    matrix: Matrix,
    linear: Vec<f64>,
}

impl Relaxation<'_> {
    /// One sweep over all variables, each with the newest values of the others.
    fn sweep(&self, factor: f64, x: &mut [f64]) {
        for i in 0..x.len() {
            let gradient = self.matrix.row_times(i, x) - self.linear[i];
            x[i] = (x[i] - factor * gradient / self.matrix.entry(i, i)).max(0.0);
        }
    }

    /// Makes some sweeps and evaluates the residual.
    fn advance(&self, Candidate { factor, x, residual: found, cycle }: &mut Candidate) {
        for _ in 0..SWEEPS_PER_LOOK {
            self.sweep(*factor, x);
        }
        *found = residual(self.qp.sizes(), x, &self.qp.gradient(x));
        cycle.look(x);
    }
}

#[cfg(test)]
mod tests {
    use super::Cycle;

    /// The number of evaluations until a sequence of numbers is known to repeat itself, at most a thousand.
    fn looks(next: impl Fn(f64) -> f64) -> Option<usize> {
        let (mut x, mut cycle) = (0.0, Cycle { mark: vec![0.0], looks: 0, closed: false });
        for look in 1..=1000 {
            x = next(x);
            cycle.look(&[x]);
            if cycle.closed {
                return Some(look);
            }
        }
        None
    }

    #[test]
    fn cycles_are_noticed_and_nothing_else() {
        // From 0 in seven steps to the cycle 7, 8, 9. The kept point is that of the eighth evaluation, and returns three later.
        assert_eq!(looks(|x| if x < 9.0 { x + 1.0 } else { 7.0 }), Some(11));
        assert_eq!(looks(|x| x), Some(1));
        // Newton's steps to √2 end at a point. A sequence that grows for ever does not.
        assert!(looks(|x| 0.5 * (x.max(1.0) + 2.0 / x.max(1.0))).is_some_and(|looks| looks < 20), "steps to a root");
        assert_eq!(looks(|x| x + f64::EPSILON), None);
    }
}
