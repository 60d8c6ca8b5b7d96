//! Scenes at the extremes of sizes, units and regimes, each with an authority that knows the answer without a solver.
//!
//! Closed forms, statics, and the rule by which quantities scale with
//! their units are the authorities. Test suite and report judge every route by them.
//!
//! [`survey()`] is the exception: ground of up to millions of points, on which routes are judged by each other.

mod borders;
mod sizes;
mod supports;
mod surveys;
mod units;

pub use borders::borders;
pub use sizes::{INTERVALS, POWERS, deep, sizes};
pub use supports::supports;
pub use surveys::{Ground, survey, survey_from};
pub use units::units;

use palkki::scene::{Scene, SceneError};
use palkki::state::ContactState;

use crate::closed::FlatSolution;
use crate::compare::largest;
use crate::draft::{Draft, Units};

/// A scene at an extreme.
#[derive(Debug, Clone)]
pub struct Extreme {
    /// What is extreme about it.
    pub name: String,
    /// Who knows the answer.
    pub authority: &'static str,
    /// The scene.
    pub scene: Scene,
    /// The answer.
    pub known: Known,
    /// Equal intervals for discretised methods.
    pub intervals: usize,
}

impl Extreme {
    /// The load of this many intervals lies between a discrete answer and the continuous beam: half an interval of load at
    /// each end of a contact, which the next node takes, and as much again for a force that acts beside a node.
    const INTERVALS_OFF: f64 = 2.0;

    /// The force by which errors of forces are measured: all loads, whichever way they act \[force\].
    #[must_use]
    pub fn load(&self) -> f64 {
        let load = self.scene.load().magnitude(self.scene.beam().length());
        if 0.0 < load { load } else { 1.0 }
    }

    /// How far reactions and contact force of a state are from the truth, over the load; infinite if one is NaN.
    #[must_use]
    pub fn error(&self, state: &ContactState) -> f64 {
        let known = self.known;
        let pairs = [
            (state.reactions.left, known.reactions[0]),
            (state.reactions.right, known.reactions[1]),
            (state.contact_force(), known.contact_force),
        ];
        largest(pairs.iter().map(|(found, expected)| (found - expected) / self.load()))
    }

    /// The error of the energy, over the energy, where it is known; where it is zero, over `P² l³/EI`, what the load would do
    /// to a free beam.
    #[must_use]
    pub fn energy_error(&self, energy: f64) -> f64 {
        let beam = self.scene.beam();
        let (l, load) = (beam.length(), self.load());
        let Some(truth) = self.known.energy else { return 0.0 };
        let size = if truth == 0.0 { load * load * l * l * l / beam.bending_stiffness() } else { truth.abs() };
        (energy - truth).abs() / size
    }

    /// How far a discretised answer may be from the truth, as [`Extreme::error`] measures it.
    #[must_use]
    #[expect(clippy::cast_precision_loss, reason = "grids stay far below 2⁵³ intervals")]
    pub fn allowance(&self) -> f64 {
        Self::INTERVALS_OFF / self.intervals as f64
    }
}

/// What an authority knows of the answer.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Known {
    /// Upward forces of the supports \[force\].
    pub reactions: [f64; 2],
    /// Resultant of all contacts, upwards \[force\].
    pub contact_force: f64,
    /// `J(v)` of (17) \[force · length\], where it is known.
    pub energy: Option<f64>,
}

impl Known {
    /// An answer that is the same seen from both sides.
    fn symmetric(reaction: f64, contact_force: f64, energy: f64) -> Self {
        Self { reactions: [reaction; 2], contact_force, energy: Some(energy) }
    }
}

impl From<FlatSolution> for Known {
    fn from(flat: FlatSolution) -> Self {
        Self::symmetric(flat.reaction, flat.contact_force, flat.energy)
    }
}

/// The grid of the paper.
const THIRTY: usize = 30;

fn extreme(
    name: impl Into<String>,
    authority: &'static str,
    draft: &Draft,
    known: Known,
) -> Result<Extreme, SceneError> {
    Ok(Extreme { name: name.into(), authority, scene: draft.scene()?, known, intervals: THIRTY })
}

/// The same in other units.
fn in_units(
    name: impl Into<String>,
    authority: &'static str,
    draft: &Draft,
    known: Known,
    units: Units,
) -> Result<Extreme, SceneError> {
    let Units { length, depth, force } = units;
    // The ratio first, which stays in range at the ends of it.
    let stiffness = draft.stiffness * (length / depth) * force * length * length;
    let known = Known {
        reactions: known.reactions.map(|r| r * force),
        contact_force: known.contact_force * force,
        energy: known.energy.map(|j| j * force * depth),
    };
    extreme(name, authority, &Draft { stiffness, ..draft.in_units(units) }, known)
}

/// Coefficients of Chebyshev's polynomial `T_d(2x − 1)` in powers of `x`: whole numbers, below `2⁵³` up to degree 20.
pub fn chebyshev(degree: usize) -> Vec<f64> {
    let (mut last, mut this) = (vec![1.0], vec![-1.0, 2.0]);
    if degree == 0 {
        return last;
    }
    for _ in 1..degree {
        // T_{d+1} = 2 (2x − 1) T_d − T_{d−1}.
        let mut next = vec![0.0; this.len() + 1];
        for (j, c) in this.iter().enumerate() {
            next[j] -= 2.0 * c;
            next[j + 1] += 4.0 * c;
        }
        next.iter_mut().zip(&last).for_each(|(next, last)| *next -= last);
        (last, this) = (this, next);
    }
    this
}
