//! Any elastic body above a foundation in place of the beam: "the methods are easy to extend to cases in which some other elastic
//! body stands in the place of the beam and in which the foundation is elastic as well".
//!
//! ```text
//! stiffness K     variables: clearances h      K h = (K g − q) + p
//! flexibility C   variables: contact forces p  (C + G) p = (C q − g) + h
//!
//! h ≥ 0, p ≥ 0, h_i p_i = 0     displacements v = g − h under loads q − p;  g: gaps;  G: flexibility of the foundation, 0 if it is rigid
//! ```
//!
//! Both are the quadratic program (32) with a given matrix. The [proof] bounds the error of any answer from below and above.

pub mod matrix_market;
mod problem;
pub mod proof;
mod reach;

pub use problem::BodyProblem;

use self::proof::{Errors, Off, Unproven};
use self::reach::{Reach, displaced_by};
use crate::double::Double;
use crate::qp::{Explicit, Profile, Qp as _, Sums};
use crate::scene::Units;
use crate::solvers::{Answer, Solver, active_set_of};
use crate::text::{magnitude_at_least, magnitude_at_most, share_at_most};
use crate::verdict::Status;

/// The given matrix of a body, which also determines the variables of the program.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// Force over displacement; the variables are clearances.
    Stiffness,
    /// Displacement over force; the variables are contact forces.
    Flexibility,
}

/// An elastic body with its gaps and loads.
#[derive(Debug, Clone, PartialEq)]
pub struct Body {
    /// The title.
    pub title: String,
    /// Labels of the units.
    pub units: Units,
    kind: Kind,
    gap: Vec<f64>,
    reach: Reach,
    load: Vec<f64>,
    program: Explicit,
}

/// Limit for the products that the four-step solver may need in at most `n` factorisations: some seconds.
const MOST_PRODUCTS: usize = 1 << 33;

impl Body {
    /// Creates a body from its matrix, gaps and loads. `foundation` is the flexibility of an elastic foundation and is given only
    /// with a flexibility of the body. An infinite gap means that there is no foundation.
    ///
    /// # Errors
    ///
    /// [`BodyProblem::Sizes`] if matrices, gaps and loads have different sizes, [`BodyProblem::NotPositiveDefinite`] if a pivot
    /// is not positive, and [`BodyProblem::Range`] if a product with gaps or loads is not finite.
    pub fn new(
        kind: Kind,
        matrix: Profile,
        foundation: Option<&Profile>,
        gap: Vec<f64>,
        load: Vec<f64>,
    ) -> Result<Self, BodyProblem> {
        let n = matrix.dimension();
        let others = [
            ("matrix of the foundation", foundation.map_or(n, Profile::dimension)),
            ("list of gaps", gap.len()),
            ("list of loads", load.len()),
        ];
        if let Some(&(what, found)) = others.iter().find(|(_, found)| *found != n) {
            return Err(BodyProblem::Sizes { what, body: n, found });
        }
        let times = |matrix: &Profile, values: &[f64]| {
            let mut sums = Sums::zero(n);
            matrix.times_into(&values.iter().copied().map(Double::exact).collect::<Vec<_>>(), &mut sums);
            sums
        };
        let displaced = (kind == Kind::Flexibility).then(|| times(&matrix, &load));
        let parts = match foundation {
            Some(foundation) => matrix.sum(foundation),
            None => [matrix, Profile::default()],
        };
        let program = Explicit::factored(parts)?;
        let free = displaced_by(&program, &load, displaced.as_ref());
        let reach = Reach::new(kind, &program, &gap, free);
        let (mut linear, taken) = match displaced {
            Some(displaced) => (displaced, &reach.gap),
            None => (times(program.profile(), &reach.gap), &load),
        };
        taken.iter().enumerate().for_each(|(i, taken)| linear.add(i, -1.0, Double::exact(*taken)));
        if !linear.values.iter().all(|b| b.rounded().is_finite()) {
            return Err(BodyProblem::Range);
        }
        let program = program.with_linear(linear);
        Ok(Self { title: String::new(), units: Units::default(), kind, gap, reach, load, program })
    }

    /// The name of the paper's method to which the program corresponds.
    #[must_use]
    pub fn method(&self) -> &'static str {
        match self.kind {
            Kind::Stiffness => "displacement",
            Kind::Flexibility => "force",
        }
    }

    /// The quadratic program.
    #[must_use]
    pub fn program(&self) -> &Explicit {
        &self.program
    }

    /// Solves the program; `tolerance` is the scaled residual at which an iterative solver may stop. The active set starts from
    /// the free variables of an interior-point method.
    #[must_use]
    pub fn run(&self, solver: Solver, tolerance: f64) -> Answer {
        let n = self.program.dimension();
        let products = self.program.factor().products().saturating_mul(n);
        let mut answer = match solver {
            Solver::ActiveSet => return active_set_of(&self.program),
            Solver::FourStep if MOST_PRODUCTS < products => Answer::refused(
                n,
                format!("not tried: up to {products} products, {MOST_PRODUCTS} is the limit of this solver for a body"),
            ),
            other => other.run(&self.program, tolerance),
        };
        answer.gradient = self.program.gradient(&answer.x);
        answer
    }

    /// The distance of each degree of freedom from the foundation before loading; infinite without a foundation.
    #[must_use]
    pub(crate) fn gap(&self) -> &[f64] {
        &self.gap
    }

    /// Whether the loads cannot bring a degree of freedom into contact, whatever contacts occur elsewhere.
    fn is_out_of_reach(&self, i: usize) -> bool {
        self.reach.gap[i] < self.gap[i]
    }

    /// The clearance and the contact force of each degree of freedom in an answer.
    #[must_use]
    pub fn clearance_and_force(&self, answer: &Answer) -> [Vec<f64>; 2] {
        let (clearance, force) = self.clearance_within_reach(answer);
        let beyond = |(i, h): (usize, &f64)| {
            let (gap, within) = (self.gap[i], self.reach.gap[i]);
            if within < gap { gap - (within - h) } else { *h }
        };
        [clearance.iter().enumerate().map(beyond).collect(), force.to_vec()]
    }

    /// The clearances and contact forces in an answer, with the reduced gaps of the program where the foundation is out of reach.
    fn clearance_within_reach<'a>(&self, answer: &'a Answer) -> (&'a [f64], &'a [f64]) {
        match self.kind {
            Kind::Stiffness => (&answer.x, &answer.gradient),
            Kind::Flexibility => (&answer.gradient, &answer.x),
        }
    }

    /// Potential energy `½ vᵀ K v − qᵀ v` of the body in an answer, including the energy of an elastic foundation.
    #[must_use]
    pub fn energy(&self, answer: &Answer) -> f64 {
        let x: Vec<Double> = answer.x.iter().copied().map(Double::exact).collect();
        proof::energy(self, &x, &self.program.gradient_at(&x)).0.rounded()
    }
}

/// The verdict on clearances, contact forces and energy.
#[derive(Debug, Clone, PartialEq)]
pub struct Verdict {
    /// Certified or not.
    pub status: Status,
    /// The error bounds, or the reason why nothing is proven.
    pub reason: String,
    /// The error bounds as numbers.
    pub errors: Errors,
}

impl Verdict {
    /// Derives the verdict from the errors; `demanded` is relative to the largest value of each quantity.
    #[must_use]
    pub fn new(errors: Result<Errors, Unproven>, demanded: f64, reports_success: bool) -> Self {
        let known = errors.unwrap_or(Errors::UNKNOWN);
        let all = [("clearances", known.clearance), ("contact forces", known.force), ("energy", known.energy)];
        let status = Status::of_body(all.map(|(_, off)| off.share), demanded, reports_success);
        let reason = match errors {
            Err(unproven) => unproven.to_string(),
            Ok(_) if all.iter().any(|(_, off)| !off.least.is_finite()) => {
                "the clearances and contact forces are not all numbers".to_owned()
            }
            Ok(_) if status == Status::Certified => {
                let [clearance, force, energy] = all.map(|(_, off)| share_at_most(off.share));
                format!(
                    "the errors of clearances, contact forces and energy are at most {clearance}, {force} and {energy} of the largest"
                )
            }
            Ok(_) => {
                let wrong = all.iter().filter(|(_, off)| !Status::is_certain(off.share, demanded));
                let told = wrong.map(|(what, Off { least, most, share })| {
                    let [least, most] = [magnitude_at_least(*least), magnitude_at_most(*most)];
                    let share = share_at_most(*share);
                    format!("the error of the {what} is at least {least} and at most {most}, {share} of the largest")
                });
                told.collect::<Vec<_>>().join("; ")
            }
        };
        Self { status, reason, errors: known }
    }
}
