//! The adaptive grid on the example: an error that is demanded, the grids that it takes, and the error that is true.

use palkki::adaptive::{Request, adapt};
use palkki_evidence::observables::errors;
use palkki_evidence::paper::example;

use super::prelude::*;

/// Powers of ten that are demanded.
const DEMANDED: [i32; 4] = [-2, -4, -6, -8];

/// Which of the observables are guaranteed: all but the moment.
const GUARANTEED: [usize; 4] = [0, 1, 2, 4];

pub(super) fn evidence(_: &Study<'_>) -> Result<Evidence, Cause> {
    let scene = example()?;
    let exact = theory::solve(&scene)?;
    let header = ["EPS", "grids tried, intervals", "certified error of the deflection", "worst true error"];
    let mut steps = Table::new(header.into_iter().chain(["unknowns gone through"]));
    for exponent in DEMANDED {
        let found = adapt(&scene, &Request::new(Method::Force, Solver::ActiveSet, ten_to(exponent)))?;
        let grids: Vec<String> = found.trials.iter().map(|tried| tried.intervals.to_string()).collect();
        let errors = errors(&exact, &found.solution.state);
        let truth = GUARANTEED.into_iter().map(|of| errors[of]).fold(0.0, f64::max);
        let [certified, truth] = [found.solution.verdict.error, truth].map(|error| cell(Some(error), 2));
        let work: usize = found.trials.iter().map(|tried| tried.work).sum();
        steps.push(row![power_of_ten(exponent), grids.join(", "), certified, truth, count(work)]);
    }
    Ok(Evidence::new(context! { steps }))
}
