//! What the scene required: unknowns of the exact solution beside those of a grid that comes close to it.

use palkki::route::{Method, Solver, Status};
use palkki::scene::Scene;
use palkki::theory::Exact;
use palkki::{Settings, solve};
use serde::Serialize;

use crate::report::error::Cause;

/// Relative errors that are asked for: what an engineer needs, and what a reference needs.
pub(super) const TARGETS: [f64; 2] = [1e-4, 1e-6];
/// The first grid, of the paper; each further one has twice as many intervals.
pub(super) const COARSEST: usize = palkki::paper::INTERVALS;
/// No grid has more unknowns.
pub(super) const MOST: usize = 1_000_000;
/// The methods: displacement and force method have the same answers.
const METHODS: [Method; 2] = [Method::Complementarity, Method::Force];

/// One scene.
#[derive(Debug, Serialize)]
pub(super) struct Required {
    /// Unknowns of the exact solution.
    exact: usize,
    /// True if the foundation meets a support, whose reaction is then not compared.
    meets_support: bool,
    /// For each method and each target; none if no reaction is left to compare.
    grids: Vec<Grid>,
}

impl Required {
    /// True if the search for a grid ended at the finest one.
    pub(super) fn is_capped(&self) -> bool {
        self.grids.iter().any(|grid| !grid.found && !grid.refused)
    }

    /// True if an answer that the judge does not certify ended it.
    pub(super) fn is_refused(&self) -> bool {
        self.grids.iter().any(|grid| !grid.found && grid.refused)
    }
}

/// The first grid that is good enough.
#[derive(Debug, Serialize)]
struct Grid {
    /// Its unknowns, or the most that were tried.
    unknowns: usize,
    /// True if it is good enough.
    found: bool,
    /// True if the judge stopped certifying before that.
    refused: bool,
}

/// Looks for the grids.
pub(super) fn required(scene: &Scene, exact: &Exact) -> Result<Required, Cause> {
    let met = met_supports(scene);
    let mut grids = Vec::new();
    let methods: &[Method] = if met == [true; 2] { &[] } else { &METHODS };
    for &method in methods {
        let mut found: [Option<usize>; TARGETS.len()] = [None; TARGETS.len()];
        let (mut last, mut refused) = (0, false);
        // One grid may be lucky: the next one has to be good enough as well.
        let mut before = f64::INFINITY;
        let mut intervals = COARSEST;
        while intervals - 1 <= MOST && found.contains(&None) {
            let outcome = solve(scene, &Settings::new(method, Solver::ActiveSet, intervals))?;
            if outcome.status != Status::Certified {
                refused = true;
                break;
            }
            let error = error(scene, exact, &outcome.state, met);
            for (found, target) in found.iter_mut().zip(TARGETS) {
                if found.is_none() && before.max(error) <= target {
                    *found = Some(last);
                }
            }
            (before, last) = (error, intervals - 1);
            intervals *= 2;
        }
        grids.extend(found.map(|n| Grid { unknowns: n.unwrap_or(last), found: n.is_some(), refused }));
    }
    Ok(Required { exact: exact.unknowns, meets_support: met.contains(&true), grids })
}

/// Supports at which the foundation starts at their own level. They share their force with the ground beside them, in a
/// way that depends on the grid.
fn met_supports(scene: &Scene) -> [bool; 2] {
    [0.0, scene.beam().length()].map(|x| scene.depth(x) == 0.0)
}

/// The worst of the reactions, relative to the load, and the energy.
fn error(scene: &Scene, exact: &Exact, state: &palkki::state::ContactState, met: [bool; 2]) -> f64 {
    let load = scene.load().magnitude(scene.beam().length());
    let (found, right) = (&state.reactions, &exact.state.reactions);
    let reactions = [found.left - right.left, found.right - right.right];
    let worst = reactions.iter().zip(met).filter(|(_, met)| !met).fold(0.0_f64, |most, (r, _)| most.max(r.abs()));
    let energy = (state.energy - exact.state.energy) / exact.state.energy;
    (worst / load).max(energy.abs())
}
