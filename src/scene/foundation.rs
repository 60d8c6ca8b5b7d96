//! The foundation: an uneven profile of known depth `u(x)`. Initial shapes of the beam use the same kinds of profile.

use std::ops::Range;

use super::Beam;
use super::error::{SceneError, finite, on_beam, positive};
use super::polynomial;
use super::quantity::{Profile, ProfileKey, Quantity};

/// Depth `u(x)` of a profile, positive downwards. The depth is 0 at the level of supports that are given no other level.
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
        /// Phase at `x = 0` \[rad\].
        phase: f64,
    },
    /// A polyline from end to end of the beam. Two points at the same position form a step, where the smaller depth governs.
    Polyline {
        /// `[x, depth]`, in ascending order of `x`.
        points: Vec<[f64; 2]>,
    },
}

impl Foundation {
    /// This profile as a rigid foundation, checked for `beam`.
    ///
    /// # Errors
    ///
    /// A number that is not finite, a wavelength that is not positive, a polyline that is invalid or does not reach from end to
    /// end of the beam, or depths that overflow. At supports: a foundation above a support by more than the rounding of its
    /// depth, at or above the level of a compression-only support, or one that rises above the beam next to a support at its
    /// level.
    pub fn checked(self, beam: &Beam) -> Result<Self, SceneError> {
        let defined = self.defined_for(beam)?;
        defined.check_at_supports(beam)?;
        Ok(defined)
    }

    /// The profile with all checks except those of a rigid foundation at supports.
    pub(super) fn defined_for(self, beam: &Beam) -> Result<Self, SceneError> {
        self.check(Profile::Foundation, beam.length())?;
        let supports = beam.supports().iter().chain(beam.bearings());
        match supports.map(|support| support.at).find(|at| self.depth(*at).is_nan()) {
            Some(at) => Err(self.overflow_at(at)),
            None => Ok(self),
        }
    }

    /// The checks that apply to foundations and initial shapes.
    pub(super) fn check(&self, of: Profile, length: f64) -> Result<(), SceneError> {
        let number = |key| Quantity::Profile(of, key);
        match self {
            Self::Flat { depth } => {
                finite(number(ProfileKey::Depth), *depth)?;
            }
            Self::Polynomial { coefficients } => {
                let count = polynomial::used(coefficients).len();
                if !(1..=polynomial::COEFFICIENTS).contains(&count) {
                    return Err(SceneError::Coefficients { of, count });
                }
                for (i, &c) in coefficients.iter().enumerate() {
                    finite(number(ProfileKey::Coefficient(i)), c)?;
                }
            }
            Self::Cosine { mean, amplitude, wavelength, phase } => {
                finite(number(ProfileKey::Mean), *mean)?;
                finite(number(ProfileKey::Amplitude), *amplitude)?;
                positive(number(ProfileKey::Wavelength), *wavelength)?;
                finite(number(ProfileKey::Phase), *phase)?;
            }
            Self::Polyline { points } => check_polyline(of, points, length)?,
        }
        let value = self.magnitude(length);
        if !value.is_finite() {
            let quantity = number(ProfileKey::Whole);
            return Err(SceneError::Overflow { quantity, what: "a bound on its depth", value });
        }
        Ok(())
    }

    /// `u(x)` \[length\]; the smaller of the two depths at a step of a polyline.
    ///
    /// `x` lies on the beam for which the foundation was checked.
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

    /// `[u, u']` just to the left and just to the right of `x` \[length, 1\]. At an end of the beam both are the values inside.
    #[must_use]
    pub fn sides(&self, x: f64) -> [[f64; 2]; 2] {
        match self {
            Self::Flat { depth } => [[*depth, 0.0]; 2],
            Self::Polynomial { coefficients } => {
                [[self.depth(x), polynomial::with_slope(coefficients.iter().copied(), x)[1]]; 2]
            }
            Self::Cosine { amplitude, wavelength, phase, .. } => {
                let rate = 2.0 * std::f64::consts::PI / wavelength;
                let angle = 2.0 * std::f64::consts::PI * (x / wavelength) + phase;
                [[self.depth(x), -amplitude * rate * libm::sin(angle)]; 2]
            }
            Self::Polyline { points } => {
                let before = points.partition_point(|p| p[0] < x);
                let beyond = points.partition_point(|p| p[0] <= x);
                // The segments next to `x`: the last one that begins before it, and the first one that ends after it.
                let left = before.checked_sub(1).and_then(|i| Some((points[i], *points.get(i + 1)?)));
                let right = beyond.checked_sub(1).and_then(|i| Some((points[i], *points.get(i + 1)?)));
                let side = |at: Option<([f64; 2], [f64; 2])>, here: usize| {
                    at.map(|(a, b)| {
                        let slope = (b[1] - a[1]) / (b[0] - a[0]);
                        [
                            points.get(here).filter(|p| p[0] <= x && x <= p[0]).map_or_else(|| self.depth(x), |p| p[1]),
                            slope,
                        ]
                    })
                };
                let (left, right) = (side(left, before), side(right, beyond.wrapping_sub(1)));
                match (left.or(right), right.or(left)) {
                    (Some(left), Some(right)) => [left, right],
                    _ => [[self.depth(x), 0.0]; 2],
                }
            }
        }
    }

    /// The magnitude of the terms whose sum is the slope at `x`. The rounding of the slope is relative to it.
    pub(super) fn slope_size(&self, x: f64) -> f64 {
        match self {
            Self::Flat { .. } => 0.0,
            Self::Polynomial { coefficients } => polynomial::magnitudes_at(coefficients, x)[1],
            Self::Cosine { amplitude, wavelength, phase, .. } => {
                let angle = 2.0 * std::f64::consts::PI * (x / wavelength).abs() + phase.abs();
                2.0 * std::f64::consts::PI / wavelength * amplitude.abs() * (1.0 + angle)
            }
            Self::Polyline { points } => {
                let beside = |w: &&[[f64; 2]]| w[0][0] < w[1][0] && w[0][0] <= x && x <= w[1][0];
                let from = points.partition_point(|p| p[0] < x).saturating_sub(1);
                let size = |w: &[[f64; 2]]| (w[0][1].abs() + w[1][1].abs()) / (w[1][0] - w[0][0]);
                points[from..].windows(2).take(4).filter(beside).map(size).fold(0.0, f64::max)
            }
        }
    }

    /// The error for a depth that overflows at a support. With finite numbers only the angle of a cosine can overflow.
    pub(super) fn overflow_at(&self, x: f64) -> SceneError {
        self.overflow_of(Profile::Foundation, x)
    }

    /// The error for a depth of either profile that overflows at a support.
    pub(super) fn overflow_of(&self, of: Profile, x: f64) -> SceneError {
        let quantity = Quantity::Profile(of, ProfileKey::Wavelength);
        SceneError::Overflow { quantity, what: "the depth at a support", value: self.depth(x) }
    }

    /// The magnitude of the terms whose sum is `u(x)` \[length\]. The rounding of the depth is relative to it.
    #[must_use]
    pub fn magnitude_at(&self, x: f64) -> f64 {
        match self {
            Self::Flat { depth } => depth.abs(),
            Self::Polynomial { coefficients } => polynomial::magnitudes_at(coefficients, x)[0],
            Self::Cosine { mean, amplitude, wavelength, phase } => {
                // The angle is also rounded.
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
            Self::Polynomial { coefficients } => polynomial::magnitudes_at(coefficients, length)[0],
            Self::Cosine { mean, amplitude, .. } => mean.abs() + amplitude.abs(),
            Self::Polyline { points } => points.iter().fold(0.0, |most, p| p[1].abs().max(most)),
        }
    }

    /// The same profile in units of `length` along the beam and `depth` across it, both powers of two.
    pub(super) fn scaled(&self, length: f64, depth: f64) -> Self {
        match self {
            Self::Flat { depth: u } => Self::Flat { depth: u / depth },
            Self::Polynomial { coefficients } => {
                // In one step: a power of the length or a quotient by the depth may leave the range of `f64` although the result
                // does not.
                let [length, depth] = [length, depth].map(|unit| i64::from(libm::ilogb(unit)));
                let scaled = (0..).zip(coefficients).map(|(j, c)| {
                    let exponent = (length * j - depth).clamp(i64::from(i32::MIN), i64::from(i32::MAX));
                    libm::scalbn(*c, i32::try_from(exponent).unwrap_or_default())
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

/// Checks that a polyline runs from 0 to `l` in ascending order, with at most two points at one position.
fn check_polyline(of: Profile, points: &[[f64; 2]], length: f64) -> Result<(), SceneError> {
    let number = |key| Quantity::Profile(of, key);
    let [first, .., last] = points else {
        return Err(SceneError::TooFewPoints { of, count: points.len() });
    };
    for (i, &[x, depth]) in points.iter().enumerate() {
        on_beam(number(ProfileKey::PolylineX(i)), x, length)?;
        finite(number(ProfileKey::PolylineDepth(i)), depth)?;
        if 0 < i && x < points[i - 1][0] {
            let previous = points[i - 1][0];
            return Err(SceneError::PointsRunBack { quantity: number(ProfileKey::PolylineX(i)), value: x, previous });
        }
        #[expect(clippy::float_cmp, reason = "a step is two points at exactly the same place")]
        if 1 < i && x == points[i - 2][0] {
            return Err(SceneError::ThreePointsAtOnePlace { quantity: number(ProfileKey::PolylineX(i)), value: x });
        }
    }
    for (end, reaches) in [(0, first[0] <= 0.0), (points.len() - 1, length <= last[0])] {
        if !reaches {
            let quantity = number(ProfileKey::PolylineX(end));
            return Err(SceneError::PointsDoNotCover { of, quantity, value: points[end][0], length });
        }
    }
    Ok(())
}

/// Depth of a polyline at `x`: interpolated between the neighbouring points, the smaller depth at a step.
fn polyline_depth(points: &[[f64; 2]], x: f64) -> f64 {
    let after = points.partition_point(|p| p[0] < x);
    let beyond = points.partition_point(|p| p[0] <= x);
    between(points, after..beyond, x)
}

/// Depth of a polyline at `x`, given the range of the points that lie at `x`. If there are none, `here.start` is the index of the
/// next point.
pub(super) fn between(points: &[[f64; 2]], here: Range<usize>, x: f64) -> f64 {
    if !here.is_empty() {
        return points[here].iter().fold(f64::INFINITY, |least, p| least.min(p[1]));
    }
    // Strictly between two points, or, for `x` outside the polyline, the depth of the nearest point.
    let after = here.start;
    let (Some(left), Some(right)) = (after.checked_sub(1).map(|i| points[i]), points.get(after)) else {
        return points[after.min(points.len() - 1)][1];
    };
    let s = (x - left[0]) / (right[0] - left[0]);
    left[1] + (right[1] - left[1]) * s
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The rounding of a slope is relative to its largest value, and it grows with the angle of the wave.
    #[test]
    fn the_size_of_a_slope_grows_with_the_angle() {
        use std::f64::consts::FRAC_PI_2;
        for wavelength in [0.1, 1.0, 10.0] {
            let wave = Foundation::Cosine { mean: 3.0, amplitude: 0.5, wavelength, phase: 0.0 };
            let steepest = wave.sides(0.25 * wavelength)[0][1].abs();
            for (quarters, factor) in [(0.0, 1.0), (1.0, 1.0 + FRAC_PI_2), (3.0, 1.0 + 3.0 * FRAC_PI_2)] {
                let size = wave.slope_size(quarters * 0.25 * wavelength);
                assert!((size / (factor * steepest) - 1.0).abs() < 1e-14, "{size} of {steepest}");
            }
        }
    }
}
