//! An answer with its verdict and its time: by beam theory, by a method on a given grid, or on a grid refined to a demanded error.

use std::time::Instant;

use palkki::adaptive::{End, Request, Search, Trial, most_intervals};
use palkki::proof;
use palkki::route::Status;
use palkki::state::Nodes;
use palkki::theory::{self, TheoryError};
use palkki::verdict::{Demand, Refusal};
use palkki::{Settings, Solution, Witness, left_out, solve_raw, solve_raw_near};

use super::input::Input;
use super::output::Failure;

/// The name that is printed for the solver of theory: Newton's method for the free boundaries, and a search for the contact list.
const FREE_BOUNDARY: &str = "free-boundary";

/// The end of the warning about a large deflection.
const LARGE: &str = "more than a tenth of its length, and linear theory assumes small slopes";

/// The requested computation, from the arguments.
#[derive(Debug, Clone, Copy)]
pub(super) enum Route {
    /// Beam theory, with the demanded accuracy.
    Exact(Demand),
    /// A method of the paper with a solver on a given grid.
    Discretised(Settings),
    /// A method of the paper with a solver, on a grid refined to a demanded error.
    Adaptive(Request),
}

/// An answer with the data that are printed with it.
#[derive(Debug)]
pub(super) struct Answer {
    /// Length of the beam.
    pub(super) length: f64,
    pub(super) method: &'static str,
    pub(super) solver: &'static str,
    /// Number of intervals of the grid, if there is one.
    pub(super) intervals: Option<usize>,
    /// Time of the solve alone.
    pub(super) seconds: f64,
    /// The answer with its verdict.
    pub(super) solution: Solution,
    /// The grids that were tried, if an error was demanded.
    pub(super) grids: Option<Grids>,
}

/// The grids that were tried.
#[derive(Debug)]
pub(super) struct Grids {
    /// The demanded error, over the largest deflection.
    pub(super) demanded: f64,
    /// The end of the search.
    pub(super) end: End,
    /// The grids, each with the time of its solve.
    pub(super) trials: Vec<(Trial, f64)>,
    /// Time of the whole search, including certificates.
    pub(super) seconds: f64,
}

impl Answer {
    /// Solves the scene by a route.
    pub(super) fn of(input: &Input, route: Route) -> Result<Self, Failure> {
        match route {
            Route::Exact(demand) => Self::exact(input, &demand),
            Route::Discretised(settings) => Self::discretised(input, &settings, &Witness::of(&input.scene)),
            Route::Adaptive(request) => Self::adaptive(input, &request),
        }
    }

    /// The answer of beam theory.
    fn exact(input: &Input, demand: &Demand) -> Result<Self, Failure> {
        let start = Instant::now();
        let exact = theory::solve(&input.scene).map_err(|error| match error {
            TheoryError::Scene(error) => input.error(error),
            error => Failure::NoTheory(error),
        })?;
        let seconds = start.elapsed().as_secs_f64();
        let length = input.scene.beam().length();
        Ok(Self::without_grid(length, exact.judged(&input.scene, demand), seconds))
    }

    /// An answer of beam theory for a beam of this length.
    pub(super) fn without_grid(length: f64, solution: Solution, seconds: f64) -> Self {
        Self { length, method: "exact", solver: FREE_BOUNDARY, intervals: None, seconds, solution, grids: None }
    }

    /// The answer of a method on a grid, certified from a candidate contact list.
    pub(super) fn discretised(input: &Input, settings: &Settings, witness: &Witness<'_>) -> Result<Self, Failure> {
        let start = Instant::now();
        let raw = solve_raw_near(witness, settings).map_err(|error| input.error(error))?;
        let seconds = start.elapsed().as_secs_f64();
        Ok(Self::on_grid(input, settings, raw.judged(witness, &Demand::default()), seconds))
    }

    /// The same for the comparison of all methods and solvers, which leaves out solvers that need too long on so fine a grid.
    pub(super) fn compared(input: &Input, settings: &Settings, witness: &Witness<'_>) -> Result<Self, Failure> {
        let (intervals, most) = (settings.intervals, most_intervals(settings.solver));
        if intervals <= most {
            return Self::discretised(input, settings, witness);
        }
        let why = format!("not tried: {intervals} intervals, {most} is the limit of this solver in a comparison");
        let raw = left_out(&input.scene, settings, why).map_err(|error| input.error(error))?;
        Ok(Self::on_grid(input, settings, raw.judged(witness, &Demand::default()), 0.0))
    }

    fn adaptive(input: &Input, request: &Request) -> Result<Self, Failure> {
        let begin = Instant::now();
        let mut search = Search::new(&input.scene, request);
        let mut times = Vec::new();
        let adapted = loop {
            let settings = search.settings();
            let start = Instant::now();
            let raw = solve_raw(&input.scene, &settings).map_err(|error| input.error(error))?;
            times.push(start.elapsed().as_secs_f64());
            if let Some(adapted) = search.record(settings, raw) {
                break adapted;
            }
        };
        let seconds = begin.elapsed().as_secs_f64();
        let trials: Vec<(Trial, f64)> = adapted.trials.into_iter().zip(times).collect();
        let of_answer = |t: &&(Trial, f64)| {
            t.0.intervals == adapted.settings.intervals && t.0.tolerance.total_cmp(&adapted.settings.tolerance).is_eq()
        };
        let alone = trials.iter().find(of_answer).map_or(seconds, |t| t.1);
        let grids = Grids { demanded: request.error, end: adapted.end, trials, seconds };
        Ok(Self { grids: Some(grids), ..Self::on_grid(input, &adapted.settings, adapted.solution, alone) })
    }

    fn on_grid(input: &Input, settings: &Settings, solution: Solution, seconds: f64) -> Self {
        let (method, solver) = (settings.method.name(), settings.solver.name());
        let length = input.scene.beam().length();
        Self { length, method, solver, intervals: Some(settings.intervals), seconds, solution, grids: None }
    }

    /// The error bound of the deflection, or any other flaw, and what to do about it.
    pub(super) fn reason(&self) -> String {
        let verdict = &self.solution.verdict;
        match (verdict.refusal, self.intervals, &self.grids) {
            (Some(Refusal::Error { .. } | Refusal::Number { .. }), None, _) => {
                format!("it meets all conditions of beam theory, and {verdict}")
            }
            (Some(Refusal::Error { .. } | Refusal::Number { .. }), Some(_), Some(_)) => {
                format!("it solves its grid, and {verdict}")
            }
            (Some(Refusal::Error { .. } | Refusal::Number { .. }), Some(_), None) => {
                format!("it solves its grid, and {verdict}: refine (--intervals), or ask for an error (--tolerance)")
            }
            _ => verdict.to_string(),
        }
    }

    /// Warnings about the scene or the model that do not prevent an answer.
    pub(super) fn warnings(&self, input: &Input) -> Vec<String> {
        let large = self.solution.has_answer().then(|| self.solution.state.large_deflection(self.length)).flatten();
        let value = |varies| input.labels().length.value(varies);
        let varies = large.map(|varies| format!("the deflection varies by {} along the beam, {LARGE}", value(varies)));
        input.warnings().iter().cloned().chain(varies).collect()
    }

    /// The warnings of several answers together.
    pub(super) fn warnings_of<'a>(all: impl Iterator<Item = &'a Self>, input: &Input) -> Vec<String> {
        let large = all.filter_map(|answer| answer.solution.state.large_deflection(answer.length));
        let most = large.max_by(f64::total_cmp).map(|most| {
            let most = input.labels().length.value(most);
            format!("the deflection varies by up to {most} along the beam, {LARGE}")
        });
        input.warnings().iter().cloned().chain(most).collect()
    }

    /// Whether the answer passed our own check.
    pub(super) fn is_certified(&self) -> bool {
        self.solution.verdict.status == Status::Certified
    }

    /// The proof of the exact answer. For an answer on a grid it is the proof of the theory's answer, on which its bounds rest.
    pub(super) fn proof(&self, input: &Input) -> Result<proof::Fields, Failure> {
        let proven = match &self.solution.exact {
            Some(exact) => proof::prove(&input.scene, exact),
            None => proof::prove(&input.scene, &theory::solve(&input.scene)?),
        };
        Ok(proven?)
    }

    /// The values at the nodes of a grid.
    pub(super) fn nodes(&self) -> Option<&Nodes> {
        self.solution.state.nodes.as_ref()
    }
}
