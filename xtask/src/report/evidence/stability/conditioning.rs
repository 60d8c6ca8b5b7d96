//! Errors of the solvers beside what the condition number of the matrix lets one expect: rendered from the file of
//! `cargo xtask measure`, whose errors are against the optimum proven in integers of 256 binary places.

use palkki::plot::{Axis, Layer, Panel, Place, Style};

use crate::measure::line::{Line, Store};
use crate::measure::plan::EXAMPLE;
use crate::report::evidence::cost::{SOLVERS, ended, shown};
use crate::report::evidence::prelude::*;

/// The method whose matrix is `A = T²`.
const METHOD: Method = Method::Complementarity;

/// What a solver that factorises the matrix has to expect: its condition number times the rounding of a number.
fn expected(intervals: usize) -> f64 {
    METHOD.condition(intervals) * f64::EPSILON
}

pub(crate) fn evidence(study: &Study<'_>) -> Result<Evidence, Cause> {
    let (_, store) = Store::read(study.root)?;
    let lines: Vec<&Line> = ended(&store, EXAMPLE);
    // Of each solver that is solved on a grid the intervals, and the worst error in four observables.
    let mut errors: Vec<(&str, usize, f64)> = Vec::new();
    for solver in SOLVERS {
        let solved = lines.iter().filter(|line| line.is(METHOD.name(), solver) && line.succeeded() && shown(line));
        errors.extend(
            solved.filter_map(|line| Some((solver, line.intervals, line.of_solver()?.into_iter().fold(0.0, f64::max)))),
        );
    }
    let mut grids: Vec<usize> = errors.iter().map(|error| error.1).collect();
    grids.sort_unstable();
    grids.dedup();
    let of = |solver: &str| errors.iter().filter(move |error| error.0 == solver).collect::<Vec<_>>();

    let y = Axis::new("relative solver error").log();
    let mut panel = Panel::new(Axis::new("intervals N").log(), y).tall(760.0);
    for (k, solver) in SOLVERS.into_iter().enumerate() {
        let points: Vec<Place> = of(solver).iter().map(|error| [as_number(error.1), error.2]).collect();
        panel = panel.with(Layer::named(points, Style::of_series(k), solver));
    }
    let dashed: Vec<Place> = grids.iter().map(|&grid| [as_number(grid), expected(grid).min(1.0)]).collect();
    panel = panel.with(Layer::named(dashed, Style::theory(), "cond(A) · 2⁻⁵²"));
    let row = |&(solver, grid, worst): &(&str, usize, f64)| {
        row![solver, grid, scientific(worst, 2), scientific(expected(grid), 1)]
    };
    let data = Table::new(["solver", "intervals", "worst_error", "cond_times_rounding"]).rows(errors.iter().map(row));
    let active_set = of(SOLVERS[0]);
    let values = context! {
        finest => grids.last(),
        active_set => bound(active_set.iter().map(|error| error.2).fold(0.0, f64::max)),
    };
    Evidence::new(values).figures([study.drawn("conditioning", context! {}, 1, vec![panel], data)?])
}
