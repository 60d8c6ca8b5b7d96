//! The entry point: from a scene in its own units to its exact solution.

use super::breakpoints::MOST_CELLS;
use super::exact::Exact;
use super::giving;
use super::neutral;
use super::piecewise::PiecewiseScene;
use super::room::{self, MEMORY};
use super::search::search;
use super::springs;
use crate::scene::axial::LONGEST;
use crate::scene::{Balance, Foundation, Profile, Scene, SceneError};

/// The reasons why there is no exact solution at all. An answer that fails its check is an [`Exact`] that is not `solved`.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum TheoryError {
    /// The scene leaves the range of `f64` when it is made dimensionless.
    #[error(transparent)]
    Scene(#[from] SceneError),
    /// The profile has so many waves that its pieces cannot be listed.
    #[error("`{}.cosine.wavelength` must be at least {least} for an exact solution, but is {wavelength}", of.path())]
    TooManyPieces {
        /// The profile.
        of: Profile,
        /// The wavelength \[length\].
        wavelength: f64,
        /// The least possible wavelength \[length\].
        least: f64,
    },
    /// The phase of a wave is so large that its rounding moves the wave.
    #[error("`{}.cosine.phase` must be at most {most} in magnitude for an exact solution, but is {phase}", of.path())]
    PhaseTooLarge {
        /// The profile.
        of: Profile,
        /// The phase \[rad\].
        phase: f64,
        /// The largest possible phase \[rad\].
        most: f64,
    },
    /// The beam is so close to a cable that its pieces cannot be listed.
    #[error("`beam.tension` must be at most {most} in magnitude for an exact solution, but is {tension}")]
    TooManyParts {
        /// The axial force \[force\].
        tension: f64,
        /// The largest possible magnitude \[force\].
        most: f64,
    },
    /// There is not enough memory for all points of a profile and all positions at which the beam is close to them.
    #[error(
        "there is no memory for {points} points of a profile and {near} places near contact, which take {needed} MB, of at most {most} MB",
        needed = bytes / 1_000_000,
        most = MEMORY / 1_000_000
    )]
    NoMemory {
        /// Number of points of the profile.
        points: usize,
        /// Number of contacts, or of positions near contact.
        near: usize,
        /// Memory that they need.
        bytes: usize,
    },
}

/// Largest phase of a wave \[rad\]: half a unit in its last place is a tenth of the tolerance of a condition.
const MOST_PHASE: f64 = 1000.0;

/// The exact solution of `scene`.
///
/// The list without contacts is tried first; on a long profile it is tried last.
///
/// # Errors
///
/// [`TheoryError`] if the numbers do not allow a solution. An answer that fails its check is not an error: it is not `solved` and lists
/// its violations.
pub fn solve(scene: &Scene) -> Result<Exact, TheoryError> {
    solve_near(scene, &[])
}

/// The exact solution of a scene that differs from the scenes of `near` only in numbers. It is the solution that [`solve`] finds, but
/// found sooner, because the search starts from the contacts of `near`, in turn.
///
/// # Errors
///
/// The errors of [`solve`].
pub fn solve_near(scene: &Scene, near: &[&Exact]) -> Result<Exact, TheoryError> {
    let scaled = scene.scaled()?;
    let foundation = scaled.scene.foundation();
    let own = scaled.scene.beam().shape().filter(|_| foundation.is_some());
    for (of, profile) in [(Profile::Foundation, foundation), (Profile::Shape, own)] {
        match profile {
            Some(&Foundation::Cosine { wavelength, phase, .. }) => {
                if MOST_PHASE < phase.abs() {
                    return Err(TheoryError::PhaseTooLarge { of, phase, most: MOST_PHASE });
                }
                // One cell is about an eighth of a wave.
                let least = 8.0 * scaled.scene.beam().length() / MOST_CELLS;
                if wavelength < least {
                    let unit = scaled.scale.length;
                    return Err(TheoryError::TooManyPieces { of, wavelength: wavelength * unit, least: least * unit });
                }
            }
            Some(Foundation::Polyline { points }) => {
                room::for_points(points.len())?;
            }
            _ => {}
        }
    }
    let (stiffness, tension) = (scaled.scene.beam().bending_stiffness(), scaled.scene.beam().tension());
    let parts = MOST_CELLS * LONGEST / scaled.scene.beam().length();
    let most = stiffness * parts * parts;
    if most < tension.abs() {
        let unit = scene.beam().tension() / tension;
        return Err(TheoryError::TooManyParts { tension: tension * unit, most: most * unit.abs() });
    }
    if let Some(ground) = scaled.scene.ground_stiffness() {
        return Ok(springs::exact(&scaled, PiecewiseScene::new(&scaled.scene), ground, near)?);
    }
    let near: Vec<&Exact> = near.iter().copied().filter(|near| near.solved).collect();
    let mut slopes = None;
    let (given, found) = giving::search_with(&scaled.scene, near.first().map(|near| near.acting()), |given, list| {
        let neutral = match scaled.balance {
            Balance::Neutral { about, .. } => neutral::balanced(given, about),
            _ => None,
        };
        if let Some((found, turns)) = neutral {
            slopes = turns;
            return Ok(found);
        }
        slopes = None;
        let near = near.iter().filter_map(|near| near.list_in(given, &scaled.scale));
        search(given, list.cloned().into_iter().chain(near))
    })?;
    let exact = Exact::new(given, found, scaled.units_over_stiffness());
    Ok(exact.balanced(scaled.balance.in_units_of(&scaled.scale), slopes))
}
