//! Loads: uniform, linear over a part of the beam, and point loads, all positive downwards; couples, positive if they rotate in
//! the direction of a positive slope. The loads are added up.
//!
//! Computations read the loads through [`Load::spread`] and [`Load::concentrated`]. Every caller destructures [`Concentrated`]
//! with all its fields, so that a new field is a compiler error wherever it has been forgotten.

use super::Beam;
use super::error::{SceneError, finite, on_beam};
use super::pieces;
use super::quantity::Quantity;

/// A load that varies linearly over a part of the beam (a trapezoid).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LinearLoad {
    /// Start of the load \[length\].
    pub from: f64,
    /// End of the load \[length\].
    pub to: f64,
    /// Intensity at `from` \[force / length\].
    pub start: f64,
    /// Intensity at `to` \[force / length\].
    pub end: f64,
}

impl LinearLoad {
    /// Intensity at `x`, which lies between `from` and `to` \[force / length\].
    #[must_use]
    pub(crate) fn intensity(&self, x: f64) -> f64 {
        let s = (x - self.from) / (self.to - self.from);
        self.start + (self.end - self.start) * s
    }
}

/// A concentrated force.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PointLoad {
    /// Position \[length\].
    pub at: f64,
    /// Force, positive downwards \[force\].
    pub force: f64,
}

/// A couple: a concentrated moment as a load.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CoupleLoad {
    /// Position \[length\].
    pub at: f64,
    /// Moment, positive if it rotates in the direction of a positive slope of the deflection. The bending moment increases by it
    /// from left to right \[force · length\].
    pub moment: f64,
}

/// A concentrated action at one position.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Concentrated {
    /// Position \[length\].
    pub(crate) at: f64,
    /// A force, positive downwards; the shear force decreases by it \[force\].
    pub(crate) force: f64,
    /// A couple; the bending moment increases by it \[force · length\].
    pub(crate) couple: f64,
}

/// All loads of a scene: `q(x)` of the paper, together with point loads and couples.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Load {
    uniform: f64,
    linear: Vec<LinearLoad>,
    point: Vec<PointLoad>,
    couple: Vec<CoupleLoad>,
}

impl Load {
    /// Loads on `beam`, checked.
    ///
    /// # Errors
    ///
    /// A number that is not finite, a load that is not on the beam, a linear load without length, or loads whose sum
    /// overflows.
    pub fn new(beam: &Beam, uniform: f64, linear: Vec<LinearLoad>, point: Vec<PointLoad>) -> Result<Self, SceneError> {
        finite(Quantity::Uniform, uniform)?;
        for (i, load) in linear.iter().enumerate() {
            on_beam(Quantity::LinearFrom(i), load.from, beam.length())?;
            on_beam(Quantity::LinearTo(i), load.to, beam.length())?;
            finite(Quantity::LinearStart(i), load.start)?;
            finite(Quantity::LinearEnd(i), load.end)?;
            if load.to <= load.from {
                return Err(SceneError::EmptyLoad { quantity: Quantity::LinearTo(i), from: load.from, to: load.to });
            }
        }
        for (i, load) in point.iter().enumerate() {
            on_beam(Quantity::PointAt(i), load.at, beam.length())?;
            finite(Quantity::PointForce(i), load.force)?;
        }
        Self { uniform, linear, point, couple: Vec::new() }.finite(beam)
    }

    /// The same loads with these couples, checked.
    ///
    /// # Errors
    ///
    /// A number that is not finite, a couple outside the beam, or loads whose sum overflows.
    pub fn with_couples(self, beam: &Beam, couple: Vec<CoupleLoad>) -> Result<Self, SceneError> {
        for (i, load) in couple.iter().enumerate() {
            on_beam(Quantity::CoupleAt(i), load.at, beam.length())?;
            finite(Quantity::CoupleMoment(i), load.moment)?;
        }
        Self { couple, ..self }.finite(beam)
    }

    /// The same loads, checked for a beam.
    pub(super) fn checked(self, beam: &Beam) -> Result<Self, SceneError> {
        Self::new(beam, self.uniform, self.linear, self.point)?.with_couples(beam, self.couple)
    }

    /// Rejects loads whose sum is not finite.
    fn finite(self, beam: &Beam) -> Result<Self, SceneError> {
        let value = self.magnitude(beam.length());
        if value.is_finite() {
            Ok(self)
        } else {
            Err(SceneError::Overflow { quantity: Quantity::TotalLoad, what: "the sum of all loads", value })
        }
    }

    /// A uniform load `q₀` \[force / length\] on the whole beam.
    ///
    /// # Errors
    ///
    /// Those of [`Load::new`].
    pub fn uniform_on(beam: &Beam, intensity: f64) -> Result<Self, SceneError> {
        Self::new(beam, intensity, Vec::new(), Vec::new())
    }

    /// `q₀`, the uniform part \[force / length\].
    #[must_use]
    pub fn uniform(&self) -> f64 {
        self.uniform
    }

    /// The linear parts.
    #[must_use]
    pub fn linear(&self) -> &[LinearLoad] {
        &self.linear
    }

    /// The point loads.
    #[must_use]
    pub fn point(&self) -> &[PointLoad] {
        &self.point
    }

    /// The couples.
    #[must_use]
    pub fn couple(&self) -> &[CoupleLoad] {
        &self.couple
    }

    /// All distributed loads on a beam of this length, the uniform load first.
    pub(crate) fn spread(&self, length: f64) -> impl Iterator<Item = LinearLoad> + '_ {
        let uniform = LinearLoad { from: 0.0, to: length, start: self.uniform, end: self.uniform };
        std::iter::once(uniform).chain(self.linear.iter().copied())
    }

    /// All concentrated loads, forces first.
    pub(crate) fn concentrated(&self) -> impl Iterator<Item = Concentrated> + Clone + '_ {
        let forces = self.point.iter().map(|&PointLoad { at, force }| Concentrated { at, force, couple: 0.0 });
        let couple = |&CoupleLoad { at, moment }: &CoupleLoad| Concentrated { at, force: 0.0, couple: moment };
        forces.chain(self.couple.iter().map(couple))
    }

    /// The positions strictly inside a beam of this length at which a load begins, ends or acts, in any order.
    pub(crate) fn places(&self, length: f64) -> impl Iterator<Item = f64> + '_ {
        let ends = self.linear.iter().flat_map(|part| [part.from, part.to]);
        ends.chain(self.concentrated().map(|acts| acts.at)).filter(move |x| 0.0 < *x && *x < length)
    }

    /// Sum of the magnitudes of all parts, `|q₀| l + Σ (|start| + |end|)/2 (to − from) + Σ |force| + Σ |couple|/l` \[force\]. It
    /// is a scale for forces and not a resultant.
    #[must_use]
    pub fn magnitude(&self, length: f64) -> f64 {
        let linear: f64 = self.linear.iter().map(|q| 0.5 * (q.start.abs() + q.end.abs()) * (q.to - q.from)).sum();
        let point: f64 = self.point.iter().map(|p| p.force.abs()).sum();
        let couple: f64 = self.couple.iter().map(|c| c.moment.abs() / length).sum();
        self.uniform.abs() * length + linear + point + couple
    }

    /// Resultant of all parts, positive downwards: `q₀ l + Σ (start + end)/2 (to − from) + Σ force` \[force\].
    #[must_use]
    pub fn resultant(&self, length: f64) -> f64 {
        let linear: f64 = self.linear.iter().map(|q| 0.5 * (q.start + q.end) * (q.to - q.from)).sum();
        let point: f64 = self.point.iter().map(|p| p.force).sum();
        self.uniform * length + linear + point
    }

    /// The same loads without the point loads at the positions for which `stands` is true.
    pub(crate) fn without(&self, stands: impl Fn(f64) -> bool) -> Self {
        let point = self.point.iter().filter(|p| !stands(p.at)).copied().collect();
        Self { point, ..self.clone() }
    }

    /// The same loads in units of `length` and `force`, both powers of two. Nothing is rounded except positions next to the left
    /// end of the beam, see [`pieces::place`].
    pub(super) fn scaled(&self, length: f64, force: f64) -> Self {
        let density = |q: f64| q / force * length;
        let place = |x: f64| pieces::place(x / length);
        let mut point: Vec<PointLoad> =
            self.point.iter().map(|p| PointLoad { at: place(p.at), force: p.force / force }).collect();
        let mut linear = Vec::with_capacity(self.linear.len());
        for q in &self.linear {
            let part =
                LinearLoad { from: place(q.from), to: place(q.to), start: density(q.start), end: density(q.end) };
            if part.from < part.to {
                linear.push(part);
            } else {
                // The load acts entirely at the support.
                let force = (0.5 * part.start + 0.5 * part.end) * ((q.to - q.from) / length);
                point.push(PointLoad { at: part.to, force });
            }
        }
        let couple = self.couple.iter().map(|c| CoupleLoad { at: place(c.at), moment: c.moment / force / length });
        Self { uniform: density(self.uniform), linear, point, couple: couple.collect() }
    }
}
