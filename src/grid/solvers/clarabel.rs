//! The interior-point library `clarabel` (Goulart and Chen 2024): only translation to its form and back.
//!
//! ```text
//! minimise ½ zᵀ P z + cᵀ z   subject to   E z + 0 = e,   −z_k + s_k = 0, s ≥ 0 for the variables with a sign
//! ```
//!
//! in the [sparse form](crate::qp::SparseForm) of a program, or the form of its matrix if it has no other. The multipliers of the
//! sign constraints are the gradient.

use ::clarabel::algebra::CscMatrix;
use ::clarabel::solver::{DefaultSettings, DefaultSolver, IPSolver, NonnegativeConeT, SolverStatus, ZeroConeT};

use super::{Answer, OwnResidual, Run, sparse_form};
use crate::qp::{Qp, UpperColumns};

/// The library adds this to the diagonal before it factorises, and compensates for it by refinement.
const REGULARISATION: f64 = 1e-10;

/// The tolerance of the library.
///
/// The residual min(x, g) of a pair is bounded by the square root of its product, and the gap is a sum of such products. So the gap
/// must fall below the tolerance of the residual. 1e-15 is the smallest value that the library reaches reliably.
pub(super) fn own_tolerance(asked: f64) -> f64 {
    (1e-5 * asked).max(1e-15)
}

/// Settings chosen for accuracy.
fn settings(tolerance: f64) -> DefaultSettings<f64> {
    let tolerance = own_tolerance(tolerance);
    DefaultSettings {
        verbose: false,
        max_iter: 200,
        tol_gap_abs: tolerance,
        tol_gap_rel: tolerance,
        tol_feas: tolerance,
        // "AlmostSolved" must not mean less than "Solved" with the defaults of the library.
        reduced_tol_gap_abs: 1e-8,
        reduced_tol_gap_rel: 1e-8,
        reduced_tol_feas: 1e-8,
        // The program is dimensionless already, and equilibration would change the meaning of the tolerances.
        equilibrate_enable: false,
        // With the default of 1e-8 the equations of 3000 intervals and more are too soft. With 1e-12 those of 30 000 are too hard for
        // a factorisation without pivoting.
        static_regularization_constant: REGULARISATION,
        // One thread and one factorisation, so that every run gives the same bits.
        max_threads: 1,
        direct_solve_method: "qdldl".to_owned(),
        ..DefaultSettings::default()
    }
}

/// The settings as text.
pub(super) fn settings_text(tolerance: f64) -> String {
    let set = settings(tolerance);
    format!(
        "gap and feasibility {:.0e}, at most {} iterations, one thread, regularisation {REGULARISATION:.0e}, no equilibration: the quadratic program is dimensionless already",
        set.tol_gap_abs, set.max_iter,
    )
}

/// Solves with clarabel.
pub(super) fn solve(qp: &dyn Qp, tolerance: f64) -> Answer {
    let form = match sparse_form(qp) {
        Ok(form) => form,
        Err(message) => return Answer::refused(qp.dimension(), message),
    };
    let (n, m, r) = (qp.dimension(), form.linear.len(), form.right.len());
    let (starts, rows, values) = form.constraints(-1.0);
    let constraints = CscMatrix::new(r + n, m, starts, rows, values);
    let UpperColumns { starts, rows, values } = form.quadratic.clone();
    let quadratic = CscMatrix::new(m, m, starts, rows, values);
    let right: Vec<f64> = form.right.iter().copied().chain(std::iter::repeat_n(0.0, n)).collect();
    let cones = [ZeroConeT(r), NonnegativeConeT(n)];
    let settings = settings(tolerance);
    let asked = settings.tol_feas;
    let mut solver = match DefaultSolver::new(&quadratic, &form.linear, &constraints, &right, &cones, settings) {
        Ok(solver) => solver,
        Err(error) => return Answer::refused(n, error.to_string()),
    };
    solver.solve();
    let solution = &solver.solution;
    Answer {
        x: solution.x[form.signed..].iter().map(|y| y * form.sizes.x).collect(),
        gradient: solution.z[r..].iter().map(|z| z * form.sizes.gradient).collect(),
        run: Run {
            reports_success: reports_success(solution.status),
            reports_almost: matches!(solution.status, SolverStatus::AlmostSolved),
            message: format!("{:?}", solution.status),
            own_residual: Some(OwnResidual::of_clarabel(&form, [&solution.x, &solution.z, &solution.s], asked)),
            iterations: solution.iterations as usize,
            work: solution.iterations as usize * n,
        },
    }
}

/// Whether a status means an optimum to the given tolerance; an almost solved status does not. The answer is checked whatever the
/// status is.
fn reports_success(status: SolverStatus) -> bool {
    match status {
        SolverStatus::Solved => true,
        SolverStatus::AlmostSolved
        | SolverStatus::Unsolved
        | SolverStatus::PrimalInfeasible
        | SolverStatus::DualInfeasible
        | SolverStatus::AlmostPrimalInfeasible
        | SolverStatus::AlmostDualInfeasible
        | SolverStatus::MaxIterations
        | SolverStatus::MaxTime
        | SolverStatus::NumericalError
        | SolverStatus::InsufficientProgress
        | SolverStatus::CallbackTerminated => false,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_word_of_twelve_claims_success() {
        // In the order of their numbers. The match above has no wildcard, so a new status does not compile unnoticed.
        let claims = [
            (SolverStatus::Unsolved, false),
            (SolverStatus::Solved, true),
            (SolverStatus::PrimalInfeasible, false),
            (SolverStatus::DualInfeasible, false),
            (SolverStatus::AlmostSolved, false),
            (SolverStatus::AlmostPrimalInfeasible, false),
            (SolverStatus::AlmostDualInfeasible, false),
            (SolverStatus::MaxIterations, false),
            (SolverStatus::MaxTime, false),
            (SolverStatus::NumericalError, false),
            (SolverStatus::InsufficientProgress, false),
            (SolverStatus::CallbackTerminated, false),
        ];
        for (number, (status, claimed)) in claims.into_iter().enumerate() {
            assert_eq!(status as usize, number, "the statuses of the library in their order");
            assert_eq!(reports_success(status), claimed, "{status:?}");
        }
    }
}
