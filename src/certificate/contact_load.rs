//! Contact forces from elsewhere, and the deflection of the beam under them and the true load.
//!
//! ```text
//! EI v'''' = q − Σ f_k δ(x − x_k) − Σ R_s δ(x − x_s),   v(x_s) = d_s,  v'(x_s) = φ_s where it is built in,   M = −EI v''
//! ```

use super::kernel::contact_node::{ContactNode, EnclosedScene, EnclosedSupport};
use super::kernel::interval::Interval;
use super::kernel::polynomial::Polynomial;
use super::witness::balance;
use crate::scene::Scale;

/// Forces of the foundation on the beam at given positions, upwards; negative forces are cut off.
#[derive(Debug, Clone, PartialEq)]
pub struct ContactLoad {
    /// Positions and forces, from left to right, one per position, all positive.
    pub(crate) pressing: Vec<(f64, f64)>,
    /// Positions and forces that were cut off, all negative.
    pub(crate) pulling: Vec<(f64, f64)>,
    /// All given positions, including those with a force of zero.
    pub(crate) places: Vec<f64>,
}

/// A contact force that is not valid.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum NotAForce {
    /// A number is NaN or infinite.
    #[error("force {index} must be finite, but is {force} at x = {x}")]
    NotFinite {
        /// Index of the force, from 0.
        index: usize,
        /// Position of the force.
        x: f64,
        /// Value of the force.
        force: f64,
    },
    /// A position is not on the beam.
    #[error("force {index} must act on the beam, between 0 and {length}, but acts at x = {x}")]
    OutsideBeam {
        /// Index of the force, from 0.
        index: usize,
        /// Position of the force.
        x: f64,
        /// Length of the beam.
        length: f64,
    },
}

impl NotAForce {
    /// Index of the force, from 0.
    #[must_use]
    pub fn index(&self) -> usize {
        match *self {
            Self::NotFinite { index, .. } | Self::OutsideBeam { index, .. } => index,
        }
    }
}

impl ContactLoad {
    /// Takes contact forces `(x, force)` on a beam of this length, in any order; forces at one position add up.
    ///
    /// # Errors
    ///
    /// A force or a position is not finite, or a position is not on the beam.
    pub fn new(length: f64, forces: impl IntoIterator<Item = (f64, f64)>) -> Result<Self, NotAForce> {
        let all = Self::sorted(length, forces)?;
        let places = all.iter().map(|f| f.0).collect();
        let pressing = all.iter().copied().filter(|f| 0.0 < f.1).collect();
        let pulling = all.into_iter().filter(|f| f.1 < 0.0).collect();
        Ok(Self { pressing, pulling, places })
    }

    /// Finite forces on the beam from left to right, one per position.
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

    /// The negative forces that were cut off: positions and forces.
    #[must_use]
    pub fn pulling(&self) -> &[(f64, f64)] {
        &self.pulling
    }

    /// The same in other units, all powers of two.
    pub(crate) fn scaled(&self, scale: &Scale) -> Self {
        let scaled = |forces: &[(f64, f64)]| forces.iter().map(|f| (f.0 / scale.length, f.1 / scale.force)).collect();
        let places = self.places.iter().map(|x| x / scale.length).collect();
        Self { pressing: scaled(&self.pressing), pulling: scaled(&self.pulling), places }
    }
}

/// The deflection under these forces by cells, on each `v(from + s)`, in dimensionless numbers. `breaks` are added to the breaks of the
/// load and the forces. Reactions follow from equilibrium and compatibility. If the supports do not hold the beam, two of the given
/// forces do: the largest one and the one with the largest moment about it, or about the only support. The beam touches the foundation
/// there, and the forces required by equilibrium replace the given ones. [`None`] if there are no two such forces.
pub(super) fn deflection(
    forces: &ContactLoad,
    enclosed: &EnclosedScene<'_>,
    breaks: &[f64],
) -> Option<Vec<([f64; 2], Polynomial)>> {
    let upwards = forces.pressing.iter().map(|&(at, force)| (at, Interval::exact(-force)));
    let mut net = enclosed.load.clone();
    net.points.extend(upwards);
    net.points.sort_by(|a, b| a.0.total_cmp(&b.0));
    bent(&EnclosedScene { load: &net, ..*enclosed }, &forces.pressing, breaks)
}

/// The same for a beam under its load and the contact forces together.
pub(super) fn bent(
    enclosed: &EnclosedScene<'_>,
    pressing: &[(f64, f64)],
    breaks: &[f64],
) -> Option<Vec<([f64; 2], Polynomial)>> {
    let mut nodes: Vec<ContactNode> = enclosed.supports.iter().map(|s| ContactNode::free(s.x)).collect();
    let mut places: Vec<f64> = enclosed.supports.iter().map(|s| s.x).collect();
    if let [] | [EnclosedSupport { slope: None, .. }] = enclosed.supports {
        while places.len() < 2 {
            let turns = |&(at, force): &(f64, f64)| force * places.first().map_or(1.0, |x| (at - x).abs());
            let most = pressing.iter().max_by(|a, b| turns(a).total_cmp(&turns(b)))?;
            if turns(most) <= 0.0 {
                return None;
            }
            places.push(most.0);
            nodes.push(ContactNode::free(most.0));
        }
    }
    nodes.sort_by(|a, b| a.x.total_cmp(&b.x));
    balance(enclosed, &mut nodes);
    let ends = |i: usize| [i.checked_sub(1).map(|i| &nodes[i]), nodes.get(i)];
    let spans = (0..=nodes.len()).filter_map(|i| enclosed.span(ends(i)[0], ends(i)[1]));
    let curves = spans.flat_map(|span| span.curves(enclosed, breaks.to_vec()));
    Some(curves.map(|(part, [v, _])| (part, v)).collect())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::certificate::in_intervals;
    use crate::scene::{Balance, Beam, Load, PointLoad, Scene};

    /// A force `P` downwards and a contact force `F` upwards, at one position `a` or at two; each of them causes
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
            let forces = ContactLoad::new(LENGTH, [(contact, 4.0)]).expect("a force");
            let caused = in_intervals(&scene.expect("well posed"), Balance::Held, |enclosed| {
                deflection(&forces, enclosed, &[1.0, 6.5]).expect("two supports hold it")
            });
            for ([from, to], v) in caused {
                for s in [0.0, 0.4 * (to - from), to - from] {
                    let expected = of(11.0, at, from + s) - of(4.0, contact, from + s);
                    let value = v.at(Interval::exact(s)).middle();
                    assert!((value - expected).abs() <= ROUNDING * 11.0, "{value}, not {expected}, at {}", from + s);
                }
            }
        }
    }
}
