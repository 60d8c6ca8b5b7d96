//! An answer with its verdict and its time, whichever way it was found.

use std::time::Instant;

use palkki::certificate::{Certificate, ContactLoad, Judged, certify, certify_contacts};
use palkki::route::Status;
use palkki::scene::Scene;
use palkki::state::{ContactState, Nodes};
use palkki::theory::{Exact, TheoryError};
use palkki::{Settings, solve};

use super::exact::exact;
use super::failure::Failure;
use super::input::Input;

/// A way to an answer.
#[derive(Debug, Clone, Copy)]
pub(super) enum Route {
    /// Beam theory.
    Exact,
    /// A method of the paper with a solver.
    Discretised(Settings),
}

/// What is printed.
#[derive(Debug)]
pub(super) struct Answer {
    pub(super) method: &'static str,
    pub(super) solver: &'static str,
    /// Intervals of the grid, if there is one.
    pub(super) intervals: Option<usize>,
    pub(super) status: Status,
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
}

/// Bounds for an answer, in the units of the scene.
pub(super) fn certificate(scene: &Scene, state: &ContactState) -> Option<Certificate> {
    match &state.nodes {
        Some(nodes) => {
            let forces = nodes.x.iter().copied().zip(nodes.contact_force.iter().copied());
            let load = ContactLoad::new(scene.beam().length(), forces).ok()?;
            certify(scene, &load, Judged::Nodes(nodes)).ok()
        }
        None => certify_contacts(scene, &state.contacts).ok(),
    }
}

impl Answer {
    /// Solves the scene.
    pub(super) fn of(input: &Input, route: Route) -> Result<Self, Failure> {
        match route {
            Route::Exact => exact(input).map_err(|error| match error {
                TheoryError::Scene(error) => input.error(error),
                error => Failure::NoTheory(error),
            }),
            Route::Discretised(settings) => Self::discretised(input, &settings),
        }
    }

    fn discretised(input: &Input, settings: &Settings) -> Result<Self, Failure> {
        let start = Instant::now();
        let outcome = solve(&input.scene, settings).map_err(|error| input.error(error))?;
        let seconds = start.elapsed().as_secs_f64();
        Ok(Self {
            method: settings.method.word(),
            solver: settings.solver.word(),
            intervals: Some(settings.intervals),
            status: outcome.status,
            solver_status: outcome.solver_status,
            residual: Some(outcome.residual),
            unknowns: outcome.unknowns,
            iterations: outcome.iterations,
            seconds,
            certificate: certificate(&input.scene, &outcome.state),
            state: outcome.state,
            exact: None,
        })
    }

    /// The values at the nodes of a grid.
    pub(super) fn nodes(&self) -> Option<&Nodes> {
        self.state.nodes.as_ref()
    }
}
