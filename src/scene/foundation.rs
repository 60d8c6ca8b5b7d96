//! The foundation: rigid, uneven, its depth `u(x)` below the line of the supports known.

use std::ops::Range;

use super::Beam;
use super::error::{SceneError, finite, on_beam, positive};
use super::polynomial;
use super::quantity::{Quantity, Support};

/// Depth `u(x)` of the foundation below the line of the supports, positive downwards.
#[derive(Debug, Clone, PartialEq)]
pub enum Foundation {
    /// `u = depth`.
    Flat {
        /// The depth \[length\].
        depth: f64,
    },
    /// `u = c₀ + c₁ x + c₂ x² + …`
    Polynomial {
        /// `c₀, c₁, …`, at least one \[length, 1, 1/length, …\].
        coefficients: Vec<f64>,
    },
    /// `u = mean + amplitude cos(2π x / wavelength + phase)`.
    Cosine {
        /// Mean depth \[length\].
        mean: f64,
        /// Amplitude \[length\].
        amplitude: f64,
        /// Wavelength \[length\], positive.
        wavelength: f64,
        /// Phase at the left support \[rad\].
        phase: f64,
    },
    /// A polyline from support to support. Two points at one place make a step; the smaller depth governs there.
    Polyline {
        /// `[x, depth]`, places not decreasing.
        points: Vec<[f64; 2]>,
    },
}

impl Foundation {
    /// This foundation, checked for `beam`.
    ///
    /// # Errors
    ///
    /// A number that is not finite, a wavelength that is not positive, a polyline that is not one or does not reach from
    /// support to support, depths that overflow, or a foundation above a support by more than the rounding of its depth there.
    pub fn checked(self, beam: &Beam) -> Result<Self, SceneError> {
        match &self {
            Self::Flat { depth } => {
                finite(Quantity::Depth, *depth)?;
            }
            Self::Polynomial { coefficients } => {
                if coefficients.is_empty() {
                    return Err(SceneError::NoCoefficients);
                }
                for (i, &c) in coefficients.iter().enumerate() {
                    finite(Quantity::Coefficient(i), c)?;
                }
            }
            Self::Cosine { mean, amplitude, wavelength, phase } => {
                finite(Quantity::Mean, *mean)?;
                finite(Quantity::Amplitude, *amplitude)?;
                positive(Quantity::Wavelength, *wavelength)?;
                finite(Quantity::Phase, *phase)?;
            }
            Self::Polyline { points } => check_polyline(points, beam)?,
        }
        let value = self.magnitude(beam.length());
        if !value.is_finite() {
            return Err(SceneError::Overflow { quantity: Quantity::Foundation, what: "a bound on its depth", value });
        }
        for (support, at) in [(Support::Left, 0.0), (Support::Right, beam.length())] {
            let depth = self.depth(at);
            if depth.is_nan() {
                // Of finite numbers only the angle of a wave can overflow.
                let (quantity, what) = (Quantity::Wavelength, "the depth at a support");
                return Err(SceneError::Overflow { quantity, what, value: depth });
            }
            if depth < -self.level_within(at, beam.length()) {
                return Err(SceneError::AboveSupport { support, at, depth });
            }
        }
        Ok(self)
    }

    /// `u(x)` \[length\]; at a step of a polyline the smaller of the two depths.
    ///
    /// `x` lies on the beam that the foundation was checked for.
    #[must_use]
    pub fn depth(&self, x: f64) -> f64 {
        match self {
            Self::Flat { depth } => *depth,
            Self::Polynomial { coefficients } => polynomial::value(coefficients, x),
            Self::Cosine { mean, amplitude, wavelength, phase } => {
                mean + amplitude * libm::cos(2.0 * std::f64::consts::PI * (x / wavelength) + phase)
            }
            Self::Polyline { points } => polyline_depth(points, x),
        }
    }

    /// Magnitude of the numbers that add up to `u(x)`: what its rounding is relative to \[length\].
    #[must_use]
    pub fn magnitude_at(&self, x: f64) -> f64 {
        match self {
            Self::Flat { depth } => depth.abs(),
            Self::Polynomial { coefficients } => polynomial::magnitude_at(coefficients, x),
            Self::Cosine { mean, amplitude, wavelength, phase } => {
                // The angle is rounded as well.
                let angle = 2.0 * std::f64::consts::PI * (x / wavelength).abs() + phase.abs();
                mean.abs() + amplitude.abs() * (1.0 + angle)
            }
            Self::Polyline { points } => {
                let after = points.partition_point(|p| p[0] < x).clamp(1, points.len() - 1);
                points[after - 1][1].abs().max(points[after][1].abs())
            }
        }
    }

    /// A bound on `|u|` over a beam of length `length` \[length\].
    #[must_use]
    pub fn magnitude(&self, length: f64) -> f64 {
        match self {
            Self::Flat { depth } => depth.abs(),
            Self::Polynomial { coefficients } => polynomial::magnitude(coefficients, length),
            Self::Cosine { mean, amplitude, .. } => mean.abs() + amplitude.abs(),
            Self::Polyline { points } => points.iter().fold(0.0, |most, p| p[1].abs().max(most)),
        }
    }

    /// The same foundation in units of `length` along the beam and `depth` across it, both powers of two.
    pub(super) fn scaled(&self, length: f64, depth: f64) -> Self {
        match self {
            Self::Flat { depth: u } => Self::Flat { depth: u / depth },
            Self::Polynomial { coefficients } => {
                // Not times a power of the length, which may leave the range of f64 where the product does not.
                let exponent = i64::from(libm::ilogb(length));
                let scaled = (0..).zip(coefficients).map(|(j, c)| {
                    let exponent = (exponent * j).clamp(i64::from(i32::MIN), i64::from(i32::MAX));
                    libm::scalbn(c / depth, i32::try_from(exponent).unwrap_or_default())
                });
                Self::Polynomial { coefficients: scaled.collect() }
            }
            Self::Cosine { mean, amplitude, wavelength, phase } => Self::Cosine {
                mean: mean / depth,
                amplitude: amplitude / depth,
                wavelength: wavelength / length,
                phase: *phase,
            },
            Self::Polyline { points } => {
                Self::Polyline { points: points.iter().map(|p| [p[0] / length, p[1] / depth]).collect() }
            }
        }
    }
}

/// A polyline runs from 0 to `l`, forwards, with at most two points at one place.
fn check_polyline(points: &[[f64; 2]], beam: &Beam) -> Result<(), SceneError> {
    let [first, .., last] = points else {
        return Err(SceneError::TooFewPoints { count: points.len() });
    };
    for (i, &[x, depth]) in points.iter().enumerate() {
        on_beam(Quantity::PolylineX(i), x, beam.length())?;
        finite(Quantity::PolylineDepth(i), depth)?;
        if 0 < i && x < points[i - 1][0] {
            let previous = points[i - 1][0];
            return Err(SceneError::PointsRunBack { quantity: Quantity::PolylineX(i), value: x, previous });
        }
        #[expect(clippy::float_cmp, reason = "a step is two points at exactly the same place")]
        if 1 < i && x == points[i - 2][0] {
            return Err(SceneError::ThreePointsAtOnePlace { quantity: Quantity::PolylineX(i), value: x });
        }
    }
    let length = beam.length();
    if 0.0 < first[0] {
        return Err(SceneError::PointsDoNotCover { quantity: Quantity::PolylineX(0), value: first[0], length });
    }
    if last[0] < length {
        let quantity = Quantity::PolylineX(points.len() - 1);
        return Err(SceneError::PointsDoNotCover { quantity, value: last[0], length });
    }
    Ok(())
}

/// Depth of a polyline at `x`: interpolated between the points around it, the smaller one at a step.
fn polyline_depth(points: &[[f64; 2]], x: f64) -> f64 {
    let after = points.partition_point(|p| p[0] < x);
    let beyond = points.partition_point(|p| p[0] <= x);
    between(points, after..beyond, x)
}

/// The same, where it is known which points lie at `x`: the end of those before, and the beginning of those behind.
pub(super) fn between(points: &[[f64; 2]], here: Range<usize>, x: f64) -> f64 {
    if !here.is_empty() {
        return points[here].iter().fold(f64::INFINITY, |least, p| least.min(p[1]));
    }
    // Strictly between two points, or, for `x` off the beam, the nearest one.
    let after = here.start;
    let (Some(left), Some(right)) = (after.checked_sub(1).map(|i| points[i]), points.get(after)) else {
        return points[after.min(points.len() - 1)][1];
    };
    let s = (x - left[0]) / (right[0] - left[0]);
    left[1] + (right[1] - left[1]) * s
}
