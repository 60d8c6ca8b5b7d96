//! Nested grids: the active set starts from the contact of a coarser grid, so that only the neighbourhood of lift-off points
//! has to change.
//!
//! Coarser grids only have to give a good guess. They are solved by the programme in contact forces, for beam or chain of links as
//! the method has it, near lift-off points where that is enough ([`guess_from`]); the method itself has the last word, on the
//! finest grid.

mod refined;

use crate::methods::{Discrete, Force, Method};
use crate::scene::{Scene, SceneError};
use crate::solvers::{Answer, active_set_counted, guess_from};
use crate::state::Bending;
use refined::refined;

/// Up to here the start with contact everywhere takes a handful of solves.
const COARSEST: usize = 30;

/// From here on the next grid may be finer by more: contact is wrong near lift-off points only.
const FINE: usize = 1000;

/// Refinement up to such grids, and of them.
const REFINEMENT: [usize; 2] = [2, 8];

/// Solves on nested grids. Solves on all grids count.
pub(crate) fn solve(scene: &Scene, method: Method, discrete: &Discrete) -> Result<Answer, SceneError> {
    Ok(counted(scene, method, discrete)?.0)
}

/// The answer, and the number of solves of the whole on the finest grid.
fn counted(scene: &Scene, method: Method, discrete: &Discrete) -> Result<(Answer, usize), SceneError> {
    let programme = method.programme(discrete);
    let (touching, spent) = start(scene, method.bending(), discrete.intervals)?;
    let (answer, whole) = active_set_counted(programme.as_ref(), method.face(touching));
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

/// Contact to start from on a grid, by a coarser one, and what it cost; everywhere on the coarsest.
fn start(scene: &Scene, bending: Bending, intervals: usize) -> Result<(Vec<bool>, Spent), SceneError> {
    let coarse = intervals / REFINEMENT[usize::from(FINE <= intervals)];
    if coarse < COARSEST {
        return Ok((vec![true; intervals - 1], Spent::default()));
    }
    let (touching, spent) = contact(scene, bending, coarse)?;
    Ok((refined(&touching, intervals), spent))
}

/// A guess of contact at the interior nodes of a coarse grid, and what it cost.
fn contact(scene: &Scene, bending: Bending, intervals: usize) -> Result<(Vec<bool>, Spent), SceneError> {
    let (touching, before) = start(scene, bending, intervals)?;
    let discrete = Discrete::new(scene, intervals)?;
    // Forces are free where there is contact.
    let guess = guess_from(&Force { discrete: &discrete, bending }, touching);
    Ok((guess.free, before.and(guess.solves, guess.work)))
}

impl Method {
    /// The free variables of a contact set: forces are free where there is contact, clearances where there is none.
    fn face(self, touching: Vec<bool>) -> Vec<bool> {
        if self == Self::Force { touching } else { touching.into_iter().map(|touches| !touches).collect() }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::{Beam, Foundation, Load};

    /// A beam above waves of many lengths and amplitudes, and above polylines through twelve uneven depths.
    fn scenes() -> impl Iterator<Item = Scene> {
        let beam = Beam::new(10.0, 500.0 / 384.0).expect("a beam");
        let load = Load::uniform_on(&beam, 1.0).expect("a load");
        // Multiples of the golden section are spread evenly between 0 and 1.
        let spread = |k: u32| (0.618_034 * f64::from(k)).fract();
        let wave = move |k: u32| Foundation::Cosine {
            mean: 1.0,
            amplitude: 0.05 + 0.45 * spread(3 * k + 1),
            wavelength: 1.5 + 10.5 * spread(3 * k + 2),
            phase: 6.25 * spread(3 * k + 3),
        };
        let rough = move |k: u32| Foundation::Polyline {
            points: (0..12).map(|i| [10.0 * f64::from(i) / 11.0, 0.5 + spread(5 * i * i + 7 * i * k + k)]).collect(),
        };
        let foundations = (0..12).flat_map(move |k| [wave(k), rough(k)]);
        foundations.map(move |foundation| Scene::new(beam, load.clone(), Some(foundation)).expect("well posed"))
    }

    /// Kinks between the nodes of a grid leave holes behind them that exchanges wander through: thousands of solves of the
    /// whole beam, once. Windows take that upon themselves.
    #[test]
    fn the_whole_beam_is_solved_a_few_times_only() {
        /// One that confirms what windows have found, as a rule; the worst of two thousand scenes needs fifty.
        const FEW: usize = 10;
        for scene in scenes() {
            let scaled = scene.scaled().expect("in range");
            let discrete = Discrete::new(&scaled.scene, 16_000).expect("a grid");
            let (answer, whole) = counted(&scaled.scene, Method::Force, &discrete).expect("in range");
            assert!(answer.claims_success && whole <= FEW, "{whole} solves of the whole: {:?}", scene.foundation());
        }
    }
}
