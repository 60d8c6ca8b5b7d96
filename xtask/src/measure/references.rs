//! Two errors, kept apart: of the solver, against the proven optimum of the same discrete problem, and of grid and solver
//! together, against beam theory.
//!
//! The contact set of an active set is only where the search for the proven optimum begins: in integers of hundreds of bits
//! nodes on the wrong side are exchanged until (34), (35) hold by more than all rounding. What comes out is *the* optimum,
//! better than every answer that is compared with it.

use std::cell::RefCell;
use std::collections::BTreeMap;
use std::rc::Rc;
use std::time::Instant;

use palkki::methods::Method;
use palkki::scene::Scene;
use palkki::solvers::Solver;
use palkki::state::{Contact, ContactState, Discretisation};
use palkki::theory::{self, Exact};
use palkki::{Settings, solve_raw};

use super::plan::{Job, Route};
use crate::text::as_number;
use palkki_evidence::authority::number::{Fixed, Number};
use palkki_evidence::authority::{forward, given};
use palkki_evidence::compare::{apart, largest};

/// Relative errors of end reaction, resultant of the largest contact, deflection (the worst node, over the largest
/// deflection) and energy; no finite numbers where there is no reference or no answer.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Errors {
    pub(super) solver: [f64; 4],
    pub(super) total: [f64; 4],
}

/// Proven optima by grid, of the finite differences or not; none where there is none.
type Known = BTreeMap<(usize, bool), Option<Rc<Reference>>>;

/// Beam theory, and the proven optimum on every grid that was asked for.
#[derive(Debug)]
pub(super) struct References {
    /// None where beam theory refuses the scene.
    exact: Option<Exact>,
    /// The contact that is the largest one by beam theory.
    largest: Option<usize>,
    length: f64,
    /// Whether optima are proven.
    proven: bool,
    known: RefCell<Known>,
}

impl References {
    pub(super) fn new(scene: &Scene, proven: bool) -> Self {
        let exact = theory::solve(scene).ok();
        let contacts = exact.iter().flat_map(|exact| exact.state.contacts.iter().enumerate());
        let largest = contacts.max_by(|(_, a), (_, b)| a.force.total_cmp(&b.force)).map(|(i, _)| i);
        Self { exact, largest, length: scene.beam().length(), proven, known: RefCell::default() }
    }

    /// Of the answer of a job.
    pub(super) fn errors(&self, scene: &Scene, job: Job, state: &ContactState) -> Errors {
        // Beam theory is what all others are compared with.
        let Some(nodes) = &state.nodes else { return Errors { solver: [0.0; 4], total: [0.0; 4] } };
        let forces = nodes.x.iter().zip(&nodes.contact_force);
        let contact: Vec<f64> = forces.filter(|(x, _)| self.in_largest(**x)).map(|(_, p)| *p).collect();
        let (reaction, energy) = (state.reactions.left, state.energy);
        let total = self.against_theory([reaction, contact.iter().sum(), energy], &nodes.deflection);
        let found = Found { reaction, contact, energy, deflection: &nodes.deflection };
        let reference = self.reference(scene, job);
        let solver = reference.map_or([f64::NAN; 4], |reference| reference.errors(&found));
        Errors { solver, total }
    }

    /// Of the proven optimum itself: nothing of the solver, all of the grid.
    pub(super) fn of_grid(&self, reference: &Reference) -> Errors {
        Errors { solver: [0.0; 4], total: self.against_theory(reference.sums(), &reference.deflection) }
    }

    /// The proven optimum of the discrete problem of a job.
    pub(super) fn reference(&self, scene: &Scene, job: Job) -> Option<Rc<Reference>> {
        if !self.proven {
            return None;
        }
        let discretisation = match job.route {
            Route::Exact | Route::Certified | Route::Adaptive(..) => return None,
            Route::Solver(method, _) | Route::Optimum(method) => method.discretisation(),
        };
        let key = (job.intervals, discretisation == Discretisation::FiniteDifferences);
        if let Some(known) = self.known.borrow().get(&key) {
            return known.clone();
        }
        let found = Reference::new(scene, job.intervals, discretisation, &|x| self.in_largest(x)).map(Rc::new);
        self.known.borrow_mut().insert(key, found.clone());
        found
    }

    /// Reaction, resultant and energy, and deflections at the interior nodes of equal intervals.
    fn against_theory(&self, [reaction, contact, energy]: [f64; 3], deflection: &[f64]) -> [f64; 4] {
        let Some(exact) = &self.exact else { return [f64::NAN; 4] };
        let state = &exact.state;
        let resultant = self.largest.and_then(|i| state.contacts.get(i)).map_or(0.0, |c| c.force);
        let share = |found: f64, exact: f64| (found - exact).abs() / exact.abs();
        let place = |i: usize| self.length * as_number(i + 1) / as_number(deflection.len() + 1);
        let worst = largest(deflection.iter().enumerate().map(|(i, v)| v - exact.deflection(place(i))));
        let [reaction, energy] = [(reaction, state.reactions.left), (energy, state.energy)].map(|(f, e)| share(f, e));
        [reaction, share(contact, resultant), worst / state.deflection.magnitude(), energy]
    }

    /// Whether a force there belongs to the largest contact: it is nearer to it than to others.
    fn in_largest(&self, x: f64) -> bool {
        let contacts = self.exact.as_ref().map_or(&[][..], |exact| &exact.state.contacts);
        let distance =
            |i: usize| contacts.get(i).map_or(f64::INFINITY, |c: &Contact| (c.from - x).max(x - c.to).max(0.0));
        let behind = contacts.partition_point(|c| c.to < x);
        let nearest = if behind == 0 || distance(behind) < distance(behind - 1) { behind } else { behind - 1 };
        self.largest == Some(nearest)
    }
}

/// The finest grid with a reference: seconds, and hundreds of megabytes.
const FINEST: usize = 100_000;

/// What is known of the optimum of a discrete problem.
#[derive(Debug)]
pub(super) struct Reference {
    reaction: Fixed,
    /// Resultant of the contact that is looked at.
    contact: Fixed,
    energy: Fixed,
    /// At the interior nodes; rounding them to 64 bits moves them by less than what is told apart.
    deflection: Vec<f64>,
    /// Exchanges that were needed.
    pub(super) exchanges: usize,
    pub(super) seconds: f64,
}

/// Observables of a floating-point answer.
#[derive(Debug)]
struct Found<'a> {
    reaction: f64,
    contact: Vec<f64>,
    energy: f64,
    deflection: &'a [f64],
}

impl Reference {
    /// The optimum on `intervals`; none beyond [`FINEST`], and none if the search does not end. `looked_at` says which nodes
    /// belong to the contact that is looked at.
    fn new(
        scene: &Scene,
        intervals: usize,
        discretisation: Discretisation,
        looked_at: &dyn Fn(f64) -> bool,
    ) -> Option<Self> {
        if FINEST < intervals {
            return None;
        }
        let method =
            if discretisation == Discretisation::FiniteDifferences { Method::Complementarity } else { Method::Force };
        let begin = solve_raw(scene, &Settings::new(method, Solver::ActiveSet, intervals)).ok()?.state.nodes?;
        let touches: Vec<bool> = begin.contact_force.iter().map(|p| 0.0 < *p).collect();

        let start = Instant::now();
        let problem = given::problem(scene, intervals, discretisation)?;
        let (solution, _, exchanges) = problem.optimum(touches)?;
        let forces = begin.x.iter().zip(&solution.contact_force[1..]);
        let looked_at = forces.filter(|(x, _)| looked_at(**x)).map(|(_, p)| p);
        Some(Self {
            reaction: solution.left_reaction(&problem.loads[0]),
            contact: looked_at.fold(Fixed::zero(), |sum, p| sum.plus(p)),
            energy: solution.energy(&problem.loads),
            deflection: (1..intervals).map(|i| solution.deflection(i).to_double()).collect(),
            exchanges,
            seconds: start.elapsed().as_secs_f64(),
        })
    }

    /// Relative errors of an answer of the same discrete problem: end reaction, contact, the worst of all nodal deflections
    /// against the largest, energy. Differences are taken exactly.
    fn errors(&self, found: &Found<'_>) -> [f64; 4] {
        let share = |found: f64, exact: &Fixed| forward::apart(found, exact) / exact.to_double().abs();
        let contact = if found.contact.iter().all(|p| p.is_finite()) {
            let sum = found.contact.iter().fold(Fixed::zero(), |sum, p| sum.plus(&Fixed::of(*p)));
            sum.minus(&self.contact).magnitude().to_double() / self.contact.to_double().abs()
        } else {
            f64::NAN
        };
        let deflection = apart(found.deflection, &self.deflection) / largest(self.deflection.iter().copied());
        [share(found.reaction, &self.reaction), contact, deflection, share(found.energy, &self.energy)]
    }

    /// Reaction, contact and energy, rounded once.
    fn sums(&self) -> [f64; 3] {
        [&self.reaction, &self.contact, &self.energy].map(Fixed::to_double)
    }
}
