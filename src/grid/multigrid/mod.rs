//! The active set for grids of up to millions of nodes: nested grids, windows, and spans of any length at the price of a short
//! one. Nothing else needs this room: [`Solver::ActiveSet`](crate::solvers::Solver::ActiveSet) solves every quadratic program
//! without it, to the same answer, but in a time that grows faster than the number of nodes.
//!
//! *Nested grids.* The active set starts from the contact of a coarser grid, so that only the neighbourhood of lift-off points
//! has to change. Coarser grids only have to give a good guess. All methods are one beam on a set of contacts, or one chain
//! of links, and what is exchanged here are its contact forces, as in the force method: they are free where there is contact.
//! Where the ground is rough between the nodes of a coarser grid, its contact is a bad guess; a better one may be given.
//!
//! *Windows* (`windows.rs`) around the borders of contact, where a guess from a coarser grid is wrong as a rule, are solved for
//! themselves before the whole. An optimum is only returned after a solve of the whole with all signs right.

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

/// A coarser grid has so many intervals at least: on fewer, contact is a bad guess. *Tuned* on waves and rough polylines of 20 to 3000
/// intervals: of 10, 15 and 30 it takes the least work on all of these grids, a third less than 30 on a hundred intervals.
const COARSEST: usize = 10;

/// From here on the next grid may be finer by more: contact is wrong near lift-off points only.
const FINE: usize = 1000;

/// Refinement up to such grids, and of them.
const REFINEMENT: [usize; 2] = [2, 8];

/// What solves cost.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
struct Cost {
    /// Solves of a whole beam.
    whole: usize,
    /// Solves of windows.
    windows: usize,
    /// Variables in all of them.
    work: usize,
}

/// The optimum of a scene on a grid in contact forces: `x = p`, `g = h`, whatever the unknowns of the method are. Solves on all
/// grids count. Contact to start from is that of coarser grids, unless it is known that contact is `near` another one.
///
/// # Errors
///
/// None for a grid that exists; the type is that of [`Discrete::new`].
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

/// Intervals of the next coarser grid, if there is one; fewer where its nodes would miss a support.
pub(crate) fn coarser(intervals: usize) -> Option<usize> {
    let coarse = intervals / REFINEMENT[usize::from(FINE <= intervals)];
    (COARSEST <= coarse).then_some(coarse)
}

/// Contact at the nodes nearest to some contacts of a beam of this length.
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

/// Contact to start from on a grid: by a coarser one with a node at each support as well, everywhere if there is none.
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
        // A solve that fails here fails again on the finest grid, where the error is returned.
        let _ = by_newton(&beam, &mut free, cost);
    } else if discrete.tension != 0.0 {
        let _ = whole(&beam, &mut free, cost);
    } else {
        Windows { beam: &beam, cost }.guess(&mut free);
    }
    Ok(refined(&free, intervals, discrete.held_ends()))
}

/// The optimum on ground that gives, where a change at a contact changes the forces at all others, so that there are no windows: all
/// variables on the wrong side change together, Newton's method for springs that cannot pull, and if that does not end, as elsewhere.
fn by_newton(
    beam: &LocalBeam<'_>,
    free: &mut FreeSet,
    cost: &mut Cost,
) -> Result<(Stationary, bool), NotPositiveDefinite> {
    /// A handful are the rule.
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

/// The optimum under an axial force. Compression carries a change at one contact over many others: there are no windows.
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

/// All variables of a beam.
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

    /// The start changes the work and not the result: near the optimum, far from it, everywhere, nowhere.
    #[test]
    fn every_start_leads_to_the_optimum() {
        /// Of the sizes: one optimum, with the rounding of systems of condition number 3, and forces of rounding size at ties.
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

    /// Behind a kink between the nodes of a grid is a hole, whose nodes exchanges change one after the other: thousands of solves of
    /// the whole beam, without windows.
    #[test]
    fn the_whole_beam_is_solved_a_few_times_only() {
        /// One that confirms what windows have found, as a rule; the worst of two thousand scenes needs fifty.
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
