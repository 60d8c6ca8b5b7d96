//! Two errors, kept apart: of the solver, against the best answer of the same discrete problem, and of grid and solver
//! together, against beam theory.

use std::cell::RefCell;
use std::collections::BTreeMap;

use palkki::methods::Method;
use palkki::route::Status;
use palkki::scene::Scene;
use palkki::solvers::Solver;
use palkki::state::{Contact, ContactState};
use palkki::{Settings, solve, theory};

use super::job::Measured;
use super::plan::{Job, Route};

/// What is compared.
pub(crate) const OBSERVABLES: [&str; 4] = ["end reaction", "largest contact force", "largest deflection", "energy"];

/// Relative errors of the four observables; NaN where there is no reference or no answer.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Errors {
    pub(crate) solver: [f64; 4],
    pub(crate) total: [f64; 4],
}

/// Observables of the active set by method and grid; none where it is not certified.
type Known = BTreeMap<(Method, usize), Option<[f64; 4]>>;

/// Beam theory, and the active set on every grid that was asked for.
#[derive(Debug)]
pub(crate) struct References {
    exact: ContactState,
    discrete: RefCell<Known>,
}

impl References {
    pub(crate) fn new(scene: &Scene) -> Result<Self, String> {
        let exact = theory::solve(scene).map_err(|error| error.to_string())?.state;
        Ok(Self { exact, discrete: RefCell::default() })
    }

    pub(crate) fn errors(&self, scene: &Scene, job: Job, measured: &Measured) -> Result<Errors, String> {
        let found = self.observables(&measured.state);
        let exact = self.observables(&self.exact);
        let solver = match job.route {
            Route::Exact => [0.0; 4],
            Route::Solver(Method::Complementarity, _) => {
                relative(&found, self.discrete(scene, Method::Complementarity, job.intervals)?)
            }
            Route::Solver(..) | Route::Repair(_) => {
                relative(&found, self.discrete(scene, Method::Force, job.intervals)?)
            }
        };
        Ok(Errors { solver, total: relative(&found, Some(exact)) })
    }

    /// Observables of the certified active-set answer; displacement and force method share that of the force method.
    fn discrete(&self, scene: &Scene, method: Method, intervals: usize) -> Result<Option<[f64; 4]>, String> {
        if let Some(known) = self.discrete.borrow().get(&(method, intervals)) {
            return Ok(*known);
        }
        let settings = Settings::new(method, Solver::ActiveSet, intervals);
        let outcome = solve(scene, &settings).map_err(|error| error.to_string())?;
        let found = (outcome.status == Status::Certified).then(|| self.observables(&outcome.state));
        self.discrete.borrow_mut().insert((method, intervals), found);
        Ok(found)
    }

    fn observables(&self, state: &ContactState) -> [f64; 4] {
        [state.reactions.left, self.largest_contact(state), state.deflection.max, state.energy]
    }

    /// Resultant of the contact that is the largest one by beam theory: of all forces that are nearer to it than to others.
    fn largest_contact(&self, state: &ContactState) -> f64 {
        let contacts = &self.exact.contacts;
        let Some(largest) = (0..contacts.len()).max_by(|&i, &j| contacts[i].force.total_cmp(&contacts[j].force)) else {
            return 0.0;
        };
        let distance = |c: &Contact, x: f64| (c.from - x).max(x - c.to).max(0.0);
        let nearest = |x: f64| {
            (0..contacts.len()).min_by(|&i, &j| distance(&contacts[i], x).total_cmp(&distance(&contacts[j], x)))
        };
        match &state.nodes {
            None => contacts[largest].force,
            Some(nodes) => {
                let forces = nodes.x.iter().zip(&nodes.contact_force);
                forces.filter(|(x, _)| nearest(**x) == Some(largest)).map(|(_, p)| p).sum()
            }
        }
    }
}

fn relative(found: &[f64; 4], reference: Option<[f64; 4]>) -> [f64; 4] {
    std::array::from_fn(|i| reference.map_or(f64::NAN, |r| (found[i] - r[i]).abs() / r[i].abs()))
}
