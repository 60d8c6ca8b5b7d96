//! `compare`: every method with every solver, set against two references.

use palkki::route::{Method, Solver, Status};
use palkki::state::ContactState;
use palkki::{Settings, Witness, verdict::Demand};

use super::answer::{Answer, Route};
use super::failure::Failure;
use super::input::Input;

/// All answers for one scene and one grid.
#[derive(Debug)]
pub(super) struct Comparison {
    pub(super) intervals: usize,
    pub(super) routes: Vec<Compared>,
}

/// An answer and how far it is from the references that it has.
#[derive(Debug)]
pub(super) struct Compared {
    pub(super) answer: Answer,
    /// Against the active-set answer for the same programme: what the solver is responsible for.
    pub(super) solver_error: Option<Difference>,
    /// Against beam theory: what the grid is responsible for, too.
    pub(super) model_error: Option<Difference>,
}

/// Relative differences from a reference, infinite where the reference is zero and the answer is not.
#[derive(Debug, Clone)]
pub(super) struct Difference {
    /// Whose answer the reference is.
    pub(super) reference: String,
    /// The larger of those of the two end reactions, relative to the larger of the two.
    pub(super) reaction: f64,
    /// Of `J(v)`.
    pub(super) energy: f64,
    /// Of the largest deflection.
    pub(super) deflection: f64,
}

impl Comparison {
    /// Solves the scene by every route. Beam theory comes first, if it has an answer.
    pub(super) fn of(input: &Input, intervals: usize) -> Result<Self, Failure> {
        let exact = Answer::of(input, Route::Exact(Demand::default())).ok();
        // One witness for all of them.
        let witness = match exact.as_ref().and_then(|answer| answer.exact.as_deref()) {
            Some(exact) => Witness::known(&input.scene, exact),
            None => Witness::of(&input.scene),
        };
        let mut answers: Vec<(Method, Answer)> = Vec::new();
        for method in Method::ALL {
            for solver in Solver::ALL {
                let settings = Settings::new(method, solver, intervals);
                answers.push((method, Answer::discretised(input, &settings, &witness)?));
            }
        }
        let differences: Vec<_> = answers
            .iter()
            .map(|(method, answer)| {
                let reference = reference(&answers, *method);
                let solver_error = reference.map(|reference| Difference::between(answer, reference));
                let model_error = exact.as_ref().map(|reference| Difference::between(answer, reference));
                (solver_error, model_error)
            })
            .collect();
        let compared = answers
            .into_iter()
            .zip(differences)
            .map(|((_, answer), (solver_error, model_error))| Compared { answer, solver_error, model_error });
        let exact = exact.map(|answer| Compared { answer, solver_error: None, model_error: None });
        Ok(Self { intervals, routes: exact.into_iter().chain(compared).collect() })
    }
}

/// The answer that the solver error of `method` is measured by, if it passed our check.
///
/// Displacement and force method have the same optimum: both are measured by the force method, whose active-set answer
/// does not lose digits on fine grids.
fn reference(answers: &[(Method, Answer)], method: Method) -> Option<&Answer> {
    let method = match method {
        Method::Complementarity => Method::Complementarity,
        Method::Displacement | Method::Force => Method::Force,
    };
    let found = answers.iter().find(|(m, answer)| *m == method && answer.solver == Solver::ActiveSet.word());
    found.map(|(_, answer)| answer).filter(|answer| answer.status == Status::Certified)
}

impl Difference {
    fn between(answer: &Answer, reference: &Answer) -> Self {
        let (a, b): (&ContactState, &ContactState) = (&answer.state, &reference.state);
        let (left, right) = (a.reactions.left - b.reactions.left, a.reactions.right - b.reactions.right);
        Self {
            reference: format!("{}/{}", reference.method, reference.solver),
            reaction: relative(larger(left, right), larger(b.reactions.left, b.reactions.right)),
            energy: relative(a.energy - b.energy, b.energy),
            deflection: relative(a.deflection.max - b.deflection.max, b.deflection.max),
        }
    }

    /// The worst of the three; NaN if one of them is.
    pub(super) fn worst(&self) -> f64 {
        larger(larger(self.reaction, self.energy), self.deflection)
    }
}

/// The larger magnitude; NaN, which an answer that went wrong may contain, is never lost.
fn larger(a: f64, b: f64) -> f64 {
    if a.is_nan() || b.is_nan() { f64::NAN } else { a.abs().max(b.abs()) }
}

fn relative(difference: f64, size: f64) -> f64 {
    if difference == 0.0 { 0.0 } else { difference.abs() / size.abs() }
}
