//! What can be wrong with a scene: the quantity, its value and what is required of it.

use super::quantity::{Quantity, Support};

/// Why a scene was refused.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum SceneError {
    /// A number that has to be positive is not.
    #[error("`{quantity}` must be positive and finite, but is {}", shown(*value))]
    NotPositive {
        /// Which number.
        quantity: Quantity,
        /// Its value.
        value: f64,
    },
    /// A number is `nan` or infinite.
    #[error("`{quantity}` must be finite, but is {}", shown(*value))]
    NotFinite {
        /// Which number.
        quantity: Quantity,
        /// Its value.
        value: f64,
    },
    /// A place is not on the beam.
    #[error("`{quantity}` must lie on the beam, between 0 and {}, but is {}", shown(*length), shown(*value))]
    OutsideBeam {
        /// Which place.
        quantity: Quantity,
        /// Its value.
        value: f64,
        /// Length of the beam.
        length: f64,
    },
    /// A line load that ends where it starts, or before.
    #[error("`{quantity}` must be greater than the start of the load, {}, but is {}", shown(*from), shown(*to))]
    EmptyLoad {
        /// The end of the load.
        quantity: Quantity,
        /// Where the load starts.
        from: f64,
        /// Where it ends.
        to: f64,
    },
    /// A polynomial without coefficients.
    #[error("`foundation.polynomial` needs at least one coefficient, but has none")]
    NoCoefficients,
    /// A polyline of fewer than two points.
    #[error("a foundation given by points needs at least 2 of them, but has {count}")]
    TooFewPoints {
        /// How many there are.
        count: usize,
    },
    /// Points of a polyline that run backwards.
    #[error(
        "`{quantity}` must not be less than the place of the point before it, {}, but is {}",
        shown(*previous),
        shown(*value)
    )]
    PointsRunBack {
        /// The place that is too small.
        quantity: Quantity,
        /// Its value.
        value: f64,
        /// The place before it.
        previous: f64,
    },
    /// More than two points of a polyline at the same place.
    #[error("`{quantity}` is the third point at x = {}: two points make a step, more have no meaning", shown(*value))]
    ThreePointsAtOnePlace {
        /// The third of them.
        quantity: Quantity,
        /// Where.
        value: f64,
    },
    /// A polyline that does not reach from support to support.
    #[error(
        "a foundation given by points must reach from 0 to {}, but `{quantity}` is {}",
        shown(*length),
        shown(*value)
    )]
    PointsDoNotCover {
        /// The first or the last place.
        quantity: Quantity,
        /// Its value.
        value: f64,
        /// Length of the beam.
        length: f64,
    },
    /// A foundation that would push a support upwards: the problem has no solution.
    #[error(
        "the foundation must not lie above a support, but its depth at the {support} support (x = {}) is {}; \
         no deflection satisfies the supports and the foundation",
        shown(*at),
        shown(*depth)
    )]
    AboveSupport {
        /// Which support.
        support: Support,
        /// Where it is.
        at: f64,
        /// Depth of the foundation there, negative.
        depth: f64,
    },
    /// Numbers that are finite by themselves and not together.
    #[error("`{quantity}` leads to numbers beyond the range of 64-bit floating point ({what} is {})", shown(*value))]
    Overflow {
        /// Where it shows.
        quantity: Quantity,
        /// Which derived number overflows.
        what: &'static str,
        /// What it came to.
        value: f64,
    },
    /// A grid without interior nodes.
    #[error("the number of intervals must be at least 2, but is {intervals}")]
    TooFewIntervals {
        /// The number asked for.
        intervals: usize,
    },
    /// A grid that there is no memory for.
    #[error("there is no memory for {intervals} intervals, which take {} MB", bytes / 1_000_000)]
    NoMemory {
        /// The number asked for.
        intervals: usize,
        /// Bytes that they take.
        bytes: usize,
    },
}

impl SceneError {
    /// The quantity that the error is about, if it is about a single one: a scene file uses it to find the line.
    #[must_use]
    pub fn quantity(&self) -> Option<Quantity> {
        match *self {
            Self::NotPositive { quantity, .. }
            | Self::NotFinite { quantity, .. }
            | Self::OutsideBeam { quantity, .. }
            | Self::EmptyLoad { quantity, .. }
            | Self::PointsRunBack { quantity, .. }
            | Self::ThreePointsAtOnePlace { quantity, .. }
            | Self::PointsDoNotCover { quantity, .. }
            | Self::Overflow { quantity, .. } => Some(quantity),
            Self::NoCoefficients | Self::TooFewPoints { .. } | Self::AboveSupport { .. } => Some(Quantity::Foundation),
            Self::TooFewIntervals { .. } | Self::NoMemory { .. } => None,
        }
    }
}

/// A number as a message has it: with a power of ten where a row of zeros would have to be counted.
fn shown(value: f64) -> String {
    let size = value.abs();
    if size == 0.0 || !value.is_finite() || (1e-5..1e16).contains(&size) {
        value.to_string()
    } else {
        format!("{value:e}")
    }
}

/// `value` if it is positive and finite.
pub(super) fn positive(quantity: Quantity, value: f64) -> Result<f64, SceneError> {
    // The comparison also refuses NaN.
    if 0.0 < value && value < f64::INFINITY { Ok(value) } else { Err(SceneError::NotPositive { quantity, value }) }
}

/// `value` if it is finite.
pub(super) fn finite(quantity: Quantity, value: f64) -> Result<f64, SceneError> {
    if value.is_finite() { Ok(value) } else { Err(SceneError::NotFinite { quantity, value }) }
}

/// `value` if it lies on a beam of length `length`.
pub(super) fn on_beam(quantity: Quantity, value: f64, length: f64) -> Result<f64, SceneError> {
    finite(quantity, value)?;
    if (0.0..=length).contains(&value) { Ok(value) } else { Err(SceneError::OutsideBeam { quantity, value, length }) }
}
