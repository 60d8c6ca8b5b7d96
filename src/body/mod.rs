//! Any elastic body above ground in place of the beam: "the methods are easy to extend to cases in which some other elastic body stands in
//! the place of the beam and in which the foundation is elastic as well".
//!
//! ```text
//! stiffness K     variables: clearances h      K h = (K g − q) + p
//! flexibility C   variables: contact forces p  (C + G) p = (C q − g) + h
//!
//! h ≥ 0, p ≥ 0, h_i p_i = 0     displacements v = g − h of loads q − p;  g: gaps;  G: flexibility of the ground, 0 if it is rigid
//! ```
//!
//! Both are the quadratic program (32), of a matrix that is given. The [proof] bounds the error of any answer from both sides.

pub mod matrix_market;
mod problem;
pub mod proof;

pub use problem::BodyProblem;

use self::proof::{Off, Unproven};
use crate::double::Double;
use crate::qp::{Explicit, Profile, Qp as _, Sums};
use crate::scene::Units;
use crate::solvers::{Answer, Solver, active_set_of};
use crate::text::{magnitude_at_least, magnitude_at_most, share_at_most};
use crate::verdict::Status;

/// Which matrix of a body is given, and with it which variables the program has.
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
    /// What it is called.
    pub title: String,
    /// Labels of its units.
    pub units: Units,
    kind: Kind,
    gap: Vec<f64>,
    load: Vec<f64>,
    program: Explicit,
}

/// Products that the four steps may take, `n` factorisations at most: some seconds.
const MOST_PRODUCTS: usize = 1 << 33;

impl Body {
    /// A body from its matrix, that of an elastic foundation, which goes with a flexibility, gaps and loads.
    ///
    /// # Errors
    ///
    /// [`BodyProblem::Sizes`] if the matrices, gaps and loads are not of one size, [`BodyProblem::NotPositiveDefinite`] if a pivot is
    /// not positive.
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
        let (given, taken) = match kind {
            Kind::Stiffness => (&gap, &load),
            Kind::Flexibility => (&load, &gap),
        };
        let mut linear = Sums::zero(n);
        matrix.times_into(&given.iter().copied().map(Double::exact).collect::<Vec<_>>(), &mut linear);
        taken.iter().enumerate().for_each(|(i, taken)| linear.add(i, -1.0, Double::exact(*taken)));
        let parts = match foundation {
            Some(foundation) => matrix.sum(foundation),
            None => [matrix, Profile::default()],
        };
        let program = Explicit::of_sums(parts, linear)?;
        Ok(Self { title: String::new(), units: Units::default(), kind, gap, load, program })
    }

    /// Which matrix was given.
    #[must_use]
    pub fn kind(&self) -> Kind {
        self.kind
    }

    /// The method of the paper that its program is, by its name.
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

    /// Solves the program by a solver; `tolerance` is the scaled residual at which an iterative one may stop. The active set begins
    /// with the free variables of an interior-point method.
    #[must_use]
    pub fn run(&self, solver: Solver, tolerance: f64) -> Answer {
        let n = self.program.dimension();
        let products = self.program.profile().products().saturating_mul(n);
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

    /// The clearance of each freedom to the ground by an answer, and the force of the ground on it.
    #[must_use]
    pub fn clearance_and_force<'a>(&self, answer: &'a Answer) -> [&'a [f64]; 2] {
        match self.kind {
            Kind::Stiffness => [&answer.x, &answer.gradient],
            Kind::Flexibility => [&answer.gradient, &answer.x],
        }
    }

    /// Potential energy `½ vᵀ K v − qᵀ v` of the body by an answer, with that of an elastic foundation.
    #[must_use]
    pub fn energy(&self, answer: &Answer) -> f64 {
        let b = self.program.linear();
        let each = answer.x.iter().zip(answer.gradient.iter().zip(&b));
        let bent: f64 = match self.kind {
            Kind::Stiffness => each.map(|(x, (g, b))| x * (g - b)).sum(),
            Kind::Flexibility => each.map(|(x, (g, b))| x * (g + b)).sum(),
        };
        0.5 * bent + proof::constant(self).0.rounded()
    }
}

/// The verdict on clearances.
#[derive(Debug, Clone, PartialEq)]
pub struct Verdict {
    /// Certified or not.
    pub status: Status,
    /// How far they may be off, or why nothing is known of it.
    pub reason: String,
    /// How far they are off.
    pub off: Off,
}

impl Verdict {
    /// From how far they are off; `demanded` is a share of the largest of them.
    #[must_use]
    pub fn new(off: Result<Off, Unproven>, demanded: f64, reports_success: bool) -> Self {
        let known = off.unwrap_or(Off { least: 0.0, most: f64::INFINITY, share: f64::INFINITY });
        let status = Status::of_body(known.share, demanded, reports_success);
        let share = share_at_most(known.share);
        let reason = match off {
            Err(unproven) => unproven.to_string(),
            Ok(Off { least, .. }) if !least.is_finite() => "the clearances are not all numbers".to_owned(),
            Ok(_) if status == Status::Certified => format!("the clearances are certain to {share} of the largest"),
            Ok(Off { least, most, .. }) => format!(
                "the clearances are off by at least {} and at most {}, {share} of the largest",
                magnitude_at_least(least),
                magnitude_at_most(most),
            ),
        };
        Self { status, reason, off: known }
    }
}
