//! The model: beam, supports, loads and foundation. The numbers of a [`Scene`] are checked when it is created. If the supports
//! leave the beam free to move, whether a solution exists also depends on the loads and the foundation. [`Scene::scaled`] then
//! determines the [`Balance`] or returns an error.

pub(crate) mod axial;
mod balance;
mod beam;
mod bend;
mod beyond;
mod depths;
mod error;
mod far_depths;
pub mod file;
mod foundation;
mod grid;
mod ground;
mod known;
mod load;
mod number;
pub(crate) mod pieces;
pub(crate) mod polynomial;
mod quantity;
mod scale;
mod sign;
mod stiffness;
mod support;
mod written;

use std::sync::Arc;

use self::ground::GroundStiffness;
pub use axial::Unstable;
pub use balance::{Balance, Resultant, Unheld};
pub use beam::Beam;
pub use error::SceneError;
pub use far_depths::FarDepths;
pub use foundation::Foundation;
pub use grid::Grid;
pub(crate) use grid::is_same_place;
pub(crate) use load::Concentrated;
pub use load::{CoupleLoad, LinearLoad, Load, PointLoad};
pub use number::PathError;
pub use quantity::{Profile, ProfileKey, Quantity};
pub use scale::{Scale, Scaled};
pub use sign::DoubtfulSign;
pub use stiffness::Joint;
pub use support::{Bearing, Held, Spring, Support};
pub(crate) use written::as_written;

/// A beam with its loads and, if there is one, the foundation below it.
#[derive(Debug, Clone, PartialEq)]
pub struct Scene {
    title: String,
    beam: Beam,
    load: Load,
    /// Shared by all data derived from the scene, because a survey may have millions of points.
    foundation: Option<Arc<Foundation>>,
    /// Stiffness of an elastic foundation; [`None`] for a rigid one.
    stiffness: Option<GroundStiffness>,
    units: Units,
    /// Point loads beyond the beam, each with its index. `load` contains a zero force in place of each of them.
    beyond: Vec<(usize, PointLoad)>,
}

/// Labels of the units for human readers; never used in arithmetic.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Units {
    /// Label of the unit of length, for example `m`.
    pub length: Option<String>,
    /// Label of the unit of force, for example `kN`.
    pub force: Option<String>,
}

impl Scene {
    /// Creates a scene. `load` and `foundation` are checked again for `beam`, since they may have been created for another beam.
    ///
    /// # Errors
    ///
    /// Every [`SceneError`] of [`Load::new`] and [`Foundation::checked`].
    pub fn new(beam: Beam, load: Load, foundation: Option<Foundation>) -> Result<Self, SceneError> {
        Self::above(beam, load, foundation, None)
    }

    /// Creates a scene above a foundation of stiffness `k` \[force / length²\]; without `stiffness` the foundation is rigid.
    /// Supports may be located inside an elastic foundation, because the beam can be pressed into it there.
    ///
    /// # Errors
    ///
    /// Those of [`new`](Self::new) and [`on_springs`](Self::on_springs).
    pub fn above(
        beam: Beam,
        load: Load,
        foundation: Option<Foundation>,
        stiffness: Option<f64>,
    ) -> Result<Self, SceneError> {
        Self::built(beam, load, foundation, stiffness.map(GroundStiffness::one).transpose()?)
    }

    fn built(
        beam: Beam,
        load: Load,
        foundation: Option<Foundation>,
        stiffness: Option<GroundStiffness>,
    ) -> Result<Self, SceneError> {
        let load = load.checked(&beam)?;
        load.check_at_joints(&beam)?;
        let checked = |foundation: Foundation| match stiffness {
            None => foundation.checked(&beam),
            Some(_) => foundation.defined_for(&beam),
        };
        let foundation = foundation.map(checked).transpose()?.map(Arc::new);
        Ok(Self {
            title: String::new(),
            beam,
            load,
            foundation,
            stiffness,
            units: Units::default(),
            beyond: Vec::new(),
        })
    }

    /// The same scene in which each rigid compression-only support that is `pressed` becomes a bilateral support. The other rigid
    /// compression-only supports are removed.
    ///
    /// # Errors
    ///
    /// Those of [`new`](Self::new).
    pub(crate) fn held_where(&self, pressed: impl Fn(&Support) -> bool) -> Result<Self, SceneError> {
        let holds = self.beam.bearings().iter().filter(|bearing| pressed(bearing));
        let holds = holds.map(|bearing| Support { pushes_only: false, ..*bearing });
        let kept = self.beam.supports().iter().chain(self.beam.springs()).copied();
        let beam = self.beam.clone().with_supports(kept.chain(holds).collect())?;
        Ok(Self { beam, ..self.clone() })
    }

    /// The same scene with a title and unit labels.
    #[must_use]
    pub fn labelled(self, title: impl Into<String>, units: Units) -> Self {
        Self { title: title.into(), units, ..self }
    }

    /// The title; empty if the scene has none.
    #[must_use]
    pub fn title(&self) -> &str {
        &self.title
    }

    /// The beam.
    #[must_use]
    pub fn beam(&self) -> &Beam {
        &self.beam
    }

    /// The loads.
    #[must_use]
    pub fn load(&self) -> &Load {
        &self.load
    }

    /// The loads that bend the beam: all loads except those directly above a support that carries them.
    pub(crate) fn bending_load(&self) -> Load {
        self.load.without(|at| self.beam.carries(at))
    }

    /// The sum of the point loads directly above a support at this position, if the support carries them \[force\].
    pub(crate) fn standing_on(&self, at: f64) -> f64 {
        let here = self.load.point().iter().filter(|load| load.at <= at && at <= load.at && self.beam.carries(at));
        here.map(|load| load.force).sum()
    }

    /// Depths of the foundation and of the initial shape that are so far from all others that they may mark missing data.
    #[must_use]
    pub fn far_depths(&self) -> Vec<FarDepths> {
        let profiles = [(Profile::Foundation, self.foundation()), (Profile::Shape, self.beam.shape())];
        profiles.into_iter().filter_map(|(of, profile)| FarDepths::of(of, profile?)).collect()
    }

    /// The foundation, if there is one.
    #[must_use]
    pub fn foundation(&self) -> Option<&Foundation> {
        self.foundation.as_deref()
    }

    /// The foundation as a shared pointer.
    pub(crate) fn shared_foundation(&self) -> Option<Arc<Foundation>> {
        self.foundation.clone()
    }

    /// The unit labels.
    #[must_use]
    pub fn units(&self) -> &Units {
        &self.units
    }

    /// The depth `u(x)` of the foundation \[length\]; infinite without a foundation.
    #[must_use]
    pub fn depth(&self, x: f64) -> f64 {
        self.foundation.as_ref().map_or(f64::INFINITY, |f| f.depth(x))
    }

    /// True if there is an obstacle that the beam may touch: a foundation or a compression-only support.
    #[must_use]
    pub fn has_obstacle(&self) -> bool {
        self.foundation.is_some() || !self.beam.bearings().is_empty() || self.stops().next().is_some()
    }

    /// `g(x) = u − w0`, the gap below the unloaded beam \[length\]. Equation (6) subtracts the deflection from it: the clearance
    /// is `h = g − v`. Above a compression-only support the gap is the initial clearance there. It is infinite where there is no
    /// obstacle. For a straight beam it is the depth of the foundation.
    #[must_use]
    pub fn gap(&self, x: f64) -> f64 {
        let mut gap = [0.0];
        self.gaps(&[x], &mut gap);
        gap[0]
    }

    /// Writes the gaps at positions in ascending order; `gaps` and `places` have the same length.
    pub(crate) fn gaps(&self, places: &[f64], gaps: &mut [f64]) {
        match &self.foundation {
            Some(foundation) => foundation.depths(places, gaps),
            None => gaps.fill(f64::INFINITY),
        }
        if let Some(shape) = self.beam.shape() {
            let mut own = vec![0.0; places.len()];
            shape.depths(places, &mut own);
            gaps.iter_mut().zip(own).for_each(|(gap, own)| *gap -= own);
        }
        let (Some(first), Some(last)) = (places.first(), places.last()) else { return };
        let is_one = |x: f64, at: f64| is_same_place(x, at, self.beam.length());
        let before = self.beam.bearings().partition_point(|bearing| bearing.at < *first && !is_one(*first, bearing.at));
        let within =
            self.bearings().skip(before).take_while(|bearing| bearing.at <= *last || is_one(*last, bearing.at));
        for bearing in within {
            let is_here = |x: f64| is_one(x, bearing.at);
            let next = places.partition_point(|&x| x < bearing.at);
            for i in [next.checked_sub(1), Some(next)].into_iter().flatten() {
                if places.get(i).is_some_and(|&x| is_here(x)) {
                    gaps[i] = bearing.gap;
                }
            }
        }
    }

    /// This scene in other units; `stiffness` is the unit of `EI`, which is `F L³ / U`.
    fn in_units(&self, scale: &Scale, stiffness: f64) -> Result<Self, SceneError> {
        let beam = self.beam.scaled(scale, stiffness)?;
        let load = self.load.scaled(scale.length, scale.force);
        let foundation = self.foundation.as_ref().map(|f| f.scaled(scale.length, scale.depth));
        // The unit is `F/L U = E/L⁴`, divided in an order that keeps every step in range.
        let spring = |k: f64| k * scale.length * scale.length / stiffness * scale.length * scale.length;
        let springs = self.stiffness.as_ref().map(|given| given.scaled(scale.length, spring));
        if let Some(value) = springs.as_ref().map(|springs| springs.greatest).filter(|k| !k.is_normal()) {
            let (quantity, what) = (Quantity::GroundStiffness, "the stiffness of the ground in these units");
            return Err(SceneError::Overflow { quantity, what, value });
        }
        Self::built(beam, load, foundation, springs)
    }
}
