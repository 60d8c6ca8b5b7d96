//! Contact forces that somebody computed.

use crate::scene::Scale;
use crate::state::Contact;

/// Forces of the foundation on the beam, at places, upwards; those that pull are cut off.
#[derive(Debug, Clone, PartialEq)]
pub struct ContactLoad {
    /// Places and forces, from left to right, one at a place, all positive.
    pub(super) pressing: Vec<(f64, f64)>,
    /// Places and forces that were cut off, all negative.
    pub(super) pulling: Vec<(f64, f64)>,
    /// Least distance of two places at which a force is given, also of those at which it is zero.
    pub(super) spacing: f64,
}

/// Where there is one force only: a share of the beam's length within which it may belong to a corner of the foundation.
const LONE: f64 = 0.02;

/// A force that is none.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum NotAForce {
    /// A number that is `nan` or infinite.
    #[error("force {index} must be finite, but is {force} at x = {x}")]
    NotFinite {
        /// Which, from 0.
        index: usize,
        /// Where.
        x: f64,
        /// Its value.
        force: f64,
    },
    /// A place that is not on the beam.
    #[error("force {index} must act on the beam, between 0 and {length}, but acts at x = {x}")]
    OutsideBeam {
        /// Which, from 0.
        index: usize,
        /// Where.
        x: f64,
        /// Length of the beam.
        length: f64,
    },
}

impl NotAForce {
    /// Which force, from 0.
    #[must_use]
    pub fn index(&self) -> usize {
        match *self {
            Self::NotFinite { index, .. } | Self::OutsideBeam { index, .. } => index,
        }
    }
}

impl ContactLoad {
    /// Contact forces `(x, force)` on a beam of some length, in any order; forces at one place add up.
    ///
    /// # Errors
    ///
    /// A force or a place that is not finite, or a place that is not on the beam.
    pub fn new(length: f64, forces: impl IntoIterator<Item = (f64, f64)>) -> Result<Self, NotAForce> {
        let all = Self::sorted(length, forces)?;
        let spacing = all.windows(2).map(|w| w[1].0 - w[0].0).reduce(f64::min).unwrap_or(LONE * length);
        let pressing = all.iter().copied().filter(|f| 0.0 < f.1).collect();
        let pulling = all.into_iter().filter(|f| f.1 < 0.0).collect();
        Ok(Self { pressing, pulling, spacing })
    }

    /// Finite forces on the beam from left to right, one at a place.
    pub(super) fn sorted(
        length: f64,
        forces: impl IntoIterator<Item = (f64, f64)>,
    ) -> Result<Vec<(f64, f64)>, NotAForce> {
        let mut all: Vec<(f64, f64)> = Vec::new();
        for (index, (x, force)) in forces.into_iter().enumerate() {
            if !force.is_finite() || !x.is_finite() {
                return Err(NotAForce::NotFinite { index, x, force });
            }
            if !(0.0..=length).contains(&x) {
                return Err(NotAForce::OutsideBeam { index, x, length });
            }
            all.push((x, force));
        }
        all.sort_by(|a, b| a.0.total_cmp(&b.0));
        all.dedup_by(|next, kept| {
            let same = next.0 <= kept.0;
            if same {
                kept.1 += next.1;
            }
            same
        });
        Ok(all)
    }

    /// The forces of contacts: those at the ends of zones, and the rest of a zone's evenly over it.
    pub(super) fn of_contacts(length: f64, contacts: &[Contact]) -> Self {
        /// Forces in a zone.
        const PARTS: u32 = 256;
        let mut forces = Vec::new();
        for Contact { from, to, force, end_forces } in contacts {
            let Some([left, right]) = end_forces.filter(|_| from < to) else {
                forces.push((*from, *force));
                continue;
            };
            forces.extend([(*from, left), (*to, right)]);
            let each = (force - left - right) / f64::from(PARTS);
            forces.extend((0..PARTS).map(|k| (from + (to - from) * ((f64::from(k) + 0.5) / f64::from(PARTS)), each)));
        }
        // Places and forces that are no numbers bound nothing.
        Self::new(length, forces).unwrap_or_else(|_| Self::none(length))
    }

    /// No forces at all.
    fn none(length: f64) -> Self {
        Self { pressing: Vec::new(), pulling: Vec::new(), spacing: LONE * length }
    }

    /// The forces that pulled and were cut off: places and forces, all negative.
    #[must_use]
    pub fn pulling(&self) -> &[(f64, f64)] {
        &self.pulling
    }

    /// The same in other units, all powers of two.
    pub(super) fn scaled(&self, scale: &Scale) -> Self {
        let scaled = |forces: &[(f64, f64)]| forces.iter().map(|f| (f.0 / scale.length, f.1 / scale.force)).collect();
        Self { pressing: scaled(&self.pressing), pulling: scaled(&self.pulling), spacing: self.spacing / scale.length }
    }

    /// Forces between the supports that are more than rounding.
    pub(super) fn inside(&self, length: f64) -> Vec<(f64, f64)> {
        /// Of the largest force: less is what an iterative solver leaves where it means zero.
        const NOTHING: f64 = 1e-9;
        let most = self.pressing.iter().fold(0.0, |most: f64, f| most.max(f.1));
        self.pressing.iter().copied().filter(|f| 0.0 < f.0 && f.0 < length && NOTHING * most < f.1).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The forces at the ends of a zone stay there; what is left lies evenly between them, in its middle.
    #[test]
    fn zones_are_spread_and_points_are_not() {
        /// Of a sum of hundreds of numbers.
        const ROUNDING: f64 = 1e-12;
        let zone = Contact { from: 2.0, to: 6.0, force: 10.0, end_forces: Some([1.0, 3.0]) };
        let point = Contact { from: 8.0, to: 8.0, force: 5.0, end_forces: None };
        let load = ContactLoad::of_contacts(20.0, &[zone, point]);
        let ends = [load.pressing[0], load.pressing[load.pressing.len() - 2]];
        assert_eq!(ends, [(2.0, 1.0), (6.0, 3.0)], "the ends of the zone");
        assert_eq!(load.pressing.last(), Some(&(8.0, 5.0)));
        let between = &load.pressing[1..load.pressing.len() - 2];
        let sum = |moment: fn(&(f64, f64)) -> f64| between.iter().map(moment).sum::<f64>();
        assert!((sum(|f| f.1) - 6.0).abs() <= ROUNDING, "the rest of the force");
        assert!((sum(|f| f.0 * f.1) - 24.0).abs() <= 4.0 * ROUNDING, "in the middle");
        let share = |f: &(f64, f64)| (f.0 - 2.0) / 4.0;
        assert!(share(&between[0]) < 0.01 && 0.99 < share(&between[between.len() - 1]), "from end to end");
        // What is no number is no force, and the spacing is that of a lone one.
        let broken = Contact { force: f64::NAN, ..point };
        assert_eq!(ContactLoad::of_contacts(20.0, &[broken]), ContactLoad::new(20.0, []).expect("no forces"));
    }

    /// Forces on supports, and forces that are nothing beside the others, say nothing of the pattern.
    #[test]
    fn forces_on_supports_are_not_inside() {
        let forces = [(0.0, 1.0), (3.0, 1e-10), (4.0, 2.0), (5.0, 1e-8), (20.0, 1.0)];
        let load = ContactLoad::new(20.0, forces).expect("finite forces on the beam");
        assert_eq!(load.inside(20.0), [(4.0, 2.0), (5.0, 1e-8)]);
    }
}
