//! The scene of each value. A point load whose place is beyond the beam is no load: a train comes onto the beam and leaves it.

use super::{Moves, Sweep};
use crate::scene::{Quantity, Scene, SceneError};

impl Sweep<'_> {
    /// The scene with a value.
    ///
    /// # Errors
    ///
    /// Those of [`Scene::with_number`].
    pub fn scene(&self, value: f64) -> Result<Scene, SceneError> {
        let moved = self.moved(value);
        let beyond = self.beyond(&moved);
        let on_beam = moved.into_iter().filter(|(quantity, _)| !beyond.contains(quantity));
        // What is no load has no force, whatever it would have, and no place that the scene does not have either.
        let none = beyond.iter().filter_map(|&quantity| match quantity {
            Quantity::PointAt(i) => Some((Quantity::PointForce(i), 0.0)),
            _ => None,
        });
        let nowhere = self.scene.loads_beyond().map(Quantity::PointAt).filter(|quantity| beyond.contains(quantity));
        self.scene.with_numbers(on_beam.chain(none).chain(nowhere.map(|quantity| (quantity, 0.0))))
    }

    /// The numbers that are varied, with what they are for a value.
    fn moved(&self, value: f64) -> Vec<(Quantity, f64)> {
        let by = value - self.scene.number(self.quantity).unwrap_or_default();
        let with = self.with.iter().map(|&Moves { quantity, number, sign }| (quantity, number + sign * by));
        std::iter::once((self.quantity, value)).chain(with).collect()
    }

    /// The places of loads that are beyond the beam, of those that are moved and of those that stay where they are.
    fn beyond(&self, moved: &[(Quantity, f64)]) -> Vec<Quantity> {
        let length = self.scene.beam().length();
        let is_beyond = |(quantity, at): &&(Quantity, f64)| {
            matches!(quantity, Quantity::PointAt(_)) && !(0.0..=length).contains(at)
        };
        let stays = |quantity: &Quantity| moved.iter().all(|(other, _)| other != quantity);
        let staying = self.scene.loads_beyond().map(Quantity::PointAt).filter(stays);
        moved.iter().filter(is_beyond).map(|(quantity, _)| *quantity).chain(staying).collect()
    }

    /// True if the same loads are on the beam for two values.
    pub(super) fn has_same_loads(&self, a: f64, b: f64) -> bool {
        self.beyond(&self.moved(a)) == self.beyond(&self.moved(b))
    }
}
