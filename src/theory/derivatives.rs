//! Derivatives of an exact answer by the numbers of its scene, in the units of the scene.
//!
//! Places and forces follow from module `sensitivity`. The energy is the least one, so that its derivative is that of the functional
//! and of the constraints alone (envelope theorem), with the forces as multipliers:
//!
//! ```text
//! ∂J/∂(depth) = −Σ R     ∂J/∂EI = ½∫v''²     ∂J/∂q₀ = −∫v     ∂J/∂P = −v(a)     ∂J/∂a = −P v'(a)     ∂J/∂d_s = −R_s
//! ```

use super::exact::Exact;
use super::list::{Beside, Kind};
use super::margin::lowest;
use super::sensitivity::{Change, NodeChange, bend, change, standing};
use crate::scene::{Foundation, Quantity, Scene};
use crate::state::Contact;

/// By what an answer is differentiated.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum By {
    /// The depth of all of the ground \[length\].
    Depth,
    /// A number of the scene.
    Number(Quantity),
}

impl std::fmt::Display for By {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Depth => f.write_str("depth"),
            Self::Number(quantity) => quantity.fmt(f),
        }
    }
}

/// The derivatives of an answer by one number; each has the unit of what is differentiated over that of the number.
#[derive(Debug, Clone, PartialEq)]
pub struct Derivative {
    /// The number.
    pub by: By,
    /// True at a change of the kind of the answer: to the other side of it the derivatives are others.
    pub one_sided: bool,
    /// Of the forces of the supports, from left to right.
    pub supports: Vec<f64>,
    /// Of the contacts, in their order.
    pub contacts: Vec<ContactDerivative>,
    /// Of the energy `J`.
    pub energy: f64,
}

/// The derivatives of a contact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ContactDerivative {
    /// Of its left end.
    pub from: f64,
    /// Of its right end.
    pub to: f64,
    /// Of its resultant.
    pub force: f64,
    /// Of the forces at the ends of a zone.
    pub end_forces: Option<[f64; 2]>,
}

/// How far forces may be off, by estimate: magnitudes \[force\].
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "cli", derive(serde::Serialize))]
pub struct Spread {
    /// Of the supports, from left to right.
    pub supports: Vec<f64>,
    /// Of the resultants of the contacts.
    pub contacts: Vec<f64>,
}

/// A contact force, a bend or a clearance below this share of the largest one is zero: there the kind of the answer changes.
const AT_A_CHANGE: f64 = 1e-9;

impl Exact {
    /// The derivatives of this solution of `scene` by the depth of all of the ground, the bending stiffness, the uniform load, force
    /// and place of each point load, level and place of each support. Left out is what has none: all of a beam whose position is
    /// not certain.
    #[must_use]
    pub fn derivatives(&self, scene: &Scene) -> Vec<Derivative> {
        let scale = &self.scale;
        let (stiffness, bending) = (self.stiffness, scene.beam().bending_stiffness());
        let mut found = Vec::new();
        let at_change = self.at_a_change();
        let mut add = |by: By, change: Change, unit: f64, one_sided: bool| {
            found.extend(self.derivative(by, change, unit, at_change || one_sided));
        };
        if scene.foundation().is_some() {
            let grounded = self.given.supports.iter().any(|support| support.grounded != [false; 2]);
            add(By::Depth, Change::Ground, scale.depth, grounded);
        }
        add(By::Number(Quantity::BendingStiffness), Change::Unload, bending, false);
        add(By::Number(Quantity::Uniform), Change::Uniform(1.0 / stiffness), scale.force / scale.length, false);
        for (i, load) in scene.load().point().iter().enumerate() {
            let at = load.at / scale.length;
            add(By::Number(Quantity::PointForce(i)), Change::Force(at, 1.0 / stiffness), scale.force, false);
            let size = load.force / scale.force / stiffness;
            // Beside a node, or at an end of the beam, another span is loaded.
            let on_node = self.list.nodes.iter().any(|node| node.x <= at && at <= node.x);
            let at_end = at <= 0.0 || self.given.length <= at;
            add(By::Number(Quantity::PointAt(i)), Change::Move(at, size), scale.length, on_node || at_end);
        }
        for (given, support) in scene.beam().supports_as_given().into_iter().enumerate() {
            let Some(i) = scene.beam().supports().iter().position(|s| s.at <= support.at && support.at <= s.at) else {
                continue;
            };
            let here = &self.given.supports[i];
            let pressed = here.grounded != [false; 2];
            add(By::Number(Quantity::SupportLevel(given)), Change::Level(i), scale.depth, pressed);
            let unit = scale.length / scale.depth;
            let (own, kinked) = scene.beam().shape().map_or(([0.0; 2], false), |shape| {
                let [[_, left], [_, right]] = shape.sides(support.at);
                let slope = if support.at < scene.beam().length() { right } else { left };
                ([slope * unit, curvature(shape, support.at) * unit * scale.length], left.total_cmp(&right).is_ne())
            });
            let at_end = support.at <= 0.0 || scene.beam().length() <= support.at;
            let loaded = self.given.breakpoints[here.breakpoint].force != 0.0;
            let one_sided = pressed || at_end || loaded || kinked;
            add(By::Number(Quantity::SupportAt(given)), Change::Support(i, own), scale.length, one_sided);
        }
        found
    }

    /// How far forces are off to first order if the depth under each contact by itself may be off by `tolerance`: the sum of the
    /// magnitudes of all derivatives. Under a zone the ground moves as a whole.
    #[must_use]
    pub fn spread(&self, tolerance: f64) -> Option<Spread> {
        let nodes = &self.list.nodes;
        let none =
            Spread { supports: vec![0.0; self.state.supports.len()], contacts: vec![0.0; self.state.contacts.len()] };
        let stretches = (0..=nodes.len()).filter_map(|i| match nodes.get(i).map(|node| node.kind) {
            _ if self.list.in_zone_before(i) => Some((i - 1, i)),
            Some(Kind::Smooth | Kind::Edge(_)) => Some((i, i)),
            _ => None,
        });
        stretches.into_iter().try_fold(none, |mut sum, (from, to)| {
            let of = Change::GroundUnder(from, to);
            let derivative = self.derivative(By::Depth, of, self.scale.depth, false)?;
            let add = |sum: &mut f64, by: f64| *sum += by.abs() * tolerance;
            sum.supports.iter_mut().zip(&derivative.supports).for_each(|(sum, &by)| add(sum, by));
            sum.contacts.iter_mut().zip(&derivative.contacts).for_each(|(sum, by)| add(sum, by.force));
            Some(sum)
        })
    }

    fn derivative(&self, by: By, of: Change, unit: f64, one_sided: bool) -> Option<Derivative> {
        let (given, list, scale) = (&self.given, &self.list, &self.scale);
        let changes = change(given, list, &self.spans, &self.forces, of)?;
        let place = |z: f64| z * scale.length / unit;
        // A force is EI times what is computed here, so that it grows with EI as such.
        let force = |now: f64, change: f64| {
            let own = if of == Change::Unload { now } else { 0.0 };
            (own + change) * self.stiffness * scale.force / unit + 0.0
        };
        let total =
            |i: usize| self.forces[i] + if list.nodes[i].support().is_some() { standing(given, list, i) } else { 0.0 };
        let (mut supports, mut contacts) = (Vec::new(), Vec::new());
        for i in 0..=list.nodes.len() {
            if list.in_zone_before(i) {
                let ends = [i - 1, i].map(|end| {
                    let node = &list.nodes[end];
                    match node.support() {
                        Some(_) => (node.x, 0.0, 0.0, 0.0),
                        None => (node.x, changes[end].place, self.forces[end], changes[end].force),
                    }
                });
                let [(from, left, force_from, change_from), (to, right, force_to, change_to)] = ends;
                let (first, last) = (given.cell_from(from), given.cell_to(to));
                let pressure = |cell: usize, x: f64| -given.drive(cell, x);
                let spread = of.on_zone(given, from, to) + pressure(last, to) * right - pressure(first, from) * left;
                let own = super::forces::zone_force(given, from, to) + force_from + force_to;
                contacts.push(ContactDerivative {
                    from: place(left),
                    to: place(right),
                    force: force(own, spread + change_from + change_to),
                    end_forces: Some([force(force_from, change_from), force(force_to, change_to)]),
                });
            }
            let Some(node) = list.nodes.get(i) else { continue };
            match node.kind {
                Kind::Smooth | Kind::Edge(_) => contacts.push(ContactDerivative {
                    from: place(changes[i].place),
                    to: place(changes[i].place),
                    force: force(self.forces[i], changes[i].force),
                    end_forces: None,
                }),
                Kind::Support(..) => supports.push(force(total(i), changes[i].force)),
                _ => {}
            }
        }
        let energy = self.energy_by(of, &changes) * self.stiffness * scale.energy() / unit + 0.0;
        Some(Derivative { by, one_sided, supports, contacts, energy })
    }

    /// The derivative of `J / EI`, of `J` by the logarithm of `EI`.
    fn energy_by(&self, of: Change, changes: &[NodeChange]) -> f64 {
        let (given, scale) = (&self.given, &self.scale);
        let deflection = |at: f64| self.deflection(at * scale.length) / scale.depth;
        match of {
            // The energy of a part of the ground is not asked for.
            Change::GroundUnder(..) => 0.0,
            Change::Ground => {
                let contact = self.state.contact_force() / (self.stiffness * scale.force);
                -contact
            }
            Change::Unload => self.integral(|[_, _, v2, _]| 0.5 * v2 * v2),
            Change::Uniform(q) => -q * self.integral(|[v, ..]| v),
            Change::Force(at, p) => -p * deflection(at),
            Change::Move(at, p) => -p * self.slope(at * scale.length) * scale.length / scale.depth,
            Change::Level(index) | Change::Support(index, _) => {
                let Some(i) = self.list.nodes.iter().position(|node| node.support() == Some(index)) else { return 0.0 };
                let force = self.forces[i] + standing(given, &self.list, i);
                let held = self.list.nodes[i].held_slope(given).is_some() && matches!(of, Change::Support(..));
                let couple = super::sensitivity::ends(&self.spans, i);
                let bends = [couple[0].map_or(0.0, |s| s.beam_b[2]), couple[1].map_or(0.0, |s| s.beam_a[2])];
                // Where the beam is built in the ends of its two parts move and turn.
                let [left, right] = changes[i].slopes;
                let turned = if held {
                    bends[0] * left - bends[1] * right + 0.5 * (bends[0] * bends[0] - bends[1] * bends[1])
                } else {
                    0.0
                };
                turned - force * changes[i].value
            }
        }
    }

    /// True where a force, a bend, a length or a clearance vanishes.
    fn at_a_change(&self) -> bool {
        let (given, nodes) = (&self.given, &self.list.nodes);
        let largest = self.forces.iter().fold(0.0, |most: f64, force| most.max(force.abs()));
        let moments = self.spans.iter().flat_map(|(_, span)| [span.beam_a[2], span.beam_b[2]]);
        let bent =
            moments.fold(0.0, |most: f64, moment| most.max(moment.abs())).max(largest * given.length * AT_A_CHANGE);
        let size = self.state.deflection.magnitude() / self.scale.depth;
        let small = |value: f64, scale: f64| value.abs() <= AT_A_CHANGE * scale;
        let at_node = nodes.iter().enumerate().any(|(i, node)| match node.kind {
            Kind::Smooth => small(self.forces[i], largest) || small(bend(&self.spans, i), bent),
            Kind::Edge(_) | Kind::ZoneStart | Kind::ZoneEnd => small(self.forces[i], largest),
            Kind::Support(_, beside) => beside != [Beside::Apart; 2],
            Kind::Tip => false,
        });
        let short = self.list.zones().any(|zone| small(zone.to - zone.from, given.length));
        // Ground that carries nothing where the beam lies on it carries something as soon as a load is there.
        let carried = self.touches();
        let near = |a: f64, b: f64| small((a - b) / self.scale.length, given.length);
        let all = |(carried, whole): (&Contact, &Contact)| near(carried.from, whole.from) && near(carried.to, whole.to);
        let contacts = &self.state.contacts;
        let unloaded = carried.len() != contacts.len() || !carried.iter().map(|(_, c)| c).zip(contacts).all(all);
        let touches = |span| given.founded && lowest(given, span).is_some_and(|least| small(least, size));
        at_node || short || unloaded || self.spans.iter().any(|(_, span)| touches(span))
    }
}

/// The second derivative of a profile, which is smooth there.
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::{Beam, Load};
    use crate::theory::solve;

    /// The paper's example: T = q a/2 with a⁴ = 24 EI u₀/q, so that ∂T/∂u₀ = T/4u₀, ∂T/∂q = 3T/4q, ∂T/∂EI = T/4EI.
    #[test]
    fn the_example_has_those_of_its_closed_form() {
        let stiffness = 500.0 / 384.0;
        let beam = Beam::new(10.0, stiffness).expect("a beam");
        let load = Load::uniform_on(&beam, 1.0).expect("a load");
        let scene = Scene::new(beam, load, Some(Foundation::Flat { depth: 1.0 })).expect("a scene");
        let exact = solve(&scene).expect("an answer");
        let t = exact.state.reactions.left;
        let derivatives = exact.derivatives(&scene);
        let of = |by: &str| derivatives.iter().find(|d| d.by.to_string() == by).expect("a derivative");
        for (by, expected) in
            [("depth", t / 4.0), ("load.uniform", 3.0 * t / 4.0), ("beam.bending_stiffness", t / 4.0 / stiffness)]
        {
            let derivative = of(by);
            assert!(!derivative.one_sided, "{by}");
            let ends = derivative.contacts[0].end_forces.expect("a zone");
            for found in [derivative.supports[0], derivative.supports[1], ends[0], ends[1]] {
                assert!((found - expected).abs() <= 1e-12 * expected.abs(), "{by}: {found} for {expected}");
            }
        }
        let energy = of("depth").energy;
        assert!((energy + 10.0 - 2.0 * t).abs() <= 1e-12 * energy.abs(), "{energy}");
        let from = of("depth").contacts[0].from;
        assert!((from - t / 2.0).abs() <= 1e-12, "a = 2T/q");
    }
}
