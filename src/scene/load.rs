//! Loads: uniform, linear over a part of the beam, and point loads; all positive downwards, all added up.

use super::Beam;
use super::error::{SceneError, finite, on_beam};
use super::pieces;
use super::quantity::Quantity;

/// A load that varies linearly over a part of the beam (a trapezoid).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LinearLoad {
    /// Where it starts \[length\].
    pub from: f64,
    /// Where it ends \[length\].
    pub to: f64,
    /// Intensity at `from` \[force / length\].
    pub start: f64,
    /// Intensity at `to` \[force / length\].
    pub end: f64,
}

impl LinearLoad {
    /// Intensity at `x`, which lies between `from` and `to` \[force / length\].
    #[must_use]
    pub fn intensity(&self, x: f64) -> f64 {
        let s = (x - self.from) / (self.to - self.from);
        self.start + (self.end - self.start) * s
    }
}

/// A concentrated force.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PointLoad {
    /// Where it acts \[length\].
    pub at: f64,
    /// Positive downwards \[force\].
    pub force: f64,
}

/// All loads of a scene: `q(x)` of the paper, with point loads besides.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Load {
    uniform: f64,
    linear: Vec<LinearLoad>,
    point: Vec<PointLoad>,
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
        let load = Self { uniform, linear, point };
        let value = load.magnitude(beam.length());
        if value.is_finite() {
            Ok(load)
        } else {
            Err(SceneError::Overflow { quantity: Quantity::TotalLoad, what: "the sum of all loads", value })
        }
    }

    /// A uniform load `q₀` \[force / length\] on the whole beam.
    ///
    /// # Errors
    ///
    /// As [`Load::new`].
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

    /// Sum of the magnitudes of all parts, `|q₀| l + Σ (|start| + |end|)/2 (to − from) + Σ |force|` \[force\]:
    /// the scale of forces, not a resultant.
    #[must_use]
    pub fn magnitude(&self, length: f64) -> f64 {
        let linear: f64 = self.linear.iter().map(|q| 0.5 * (q.start.abs() + q.end.abs()) * (q.to - q.from)).sum();
        let point: f64 = self.point.iter().map(|p| p.force.abs()).sum();
        self.uniform.abs() * length + linear + point
    }

    /// Resultant of all parts, positive downwards: `q₀ l + Σ (start + end)/2 (to − from) + Σ force` \[force\].
    #[must_use]
    pub fn resultant(&self, length: f64) -> f64 {
        let linear: f64 = self.linear.iter().map(|q| 0.5 * (q.start + q.end) * (q.to - q.from)).sum();
        let point: f64 = self.point.iter().map(|p| p.force).sum();
        self.uniform * length + linear + point
    }

    /// The same loads without the point loads at some places.
    pub(crate) fn without(&self, stands: impl Fn(f64) -> bool) -> Self {
        let point = self.point.iter().filter(|p| !stands(p.at)).copied().collect();
        Self { point, ..self.clone() }
    }

    /// The same loads in units of `length` and `force`, both powers of two, so that nothing is rounded but places that are at
    /// the left end of the beam, see [`pieces::place`].
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
                // All of it is at the support.
                let force = (0.5 * part.start + 0.5 * part.end) * ((q.to - q.from) / length);
                point.push(PointLoad { at: part.to, force });
            }
        }
        Self { uniform: density(self.uniform), linear, point }
    }
}
