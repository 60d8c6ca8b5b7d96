//! The command `compare`: every method with every solver, compared with two references.

use palkki::route::{Method, Solver, Status};
use palkki::state::ContactState;
use palkki::text::{magnitude, magnitude_at_most, share_at_most};
use palkki::verdict::{Demand, EXACT, USABLE};
use palkki::{Settings, Witness};
use serde::Serialize;

use super::answer::{Answer, Route};
use super::input::Input;
use super::output::Failure;
use super::table::{Labels, Row, list, table};

/// All answers for one scene and one grid.
#[derive(Debug)]
pub(super) struct Comparison {
    pub(super) intervals: usize,
    pub(super) routes: Vec<Compared>,
}

/// An answer and its differences from the references that exist.
#[derive(Debug)]
pub(super) struct Compared {
    pub(super) answer: Answer,
    /// Difference from the active-set answer for the same quadratic program: the solver error.
    pub(super) solver_error: Option<Difference>,
    /// Difference from beam theory: solver error and grid error together.
    pub(super) model_error: Option<Difference>,
}

/// Relative differences from a reference; infinite if the reference is zero and the answer is not.
#[derive(Debug, Clone, Serialize)]
pub(super) struct Difference {
    /// Method and solver of the reference.
    pub(super) reference: String,
    /// The largest difference of the reactions, relative to the largest reaction.
    pub(super) reaction: f64,
    /// The difference of `J(v)`.
    pub(super) energy: f64,
    /// The difference of the largest deflection.
    pub(super) deflection: f64,
}

impl Comparison {
    /// Solves the scene by beam theory and by every method with every solver. Beam theory comes first, if it has an answer.
    pub(super) fn of(input: &Input, intervals: usize) -> Result<Self, Failure> {
        let exact = Answer::of(input, Route::Exact(Demand::default())).ok();
        // One candidate contact list for all answers.
        let witness = match exact.as_ref().and_then(|answer| answer.solution.exact.as_deref()) {
            Some(exact) => Witness::known(&input.scene, exact),
            None => Witness::of(&input.scene),
        };
        let mut answers: Vec<(Method, Answer)> = Vec::new();
        for method in Method::ALL {
            for solver in Solver::ALL {
                let settings = Settings::new(method, solver, intervals);
                answers.push((method, Answer::compared(input, &settings, &witness)?));
            }
        }
        let differences: Vec<_> = answers
            .iter()
            .map(|(method, answer)| {
                // Without an answer there is nothing to compare.
                let exact = exact.as_ref().filter(|_| answer.solution.has_answer());
                let reference = reference(&answers, *method).filter(|_| answer.solution.has_answer());
                let solver_error = reference.map(|reference| Difference::between(answer, reference));
                let model_error = exact.map(|reference| Difference::between(answer, reference));
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

    /// The number of answers that passed our own check.
    fn certified(&self) -> usize {
        self.routes.iter().filter(|route| route.answer.is_certified()).count()
    }

    /// Whether at least one answer passed.
    pub(super) fn is_certified(&self) -> bool {
        0 < self.certified()
    }
}

/// The answer from which the solver error of `method` is measured, if it solves its discrete problem.
///
/// Displacement and force method have the same optimum. Both are compared with the force method, whose active-set answer loses no
/// digits on fine grids.
fn reference(answers: &[(Method, Answer)], method: Method) -> Option<&Answer> {
    let method = match method {
        Method::Complementarity => Method::Complementarity,
        Method::Displacement | Method::Force => Method::Force,
    };
    let found = answers.iter().find(|(m, answer)| *m == method && answer.solver == Solver::ActiveSet.name());
    found.map(|(_, answer)| answer).filter(|answer| answer.solution.verdict.solves_its_problem())
}

impl Difference {
    fn between(answer: &Answer, reference: &Answer) -> Self {
        let (a, b): (&ContactState, &ContactState) = (&answer.solution.state, &reference.solution.state);
        let forces = a.supports.iter().zip(&b.supports);
        let apart = forces.map(|(a, b)| a.force - b.force).fold(0.0, larger);
        let size = b.supports.iter().map(|support| support.force).fold(0.0, larger);
        Self {
            reference: format!("{}/{}", reference.method, reference.solver),
            reaction: relative(apart, size),
            energy: relative(a.energy - b.energy, b.energy),
            deflection: relative(a.deflection.max - b.deflection.max, b.deflection.max),
        }
    }

    /// The largest of the three; NaN if one of them is.
    pub(super) fn worst(&self) -> f64 {
        larger(larger(self.reaction, self.energy), self.deflection)
    }
}

/// The larger magnitude. NaN, which a failed answer may contain, is never lost.
fn larger(a: f64, b: f64) -> f64 {
    if a.is_nan() || b.is_nan() { f64::NAN } else { a.abs().max(b.abs()) }
}

fn relative(difference: f64, size: f64) -> f64 {
    if difference == 0.0 { 0.0 } else { difference.abs() / size.abs() }
}

/// The answers as text, one per row.
pub(super) fn text(input: &Input, comparison: &Comparison) -> String {
    let labels = input.labels();
    let error =
        |difference: &Option<Difference>| difference.as_ref().map_or_else(|| "–".to_owned(), |d| magnitude(d.worst()));
    let rows: Vec<Row> = comparison
        .routes
        .iter()
        .map(|compared| {
            let answer = &compared.answer;
            vec![
                answer.method.to_owned(),
                answer.solver.to_owned(),
                answer.solution.verdict.status.to_string(),
                magnitude(answer.solution.residual),
                answer.solution.run.iterations.to_string(),
                magnitude(answer.seconds),
                first_reaction(answer, &labels),
                magnitude_at_most(answer.solution.verdict.error),
                error(&compared.solver_error),
                error(&compared.model_error),
            ]
        })
        .collect();
    let at_left = input.scene.beam().all_supports().first().is_none_or(|support| support.at == 0.0);
    let reaction = labels.force.name(if at_left { "left reaction" } else { "first reaction" });
    let header = [
        "method",
        "solver",
        "status",
        "residual",
        "iterations",
        "seconds",
        &reaction,
        "certified error",
        "solver error",
        "model error",
    ];
    let status = Status::of_several(comparison.is_certified());
    let mut text = format!("{status}: {} of {} answers\n", comparison.certified(), comparison.routes.len());
    if !input.warnings().is_empty() {
        text = text + "\n" + input.warning_lines().trim_end() + "\n";
    }
    text += &table(&format!("{}, {} intervals", input.title(), comparison.intervals), &header, &rows);
    text.push_str(&not_tried(comparison));
    text += &format!(
        "\nCertified error: proven bound on the deflection error, relative to the largest deflection.\n\
         Certified: the answer solves its problem, and the proven errors of deflection, reactions, contact force and energy\n\
         are at most {} of the largest value of each, or {} without a grid.\n\
         Solver error: difference from the active-set answer on the same grid. Model error: difference from beam theory.\n\
         Both are the largest relative difference of end reactions, energy and largest deflection.\n",
        share_at_most(USABLE),
        share_at_most(EXACT),
    );
    text
}

/// The reaction of the first support.
fn first_reaction(answer: &Answer, labels: &Labels) -> String {
    answer.solution.state.supports.first().map_or_else(|| "–".to_owned(), |support| labels.number(support.force))
}

/// The reasons why routes were not tried, one per line; empty if all were.
fn not_tried(comparison: &Comparison) -> String {
    let lines: Vec<(String, String)> = comparison
        .routes
        .iter()
        .map(|compared| &compared.answer)
        .filter(|answer| !answer.solution.has_answer())
        .map(|answer| (format!("{}/{}", answer.method, answer.solver), answer.solution.run.message.clone()))
        .collect();
    if lines.is_empty() { String::new() } else { format!("\n{}", list(&lines)) }
}
