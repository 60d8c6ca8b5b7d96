//! Plans the next grid of an adaptive search from the errors on the grids before it.
//!
//! With the order `p` of the last few errors, `e ≈ c N^−p`, the grid for the error `EPS` has
//!
//! ```text
//! N_next = N (e / EPS)^(1/p)
//! ```
//!
//! intervals. A small margin is added, and the number is rounded up to a grid with nodes where the scene breaks. Far from the goal
//! the refinement per step is limited: a prediction is only as good as the observed order, and a coarse grid costs next to nothing
//! compared with one that is too fine.

use super::order::observed_order;
use super::{End, Request, Trial, breaks};
use crate::answer::solve::DEFAULT_TOLERANCE;
use crate::route::Solver;
use crate::scene::{Grid, Scene};
use crate::solvers::MOST_WORK;
use crate::verdict::{Demand, Refusal};

/// Approximate number of intervals of the first grid.
const START: usize = 8;

/// Order assumed while only one error is known: the order of nodal loads that replace distributed loads.
const ORDER: f64 = 2.0;

/// Range to which a fitted order is limited. A kink or a step between nodes gives first order or less. No method here exceeds fourth
/// order.
const ORDERS: [f64; 2] = [0.5, 4.0];

/// Number of errors from which the order is fitted. Three, because the distance of a lift-off point from the nearest node varies
/// irregularly from grid to grid.
const FITTED: usize = 3;

/// Factor on the predicted number of intervals.
const MARGIN: f64 = 1.1;

/// Smallest refinement from one grid to the next, so that the two errors give an order.
const LEAST_STEP: f64 = 1.4;

/// Refinement while the error is unknown.
const BLIND_STEP: f64 = 4.0;

/// Refinement within which the error must at least halve. Lift-off points that happen to lie near nodes can make a grid as good as
/// one that is ten times as fine.
const STALL: usize = 64;

/// From this number of intervals on, the active set starts from a grid that is coarser by [`NESTED`]. A guess from a grid whose nodes
/// are elsewhere is far worse: at a corner it can cost thousands of solves.
const FEW: usize = 1000;
/// Refinement between these grids.
const NESTED: usize = 8;
/// How much finer than predicted a grid may be so that its coarser grids fit.
const NEAR: f64 = 1.1;

/// Factor from a tolerance to the next smaller one.
const STRICTER: f64 = 1e-3;

/// The next step of a search.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Next {
    /// Solve on a grid, with the tolerance of an iterative solver.
    Solve { intervals: usize, tolerance: f64 },
    /// Stop.
    End(End),
}

/// The data that do not change during a search.
#[derive(Debug, Clone, Copy)]
pub(super) struct Plan {
    /// Grids should be multiples of this number, so that the breaks of the scene are nodes.
    common: usize,
    /// Grids must be multiples of this number, so that supports, joints and changes of the bending stiffness are nodes.
    step: usize,
    /// The finest grid.
    most: usize,
    demand: Demand,
    loose: f64,
    /// Largest refinement in one step.
    refinement: f64,
}

impl Plan {
    pub(super) fn new(scene: &Scene, request: &Request) -> Self {
        // The cost of the active set is proportional to the grid, and the cost of the other solvers to its square or cube.
        let refinement = if request.solver == Solver::ActiveSet { 8.0 } else { 3.0 };
        let changes = scene.beam().joints().len() + scene.beam().changes().count();
        let step = if 0 < changes { Grid::least_fitting(scene) } else { Grid::step(scene) }.unwrap_or(1);
        Self {
            common: breaks::common_intervals(scene),
            step,
            most: (request.most_intervals / step * step).max(step).max(2),
            demand: request.demand(),
            loose: request.tolerance(),
            refinement,
        }
    }

    /// The first grid and its tolerance.
    pub(super) fn start(&self) -> (usize, f64) {
        (self.fitting(START).min(self.most), self.loose)
    }

    /// The step after these trials; without trials, the first grid.
    pub(super) fn next(&self, trials: &[Trial]) -> Next {
        let Some(last) = trials.last() else {
            let (intervals, tolerance) = self.start();
            return Next::Solve { intervals, tolerance };
        };
        let Some(refusal) = last.refusal else { return Next::End(End::Reached) };
        // NaN is not small.
        let unsolved = self.demand.residual < last.residual || last.residual.is_nan();
        if DEFAULT_TOLERANCE < last.tolerance && last.reports_success && (unsolved || !last.contacts_proven) {
            let tolerance = (STRICTER * last.tolerance).max(DEFAULT_TOLERANCE);
            return Next::Solve { intervals: last.intervals, tolerance };
        }
        if unsolved || refusal == Refusal::NoNumbers {
            return Next::End(End::Failed { intervals: last.intervals, refusal });
        }
        if stalled(trials) {
            return Next::End(End::Stalled { intervals: last.intervals });
        }
        if MOST_WORK <= trials.iter().map(|trial| trial.work).sum() {
            return Next::End(End::Spent { intervals: last.intervals, most: MOST_WORK });
        }
        let finest = self.finest();
        if finest <= last.intervals {
            return Next::End(End::Limit { intervals: last.intervals });
        }
        let intervals = self.fitting(self.predicted(trials, last)).min(finest);
        Next::Solve { intervals, tolerance: self.tolerance(trials, last) }
    }

    /// The grid that the errors so far predict, at most one step finer than the last one.
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a positive number far below 2⁵³")]
    fn predicted(&self, trials: &[Trial], last: &Trial) -> usize {
        let aligned =
            |t: &&Trial| t.intervals.is_multiple_of(self.common) == last.intervals.is_multiple_of(self.common);
        let mut known: Vec<&Trial> = Vec::new();
        for t in trials.iter().rev().filter(aligned) {
            // Of several trials on one grid the last is the best.
            if known.iter().all(|k| k.intervals != t.intervals) && known.len() < FITTED {
                known.push(t);
            }
        }
        let errors: Vec<(f64, f64)> = known.iter().map(|t| (1.0 / as_number(t.intervals), t.error)).collect();
        let order = observed_order(&errors);
        let order = if order.is_finite() { order.clamp(ORDERS[0], ORDERS[1]) } else { ORDER };
        let factor = MARGIN * libm::pow(last.error / self.demand.error, 1.0 / order);
        let factor = if factor.is_finite() { factor.clamp(LEAST_STEP, self.refinement) } else { BLIND_STEP };
        (as_number(last.intervals) * factor).ceil() as usize
    }

    /// The smallest grid of at least this size with nodes where the scene breaks, unless it is much finer. If possible, the coarser
    /// grids from which the active set starts have these nodes too.
    fn fitting(&self, intervals: usize) -> usize {
        let nested = self.nested(intervals);
        let near = |multiple: usize, most: f64| {
            let next = intervals.next_multiple_of(multiple);
            (as_number(next) <= most * as_number(intervals)).then_some(next)
        };
        near(nested, NEAR).or_else(|| near(self.common, 2.0)).unwrap_or(intervals.next_multiple_of(self.step))
    }

    /// The finest allowed grid; if this costs little, one that fits together with its coarser grids.
    fn finest(&self) -> usize {
        let whole = |multiple: usize| self.most / multiple * multiple;
        let nested = whole(self.nested(self.most));
        if as_number(self.most) <= NEAR * as_number(nested) { nested } else { self.most }
    }

    /// Grids that are multiples of this number have nodes where the scene breaks. So do all the coarser grids from which the active
    /// set starts on the given number of intervals.
    fn nested(&self, intervals: usize) -> usize {
        let mut nested = self.common;
        while FEW * (nested / self.common) <= intervals {
            nested = nested.saturating_mul(NESTED);
        }
        nested
    }

    /// The tolerance of the next grid: the smaller one, if it reduced the error or the residual on the last grid.
    fn tolerance(&self, trials: &[Trial], last: &Trial) -> f64 {
        let first = trials.iter().find(|t| t.intervals == last.intervals).unwrap_or(last);
        let helped = last.error < 0.5 * first.error || self.demand.residual < first.residual;
        if helped || first.tolerance < self.loose { last.tolerance } else { self.loose }
    }
}

#[expect(clippy::cast_precision_loss, reason = "grids stay far below 2⁵³ intervals")]
fn as_number(intervals: usize) -> f64 {
    intervals as f64
}

/// Whether refinement by [`STALL`] did not even halve the error.
fn stalled(trials: &[Trial]) -> bool {
    let least = |trials: &mut dyn Iterator<Item = &Trial>| trials.map(|t| t.error).fold(f64::INFINITY, f64::min);
    let finest = trials.last().map_or(0, |t| t.intervals);
    let old = |t: &&Trial| t.intervals <= finest / STALL;
    let before = least(&mut trials.iter().filter(old));
    let since = least(&mut trials.iter().filter(|t| !old(t)));
    trials.iter().any(|t| old(&t)) && 0.5 * before <= since
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::route::Method;
    use crate::scene::{Beam, Foundation, Load};

    fn plan(error: f64) -> Plan {
        let beam = Beam::new(10.0, 500.0 / 384.0).expect("a beam");
        let load = Load::uniform_on(&beam, 1.0).expect("a load");
        let scene = Scene::new(beam, load, Some(Foundation::Flat { depth: 1.0 })).expect("well posed");
        Plan::new(&scene, &Request::new(Method::Force, Solver::ActiveSet, error))
    }

    /// A trial whose error is `law(N)`.
    fn tried(plan: &Plan, (intervals, tolerance): (usize, f64), law: impl Fn(f64) -> f64) -> Trial {
        let error = law(as_number(intervals));
        let refusal = (plan.demand.error < error).then_some(Refusal::Error { share: error, most: plan.demand.error });
        let (residual, contacts_proven, reports_success) = (0.0, true, true);
        Trial {
            intervals,
            tolerance,
            unknowns: 0,
            iterations: 0,
            work: 0,
            residual,
            error,
            contacts_proven,
            reports_success,
            refusal,
        }
    }

    /// The grids for a given error law, and how the search ended.
    fn search(error: f64, law: impl Fn(f64) -> f64) -> (Vec<usize>, End) {
        let plan = plan(error);
        let mut trials = vec![tried(&plan, plan.start(), &law)];
        loop {
            match plan.next(&trials) {
                Next::Solve { intervals, tolerance } => trials.push(tried(&plan, (intervals, tolerance), &law)),
                Next::End(end) => return (trials.iter().map(|t| t.intervals).collect(), end),
            }
        }
    }

    #[test]
    fn a_power_law_is_followed_without_waste() {
        // The first step assumes second order; with a higher order it goes too far.
        for order in [1.0, ORDER] {
            for error in [1e-2, 1e-3, 1e-4] {
                let (grids, end) = search(error, |n| libm::pow(n, -order));
                let (needed, last) = (libm::pow(error, -1.0 / order), as_number(*grids.last().expect("a grid")));
                assert_eq!(end, End::Reached, "{grids:?}");
                // Allowed for: the margin, the smallest step, rounding up to a grid that fits, and the first grid.
                let most = (MARGIN * LEAST_STEP * NEAR * needed + 2.0).max(as_number(START));
                assert!(needed <= last && last <= most, "order {order}, {error}: {needed} of {grids:?}");
                assert!(grids.iter().sum::<usize>() <= 3 * grids[grids.len() - 1], "{grids:?}");
            }
        }
    }

    #[test]
    fn a_floor_is_seen() {
        let (grids, end) = search(1e-12, |n| libm::pow(n, -2.0).max(1e-4));
        assert!(matches!(end, End::Stalled { intervals } if intervals <= 100_000), "{grids:?}");
        let (grids, end) = search(1e-3, |_| f64::INFINITY);
        assert!(matches!(end, End::Stalled { .. }), "nothing can be proven: {grids:?}");
    }

    #[test]
    fn the_work_of_all_grids_together_has_a_limit() {
        let plan = plan(1e-12);
        let first = tried(&plan, plan.start(), |n| 1.0 / n);
        let second = tried(&plan, (64, first.tolerance), |n| 1.0 / n);
        let next = |work| plan.next(&[Trial { work: 7, ..first }, Trial { work, ..second }]);
        assert!(matches!(next(MOST_WORK - 8), Next::Solve { .. }));
        assert_eq!(next(MOST_WORK - 7), Next::End(End::Spent { intervals: 64, most: MOST_WORK }));
    }

    #[test]
    fn a_strict_tolerance_is_kept_where_it_halves_the_error() {
        let plan = plan(1e-3);
        for (error, strict) in [(0.09, false), (0.04, true)] {
            let trials =
                [(plan.loose, 0.1), (1e-3 * plan.loose, error)].map(|(asked, e)| tried(&plan, (64, asked), |_| e));
            let expected = trials[usize::from(strict)].tolerance;
            assert_eq!(plan.tolerance(&trials, &trials[1]).to_bits(), expected.to_bits());
        }
    }

    #[test]
    fn the_finest_grid_is_the_last() {
        let (grids, end) = search(1e-12, |n| 1.0 / n);
        assert!(matches!(end, End::Limit { intervals } if 900_000 < intervals && intervals <= 1_000_000), "{grids:?}");
    }
}
