//! What a message about a scene calls its numbers: as in the scene file.

use std::fmt;

/// A number of a scene, named as in the scene file. Indices count from 0, as in the file's arrays.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[expect(missing_docs, reason = "each variant is the key of the scene file that Display prints")]
pub enum Quantity {
    Length,
    BendingStiffness,
    Uniform,
    LinearFrom(usize),
    LinearTo(usize),
    LinearStart(usize),
    LinearEnd(usize),
    PointAt(usize),
    PointForce(usize),
    Depth,
    Coefficient(usize),
    Mean,
    Amplitude,
    Wavelength,
    Phase,
    /// Place of a point of the polyline, `foundation.points[i][0]`.
    PolylineX(usize),
    /// Depth of a point of the polyline, `foundation.points[i][1]`.
    PolylineDepth(usize),
    /// All loads together.
    TotalLoad,
    /// The foundation as a whole.
    Foundation,
}

impl fmt::Display for Quantity {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Length => write!(f, "beam.length"),
            Self::BendingStiffness => write!(f, "beam.bending_stiffness"),
            Self::Uniform => write!(f, "load.uniform"),
            Self::LinearFrom(i) => write!(f, "load.linear[{i}].from"),
            Self::LinearTo(i) => write!(f, "load.linear[{i}].to"),
            Self::LinearStart(i) => write!(f, "load.linear[{i}].start"),
            Self::LinearEnd(i) => write!(f, "load.linear[{i}].end"),
            Self::PointAt(i) => write!(f, "load.point[{i}].at"),
            Self::PointForce(i) => write!(f, "load.point[{i}].force"),
            Self::Depth => write!(f, "foundation.depth"),
            Self::Coefficient(i) => write!(f, "foundation.polynomial[{i}]"),
            Self::Mean => write!(f, "foundation.cosine.mean"),
            Self::Amplitude => write!(f, "foundation.cosine.amplitude"),
            Self::Wavelength => write!(f, "foundation.cosine.wavelength"),
            Self::Phase => write!(f, "foundation.cosine.phase"),
            Self::PolylineX(i) => write!(f, "foundation.points[{i}][0]"),
            Self::PolylineDepth(i) => write!(f, "foundation.points[{i}][1]"),
            Self::TotalLoad => write!(f, "load"),
            Self::Foundation => write!(f, "foundation"),
        }
    }
}

/// One of the two supports.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Support {
    /// At `x = 0`.
    Left,
    /// At `x = l`.
    Right,
}

impl fmt::Display for Support {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Left => "left",
            Self::Right => "right",
        })
    }
}
