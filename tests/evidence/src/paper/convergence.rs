//! How the methods converge, with the observed order: on the example to its closed form, on any scene to its exact solution.
//!
//! The exact solution and a discrete one have nothing in common but the scene: one has a list of contacts and no grid, the
//! other a grid and no list. That the second comes ever closer to the first confirms both.

use palkki::adaptive::observed_order;
use palkki::methods::Method;
use palkki::scene::{Scene, SceneError};
use palkki::solvers::Solver;
use palkki::state::ContactState;
use palkki::theory::Exact;
use palkki::{Settings, solve_raw};

use super::{example, theory};

/// What converges. Nodal contact pressures do not: see [`super::claims`].
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Quantity {
    /// Reaction of the left support.
    EndReaction,
    /// Energy `J`.
    Energy,
    /// The largest deflection, on a grid that of a node.
    LargestDeflection,
    /// Of the example: the first node in contact, which stands for the lift-off point. No grid resolves it better than its
    /// spacing.
    LiftOff,
    /// Of the example: deflection at an eighth of the span, half-way to the lift-off point.
    Deflection,
    /// Of the example: resultant of the contact forces on one half of the beam minus `q₀ (l/2 − a)`. This is the point force
    /// at lift-off, which neighbouring nodes share.
    PointForce,
}

impl Quantity {
    /// Those that any scene has.
    pub const OF_ANY_SCENE: [Self; 3] = [Self::EndReaction, Self::Energy, Self::LargestDeflection];

    /// Those that are compared on the example.
    pub const OF_THE_EXAMPLE: [Self; 5] =
        [Self::EndReaction, Self::LiftOff, Self::Energy, Self::Deflection, Self::PointForce];

    /// Its name in tables.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::EndReaction => "end reaction",
            Self::Energy => "energy",
            Self::LargestDeflection => "largest deflection",
            Self::LiftOff => "lift-off point",
            Self::Deflection => "deflection at l/8",
            Self::PointForce => "point force at lift-off",
        }
    }

    /// Its value in a state; the last three mean something in a discrete state of the example only, and are NaN without nodes.
    #[must_use]
    pub fn of(self, state: &ContactState) -> f64 {
        let nodes = state.nodes.as_ref();
        match self {
            Self::EndReaction => state.reactions.left,
            Self::Energy => state.energy,
            Self::LargestDeflection => state.deflection.max,
            Self::LiftOff => state.contacts.first().map_or(f64::NAN, |c| c.from),
            Self::Deflection => {
                let at = |deflection: &Vec<f64>| deflection.get(((deflection.len() + 1) / 8).checked_sub(1)?).copied();
                nodes.and_then(|nodes| at(&nodes.deflection)).unwrap_or(f64::NAN)
            }
            Self::PointForce => nodes.map_or(f64::NAN, |nodes| {
                // Half the contact, by symmetry, against what the pressure of beam theory carries.
                let exact = theory();
                0.5 * (nodes.contact_force.iter().sum::<f64>() - exact.contact_force) + exact.end_force
            }),
        }
    }

    /// Its value in the example by beam theory.
    #[must_use]
    pub fn exact(self) -> f64 {
        let exact = theory();
        match self {
            Self::EndReaction => exact.reaction,
            Self::Energy => exact.energy,
            Self::LargestDeflection => exact.deflection(5.0),
            Self::LiftOff => exact.lift_off.unwrap_or(f64::NAN),
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

/// Errors of every quantity on the example, on grids of `intervals`, each a multiple of 8.
///
/// # Errors
///
/// None for the example on such grids; the type is that of [`solve_raw`].
pub fn of_the_example(method: Method, intervals: &[usize]) -> Result<Vec<Series>, SceneError> {
    let quantities = Quantity::OF_THE_EXAMPLE.map(|quantity| (quantity, quantity.exact()));
    errors(&example()?, &quantities, method, intervals)
}

/// Errors of every quantity against `exact`, the exact solution of `scene`, on grids of `intervals` by the active set.
///
/// # Errors
///
/// Those of [`solve_raw`].
pub fn of_scene(scene: &Scene, exact: &Exact, method: Method, intervals: &[usize]) -> Result<Vec<Series>, SceneError> {
    let quantities = Quantity::OF_ANY_SCENE.map(|quantity| (quantity, quantity.of(&exact.state)));
    errors(scene, &quantities, method, intervals)
}

fn errors(
    scene: &Scene,
    quantities: &[(Quantity, f64)],
    method: Method,
    intervals: &[usize],
) -> Result<Vec<Series>, SceneError> {
    let state = |&n: &usize| Ok((n, solve_raw(scene, &Settings::new(method, Solver::ActiveSet, n))?.state));
    let states = intervals.iter().map(state).collect::<Result<Vec<_>, SceneError>>()?;
    let of = |&(quantity, exact): &(Quantity, f64)| {
        let error = |state: &ContactState| (quantity.of(state) - exact).abs() / exact.abs();
        let errors: Vec<(usize, f64)> = states.iter().map(|(n, state)| (*n, error(state))).collect();
        #[expect(clippy::cast_precision_loss, reason = "grids stay far below 2⁵³ intervals")]
        let pairs: Vec<(f64, f64)> = errors.iter().map(|&(n, error)| (1.0 / n as f64, error)).collect();
        Series { method, quantity, order: observed_order(&pairs), errors }
    };
    Ok(quantities.iter().map(of).collect())
}
