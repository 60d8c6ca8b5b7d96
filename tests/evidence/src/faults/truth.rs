//! What is certified about an answer, beside the truth, and how far it is from the solution of its discrete problem.

use palkki::certificate::{Certificate, Judged, certify};
use palkki::scene::Scene;
use palkki::state::{Contact, ContactState, Nodes};
use palkki::theory::{self, Exact, TheoryError};

use crate::closed::Closed;
use crate::compare::{apart, largest};

/// Closed forms and beam theory: the latter is right to twelve digits of the largest deflection, of the energy and of the
/// reactions where it is certified; one digit less is believed.
pub const THEORY: f64 = 1e-11;

/// At least so many places on the beam are compared, and at least [`PER_INTERVAL`] in each interval.
const PLACES: usize = 400;
const PER_INTERVAL: usize = 8;

/// A scene and its exact solution: by a closed form where there is one, otherwise by beam theory.
#[derive(Debug)]
pub struct Truth<'a> {
    /// The scene.
    pub scene: &'a Scene,
    /// Where the beam touches: the witness, unless another one is tried.
    pub contacts: Vec<Contact>,
    /// The largest magnitude of `v*` \[length\].
    pub deflection: f64,
    /// Whether all conditions of the problem are known to hold.
    pub solved: bool,
    energy: f64,
    /// Forces of the supports from left to right, where they are known.
    reactions: Vec<Option<f64>>,
    source: Source<'a>,
}

/// Who knows the deflection.
#[derive(Debug)]
enum Source<'a> {
    Closed(&'a Closed),
    Theory(Box<Exact>),
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
        let state = &exact.state;
        Ok(Self {
            scene,
            contacts: state.contacts.clone(),
            deflection: state.deflection.magnitude(),
            solved: exact.solved,
            energy: state.energy,
            reactions: state.supports.iter().map(|support| Some(support.force)).collect(),
            source: Source::Theory(Box::new(exact)),
        })
    }

    /// From a closed form; theory is not asked.
    #[must_use]
    pub fn closed(closed: &'a Closed) -> Self {
        Self {
            scene: &closed.scene,
            contacts: closed.contacts.clone(),
            deflection: closed.largest(),
            solved: true,
            energy: closed.energy(),
            reactions: closed.reactions(),
            source: Source::Closed(closed),
        }
    }

    /// `v*(x)` \[length\].
    #[must_use]
    pub fn at(&self, x: f64) -> f64 {
        match &self.source {
            Source::Closed(closed) => closed.deflection(x),
            Source::Theory(exact) => exact.deflection(x),
        }
    }

    /// What is certified about nodal values; [`None`] if it refuses them because they are no numbers.
    #[must_use]
    pub fn nodes(&self, nodes: &Nodes) -> Option<Certified> {
        self.nodes_from(nodes, &self.contacts)
    }

    /// The same, proven from any witness.
    #[must_use]
    pub fn nodes_from(&self, nodes: &Nodes, witness: &[Contact]) -> Option<Certified> {
        if nodes.contact_force.iter().any(|force| !force.is_finite()) {
            return None;
        }
        let certificate = certify(self.scene, Judged::Nodes(nodes), witness).ok()?;
        let error = self.error(nodes, certificate.deflection_error_at, certificate.up_to_a_turn);
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
        // Written so that NaN is a false bound.
        let holds = |least: f64, most: f64| least <= most;
        if !holds(error, certificate.deflection_error + THEORY * self.deflection) {
            false_bounds.push(FalseBound::Deflection);
        }
        let slack = THEORY * self.energy.abs();
        if !holds(certificate.energy_lower, self.energy + slack) {
            false_bounds.push(FalseBound::EnergyLower);
        }
        if !holds(self.energy - slack, certificate.energy_upper) {
            false_bounds.push(FalseBound::EnergyUpper);
        }
        let load = self.scene.load().magnitude(self.scene.beam().length());
        for (reaction, bracket) in self.reactions.iter().zip(&certificate.reactions) {
            let (Some(reaction), Some([least, most])) = (*reaction, *bracket) else { continue };
            // Of a settlement there are reactions without a load.
            let slack = THEORY * load.max(reaction.abs());
            if !(holds(least, reaction + slack) && holds(reaction - slack, most)) {
                false_bounds.push(FalseBound::Reaction);
            }
        }
        Certified { error, certificate, false_bounds }
    }

    /// The largest difference from `v*` of the cubics that deflections and moments at the nodes make, `at` one place besides
    /// the regular ones; after the best turn about a place if the beam can turn there. Infinite if any of it is no number.
    fn error(&self, nodes: &Nodes, at: f64, turns_about: Option<f64>) -> f64 {
        let length = self.scene.beam().length();
        let intervals = nodes.x.len() + 1;
        let parts = (PER_INTERVAL * intervals).max(PLACES.next_multiple_of(intervals));
        #[expect(clippy::cast_precision_loss, reason = "thousands of places")]
        let places = (1..parts).map(|k| length * (k as f64 / parts as f64)).chain([at]);
        let drawn = Cubics::of(self.scene, nodes);
        let differences = places.map(|x| (x, drawn.at(x) - self.at(x)));
        let Some(about) = turns_about else { return largest(differences.map(|(_, d)| d)) };
        let differences: Vec<(f64, f64)> = differences.collect();
        best_turn(&differences, about)
    }
}

/// The least value over `φ` of `max |d(x) − φ (x − about)|`, by thirds: it is a convex function of `φ`.
fn best_turn(differences: &[(f64, f64)], about: f64) -> f64 {
    /// A third less each time: what is left of the interval is below rounding.
    const STEPS: usize = 100;
    let off = |turn: f64| largest(differences.iter().map(|(x, d)| d - turn * (x - about)));
    let reach = largest(differences.iter().map(|(x, _)| x - about));
    // Beyond this turn the difference at the end that is farther away is larger than without any.
    let most = 2.0 * off(0.0) / reach;
    let [mut from, mut to] = [-most, most];
    for _ in 0..STEPS {
        let [left, right] = [from + (to - from) / 3.0, to - (to - from) / 3.0];
        if off(left) <= off(right) { to = right } else { from = left }
    }
    off(0.5 * (from + to))
}

/// The deflection that nodal values have: the cubics between the nodes, and between nodes and the supports at the ends. The judge
/// has its own.
#[derive(Debug)]
struct Cubics {
    /// Place, deflection and moment.
    nodes: Vec<[f64; 3]>,
    /// Places and slopes where the beam is built in.
    built_in: Vec<[f64; 2]>,
    stiffness: f64,
}

impl Cubics {
    /// Supports that are no nodes are added, with the deflection that they ask and no moment.
    fn of(scene: &Scene, given: &Nodes) -> Self {
        let mut nodes: Vec<[f64; 3]> = (0..given.x.len().min(given.deflection.len()).min(given.moment.len()))
            .map(|k| [given.x[k], given.deflection[k], given.moment[k]])
            .collect();
        let held = scene.held();
        for support in &held {
            let after = nodes.partition_point(|node| node[0] < support.at);
            if nodes.get(after).is_none_or(|node| support.at < node[0]) {
                nodes.insert(after, [support.at, support.deflection, 0.0]);
            }
        }
        let built_in = held.iter().filter_map(|support| Some([support.at, support.slope?])).collect();
        Self { nodes, built_in, stiffness: scene.beam().bending_stiffness() }
    }

    /// `v(x)` \[length\]; no number beyond the nodes.
    fn at(&self, x: f64) -> f64 {
        let after = self.nodes.partition_point(|node| node[0] <= x).min(self.nodes.len().saturating_sub(1));
        let Some(cell) = after.checked_sub(1).and_then(|before| self.nodes.get(before..=after)) else {
            return f64::NAN;
        };
        let [mut left, mut right] = [cell[0], cell[1]];
        left[2] = self.moment(left, right);
        right[2] = self.moment(right, left);
        let ([a, v0, m0], [b, v1, m1]) = (left, right);
        let (s, width) = ((x - a) / (b - a), b - a);
        let r = 1.0 - s;
        // With s from 0 to 1, r = 1 − s: v = v₀ r + v₁ s + Δ²/(6 EI) (M₀ r (1 − r²) + M₁ s (1 − s²)).
        v0 * r + v1 * s + width * width / (6.0 * self.stiffness) * (m0 * r * (1.0 - r * r) + m1 * s * (1.0 - s * s))
    }

    /// The moment at the first node of a cell: its own, or that which gives the cubic the slope `φ` where the beam is built in,
    /// `M₀ = −3 EI (v₁ − v₀ − φ Δ)/Δ² − M₁/2`.
    fn moment(&self, [a, v0, own]: [f64; 3], [b, v1, m1]: [f64; 3]) -> f64 {
        let width = b - a;
        let slope = self.built_in.iter().find(|[at, _]| (at - a).abs() <= 0.0).map(|[_, slope]| slope);
        slope.map_or(own, |slope| -3.0 * self.stiffness * (v1 - v0 - slope * width) / (width * width) - 0.5 * m1)
    }
}

/// Largest differences of two answers of the same discrete problem, all dimensionless. Infinite for what is no number, or
/// is not there.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Distance {
    /// Of deflections, over the largest one.
    pub deflection: f64,
    /// Of clearances, over the largest deflection.
    pub clearance: f64,
    /// Of bending moments, and of those where the beam is built in, over the load times the length.
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
        let reactions = |state: &ContactState| {
            let ends = [state.reactions.left, state.reactions.right];
            ends.into_iter().chain(state.supports.iter().map(|support| support.force)).collect::<Vec<_>>()
        };
        let couples = |state: &ContactState| state.supports.iter().filter_map(|s| s.moment).collect::<Vec<_>>();
        let moment = apart(&a.moment, &b.moment).max(apart(&couples(sound), &couples(other)));
        Self {
            deflection: apart(&a.deflection, &b.deflection) / largest,
            clearance: apart(&a.clearance, &b.clearance) / largest,
            moment: moment / (load * length),
            force: apart(&a.contact_force, &b.contact_force) / load,
            reaction: apart(&reactions(sound), &reactions(other)) / load,
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
