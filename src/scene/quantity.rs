//! The numbers of a scene by their names in the scene file, as messages print them.

use std::fmt;

/// A number of a scene, named as in the scene file. Indices count from 0, as in the arrays of the file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[expect(missing_docs, reason = "each variant is the key of the scene file that Display prints")]
pub enum Quantity {
    Length,
    BendingStiffness,
    /// Position of a step of the bending stiffness.
    StepAt(usize),
    /// The bending stiffness that begins at the step.
    StepStiffness(usize),
    JointAt(usize),
    JointStiffness(usize),
    /// The axial force.
    Tension,
    Uniform,
    LinearFrom(usize),
    LinearTo(usize),
    LinearStart(usize),
    LinearEnd(usize),
    PointAt(usize),
    PointForce(usize),
    CoupleAt(usize),
    CoupleMoment(usize),
    SupportAt(usize),
    SupportLevel(usize),
    SupportSlope(usize),
    SupportStiffness(usize),
    SupportTurningStiffness(usize),
    /// All supports of the beam.
    Supports,
    /// A number of a profile.
    Profile(Profile, ProfileKey),
    GroundStiffness,
    /// Position of a step of the foundation stiffness.
    GroundStepAt(usize),
    /// The foundation stiffness that begins at the step.
    GroundStepStiffness(usize),
    /// All loads together.
    TotalLoad,
}

/// A depth as a function of position: of the foundation, or of the axis of the unloaded beam.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Profile {
    /// `u(x)`, the key `foundation` of the scene file.
    Foundation,
    /// `w0(x)`, the key `beam.shape`.
    Shape,
}

impl Profile {
    /// The table in the scene file.
    #[must_use]
    pub(crate) fn path(self) -> &'static str {
        match self {
            Self::Foundation => "foundation",
            Self::Shape => "beam.shape",
        }
    }
}

impl fmt::Display for Profile {
    /// The name in a sentence.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Foundation => "a foundation",
            Self::Shape => "an own shape",
        })
    }
}

/// A number of a profile, named as in its table of the scene file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[expect(missing_docs, reason = "each variant is the key of the scene file that Display prints")]
pub enum ProfileKey {
    Depth,
    Coefficient(usize),
    Mean,
    Amplitude,
    Wavelength,
    Phase,
    /// Position of a point of the polyline, `points[i][0]`.
    PolylineX(usize),
    /// Depth of a point of the polyline, `points[i][1]`.
    PolylineDepth(usize),
    /// The profile as a whole.
    Whole,
}

/// The physical dimension of a number. Numbers of the same kind can be changed by the same amount.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Kind {
    /// A position, a depth or a level.
    Length,
    /// A force.
    Force,
    /// A force times a length.
    Moment,
    /// A force per length: a distributed load, or the stiffness of a support.
    Intensity,
    /// A slope, or an angle in radians.
    Angle,
    /// A force times the square of a length.
    BendingStiffness,
    /// A force per length of beam and per length of penetration.
    GroundStiffness,
    /// A length divided by this power of a length: a coefficient of a polynomial.
    Coefficient(usize),
}

impl Quantity {
    /// The dimension of the quantity; [`None`] if it is not a single number.
    #[must_use]
    pub(crate) fn kind(self) -> Option<Kind> {
        Some(match self {
            Self::BendingStiffness | Self::StepStiffness(_) => Kind::BendingStiffness,
            Self::GroundStiffness | Self::GroundStepStiffness(_) => Kind::GroundStiffness,
            Self::Uniform | Self::LinearStart(_) | Self::LinearEnd(_) | Self::SupportStiffness(_) => Kind::Intensity,
            Self::PointForce(_) | Self::Tension => Kind::Force,
            Self::CoupleMoment(_) | Self::JointStiffness(_) | Self::SupportTurningStiffness(_) => Kind::Moment,
            Self::SupportSlope(_) | Self::Profile(_, ProfileKey::Phase) => Kind::Angle,
            Self::Profile(_, ProfileKey::Coefficient(i)) if 0 < i => Kind::Coefficient(i),
            Self::Supports | Self::TotalLoad | Self::Profile(_, ProfileKey::Whole) => return None,
            Self::Length
            | Self::StepAt(_)
            | Self::GroundStepAt(_)
            | Self::JointAt(_)
            | Self::LinearFrom(_)
            | Self::LinearTo(_)
            | Self::PointAt(_)
            | Self::CoupleAt(_)
            | Self::SupportAt(_)
            | Self::SupportLevel(_)
            | Self::Profile(..) => Kind::Length,
        })
    }
}

impl fmt::Display for Quantity {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Length => write!(f, "beam.length"),
            Self::BendingStiffness => write!(f, "beam.bending_stiffness"),
            Self::StepAt(i) => write!(f, "beam.bending_stiffness.steps[{i}][0]"),
            Self::StepStiffness(i) => write!(f, "beam.bending_stiffness.steps[{i}][1]"),
            Self::JointAt(i) => write!(f, "beam.joints[{i}].at"),
            Self::JointStiffness(i) => write!(f, "beam.joints[{i}].stiffness"),
            Self::Tension => write!(f, "beam.tension"),
            Self::Uniform => write!(f, "load.uniform"),
            Self::LinearFrom(i) => write!(f, "load.linear[{i}].from"),
            Self::LinearTo(i) => write!(f, "load.linear[{i}].to"),
            Self::LinearStart(i) => write!(f, "load.linear[{i}].start"),
            Self::LinearEnd(i) => write!(f, "load.linear[{i}].end"),
            Self::PointAt(i) => write!(f, "load.point[{i}].at"),
            Self::PointForce(i) => write!(f, "load.point[{i}].force"),
            Self::CoupleAt(i) => write!(f, "load.couple[{i}].at"),
            Self::CoupleMoment(i) => write!(f, "load.couple[{i}].moment"),
            Self::SupportAt(i) => write!(f, "beam.supports[{i}].at"),
            Self::SupportLevel(i) => write!(f, "beam.supports[{i}].level"),
            Self::SupportSlope(i) => write!(f, "beam.supports[{i}].slope"),
            Self::SupportStiffness(i) => write!(f, "beam.supports[{i}].stiffness"),
            Self::SupportTurningStiffness(i) => write!(f, "beam.supports[{i}].turning_stiffness"),
            Self::Supports => write!(f, "beam.supports"),
            Self::Profile(of, key) => {
                f.write_str(of.path())?;
                match key {
                    ProfileKey::Depth => write!(f, ".depth"),
                    ProfileKey::Coefficient(i) => write!(f, ".polynomial[{i}]"),
                    ProfileKey::Mean => write!(f, ".cosine.mean"),
                    ProfileKey::Amplitude => write!(f, ".cosine.amplitude"),
                    ProfileKey::Wavelength => write!(f, ".cosine.wavelength"),
                    ProfileKey::Phase => write!(f, ".cosine.phase"),
                    ProfileKey::PolylineX(i) => write!(f, ".points[{i}][0]"),
                    ProfileKey::PolylineDepth(i) => write!(f, ".points[{i}][1]"),
                    ProfileKey::Whole => Ok(()),
                }
            }
            Self::GroundStiffness => write!(f, "foundation.stiffness"),
            Self::GroundStepAt(i) => write!(f, "foundation.stiffness.steps[{i}][0]"),
            Self::GroundStepStiffness(i) => write!(f, "foundation.stiffness.steps[{i}][1]"),
            Self::TotalLoad => write!(f, "load"),
        }
    }
}
