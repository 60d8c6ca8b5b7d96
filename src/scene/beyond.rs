//! Point loads beyond the beam: the axles of a train before a sweep brings them onto it, or after it has left.

use super::{PointLoad, Scene};

impl Scene {
    /// Takes the loads that lie beyond a beam of this length out of a list: in their place it has forces of zero. A number that is not
    /// finite stays where it is, to be refused.
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

    /// The indices of the point loads beyond the beam. Only a scene that was read for a sweep has any
    /// ([`parse_train`](super::file::parse_train)); there they are no loads.
    pub fn loads_beyond(&self) -> impl Iterator<Item = usize> + '_ {
        self.beyond.iter().map(|(i, _)| *i)
    }

    /// All point loads, with those beyond the beam.
    #[must_use]
    pub fn point_loads(&self) -> Vec<PointLoad> {
        let mut point = self.load.point().to_vec();
        for &(i, load) in &self.beyond {
            point[i] = load;
        }
        point
    }
}
