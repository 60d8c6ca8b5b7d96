//! How the methods converge to beam theory on the example, with the observed order.

use super::{example, theory};
use palkki::dial::observed_order;
use palkki::methods::Method;
use palkki::scene::SceneError;
use palkki::solvers::Solver;
use palkki::state::ContactState;
use palkki::{Settings, solve};

/// What converges. Nodal contact pressures do not: see [`super::claims`].
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Quantity {
    /// Reaction of the left support.
    EndReaction,
    /// The first node in contact, which stands for the lift-off point: no grid resolves it better than its spacing.
    LiftOff,
    /// Energy `J`.
    Energy,
    /// Deflection at an eighth of the span, half-way to the lift-off point.
    Deflection,
    /// Resultant of the contact forces on one half of the beam minus `q₀ (l/2 − a)`: the point force at lift-off, which
    /// neighbouring nodes share.
    PointForce,
}

impl Quantity {
    /// All of them.
    pub const ALL: [Self; 5] = [Self::EndReaction, Self::LiftOff, Self::Energy, Self::Deflection, Self::PointForce];

    /// Its name in tables.
    #[must_use]
    pub fn word(self) -> &'static str {
        match self {
            Self::EndReaction => "end reaction",
            Self::LiftOff => "lift-off point",
            Self::Energy => "energy",
            Self::Deflection => "deflection at l/8",
            Self::PointForce => "point force at lift-off",
        }
    }

    /// Its value in a discrete state of the example.
    #[must_use]
    pub fn discrete(self, state: &ContactState) -> f64 {
        let Some(nodes) = &state.nodes else { return f64::NAN };
        match self {
            Self::EndReaction => state.reactions.left,
            Self::LiftOff => state.contacts.first().map_or(f64::NAN, |c| c.from),
            Self::Energy => state.energy,
            Self::Deflection => {
                let node = ((nodes.x.len() + 1) / 8).checked_sub(1);
                node.and_then(|k| nodes.deflection.get(k)).copied().unwrap_or(f64::NAN)
            }
            Self::PointForce => {
                // Half the contact, by symmetry, against what the pressure of beam theory carries.
                let exact = theory();
                0.5 * (nodes.contact_force.iter().sum::<f64>() - exact.contact_force) + exact.end_force
            }
        }
    }

    /// Its value by beam theory.
    #[must_use]
    pub fn exact(self) -> f64 {
        let exact = theory();
        match self {
            Self::EndReaction => exact.reaction,
            Self::LiftOff => exact.lift_off.unwrap_or(f64::NAN),
            Self::Energy => exact.energy,
            Self::Deflection => exact.deflection(1.25),
            Self::PointForce => exact.end_force,
        }
    }
}

/// Errors of one quantity by one method on several grids.
#[derive(Debug, Clone, PartialEq)]
pub struct Series {
    /// Which method.
    pub method: Method,
    /// Which quantity.
    pub quantity: Quantity,
    /// Number of intervals and relative error.
    pub errors: Vec<(usize, f64)>,
    /// Slope of the errors over the spacing.
    pub order: f64,
}

/// Errors of every quantity on grids of `intervals`, each a multiple of 8.
///
/// # Errors
///
/// None for the example on such grids; the type is that of [`solve`].
pub fn all(method: Method, intervals: &[usize]) -> Result<Vec<Series>, SceneError> {
    let states = intervals.iter().map(|&n| Ok((n, state(method, n)?))).collect::<Result<Vec<_>, SceneError>>()?;
    Ok(Quantity::ALL.into_iter().map(|quantity| of(method, quantity, &states)).collect())
}

/// Errors of one quantity on grids of `intervals`, each a multiple of 8.
///
/// # Errors
///
/// As [`all`].
pub fn series(method: Method, quantity: Quantity, intervals: &[usize]) -> Result<Series, SceneError> {
    let states = intervals.iter().map(|&n| Ok((n, state(method, n)?))).collect::<Result<Vec<_>, SceneError>>()?;
    Ok(of(method, quantity, &states))
}

fn state(method: Method, intervals: usize) -> Result<ContactState, SceneError> {
    Ok(solve(&example()?, &Settings::new(method, Solver::ActiveSet, intervals))?.state)
}

#[expect(clippy::cast_precision_loss, reason = "grids stay far below 2⁵³ intervals")]
fn of(method: Method, quantity: Quantity, states: &[(usize, ContactState)]) -> Series {
    let exact = quantity.exact();
    let errors: Vec<(usize, f64)> =
        states.iter().map(|(n, state)| (*n, (quantity.discrete(state) - exact).abs() / exact.abs())).collect();
    let pairs: Vec<(f64, f64)> = errors.iter().map(|&(n, e)| (1.0 / n as f64, e)).collect();
    Series { method, quantity, order: observed_order(&pairs), errors }
}
