//! Contact forces that somebody computed, and the beam that bends under them and the true load.
//!
//! ```text
//! EI v'''' = q − Σ f_k δ(x − x_k),   v(0) = v(l) = 0,  v''(0) = v''(l) = 0,   M = −EI v''
//! ```

use super::kernel::interval::Interval;
use super::kernel::load::{EnclosedLoad, one_at_a_place};
use super::kernel::polynomial::{Polynomial, number};
use super::kernel::span::march;
use crate::scene::Scale;

/// Forces of the foundation on the beam, at places, upwards; those that pull are cut off.
#[derive(Debug, Clone, PartialEq)]
pub struct ContactLoad {
    /// Places and forces, from left to right, one at a place, all positive.
    pub(crate) pressing: Vec<(f64, f64)>,
    /// Places and forces that were cut off, all negative.
    pub(crate) pulling: Vec<(f64, f64)>,
}

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
        let pressing = all.iter().copied().filter(|f| 0.0 < f.1).collect();
        let pulling = all.into_iter().filter(|f| f.1 < 0.0).collect();
        Ok(Self { pressing, pulling })
    }

    /// Finite forces on the beam from left to right, one at a place.
    pub(crate) fn sorted(
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

    /// The forces that pulled and were cut off: places and forces, all negative.
    #[must_use]
    pub fn pulling(&self) -> &[(f64, f64)] {
        &self.pulling
    }

    /// The same in other units, all powers of two.
    pub(crate) fn scaled(&self, scale: &Scale) -> Self {
        let scaled = |forces: &[(f64, f64)]| forces.iter().map(|f| (f.0 / scale.length, f.1 / scale.force)).collect();
        Self { pressing: scaled(&self.pressing), pulling: scaled(&self.pulling) }
    }
}

/// Their deflection by cells, on each `v(from + s)`, found by one shot from a horizontal start; `breaks` besides those of the load
/// and the forces. All in dimensionless numbers.
pub(super) fn deflection(
    forces: &ContactLoad,
    load: &EnclosedLoad,
    breaks: &[f64],
    stiffness: f64,
    length: f64,
) -> Vec<([f64; 2], Polynomial)> {
    let upwards = forces.pressing.iter().map(|&(at, force)| (at, Interval::exact(-force)));
    let mut net = load.clone();
    net.points = one_at_a_place(load.points.iter().copied().chain(upwards).collect());
    let all: Vec<f64> = net.breaks(0.0, length).into_iter().chain(breaks.iter().copied()).collect();
    let l = Interval::exact(length);
    // First as if nothing held it at the left end, then with the slope and the shear that bring the right end back.
    let [v, _, curvature, _] = march([Interval::ZERO; 4], 0.0, length, all.clone(), &net, stiffness).1;
    let third = -(curvature / l);
    let slope = -(v / l) - third * l * l / number(6);
    march([Interval::ZERO, slope, Interval::ZERO, third], 0.0, length, all, &net, stiffness).0
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::{Beam, Load, PointLoad, Scene};

    /// A force `P` downwards and a contact force `F` upwards, at one place `a` or at two: of each
    ///
    /// ```text
    /// v(x) = P b x (l² − b² − x²) / 6 EI l  for x ≤ a,    b = l − a
    /// ```
    #[test]
    fn forces_bend_the_beam_by_their_closed_form() {
        const LENGTH: f64 = 8.0;
        const STIFFNESS: f64 = 70.0;
        const ROUNDING: f64 = 1e-13;
        let left = |force: f64, a: f64, x: f64| {
            let b = LENGTH - a;
            force * b * x * (LENGTH * LENGTH - b * b - x * x) / (6.0 * STIFFNESS * LENGTH)
        };
        let of = |force: f64, a: f64, x: f64| {
            if x <= a { left(force, a, x) } else { left(force, LENGTH - a, LENGTH - x) }
        };
        let beam = Beam::new(LENGTH, STIFFNESS).expect("positive");
        for (at, contact) in [(3.0, 3.0), (2.0, 5.0), (5.0, 2.0)] {
            let points = vec![PointLoad { at, force: 11.0 }];
            let scene = Scene::new(beam.clone(), Load::new(&beam, 0.0, Vec::new(), points).expect("finite"), None);
            let load = EnclosedLoad::of(&scene.expect("well posed"));
            let forces = ContactLoad::new(LENGTH, [(contact, 4.0)]).expect("a force");
            for ([from, to], v) in deflection(&forces, &load, &[1.0, 6.5], STIFFNESS, LENGTH) {
                for s in [0.0, 0.4 * (to - from), to - from] {
                    let expected = of(11.0, at, from + s) - of(4.0, contact, from + s);
                    let value = v.at(Interval::exact(s)).middle();
                    assert!((value - expected).abs() <= ROUNDING * 11.0, "{value}, not {expected}, at {}", from + s);
                }
            }
        }
    }
}
