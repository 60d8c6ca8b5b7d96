//! `--method exact`: beam theory with free lift-off points.

use std::time::Instant;

use palkki::route::Status;
use palkki::theory::{self, Exact, TheoryError};
use palkki::verdict::{Demand, Verdict};

use super::answer::Answer;
use super::input::Input;

/// What solves the equations of theory: Newton's method for the free boundaries, under a search for the list of contacts.
const SOLVER: &str = "free-boundary";

/// The answer of beam theory.
pub(super) fn exact(input: &Input, demand: &Demand) -> Result<Answer, TheoryError> {
    let start = Instant::now();
    let exact = theory::solve(&input.scene)?;
    let seconds = start.elapsed().as_secs_f64();
    let verdict = Verdict::of_exact(&input.scene, &exact, demand);
    Ok(Answer {
        method: "exact",
        solver: SOLVER,
        intervals: None,
        status: verdict.status,
        refusal: verdict.refusal,
        solver_status: words(&exact),
        residual: Some(exact.residual),
        unknowns: exact.unknowns,
        iterations: exact.iterations,
        seconds,
        certificate: verdict.certificate,
        error: verdict.error,
        search: None,
        state: exact.state.clone(),
        exact: Some(Box::new(exact)),
    })
}

fn words(exact: &Exact) -> String {
    let lists = match exact.lists {
        1 => "1 list of contacts tried".to_owned(),
        lists => format!("{lists} lists of contacts tried"),
    };
    if exact.status == Status::Certified {
        return format!("all conditions hold everywhere, {lists}");
    }
    let violations: Vec<String> = exact.violations.iter().map(ToString::to_string).collect();
    if violations.is_empty() { lists } else { format!("{}; {lists}", violations.join("; ")) }
}
