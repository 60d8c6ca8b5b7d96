//! What the scene required: unknowns of the exact solution beside those of a grid that comes close to it.

use palkki::theory::Exact;

use crate::report::evidence::prelude::*;

/// Relative errors that are asked for: what an engineer needs, and what a reference needs.
pub(super) const TARGETS: [f64; 2] = [1e-4, 1e-6];
/// The first grid, of the paper; each further one has twice as many intervals.
pub(super) const COARSEST: usize = palkki_evidence::paper::INTERVALS;
/// No grid has more unknowns.
pub(super) const MOST: usize = 1_000_000;
/// The methods: displacement and force method have the same answers.
const METHODS: [Method; 2] = [Method::Complementarity, Method::Force];

/// What the search found for one scene.
pub(super) struct Required {
    /// Unknowns of the exact solution, then those of the grids, for each method and each target.
    pub(super) cells: Vec<String>,
    /// True if the search ended at the finest grid.
    pub(super) capped: bool,
    /// True if it ended at an answer that is not certified.
    pub(super) refused: bool,
}

/// Looks for the grids.
pub(super) fn required(scene: &Scene, exact: &Exact) -> Result<Required, Cause> {
    let met = met_supports(scene);
    let mark = if met.contains(&true) { " ¹" } else { "" };
    let mut found = Required { cells: vec![format!("{}{mark}", exact.unknowns)], capped: false, refused: false };
    if met == [true; 2] {
        found.cells.extend(["none ¹"; METHODS.len() * TARGETS.len()].map(str::to_owned));
        return Ok(found);
    }
    for method in METHODS {
        let mut first: [Option<usize>; TARGETS.len()] = [None; TARGETS.len()];
        let (mut last, mut refused) = (0, false);
        // One grid may be lucky: the next one has to be good enough as well.
        let mut before = f64::INFINITY;
        let mut intervals = COARSEST;
        while intervals - 1 <= MOST && first.contains(&None) {
            let outcome = on_grid(scene, method, Solver::ActiveSet, intervals)?;
            if !outcome.solved {
                refused = true;
                break;
            }
            let error = error(scene, exact, &outcome.state, met);
            for (first, target) in first.iter_mut().zip(TARGETS) {
                if first.is_none() && before.max(error) <= target {
                    *first = Some(last);
                }
            }
            (before, last) = (error, intervals - 1);
            intervals *= 2;
        }
        let missing = first.contains(&None);
        (found.refused, found.capped) = (found.refused | (missing && refused), found.capped | (missing && !refused));
        found.cells.extend(first.map(|n| match n {
            Some(n) => count(n),
            None if refused => "none ²".to_owned(),
            None => format!("more than {}", count(last)),
        }));
    }
    Ok(found)
}

/// Supports at which the foundation starts at their own level. They share their force with the ground beside them, in a
/// way that depends on the grid.
fn met_supports(scene: &Scene) -> [bool; 2] {
    [0.0, scene.beam().length()].map(|x| scene.depth(x) == 0.0)
}

/// The worst of the reactions, relative to the load, and the energy.
fn error(scene: &Scene, exact: &Exact, state: &palkki::state::ContactState, met: [bool; 2]) -> f64 {
    let (found, right) = (&state.reactions, &exact.state.reactions);
    let reactions = [found.left - right.left, found.right - right.right];
    let worst = reactions.iter().zip(met).filter(|(_, met)| !met).fold(0.0_f64, |most, (r, _)| most.max(r.abs()));
    let energy = (state.energy - exact.state.energy) / exact.state.energy;
    (worst / load(scene)).max(energy.abs())
}
