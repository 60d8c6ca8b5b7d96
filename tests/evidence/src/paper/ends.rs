//! Built-in and free ends, which what is left of the paper does not speak of: the three methods on them.

use palkki::methods::Method;
use palkki::scene::{Foundation, SceneError, Support};
use palkki::solvers::Solver;
use palkki::{Settings, solve_raw, theory};

use super::claims::curved::scene_on;
use super::{DEPTH, LENGTH, UNIFORM};

/// Scenes with built-in and free ends by the three methods, beside the exact solution.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ends {
    /// How many scenes.
    pub scenes: usize,
    /// Answers that solve their discrete problem.
    pub solved: usize,
    /// Largest error of the energy, over the exact one.
    pub energy: f64,
    /// Largest error of the contact force, over the load.
    pub contact_force: f64,
}

/// Intervals on which they are solved.
pub const FINE: usize = 300;

/// Solves the example with its ends built in, one of them built in and the other simple or free, with both free beyond two
/// supports, and with both free over a ridge without supports.
///
/// # Errors
///
/// None; the type is that of [`solve_raw`].
pub fn other_ends() -> Result<Ends, SceneError> {
    let flat = || Foundation::Flat { depth: DEPTH };
    let ridge = Foundation::Polyline { points: vec![[0.0, DEPTH], [4.0, 0.5 * DEPTH], [LENGTH, DEPTH]] };
    let scenes = [
        (vec![Support::built_in(0.0), Support::built_in(LENGTH)], flat()),
        (vec![Support::built_in(0.0), Support::simple(LENGTH)], flat()),
        (vec![Support::built_in(0.0)], flat()),
        (vec![Support::simple(0.2 * LENGTH), Support::simple(0.8 * LENGTH)], flat()),
        (vec![], ridge),
    ];
    let mut ends = Ends { scenes: scenes.len(), solved: 0, energy: 0.0, contact_force: 0.0 };
    for (supports, foundation) in scenes {
        let scene = scene_on(supports, None, foundation)?;
        // Without an exact solution nothing is known of the error.
        let exact = theory::solve(&scene).ok().filter(|exact| exact.solved);
        let [energy, contact_force] =
            exact.map_or([f64::INFINITY; 2], |exact| [exact.state.energy, exact.state.contact_force()]);
        for method in Method::ALL {
            let answer = solve_raw(&scene, &Settings::new(method, Solver::ActiveSet, FINE))?;
            ends.solved += usize::from(answer.solved);
            ends.energy = ends.energy.max(if energy.is_finite() {
                (answer.state.energy - energy).abs() / energy.abs()
            } else {
                energy
            });
            let error = (answer.state.contact_force() - contact_force).abs() / (UNIFORM * LENGTH);
            ends.contact_force = ends.contact_force.max(error);
        }
    }
    Ok(ends)
}
