//! An answer with its verdict and its time, whichever way it was found.

use std::time::Instant;

use palkki::certificate::Certificate;
use palkki::dial::{Dial, End, Request, Try};
use palkki::route::{Outcome, Status};
use palkki::state::{ContactState, Nodes};
use palkki::theory::{Exact, TheoryError};
use palkki::verdict::{Demand, Refusal, Verdict};
use palkki::{Settings, Witness, solve};

use super::exact::exact;
use super::failure::Failure;
use super::input::Input;

/// A way to an answer.
#[derive(Debug, Clone, Copy)]
pub(super) enum Route {
    /// Beam theory, with an error that may be demanded.
    Exact(Demand),
    /// A method of the paper with a solver on a grid.
    Discretised(Settings),
    /// A method of the paper with a solver, on the grid that an error demands.
    Dialled(Request),
}

/// What is printed.
#[derive(Debug)]
pub(super) struct Answer {
    pub(super) method: &'static str,
    pub(super) solver: &'static str,
    /// Intervals of the grid, if there is one.
    pub(super) intervals: Option<usize>,
    pub(super) status: Status,
    /// Why it is not certified.
    pub(super) refusal: Option<Refusal>,
    /// The solver's own word.
    pub(super) solver_status: String,
    /// Scaled residual of our own check.
    pub(super) residual: Option<f64>,
    pub(super) unknowns: usize,
    pub(super) iterations: usize,
    /// Time of the solve alone.
    pub(super) seconds: f64,
    pub(super) state: ContactState,
    /// The solution of beam theory as functions of `x`, if that is where the answer comes from.
    pub(super) exact: Option<Box<Exact>>,
    /// Two-sided bounds; there are none for an answer that is no numbers.
    pub(super) certificate: Option<Certificate>,
    /// Guaranteed error of the deflection over the largest deflection.
    pub(super) error: f64,
    /// What it took to find the grid, if that was asked for.
    pub(super) search: Option<Search>,
}

/// What it took to find a grid.
#[derive(Debug)]
pub(super) struct Search {
    /// The error that was demanded, over the largest deflection.
    pub(super) demanded: f64,
    /// How it ended.
    pub(super) end: End,
    /// The grids and the time that each took to solve.
    pub(super) tries: Vec<(Try, f64)>,
    /// Time of the whole search, certificates included.
    pub(super) seconds: f64,
}

impl Answer {
    /// Solves the scene.
    pub(super) fn of(input: &Input, route: Route) -> Result<Self, Failure> {
        match route {
            Route::Exact(demand) => exact(input, &demand).map_err(|error| match error {
                TheoryError::Scene(error) => input.error(error),
                error => Failure::NoTheory(error),
            }),
            Route::Discretised(settings) => Self::discretised(input, &settings, &Witness::of(&input.scene)),
            Route::Dialled(request) => Self::dialled(input, &request),
        }
    }

    /// The answer of a method on a grid, certified from a witness.
    pub(super) fn discretised(input: &Input, settings: &Settings, witness: &Witness<'_>) -> Result<Self, Failure> {
        let start = Instant::now();
        let outcome = solve(&input.scene, settings).map_err(|error| input.error(error))?;
        let seconds = start.elapsed().as_secs_f64();
        let verdict = Verdict::of_outcome(&outcome, witness, &Demand::default());
        Ok(Self::new(settings, outcome, verdict, seconds))
    }

    fn dialled(input: &Input, request: &Request) -> Result<Self, Failure> {
        let begin = Instant::now();
        let mut dial = Dial::new(&input.scene, request);
        let mut times = Vec::new();
        let dialled = loop {
            let settings = dial.settings();
            let start = Instant::now();
            let outcome = solve(&input.scene, &settings).map_err(|error| input.error(error))?;
            times.push(start.elapsed().as_secs_f64());
            if let Some(dialled) = dial.learn(settings, outcome) {
                break dialled;
            }
        };
        let seconds = begin.elapsed().as_secs_f64();
        let tries: Vec<(Try, f64)> = dialled.tries.into_iter().zip(times).collect();
        let of_answer = |t: &&(Try, f64)| {
            t.0.intervals == dialled.settings.intervals && t.0.tolerance.total_cmp(&dialled.settings.tolerance).is_eq()
        };
        let alone = tries.iter().find(of_answer).map_or(seconds, |t| t.1);
        let search = Search { demanded: request.error, end: dialled.end, tries, seconds };
        let answer = Self::new(&dialled.settings, dialled.outcome, dialled.verdict, alone);
        Ok(Self { search: Some(search), ..answer })
    }

    fn new(settings: &Settings, outcome: Outcome, verdict: Verdict, seconds: f64) -> Self {
        Self {
            method: settings.method.word(),
            solver: settings.solver.word(),
            intervals: Some(settings.intervals),
            status: verdict.status,
            refusal: verdict.refusal,
            solver_status: outcome.solver_status,
            residual: Some(outcome.residual),
            unknowns: outcome.unknowns,
            iterations: outcome.iterations,
            seconds,
            certificate: verdict.certificate,
            error: verdict.error,
            search: None,
            state: outcome.state,
            exact: None,
        }
    }

    /// The values at the nodes of a grid.
    pub(super) fn nodes(&self) -> Option<&Nodes> {
        self.state.nodes.as_ref()
    }
}
