//! Depths and loads whose sign is probably that of the other convention. They are valid, so they are only named.

use std::fmt;

use super::written::as_written;
use super::{Foundation, Scene};

/// A sign that a user of the other convention would write.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum DoubtfulSign {
    /// The whole foundation lies above the line of depth 0.
    Depths {
        /// Its greatest depth, negative \[length\].
        greatest: f64,
    },
    /// Every load acts upwards, away from what the beam could touch.
    Loads,
}

impl Scene {
    /// Signs of depths and loads that are probably those of the other convention.
    #[must_use]
    pub fn doubtful_signs(&self) -> Vec<DoubtfulSign> {
        let beam = &self.beam;
        let supports = beam.supports().iter().chain(beam.bearings()).chain(beam.springs());
        // Whoever gives a shape or negative levels as well has moved the line of depth 0.
        let is_moved = beam.shape().is_some() || supports.into_iter().any(|support| support.level < 0.0);
        let greatest = self.foundation().and_then(greatest_depth).filter(|greatest| *greatest < 0.0 && !is_moved);
        let load = &self.load;
        let spread = load.linear().iter().flat_map(|part| [part.start, part.end]);
        let all = || spread.clone().chain(load.point().iter().map(|point| point.force)).chain([load.uniform()]);
        let is_lifted =
            self.has_obstacle() && load.couple().is_empty() && all().all(|q| q <= 0.0) && all().any(|q| q < 0.0);
        let depths = greatest.map(|greatest| DoubtfulSign::Depths { greatest });
        depths.into_iter().chain(is_lifted.then_some(DoubtfulSign::Loads)).collect()
    }
}

/// The greatest depth of a profile, where it is known without computation.
fn greatest_depth(profile: &Foundation) -> Option<f64> {
    match profile {
        Foundation::Flat { depth } => Some(*depth),
        Foundation::Cosine { mean, amplitude, .. } => Some(mean + amplitude.abs()),
        Foundation::Polyline { points } => points.iter().map(|point| point[1]).max_by(f64::total_cmp),
        Foundation::Polynomial { coefficients } => {
            coefficients.first().copied().filter(|_| coefficients.iter().all(|c| *c <= 0.0))
        }
    }
}

impl fmt::Display for DoubtfulSign {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::Depths { greatest } => write!(
                f,
                "every depth of `foundation` is negative, at most {}: the foundation lies above the line of depth 0 everywhere. Depths \
                 are positive downwards, so elevations have to change their signs",
                as_written(greatest)
            ),
            Self::Loads => write!(
                f,
                "every load is negative and acts upwards, away from the foundation and from compression-only supports. Loads are positive \
                 downwards"
            ),
        }
    }
}
