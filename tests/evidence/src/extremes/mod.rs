//! Scenes at the extremes of sizes, units and regimes, each with an authority that knows the answer without a solver.
//!
//! Closed forms of [`palkki::theory`] (the functions, not the search), statics, and the rule by which quantities scale with
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
pub use surveys::{Ground, survey};
pub use units::{Factors, units};

use palkki::scene::{Beam, Foundation, LinearLoad, Load, PointLoad, Scene, SceneError, Support};
use palkki::state::ContactState;
use palkki::theory::FlatSolution;

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
    pub truth: Truth,
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
        let truth = self.truth;
        let pairs = [
            (state.reactions.left, truth.reactions[0]),
            (state.reactions.right, truth.reactions[1]),
            (state.contact_force(), truth.contact_force),
        ];
        let errors = pairs.iter().map(|(found, expected)| (found - expected).abs() / self.load());
        errors.fold(0.0, |most, e| if e.is_nan() { f64::INFINITY } else { e.max(most) })
    }

    /// The error of the energy, over the energy, where it is known; where it is zero, over `P² l³/EI`, what the load would do
    /// to a free beam.
    #[must_use]
    pub fn energy_error(&self, energy: f64) -> f64 {
        let beam = self.scene.beam();
        let (l, load) = (beam.length(), self.load());
        let Some(truth) = self.truth.energy else { return 0.0 };
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

/// What an authority says.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Truth {
    /// Upward forces of the supports \[force\].
    pub reactions: [f64; 2],
    /// Resultant of all contacts, upwards \[force\].
    pub contact_force: f64,
    /// `J(v)` of (17) \[force · length\], where it is known.
    pub energy: Option<f64>,
}

impl Truth {
    /// An answer that is the same seen from both sides.
    fn symmetric(reaction: f64, contact_force: f64, energy: f64) -> Self {
        Self { reactions: [reaction; 2], contact_force, energy: Some(energy) }
    }
}

impl From<FlatSolution> for Truth {
    fn from(flat: FlatSolution) -> Self {
        Self::symmetric(flat.reaction, flat.contact_force, flat.energy)
    }
}

/// The numbers that a scene is made of.
#[derive(Debug, Clone)]
pub(crate) struct Parts {
    pub(crate) length: f64,
    pub(crate) stiffness: f64,
    pub(crate) uniform: f64,
    pub(crate) linear: Vec<LinearLoad>,
    pub(crate) point: Vec<PointLoad>,
    pub(crate) foundation: Option<Foundation>,
    /// Simple ones at both ends unless it is said otherwise.
    pub(crate) supports: Option<Vec<Support>>,
}

impl Parts {
    /// A beam of the length 10 and the stiffness 500/384, as in the example of the paper, under a uniform load of 1.
    pub(crate) fn over(foundation: Foundation) -> Self {
        Self {
            length: 10.0,
            stiffness: 500.0 / 384.0,
            uniform: 1.0,
            linear: Vec::new(),
            point: Vec::new(),
            foundation: Some(foundation),
            supports: None,
        }
    }

    /// With point loads `(place, force)`.
    pub(crate) fn with_points(self, points: &[(f64, f64)]) -> Self {
        Self { point: points.iter().map(|&(at, force)| PointLoad { at, force }).collect(), ..self }
    }

    pub(crate) fn scene(&self) -> Result<Scene, SceneError> {
        let beam = Beam::new(self.length, self.stiffness)?;
        let beam = match &self.supports {
            Some(supports) => beam.with_supports(supports.clone())?,
            None => beam,
        };
        let load = Load::new(&beam, self.uniform, self.linear.clone(), self.point.clone())?;
        Scene::new(beam, load, self.foundation.clone())
    }
}

/// The grid of the paper.
const THIRTY: usize = 30;

fn extreme(
    name: impl Into<String>,
    authority: &'static str,
    parts: &Parts,
    truth: Truth,
) -> Result<Extreme, SceneError> {
    Ok(Extreme { name: name.into(), authority, scene: parts.scene()?, truth, intervals: THIRTY })
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
