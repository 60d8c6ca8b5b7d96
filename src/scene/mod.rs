//! What is given: beam, load, foundation. A [`Scene`] that exists is well posed.

mod beam;
mod bend;
mod depths;
mod double;
mod error;
pub mod file;
mod foundation;
mod grid;
mod load;
pub(crate) mod pieces;
pub(crate) mod polynomial;
mod quantity;
mod scale;

pub use beam::Beam;
pub use error::SceneError;
pub use foundation::Foundation;
pub use grid::Grid;
pub use load::{LinearLoad, Load, PointLoad};
pub use quantity::{Quantity, Support};
pub use scale::{Scale, Scaled};

/// A beam, its loads and the foundation below it, if there is one.
#[derive(Debug, Clone, PartialEq)]
pub struct Scene {
    title: String,
    beam: Beam,
    load: Load,
    foundation: Option<Foundation>,
    units: Units,
}

/// Labels for numbers that a person reads; never used in arithmetic.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Units {
    /// Label of the unit of length, for example `m`.
    pub length: Option<String>,
    /// Label of the unit of force, for example `kN`.
    pub force: Option<String>,
}

impl Scene {
    /// A scene. `load` and `foundation` are checked for `beam` again, since they may have been made for another one.
    ///
    /// # Errors
    ///
    /// Every [`SceneError`] of [`Load::new`] and [`Foundation::checked`].
    pub fn new(beam: Beam, load: Load, foundation: Option<Foundation>) -> Result<Self, SceneError> {
        let load = Load::new(&beam, load.uniform(), load.linear().to_vec(), load.point().to_vec())?;
        let foundation = foundation.map(|f| f.checked(&beam)).transpose()?;
        Ok(Self { title: String::new(), beam, load, foundation, units: Units::default() })
    }

    /// The same scene with a title and with labels for its units.
    #[must_use]
    pub fn labelled(self, title: impl Into<String>, units: Units) -> Self {
        Self { title: title.into(), units, ..self }
    }

    /// The title, empty if the scene has none.
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

    /// The foundation, if there is one.
    #[must_use]
    pub fn foundation(&self) -> Option<&Foundation> {
        self.foundation.as_ref()
    }

    /// The labels of the units.
    #[must_use]
    pub fn units(&self) -> &Units {
        &self.units
    }

    /// Depth `u(x)` of the foundation, from which (6) takes the clearance \[length\]; infinite where there is none.
    #[must_use]
    pub fn depth(&self, x: f64) -> f64 {
        self.foundation.as_ref().map_or(f64::INFINITY, |f| f.depth(x))
    }

    /// The same at ascending places; `depths` is as long as `places`.
    pub fn depths(&self, places: &[f64], depths: &mut [f64]) {
        match &self.foundation {
            Some(foundation) => foundation.depths(places, depths),
            None => depths.fill(f64::INFINITY),
        }
    }

    /// This scene in other units; `stiffness` is the unit of `EI`, that is `F L³ / U`.
    fn in_units(&self, scale: &Scale, stiffness: f64) -> Result<Self, SceneError> {
        let beam = Beam::new(self.beam.length() / scale.length, self.beam.bending_stiffness() / stiffness)?;
        let load = self.load.scaled(scale.length, scale.force);
        let foundation = self.foundation.as_ref().map(|f| f.scaled(scale.length, scale.depth));
        Self::new(beam, load, foundation)
    }
}
