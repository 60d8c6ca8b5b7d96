//! "The reaction became approximately 1,14 (n = 29), beam theory gives 1,18."

use super::{Claim, Verdict};
use crate::paper::{INTERVALS, PRINTED_FORCE, PRINTED_REACTION, example, theory};
use palkki::methods::Method;
use palkki::scene::SceneError;
use palkki::solvers::Solver;
use palkki::{Settings, solve};

/// The two printed numbers, computed again.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Evidence {
    /// `T` by beam theory.
    pub reaction_by_theory: f64,
    /// Contact force at the first node in contact, force method, 30 intervals.
    pub first_force: f64,
    /// Where that node is.
    pub first_place: f64,
    /// Reaction of the left support on the same grid, with the load of half an interval on the support.
    pub end_reaction: f64,
    /// The first contact force by finite differences.
    pub first_force_by_differences: f64,
}

/// Half a unit of the last printed digit.
const PRINTED: f64 = 0.005;

/// Measures on the example.
///
/// # Errors
///
/// None for the example; the type is that of [`solve`].
pub fn measure() -> Result<Evidence, SceneError> {
    let first = |method| -> Result<(f64, f64, f64), SceneError> {
        let state = solve(&example()?, &Settings::new(method, Solver::ActiveSet, INTERVALS))?.state;
        let nodes = state.nodes.unwrap_or_default();
        let index = nodes.contact_force.iter().position(|p| 0.0 < *p).unwrap_or(0);
        Ok((nodes.x[index], nodes.contact_force[index], state.reactions.left))
    };
    let (first_place, first_force, end_reaction) = first(Method::Force)?;
    let (_, first_force_by_differences, _) = first(Method::Complementarity)?;
    Ok(Evidence {
        reaction_by_theory: theory().reaction,
        first_force,
        first_place,
        end_reaction,
        first_force_by_differences,
    })
}

impl Evidence {
    /// Whether both numbers round to what is printed.
    #[must_use]
    pub fn verdict(&self) -> Verdict {
        let rounds = |value: f64, printed: f64| (value - printed).abs() <= PRINTED;
        if rounds(self.reaction_by_theory, PRINTED_REACTION) && rounds(self.first_force, PRINTED_FORCE) {
            Verdict::Confirmed
        } else {
            Verdict::Refuted
        }
    }

    pub(super) fn claim(&self) -> Claim {
        Claim {
            name: "printed_numbers",
            statement: "The reaction became 1.14 (n = 29); beam theory gives 1.18.",
            verdict: self.verdict(),
            reading: None,
            summary: format!("{:.5} and {:.5}", self.first_force, self.reaction_by_theory),
            evidence: format!(
                "Beam theory gives {:.5}. The force method on 30 intervals gives {:.5} as the contact force of its first node \
                 in contact, at x = {:.4}, which rounds to the printed number; the end reaction of the same grid, {:.5}, does \
                 not. Finite differences give {:.5} for the first contact force.",
                self.reaction_by_theory,
                self.first_force,
                self.first_place,
                self.end_reaction,
                self.first_force_by_differences,
            ),
        }
    }
}
