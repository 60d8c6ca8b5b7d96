//! Estimated errors of the forces of an exact answer for given errors of the foundation depths, to first order from its derivatives.

use super::derivatives::By;
use super::exact::Exact;
use super::sensitivity::Change;
use super::variation::Variation;

/// Estimated errors of forces: magnitudes \[force\].
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Spread {
    /// Of the reactions, from left to right.
    pub supports: Vec<f64>,
    /// Of the resultants of the contacts.
    pub contacts: Vec<f64>,
}

impl Exact {
    /// The first-order errors of the forces if the depth under each contact may independently be wrong by `tolerance`: the sum of the
    /// magnitudes of all derivatives. Under a zone the foundation moves as a whole. [`None`] on an elastic foundation, where the
    /// foundation fixes the slope at a support, and for a beam that is free to rotate.
    #[must_use]
    pub fn spread(&self, tolerance: f64) -> Option<Spread> {
        if self.springs.is_some() {
            return None;
        }
        let nodes = &self.list.nodes;
        let none =
            Spread { supports: vec![0.0; self.state.supports.len()], contacts: vec![0.0; self.state.contacts.len()] };
        let stretches = (0..=nodes.len()).filter_map(|i| match nodes.get(i) {
            _ if self.list.in_zone_before(i) => Some((i - 1, i)),
            Some(node) if node.is_point(&self.given) => Some((i, i)),
            _ => None,
        });
        // Where the foundation separates from a support, forces change with the root of the distance.
        let rests = |i: usize| nodes[i].rests_at_support(&self.given);
        if (0..nodes.len()).any(rests) {
            return None;
        }
        let linear = self.sensitivity()?;
        stretches.into_iter().try_fold(none, |mut sum, (from, to)| {
            let of = Change::GroundUnder(from, to);
            let variation = Variation { by: By::Depth, change: [of; 2], unit: self.units.depth, least: 0.0 };
            let derivative = self.derivative(&linear, variation, &linear.on_both_sides(variation.change), [true; 2]);
            let add = |sum: &mut f64, by: f64| *sum += by.abs() * tolerance;
            sum.supports.iter_mut().zip(&derivative.supports).for_each(|(sum, &by)| add(sum, by));
            sum.contacts.iter_mut().zip(&derivative.contacts).for_each(|(sum, by)| add(sum, by.force));
            Some(sum)
        })
    }
}
