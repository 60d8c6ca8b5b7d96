//! Solvers: where contact is hard to find, what they cost, what libraries do at the edge, which grid an accuracy asked for takes.

mod adaptive;
mod costs;
mod exchanges;
mod libraries;
mod windows;

use palkki::route::{Method, Solution, Solver};
use palkki::scene::Scene;

use crate::scenes::run;

/// The active set ends at the optimum, certified, with at most so many solves, those of windows and of coarser grids counted.
#[track_caller]
fn ends(scene: &Scene, method: Method, intervals: usize, solves: usize) -> Solution<()> {
    let raw = run(scene, method, Solver::ActiveSet, intervals);
    let (name, taken, residual) = (scene.title(), raw.run.iterations, raw.residual);
    let told = format!("{name}, {method}, {intervals}: {taken} solves, residual {residual:.1e}");
    assert!(raw.solved, "{told}");
    assert!(raw.run.reports_success && taken <= solves, "{told}");
    raw
}
