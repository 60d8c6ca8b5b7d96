//! Point loads beyond the beam: axles of a train before they reach the beam in a sweep, or after they have left it.

use super::{PointLoad, Scene};

impl Scene {
    /// Removes the loads beyond a beam of this length from a list and leaves forces of zero in their place. A number that is not
    /// finite stays in the list, so that it is rejected later.
    pub(super) fn taken_beyond(point: &mut [PointLoad], length: f64) -> Vec<(usize, PointLoad)> {
        let is_beyond =
            |load: &PointLoad| load.at.is_finite() && load.force.is_finite() && !(0.0..=length).contains(&load.at);
        let beyond: Vec<_> = point.iter().copied().enumerate().filter(|(_, load)| is_beyond(load)).collect();
        for &(i, _) in &beyond {
            point[i] = PointLoad { at: 0.0, force: 0.0 };
        }
        beyond
    }

    /// The same scene with these loads beyond the beam.
    pub(super) fn with_loads_beyond(self, beyond: Vec<(usize, PointLoad)>) -> Self {
        Self { beyond, ..self }
    }

    /// The indices of the point loads beyond the beam. Only a scene that was read for a sweep can have any
    /// ([`parse_train`](super::file::parse_train)). They do not act on the beam.
    pub fn loads_beyond(&self) -> impl Iterator<Item = usize> + '_ {
        self.beyond.iter().map(|(i, _)| *i)
    }

    /// All point loads, including those beyond the beam.
    #[must_use]
    pub fn point_loads(&self) -> Vec<PointLoad> {
        let mut point = self.load.point().to_vec();
        for &(i, load) in &self.beyond {
            point[i] = load;
        }
        point
    }
}
