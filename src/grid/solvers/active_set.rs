//! An active-set solver that continues where the paper's four steps stop, and always ends.
//!
//! The four steps drop variables one by one and never release any. This solver also releases variables whose gradient is negative,
//! and changes many at a time.
//!
//! **Exchanges.** An exchange drops all free variables that came out negative. Of each run of neighbours with a negative gradient it
//! releases the steepest one. Exchanges continue as long as the runs on the wrong side become fewer, and a few times in all if they
//! do not. Ten exchanges settle most of a set. The rest of the set cycles, at a few places.
//!
//! **Descent.** After that the objective decreases from one face minimum to the next, where a face is a set of free variables:
//!
//! 1. *Feasible*: solve step 1° on the face, drop the most negative variable of each run of neighbours that came out negative, and
//!    repeat until none does.
//! 2. *Release*: release the steepest variable of each run of neighbours with a negative gradient, and make the face feasible as
//!    before. Releasing whole runs would be far too much: most of a run would be on the wrong side next.
//! 3. *Walk*, if the objective is not lower after 2: from the point before the release towards the minimum on the larger face,
//!    leaving that face where a variable reaches zero on the way, as Lawson and Hanson do.
//!
//! If the matrix is only semidefinite, a walk comes to corners at which no smaller face has a solution. Of the variables that reach
//! zero together there, those without which the rest has no solution stay in the set, at zero.
//!
//! *It ends.* A face shrinks in 1, so that 1 ends. There is one exception. If the matrix is only semidefinite and the smaller face
//! has no solution, 1 begins again on a face that has one ([`Qp::make_definite`]). Then only the limit on the number of solves ends
//! it. The objective strictly decreases from one round to the next: in 2 by comparison, and in 3 for the following reason. The point
//! before is the minimum on its own face. A released variable with a negative gradient leads down from it, and the last of the
//! released variables that is left cannot come out negative. Each round ends at a feasible face minimum and no face occurs twice.
//! There are finitely many faces, and the optimum is reached where no gradient is negative. In floating-point arithmetic a decrease
//! may be smaller than rounding. The limit on the number of solves then ends the descent, and the answer is not called optimal.
//!
//! The two objectives are not computed, because their difference would cancel. At a face minimum `x_i g_i = 0`, so that
//!
//! ```text
//! f(x₂) − f(x₁) = ½ (g₁ + g₂)ᵀ (x₂ − x₁) = ½ (g₁ᵀ x₂ − g₂ᵀ x₁)
//! ```
//!
//! and only variables that were released or dropped contribute.
//!
//! *Ties*, `x_i = 0` and `g_i = 0` up to the rounding of a [solve](Qp::stationary), stay on the side where they are.

// Discrepancy: beyond-four-steps
//
// The paper continues with "some algorithm of nonlinear optimisation". Ours fixes and releases many variables at a time (Portugal,
// Júdice and Vicente 1994), with the step of Lawson and Hanson (1974) that makes it finite.

use super::{Answer, MOST_WORK, Run};
use crate::qp::{FreeSet, NotPositiveDefinite, Qp, Stationary};

/// Exchanges continue while the number of runs on the wrong side falls by this part, `1/FEWER`, below its minimum so far.
const FEWER: usize = 10;

/// Total number of exchanges that need not reduce the runs on the wrong side. The second exchange may undo part of the first.
pub(crate) const PATIENCE: usize = 5;

/// Limit on the solves of a descent, which only rounding can exceed: this many, and this many per variable. Of the slowest known
/// instances some need a few hundred, and two thousand where all variables change together.
const EXHAUSTED: [usize; 2] = [200, 20];

/// The settings as text.
pub(super) fn settings_text() -> String {
    format!(
        "exchanges, then a descent; a sign counts if it is larger than the rounding of a solve; a budget of {} million unknowns \
         in all solves together",
        MOST_WORK / 1_000_000,
    )
}

/// Solves with every variable free at first, like the paper's algorithm.
pub(super) fn solve(qp: &dyn Qp) -> Answer {
    solve_from(qp, FreeSet::all(qp.dimension()))
}

/// Solves from a given set of free variables.
pub(super) fn solve_from(qp: &dyn Qp, mut free: FreeSet) -> Answer {
    let (mut solves, mut idle) = (0, 0);
    let patient = |_: &mut FreeSet, _: &[usize]| {
        idle += 1;
        Ok(idle <= PATIENCE)
    };
    let end = optimum(&mut Reduced::of(qp), &mut free, &mut solves, patient);
    answer(end, qp.dimension(), solves, solves * qp.solve_work())
}

/// The answer for the end of a run.
pub(crate) fn answer(
    end: Result<(Stationary, bool), NotPositiveDefinite>,
    n: usize,
    iterations: usize,
    work: usize,
) -> Answer {
    let run = |reports_success, message| Run { reports_success, message, iterations, work, ..Run::default() };
    match end {
        Ok((Stationary { x, gradient }, optimal)) => {
            let message = match optimal {
                true => "optimal".to_owned(),
                false if MOST_WORK <= work => format!(
                    "not converged: {iterations} solves went through {work} unknowns, {MOST_WORK} is the limit of this solver"
                ),
                false => "no further descent above rounding".to_owned(),
            };
            Answer { x, gradient, run: run(optimal, message) }
        }
        Err(error) => Answer::without_numbers(n, run(false, error.to_string())),
    }
}

/// The optimum by exchanges. After an exchange without fewer runs, `stalled` is called with the variables on the wrong side. It may
/// change the free set, and returns whether to continue with exchanges. If not, a descent follows. Returns the point, and whether no
/// variable is on the wrong side, which is not certain once the limit on solves is reached. `solves` counts the solves.
pub(crate) fn optimum(
    reduced: &mut Reduced<'_>,
    free: &mut FreeSet,
    solves: &mut usize,
    mut stalled: impl FnMut(&mut FreeSet, &[usize]) -> Result<bool, NotPositiveDefinite>,
) -> Result<(Stationary, bool), NotPositiveDefinite> {
    let mut fewest = usize::MAX;
    loop {
        *solves += 1;
        (reduced.make_definite)(free);
        let point = (reduced.point)(free)?;
        let wrong = violators(&point, free);
        if wrong.is_empty() {
            return Ok((point, true));
        }
        if reduced.most_solves <= *solves {
            return Ok((point, false));
        }
        exchange(free, 0, &wrong, &point.gradient);
        let runs = wrong.chunk_by(|i, j| i + 1 == *j).count();
        if runs < fewest - fewest / FEWER {
            fewest = runs;
        } else if !stalled(free, &wrong)? {
            return descend(reduced, free, solves);
        }
    }
}

/// Drops those of the variables on the wrong side that are free. Of each run of the others, releases the one with the smallest
/// gradient. Variables and gradients count from `start`.
pub(crate) fn exchange(free: &mut FreeSet, start: usize, wrong: &[usize], gradient: &[f64]) {
    wrong.iter().for_each(|&k| free.set(start + k, false));
    each_steepest(wrong, gradient, |k| free.set(start + k, true));
}

/// Step 1° of the paper's algorithm, see [`Qp::stationary`].
pub(crate) type PointOn<'a> = Box<dyn FnMut(&FreeSet) -> Result<Stationary, NotPositiveDefinite> + 'a>;

/// The part of a quadratic program that is used here: the stationary point for a set of free variables. It may represent part of a
/// larger program, with the variables of that part only.
pub(crate) struct Reduced<'a> {
    pub(crate) point: PointOn<'a>,
    /// See [`Qp::make_definite`].
    pub(crate) make_definite: Box<dyn Fn(&mut FreeSet) + 'a>,
    /// Number of solves after which a run ends in any case.
    pub(crate) most_solves: usize,
}

impl<'a> Reduced<'a> {
    /// The whole of a quadratic program.
    pub(super) fn of(qp: &'a dyn Qp) -> Self {
        let most_solves = solves_within(MOST_WORK, qp.solve_work());
        Self {
            point: Box::new(|free| qp.stationary(free)),
            make_definite: Box::new(|free| qp.make_definite(free)),
            most_solves,
        }
    }
}

/// The number of solves of `n` unknowns that use up `work`.
pub(crate) fn solves_within(work: usize, n: usize) -> usize {
    work.div_ceil(n.max(1))
}

/// The variables on the wrong side at a point: free variables that are negative, and variables fixed at zero with a negative gradient.
pub(crate) fn violators(point: &Stationary, free: &FreeSet) -> Vec<usize> {
    /// Usually there are no violators, or few.
    const FEW: usize = 32;
    let mut wrong = Vec::new();
    for (k, ((x, slope), free)) in point.x.iter().zip(&point.gradient).zip(free.iter()).enumerate() {
        if (if free { *x } else { *slope }) < 0.0 {
            if wrong.is_empty() {
                wrong.reserve(FEW);
            }
            wrong.push(k);
        }
    }
    wrong
}

/// The variable with the smallest value of each run of neighbours with negative values. For gradients, these are the variables to
/// release.
pub(super) fn steepest(variables: &[usize], values: &[f64]) -> Vec<usize> {
    let mut steepest = Vec::new();
    each_steepest(variables, values, |k| steepest.push(k));
    steepest
}

/// The same, one variable at a time.
fn each_steepest(variables: &[usize], values: &[f64], mut visit: impl FnMut(usize)) {
    // The current run: its last variable, and the variable with its smallest value.
    let mut run: Option<[usize; 2]> = None;
    for &k in variables.iter().filter(|&&k| values[k] < 0.0) {
        run = Some(match run {
            Some([last, least]) if last + 1 == k => [k, if values[k] < values[least] { k } else { least }],
            ended => {
                ended.into_iter().for_each(|[_, least]| visit(least));
                [k, k]
            }
        });
    }
    run.into_iter().for_each(|[_, least]| visit(least));
}

/// Changes the free variables until the point is optimal. Returns the point, and whether no variable is on the wrong side. `solves`
/// counts the solves.
pub(crate) fn descend(
    reduced: &mut Reduced<'_>,
    free: &mut FreeSet,
    solves: &mut usize,
) -> Result<(Stationary, bool), NotPositiveDefinite> {
    let most = (*solves + EXHAUSTED[0] + EXHAUSTED[1] * free.dimension() + 1).min(reduced.most_solves);
    let mut point = feasible(reduced, free, solves, most)?;
    loop {
        let wrong = violators(&point, free);
        if wrong.is_empty() {
            return Ok((point, true));
        }
        if most <= *solves {
            return Ok((point, false));
        }
        let released = steepest(&wrong, &point.gradient);
        let mut larger = free.clone();
        released.iter().for_each(|&i| larger.set(i, true));
        free.clone_from(&larger);
        let next = feasible(reduced, free, solves, most)?;
        if change(&point, &next) < 0.0 {
            point = next;
        } else {
            released.iter().for_each(|&i| larger.set(i, false));
            *free = larger;
            set_definite(reduced, free, &released, true);
            point = walk(reduced, point, free, solves)?;
        }
    }
}

/// Drops the most negative variable of each run until none is negative, or until `most` solves are made. The limit is needed where
/// only variables that are negative by rounding make the problem definite: they are dropped and put back for ever.
fn feasible(
    reduced: &mut Reduced<'_>,
    free: &mut FreeSet,
    solves: &mut usize,
    most: usize,
) -> Result<Stationary, NotPositiveDefinite> {
    loop {
        *solves += 1;
        (reduced.make_definite)(free);
        let point = (reduced.point)(free)?;
        let negative: Vec<usize> = free.variables().filter(|&i| point.x[i] < 0.0).collect();
        if negative.is_empty() || most <= *solves {
            return Ok(point);
        }
        steepest(&negative, &point.x).into_iter().for_each(|i| free.set(i, false));
    }
}

/// Walks from a feasible point to the minimum on a larger face, leaving that face where a variable reaches zero on the way. At the
/// limit on solves it returns the minimum on the face, feasible or not.
fn walk(
    reduced: &mut Reduced<'_>,
    from: Stationary,
    free: &mut FreeSet,
    solves: &mut usize,
) -> Result<Stationary, NotPositiveDefinite> {
    let mut x: Vec<f64> = from.x.into_iter().map(|x| x.max(0.0)).collect();
    loop {
        *solves += 1;
        let target = (reduced.point)(free)?;
        let way = |i: usize| x[i] / (x[i] - target.x[i]);
        let blocked: Vec<usize> = free.variables().filter(|&i| target.x[i] < 0.0 && target.x[i] < x[i]).collect();
        let step = blocked.iter().map(|&i| way(i)).fold(1.0, f64::min);
        let blocking: Vec<usize> = blocked.into_iter().filter(|&i| way(i) <= step).collect();
        if reduced.most_solves <= *solves || set_definite(reduced, free, &blocking, false) == 0 {
            return Ok(target);
        }
        for (x, target) in x.iter_mut().zip(&target.x) {
            *x = (*x + step * (target - *x)).max(0.0);
        }
        blocking.into_iter().for_each(|i| x[i] = 0.0);
    }
}

/// Frees or drops variables. Leaves out the last of them if the face would otherwise have no solution. Returns how many it changed.
fn set_definite(reduced: &Reduced<'_>, free: &mut FreeSet, variables: &[usize], to: bool) -> usize {
    let is_definite = |free: &FreeSet| {
        let mut definite = free.clone();
        (reduced.make_definite)(&mut definite);
        definite == *free
    };
    variables.iter().for_each(|&i| free.set(i, to));
    let mut changed = variables.len();
    while 0 < changed && !is_definite(free) {
        changed -= 1;
        free.set(variables[changed], !to);
    }
    changed
}

/// The change of the objective from one face minimum to another.
fn change(from: &Stationary, to: &Stationary) -> f64 {
    let terms = from.x.iter().zip(&from.gradient).zip(to.x.iter().zip(&to.gradient));
    0.5 * terms.map(|((x, g), (next_x, next_g))| g * next_x - next_g * x).sum::<f64>()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::qp::{Explicit, Profile};

    /// A chain in which many variables have to be dropped and released again.
    fn chain(n: usize) -> Explicit {
        let entry = |i: usize, j: usize| match i.abs_diff(j) {
            0 => 6.0,
            1 => -4.0,
            2 => 1.0,
            _ => 0.0,
        };
        let linear: Vec<f64> = (0..n).map(|i| if i % 5 < 2 { 1.0 } else { -1.0 }).collect();
        Explicit::new(Profile::full(n, entry), &linear).expect("positive definite")
    }

    /// By exchanges and by a descent, for every limit: a step that has begun makes at most two more solves.
    #[test]
    fn a_run_ends_at_its_limit_of_solves() {
        for n in [20, 40, 70] {
            let qp = chain(n);
            for by_descent in [false, true] {
                let run = |most_solves: usize| {
                    let (mut free, mut solves) = (FreeSet::all(n), 0);
                    let mut reduced = Reduced { most_solves, ..Reduced::of(&qp) };
                    let end = match by_descent {
                        true => descend(&mut reduced, &mut free, &mut solves),
                        false => optimum(&mut reduced, &mut free, &mut solves, |_, _| Ok(true)),
                    };
                    (end.expect("definite").1, solves)
                };
                let (optimal, needed) = run(usize::MAX);
                assert!(optimal && 3 < needed, "{n}: {needed} solves");
                assert_eq!(run(needed), (true, needed), "as many as are needed");
                for most in 1..needed {
                    let (optimal, solves) = run(most);
                    assert!(solves <= most + 2, "{n}: {solves} solves, {most} is the limit");
                    assert!(!optimal || needed <= most + 2, "{n}: optimal after {solves}, {needed} are needed");
                }
            }
        }
    }

    #[test]
    fn the_last_solve_reaches_the_limit_of_work() {
        for n in [1, 2, 1000, 999_999, 9_999_999] {
            let most = solves_within(MOST_WORK, n);
            assert!(MOST_WORK <= most * n && (most - 1) * n < MOST_WORK, "{n}");
        }
        assert_eq!(solves_within(0, 5), 0, "nothing is left");
    }
}
