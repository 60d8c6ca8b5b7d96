//! What is certified about an answer, beside beam theory, and how far it is from the solution of its discrete problem.

use palkki::certificate::{Certificate, Judged, certify};
use palkki::scene::Scene;
use palkki::state::{Contact, ContactState, Nodes};
use palkki::theory::{self, Exact, TheoryError};

/// Beam theory is right to twelve digits of the largest deflection, of the energy and of the reactions where it is certified;
/// one digit less is believed.
pub const THEORY: f64 = 1e-11;

/// At least so many places on the beam are compared, and at least [`PER_INTERVAL`] in each interval.
const PLACES: usize = 400;
const PER_INTERVAL: usize = 8;

/// A scene and its exact solution.
#[derive(Debug)]
pub struct Truth<'a> {
    /// The scene.
    pub scene: &'a Scene,
    /// Its exact solution.
    pub exact: Exact,
    /// The largest magnitude of `v*` \[length\].
    pub deflection: f64,
}

/// What was certified about an answer and is not so.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum FalseBound {
    /// `|v − v*|` is larger than the certified error.
    Deflection,
    /// `J*` is below its lower bound.
    EnergyLower,
    /// `J*` is above its upper bound.
    EnergyUpper,
    /// The reaction of a support is not in its bracket.
    Reaction,
}

/// A certificate beside the truth.
#[derive(Debug, Clone)]
pub struct Certified {
    /// `max |v − v*|` over a few hundred places, or more on finer grids; at most the true maximum \[length\].
    pub error: f64,
    /// What was certified.
    pub certificate: Certificate,
    /// What of it is not so.
    pub false_bounds: Vec<FalseBound>,
}

impl<'a> Truth<'a> {
    /// Solves the scene by beam theory.
    ///
    /// # Errors
    ///
    /// Those of [`theory::solve`].
    pub fn of(scene: &'a Scene) -> Result<Self, TheoryError> {
        let exact = theory::solve(scene)?;
        let deflection = exact.state.deflection.max.abs().max(exact.state.deflection.min.abs());
        Ok(Self { scene, exact, deflection })
    }

    /// What is certified about nodal values; [`None`] if it refuses them because they are no numbers.
    #[must_use]
    pub fn nodes(&self, nodes: &Nodes) -> Option<Certified> {
        self.nodes_from(nodes, &self.exact.state.contacts)
    }

    /// The same, proven from any witness.
    #[must_use]
    pub fn nodes_from(&self, nodes: &Nodes, witness: &[Contact]) -> Option<Certified> {
        if nodes.contact_force.iter().any(|force| !force.is_finite()) {
            return None;
        }
        let certificate = certify(self.scene, Judged::Nodes(nodes), witness).ok()?;
        let error = self.error(nodes, certificate.deflection_error_at);
        Some(self.beside(certificate, error))
    }

    /// What is certified about the places of contacts. The deflection that they make is known to the judge alone: only
    /// energy and reactions are compared.
    #[must_use]
    pub fn contacts(&self, contacts: &[Contact]) -> Option<Certified> {
        let certificate = certify(self.scene, Judged::Witness, contacts).ok()?;
        Some(self.beside(certificate, 0.0))
    }

    fn beside(&self, certificate: Certificate, error: f64) -> Certified {
        let mut false_bounds = Vec::new();
        let state = &self.exact.state;
        // Written so that NaN is a false bound.
        let holds = |least: f64, most: f64| least <= most;
        if !holds(error, certificate.deflection_error + THEORY * self.deflection) {
            false_bounds.push(FalseBound::Deflection);
        }
        let slack = THEORY * state.energy.abs();
        if !holds(certificate.energy_lower, state.energy + slack) {
            false_bounds.push(FalseBound::EnergyLower);
        }
        if !holds(state.energy - slack, certificate.energy_upper) {
            false_bounds.push(FalseBound::EnergyUpper);
        }
        let slack = THEORY * self.scene.load().magnitude(self.scene.beam().length());
        let reactions = [state.reactions.left, state.reactions.right];
        for (reaction, bracket) in reactions.into_iter().zip(certificate.reactions.iter()) {
            if bracket.is_some_and(|[least, most]| !(holds(least, reaction + slack) && holds(reaction - slack, most))) {
                false_bounds.push(FalseBound::Reaction);
            }
        }
        Certified { error, certificate, false_bounds }
    }

    /// The largest difference from `v*` of the cubics that deflections and moments at the nodes make, `at` one place besides
    /// the regular ones. Infinite if any of it is no number.
    fn error(&self, nodes: &Nodes, at: f64) -> f64 {
        let length = self.scene.beam().length();
        let intervals = nodes.x.len() + 1;
        let parts = (PER_INTERVAL * intervals).max(PLACES.next_multiple_of(intervals));
        #[expect(clippy::cast_precision_loss, reason = "thousands of places")]
        let places = (1..parts).map(|k| length * (k as f64 / parts as f64)).chain([at]);
        let stiffness = self.scene.beam().bending_stiffness();
        let differences = places.map(|x| (drawn(nodes, x, length, stiffness) - self.exact.deflection(x)).abs());
        differences.fold(0.0, |most: f64, d| if d.is_nan() { f64::INFINITY } else { most.max(d) })
    }
}

/// The deflection that nodal values have at `x`: the cubic between the nodes around it. The judge has its own.
fn drawn(nodes: &Nodes, x: f64, length: f64, stiffness: f64) -> f64 {
    let after = nodes.x.partition_point(|node| *node <= x);
    let at = |i: usize| match i.checked_sub(1) {
        None => [0.0; 3],
        Some(k) if k < nodes.x.len() => [nodes.x[k], nodes.deflection[k], nodes.moment[k]],
        Some(_) => [length, 0.0, 0.0],
    };
    let ([a, v0, m0], [b, v1, m1]) = (at(after), at(after + 1));
    let (s, width) = ((x - a) / (b - a), b - a);
    let r = 1.0 - s;
    // With s from 0 to 1, r = 1 − s: v = v₀ r + v₁ s + Δ²/(6 EI) (M₀ r (1 − r²) + M₁ s (1 − s²)).
    v0 * r + v1 * s + width * width / (6.0 * stiffness) * (m0 * r * (1.0 - r * r) + m1 * s * (1.0 - s * s))
}

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
