//! What can be wrong with a scene: the quantity, its value and what is required of it.

use super::balance::Unheld;
use super::quantity::{Profile, ProfileKey, Quantity};
use super::scale::Scale;
use super::written::{against, fitting, placed, shown};

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
    #[error("`{quantity}` must lie on the beam, between 0 and {}, but is {}", against(*length, *value), against(*value, *length))]
    OutsideBeam {
        /// Which place.
        quantity: Quantity,
        /// Its value.
        value: f64,
        /// Length of the beam.
        length: f64,
    },
    /// A line load that ends where it starts, or before.
    #[error("`{quantity}` must be greater than the start of the load, {}, but is {}", against(*from, *to), against(*to, *from))]
    EmptyLoad {
        /// The end of the load.
        quantity: Quantity,
        /// Where the load starts.
        from: f64,
        /// Where it ends.
        to: f64,
    },
    /// A polynomial without coefficients, or with so many that 64 bits do not keep the digits of their sum.
    #[error("`{}.polynomial` must have from 1 to {} coefficients, but has {count}; in place of more give points, or a survey", of.path(), super::polynomial::COEFFICIENTS)]
    Coefficients {
        /// Of which profile.
        of: Profile,
        /// How many there are, up to the last one that is not zero.
        count: usize,
    },
    /// A polyline of fewer than two points.
    #[error("{of} given by points needs at least 2 of them, but has {count}")]
    TooFewPoints {
        /// Which profile.
        of: Profile,
        /// How many there are.
        count: usize,
    },
    /// Points of a polyline that run backwards.
    #[error(
        "`{quantity}` must not be less than the place of the point before it, {}, but is {}",
        against(*previous, *value),
        against(*value, *previous)
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
    /// A polyline that does not reach from end to end of the beam.
    #[error("{of} given by points must reach from 0 to {}, but `{quantity}` is {}", against(*length, *value), against(*value, *length))]
    PointsDoNotCover {
        /// Which profile.
        of: Profile,
        /// The first or the last place.
        quantity: Quantity,
        /// Its value.
        value: f64,
        /// Length of the beam.
        length: f64,
    },
    /// Two supports at the same place, or so close together that the last digits of their places decide how they turn the beam.
    #[error(
        "`{quantity}` is {}, and another support is at x = {}: two supports must be more than {least:.1e} apart",
        against(*value, *other),
        against(*other, *value)
    )]
    SupportsTooClose {
        /// The one of them that is given later.
        quantity: Quantity,
        /// Where it is.
        value: f64,
        /// Where the other one is.
        other: f64,
        /// The distance that is too small still.
        least: f64,
    },
    /// A stiffness in steps without steps.
    #[error("`{of}.steps` needs at least one pair [x, stiffness], but has none")]
    NoSteps {
        /// Which stiffness.
        of: Quantity,
    },
    /// A negative stiffness of an elastic foundation.
    #[error("`{quantity}` must not be negative, but is {}; 0 leaves a gap without foundation", shown(*value))]
    NegativeGroundStiffness {
        /// Which number.
        quantity: Quantity,
        /// Its value.
        value: f64,
    },
    /// An elastic foundation whose stiffness is 0 from end to end.
    #[error("`{}` is 0 from end to end; leave out `[foundation]` if there is none", Quantity::GroundStiffness)]
    NoGroundAnywhere,
    /// A step of the bending stiffness, or a joint, that is not where it could be.
    #[error("`{quantity}` must {expected}, but is {}", shown(*value))]
    Misplaced {
        /// Which place.
        quantity: Quantity,
        /// Its value.
        value: f64,
        /// What is required of it.
        expected: &'static str,
    },
    /// A bending stiffness of a step that is not positive.
    #[error("`{quantity}` must be positive and finite, but is {}; a hinge is one of `beam.joints`", shown(*value))]
    StepNotPositive {
        /// Which number.
        quantity: Quantity,
        /// Its value.
        value: f64,
    },
    /// Two joints at one place.
    #[error("`{quantity}` is {}, and another joint is at x = {}", shown(*value), shown(*other))]
    JointsTooClose {
        /// The one of them that is given later.
        quantity: Quantity,
        /// Where it is.
        value: f64,
        /// Where the other one is.
        other: f64,
    },
    /// A joint where the beam is built in, or a support has a spring against turning.
    #[error(
        "`{quantity}` is {}, where a support holds the slope (`built_in` or `turning_stiffness`): give the joint a place beside the \
         support, on the side on which the beam turns",
        shown(*value)
    )]
    JointAtBuiltIn {
        /// Which joint.
        quantity: Quantity,
        /// Where it is.
        value: f64,
    },
    /// A couple at a joint.
    #[error("`{quantity}` is {}, where a joint is: give it a place beside the joint, on the side on which it acts", shown(*value))]
    CoupleAtJoint {
        /// Which couple.
        quantity: Quantity,
        /// Where it acts.
        value: f64,
    },
    /// Compression that the beam does not bear.
    #[error(transparent)]
    Unstable(#[from] super::Unstable),
    /// Something that does not know a part of the scene.
    #[error("{what} cannot compute {feature} yet")]
    NotKnown {
        /// What was asked for.
        what: &'static str,
        /// What it does not know.
        feature: &'static str,
    },
    /// A step in the own shape: an axis has none.
    #[error("`{quantity}` is the second point at x = {}: the axis of a beam has no step", shown(*value))]
    StepInShape {
        /// The second of the two points.
        quantity: Quantity,
        /// Where.
        value: f64,
    },
    /// A built-in support where the axis has a corner: its slope would be two.
    #[error(
        "the own shape must not have a corner at a built-in support, which holds the slope, but has one at x = {}",
        shown(*at)
    )]
    CornerAtBuiltIn {
        /// Where.
        at: f64,
    },
    /// A foundation that would push a support upwards: the problem has no solution.
    #[error(
        "the foundation must not lie above a support, but its depth at the support x = {} is {}, above the level {} of the \
         support: no deflection satisfies both on rigid ground; an elastic foundation (`stiffness`) may lie above a support",
        shown(*at),
        against(*depth, *level),
        against(*level, *depth)
    )]
    AboveSupport {
        /// Where the support is.
        at: f64,
        /// Depth of the foundation there.
        depth: f64,
        /// Depth of the support, greater.
        level: f64,
    },
    /// A support that only pushes, in the ground or level with it: the beam can never reach it.
    #[error(
        "a support with pushes_only must stand above the ground, but at x = {} its level is {} and the depth of the foundation {}: \
         rigid ground is in its way; in an elastic foundation (`stiffness`) it may stand",
        shown(*at),
        against(*level, *depth),
        against(*depth, *level)
    )]
    BearingInGround {
        /// Where the support is.
        at: f64,
        /// Depth of the foundation there.
        depth: f64,
        /// Depth of the support, not less.
        level: f64,
    },
    /// A support that only pushes and in which the beam is built in.
    #[error("the support at x = {} cannot both push only and be built in", shown(*at))]
    PushesBuiltIn {
        /// Its place.
        quantity: Quantity,
        /// Where it is.
        at: f64,
    },
    /// A support that gives and in which the beam is built in.
    #[error(
        "the support at x = {} cannot both give (`stiffness`) and be `built_in`: with `turning_stiffness` a spring holds the slope",
        shown(*at)
    )]
    GivesBuiltIn {
        /// Its place.
        quantity: Quantity,
        /// Where it is.
        at: f64,
    },
    /// A foundation that starts at the level of a built-in support and rises from the beam: the problem has no solution.
    #[error(
        "the foundation must not rise above a beam that is built in, but at the built-in support x = {}, where it is level with \
         the beam, its slope to the {side} of it is {}, and that of the beam is {}: no deflection satisfies both on rigid ground; an \
         elastic foundation (`stiffness`) may rise there",
        shown(*at),
        against(*slope, *held),
        against(*held, *slope)
    )]
    RisesAtBuiltIn {
        /// Where the support is.
        at: f64,
        /// On which side of it, `left` or `right`.
        side: &'static str,
        /// Slope `u'` of the foundation there.
        slope: f64,
        /// Slope of the axis of the beam there.
        held: f64,
    },
    /// A simple support in the bottom of a valley: the problem has no solution.
    #[error(
        "the foundation must not rise above the beam on both sides of a support, but at the simple support x = {}, where it is \
         level with the beam, its slope against that of the own shape is {} to the left and {} to the right of it: no deflection \
         satisfies both on rigid ground; an elastic foundation (`stiffness`) may rise there",
        shown(*at),
        against(slopes[0], slopes[1]),
        against(slopes[1], slopes[0])
    )]
    ValleyAtSupport {
        /// Where the support is.
        at: f64,
        /// Slopes `g'` of the gap to the left and to the right of it, the left one greater.
        slopes: [f64; 2],
    },
    /// What the supports leave free is not held by the loads and the ground either.
    #[error(transparent)]
    Unheld(#[from] Unheld),
    /// What is not there yet for ground that gives.
    #[error("{what} needs rigid ground, but `{}` is given", Quantity::GroundStiffness)]
    NeedsRigidGround {
        /// What was asked for.
        what: &'static str,
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
    /// What a grid needs a node for lies between its nodes.
    #[error("no node of {intervals} equal intervals lies on {} at x = {}; {}", placed(*quantity), shown(*at), fitting(*fits))]
    BetweenNodes {
        /// The supports, a joint, or a step of the bending stiffness.
        quantity: Quantity,
        /// Where it is.
        at: f64,
        /// The number of intervals asked for.
        intervals: usize,
        /// The least number that has a node at each of them, if it is not too large.
        fits: Option<usize>,
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
    /// What is wrong with a dimensionless scene on a grid, in the units of the scene.
    #[must_use]
    pub(crate) fn in_units_of(mut self, scale: &Scale) -> Self {
        if let Self::BetweenNodes { at, .. } = &mut self {
            *at *= scale.length;
        }
        if let Self::Unstable(of) = self { of.times(scale.force * scale.length / scale.depth).into() } else { self }
    }

    /// The quantity that the error is about, if it is about a single one: a scene file uses it to find the line.
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
