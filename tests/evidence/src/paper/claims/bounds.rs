//! "If in the force method there is no tension between the supports either, or in the displacement method the clearance is
//! positive between the supports too, the structural quantity stiffness D is bounded from above and from below."

use super::{Claim, Verdict, words::bound};
use crate::paper::{INTERVALS, PRINTED_USEFUL_INTERVALS, example, theory};
use palkki::certificate::{Judged, certify};
use palkki::methods::Method;
use palkki::scene::SceneError;
use palkki::solvers::Solver;
use palkki::state::Contact;
use palkki::{Settings, solve};

/// Energy and penetration on one grid of the example.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Grid {
    /// Number of intervals.
    pub intervals: usize,
    /// Energy of the displacement method over that of beam theory, minus one.
    pub energy: f64,
    /// Difference of the energies of the two methods, relative.
    pub difference: f64,
    /// Largest penetration between the nodes, over `u₀`.
    pub penetration: f64,
    /// Guaranteed bounds on the energy of the continuous beam from the contact forces of the force method, over the energy
    /// of beam theory: lower and upper, relative differences.
    pub bracket: [f64; 2],
}

/// What was measured.
#[derive(Debug, Clone, PartialEq)]
pub struct Evidence {
    /// Three grids.
    pub grids: Vec<Grid>,
}

/// Measures on the example, 20, 30 and 100 intervals.
///
/// # Errors
///
/// None for the example; the type is that of [`solve`].
pub fn measure() -> Result<Evidence, SceneError> {
    let scene = example()?;
    let exact = theory().energy;
    // The zone between the two lift-off points of the closed form.
    let length = scene.beam().length();
    let zone = theory().lift_off.map(|a| Contact { from: a, to: length - a, ..Contact::at(a, 0.0) });
    let mut grids = Vec::new();
    for intervals in [PRINTED_USEFUL_INTERVALS, INTERVALS, 100] {
        let state = |method| solve(&scene, &Settings::new(method, Solver::ActiveSet, intervals)).map(|o| o.state);
        let (displacement, force) = (state(Method::Displacement)?, state(Method::Force)?);
        let nodes = force.nodes.unwrap_or_default();
        let certificate = certify(&scene, Judged::Nodes(&nodes), zone.as_slice())?;
        let bracket = [certificate.energy_lower, certificate.energy_upper].map(|bound| (bound - exact) / exact.abs());
        grids.push(Grid {
            intervals,
            energy: displacement.energy / exact - 1.0,
            difference: (displacement.energy / force.energy - 1.0).abs(),
            // The foundation is flat at u₀ = 1, so that the largest deflection says how deep the beam goes.
            penetration: displacement.deflection.max - 1.0,
            bracket,
        });
    }
    Ok(Evidence { grids })
}

impl Evidence {
    /// The condition is essential: without it the two methods give one and the same number, which bounds nothing.
    #[must_use]
    pub fn verdict(&self) -> Verdict {
        let same = self.grids.iter().all(|g| g.difference < 1e-9);
        let penetrates = self.grids.iter().any(|g| 1e-9 < g.penetration);
        match (same, penetrates) {
            (true, true) => Verdict::Qualified,
            (false, false) => Verdict::Confirmed,
            _ => Verdict::Refuted,
        }
    }

    pub(super) fn claim(&self) -> Claim {
        let line = |g: &Grid| {
            format!("{:.3} % of u₀ and {:+.2} % on {} intervals", 100.0 * g.penetration, 100.0 * g.energy, g.intervals)
        };
        let between = |g: &Grid| g.bracket[0] <= 0.0 && 0.0 <= g.bracket[1];
        let holds = if self.grids.iter().all(between) { "contains" } else { "does not contain" };
        let width = self.grids.iter().map(|g| g.bracket[1] - g.bracket[0]).fold(0.0, f64::max);
        Claim {
            name: "bounded_from_both_sides",
            statement: "Without tension, or penetration, between the nodes, the stiffness D is bounded from both sides.",
            verdict: self.verdict(),
            reading: None,
            summary: format!(
                "not by nodes alone: between them the beam goes up to {:.2} % of u₀ below the ground on coarse grids; `palkki certify` \
                 computes such bounds",
                100.0 * self.grids.iter().map(|g| g.penetration).fold(0.0, f64::max),
            ),
            evidence: format!(
                "The condition is not met by the methods as they stand. They have constraints at the nodes only, and both then have \
                 the same energy (the two differ by less than {}), which is one number and no pair of bounds. Between the nodes the \
                 beam goes below the ground; the penetration and the difference of the energy from beam theory are {}. \
                 If the deflection is changed so that it stays above the ground between the nodes too, the claim can be carried out: \
                 `palkki certify` bounds the energy of the continuous beam from both sides, from the contact forces alone. On each of \
                 these grids the interval {holds} the energy of beam theory, and it is narrower than {} of that energy.",
                // Two sums that end in the same bits still say no more than that.
                bound(self.grids.iter().map(|g| g.difference).fold(f64::EPSILON, f64::max)),
                self.grids.iter().map(line).collect::<Vec<_>>().join("; "),
                bound(width),
            ),
        }
    }
}
