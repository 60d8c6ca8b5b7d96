//! The active set for grids of up to millions of nodes: nested grids, windows, and spans of any length at the cost of a short one.
//! This module only saves time. [`Solver::ActiveSet`](crate::solvers::Solver::ActiveSet) solves every quadratic program to the same
//! answer without it, but in a time that grows faster than the number of nodes.
//!
//! *Nested grids.* The active set starts from the contact of a coarser grid, so that only the neighbourhood of lift-off points has to
//! change. Coarser grids only need to give a good guess. For all methods the beam, or chain of links, on a set of contacts is solved
//! in the same way. The variables exchanged here are its contact forces, as in the force method: they are free where there is
//! contact. If the foundation is rough between the nodes of a coarser grid, its contact is a bad guess, and the caller can give a
//! better one.
//!
//! *Windows* (`windows.rs`) surround the borders of contact, where a guess from a coarser grid is usually wrong. They are solved
//! separately before the whole. An optimum is returned only after a solve of the whole with all signs right.

mod local_beam;
mod refined;
mod spans;
mod windows;

use crate::methods::{Discrete, Method};
use crate::qp::{FreeSet, NotPositiveDefinite, Stationary};
use crate::scene::{Grid, Scene, SceneError};
use crate::solvers::active_set::{PATIENCE, Reduced, optimum, solves_within, violators};
use crate::solvers::{Answer, MOST_WORK, active_set};
use crate::state::Contact;
use local_beam::LocalBeam;
use refined::refined;
use windows::Windows;

/// Smallest number of intervals of a coarser grid; with fewer, contact is a bad guess. *Tuned* on waves and rough polylines of 20 to
/// 3000 intervals. Of 10, 15 and 30 it needs the least work on all of these grids, a third less than 30 on a hundred intervals.
const COARSEST: usize = 10;

/// From this number of intervals on, the refinement to the next grid may be larger: contact is then wrong near lift-off points only.
const FINE: usize = 1000;

/// Refinement to grids below this number, and from it on.
const REFINEMENT: [usize; 2] = [2, 8];

/// The cost of solves.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
struct Cost {
    /// Solves of the whole beam.
    whole: usize,
    /// Solves of windows.
    windows: usize,
    /// Variables in all these solves.
    work: usize,
}

/// The optimum of a scene on a grid in contact forces: `x = p`, `g = h`, whatever the unknowns of the method are. The cost includes
/// the solves on all grids. The start is `near` if given, otherwise the contact of coarser grids.
///
/// # Errors
///
/// None for a grid that exists. The error type is that of [`Discrete::new`].
pub(crate) fn solve(
    scene: &Scene,
    method: Method,
    discrete: &Discrete,
    near: Option<FreeSet>,
) -> Result<Answer, SceneError> {
    let mut cost = Cost::default();
    let mut free = match near {
        Some(near) => near,
        None => start(scene, method, discrete, &mut cost)?,
    };
    let beam = LocalBeam::new(discrete, method.discretisation());
    let end = if discrete.gives() {
        by_newton(&beam, &mut free, &mut cost)
    } else if discrete.tension != 0.0 {
        whole(&beam, &mut free, &mut cost)
    } else {
        Windows { beam: &beam, cost: &mut cost }.optimum(&mut free)
    };
    Ok(active_set::answer(end, discrete.nodes().len(), cost.whole + cost.windows, cost.work))
}

/// Intervals of the next coarser grid, if there is one. The grid used has fewer if its nodes would miss a support.
pub(crate) fn coarser(intervals: usize) -> Option<usize> {
    let coarse = intervals / REFINEMENT[usize::from(FINE <= intervals)];
    (COARSEST <= coarse).then_some(coarse)
}

/// Contact at the nodes nearest to the given contacts of a beam of this length.
pub(crate) fn nearest(discrete: &Discrete, contacts: &[Contact], length: f64) -> FreeSet {
    let nodes = discrete.nodes();
    let mut free = FreeSet::none(nodes.len());
    for contact in contacts {
        let [from, to] = [contact.from, contact.to].map(|x| discrete.grid.nearest(x / length));
        let from = from.max(nodes.start);
        let to = (to + 1).min(nodes.end);
        if from < to {
            free.release(from - nodes.start..to - nodes.start);
        }
    }
    free
}

/// The contact to start from on a grid: that of a coarser grid which also has a node at each support, or contact everywhere if there
/// is no such grid.
fn start(scene: &Scene, method: Method, discrete: &Discrete, cost: &mut Cost) -> Result<FreeSet, SceneError> {
    let intervals = discrete.intervals;
    let coarse = coarser(intervals).zip(Grid::step(scene)).map_or(0, |(coarse, step)| coarse / step * step);
    if coarse < COARSEST {
        return Ok(FreeSet::all(discrete.nodes().len()));
    }
    let coarse = discrete.coarser(scene, coarse)?;
    let mut free = start(scene, method, &coarse, cost)?;
    let beam = LocalBeam::new(&coarse, method.discretisation());
    if discrete.gives() {
        // A solve that fails here fails again on the finest grid, which returns the error.
        let _ = by_newton(&beam, &mut free, cost);
    } else if discrete.tension != 0.0 {
        let _ = whole(&beam, &mut free, cost);
    } else {
        Windows { beam: &beam, cost }.guess(&mut free);
    }
    Ok(refined(&free, intervals, discrete.held_ends()))
}

/// The optimum on an elastic foundation. A change at one contact changes the forces at all others, so there are no windows. All
/// variables on the wrong side change together, which is Newton's method for compression-only springs. If it does not end, the
/// exchanges and descent of the active set follow.
fn by_newton(
    beam: &LocalBeam<'_>,
    free: &mut FreeSet,
    cost: &mut Cost,
) -> Result<(Stationary, bool), NotPositiveDefinite> {
    /// A handful of steps is usual.
    const STEPS: usize = 60;
    let n = free.dimension();
    let mut whole = all_of(beam, n, cost);
    let mut solves = 0;
    let mut settled = None;
    while solves < STEPS.min(whole.most_solves) && settled.is_none() {
        solves += 1;
        (whole.make_definite)(free);
        let point = (whole.point)(free)?;
        let wrong = violators(&point, free);
        wrong.iter().for_each(|&i| free.set(i, !free.contains(i)));
        settled = wrong.is_empty().then_some(point);
    }
    let end = match settled {
        Some(point) => Ok((point, true)),
        None => optimum(&mut whole, free, &mut solves, |_, _| Ok(false)),
    };
    cost.whole += solves;
    cost.work += solves * n;
    end
}

/// The optimum under an axial force. Compression transmits a change at one contact to many others, so there are no windows.
fn whole(beam: &LocalBeam<'_>, free: &mut FreeSet, cost: &mut Cost) -> Result<(Stationary, bool), NotPositiveDefinite> {
    let n = free.dimension();
    let (mut solves, mut idle) = (0, 0);
    let end = optimum(&mut all_of(beam, n, cost), free, &mut solves, |_, _| {
        idle += 1;
        Ok(idle <= PATIENCE)
    });
    cost.whole += solves;
    cost.work += solves * n;
    end
}

/// The reduced program of all variables of a beam.
fn all_of<'a>(beam: &'a LocalBeam<'_>, n: usize, cost: &Cost) -> Reduced<'a> {
    Reduced {
        point: Box::new(move |free| beam.point(free, 0..n)),
        make_definite: Box::new(|free| beam.hold(free)),
        most_solves: solves_within(MOST_WORK.saturating_sub(cost.work), n),
    }
}

#[cfg(test)]
pub(super) mod tests {
    use super::*;
    use crate::scene::{Beam, Foundation, Load};

    /// Multiples of the golden section are spread evenly between 0 and 1.
    pub(in crate::grid::multigrid) fn spread(k: u32) -> f64 {
        (0.618_034 * f64::from(k)).fract()
    }

    /// A beam above waves of many lengths and amplitudes, and above polylines through twelve uneven depths.
    pub(in crate::grid::multigrid) fn scenes() -> impl Iterator<Item = Scene> {
        let beam = Beam::new(10.0, 500.0 / 384.0).expect("a beam");
        let load = Load::uniform_on(&beam, 1.0).expect("a load");
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
        foundations.map(move |foundation| Scene::new(beam.clone(), load.clone(), Some(foundation)).expect("well posed"))
    }

    /// The start affects the work but not the result: near the optimum, far from it, everywhere, nowhere.
    #[test]
    fn every_start_leads_to_the_optimum() {
        /// Relative to the sizes: one optimum, with the rounding of systems of condition number 3, and forces of rounding size at ties.
        const ROUNDED: f64 = 1e-10;
        for scene in scenes().step_by(3) {
            let scaled = scene.scaled().expect("in range");
            let discrete = Discrete::new(&scaled.scene, 2000).expect("a grid");
            let sizes = discrete.sizes();
            for method in [Method::Complementarity, Method::Force] {
                let run = |near| solve(&scaled.scene, method, &discrete, near).expect("in range");
                let expected = run(None);
                let middle = [Contact { to: 6.0, ..Contact::at(4.0, 1.0) }, Contact::at(9.0, 1.0)];
                for near in [
                    nearest(&discrete, &[], 10.0),
                    nearest(&discrete, &middle, 10.0),
                    FreeSet::all(discrete.nodes().len()),
                    (0..discrete.nodes().len()).map(|i| spread(u32::try_from(i).expect("small")) < 0.1).collect(),
                ] {
                    let found = run(Some(near));
                    assert!(
                        expected.run.reports_success && found.run.reports_success,
                        "{method}: {}",
                        found.run.message
                    );
                    let pairs = found.x.iter().zip(&expected.x).map(|(p, other)| (p - other) / sizes.gradient);
                    let open = found.gradient.iter().zip(&expected.gradient).map(|(h, other)| (h - other) / sizes.x);
                    let apart = pairs.chain(open).fold(0.0_f64, |most, apart| most.max(apart.abs()));
                    assert!(apart <= ROUNDED, "{method}: {apart:.1e}, {:?}", scene.foundation());
                }
            }
        }
    }

    /// Behind a kink between the nodes of a grid is a hole. Without windows exchanges change its nodes one after the other, with
    /// thousands of solves of the whole beam.
    #[test]
    fn the_whole_beam_is_solved_a_few_times_only() {
        /// Usually one solve, which confirms the result of the windows. The maximum of two thousand scenes is fifty.
        const FEW: usize = 10;
        for scene in scenes() {
            let scaled = scene.scaled().expect("in range");
            let discrete = Discrete::new(&scaled.scene, 16_000).expect("a grid");
            let answer = solve(&scaled.scene, Method::Force, &discrete, None).expect("in range");
            assert!(answer.run.reports_success, "{:?}", scene.foundation());
            assert!(answer.run.work <= FEW * answer.x.len(), "{} unknowns: {:?}", answer.run.work, scene.foundation());
        }
    }
}
