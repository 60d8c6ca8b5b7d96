//! What is certified about an answer, beside beam theory.

use palkki::certificate::{Certificate, Judged, certify};
use palkki::scene::Scene;
use palkki::state::{Contact, Nodes};
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
pub enum Lie {
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
    pub lies: Vec<Lie>,
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
        let mut lies = Vec::new();
        let state = &self.exact.state;
        // Written so that NaN is a lie.
        let holds = |least: f64, most: f64| least <= most;
        if !holds(error, certificate.deflection_error + THEORY * self.deflection) {
            lies.push(Lie::Deflection);
        }
        let slack = THEORY * state.energy.abs();
        if !holds(certificate.energy_lower, state.energy + slack) {
            lies.push(Lie::EnergyLower);
        }
        if !holds(state.energy - slack, certificate.energy_upper) {
            lies.push(Lie::EnergyUpper);
        }
        let slack = THEORY * self.scene.load().magnitude(self.scene.beam().length());
        for (reaction, bracket) in [state.reactions.left, state.reactions.right].into_iter().zip(certificate.reactions)
        {
            if bracket.is_some_and(|[least, most]| !(holds(least, reaction + slack) && holds(reaction - slack, most))) {
                lies.push(Lie::Reaction);
            }
        }
        Certified { error, certificate, lies }
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
