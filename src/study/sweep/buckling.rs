//! The events of a sweep at which the compression reaches the buckling load of the beam.

use super::events::Event;
use super::{Sweep, last};
use crate::scene::{SceneError, Unstable};

impl Sweep<'_> {
    /// Whether there is no answer for a value because the beam buckles.
    pub(super) fn buckles(&self, value: f64) -> bool {
        let unstable = |error| matches!(error, SceneError::Unstable(Unstable::Buckles { .. }));
        self.scene(value).and_then(|scene| scene.scaled()).err().is_some_and(unstable)
    }

    /// The events at which the beam begins or ceases to buckle, between consecutive values of which only one carries its compression.
    pub(super) fn buckling(&self) -> Vec<Event> {
        let bears = |value: f64| self.scene(value).and_then(|scene| scene.scaled()).is_ok();
        let values: Vec<(f64, bool)> = self.values().map(|value| (value, bears(value))).collect();
        let between = |two: &[(f64, bool)]| {
            let (with, without, what) = match [two[0], two[1]] {
                [(before, true), (after, false)] => (before, after, "the beam buckles"),
                [(before, false), (after, true)] => (after, before, "the beam no longer buckles"),
                _ => return None,
            };
            self.buckles(without).then_some(())?;
            let (value, ()) = last((with, ()), without, u32::MAX, |_, _| false, |value, ()| bears(value).then_some(()));
            Some(Event { value, what: what.to_owned(), uncertainty: 0.0 })
        };
        values.windows(2).filter_map(between).collect()
    }
}
