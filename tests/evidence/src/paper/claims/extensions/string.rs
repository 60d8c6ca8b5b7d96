//! Extension (a): any elastic body whose stiffness matrix can be computed. Here a taut string, which is no beam.

use nalgebra::{DMatrix, DVector};

use crate::paper::claims::{Claim, Verdict, words::bound};
use palkki::problem::{Dense, Sizes, residual};
use palkki::solvers::Solver;

/// A taut string of span 10 under tension 10 and a unit load, above a flat foundation at depth 1: touched or not, the
/// quadratic program (32) with another `K`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Taut {
    /// Scaled residual of the optimality conditions.
    pub residual: f64,
    /// End reaction over that of the closed form `√(2 S q u₀)`, minus one, on 200 intervals.
    pub end_reaction: f64,
}

/// Solves the string with the active set.
///
/// Closed form: `S v'' = −q` up to the lift-off point `b`, where `v = u₀`, `v' = 0`: `b² = 2 S u₀/q`, reaction `q b`.
#[must_use]
#[expect(clippy::cast_precision_loss, reason = "200 intervals")]
pub fn any_body() -> Taut {
    const INTERVALS: usize = 200;
    let (length, tension, load, depth) = (10.0, 10.0, 1.0, 1.0_f64);
    let n = INTERVALS - 1;
    let spacing = length / INTERVALS as f64;
    let stiffness = DMatrix::from_fn(n, n, |i, j| match i.abs_diff(j) {
        0 => 2.0 * tension / spacing,
        1 => -tension / spacing,
        _ => 0.0,
    });
    let depths = DVector::from_element(n, depth);
    let loads = DVector::from_element(n, load * spacing);
    let linear = &stiffness * &depths - &loads;
    let programme = Dense { matrix: stiffness, linear, sizes: Sizes { x: depth, gradient: load * length } };
    let answer = Solver::ActiveSet.run(&programme, 0.0);
    let first = depth - answer.x[0];
    let reaction = tension * first / spacing + 0.5 * load * spacing;
    Taut {
        residual: residual(programme.sizes, &answer.x, &answer.gradient),
        end_reaction: reaction / (2.0 * tension * load * depth).sqrt() - 1.0,
    }
}

impl Taut {
    /// Whether the method works as it is: optimal, and within one per cent of the closed form.
    #[must_use]
    pub fn verdict(&self) -> Verdict {
        if self.residual <= 1e-9 && self.end_reaction.abs() <= 0.01 { Verdict::Confirmed } else { Verdict::Refuted }
    }

    pub(in crate::paper::claims) fn claim(&self) -> Claim {
        Claim {
            name: "any_elastic_body",
            statement: "The methods extend to any elastic body whose stiffness or flexibility matrix can be computed.",
            verdict: self.verdict(),
            reading: None,
            summary: format!("a taut string: end reaction within {} of its closed form", bound(self.end_reaction)),
            evidence: format!(
                "The solvers take any symmetric positive definite matrix. Tried on a body that is not a beam, a taut string on 200 \
                 intervals: scaled residual below {}, end reaction within {} of its closed form √(2 S q u₀).",
                bound(self.residual.max(f64::EPSILON)),
                bound(self.end_reaction)
            ),
        }
    }
}
