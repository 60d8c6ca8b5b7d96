//! Everything that can be wrong with a scene: the quantity, its value and the requirement.

use super::balance::Unheld;
use super::quantity::{Profile, ProfileKey, Quantity};
use super::scale::Scale;
use super::written::{against, as_written, fitting, placed};

/// The reason why a scene was rejected.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum SceneError {
    /// A number must be positive and is not.
    #[error("`{quantity}` must be positive and finite, but is {}", as_written(*value))]
    NotPositive {
        /// The quantity.
        quantity: Quantity,
        /// Its value.
        value: f64,
    },
    /// A number is NaN or infinite.
    #[error("`{quantity}` must be finite, but is {}", as_written(*value))]
    NotFinite {
        /// The quantity.
        quantity: Quantity,
        /// Its value.
        value: f64,
    },
    /// A position outside the beam.
    #[error("`{quantity}` must lie on the beam, between 0 and {}, but is {}", against(*length, *value), against(*value, *length))]
    OutsideBeam {
        /// The quantity.
        quantity: Quantity,
        /// Its value.
        value: f64,
        /// Length of the beam.
        length: f64,
    },
    /// A line load whose end is not to the right of its start.
    #[error("`{quantity}` must be greater than the start of the load, {}, but is {}", against(*from, *to), against(*to, *from))]
    EmptyLoad {
        /// The quantity that gives the end of the load.
        quantity: Quantity,
        /// Start of the load.
        from: f64,
        /// End of the load.
        to: f64,
    },
    /// A polynomial without coefficients, or with so many that their sum loses its digits in 64-bit arithmetic.
    #[error("`{}.polynomial` must have from 1 to {} coefficients, but has {count}; in place of more give points, or a survey", of.path(), super::polynomial::COEFFICIENTS)]
    Coefficients {
        /// The profile.
        of: Profile,
        /// Number of coefficients up to the last nonzero one.
        count: usize,
    },
    /// A polyline with fewer than two points.
    #[error("{of} given by points needs at least 2 of them, but has {count}")]
    TooFewPoints {
        /// The profile.
        of: Profile,
        /// Number of points.
        count: usize,
    },
    /// The positions of a polyline decrease.
    #[error(
        "`{quantity}` must not be less than the place of the point before it, {}, but is {}",
        against(*previous, *value),
        against(*value, *previous)
    )]
    PointsRunBack {
        /// The quantity that is too small.
        quantity: Quantity,
        /// Its value.
        value: f64,
        /// The position of the point before it.
        previous: f64,
    },
    /// More than two points of a polyline at the same position.
    #[error("`{quantity}` is the third point at x = {}: two points make a step, more have no meaning", as_written(*value))]
    ThreePointsAtOnePlace {
        /// The quantity of the third point.
        quantity: Quantity,
        /// The position.
        value: f64,
    },
    /// A polyline that does not reach from end to end of the beam.
    #[error("{of} given by points must reach from 0 to {}, but `{quantity}` is {}", against(*length, *value), against(*value, *length))]
    PointsDoNotCover {
        /// The profile.
        of: Profile,
        /// The first or the last position of the polyline.
        quantity: Quantity,
        /// Its value.
        value: f64,
        /// Length of the beam.
        length: f64,
    },
    /// Two supports so close together that rounding of their positions would decide the slope of the beam.
    #[error(
        "`{quantity}` is {}, and another support is at x = {}: two supports must be more than {least:.1e} apart",
        against(*value, *other),
        against(*other, *value)
    )]
    SupportsTooClose {
        /// The position that is given later.
        quantity: Quantity,
        /// Its value.
        value: f64,
        /// Position of the other support.
        other: f64,
        /// The greatest distance that is still too small.
        least: f64,
    },
    /// A stiffness in steps without steps.
    #[error("`{of}.steps` needs at least one pair [x, stiffness], but has none")]
    NoSteps {
        /// The stiffness.
        of: Quantity,
    },
    /// A negative stiffness of an elastic foundation.
    #[error("`{quantity}` must not be negative, but is {}; 0 leaves a gap without foundation", as_written(*value))]
    NegativeGroundStiffness {
        /// The quantity.
        quantity: Quantity,
        /// Its value.
        value: f64,
    },
    /// An elastic foundation whose stiffness is 0 from end to end.
    #[error("`{}` is 0 from end to end; leave out `[foundation]` if there is none", Quantity::GroundStiffness)]
    NoGroundAnywhere,
    /// A step of a stiffness, or a joint, at a position that is not allowed.
    #[error("`{quantity}` must {expected}, but is {}", as_written(*value))]
    Misplaced {
        /// The quantity that gives the position.
        quantity: Quantity,
        /// Its value.
        value: f64,
        /// The requirement.
        expected: &'static str,
    },
    /// The bending stiffness of a step is not positive and finite.
    #[error("`{quantity}` must be positive and finite, but is {}; a hinge is one of `beam.joints`", as_written(*value))]
    StepNotPositive {
        /// The quantity.
        quantity: Quantity,
        /// Its value.
        value: f64,
    },
    /// Two joints at the same position.
    #[error("`{quantity}` is {}, and another joint is at x = {}", as_written(*value), as_written(*other))]
    JointsTooClose {
        /// The position that is given later.
        quantity: Quantity,
        /// Its value.
        value: f64,
        /// Position of the other joint.
        other: f64,
    },
    /// A joint at a support that restrains rotation, rigidly or with a spring.
    #[error(
        "`{quantity}` is {}, where a support holds the slope (`built_in` or `turning_stiffness`): give the joint a place beside the \
         support, on the side on which the beam turns",
        as_written(*value)
    )]
    JointAtBuiltIn {
        /// The position of the joint.
        quantity: Quantity,
        /// Its value.
        value: f64,
    },
    /// A couple at a joint.
    #[error("`{quantity}` is {}, where a joint is: give it a place beside the joint, on the side on which it acts", as_written(*value))]
    CoupleAtJoint {
        /// The position of the couple.
        quantity: Quantity,
        /// Its value.
        value: f64,
    },
    /// Compression under which the beam is not stable.
    #[error(transparent)]
    Unstable(#[from] super::Unstable),
    /// A feature of the scene that a computation does not support.
    #[error("{what} cannot compute {feature} yet")]
    NotKnown {
        /// The computation.
        what: &'static str,
        /// The feature.
        feature: &'static str,
    },
    /// A step in the initial shape: the axis of a beam is continuous.
    #[error("`{quantity}` is the second point at x = {}: the axis of a beam has no step", as_written(*value))]
    StepInShape {
        /// The position of the second of the two points.
        quantity: Quantity,
        /// Its value.
        value: f64,
    },
    /// A corner of the axis at a support that prescribes the slope: the slope is not unique there.
    #[error(
        "the own shape must not have a corner at a built-in support, which holds the slope, but has one at x = {}",
        as_written(*at)
    )]
    CornerAtBuiltIn {
        /// Position of the support.
        at: f64,
    },
    /// A rigid foundation above a support: the problem has no solution.
    #[error(
        "the foundation must not lie above a support, but its depth at the support x = {} is {}, above the level {} of the \
         support: no deflection satisfies both on rigid ground; an elastic foundation (`stiffness`) may lie above a support",
        as_written(*at),
        against(*depth, *level),
        against(*level, *depth)
    )]
    AboveSupport {
        /// Position of the support.
        at: f64,
        /// Depth of the foundation there.
        depth: f64,
        /// Level of the support, deeper than the foundation.
        level: f64,
    },
    /// A compression-only support at or below the surface of a rigid foundation: the beam can never reach it.
    #[error(
        "a support with pushes_only must stand above the ground, but at x = {} its level is {} and the depth of the foundation {}: \
         rigid ground is in its way; in an elastic foundation (`stiffness`) it may stand",
        as_written(*at),
        against(*level, *depth),
        against(*depth, *level)
    )]
    BearingInGround {
        /// Position of the support.
        at: f64,
        /// Depth of the foundation there.
        depth: f64,
        /// Level of the support, at least as deep.
        level: f64,
    },
    /// A built-in support that is also compression-only.
    #[error("the support at x = {} cannot both push only and be built in", as_written(*at))]
    PushesBuiltIn {
        /// The position of the support.
        quantity: Quantity,
        /// Its value.
        at: f64,
    },
    /// A built-in support that is also elastic.
    #[error(
        "the support at x = {} cannot both give (`stiffness`) and be `built_in`: with `turning_stiffness` a spring holds the slope",
        as_written(*at)
    )]
    GivesBuiltIn {
        /// The position of the support.
        quantity: Quantity,
        /// Its value.
        at: f64,
    },
    /// A rigid foundation that begins at the level of a built-in support and rises above the beam: the problem has no solution.
    #[error(
        "the foundation must not rise above a beam that is built in, but at the built-in support x = {}, where it is level with \
         the beam, its slope to the {side} of it is {}, and that of the beam is {}: no deflection satisfies both on rigid ground; an \
         elastic foundation (`stiffness`) may rise there",
        as_written(*at),
        against(*slope, *held),
        against(*held, *slope)
    )]
    RisesAtBuiltIn {
        /// Position of the support.
        at: f64,
        /// The side, `left` or `right`.
        side: &'static str,
        /// Slope `u'` of the foundation on this side.
        slope: f64,
        /// Slope of the axis that the support prescribes.
        held: f64,
    },
    /// A simple support at the lowest point of a valley of the rigid foundation: the problem has no solution.
    #[error(
        "the foundation must not rise above the beam on both sides of a support, but at the simple support x = {}, where it is \
         level with the beam, its slope against that of the own shape is {} to the left and {} to the right of it: no deflection \
         satisfies both on rigid ground; an elastic foundation (`stiffness`) may rise there",
        as_written(*at),
        against(slopes[0], slopes[1]),
        against(slopes[1], slopes[0])
    )]
    ValleyAtSupport {
        /// Position of the support.
        at: f64,
        /// Slopes `g'` of the gap to the left and to the right of it; the left one is greater.
        slopes: [f64; 2],
    },
    /// Loads and foundation do not balance the motions that the supports leave free.
    #[error(transparent)]
    Unheld(#[from] Unheld),
    /// A computation that does not support an elastic foundation.
    #[error("{what} needs rigid ground, but `{}` is given", Quantity::GroundStiffness)]
    NeedsRigidGround {
        /// The computation.
        what: &'static str,
    },
    /// Finite numbers from which a derived number overflows.
    #[error("`{quantity}` leads to numbers beyond the range of 64-bit floating point ({what} is {})", as_written(*value))]
    Overflow {
        /// The quantity that the message names.
        quantity: Quantity,
        /// The derived number.
        what: &'static str,
        /// The value of the derived number.
        value: f64,
    },
    /// A position that needs a node of its own has none on the grid.
    #[error("no node of {intervals} equal intervals lies on {} at x = {}; {}", placed(*quantity), as_written(*at), fitting(*fits))]
    BetweenNodes {
        /// The position of a support, a joint or a step of the bending stiffness.
        quantity: Quantity,
        /// Its value.
        at: f64,
        /// The requested number of intervals.
        intervals: usize,
        /// The smallest number of intervals with a node at all of these positions; [`None`] above a limit.
        fits: Option<usize>,
    },
    /// A grid without interior nodes.
    #[error("the number of intervals must be at least 2, but is {intervals}")]
    TooFewIntervals {
        /// The requested number of intervals.
        intervals: usize,
    },
    /// A grid that exceeds the available memory.
    #[error("there is no memory for {intervals} intervals, which take {} MB", bytes / 1_000_000)]
    NoMemory {
        /// The requested number of intervals.
        intervals: usize,
        /// Required memory in bytes.
        bytes: usize,
    },
}

impl SceneError {
    /// Converts an error of a dimensionless scene on a grid to the units of the scene.
    #[must_use]
    pub(crate) fn in_units_of(mut self, scale: &Scale) -> Self {
        if let Self::BetweenNodes { at, .. } = &mut self {
            *at *= scale.length;
        }
        if let Self::Unstable(of) = self { of.times(scale.force * scale.length / scale.depth).into() } else { self }
    }

    /// The quantity that the error concerns, if there is a single one. A scene file uses it to find the line.
    #[must_use]
    pub(crate) fn quantity(&self) -> Option<Quantity> {
        let whole = |of| Some(Quantity::Profile(of, ProfileKey::Whole));
        match *self {
            Self::NotPositive { quantity, .. }
            | Self::NotFinite { quantity, .. }
            | Self::OutsideBeam { quantity, .. }
            | Self::EmptyLoad { quantity, .. }
            | Self::PointsRunBack { quantity, .. }
            | Self::ThreePointsAtOnePlace { quantity, .. }
            | Self::PointsDoNotCover { quantity, .. }
            | Self::SupportsTooClose { quantity, .. }
            | Self::StepInShape { quantity, .. }
            | Self::Misplaced { quantity, .. }
            | Self::StepNotPositive { quantity, .. }
            | Self::NegativeGroundStiffness { quantity, .. }
            | Self::JointsTooClose { quantity, .. }
            | Self::JointAtBuiltIn { quantity, .. }
            | Self::CoupleAtJoint { quantity, .. }
            | Self::PushesBuiltIn { quantity, .. }
            | Self::GivesBuiltIn { quantity, .. }
            | Self::NoSteps { of: quantity }
            | Self::BetweenNodes { quantity, .. }
            | Self::Overflow { quantity, .. } => Some(quantity),
            Self::Coefficients { of, .. } | Self::TooFewPoints { of, .. } => whole(of),
            Self::AboveSupport { .. } | Self::BearingInGround { .. } => whole(Profile::Foundation),
            Self::RisesAtBuiltIn { .. } | Self::ValleyAtSupport { .. } => whole(Profile::Foundation),
            Self::CornerAtBuiltIn { .. } => whole(Profile::Shape),
            Self::Unstable(_) => Some(Quantity::Tension),
            Self::NeedsRigidGround { .. } | Self::NoGroundAnywhere => Some(Quantity::GroundStiffness),
            Self::Unheld(_) => Some(Quantity::Supports),
            Self::TooFewIntervals { .. } | Self::NoMemory { .. } | Self::NotKnown { .. } => None,
        }
    }
}

/// `value` if it is positive and finite.
pub(super) fn positive(quantity: Quantity, value: f64) -> Result<f64, SceneError> {
    // The comparison also rejects NaN.
    if 0.0 < value && value < f64::INFINITY { Ok(value) } else { Err(SceneError::NotPositive { quantity, value }) }
}

/// `value` if it is finite.
pub(super) fn finite(quantity: Quantity, value: f64) -> Result<f64, SceneError> {
    if value.is_finite() { Ok(value) } else { Err(SceneError::NotFinite { quantity, value }) }
}

/// `value` if it is a position on a beam of length `length`.
pub(super) fn on_beam(quantity: Quantity, value: f64, length: f64) -> Result<f64, SceneError> {
    finite(quantity, value)?;
    if (0.0..=length).contains(&value) { Ok(value) } else { Err(SceneError::OutsideBeam { quantity, value, length }) }
}
