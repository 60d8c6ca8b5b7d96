//! How the discrete methods approach the exact solution of any scene, with the observed order.
//!
//! The exact solution and a discrete one have nothing in common but the scene: one has a list of contacts and no grid, the
//! other a grid and no list. That the second comes ever closer to the first confirms both.

use palkki::dial::observed_order;
use palkki::methods::Method;
use palkki::scene::{Scene, SceneError};
use palkki::solvers::Solver;
use palkki::state::ContactState;
use palkki::theory::Exact;
use palkki::{Settings, solve};

/// What is compared.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Quantity {
    /// Reaction of the left support.
    EndReaction,
    /// Energy `J`.
    Energy,
    /// The largest deflection, on a grid that of a node.
    LargestDeflection,
}

impl Quantity {
    /// All of them.
    pub const ALL: [Self; 3] = [Self::EndReaction, Self::Energy, Self::LargestDeflection];

    /// Its name.
    #[must_use]
    pub fn word(self) -> &'static str {
        match self {
            Self::EndReaction => "end reaction",
            Self::Energy => "energy",
            Self::LargestDeflection => "largest deflection",
        }
    }

    fn of(self, state: &ContactState) -> f64 {
        match self {
            Self::EndReaction => state.reactions.left,
            Self::Energy => state.energy,
            Self::LargestDeflection => state.deflection.max,
        }
    }
}

/// Errors of one quantity by one method on several grids.
#[derive(Debug, Clone, PartialEq)]
pub struct Approach {
    /// Which method.
    pub method: Method,
    /// Which quantity.
    pub quantity: Quantity,
    /// Number of intervals and relative error.
    pub errors: Vec<(usize, f64)>,
    /// Slope of the errors over the spacing.
    pub order: f64,
}

/// Errors of every quantity against `exact`, the exact solution of `scene`, on grids of `intervals` by the active set.
///
/// # Errors
///
/// Those of [`solve`].
pub fn approach(
    scene: &Scene,
    exact: &Exact,
    method: Method,
    intervals: &[usize],
) -> Result<Vec<Approach>, SceneError> {
    let state = |&n: &usize| Ok((n, solve(scene, &Settings::new(method, Solver::ActiveSet, n))?.state));
    let states = intervals.iter().map(state).collect::<Result<Vec<_>, SceneError>>()?;
    let of = |quantity: Quantity| {
        let right = quantity.of(&exact.state);
        let error = |found: f64| (found - right).abs() / right.abs();
        let errors: Vec<(usize, f64)> = states.iter().map(|(n, state)| (*n, error(quantity.of(state)))).collect();
        #[expect(clippy::cast_precision_loss, reason = "grids stay far below 2⁵³ intervals")]
        let pairs: Vec<(f64, f64)> = errors.iter().map(|&(n, error)| (1.0 / n as f64, error)).collect();
        Approach { method, quantity, order: observed_order(&pairs), errors }
    };
    Ok(Quantity::ALL.into_iter().map(of).collect())
}
