//! How far an answer is from the solution of its discrete problem, quantity by quantity.

use palkki::state::{ContactState, Nodes};

/// Largest differences of two answers of the same discrete problem, all dimensionless. Infinite for what is no number, or
/// is not there.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Distance {
    /// Of deflections, over the largest one.
    pub deflection: f64,
    /// Of clearances, over the largest deflection.
    pub clearance: f64,
    /// Of bending moments, over the load times the length.
    pub moment: f64,
    /// Of nodal contact forces, over the load.
    pub force: f64,
    /// Of reactions, over the load.
    pub reaction: f64,
    /// Of the places of nodes, over the length.
    pub place: f64,
}

impl Distance {
    /// From `sound` to `other`, both on a beam of some length under loads of some magnitude.
    #[must_use]
    pub fn between(sound: &ContactState, other: &ContactState, length: f64, load: f64) -> Self {
        let none = Nodes::default();
        let (a, b) = (sound.nodes.as_ref().unwrap_or(&none), other.nodes.as_ref().unwrap_or(&none));
        let largest = nonzero(a.deflection.iter().fold(0.0, |most: f64, v| most.max(v.abs())));
        let load = nonzero(load);
        let (ra, rb) = (sound.reactions, other.reactions);
        Self {
            deflection: apart(&a.deflection, &b.deflection) / largest,
            clearance: apart(&a.clearance, &b.clearance) / largest,
            moment: apart(&a.moment, &b.moment) / (load * length),
            force: apart(&a.contact_force, &b.contact_force) / load,
            reaction: apart(&[ra.left, ra.right], &[rb.left, rb.right]) / load,
            place: apart(&a.x, &b.x) / length,
        }
    }

    /// The largest of all but the nodal forces, which the check of the discrete problem sees through the stiffness only.
    #[must_use]
    pub fn shape(&self) -> f64 {
        [self.clearance, self.moment, self.reaction, self.place].into_iter().fold(self.deflection, f64::max)
    }
}

fn nonzero(size: f64) -> f64 {
    if 0.0 < size { size } else { 1.0 }
}

fn apart(a: &[f64], b: &[f64]) -> f64 {
    if a.len() != b.len() {
        return f64::INFINITY;
    }
    // Equal first: both may be infinite, as clearances without a foundation are.
    let difference = |(a, b): (&f64, &f64)| if a.total_cmp(b).is_eq() { 0.0 } else { (a - b).abs() };
    a.iter().zip(b).map(difference).fold(0.0, |most, d| if d.is_nan() { f64::INFINITY } else { most.max(d) })
}
