//! The operator-splitting library `osqp` (Stellato, Banjac, Goulart, Bemporad and Boyd 2020): only translation to its form and back.
//!
//! ```text
//! minimise ½ zᵀ P z + cᵀ z   subject to   e ≤ E z ≤ e,   0 ≤ z_k ≤ ∞ for the variables with a sign
//! ```
//!
//! in the [sparse form](crate::qp::SparseForm) of a program, or the form of its matrix if it has no other. The multipliers of the
//! sign constraints are the gradient with the opposite sign.

use ::osqp::{CscMatrix, Problem, Settings, Status};

use super::{Answer, OwnResidual, Run, sparse_form};
use crate::qp::{Qp, UpperColumns};

/// The value that the library treats as infinity (`OSQP_INFTY`).
const INFINITY: f64 = 1e30;

/// Budget of a run in multiplications. The limit on iterations follows from it, so that no clock is needed.
const MULTIPLICATIONS: usize = 1 << 31;

/// Iterations between two adaptations of the step size ρ, and between two checks for termination. By default a clock decides.
const INTERVAL: u32 = 25;

/// Rounds of iterative refinement when an answer is polished.
const REFINEMENTS: u32 = 20;

/// Range to which the limit on iterations is restricted.
const ITERATIONS: [usize; 2] = [1000, 200_000];

/// The settings as text.
pub(super) fn settings_text(tolerance: f64) -> String {
    let [least, most] = ITERATIONS;
    format!(
        "absolute residual {tolerance:.0e}, relative none; ρ adapted every {INTERVAL} iterations, so that no clock decides; polished \
         with {REFINEMENTS} refinements; {least} to {most} iterations, by a budget of {} million multiplications",
        MULTIPLICATIONS / 1_000_000,
    )
}

/// Settings chosen for accuracy and for the same bits on every run.
fn settings(tolerance: f64, entries: usize) -> Settings {
    let iterations = (MULTIPLICATIONS / entries.max(1)).clamp(ITERATIONS[0], ITERATIONS[1]);
    Settings::default()
        .verbose(false)
        .eps_abs(tolerance)
        .eps_rel(0.0)
        .max_iter(u32::try_from(iterations).unwrap_or(u32::MAX))
        .adaptive_rho(true)
        .adaptive_rho_interval(Some(INTERVAL))
        .check_termination(Some(INTERVAL))
        .polish(true)
        .polish_refine_iter(REFINEMENTS)
}

/// Solves with osqp.
pub(super) fn solve(qp: &dyn Qp, tolerance: f64) -> Answer {
    let form = match sparse_form(qp) {
        Ok(form) => form,
        // The library accepts NaN without an error and calls x = 0 solved.
        Err(message) => return Answer::refused(qp.dimension(), message),
    };
    let (n, m, r) = (qp.dimension(), form.linear.len(), form.right.len());
    let (starts, rows, values) = form.constraints(1.0);
    // Factors of these matrices have up to about four times as many entries.
    let entries = 4 * (values.len() + form.quadratic.values.len());
    let constraints =
        CscMatrix { nrows: r + n, ncols: m, indptr: starts.into(), indices: rows.into(), data: values.into() };
    let UpperColumns { starts, rows, values } = form.quadratic.clone();
    let quadratic = CscMatrix { nrows: m, ncols: m, indptr: starts.into(), indices: rows.into(), data: values.into() };
    let (mut lower, mut upper) = (form.right.clone(), form.right.clone());
    lower.extend(vec![0.0; n]);
    upper.extend(vec![INFINITY; n]);
    let problem = Problem::new(quadratic, &form.linear, constraints, &lower, &upper, &settings(tolerance, entries));
    let mut problem = match problem {
        Ok(problem) => problem,
        Err(error) => return Answer::refused(n, error.to_string()),
    };
    let status = problem.solve();
    let iterations = status.iter() as usize;
    let (message, solution) = match &status {
        Status::Solved(solution) => ("Solved", Some(solution)),
        Status::SolvedInaccurate(solution) => ("SolvedInaccurate", Some(solution)),
        Status::MaxIterationsReached(solution) => ("MaxIterationsReached", Some(solution)),
        Status::TimeLimitReached(solution) => ("TimeLimitReached", Some(solution)),
        Status::PrimalInfeasible(_) => ("PrimalInfeasible", None),
        Status::PrimalInfeasibleInaccurate(_) => ("PrimalInfeasibleInaccurate", None),
        Status::DualInfeasible(_) => ("DualInfeasible", None),
        Status::DualInfeasibleInaccurate(_) => ("DualInfeasibleInaccurate", None),
        Status::NonConvex(_) => ("NonConvex", None),
        _ => ("a status that is not documented", None),
    };
    let run = Run {
        reports_success: matches!(status, Status::Solved(_)),
        reports_almost: matches!(status, Status::SolvedInaccurate(_)),
        message: message.to_owned(),
        own_residual: solution.map(|s| OwnResidual::of_osqp(&form, s.x(), s.y(), tolerance)),
        iterations,
        work: iterations * n,
    };
    let Some(solution) = solution else { return Answer::without_numbers(n, run) };
    Answer {
        x: solution.x()[form.signed..].iter().map(|y| y * form.sizes.x).collect(),
        gradient: solution.y()[r..].iter().map(|y| -y * form.sizes.gradient).collect(),
        run,
    }
}
