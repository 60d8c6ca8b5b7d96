//! The optimum of a window, from face minimum to face minimum.
//!
//! 1. *Feasible*: solve step 1° on the face, drop of each run of neighbours that came out negative the most negative one,
//!    and again, until none does.
//! 2. *Release*: of each run of neighbours with a negative gradient the steepest one, and make that feasible as in 1. A run
//!    as a whole would be far too much: most of it would be on the wrong side next.
//! 3. *Walk*, if the objective is not lower after 2: from the point before the release towards the minimum on the larger
//!    face, leaving that face where a variable reaches zero on the way, as Lawson and Hanson do.
//!
//! *It ends.* A face shrinks in 1, so that 1 ends. The objective falls strictly from one round to the next: in 2 by
//! comparison, and in 3 because the point before is the minimum on its own face, from which a released variable with a
//! negative gradient leads down, and the last one that is left of them cannot come out negative. Each round ends at a
//! feasible face minimum, no face is met twice, there are finitely many, and where no gradient is negative the optimum is
//! reached. In floating-point arithmetic, where a strict descent can drown in rounding, a limit on the number of solves says so.
//!
//! The two objectives are not computed, since their difference would cancel. On a face minimum `x_i g_i = 0`, so that
//!
//! ```text
//! f(x₂) − f(x₁) = ½ (g₁ + g₂)ᵀ (x₂ − x₁) = ½ (g₁ᵀ x₂ − g₂ᵀ x₁)
//! ```
//!
//! and only variables that were released or dropped contribute.
//!
//! *Ties*, `x_i = 0` and `g_i = 0` within the [rounding](Programme::rounding) of the solves, stay on the side where they are.

use std::ops::Range;

use crate::problem::{NotPositiveDefinite, Programme, Stationary};

/// Solves of a window that only rounding can need: so many, and as many for each of its variables. Of the slowest known
/// instances some take a few hundred, and two thousand where a programme has no windows.
const EXHAUSTED: [usize; 2] = [200, 20];

/// Number of solves.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub(crate) struct Cost {
    /// Of the whole.
    pub(crate) whole: usize,
    /// Of windows.
    pub(crate) windows: usize,
    /// Variables in all of them.
    pub(crate) variables: usize,
}

/// Signs below zero that count at a point: more than the rounding of the solves.
struct Signs {
    x: f64,
    gradient: f64,
}

impl Signs {
    fn at(programme: &dyn Programme, point: &Stationary) -> Self {
        let sizes = programme.sizes();
        let (mut x, mut gradient) = (sizes.x, sizes.gradient);
        for (value, slope) in point.x.iter().zip(&point.gradient) {
            // Not `max`: a comparison is all that a number needs.
            x = if x < value.abs() { value.abs() } else { x };
            gradient = if gradient < slope.abs() { slope.abs() } else { gradient };
        }
        Self { x: -programme.rounding() * x, gradient: -programme.rounding() * gradient }
    }
}

/// Variables with a negative sign at a point: free ones that are negative, and those at zero with a negative gradient, in the
/// order of the point.
pub(super) struct Violators {
    /// By more than rounding: these are on the wrong side.
    pub(super) wrong: Vec<usize>,
    /// By no more than that.
    rounded: Vec<usize>,
}

impl Violators {
    /// One pass; `free` is in the order of the point.
    pub(super) fn of(programme: &dyn Programme, point: &Stationary, free: impl Iterator<Item = bool>) -> Self {
        let values = point.x.iter().zip(&point.gradient).zip(free).enumerate();
        let negative = values.filter(|(_, ((x, slope), free))| if *free { **x < 0.0 } else { **slope < 0.0 });
        let doubtful: Vec<(usize, bool)> = negative.map(|(k, (_, free))| (k, free)).collect();
        // Sizes of a million numbers are wanted only if one of them is on the wrong side.
        if doubtful.is_empty() {
            return Self { wrong: Vec::new(), rounded: Vec::new() };
        }
        let signs = Signs::at(programme, point);
        let is_wrong =
            |&(k, free): &(usize, bool)| if free { point.x[k] < signs.x } else { point.gradient[k] < signs.gradient };
        let (wrong, rounded): (Vec<_>, Vec<_>) = doubtful.into_iter().partition(is_wrong);
        let places = |doubtful: Vec<(usize, bool)>| doubtful.into_iter().map(|(k, _)| k).collect();
        Self { wrong: places(wrong), rounded: places(rounded) }
    }

    /// An optimal point without the rounding below zero.
    pub(super) fn clipped(&self, mut point: Stationary) -> Stationary {
        for &k in &self.rounded {
            point.x[k] = point.x[k].max(0.0);
            point.gradient[k] = point.gradient[k].max(0.0);
        }
        point
    }
}

/// Of each run of neighbours with a negative value the one with the smallest: of gradients, those to release.
pub(super) fn steepest(variables: &[usize], values: &[f64]) -> Vec<usize> {
    let steep: Vec<usize> = variables.iter().copied().filter(|&k| values[k] < 0.0).collect();
    let runs = steep.chunk_by(|i, j| i + 1 == *j);
    runs.filter_map(|run| run.iter().copied().min_by(|&i, &j| values[i].total_cmp(&values[j]))).collect()
}

/// A window whose optimum is looked for.
pub(super) struct Descent<'a> {
    programme: &'a dyn Programme,
    /// The variables of the window.
    range: Range<usize>,
    solves: usize,
}

impl<'a> Descent<'a> {
    pub(super) fn new(programme: &'a dyn Programme, range: Range<usize>) -> Self {
        Self { programme, range, solves: 0 }
    }

    /// Changes `free`, the flags of all variables, in the window until it is optimal there. Returns the point, and whether
    /// nothing is on the wrong side.
    pub(super) fn run(mut self, free: &mut [bool], cost: &mut Cost) -> Result<(Stationary, bool), NotPositiveDefinite> {
        let end = self.optimum(free);
        *(if self.range.len() == free.len() { &mut cost.whole } else { &mut cost.windows }) += self.solves;
        cost.variables += self.solves * self.range.len();
        end
    }

    fn optimum(&mut self, free: &mut [bool]) -> Result<(Stationary, bool), NotPositiveDefinite> {
        let mut point = self.feasible(free)?;
        loop {
            let violators = Violators::of(self.programme, &point, free[self.range.clone()].iter().copied());
            if violators.wrong.is_empty() {
                return Ok((violators.clipped(point), true));
            }
            if EXHAUSTED[0] + EXHAUSTED[1] * self.range.len() < self.solves {
                return Ok((point, false));
            }
            let released = steepest(&violators.wrong, &point.gradient);
            let before = free[self.range.clone()].to_vec();
            self.release(free, &released);
            let next = self.feasible(free)?;
            if change(&point, &next) < 0.0 {
                point = next;
            } else {
                free[self.range.clone()].copy_from_slice(&before);
                self.release(free, &released);
                point = self.walk(point, free)?;
            }
        }
    }

    /// Step 1° on a face.
    fn minimum_on(&mut self, free: &[bool]) -> Result<Stationary, NotPositiveDefinite> {
        self.solves += 1;
        if self.range.len() == free.len() {
            self.programme.stationary(free)
        } else {
            self.programme.stationary_near(free, self.range.clone())
        }
    }

    fn release(&self, free: &mut [bool], released: &[usize]) {
        released.iter().for_each(|&k| free[self.range.start + k] = true);
    }

    /// Drops the most negative of each run until nothing comes out negative.
    fn feasible(&mut self, free: &mut [bool]) -> Result<Stationary, NotPositiveDefinite> {
        loop {
            let point = self.minimum_on(free)?;
            let signs = Signs::at(self.programme, &point);
            let negative: Vec<usize> =
                (0..point.x.len()).filter(|&k| free[self.range.start + k] && point.x[k] < signs.x).collect();
            if negative.is_empty() {
                return Ok(point);
            }
            steepest(&negative, &point.x).into_iter().for_each(|k| free[self.range.start + k] = false);
        }
    }

    /// Walks from a feasible point to the minimum on a larger face, leaving it where a variable reaches zero on the way.
    fn walk(&mut self, from: Stationary, free: &mut [bool]) -> Result<Stationary, NotPositiveDefinite> {
        let mut x: Vec<f64> = from.x.into_iter().map(|x| x.max(0.0)).collect();
        loop {
            let target = self.minimum_on(free)?;
            let least = Signs::at(self.programme, &target).x;
            let blocked = |k: usize, x: &[f64]| free[self.range.start + k] && target.x[k] < least && target.x[k] < x[k];
            let way = |k: usize, x: &[f64]| x[k] / (x[k] - target.x[k]);
            let step = (0..x.len()).filter(|&k| blocked(k, &x)).map(|k| way(k, &x)).fold(1.0, f64::min);
            let blocking: Vec<usize> = (0..x.len()).filter(|&k| blocked(k, &x) && way(k, &x) <= step).collect();
            if blocking.is_empty() {
                return Ok(target);
            }
            for (x, target) in x.iter_mut().zip(&target.x) {
                *x = (*x + step * (target - *x)).max(0.0);
            }
            for k in blocking {
                x[k] = 0.0;
                free[self.range.start + k] = false;
            }
        }
    }
}

/// By how much the objective changes from one face minimum to another.
fn change(from: &Stationary, to: &Stationary) -> f64 {
    let terms = from.x.iter().zip(&from.gradient).zip(to.x.iter().zip(&to.gradient));
    0.5 * terms.map(|((x, g), (next_x, next_g))| g * next_x - next_g * x).sum::<f64>()
}
