//! The stiffness of an elastic foundation along the beam: one value `k`, or steps.
//!
//! ```text
//! p = k(x) (v − g)₊,    k(x) = k_i from x_i on        where k = 0 there is no foundation at all
//! ```

use super::error::{SceneError, finite, positive};
use super::quantity::Quantity;
use super::stiffness::check_places;
use super::{Beam, Foundation, Load, Scene};

/// The stiffness `k` of an elastic foundation.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct GroundStiffness {
    /// The greatest stiffness, positive.
    pub(super) greatest: f64,
    /// Positions and the stiffness that begins at each; empty if the stiffness is uniform.
    pub(super) steps: Vec<[f64; 2]>,
}

impl GroundStiffness {
    pub(super) fn one(stiffness: f64) -> Result<Self, SceneError> {
        Ok(Self { greatest: positive(Quantity::GroundStiffness, stiffness)?, steps: Vec::new() })
    }

    pub(super) fn in_steps(steps: Vec<[f64; 2]>, length: f64) -> Result<Self, SceneError> {
        check_places(&steps, length, Quantity::GroundStiffness, Quantity::GroundStepAt)?;
        for (i, step) in steps.iter().enumerate() {
            let quantity = Quantity::GroundStepStiffness(i);
            if finite(quantity, step[1])? < 0.0 {
                return Err(SceneError::NegativeGroundStiffness { quantity, value: step[1] });
            }
        }
        let greatest = steps.iter().fold(0.0, |most: f64, step| most.max(step[1]));
        if greatest <= 0.0 {
            return Err(SceneError::NoGroundAnywhere);
        }
        Ok(Self { greatest, steps })
    }

    /// The stiffness in other units: `of` converts a stiffness, `length` is the unit of length.
    pub(super) fn scaled(&self, length: f64, of: impl Fn(f64) -> f64) -> Self {
        let steps = self.steps.iter().map(|&[at, value]| [super::pieces::place(at / length), of(value)]).collect();
        Self { greatest: of(self.greatest), steps }
    }

    /// `k` just to the left and just to the right of a position.
    fn beside(&self, x: f64) -> [f64; 2] {
        let at = |next: usize| next.checked_sub(1).map_or(self.greatest, |i| self.steps[i][1]);
        [at(self.steps.partition_point(|step| step[0] < x)), at(self.steps.partition_point(|step| step[0] <= x))]
    }

    /// The parts of uniform stiffness: `[from, to]` and `k`.
    fn parts(&self, length: f64) -> impl Iterator<Item = ([f64; 2], f64)> + '_ {
        let end = move |i: usize| self.steps.get(i + 1).map_or(length, |next| next[0]);
        let one = self.steps.is_empty().then_some(([0.0, length], self.greatest));
        let each = self.steps.iter().enumerate().map(move |(i, step)| ([step[0], end(i)], step[1]));
        one.into_iter().chain(each)
    }
}

impl Scene {
    /// The same scene on an elastic foundation that presses with `k (v − g)` under a penetration `v − g` and carries no tension:
    /// a unilateral Winkler foundation.
    ///
    /// # Errors
    ///
    /// [`SceneError::NotPositive`] unless `k` is positive and finite.
    pub fn on_springs(&self, stiffness: f64) -> Result<Self, SceneError> {
        Ok(Self { stiffness: Some(GroundStiffness::one(stiffness)?), ..self.clone() })
    }

    /// A scene above a foundation whose stiffness varies in steps, `(x_i, k_i)` \[length, force / length²\].
    ///
    /// # Errors
    ///
    /// Those of [`above`](Self::above), and steps that do not begin at 0, go back or begin at the end of the beam, a negative stiffness,
    /// and a stiffness of 0 everywhere.
    pub fn above_steps(
        beam: Beam,
        load: Load,
        foundation: Option<Foundation>,
        steps: Vec<[f64; 2]>,
    ) -> Result<Self, SceneError> {
        let stiffness = GroundStiffness::in_steps(steps, beam.length())?;
        Self::built(beam, load, foundation, Some(stiffness))
    }

    /// `k` of an elastic foundation \[force / length²\], the greatest value if it varies in steps; [`None`] if the foundation is
    /// rigid or absent.
    #[must_use]
    pub fn ground_stiffness(&self) -> Option<f64> {
        self.given_stiffness().map(|stiffness| stiffness.greatest)
    }

    /// `(x_i, k_i)`, positions and the stiffness of the elastic foundation that begins at each \[length, force / length²\]; empty
    /// if it is uniform.
    #[must_use]
    pub fn ground_steps(&self) -> &[[f64; 2]] {
        self.given_stiffness().map_or(&[], |stiffness| &stiffness.steps)
    }

    /// The parts of the beam with a uniform stiffness of the foundation, from end to end: `[from, to]` and `k`; none on a rigid
    /// foundation.
    pub fn ground_parts(&self) -> impl Iterator<Item = ([f64; 2], f64)> + '_ {
        self.given_stiffness().into_iter().flat_map(|stiffness| stiffness.parts(self.beam.length()))
    }

    /// The positions at which the stiffness of an elastic foundation changes, from left to right \[length\].
    pub(crate) fn ground_changes(&self) -> impl Iterator<Item = f64> + '_ {
        self.ground_steps().windows(2).filter(|two| two[0][1].total_cmp(&two[1][1]).is_ne()).map(|two| two[1][0])
    }

    /// `k` just to the left and just to the right of a position; 0 for a rigid foundation and without a foundation.
    #[must_use]
    pub(crate) fn ground_stiffness_beside(&self, x: f64) -> [f64; 2] {
        self.given_stiffness().map_or([0.0; 2], |stiffness| stiffness.beside(x))
    }

    /// Whether there is a foundation, rigid or elastic, just to the left and just to the right of a position.
    pub(crate) fn is_grounded_beside(&self, x: f64) -> [bool; 2] {
        match self.given_stiffness() {
            Some(stiffness) => stiffness.beside(x).map(|k| 0.0 < k),
            None => [self.foundation.is_some(); 2],
        }
    }

    /// The outermost positions above the foundation; [`None`] if there is no foundation.
    pub(super) fn ground_ends(&self) -> Option<[f64; 2]> {
        let length = self.beam.length();
        let Some(stiffness) = self.given_stiffness() else {
            return self.foundation.is_some().then_some([0.0, length]);
        };
        let grounded = || stiffness.parts(length).filter(|(_, k)| 0.0 < *k).map(|(ends, _)| ends);
        let first = grounded().next()?;
        Some([first[0], grounded().last().unwrap_or(first)[1]])
    }

    /// The same scene under another load.
    ///
    /// # Errors
    ///
    /// Those of [`Scene::new`].
    pub(crate) fn under(&self, load: Load) -> Result<Self, SceneError> {
        Ok(Self { load: load.checked(&self.beam)?, ..self.clone() })
    }

    /// The same scene above another foundation of the same stiffness.
    ///
    /// # Errors
    ///
    /// Those of [`Scene::new`].
    pub(crate) fn above_other(&self, foundation: Option<Foundation>) -> Result<Self, SceneError> {
        let (beam, load) = (self.beam.clone(), self.load.clone());
        let other = Self::built(beam, load, foundation, self.stiffness.clone())?;
        Ok(other.labelled(self.title.clone(), self.units.clone()))
    }

    /// The stiffness if there is a foundation.
    fn given_stiffness(&self) -> Option<&GroundStiffness> {
        self.stiffness.as_ref().filter(|_| self.foundation.is_some())
    }
}
