//! All routes on two scenes and three grids: what a solver says of itself, and what the judge says.

use std::path::Path;

use palkki::certificate::CERTIFIED_RESIDUAL;
use palkki::route::{Method, Outcome, Solver};
use palkki::scene::Scene;
use palkki::{Settings, solve};
use serde::Serialize;

use crate::report::csv::csv;
use crate::report::error::Cause;
use crate::report::scenes;

/// The example, and a truly uneven foundation.
const SCENES: [&str; 2] = ["heinisuo-1984", "wave"];
const GRIDS: [usize; 3] = [30, 100, 300];

/// A residual above the threshold by this factor is no matter of rounding, on any machine.
const CLEARLY: f64 = 10.0;

#[derive(Debug, Serialize)]
pub(super) struct Values {
    scenes: Vec<String>,
    grids: [usize; 3],
    clearly: u32,
    rows: Vec<Row>,
    /// Runs, and those among them in which success was claimed and is clearly none.
    runs: usize,
    wrong: usize,
    wrong_libraries: usize,
    gave_up: usize,
    active_set_wrong: usize,
}

#[derive(Debug, Serialize)]
struct Row {
    method: &'static str,
    solver: &'static str,
    /// Scene by scene, grid by grid.
    cells: Vec<String>,
}

/// What one run came to.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum End {
    Agreed,
    GaveUp,
    Wrong,
    NotRun,
}

impl End {
    fn of(outcome: &Outcome) -> Self {
        // The judge makes NaN infinite.
        let clear = CLEARLY * CERTIFIED_RESIDUAL < outcome.residual;
        match (outcome.solver_claims_success, clear) {
            (true, true) => Self::Wrong,
            (false, true) => Self::GaveUp,
            (_, false) => Self::Agreed,
        }
    }

    fn word(self) -> &'static str {
        match self {
            Self::Agreed => "solved",
            Self::GaveUp => "gave up",
            Self::Wrong => "wrong",
            Self::NotRun => "not run",
        }
    }
}

/// NSOR runs out of its budget on the finest grid; it takes many seconds to.
fn too_long(solver: Solver, intervals: usize) -> bool {
    200 < intervals && solver == Solver::Nsor
}

/// Runs everything.
pub(super) fn against_the_judge(root: &Path) -> Result<(Values, String), Cause> {
    let scenes: Vec<Scene> = SCENES.iter().map(|name| scenes::read(root, name)).collect::<Result<_, _>>()?;
    let mut rows = Vec::new();
    let mut table = Vec::new();
    let mut ends = Vec::new();
    for method in Method::ALL {
        for solver in Solver::ALL {
            let mut cells = Vec::new();
            for (name, scene) in SCENES.iter().zip(&scenes) {
                for intervals in GRIDS {
                    let (end, words) = if too_long(solver, intervals) {
                        (End::NotRun, "")
                    } else {
                        let outcome = solve(scene, &Settings::new(method, solver, intervals))?;
                        let end = End::of(&outcome);
                        (end, if outcome.solver_claims_success { "success" } else { "failure" })
                    };
                    ends.push((solver, end));
                    cells.push(if end == End::Wrong { format!("**{}**", end.word()) } else { end.word().to_owned() });
                    let row = [name, method.word(), solver.word(), &intervals.to_string(), words, end.word()];
                    table.push(row.map(str::to_owned).to_vec());
                }
            }
            rows.push(Row { method: method.word(), solver: solver.word(), cells });
        }
    }
    let count = |of: &dyn Fn(Solver, End) -> bool| ends.iter().filter(|&&(solver, end)| of(solver, end)).count();
    let values = Values {
        scenes: scenes.iter().map(|scene| scene.title().to_owned()).collect(),
        grids: GRIDS,
        clearly: 10,
        rows,
        runs: count(&|_, end| end != End::NotRun),
        wrong: count(&|_, end| end == End::Wrong),
        wrong_libraries: count(&|solver, end| end == End::Wrong && matches!(solver, Solver::Clarabel | Solver::Osqp)),
        gave_up: count(&|_, end| end == End::GaveUp),
        active_set_wrong: count(&|solver, end| end != End::Agreed && solver == Solver::ActiveSet),
    };
    Ok((values, csv(&["scene", "method", "solver", "intervals", "claims", "judged"], table)))
}
