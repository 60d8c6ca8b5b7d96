//! Nested grids: the active set starts from the contact of a coarser grid, so that only the neighbourhood of lift-off points
//! has to change.
//!
//! Where a programme can be [settled](guess_from) in neighbourhoods, coarser grids only have to give a good guess, and the
//! whole beam is solved on small grids and on the finest alone. Each of the others makes the error of the lift-off points
//! smaller at a price that does not grow with the grid. Only where neighbourhoods grow too large a grid is solved.

mod refined;

use crate::methods::{Discrete, Method};
use crate::route::Solver;
use crate::scene::{Scene, SceneError};
use crate::solvers::{Answer, active_set_counted, active_set_from, guess_from};
use refined::refined;

/// Up to here the paper's start, all variables free, takes a handful of solves.
const COARSEST: usize = 30;

/// From here on a grid is guessed from, and the next one may be finer by more.
const GUESSED: usize = 1000;

/// Refinement of grids that are solved, and of those that are guessed from.
const REFINEMENT: [usize; 2] = [2, 8];

/// Solves on nested grids. Solves on all grids count.
pub(crate) fn solve(scene: &Scene, method: Method, discrete: &Discrete) -> Result<Answer, SceneError> {
    Ok(counted(scene, method, discrete)?.0)
}

/// The answer, and the number of solves of the whole on the finest grid.
fn counted(scene: &Scene, method: Method, discrete: &Discrete) -> Result<(Answer, usize), SceneError> {
    let programme = method.programme(discrete);
    let Some((free, spent)) = start(scene, method, discrete.intervals)? else {
        let answer = Solver::ActiveSet.run(programme.as_ref(), 0.0);
        let whole = answer.iterations;
        return Ok((answer, whole));
    };
    let (answer, whole) = active_set_counted(programme.as_ref(), free);
    let Spent { solves, work } = spent.and(answer.iterations, answer.work);
    Ok((Answer { iterations: solves, work, ..answer }, whole))
}

/// What coarser grids cost: numbers of solves, and of variables in them.
#[derive(Clone, Copy, Default)]
struct Spent {
    solves: usize,
    work: usize,
}

impl Spent {
    fn and(self, solves: usize, work: usize) -> Self {
        Self { solves: self.solves + solves, work: self.work + work }
    }
}

/// The face to start from on a grid, by a coarser one, and what it cost; [`None`] on the coarsest.
fn start(scene: &Scene, method: Method, intervals: usize) -> Result<Option<(Vec<bool>, Spent)>, SceneError> {
    let coarse = intervals / REFINEMENT[usize::from(method.is_guessed(intervals))];
    if coarse < COARSEST {
        return Ok(None);
    }
    let (touching, spent) = contact(scene, method, coarse)?;
    Ok(Some((method.face(refined(&touching, intervals)), spent)))
}

/// Contact at the interior nodes of a coarse grid, and what it cost.
fn contact(scene: &Scene, method: Method, intervals: usize) -> Result<(Vec<bool>, Spent), SceneError> {
    let discrete = Discrete::new(scene, intervals)?;
    let programme = method.programme(&discrete);
    let (answer, before) = match start(scene, method, intervals)? {
        None => (Solver::ActiveSet.run(programme.as_ref(), 0.0), Spent::default()),
        Some((free, before)) if method.is_guessed(intervals) => {
            let guess = guess_from(programme.as_ref(), free);
            let spent = before.and(guess.solves, guess.work);
            if guess.settled {
                return Ok((method.face(guess.free), spent));
            }
            (active_set_from(programme.as_ref(), guess.free), spent)
        }
        Some((free, before)) => (active_set_from(programme.as_ref(), free), before),
    };
    let spent = before.and(answer.iterations, answer.work);
    let nodal = method.nodal(&discrete, answer.x, answer.gradient);
    Ok((nodal.contact_force.iter().map(|p| 0.0 < *p).collect(), spent))
}

impl Method {
    /// The free variables of a contact set, or the contact set of free variables: forces are free where there is contact,
    /// clearances where there is none.
    fn face(self, flags: Vec<bool>) -> Vec<bool> {
        if self == Self::Force { flags } else { flags.into_iter().map(|flag| !flag).collect() }
    }

    /// Whether a grid is fine enough to be guessed from: by programmes that can be solved near some variables only.
    fn is_guessed(self, intervals: usize) -> bool {
        self != Self::Complementarity && GUESSED <= intervals
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::paper::uneven::{Unevenness, scenes};

    /// Kinks between the nodes of a grid leave holes behind them that exchanges wander through: thousands of solves of the
    /// whole beam, once. Windows take that upon themselves.
    #[test]
    fn the_whole_beam_is_solved_a_few_times_only() {
        /// One that confirms what windows have found, as a rule; the worst of two thousand scenes needs fifty.
        const FEW: usize = 10;
        for kind in Unevenness::ALL {
            for scene in scenes(kind, 12, 5).expect("scenes") {
                let scaled = scene.scaled().expect("in range");
                let discrete = Discrete::new(&scaled.scene, 16_000).expect("a grid");
                let (answer, whole) = counted(&scaled.scene, Method::Force, &discrete).expect("in range");
                assert!(answer.claims_success && whole <= FEW, "{}: {whole} solves of the whole", kind.word());
            }
        }
    }
}
