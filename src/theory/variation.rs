//! The numbers of the scene by which an answer is differentiated.

use super::derivatives::By;
use super::exact::Exact;
use super::leeway::Leeway;
use super::sensitivity::{Change, NodeChange};
use crate::scene::{Beam, Foundation, Quantity, Scene, Support};

/// A share of a number of the scene that has no practical meaning: no such number is known to seven digits, and conditions are
/// satisfied to twelve.
pub(super) const NOTHING: f64 = 1e-7;

/// Two neighbouring answers differ by at most this share of the largest force, or of the length. After a change by [`NOTHING`], a
/// quantity that jumps changes by more, and so does one that grows like the root of the change.
const NEAR: f64 = 1e-4;

/// A derivative to be computed.
#[derive(Debug, Clone, Copy)]
pub(super) struct Variation {
    pub(super) by: By,
    /// The change as the number falls, and as it grows. They differ where a support moves across a corner of the initial shape.
    pub(super) change: [Change; 2],
    pub(super) unit: f64,
    /// A change of the number that has no practical meaning, in the units of the scene.
    pub(super) least: f64,
}

impl Variation {
    /// For each side, as the number falls and as it grows: whether an answer with the same contacts exists there, close to this one.
    /// Computed from the answers of both neighbouring scenes.
    pub(super) fn continues_beside(&self, scene: &Scene, exact: &Exact) -> [bool; 2] {
        self.neighbouring_scenes(scene).map(|beside| {
            let there = beside.and_then(|beside| exact.continued_in(&beside));
            there.is_some_and(|there| is_next_to(exact, &there, scene.beam().length()))
        })
    }

    /// Whether the number is the position of a load that is at the end of a zone: the load moves into the zone or out of it.
    #[expect(clippy::float_cmp, reason = "a node at a load is exactly there")]
    pub(super) fn moves_at_zone(&self, exact: &Exact) -> bool {
        let moves = |x: f64| matches!(self.change[0], Change::Move(at, _) if at == x);
        exact.list.zones().any(|zone| moves(zone.from) || moves(zone.to))
    }

    /// Whether the answer is certain to continue on both sides; `changes` are the changes of the nodes on each side.
    pub(super) fn is_certain_to_continue(&self, leeway: &Leeway<'_>, changes: &[Vec<NodeChange>; 2]) -> bool {
        let step = self.least / self.unit;
        self.change.iter().zip(changes).all(|(of, changes)| leeway.contacts_remain(*of, changes, step, NEAR))
    }

    /// The neighbouring scene on each side, if there is one.
    pub(super) fn neighbouring_scenes(&self, scene: &Scene) -> [Option<Scene>; 2] {
        [-self.least, self.least].map(|step| self.changed_scene(scene, step))
    }

    /// The scene with its number changed by a step.
    pub(super) fn changed_scene(&self, scene: &Scene, step: f64) -> Option<Scene> {
        match self.by {
            By::Depth => scene.with_ground_moved(step).ok(),
            By::Number(quantity) => scene.with_number(quantity, scene.number(quantity)? + step).ok(),
        }
    }
}

/// Whether two answers have contacts and supports of the same kinds, with nearly the same forces at nearly the same positions.
pub(super) fn is_next_to(exact: &Exact, other: &Exact, length: f64) -> bool {
    let kinds = |exact: &Exact| -> Vec<bool> {
        let supports = exact.state.supports.iter().map(|support| support.pushes_only && support.force <= 0.0);
        exact.listed.iter().map(|contact| contact.end_forces.is_some()).chain(supports).collect()
    };
    let forces = |exact: &Exact| -> Vec<f64> {
        let contacts = exact.listed.iter().flat_map(|c| [c.force].into_iter().chain(c.end_forces.unwrap_or_default()));
        exact.state.supports.iter().map(|support| support.force).chain(contacts).collect()
    };
    let places = |exact: &Exact| -> Vec<f64> { exact.listed.iter().flat_map(|c| [c.from, c.to]).collect() };
    let near = |a: Vec<f64>, b: Vec<f64>, size: f64| a.iter().zip(&b).all(|(a, b)| (a - b).abs() <= NEAR * size);
    let largest = forces(exact).into_iter().fold(0.0, |most: f64, force| most.max(force.abs()));
    kinds(exact) == kinds(other)
        && near(forces(exact), forces(other), largest)
        && near(places(exact), places(other), length)
}

/// The largest distance between two neighbouring positions among supports and ends of a beam \[length\].
fn longest_stretch(beam: &Beam) -> f64 {
    let mut places: Vec<f64> = beam.all_supports().iter().map(|support| support.at).collect();
    places.extend([0.0, beam.length()]);
    places.sort_by(f64::total_cmp);
    places.windows(2).fold(0.0, |most, pair| most.max(pair[1] - pair[0]))
}

impl Exact {
    /// All derivatives to be computed, in their order.
    pub(super) fn variations(&self, scene: &Scene) -> Vec<Variation> {
        // The influence of a change fades over a few supports, so the longest stretch between supports sets the size.
        let (units, length) = (&self.units, longest_stretch(scene.beam()));
        let forces = self.state.supports.iter().map(|support| support.force.abs());
        let load = self.given.total_load * units.force * (length / scene.beam().length());
        let force = forces.chain([self.state.contact_force()]).fold(load, f64::max);
        // At least the deflection that the loads alone would cause in a beam at rest.
        let part = length / units.length;
        let at_rest = force / units.force * units.depth / 384.0 * (part * part * part);
        let depth = self.state.deflection.magnitude().max(at_rest);
        let variation =
            |by, change, unit, size: f64| Variation { by, change: [change; 2], unit, least: NOTHING * size };
        let number = |quantity, change, unit, size| variation(By::Number(quantity), change, unit, size);
        let mut all = Vec::new();
        all.extend(scene.foundation().map(|_| variation(By::Depth, Change::Ground, units.depth, depth)));
        let stiffness = scene.beam().bending_stiffness();
        // If the stiffness changes in steps, each step is a number of its own.
        let is_uniform = scene.beam().changes().next().is_none();
        all.extend(is_uniform.then(|| number(Quantity::BendingStiffness, Change::Unload, stiffness, stiffness)));
        let ground = scene.ground_stiffness().filter(|_| scene.ground_changes().next().is_none());
        all.extend(ground.map(|k| number(Quantity::GroundStiffness, Change::Stiffen, k, k)));
        all.push(number(Quantity::Uniform, Change::Uniform(1.0), units.pressure(), force / length));
        for (i, load) in scene.load().point().iter().enumerate() {
            let (at, size) = (load.at / units.length, load.force / units.force);
            all.push(number(Quantity::PointForce(i), Change::Force(at, 1.0), units.force, force));
            all.push(number(Quantity::PointAt(i), Change::Move(at, size), units.length, length));
        }
        for (given, support) in scene.beam().supports_as_given().into_iter().enumerate() {
            let Some(i) = self.index_of(scene, &support) else { continue };
            all.push(number(Quantity::SupportLevel(given), Change::Level(i), units.depth, depth));
            let moves = self.axis_beside(scene, support.at).map(|axis| Change::Support(i, axis));
            let place = variation(By::Number(Quantity::SupportAt(given)), moves[0], units.length, length);
            all.extend(self.springs.is_none().then_some(Variation { change: moves, ..place }));
        }
        all
    }

    /// The index of a support in the answer: compression-only supports come after the others. On an elastic foundation it is the
    /// breakpoint.
    fn index_of(&self, scene: &Scene, support: &Support) -> Option<usize> {
        if self.springs.is_some() {
            return self.given.breakpoint_at(support.at / self.units.length);
        }
        let before = |these: &[Support]| these.iter().filter(|s| s.at < support.at).count();
        let (held, bearings) = (scene.beam().supports(), scene.beam().bearings());
        Some(if support.pushes_only { held.len() + before(bearings) } else { before(held) })
    }

    /// Slope and curvature of the initial shape to the left and to the right of a position, dimensionless.
    fn axis_beside(&self, scene: &Scene, x: f64) -> [[f64; 2]; 2] {
        let unit = 1.0 / self.units.slope();
        let Some(shape) = scene.beam().shape() else { return [[0.0; 2]; 2] };
        shape.sides(x).map(|[_, slope]| [slope * unit, curvature(shape, x) * unit * self.units.length])
    }
}

/// The second derivative of a profile where it is smooth.
fn curvature(profile: &Foundation, x: f64) -> f64 {
    match profile {
        Foundation::Flat { .. } | Foundation::Polyline { .. } => 0.0,
        Foundation::Polynomial { coefficients } => {
            #[expect(clippy::cast_precision_loss, reason = "a degree is a small number")]
            let terms = coefficients.iter().enumerate().skip(2).rev().map(|(j, c)| (j * (j - 1)) as f64 * c);
            terms.fold(0.0, |sum, c| sum * x + c)
        }
        Foundation::Cosine { amplitude, wavelength, phase, .. } => {
            let rate = 2.0 * std::f64::consts::PI / wavelength;
            -amplitude * rate * rate * libm::cos(rate * x + phase)
        }
    }
}
