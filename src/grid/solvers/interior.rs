//! Mehrotra's predictor-corrector method (Mehrotra 1992). It gives the active set a first set of free variables, which alone would
//! exchange them one by one.

use crate::qp::{Explicit, FreeSet, NotPositiveDefinite, Profile, Qp as _, solved_in};

/// Largest number of steps; 10 to 30 are usual.
const STEPS: usize = 60;

/// The steps end when the mean product of a pair is this fraction of its size, which is far less than is needed to tell which member
/// of a pair is zero.
const PRODUCT: f64 = 1e-18;
/// They also require that the residual of the equations is this fraction of its size, or is rounding and no longer decreases. *Tuned*
/// on the bodies of the tests so that it needs no more steps than the pairs.
const REST: f64 = 1e-12;

/// Fraction of the distance to the border that a step covers; the usual value (Mehrotra 1992).
const SHORT_OF_BORDER: f64 = 0.995;

/// A point `x > 0` and `g > 0`, aiming at `A x − g = b`.
struct Interior<'a> {
    matrix: &'a Profile,
    order: &'a [usize],
    linear: &'a [f64],
    x: Vec<f64>,
    gradient: Vec<f64>,
}

/// A step of `x` and `g`, and the fraction of it that reaches the border, at most 1.
struct Step {
    x: Vec<f64>,
    gradient: Vec<f64>,
    longest: f64,
}

/// The free variables according to steps through the interior: of each pair the member that vanishes faster is zero. The steps begin
/// at the size that each variable would have alone. If the actual solution is far larger, this start is so near the border that steps
/// become shorter and shorter. They then begin again at the size of the free minimum, which may be far too large.
pub(super) fn free_set(qp: &Explicit) -> FreeSet {
    let x = qp.sizes().x;
    let (free, ended) = free_from(qp, x);
    if ended {
        return free;
    }
    let minimum = qp.solve(&qp.linear());
    let (other, ended) = free_from(qp, minimum.iter().fold(x, |most, x| most.max(x.abs())));
    if ended { other } else { free }
}

/// The same from one size for all variables, and whether the steps converged.
fn free_from(qp: &Explicit, x: f64) -> (FreeSet, bool) {
    let (n, gradient, linear) = (qp.dimension(), qp.sizes().gradient, qp.linear());
    let (matrix, order) = (qp.profile(), qp.order());
    let mut point = Interior { matrix, order, linear: &linear, x: vec![x; n], gradient: vec![gradient; n] };
    let mut free = FreeSet::all(n);
    let mut last = f64::INFINITY;
    for _ in 0..STEPS {
        let rest = point.rest();
        let mean = point.mean(&[], &[], 0.0);
        let most = rest.iter().fold(0.0, |most: f64, rest| most.max(rest.abs()));
        if mean <= PRODUCT * x * gradient && (most <= REST * gradient || 0.5 * last <= most) {
            return (free, true);
        }
        last = most;
        let Ok(step) = point.step(&rest, mean) else { break };
        let length = (SHORT_OF_BORDER * step.longest).min(1.0);
        let next = |from: &[f64], step: &[f64]| -> Vec<f64> {
            from.iter().zip(step).map(|(from, step)| from + length * step).collect()
        };
        let (x, gradient) = (next(&point.x, &step.x), next(&point.gradient, &step.gradient));
        if x.iter().chain(&gradient).any(|value| !(0.0 < *value && *value < f64::INFINITY)) {
            break;
        }
        (0..n).for_each(|i| free.set(i, gradient[i] * point.x[i] < x[i] * point.gradient[i]));
        (point.x, point.gradient) = (x, gradient);
    }
    (free, false)
}

impl Interior<'_> {
    /// The residual `A x − b − g`.
    fn rest(&self) -> Vec<f64> {
        let others = self.linear.iter().zip(&self.gradient);
        self.matrix.times(&self.x).iter().zip(others).map(|(product, (b, g))| product - b - g).collect()
    }

    /// The mean of `x_i g_i` after `length` times a step.
    fn mean(&self, x: &[f64], gradient: &[f64], length: f64) -> f64 {
        let moved = |from: f64, step: &[f64], i: usize| from + length * step.get(i).copied().unwrap_or(0.0);
        let pairs = self.x.iter().zip(&self.gradient).enumerate();
        let sum: f64 = pairs.map(|(i, (p, g))| moved(*p, x, i) * moved(*g, gradient, i)).sum();
        #[expect(clippy::cast_precision_loss, reason = "far below 2⁵³ variables")]
        let n = self.x.len() as f64;
        sum / n
    }

    /// A step towards pairs with one smaller product for all: `g dx + x dg = σμ − x g − dx dg`, `A dx − dg = −rest`.
    fn step(&self, rest: &[f64], mean: f64) -> Result<Step, NotPositiveDefinite> {
        let mut shifted = self.matrix.part(self.order, 0.0);
        shifted.add_to_diagonal(self.order.iter().map(|i| self.gradient[*i] / self.x[*i]));
        let factor = shifted.cholesky()?;
        let towards = |product: f64, before: Option<&Step>| {
            let second = |i: usize| before.map_or(0.0, |step| step.x[i] * step.gradient[i]);
            let pairs = self.x.iter().zip(&self.gradient).enumerate();
            let right: Vec<f64> = pairs.map(|(i, (x, g))| product - x * g - second(i)).collect();
            let towards: Vec<f64> = (0..right.len()).map(|i| right[i] / self.x[i] - rest[i]).collect();
            let x = solved_in(self.order, &factor, &towards);
            let gradient: Vec<f64> =
                (0..right.len()).map(|i| (right[i] - self.gradient[i] * x[i]) / self.x[i]).collect();
            let border = |from: &[f64], step: &[f64]| {
                let ways = from.iter().zip(step).filter(|(_, step)| **step < 0.0).map(|(from, step)| -from / step);
                ways.fold(1.0, f64::min)
            };
            Step { longest: border(&self.x, &x).min(border(&self.gradient, &gradient)), x, gradient }
        };
        let straight = towards(0.0, None);
        let share = self.mean(&straight.x, &straight.gradient, straight.longest) / mean;
        Ok(towards(share * share * share * mean, Some(&straight)))
    }
}
