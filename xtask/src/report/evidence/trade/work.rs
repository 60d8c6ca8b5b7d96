//! What the active set costs without a clock: unknowns that its solves go through, for each unknown of the problem.

use palkki::paper::example;
use palkki::route::{Method, Solver};
use palkki::scene::SceneError;
use palkki::{Settings, solve};
use serde::Serialize;

/// Grids of the table.
pub(super) const GRIDS: [usize; 5] = [30, 300, 3000, 30_000, 300_000];

/// One method.
#[derive(Debug, Clone, Serialize)]
pub(super) struct Row {
    method: &'static str,
    /// Work over unknowns, grid by grid: of how many solves of the whole it is worth.
    shares: Vec<f64>,
}

/// Of all methods, on the paper's example.
pub(super) fn rows() -> Result<Vec<Row>, SceneError> {
    let scene = example()?;
    let row = |method: Method| {
        let share = |intervals| {
            let outcome = solve(&scene, &Settings::new(method, Solver::ActiveSet, intervals))?;
            #[expect(clippy::cast_precision_loss, reason = "counts stay far below 2⁵³")]
            Ok(outcome.work as f64 / outcome.unknowns as f64)
        };
        let shares = GRIDS.into_iter().map(share).collect::<Result<_, SceneError>>()?;
        Ok(Row { method: method.word(), shares })
    };
    Method::ALL.into_iter().map(row).collect()
}
