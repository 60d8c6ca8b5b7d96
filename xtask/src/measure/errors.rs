//! Two errors, kept apart: of the solver, against the proven optimum of the same discrete problem, and of grid and solver
//! together, against beam theory.

use std::cell::RefCell;
use std::collections::BTreeMap;
use std::rc::Rc;

use palkki::scene::Scene;
use palkki::state::{Bending, Contact};
use palkki::theory::{self, Exact};

use super::job::Measured;
use super::plan::{Job, Route};
use super::reference::{Found, Reference};

/// Relative errors of end reaction, resultant of the largest contact, deflection (the worst node, over the largest
/// deflection) and energy; NaN where there is no reference or no answer.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Errors {
    pub(crate) solver: [f64; 4],
    pub(crate) total: [f64; 4],
}

/// Proven optima by grid, of the finite differences or not; none where there is none.
type Known = BTreeMap<(usize, bool), Option<Rc<Reference>>>;

/// Beam theory, and the proven optimum on every grid that was asked for.
#[derive(Debug)]
pub(super) struct References {
    exact: Exact,
    length: f64,
    known: RefCell<Known>,
}

impl References {
    pub(super) fn new(scene: &Scene) -> Result<Self, String> {
        let exact = theory::solve(scene).map_err(|error| error.to_string())?;
        Ok(Self { exact, length: scene.beam().length(), known: RefCell::default() })
    }

    /// Of an answer that was measured.
    pub(super) fn errors(&self, scene: &Scene, job: Job, measured: &Measured) -> Errors {
        let state = &measured.state;
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
        let bending = match job.route {
            Route::Exact | Route::Adaptive(..) => return None,
            Route::Solver(method, _) | Route::Optimum(method) => method.bending(),
            Route::Repair(_) => Bending::Between,
        };
        let key = (job.intervals, bending == Bending::AtNodes);
        if let Some(known) = self.known.borrow().get(&key) {
            return known.clone();
        }
        let found = Reference::new(scene, job.intervals, bending, &|x| self.in_largest(x)).map(Rc::new);
        self.known.borrow_mut().insert(key, found.clone());
        found
    }

    /// Reaction, resultant and energy, and deflections at the interior nodes of equal intervals.
    fn against_theory(&self, [reaction, contact, energy]: [f64; 3], deflection: &[f64]) -> [f64; 4] {
        let state = &self.exact.state;
        let resultant = self.largest_contact().and_then(|i| state.contacts.get(i)).map_or(0.0, |c| c.force);
        let share = |found: f64, exact: f64| (found - exact).abs() / exact.abs();
        #[expect(clippy::cast_precision_loss, reason = "numbers of nodes stay far below 2⁵³")]
        let place = |i: usize| self.length * (i + 1) as f64 / (deflection.len() + 1) as f64;
        let off = deflection.iter().enumerate().map(|(i, v)| (v - self.exact.deflection(place(i))).abs());
        // `max` would overlook NaN.
        let worst = off.fold(0.0, |worst: f64, off| if worst >= off { worst } else { off });
        let largest = state.deflection.max.abs().max(state.deflection.min.abs());
        let [reaction, energy] = [(reaction, state.reactions.left), (energy, state.energy)].map(|(f, e)| share(f, e));
        [reaction, share(contact, resultant), worst / largest, energy]
    }

    /// The contact that is the largest one by beam theory.
    fn largest_contact(&self) -> Option<usize> {
        let contacts = &self.exact.state.contacts;
        (0..contacts.len()).max_by(|&i, &j| contacts[i].force.total_cmp(&contacts[j].force))
    }

    /// Whether a force there belongs to that contact: it is nearer to it than to others.
    fn in_largest(&self, x: f64) -> bool {
        let contacts = &self.exact.state.contacts;
        let distance = |i: usize| {
            let c: &Contact = &contacts[i];
            (c.from - x).max(x - c.to).max(0.0)
        };
        let nearest = (0..contacts.len()).min_by(|&i, &j| distance(i).total_cmp(&distance(j)));
        nearest.is_some() && nearest == self.largest_contact()
    }
}
