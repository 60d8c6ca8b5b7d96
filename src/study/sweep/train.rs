//! The scene for each value of a sweep. A point load beyond the beam does not act, so a train can come onto the beam and leave it.

use super::{Moves, Sweep};
use crate::scene::{Quantity, Scene, SceneError};

impl Sweep<'_> {
    /// The scene with this value of the varied number.
    ///
    /// # Errors
    ///
    /// The errors of [`Scene::with_number`].
    pub fn scene(&self, value: f64) -> Result<Scene, SceneError> {
        let moved = self.moved(value);
        let beyond = self.beyond(&moved);
        let on_beam = moved.into_iter().filter(|(quantity, _)| !beyond.contains(quantity));
        // A load that does not act has force zero, and position 0 if the scene has it beyond the beam.
        let none = beyond.iter().filter_map(|&quantity| match quantity {
            Quantity::PointAt(i) => Some((Quantity::PointForce(i), 0.0)),
            _ => None,
        });
        let nowhere = self.scene.loads_beyond().map(Quantity::PointAt).filter(|quantity| beyond.contains(quantity));
        self.scene.with_numbers(on_beam.chain(none).chain(nowhere.map(|quantity| (quantity, 0.0))))
    }

    /// The varied numbers with their values for a value of the sweep.
    fn moved(&self, value: f64) -> Vec<(Quantity, f64)> {
        let by = value - self.scene.number(self.quantity).unwrap_or_default();
        let with = self.with.iter().map(|&Moves { quantity, number, sign }| (quantity, number + sign * by));
        std::iter::once((self.quantity, value)).chain(with).collect()
    }

    /// The position quantities of all loads beyond the beam, both those that move and those that stay.
    fn beyond(&self, moved: &[(Quantity, f64)]) -> Vec<Quantity> {
        let length = self.scene.beam().length();
        let is_beyond = |(quantity, at): &&(Quantity, f64)| {
            matches!(quantity, Quantity::PointAt(_)) && !(0.0..=length).contains(at)
        };
        let stays = |quantity: &Quantity| moved.iter().all(|(other, _)| other != quantity);
        let staying = self.scene.loads_beyond().map(Quantity::PointAt).filter(stays);
        moved.iter().filter(is_beyond).map(|(quantity, _)| *quantity).chain(staying).collect()
    }

    /// Whether the same loads are on the beam for two values.
    pub(super) fn has_same_loads(&self, a: f64, b: f64) -> bool {
        self.beyond(&self.moved(a)) == self.beyond(&self.moved(b))
    }
}
