//! Errors of the solvers beside what the condition number of the matrix lets one expect: rendered from the file of
//! `cargo xtask measure`, whose errors are against the optimum proven in integers of 256 binary places.

use palkki::plot::{Axis, Layer, Panel, Place, Style};

use crate::measure::line::{Line, Store};
use crate::measure::plan::EXAMPLE;
use crate::report::evidence::cost::{SOLVERS, ended, shown};
use crate::report::evidence::prelude::*;

/// The method whose matrix is `A = T²`.
const METHOD: Method = Method::Complementarity;

/// The worst error of a solver in four observables on a grid, if it is solved.
struct Error {
    solver: &'static str,
    intervals: usize,
    worst: f64,
}

/// What a solver that factorises the matrix has to expect: its condition number times the rounding of a number.
fn expected(intervals: usize) -> f64 {
    METHOD.condition(intervals) * f64::EPSILON
}

pub(crate) fn evidence(study: &Study<'_>) -> Result<Evidence, Cause> {
    let (_, store) = Store::read(study.root)?;
    let lines: Vec<&Line> = ended(&store, EXAMPLE);
    let mut errors: Vec<Error> = Vec::new();
    for solver in SOLVERS {
        let solved = lines.iter().filter(|line| line.is(METHOD.name(), solver) && line.succeeded() && shown(line));
        errors.extend(solved.filter_map(|line| {
            let worst = line.of_solver()?.into_iter().fold(0.0, f64::max);
            Some(Error { solver, intervals: line.intervals, worst })
        }));
    }
    let mut grids: Vec<usize> = errors.iter().map(|error| error.intervals).collect();
    grids.sort_unstable();
    grids.dedup();
    let of = |solver: &str| errors.iter().filter(move |error| error.solver == solver).collect::<Vec<_>>();

    let header = ["intervals", "cond(A)", "cond(A) · 2⁻⁵²"].into_iter().chain(SOLVERS);
    let table = Table::new(header).rows(grids.iter().map(|&grid| {
        let of_solvers = SOLVERS.map(|solver| {
            let found = of(solver).into_iter().find(|error| error.intervals == grid);
            error_cell(found.map(|error| error.worst))
        });
        let condition = [METHOD.condition(grid), expected(grid)].map(|number| times_ten(number, 0));
        [count(grid)].into_iter().chain(condition).chain(of_solvers)
    }));

    let y = Axis::new("error of the solver").log();
    let mut panel = Panel::new(Axis::new("intervals N").log(), y).tall(760.0);
    for (k, solver) in SOLVERS.into_iter().enumerate() {
        let points: Vec<Place> = of(solver).iter().map(|error| [as_number(error.intervals), error.worst]).collect();
        panel = panel.with(Layer::named(points, Style::of_series(k), solver));
    }
    let dashed: Vec<Place> = grids.iter().map(|&grid| [as_number(grid), expected(grid).min(1.0)]).collect();
    panel = panel.with(Layer::named(dashed, Style::theory(), "cond(A) · 2⁻⁵²"));
    let data = Table::new(["solver", "intervals", "worst_error", "cond_times_rounding"]).rows(
        errors
            .iter()
            .map(|e| row![e.solver, e.intervals, scientific(e.worst, 2), scientific(expected(e.intervals), 1)]),
    );
    let active_set = of(SOLVERS[0]);
    let values = context! {
        table,
        finest => grids.last(),
        active_set => bound(active_set.iter().map(|error| error.worst).fold(0.0, f64::max)),
    };
    Evidence::new(values).figures([study.drawn("conditioning", context! {}, 1, vec![panel], data)?])
}
