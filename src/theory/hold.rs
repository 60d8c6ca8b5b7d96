//! How a span begins and ends: where, and what is given there.

/// How a span begins or ends.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Hold {
    /// `h` and `h'` are given: a contact, or a support at which the beam is clamped.
    Clamped {
        /// `h`.
        height: f64,
        /// `h'`.
        slope: f64,
        /// `v'`, where it is that which is given: at an edge. Beside a cliff `u' − h'` would lose its digits.
        turn: Option<f64>,
        /// `v`, where a break of the profile is not as deep as what `h` counts from: at the edge of a deep step.
        level: Option<f64>,
    },
    /// `h` and `h''` are given: a simple support, `v = v'' = 0`.
    Hinged {
        /// `h`.
        height: f64,
        /// `h''`.
        curvature: f64,
    },
}

impl Hold {
    /// On a smooth piece of the profile, or clamped to it: `h = h' = 0`.
    pub(super) const RESTING: Self = Self::Clamped { height: 0.0, slope: 0.0, turn: None, level: None };

    /// The same for `v = u − h`, beside a profile that has been moved up by `h`.
    pub(super) fn of_beam(self, profile: &[f64; 4]) -> Self {
        match self {
            Self::Clamped { slope, turn, level, .. } => {
                Self::Clamped { height: profile[0], slope: turn.unwrap_or(profile[1] - slope), turn, level }
            }
            Self::Hinged { curvature, .. } => Self::Hinged { height: profile[0], curvature: profile[2] - curvature },
        }
    }

    /// `v`, beside a profile at `depth`.
    pub(super) fn level(self, depth: f64) -> f64 {
        match self {
            Self::Clamped { level: Some(level), .. } => level,
            _ => depth - self.height(),
        }
    }

    /// `h`.
    pub(super) fn height(self) -> f64 {
        match self {
            Self::Clamped { height, .. } | Self::Hinged { height, .. } => height,
        }
    }
}

/// One end of a span: where, in which cell, and how it is held.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct End {
    /// Where.
    pub(super) x: f64,
    /// What its place is beyond `x`.
    pub(super) rest: f64,
    /// The cell of the span that ends there.
    pub(super) cell: usize,
    /// How it is held.
    pub(super) hold: Hold,
}

impl End {
    /// An end that rests on a smooth piece of the profile.
    pub(super) fn resting(x: f64, cell: usize) -> Self {
        Self { x, rest: 0.0, cell, hold: Hold::RESTING }
    }
}
